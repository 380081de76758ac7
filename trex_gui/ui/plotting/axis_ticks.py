"""The arithmetic of axes and labels: steps of 1, 2 and 5, ranges that do not jump, spreading."""

import math
from collections.abc import Sequence

_STEPS = (1.0, 2.0, 5.0)


def round_up(value: float) -> float:
    """Return the smallest of ... 0.5, 1, 2, 5, 10, 20 ... that is not below `value` (> 0)."""
    decade = 10.0 ** math.floor(math.log10(value))
    for step in (*_STEPS, 10.0):
        # The margin keeps 0.3 - 0.1 from counting as more than 0.2.
        if value <= step * decade * (1 + 1e-9):
            return step * decade
    return 10.0 * decade  # pragma: no cover - rounding in log10 only


def ticks(low: float, high: float, step: float) -> list[float]:
    """Return the multiples of `step` from `low` to `high`, both included."""
    first = math.ceil(low / step - 1e-9)
    last = math.floor(high / step + 1e-9)
    return [n * step for n in range(first, last + 1)]


def spread(
    centres: Sequence[float], widths: Sequence[float], low: float, high: float, gap: float
) -> list[float] | None:
    """Move labels as little as needed so that none covers its neighbour.

    `centres` rise. The result is where each centre goes, within `low` to `high`; `None` when
    there is not room for all.
    """
    if sum(widths) + gap * max(0, len(widths) - 1) > high - low:
        return None
    # Labels that touch form a group, which sits where its members lean to on average.
    groups: list[_Group] = []
    for centre, width in zip(centres, widths, strict=True):
        group = _Group([width], [centre - width / 2], gap)
        group.settle(low, high)
        while groups and groups[-1].left + groups[-1].width + gap > group.left:
            group = groups.pop().joined(group)
            group.settle(low, high)
        groups.append(group)
    return [centre for group in groups for centre in group.centres()]


class _Group:
    """Labels side by side; `wishes` is where each would put the left edge of the group."""

    def __init__(self, widths: list[float], wishes: list[float], gap: float) -> None:
        self.widths = widths
        self.wishes = wishes
        self.gap = gap
        self.width = sum(widths) + gap * (len(widths) - 1)
        self.left = 0.0

    def settle(self, low: float, high: float) -> None:
        wish = sum(self.wishes) / len(self.wishes)
        self.left = max(low, min(wish, high - self.width))

    def joined(self, other: "_Group") -> "_Group":
        shift = self.width + self.gap
        wishes = [*self.wishes, *(wish - shift for wish in other.wishes)]
        return _Group([*self.widths, *other.widths], wishes, self.gap)

    def centres(self) -> list[float]:
        edge = self.left
        found = []
        for width in self.widths:
            found.append(edge + width / 2)
            edge += width + self.gap
        return found


class AutoRange:
    """A range in steps of 1, 2 and 5 that grows at once and shrinks only when it pays.

    It contains 0, for currents and speeds mean little without it.
    """

    SHRINK_BELOW = 0.8
    """How far the data must lie within the next smaller range before that is taken."""

    def __init__(self, smallest: float = 1.0) -> None:
        self._smallest = smallest
        self.low = 0.0
        self.high = smallest

    def reset(self) -> None:
        """Go back to the range of no data."""
        self.low = 0.0
        self.high = self._smallest

    def include(self, low: float, high: float) -> bool:
        """Take the extremes of what is shown; return whether the range is another now."""
        before = (self.low, self.high)
        self.high = self._end(self.high, max(0.0, high))
        self.low = -self._end(-self.low, max(0.0, -low))
        if self.high == 0 and self.low == 0:
            self.high = self._smallest
        return (self.low, self.high) != before

    def _end(self, current: float, wanted: float) -> float:
        if wanted <= 0:
            return 0.0
        if wanted > current:
            return max(self._smallest, round_up(wanted))
        return min(current, max(self._smallest, round_up(wanted / self.SHRINK_BELOW)))
