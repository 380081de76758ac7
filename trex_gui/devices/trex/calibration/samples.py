"""Samples of one channel, and how much of their changing is noise."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from statistics import median

from trex_gui.devices.trex.protocol.flags import InputSource

MAD_TO_DEVIATION = 1.4826
"""Standard deviation of a normal distribution for a median absolute deviation of 1."""

LEAST_DEVIATION = 1.0
"""Counts; a converter that rounds to whole counts cannot be trusted to less."""

_STILL = 0.75
"""Share of equal neighbours from which a signal counts as standing still.

The board renews its inputs 50 times a second; polling as often reads some values twice.
"""


@dataclass(frozen=True, slots=True)
class Sample:
    """A raw count at a time in seconds; `None` without a valid signal."""

    time: float
    count: int | None


@dataclass(frozen=True, slots=True)
class InputLimits:
    """What counts as movement, in counts, however quiet a signal is."""

    moved: int
    drifted: int
    noisy: int


LIMITS = {
    InputSource.RC: InputLimits(moved=25, drifted=12, noisy=312),  # 10, 5 and 125 us
    InputSource.ANALOG: InputLimits(moved=8, drifted=4, noisy=128),  # 39, 20 and 626 mV
}
"""Inferred, from what sticks do: a hand moves one further than this, a spring holds it closer."""


def deviation(counts: Sequence[int]) -> float:
    """Return the standard deviation of the noise, whatever else the signal does.

    It comes from the differences between neighbours and from their medians: neither a steady
    movement nor a few wild values make noise of what is none.
    """
    steps = [b - a for a, b in pairwise(counts)]
    moving = [step for step in steps if step]
    if not steps or len(moving) <= (1 - _STILL) * len(steps):
        return LEAST_DEVIATION
    trend = median(moving)
    spread = min(median(abs(step - way) for step in moving) for way in (0, trend))
    return max(LEAST_DEVIATION, MAD_TO_DEVIATION * spread / 2**0.5)


def runs(marks: Sequence[bool]) -> Iterator[tuple[int, int]]:
    """Yield where marks that are set begin and end (beyond the last), run by run."""
    start = None
    for index, mark in enumerate([*marks, False]):
        if mark and start is None:
            start = index
        elif not mark and start is not None:
            yield start, index
            start = None
