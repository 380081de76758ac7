"""Waiting for a simulator that runs in real time."""

import time
from collections.abc import Callable

LONG_TIMEOUT = 20.0
"""Seconds after which something that should have happened will not."""


def becomes(look: Callable[[], object], wanted: object) -> bool:
    """Look again and again until it is as wanted; return whether that was in time."""
    end = time.monotonic() + LONG_TIMEOUT
    while look() != wanted:
        if time.monotonic() > end:
            return False
        time.sleep(0.02)
    return True
