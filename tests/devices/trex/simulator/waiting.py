"""Polling of a simulator that runs in real time."""

import time
from collections.abc import Callable

LONG_TIMEOUT = 30.0  # seconds


def comes_true(condition: Callable[[], object]) -> bool:
    """Poll a condition. Return whether it came true in time."""
    end = time.monotonic() + LONG_TIMEOUT
    while not condition():
        if time.monotonic() > end:
            return False
        time.sleep(0.02)  # leaves processor time to the simulator
    return True
