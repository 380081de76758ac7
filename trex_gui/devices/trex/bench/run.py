"""A bench test that was run: setpoints, measured currents, how it ended."""

from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime
from enum import Enum
from operator import itemgetter

from trex_gui.devices.trex.bench.profile import Profile


class End(Enum):
    """How a test ended; the values are those of saved files."""

    COMPLETE = "complete"
    RELEASED = "released"
    ABORTED = "aborted"


@dataclass(frozen=True, slots=True, kw_only=True)
class Run:
    """A test and its measurements; all times in seconds since its first setpoint.

    Attributes:
        motor: 1 or 2.
        accelerate: whether the speeds went through the board's ramp.
        abort_current: A; one reading above it aborts the test.
        ampere: A per count of the current measurement.
        started: local date and time.
        end, reason: how it ended, and why if it was aborted, for the user.
        ended: when the motor began to brake.
        setpoints: time and signed speed of each.
        currents: time and current in A of each reading, those after the end included.
        settings: name and value, for the user, of the motor's stored parameters.
    """

    motor: int
    profile: Profile
    accelerate: bool
    abort_current: float
    ampere: float
    started: datetime
    end: End
    reason: str = ""
    ended: float
    setpoints: Sequence[tuple[float, int]]
    currents: Sequence[tuple[float, float]]
    settings: Sequence[tuple[str, str]] = ()

    @property
    def title(self) -> str:
        """A short name, such as `step +60, 3 s`."""
        profile = self.profile
        return f"{profile.shape.value} {profile.speed:+d}, {profile.duration:g} s".replace("-", "−")

    def setpoint_at(self, seconds: float) -> int:
        """Return the speed setpoint at a moment; 0 without one."""
        index = bisect_right(self.setpoints, seconds, key=itemgetter(0))
        return self.setpoints[index - 1][1] if index and seconds <= self.ended else 0

    def current_at(self, seconds: float) -> float | None:
        """Return the last reading in A at a moment; `None` before the first and after the last."""
        index = bisect_right(self.currents, seconds, key=itemgetter(0))
        if not index or seconds > self.currents[-1][0]:
            return None
        return self.currents[index - 1][1]
