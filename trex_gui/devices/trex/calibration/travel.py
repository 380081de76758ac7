"""Travel of a channel to each side of its rest position."""

from bisect import bisect_left
from collections import deque
from enum import Enum, auto
from itertools import pairwise
from math import ceil
from statistics import median, median_low

from trex_gui.devices.trex.calibration.neutral import (
    LIMITS,
    ChannelSample,
    Neutral,
    lost_pulses,
    no_signal,
)
from trex_gui.devices.trex.calibration.problems import CalibrationProblem, ProblemKind
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.protocol.flags import InputSource

HELD_SAMPLES = 6
"""Number of consecutive samples that must agree. They take longer than 100 ms, for which the board
repeats a wild value if the next pulses are lost."""

_SLOW_HELD_SAMPLES = 3  # `HELD_SAMPLES` on a slow line, where three samples exceed 100 ms
WINDOW = 2 * HELD_SAMPLES - 1  # samples per median; the median ignores up to five wild samples

_MAX_FAST_INTERVAL = 0.05
"""Maximum seconds between samples on a fast line. On a slow line, a wild pulse of 20 ms is never
read twice. A short push of the stick may also be read only once."""

_HELD_FRACTION = 0.02  # samples agree within this fraction of the travel plus `_DEVIATIONS`
_DEVIATIONS = 6.0  # limit for a still channel, in standard deviations of the noise
_SILENT_AFTER = 0.5  # seconds without a valid sample; the channel may have moved meanwhile
_MANY_INVALID = 0.1  # minimum fraction of samples without a signal to report
_MIN_SAMPLES = 25  # needed for a meaningful fraction of invalid samples
_TIMES = 16  # number of samples for measuring their interval
_MIN_HOLD = 0.3  # seconds; a user cannot deliberately hold a stick for a shorter time
_RAIL = 5  # counts; a voltage within 24 mV of a range limit is at this limit (inferred)

_MOSTLY = 0.75
"""Fraction of the travel. `Travel.first` is the direction that covers this fraction first.

Inferred: a push of a two-axis stick along one axis moves the other axis by a third of its travel,
rarely more.
"""

_SETTLED_SECONDS = 0.4  # seconds of standstill until a channel is settled
_SETTLED_SAMPLES = 3  # minimum number of samples of a settled channel
_SETTLED_COVERED = 0.75  # minimum fraction of `_SETTLED_SECONDS` that samples must cover
_SETTLED_WILD = 0.1  # maximum fraction of wild samples
_RELEASED = 0.5  # fraction of the travel; a channel that settles closer to rest was released
_UNEVEN = 0.5  # minimum length of the shorter side, as a fraction of the longer side


class Task(Enum):
    STICK = auto()
    ONE_WAY = auto()
    SWITCH = auto()


TASKS = {1: Task.STICK, 2: Task.STICK, 3: Task.ONE_WAY, 4: Task.SWITCH, 5: Task.SWITCH}
"""Channel 3 drives a motor with one direction. Channels 4 (flip) and 5 (override) are switches."""


class Way(Enum):
    """Direction of a movement, as the sign of the change in counts."""

    DOWN = -1
    UP = 1


def least_travel(deadband: int) -> int:
    """Return the minimum distance of an end from rest, in counts.

    This is the sum of the deadband and 127 counts for the 127 speeds. With less travel, the channel
    never reaches some speeds.
    """
    return deadband + FULL_SCALE


class _End:
    """Furthest position of a channel to one side.

    An end is held when enough consecutive samples agree with the furthest position. On a slow line,
    one sample further out cancels the hold.
    """

    def __init__(self, way: Way, neutral: Neutral) -> None:
        self.furthest: int | None = None  # furthest median; `None` before the first median
        self.is_held = False
        self.distances: list[int] = []  # from rest to `furthest`, after each sample
        self._sign = way.value
        self._neutral = neutral
        self._held_at: int | None = None

    def feed(self, recent: deque[int], *, slow: bool) -> None:
        held = _SLOW_HELD_SAMPLES if slow else HELD_SAMPLES
        window = list(recent)[1 - 2 * held :]
        if len(window) < 2 * held - 1:
            return
        position = median_low(window)
        if self.furthest is None or self._sign * (position - self.furthest) > 0:
            self.furthest = position
        furthest, sign = self.furthest, self._sign
        distance = sign * (furthest - self._neutral.value)
        self.distances.append(distance)
        tolerance = ceil(_HELD_FRACTION * abs(distance) + _DEVIATIONS * self._neutral.deviation)
        last = window[-held:]
        middle = median_low(last)
        if max(last) - min(last) <= tolerance and sign * (furthest - middle) <= tolerance:
            self._held_at = middle
        elif slow and sign * (last[-1] - furthest) > tolerance:
            self._held_at = None
        self.is_held = self._held_at is not None and sign * (furthest - self._held_at) <= tolerance


class Travel:
    """Movement of one channel. Lone wild samples do not count."""

    def __init__(self, neutral: Neutral, task: Task) -> None:
        self.source = neutral.source
        self.task = task
        self.neutral = neutral.value  # in counts, as measured at rest
        self.deadband = neutral.deadband  # in counts
        self.now: int | None = None  # newest valid count
        self._deviation = neutral.deviation
        self._ends = {way: _End(way, neutral) for way in Way}
        self._recent: deque[int] = deque(maxlen=WINDOW)
        self._times: deque[float] = deque(maxlen=_TIMES)
        self._last: deque[tuple[float, int]] = deque()
        self._samples = 0
        self._invalid = 0

    def feed(self, sample: ChannelSample) -> None:
        self._samples += 1
        self._times.append(sample.time)
        if sample.count is None:
            self._invalid += 1
            return
        self.now = sample.count
        self._recent.append(sample.count)
        slow = self.is_slow
        for end in self._ends.values():
            end.feed(self._recent, slow=slow)
        self._last.append((sample.time, sample.count))
        while (
            len(self._last) > _SETTLED_SAMPLES and sample.time - self._last[0][0] > _SETTLED_SECONDS
        ):
            self._last.popleft()

    # --- Rest position ------------------------------------------------------------------

    @property
    def rest(self) -> int:
        """Count at which the channel settled after its release, or else `neutral`."""
        settled = self.settled
        if settled is None or self.task is Task.SWITCH:
            return self.neutral
        way = Way.UP if settled > self.neutral else Way.DOWN
        is_released = abs(settled - self.neutral) < _RELEASED * self.length(way)
        return settled if is_released else self.neutral

    @property
    def settled(self) -> int | None:
        """Count at which the channel is still, without wild values. `None` if it moves."""
        if (
            len(self._last) < _SETTLED_SAMPLES
            or self._times[-1] - self._last[-1][0] > _SILENT_AFTER
        ):
            return None
        if self._last[-1][0] - self._last[0][0] < _SETTLED_COVERED * _SETTLED_SECONDS:
            return None
        counts = [count for _, count in self._last]
        middle = median(counts)
        tolerance = max(LIMITS[self.source].moved / 2, _DEVIATIONS * self._deviation)
        wild = sum(abs(count - middle) > tolerance for count in counts)
        return round(middle) if wild <= _SETTLED_WILD * len(counts) else None

    # --- Ends ---------------------------------------------------------------------------

    def end(self, way: Way) -> int:
        """Return the furthest count. `neutral` before the first measurement."""
        furthest = self._ends[way].furthest
        return self.neutral if furthest is None else furthest

    def length(self, way: Way) -> int:
        """Return the travel in counts. Negative if the channel never returned to rest."""
        return way.value * (self.end(way) - self.neutral)

    def has_reached(self, way: Way) -> bool:
        return self.length(way) >= least_travel(self.deadband)

    def is_held(self, way: Way) -> bool:
        return self.has_reached(way) and self._ends[way].is_held

    @property
    def hold_direction(self) -> Way | None:
        """Direction in which the user must still hold the stick, if the stick is there now."""
        for way in Way:
            if self.now is not None and not self.is_held(way):
                offset = way.value * (self.now - self.neutral)
                if offset >= least_travel(self.deadband):
                    return way
        return None

    @property
    def first(self) -> Way | None:
        """Direction in which the channel first covered most of its travel."""
        reached = {
            way: bisect_left(end.distances, _MOSTLY * end.distances[-1])
            for way, end in self._ends.items()
            if self.has_reached(way)
        }
        return min(reached, key=lambda way: reached[way], default=None)

    @property
    def idle(self) -> Way | None:
        """Direction without travel. A switch or a throttle rests at this end."""
        ways = [way for way in Way if not self.has_reached(way)]
        return ways[0] if self.task is not Task.STICK and len(ways) == 1 else None

    @property
    def is_enough(self) -> bool:
        held = [self.is_held(way) for way in Way]
        return all(held) if self.task is Task.STICK else any(held)

    # --- Sample rate --------------------------------------------------------------------

    @property
    def interval(self) -> float:
        """Median time between two samples, in seconds. It is 0 until it is known."""
        steps = [b - a for a, b in pairwise(self._times)]
        return median(steps) if steps else 0.0

    @property
    def is_slow(self) -> bool:
        return self.interval > _MAX_FAST_INTERVAL

    @property
    def hold_seconds(self) -> float:
        """Seconds for which an end must be held, including one spare sample."""
        held = _SLOW_HELD_SAMPLES if self.is_slow else HELD_SAMPLES
        return max(_MIN_HOLD, (held + 1) * self.interval)

    # --- Problems -----------------------------------------------------------------------

    @property
    def problems(self) -> tuple[CalibrationProblem, ...]:
        if self._samples and self._invalid > self._samples / 2:
            return (no_signal(self.source),)
        problem = self._length_problem()
        problems = () if problem is None else (problem,)
        if self._samples >= _MIN_SAMPLES and self._invalid > _MANY_INVALID * self._samples:
            return (*problems, lost_pulses(self._invalid / self._samples, fatal=False))
        return problems

    def _length_problem(self) -> CalibrationProblem | None:
        shorter, longer = sorted(Way, key=self.length)
        shortest, longest = self.length(shorter), self.length(longer)
        text, least = self.source.text, least_travel(self.deadband)
        needed = text(least), FULL_SCALE
        if longest <= self.deadband:
            return self._never_moved()
        if shortest < -self.deadband:
            positions = text(self.neutral), text(self.end(Way.DOWN)), text(self.end(Way.UP))
            return CalibrationProblem(ProblemKind.NEUTRAL_OUTSIDE, values=positions)
        if longest < least:
            return CalibrationProblem(ProblemKind.TOO_LITTLE, values=(text(longest), *needed))
        if self.task is not Task.STICK:
            return self._not_held()
        if shortest <= self.deadband:
            return CalibrationProblem(ProblemKind.ONE_DIRECTION, shorter.name)
        if shortest < least:
            values = text(shortest), *needed
            return CalibrationProblem(ProblemKind.END_TOO_NEAR, shorter.name, values)
        if (problem := self._not_held()) is not None:
            return problem
        if shortest < _UNEVEN * longest:
            lengths = text(longest), text(shortest)
            return CalibrationProblem(ProblemKind.UNEVEN, shorter.name, lengths, fatal=False)
        return None

    def _never_moved(self) -> CalibrationProblem:
        if self.source is InputSource.RC:
            return CalibrationProblem(ProblemKind.NEVER_MOVED, "RC")
        at_rail = self.neutral <= _RAIL or self.neutral >= self.source.highest_count - _RAIL
        variant = "RAIL" if at_rail else "ANALOG"
        text = self.source.text(self.neutral)
        return CalibrationProblem(ProblemKind.NEVER_MOVED, variant, (text,))

    def _not_held(self) -> CalibrationProblem | None:
        ends = [way.name for way in Way if self.has_reached(way) and not self.is_held(way)]
        if not ends:
            return None
        variant = ends[0] if len(ends) == 1 else "BOTH"
        return CalibrationProblem(ProblemKind.NOT_HELD, variant, (self.hold_seconds,))
