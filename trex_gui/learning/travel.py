"""How far a channel goes to each side of its rest, followed while it moves."""

from collections import deque
from dataclasses import dataclass
from enum import Enum, auto
from statistics import median_low

from trex_gui.learning.neutral import Neutral, lost_pulses, no_signal
from trex_gui.learning.problems import Kind, Problem
from trex_gui.learning.samples import Sample
from trex_gui.protocol.calibration import FULL_SCALE
from trex_gui.protocol.flags import InputSource

WINDOW = 5
"""Samples whose median counts as seen: up to two wild ones among them make no end, and an end
counts once it was held for three (60 ms)."""

_SILENT_AFTER = 0.5
"""Seconds without a valid sample until a channel is said to have no signal."""

_MANY_INVALID = 0.1
_JUDGED_FROM = 25
"""Samples from which on a share of invalid ones says something."""

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
    """How far a channel went; `low` and `high` are `None` before anything was seen."""

    source: InputSource
    task: Task
    neutral: int
    deadband: int
    low: int | None = None
    high: int | None = None
    first: Way | None = None
    samples: int = 0
    invalid: int = 0
    is_silent: bool = False

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

    @property
    def is_enough(self) -> bool:
        """Whether it went everywhere that its task needs."""
        both = [self.reached(way) for way in Way]
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
        needed = (
            f"{text(self.least)} are needed: the deadband, and a count for each of the "
            f"{FULL_SCALE} speeds"
        )
        longest, shortest = max(up, down), min(up, down)
        if longest <= self.deadband:
            return (Problem(Kind.NEVER_MOVED, "It never moved. Is it the right stick?"),)
        if shortest < -self.deadband:
            words = (
                f"Its rest ({text(self.neutral)}) is not between the ends that it went to "
                f"({text(self.low or 0)} and {text(self.high or 0)}). Was a trim moved? Begin "
                "again with the sticks at rest."
            )
            return (Problem(Kind.NEUTRAL_OUTSIDE, words),)
        if longest < self.least:
            words = f"It went only {text(longest)} from its rest; {needed}."
            return (Problem(Kind.TOO_LITTLE, words),)
        if self.task is not Task.STICK:
            return ()
        where = "below" if up > down else "above"
        if shortest <= self.deadband:
            words = (
                f"It went one way only, never {where} its rest. Push it the other way too; if it "
                "cannot go there, it rested at an end while it was sampled."
            )
            return (Problem(Kind.ONE_DIRECTION, words),)
        if shortest < self.least:
            words = f"The end {where} is only {text(shortest)} from its rest; {needed}."
            return (Problem(Kind.END_TOO_NEAR, words),)
        if shortest < _UNEVEN * longest:
            words = (
                f"It went {text(longest)} to one side, {text(shortest)} {where}. Was it pushed "
                "all the way?"
            )
            return (Problem(Kind.UNEVEN, words, fatal=False),)
        return ()


class TravelWatch:
    """Follows one channel; wild single samples do not count."""

    def __init__(self, neutral: Neutral, task: Task) -> None:
        self._source = neutral.source
        self._task = task
        self._neutral = neutral.value
        self._deadband = neutral.deadband
        self._window: deque[int] = deque(maxlen=WINDOW)
        self._low: int | None = None
        self._high: int | None = None
        self._first: Way | None = None
        self._samples = 0
        self._invalid = 0
        self._heard_at: float | None = None
        self._now = 0.0

    def feed(self, sample: Sample) -> None:
        """Take the next sample."""
        self._samples += 1
        self._now = sample.time
        if self._heard_at is None:
            self._heard_at = sample.time
        if sample.count is None:
            self._invalid += 1
            return
        self._heard_at = sample.time
        self._window.append(sample.count)
        if len(self._window) < WINDOW:
            return
        seen = median_low(self._window)
        self._low = seen if self._low is None else min(self._low, seen)
        self._high = seen if self._high is None else max(self._high, seen)
        offset = seen - self._neutral
        if self._first is None and abs(offset) >= least_travel(self._deadband):
            self._first = Way.UP if offset > 0 else Way.DOWN

    @property
    def travel(self) -> Travel:
        """What was seen so far."""
        silent = self._heard_at is not None and self._now - self._heard_at > _SILENT_AFTER
        return Travel(
            self._source,
            self._task,
            self._neutral,
            self._deadband,
            self._low,
            self._high,
            self._first,
            self._samples,
            self._invalid,
            silent,
        )
