"""When to ask whether the robot is there, and what is to be told once it is. Pure."""

from enum import Enum, auto

from trex_gui.devices.aracna.protocol.replies import Version
from trex_gui.devices.aracna.protocol.units import MOTORS

LOOK = 2.0
"""Seconds after which a robot that nothing was asked of is asked whether it is still there."""

RETRY = 0.5
"""Seconds between two questions while an answer is awaited."""

SEARCH = 1.0
"""Seconds between two questions to a robot that has been called silent."""

BOOT = 1.1
"""Seconds after `.h` in which the firmware reads nothing: one of blinking, and a margin."""

PATIENCE = 6.0
"""Seconds until a robot is called silent that was reset: a boot loader may delay its start."""

OPENING = 15.0
"""Seconds until one that is connected to, and only says that it starts, is given up."""

_MOTORS = {0: 2}
"""Motors that a firmware was made for whose answer to `.q` does not tell, by its version."""


def motors_of(version: Version) -> int:
    """Return how many motors a firmware moves; early ones do not tell, but are known."""
    return version.motors or _MOTORS.get(version.version, MOTORS)


class QueryReason(Enum):
    """Why an answer to `.q` is awaited before anything else is sent."""

    OPENING = auto()
    RESTARTED = auto()
    UNSURE = auto()
    SILENT = auto()


class LivenessMonitor:
    """What is known of the robot's being there.

    Attributes:
        why: why it is being asked; `None` while it is there.
        was_restarted: whether it has said `.h` since it answered last.
    """

    def __init__(self, now: float) -> None:
        self.why: QueryReason | None = QueryReason.OPENING
        self.was_restarted = False
        self._ask_at = now
        self._until = now + PATIENCE
        self._given_up_at = now + OPENING
        self._look_at = now

    def doubt(self, now: float) -> None:
        """It has not answered something; ask before anything else is sent."""
        if self.why is None:
            self.why = QueryReason.UNSURE
            self._ask_at = now
            self._until = now + RETRY

    def restart(self, now: float) -> None:
        """It has said `.h`, and is deaf for a second."""
        self.was_restarted = True
        self._ask_at = now + BOOT
        self._until = now + PATIENCE
        if self.why is QueryReason.OPENING:
            self._until = min(self._until, self._given_up_at)
        else:
            self.why = QueryReason.RESTARTED

    def fall_silent(self, now: float) -> None:
        """It is called silent from here on."""
        self.why = QueryReason.SILENT
        self._ask_at = now + SEARCH

    def note_answer(self, now: float) -> None:
        """It has answered something."""
        self._look_at = now + LOOK

    def be_there(self, now: float) -> QueryReason | None:
        """It has answered `.q`; return why that was awaited."""
        why, self.why = self.why, None
        self.was_restarted = False
        self.note_answer(now)
        return why

    def retry(self, now: float) -> None:
        """An answer to `.q` has not come."""
        self._ask_at = max(self._ask_at, now)
        if self.why is QueryReason.SILENT:
            self._ask_at = now + SEARCH - RETRY

    def is_due(self, now: float) -> bool:
        """Whether to ask now, the line being free."""
        return now >= (self._look_at if self.why is None else self._ask_at)

    def is_over(self, now: float) -> bool:
        """Whether it has been asked in vain for long enough to say so."""
        return self.why not in {None, QueryReason.SILENT} and now >= self._until

    def seconds_to_next(self, now: float) -> float:
        """Return how long nothing has to be asked."""
        return max(0.0, (self._look_at if self.why is None else self._ask_at) - now)
