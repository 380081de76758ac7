"""Waiting for a simulator that runs in real time."""

import time
from collections.abc import Callable

LONG_TIMEOUT = 20.0
"""Timeout in seconds."""


def becomes(look: Callable[[], object], wanted: object) -> bool:
    """Wait for a condition. Return whether it became true in time."""
    end = time.monotonic() + LONG_TIMEOUT
    while look() != wanted:
        if time.monotonic() > end:
            return False
        time.sleep(0.02)
    return True
