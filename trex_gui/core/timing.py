"""Timeouts of sessions, and update intervals of displays."""

import math
from dataclasses import dataclass

FRAME = 1 / 30  # seconds between two frames of a display, and between two batches of samples

FRAME_MS = round(1000 * FRAME)

UNWATCHED_INTERVAL = 0.25  # seconds between two batches of samples that are not shown or recorded

TEXT_INTERVAL = 0.2
"""Seconds between updates of a measured value as text.

Users cannot read faster, and a change of the text may cause a new layout of the whole page."""


_MIN_STEPS = 3  # completed steps that an estimate needs
_ROUNDING = 5  # seconds


def seconds_left(elapsed: float, done: int, total: int) -> int | None:
    """Estimate the remaining seconds, rounded up to a multiple of 5.

    `elapsed`: duration of the completed steps in s. Return `None` if too few steps are complete for
    an estimate, or if all steps are complete.
    """
    if not _MIN_STEPS <= done < total:
        return None
    return _ROUNDING * math.ceil(elapsed / done * (total - done) / _ROUNDING)


@dataclass(frozen=True, slots=True, kw_only=True)
class Timeouts:
    """Time limits in seconds.

    Attributes:
        extra: added to the deadline of every reply, for slow adapters, hosts and networks.
        heartbeat: armed motors are stopped after this time without a heartbeat from the window. A
            slow window may be late by tenths of a second. At full speed, a robot moves a metre in
            this time.
        guardian: the guardian process stops the motors after this time without a heartbeat from
            the session.
        stop_confirmation: time after which an unconfirmed stop is reported. At 19200 baud and
            above, a line that corrupts bytes becomes quiet 2 s after the last error.
        retry: pause between two attempts to reach a silent board.
        current_gap: a bench test is aborted after this time without a current reading.
        standstill: maximum time for which a motor may draw current after a confirmed stop.
            Braking takes up to 1.3 s, and a reading on a slow line takes 0.4 s.
        sleep_delay: maximum delay of the computer's sleep until a stop is confirmed.
    """

    extra: float = 0.0
    heartbeat: float = 0.6
    guardian: float = 0.5
    stop_confirmation: float = 3.0
    retry: float = 0.25
    current_gap: float = 0.6
    standstill: float = 2.5
    sleep_delay: float = 1.0
