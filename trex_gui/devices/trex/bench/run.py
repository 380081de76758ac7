"""One bench test that was run: what was asked, what was measured, how it ended."""

from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime
from enum import Enum

from trex_gui.devices.trex.bench.profile import Profile


class End(Enum):
    """How a test ended; the values are the words of a saved one."""

    COMPLETE = "complete"
    LET_GO = "let go"
    ABORTED = "aborted"


@dataclass(frozen=True, slots=True, kw_only=True)
class Run:
    """A test and its measurements; all times in seconds since its first command.

    Attributes:
        motor: 1 or 2.
        accelerate: whether the speeds went through the board's ramp.
        abort_current: the current in A above which it was to be aborted.
        ampere: A for each count of the current measurement: its resolution.
        began: when, by the clock on the wall.
        end, reason: how it ended, and why if it was aborted, for people.
        ended: when the motor was left to brake.
        wishes: time and signed speed of each command.
        currents: time and current in A of each reading, those after the end included.
        settings: name and value, for people, of what the board stored for this motor.
    """

    motor: int
    profile: Profile
    accelerate: bool
    abort_current: float
    ampere: float
    began: datetime
    end: End
    reason: str = ""
    ended: float
    wishes: Sequence[tuple[float, int]]
    currents: Sequence[tuple[float, float]]
    settings: Sequence[tuple[str, str]] = ()

    @property
    def title(self) -> str:
        """The test in few words, such as `step +60, 3 s`."""
        profile = self.profile
        return f"{profile.shape.value} {profile.speed:+d}, {profile.duration:g} s".replace("-", "−")

    def wish_at(self, seconds: float) -> int:
        """Return the speed that was asked for at a moment; 0 when none was."""
        index = bisect_right(self.wishes, seconds, key=lambda wish: wish[0])
        return self.wishes[index - 1][1] if index and seconds <= self.ended else 0

    def current_at(self, seconds: float) -> float | None:
        """Return the last reading in A at a moment; `None` before the first and after the last."""
        index = bisect_right(self.currents, seconds, key=lambda reading: reading[0])
        if not index or seconds > self.currents[-1][0]:
            return None
        return self.currents[index - 1][1]
