"""What a bench test asks of a motor: a speed as a function of time. Pure."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from enum import Enum

from trex_gui.devices.trex.protocol.calibration import FULL_SCALE

SHORTEST = 0.2
"""Seconds that a test or a period lasts at least: ten of the profile's own steps."""

LONGEST = 120.0
"""Seconds that a test lasts at most; somebody holds a button all the while."""


class Shape(Enum):
    """The course of a test; the values are the words of a saved one."""

    STEP = "step"
    RAMP = "ramp"
    REVERSE = "reverse"
    SINE = "sine"

    @property
    def has_period(self) -> bool:
        """Whether `Profile.period` means anything to it."""
        return self is not Shape.STEP


@dataclass(frozen=True, slots=True, kw_only=True)
class Profile:
    """A speed for each moment of a test.

    Attributes:
        shape: step: the speed at once, then constant. Ramp: rises in a straight line for one
            `period`, then constant. Reverse: the speed for half a period, the same backwards for
            the other half, again and again. Sine: what its name says, forward first.
        speed: the greatest speed, -127 to 127 and not 0; negative begins backwards.
        duration: seconds in all.
        period: seconds; see `shape`.
    """

    shape: Shape = Shape.STEP
    speed: int = 40
    duration: float = 3.0
    period: float = 1.0

    def __post_init__(self) -> None:
        """Refuse what is no test.

        Raises:
            ValueError: a value is outside its limits; names them.
        """
        if self.speed == 0 or not -FULL_SCALE <= self.speed <= FULL_SCALE:
            raise ValueError(
                f"the speed of a bench test is −{FULL_SCALE} to {FULL_SCALE} and not 0, "
                f"not {self.speed}"
            )
        if not SHORTEST <= self.duration <= LONGEST:
            raise ValueError(
                f"a bench test lasts {SHORTEST:g} to {LONGEST:g} s, not {self.duration:g} s"
            )
        if self.shape.has_period and not SHORTEST <= self.period <= LONGEST:
            raise ValueError(
                f"the period of a bench test is {SHORTEST:g} to {LONGEST:g} s, "
                f"not {self.period:g} s"
            )

    def speed_at(self, seconds: float) -> int:
        """Return the speed at a moment; 0 before the beginning and from the end on."""
        if not 0 <= seconds < self.duration:
            return 0
        return round(self.speed * self._share(seconds))

    def _share(self, seconds: float) -> float:
        """Return the share of the greatest speed, -1 to 1."""
        match self.shape:
            case Shape.STEP:
                return 1.0
            case Shape.RAMP:
                return min(1.0, seconds / self.period)
            case Shape.REVERSE:
                return 1.0 if seconds % self.period < self.period / 2 else -1.0
            case Shape.SINE:
                return math.sin(2 * math.pi * seconds / self.period)

    def limited(self, ceiling: int) -> "Profile":
        """Return the same course with no greater speed than a ceiling (1-127)."""
        if abs(self.speed) <= ceiling:
            return self
        return replace(self, speed=ceiling if self.speed > 0 else -ceiling)

    def plateau(self, end: float) -> tuple[float, float] | None:
        """Return from when to when the wish was constant first, in a test that ended at `end`.

        `None` where it never was: a current means nothing steady there.
        """
        match self.shape:
            case Shape.STEP:
                span = 0.0, min(end, self.duration)
            case Shape.RAMP:
                span = self.period, min(end, self.duration)
            case Shape.REVERSE:
                span = 0.0, min(end, self.duration, self.period / 2)
            case Shape.SINE:
                return None
        return span if span[1] > span[0] else None

    def course(self, points: int = 600) -> Sequence[tuple[float, int]]:
        """Return times and speeds to draw it by, with both sides of every jump."""
        steps = {self.duration * index / points for index in range(points)}
        if self.shape is Shape.REVERSE:
            half, count = self.period / 2, 1
            while half * count < self.duration:
                steps |= {half * count - 1e-6, half * count + 1e-6}
                count += 1
        inside = [(seconds, self.speed_at(seconds)) for seconds in sorted(steps)]
        return [(0.0, 0), *inside, (self.duration, inside[-1][1]), (self.duration, 0)]
