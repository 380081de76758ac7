"""How far a channel goes to each side of its rest, followed while it moves."""

from bisect import bisect_left
from collections import deque
from dataclasses import dataclass
from enum import Enum, auto
from itertools import pairwise
from statistics import median

from trex_gui.devices.trex.calibration.holding import HELD, SLOW, WINDOW, EndWatch
from trex_gui.devices.trex.calibration.neutral import Neutral, lost_pulses, no_signal
from trex_gui.devices.trex.calibration.problems import Problem, ProblemKind
from trex_gui.devices.trex.calibration.samples import LIMITS, Sample
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.protocol.flags import InputSource

_SILENT_AFTER = 0.5
"""Seconds without a valid sample until a channel is said to have no signal."""

_MANY_INVALID = 0.1
_JUDGED_FROM = 25
"""Samples from which on a share of invalid ones says something."""

_TIMES = 16
"""Samples over which the time between two is measured."""

_LEAST_HOLD = 0.3
"""Seconds; a stick cannot be held for less on purpose."""

_RAIL = 5
"""Counts from the end of the range within which a voltage is at it: 24 mV (inferred)."""

_MOSTLY = 0.75
"""Share of the way to an end at which it counts as the first one. Inferred: a stick of two axes
that is pushed along one moves the other by a third of its way, seldom more."""

_SETTLED_SECONDS = 0.4
"""Seconds that a channel has to be still to have settled."""

_SETTLED_LEAST = 0.75
"""Share of that time that has to be covered by samples."""

_SETTLED_WILD = 0.1
"""Share of the samples that may be wild."""

_LET_GO = 0.5
"""Share of the way to an end within which a still channel was let go."""

_DEVIATIONS = 6.0
"""Standard deviations of the noise that a still channel stays within."""

_UNEVEN = 0.5
"""Share of the longer side below which the shorter one is worth a word."""


class Task(Enum):
    """What a channel is there for, which decides how it has to move."""

    STICK = auto()
    ONE_WAY = auto()
    SWITCH = auto()


TASKS = {1: Task.STICK, 2: Task.STICK, 3: Task.ONE_WAY, 4: Task.SWITCH, 5: Task.SWITCH}
"""Channel 3 drives a motor with one direction; 4 (flip) and 5 (override) are switches."""


class Way(Enum):
    """A direction, by what it does to the raw value."""

    DOWN = auto()
    UP = auto()


def least_travel(deadband: int) -> int:
    """Return how far from rest an end has to be, in counts.

    The deadband, and 127 counts for the 127 speeds: with less, not every speed is reached.
    """
    return deadband + FULL_SCALE


@dataclass(frozen=True, slots=True)
class Travel:
    """How far a channel went; `low` and `high` are `None` before anything was seen.

    Attributes:
        first: the end that was reached first, by most of the way to it.
        held_low, held_high: whether it was held there, not only passed.
        settled: where it is still now, if it is.
        now: the newest valid count.
        interval: seconds between two samples; 0 before it is known.
    """

    source: InputSource
    task: Task
    neutral: int
    deadband: int
    low: int | None
    high: int | None
    first: Way | None
    samples: int
    invalid: int
    is_silent: bool
    held_low: bool
    held_high: bool
    now: int | None
    interval: float
    settled: int | None

    @property
    def rest(self) -> int:
        """Where it rests: where it came to rest when it was let go, else where it was sampled."""
        if self.settled is None or self.task is Task.SWITCH:
            return self.neutral
        way = Way.UP if self.settled > self.neutral else Way.DOWN
        is_let_go = abs(self.settled - self.neutral) < _LET_GO * self.length(way)
        return self.settled if is_let_go else self.neutral

    @property
    def idle(self) -> Way | None:
        """The way that a switch or a throttle never goes, since it rests at that end."""
        ways = [way for way in Way if not self.reached(way)]
        return ways[0] if self.task is not Task.STICK and len(ways) == 1 else None

    @property
    def least(self) -> int:
        """How far from rest an end has to be, in counts."""
        return least_travel(self.deadband)

    def length(self, way: Way) -> int:
        """How far it went that way, in counts; below 0 when it never came back to its rest."""
        if self.low is None or self.high is None:
            return 0
        return self.high - self.neutral if way is Way.UP else self.neutral - self.low

    def reached(self, way: Way) -> bool:
        """Whether it went far enough that way."""
        return self.length(way) >= self.least

    def held(self, way: Way) -> bool:
        """Whether it went far enough that way and was held at the end of it."""
        return self.reached(way) and (self.held_high if way is Way.UP else self.held_low)

    @property
    def to_hold(self) -> Way | None:
        """The way that it is pushed now, where the end still has to be held."""
        for way in Way:
            if self.now is not None and not self.held(way):
                offset = self.now - self.neutral if way is Way.UP else self.neutral - self.now
                if offset >= self.least:
                    return way
        return None

    @property
    def is_slow(self) -> bool:
        """Whether samples come so seldom that an end has to be held for longer."""
        return self.interval > SLOW

    @property
    def hold_seconds(self) -> float:
        """How long an end has to be held to be surely seen: a sample more than have to agree."""
        return max(_LEAST_HOLD, (HELD + 1) * self.interval)

    @property
    def is_enough(self) -> bool:
        """Whether it was held everywhere that its task needs."""
        both = [self.held(way) for way in Way]
        return all(both) if self.task is Task.STICK else any(both)

    @property
    def problems(self) -> tuple[Problem, ...]:
        """What is wrong with what was seen."""
        if self.samples and self.invalid > self.samples / 2:
            return (no_signal(self.source),)
        problems = list(self._lengths())
        if self.samples >= _JUDGED_FROM and self.invalid > _MANY_INVALID * self.samples:
            problems.append(lost_pulses(self.invalid / self.samples, fatal=False))
        return tuple(problems)

    def _lengths(self) -> tuple[Problem, ...]:
        up, down = self.length(Way.UP), self.length(Way.DOWN)
        text = self.source.text
        needed = text(self.least), FULL_SCALE
        longest, shortest = max(up, down), min(up, down)
        if longest <= self.deadband:
            return (self._never_moved(),)
        if shortest < -self.deadband:
            values = text(self.neutral), text(self.low or 0), text(self.high or 0)
            return (Problem(ProblemKind.NEUTRAL_OUTSIDE, values=values),)
        if longest < self.least:
            return (Problem(ProblemKind.TOO_LITTLE, values=(text(longest), *needed)),)
        if self.task is not Task.STICK:
            return self._passed()
        where = "BELOW" if up > down else "ABOVE"
        if shortest <= self.deadband:
            return (Problem(ProblemKind.ONE_DIRECTION, where),)
        if shortest < self.least:
            return (Problem(ProblemKind.END_TOO_NEAR, where, (text(shortest), *needed)),)
        if passed := self._passed():
            return passed
        if shortest < _UNEVEN * longest:
            lengths = text(longest), text(shortest)
            return (Problem(ProblemKind.UNEVEN, where, lengths, fatal=False),)
        return ()

    def _never_moved(self) -> Problem:
        if self.source is InputSource.RC:
            return Problem(ProblemKind.NEVER_MOVED, "RC")
        at_rail = self.neutral <= _RAIL or self.neutral >= self.source.highest_count - _RAIL
        variant = "RAIL" if at_rail else "ANALOG"
        return Problem(ProblemKind.NEVER_MOVED, variant, (self.source.text(self.neutral),))

    def _passed(self) -> tuple[Problem, ...]:
        """Return which ends were only passed."""
        names = {Way.UP: "ABOVE", Way.DOWN: "BELOW"}
        ends = [names[way] for way in Way if self.reached(way) and not self.held(way)]
        if not ends:
            return ()
        variant = ends[0] if len(ends) == 1 else "BOTH"
        return (Problem(ProblemKind.NOT_HELD, variant, (self.hold_seconds,)),)


class TravelWatch:
    """Follows one channel; wild single samples do not count."""

    def __init__(self, neutral: Neutral, task: Task) -> None:
        self._source = neutral.source
        self._task = task
        self._neutral = neutral.value
        self._deadband = neutral.deadband
        self._deviation = neutral.deviation
        self._recent: deque[int] = deque(maxlen=WINDOW)
        self._times: deque[float] = deque(maxlen=_TIMES)
        self._low = EndWatch(neutral.value, neutral.deviation, up=False)
        self._high = EndWatch(neutral.value, neutral.deviation, up=True)
        self._ways: dict[Way, list[int]] = {way: [] for way in Way}
        self._last: deque[tuple[float, int]] = deque()
        self._samples = 0
        self._invalid = 0
        self._heard_at: float | None = None
        self._now = 0.0

    def feed(self, sample: Sample) -> None:
        self._samples += 1
        self._now = sample.time
        self._times.append(sample.time)
        if self._heard_at is None:
            self._heard_at = sample.time
        if sample.count is None:
            self._invalid += 1
            return
        self._heard_at = sample.time
        self._recent.append(sample.count)
        slow = self._interval > SLOW
        for end in (self._low, self._high):
            end.feed(self._recent, slow=slow)
        for way, sign, watch in ((Way.DOWN, -1, self._low), (Way.UP, 1, self._high)):
            if watch.end is not None:
                self._ways[way].append(sign * (watch.end - self._neutral))
        self._last.append((sample.time, sample.count))
        while len(self._last) > HELD and sample.time - self._last[0][0] > _SETTLED_SECONDS:
            self._last.popleft()

    @property
    def _first(self) -> Way | None:
        """The end that was reached first; known once both were reached."""
        reached = {
            way: bisect_left(furthest, _MOSTLY * furthest[-1])
            for way, furthest in self._ways.items()
            if furthest and furthest[-1] >= least_travel(self._deadband)
        }
        return min(reached, key=lambda way: reached[way], default=None)

    @property
    def _settled(self) -> int | None:
        """Where it is still, a wild value aside."""
        if len(self._last) < HELD:
            return None
        if self._last[-1][0] - self._last[0][0] < _SETTLED_LEAST * _SETTLED_SECONDS:
            return None
        counts = [count for _, count in self._last]
        middle = median(counts)
        tolerance = max(LIMITS[self._source].moved / 2, _DEVIATIONS * self._deviation)
        wild = sum(abs(count - middle) > tolerance for count in counts)
        return round(middle) if wild <= _SETTLED_WILD * len(counts) else None

    @property
    def _interval(self) -> float:
        """Seconds between two samples, most often."""
        steps = [b - a for a, b in pairwise(self._times)]
        return median(steps) if steps else 0.0

    @property
    def travel(self) -> Travel:
        """What was seen so far."""
        silent = self._heard_at is not None and self._now - self._heard_at > _SILENT_AFTER
        return Travel(
            self._source,
            self._task,
            self._neutral,
            self._deadband,
            self._low.end,
            self._high.end,
            self._first,
            self._samples,
            self._invalid,
            silent,
            held_low=self._low.held,
            held_high=self._high.held,
            now=self._recent[-1] if self._recent else None,
            interval=self._interval,
            settled=None if silent else self._settled,
        )
