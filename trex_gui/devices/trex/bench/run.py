"""Plan, profile, measurements and figures of a bench test."""

import math
from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from datetime import datetime
from enum import Enum
from itertools import pairwise
from operator import itemgetter
from statistics import fmean

from trex_gui.core.texts import signed_text
from trex_gui.core.translation import Number, tr, tr_noop
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE

MIN_SECONDS = 0.2  # minimum duration of a test or period; ten steps of the profile
MAX_SECONDS = 120.0  # maximum duration; the user holds a button during the test
MAX_GAP = 0.5  # seconds between readings; longer gaps do not count as charge
SETTLED_BAND = 0.1  # maximum deviation of a settled current, as a fraction of the steady current
_TAIL = 0.3  # final fraction of a constant setpoint; its mean current is the steady current
_MIN_PLATEAU = 0.4  # seconds of a constant setpoint; its tail contains ten readings
_NOISE_COUNTS = 2  # lowest reading that shows a current; a single count may be noise


class Shape(Enum):
    """Shape of a profile. Saved files contain the values."""

    STEP = "step"
    RAMP = "ramp"
    REVERSE = "reverse"
    SINE = "sine"

    @property
    def has_period(self) -> bool:
        return self is not Shape.STEP


_TITLES = {
    Shape.STEP: tr_noop("step {0}, {1} s"),
    Shape.RAMP: tr_noop("ramp {0}, {1} s"),
    Shape.REVERSE: tr_noop("reverse {0}, {1} s"),
    Shape.SINE: tr_noop("sine {0}, {1} s"),
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Profile:
    """Speed as a function of time."""

    # Step: constant speed. Ramp: linear rise for one `period`, then constant speed. Reverse: half a
    # period forward, half a period backward, repeated. Sine: one wave per period.
    shape: Shape = Shape.STEP
    speed: int = 40  # maximum speed, -127 to 127 except 0; a negative speed starts backward
    duration: float = 3.0  # total seconds
    period: float = 1.0  # seconds; see `shape`

    def __post_init__(self) -> None:
        """Raise `ValueError` if a value is out of range. The text gives the limits."""
        limits = Number(MIN_SECONDS), Number(MAX_SECONDS)
        if self.speed == 0 or not -FULL_SCALE <= self.speed <= FULL_SCALE:
            text = tr("the speed of a bench test must be −{0} to −1 or 1 to {0}, not {1}")
            raise ValueError(text.format(FULL_SCALE, self.speed))
        if not MIN_SECONDS <= self.duration <= MAX_SECONDS:
            text = tr("a bench test must last {0:g} to {1:g} s, not {2:g} s")
            raise ValueError(text.format(*limits, Number(self.duration)))
        if self.shape.has_period and not MIN_SECONDS <= self.period <= MAX_SECONDS:
            text = tr("the period of a bench test must be {0:g} to {1:g} s, not {2:g} s")
            raise ValueError(text.format(*limits, Number(self.period)))

    def speed_at(self, seconds: float) -> int:
        """Return the speed at a time. It is 0 before the start and after the end."""
        if not 0 <= seconds < self.duration:
            return 0
        return round(self.speed * self._fraction(seconds))

    def _fraction(self, seconds: float) -> float:
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
        """Return the profile with its speed limited to `ceiling` (1 to 127)."""
        if abs(self.speed) <= ceiling:
            return self
        return replace(self, speed=ceiling if self.speed > 0 else -ceiling)

    def plateau(self, end: float) -> tuple[float, float] | None:
        """Return the start and end of the first constant speed before `end`, or `None`."""
        if self.shape is Shape.SINE:
            return None
        first = self.period if self.shape is Shape.RAMP else 0.0
        last = min(end, self.duration)
        if self.shape is Shape.REVERSE:
            last = min(last, self.period / 2)
        return (first, last) if last > first else None

    def course(self, points: int = 600) -> Sequence[tuple[float, int]]:
        """Return times and speeds for a plot, with a point on each side of every jump."""
        steps = {self.duration * index / points for index in range(points)}
        if self.shape is Shape.REVERSE:
            half = self.period / 2
            for count in range(1, math.ceil(self.duration / half)):
                steps |= {half * count - 1e-6, half * count + 1e-6}
        inside = [(seconds, self.speed_at(seconds)) for seconds in sorted(steps)]
        return [(0.0, 0), *inside, (self.duration, inside[-1][1]), (self.duration, 0)]


@dataclass(frozen=True, slots=True, kw_only=True)
class Plan:
    motor: int = 1  # 1 or 2
    profile: Profile = field(default_factory=Profile)
    accelerate: bool = True  # True to use the board's ramp, brake duration and current limit
    abort_current: float = 10.0  # A; a single reading above it stops all motors
    abort_at_limit: bool = False  # True to stop all motors at the board's current limit too


class End(Enum):
    """Result of a test. Saved files contain the values."""

    COMPLETE = "complete"
    RELEASED = "released"
    ABORTED = "aborted"


@dataclass(frozen=True, slots=True, kw_only=True)
class Run:
    """Test with its measurements. Times are in seconds since the first setpoint."""

    motor: int  # 1 or 2
    profile: Profile
    accelerate: bool  # True if the board's ramp applied to the speeds
    abort_current: float  # A; a single reading above it aborts the test
    ampere: float  # A per count of the current measurement
    started: datetime  # local date and time
    end: End
    reason: str = ""  # reason for an abort, for the user
    ended: float  # when the motor started to brake
    setpoints: Sequence[tuple[float, int]]  # times and signed speeds
    currents: Sequence[tuple[float, float]]  # times and currents in A, even after the end
    settings: Sequence[tuple[str, str]] = ()  # names and texts of the motor's parameters

    @property
    def title(self) -> str:
        profile = self.profile
        speed = signed_text(profile.speed)
        return tr(_TITLES[profile.shape]).format(speed, f"{Number(profile.duration):g}")

    def setpoint_at(self, seconds: float) -> int:
        index = bisect_right(self.setpoints, seconds, key=itemgetter(0))
        return self.setpoints[index - 1][1] if index and seconds <= self.ended else 0

    def current_at(self, seconds: float) -> float | None:
        """Return the latest reading in A at a time. `None` outside the readings."""
        index = bisect_right(self.currents, seconds, key=itemgetter(0))
        if not index or seconds > self.currents[-1][0]:
            return None
        return self.currents[index - 1][1]


@dataclass(frozen=True, slots=True)
class Figures:
    """Figures of a test. A figure is `None` if the readings are insufficient."""

    peak: float | None = None  # highest reading, A
    mean: float | None = None  # A, from the first setpoint until the motor began to brake
    charge: float | None = None  # mAh, over the same time as `mean`
    steady: float | None = None  # A at the end of the first constant setpoint
    # Seconds from the first setpoint until the current stays within `SETTLED_BAND` of `steady`, or
    # within two counts. A single crossing does not count: an inrush crosses the steady current.
    settled: float | None = None
    delay: float | None = None  # s from the first setpoint to the first current above the noise


def figures(run: Run) -> Figures:
    start = next((time for time, speed in run.setpoints if speed), None)
    driven = [(time, amps) for time, amps in run.currents if 0 <= time <= run.ended]
    if start is None or not driven:
        return Figures()
    mean, charge = _mean_and_charge(driven)
    noise = _NOISE_COUNTS * run.ampere
    first, last = run.profile.plateau(run.ended) or (0.0, 0.0)
    tail = [amps for time, amps in driven if last - _TAIL * (last - first) <= time < last]
    steady = fmean(tail) if tail and last - first >= _MIN_PLATEAU else None
    settled = None
    if steady:
        tolerance = max(SETTLED_BAND * steady, noise) + 1e-9
        constant = [(time, amps) for time, amps in driven if start <= time < last]
        outside = (time for time, amps in constant if abs(amps - steady) > tolerance)
        last_outside = max(outside, default=-1.0)
        settled = next((time - start for time, _ in constant if time > last_outside), None)
    delays = (time - start for time, amps in driven if time >= start and amps >= noise - 1e-9)
    return Figures(
        peak=max(amps for _, amps in driven),
        mean=mean,
        charge=charge,
        steady=steady,
        settled=settled,
        delay=next(delays, None),
    )


def _mean_and_charge(readings: Sequence[tuple[float, float]]) -> tuple[float | None, float]:
    """Return the mean in A and the charge in mAh. Both exclude long gaps."""
    seconds = coulombs = 0.0
    for (start, before), (end, after) in pairwise(readings):
        if end - start <= MAX_GAP:
            seconds += end - start
            coulombs += (before + after) / 2 * (end - start)
    return (coulombs / seconds if seconds else None), coulombs / 3.6
