"""Timeouts for a board and for the program's own window, and rates at which values are shown."""

import math
from dataclasses import dataclass

FRAME = 1 / 30
"""Seconds between two pictures of what moves, and between two batches of samples for them."""

FRAME_MS = round(1000 * FRAME)

UNWATCHED_INTERVAL = 0.25
"""Seconds between two batches of samples while nothing shows or records them."""

TEXT_INTERVAL = 0.2
"""Seconds between two renewals of a measured value as text: nobody reads faster, and a text that
changes may lay out the whole page again."""


_LEAST_STEPS = 3
_ROUND = 5  # seconds


def seconds_left(elapsed: float, done: int, total: int) -> int | None:
    """Estimate what the rest of some steps takes, in steps of 5 s. `None` while too few are done.

    `elapsed`: seconds that the steps that are done have taken.
    """
    if not _LEAST_STEPS <= done < total:
        return None
    return _ROUND * math.ceil(elapsed / done * (total - done) / _ROUND)


@dataclass(frozen=True, slots=True, kw_only=True)
class Timeouts:
    """Time limits in seconds.

    Attributes:
        extra: added to the deadline of every reply, for slow adapters, hosts and networks.
        heartbeat: without a heartbeat of the window for so long, armed motors are stopped. A
            window that paints slowly is late by tenths of a second; a motor at full speed moves a
            robot by a metre in that time, so it is not more.
        guardian: without a heartbeat of the session for so long, the guardian process stops motors
            that may be moving.
        stop_confirmation: how long a stop waits for a line that corrupts bytes to become quiet
            before it is reported as unconfirmed. At 19200 baud and above that takes 1.6 s from the
            last error on.
        retry: pause between two attempts to reach a board that does not respond.
        current_gap: a bench test is aborted when no current was read for so long.
        standstill: how long a motor may draw a current after a confirmed stop. Brakes take 1.3 s at
            most, and a reading on a slow line 0.4 s.
        sleep_delay: how long the computer is kept from sleeping until a stop is confirmed.
    """

    extra: float = 0.0
    heartbeat: float = 0.6
    guardian: float = 0.5
    stop_confirmation: float = 3.0
    retry: float = 0.25
    current_gap: float = 0.6
    standstill: float = 2.5
    sleep_delay: float = 1.0
