"""Extremes and integrals of blocks of rows, of blocks of blocks, and so on.

A plot of an hour needs the extremes of some hundred spans of samples. From here they cost the
same whether a span holds eight samples or a hundred thousand.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

FACTOR = 8
"""Rows in a block of the lowest level, and blocks in one of the next."""

_BATCH = 64
"""Rows summarized at once: as many cost little more than a single block."""

MAX_LEVELS = 6
"""The largest block has 8 to the power of 6 rows: 55 minutes at 80 samples a second."""


class Integrals(NamedTuple):
    """Of one column by the trapezoidal rule; the interval before a row belongs to the row."""

    seconds: float
    integral: float
    squares: float


class Pyramid:
    """Summaries of whole blocks of the rows of `times` and `values` (columns, rows).

    NaN is left out; a block of nothing else is NaN itself. An interval longer than `max_gap`
    seconds, or with NaN at one end, counts for no integral.
    """

    _REDUCE = (np.fmin, np.fmax, np.add, np.add, np.add)

    def __init__(self, columns: int, levels: int, max_gap: float) -> None:
        self._columns = columns
        self._levels = levels
        self._max_gap = max_gap
        self._done = [0] * (levels + 1)  # whole blocks of each level; level 0: summarized rows
        self._blocks = [np.empty((5, columns, 0)) for _ in range(levels + 1)]

    def resize(self, rows: int) -> None:
        """Make room for the blocks of that many rows; what is there stays."""
        for level in range(1, self._levels + 1):
            grown = np.empty((5, self._columns, rows // FACTOR**level))
            done = self._done[level]
            grown[:, :, :done] = self._blocks[level][:, :, :done]
            self._blocks[level] = grown

    def grow(self, times: Floats, values: Floats, size: int) -> None:
        """Summarize the rows up to `size` in batches; none is read twice."""
        if size - self._done[0] < _BATCH:
            return
        self._done[0] = size
        for level in range(1, self._levels + 1):
            first, done = self._done[level], self._done[level - 1] // FACTOR
            if done == first:
                return
            begin, end = first * FACTOR, done * FACTOR
            if level == 1:
                rows = values[:, begin:end]
                below = [rows, rows, *self._intervals(times, values, begin, end)]
            else:
                below = list(self._blocks[level - 1][:, :, begin:end])
            for reduce, summary, part in zip(self._REDUCE, self._blocks[level], below, strict=True):
                shaped = part.reshape(self._columns, done - first, FACTOR)
                reduce.reduce(shaped, axis=2, out=summary[:, first:done])
            self._done[level] = done

    def drop(self, rows: int) -> None:
        """Forget the first rows, a multiple of the largest block."""
        for level in range(self._levels + 1):
            gone, done = rows // FACTOR**level, self._done[level]
            if level and done > gone:
                blocks = self._blocks[level]
                blocks[:, :, : done - gone] = blocks[:, :, gone:done].copy()
            self._done[level] = max(0, done - gone)

    def extremes(
        self, values: Floats, column: int, first: int, stop: int, least: int
    ) -> tuple[NDArray[np.intp], Floats, Floats]:
        """Return where the blocks that cover rows `first` to `stop` begin, and their extremes.

        They are as large as possible while there are at least `least` of them, and smaller at
        the ends, so that they cover exactly these rows.
        """
        top = 0
        while top < self._levels and (stop - first) // FACTOR ** (top + 1) >= least:
            top += 1
        if first >= stop:
            return np.empty(0, np.intp), np.empty(0), np.empty(0)
        starts, lows, highs = [], [], []
        for level, begin, end in self._cover(first, stop, top):
            size = FACTOR**level
            span = slice(begin // size, end // size)
            blocks = self._blocks[level] if level else (values, values)
            starts.append(np.arange(begin, end, size))
            lows.append(blocks[0][column, span])
            highs.append(blocks[1][column, span])
        return np.concatenate(starts), np.concatenate(lows), np.concatenate(highs)

    def integrals(
        self, times: Floats, values: Floats, column: int, first: int, stop: int
    ) -> Integrals:
        """Return what the intervals between the rows `first` to `stop` - 1 add up to."""
        total = np.zeros(3)
        for level, begin, end in self._cover(first + 1, stop, self._levels):
            size = FACTOR**level
            if level:
                total += self._blocks[level][2:, column, begin // size : end // size].sum(axis=1)
            else:
                one = values[column : column + 1]
                total += self._intervals(times, one, begin, end).sum(axis=2)[:, 0]
        return Integrals(*total.tolist())

    def _cover(self, first: int, stop: int, top: int) -> list[tuple[int, int, int]]:
        """Return (level, from, to) of whole blocks, none above `top`, that cover these rows."""
        done = max(first, min(stop, self._done[0]))
        blocks = _whole_blocks(first, done, top)
        return [*blocks, (0, done, stop)] if done < stop else blocks

    def _intervals(self, times: Floats, values: Floats, first: int, stop: int) -> Floats:
        """Return what the interval before each row adds: (integrals, columns, rows)."""
        added = np.zeros((3, len(values), stop - first))
        begin = max(first, 1)  # there is no interval before row 0
        after, before = values[:, begin:stop], values[:, begin - 1 : stop - 1]
        width = times[begin:stop] - times[begin - 1 : stop - 1]
        counts = np.isfinite(after) & np.isfinite(before) & (width <= self._max_gap)
        part = added[:, :, begin - first :]
        np.copyto(part[0], width, where=counts)
        np.copyto(part[1], (before + after) / 2 * width, where=counts)
        np.copyto(part[2], (before * before + after * after) / 2 * width, where=counts)
        return added


def _whole_blocks(first: int, stop: int, top: int) -> list[tuple[int, int, int]]:
    if first >= stop:
        return []
    if top == 0:
        return [(0, first, stop)]
    size = FACTOR**top
    begin, end = -(-first // size) * size, stop // size * size
    if begin >= end:
        return _whole_blocks(first, stop, top - 1)
    return [
        *_whole_blocks(first, begin, top - 1),
        (top, begin, end),
        *_whole_blocks(end, stop, top - 1),
    ]
