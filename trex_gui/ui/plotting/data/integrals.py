"""Sums over time of values and of their squares, kept so that any span costs two look-ups."""

from dataclasses import dataclass

import numpy as np

from trex_gui.ui.plotting.data.source import Floats

BLOCK = 64
"""Rows between two sums that are kept; what lies between is added up when asked for."""


@dataclass(frozen=True, slots=True)
class Sums:
    """Of one column over some rows; the interval before a row belongs to it."""

    seconds: float
    integral: float
    squares: float


class Integrals:
    """Time, unit x time and squared unit x time, by the trapezoidal rule.

    Two samples further apart than `max_gap` seconds, or one that is no number, count for
    nothing: the line was silent between them and nobody knows what flowed.
    """

    def __init__(self, columns: int, max_gap: float) -> None:
        self._max_gap = max_gap
        self._done = 0
        self._kept = np.zeros((3, columns, 1))

    def resize(self, rows: int) -> None:
        """Make room for so many rows; what is there stays."""
        grown = np.zeros((*self._kept.shape[:2], rows // BLOCK + 1))
        grown[:, :, : self._done + 1] = self._kept[:, :, : self._done + 1]
        self._kept = grown

    def grow(self, times: Floats, values: Floats, size: int) -> None:
        """Take the rows up to `size`."""
        done = size // BLOCK
        if done == self._done:
            return
        first, stop = self._done * BLOCK, done * BLOCK
        shape = (*self._kept.shape[:2], done - self._done, BLOCK)
        added = self._intervals(times, values, first, stop).reshape(shape).sum(axis=3)
        before = self._kept[:, :, self._done, np.newaxis]
        self._kept[:, :, self._done + 1 : done + 1] = before + np.cumsum(added, axis=2)
        self._done = done

    def drop(self, rows: int) -> None:
        """Forget the first rows, a multiple of `BLOCK`; sums begin anew there, and stay exact."""
        gone = rows // BLOCK
        left = self._kept[:, :, gone : self._done + 1] - self._kept[:, :, gone, np.newaxis]
        self._done -= gone
        self._kept[:, :, : self._done + 1] = left

    def between(self, times: Floats, values: Floats, column: int, first: int, stop: int) -> Sums:
        """Return the sums of one column over the intervals between rows `first` and `stop` - 1."""
        first += 1  # the interval before the first row is outside
        if first >= stop:
            return Sums(0.0, 0.0, 0.0)
        begin, end = -(-first // BLOCK), min(stop // BLOCK, self._done)
        if begin >= end:
            return Sums(*self._sum(times, values, column, first, stop))
        middle = self._kept[:, column, end] - self._kept[:, column, begin]
        head = self._sum(times, values, column, first, begin * BLOCK)
        tail = self._sum(times, values, column, end * BLOCK, stop)
        return Sums(*(head + middle + tail))

    def _sum(self, times: Floats, values: Floats, column: int, first: int, stop: int) -> Floats:
        one = values[column : column + 1]
        total: Floats = self._intervals(times, one, first, stop).sum(axis=2)[:, 0]
        return total

    def _intervals(self, times: Floats, values: Floats, first: int, stop: int) -> Floats:
        """Return what each row's interval adds: (sums, columns, rows); row 0 has none."""
        added = np.zeros((3, len(values), stop - first))
        begin = max(first, 1)
        if begin >= stop:
            return added
        after, before = values[:, begin:stop], values[:, begin - 1 : stop - 1]
        width = times[begin:stop] - times[begin - 1 : stop - 1]
        width = np.where(width <= self._max_gap, width, 0.0)
        known = np.isfinite(after) & np.isfinite(before)
        part = added[:, :, begin - first :]
        part[0] = np.where(known, width, 0.0)
        part[1] = np.where(known, (before + after) / 2 * width, 0.0)
        part[2] = np.where(known, (before * before + after * after) / 2 * width, 0.0)
        return added
