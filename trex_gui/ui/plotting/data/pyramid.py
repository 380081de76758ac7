"""Smallest and greatest values of blocks of rows, of blocks of blocks, and so on.

A picture of an hour needs the extremes of some hundred spans of samples. Read from here that
costs the same whether a span holds eight samples or a hundred thousand.
"""

import numpy as np

from trex_gui.ui.plotting.data.source import Floats

FACTOR = 8
"""Rows in a block of the lowest level, and blocks in one of the next."""

MOST_LEVELS = 6
"""The greatest block has 8 to the power of 6 rows: 55 minutes at 80 samples a second."""


class Pyramid:
    """Extremes of whole blocks; it grows with the rows it is told of and never reads one twice.

    A value that is no number is left out; a block of nothing else is no number itself.
    """

    def __init__(self, columns: int, levels: int = MOST_LEVELS) -> None:
        self._columns = columns
        self._levels = levels
        self._done = [0] * (levels + 1)  # whole blocks of each level; level 0 are the rows
        self._low = [np.empty((columns, 0)) for _ in range(levels + 1)]
        self._high = [np.empty((columns, 0)) for _ in range(levels + 1)]

    def resize(self, rows: int) -> None:
        """Make room for blocks of so many rows; what is there stays."""
        for level in range(1, self._levels + 1):
            for kept in (self._low, self._high):
                grown = np.empty((self._columns, rows // FACTOR**level))
                grown[:, : self._done[level]] = kept[level][:, : self._done[level]]
                kept[level] = grown

    def grow(self, values: Floats, size: int) -> None:
        """Take the rows up to `size` of `values`, a row of which is a column of ours."""
        low = high = values
        self._done[0] = size
        for level in range(1, self._levels + 1):
            first, done = self._done[level], self._done[level - 1] // FACTOR
            if done == first:
                return
            shape = (self._columns, done - first, FACTOR)
            span = slice(first * FACTOR, done * FACTOR)
            new = slice(first, done)
            np.fmin.reduce(low[:, span].reshape(shape), axis=2, out=self._low[level][:, new])
            np.fmax.reduce(high[:, span].reshape(shape), axis=2, out=self._high[level][:, new])
            self._done[level] = done
            low, high = self._low[level], self._high[level]

    def drop(self, rows: int) -> None:
        """Forget the first rows, a multiple of the greatest block."""
        for level in range(self._levels + 1):
            gone = rows // FACTOR**level
            if level and self._done[level] > gone:
                for kept in (self._low, self._high):
                    left = kept[level][:, gone : self._done[level]].copy()
                    kept[level][:, : left.shape[1]] = left
            self._done[level] = max(0, self._done[level] - gone)

    def blocks(
        self, values: Floats, column: int, first: int, stop: int, most: int
    ) -> tuple[np.ndarray[tuple[int], np.dtype[np.intp]], Floats, Floats]:
        """Return where blocks that cover rows `first` to `stop` begin, and their extremes.

        They are as large as can be while there are `most` of them or more, and smaller at the
        ends, so that they cover exactly these rows.
        """
        top = 0
        while top < self._levels and (stop - first) // FACTOR ** (top + 1) >= most:
            top += 1
        starts, lows, highs = [], [], []
        for level, begin, end in _cover(first, stop, top):
            span = slice(begin // FACTOR**level, end // FACTOR**level)
            starts.append(np.arange(begin, end, FACTOR**level))
            lows.append((self._low[level] if level else values)[column, span])
            highs.append((self._high[level] if level else values)[column, span])
        if not starts:
            return np.empty(0, np.intp), np.empty(0), np.empty(0)
        return np.concatenate(starts), np.concatenate(lows), np.concatenate(highs)


def _cover(first: int, stop: int, top: int) -> list[tuple[int, int, int]]:
    """Return spans (level, from, to) of whole blocks, none above `top`, from `first` to `stop`."""
    if first >= stop:
        return []
    size = FACTOR**top
    begin, end = -(-first // size) * size, stop // size * size
    if top == 0:
        return [(0, first, stop)]
    if begin >= end:
        return _cover(first, stop, top - 1)
    return [*_cover(first, begin, top - 1), (top, begin, end), *_cover(end, stop, top - 1)]
