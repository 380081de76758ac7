"""Timeouts for a board and for the program's own window, and rates at which values are shown."""

import math
from dataclasses import dataclass

FRAME = 1 / 30
"""Seconds between two frames of moving displays, and between two batches of their samples."""

FRAME_MS = round(1000 * FRAME)

UNWATCHED_INTERVAL = 0.25
"""Seconds between two batches of samples while nothing shows or records them."""

TEXT_INTERVAL = 0.2
"""Seconds between two updates of a measured value as text. Nobody reads faster, and each changed
text may lay out the whole page again."""


_LEAST_STEPS = 3
_ROUND = 5  # seconds


def seconds_left(elapsed: float, done: int, total: int) -> int | None:
    """Estimate the seconds left, rounded up to 5 s. `None` while too few steps are done.

    `elapsed`: seconds that the completed steps have taken.
    """
    if not _LEAST_STEPS <= done < total:
        return None
    return _ROUND * math.ceil(elapsed / done * (total - done) / _ROUND)


@dataclass(frozen=True, slots=True, kw_only=True)
class Timeouts:
    """Time limits in seconds.

    Attributes:
        extra: added to the deadline of every reply, for slow adapters, hosts and networks.
        heartbeat: armed motors are stopped after this time without a heartbeat of the window. A
            window that paints slowly is late by tenths of a second. The timeout is not longer
            because a motor at full speed moves a robot by a metre in this time.
        guardian: the guardian process stops motors that may be moving after this time without a
            heartbeat of the session.
        stop_confirmation: time for a line that corrupts bytes to become quiet. After it, the stop
            is reported as unconfirmed. At 19200 baud and above, the line becomes quiet 1.6 s after
            the last error.
        retry: pause between two attempts to reach a board that does not respond.
        current_gap: a bench test is aborted after this time without a current reading.
        standstill: how long a motor may draw a current after a confirmed stop. Brakes take 1.3 s at
            most, and a reading on a slow line 0.4 s.
        sleep_delay: longest delay of the computer's sleep, to wait until a stop is confirmed.
    """

    extra: float = 0.0
    heartbeat: float = 0.6
    guardian: float = 0.5
    stop_confirmation: float = 3.0
    retry: float = 0.25
    current_gap: float = 0.6
    standstill: float = 2.5
    sleep_delay: float = 1.0
