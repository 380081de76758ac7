"""Whether an end was held for long enough to be believed, or only passed."""

from collections import deque
from math import ceil
from statistics import median_low

WINDOW = 5
"""Samples whose median counts as seen: up to two wild ones among them make no end, and an end
counts once it was held for three (60 ms)."""

HELD = 3
"""Samples in a row that have to agree."""

SLOW = 0.05
"""Seconds between samples from which on it is slow: a wild pulse lasts 20 ms, so it is never
read twice then, while a stick that is pushed and let go at once may be read once only."""

_SHARE = 0.02
_DEVIATIONS = 6.0
"""Samples agree within this share of the way and so many standard deviations of the noise."""


class EndWatch:
    """Follows one channel towards one of its ends.

    An end is held when some samples in a row agree with the furthest place that was seen. On a
    slow line one sample beyond that place is enough to doubt it, until it is held anew.

    Attributes:
        end: the furthest median so far, in counts; `None` before there was one.
        held: whether it was held there.
    """

    def __init__(self, neutral: int, deviation: float, *, up: bool) -> None:
        self.end: int | None = None
        self.held = False
        self._neutral = neutral
        self._deviation = deviation
        self._sign = 1 if up else -1
        self._held_at: int | None = None

    def feed(self, recent: deque[int], *, slow: bool) -> None:
        """Take the last samples, the newest of which is new."""
        if len(recent) < WINDOW:
            return
        seen = median_low(recent)
        if self.end is None or self._beyond(seen, self.end) > 0:
            self.end = seen
        tolerance = self._tolerance(self.end)
        last = list(recent)[-HELD:]
        middle = median_low(last)
        if max(last) - min(last) <= tolerance and self._beyond(self.end, middle) <= tolerance:
            self._held_at = middle
        elif slow and self._beyond(recent[-1], self.end) > tolerance:
            self._held_at = None
        self.held = self._held_at is not None and self._beyond(self.end, self._held_at) <= tolerance

    def _tolerance(self, end: int) -> int:
        return ceil(_SHARE * abs(end - self._neutral) + _DEVIATIONS * self._deviation)

    def _beyond(self, count: int, other: int) -> int:
        """Return how much further out a count lies than another."""
        return self._sign * (count - other)
