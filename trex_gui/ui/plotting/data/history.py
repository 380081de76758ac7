"""A million rows of samples in bounded memory, of which any span is drawn and summed up at once."""

import itertools
import math
from bisect import bisect_right
from collections.abc import Sequence
from operator import itemgetter

import numpy as np

from trex_gui.ui.plotting.data.integrals import Integrals
from trex_gui.ui.plotting.data.pyramid import FACTOR, MOST_LEVELS, Pyramid
from trex_gui.ui.plotting.data.source import Floats, Points, Statistics

CAPACITY = 1_000_000
"""Rows kept: three and a half hours at 80 a second."""

MAX_GAP = 0.5
"""Seconds without a sample after which a line was silent: 40 samples of currents long."""

_FIRST_ROOM = 4096

_GAPS_AT_ONCE = 200
"""Long gaps that a picture shows as such; where there are more, only the longest of them."""


class SampleHistory:
    """The last `capacity` rows of a time and some values; times rise.

    A value that is no number means that nothing was known. Memory grows with the rows; when it
    is full the oldest go. Adding a row costs the same on average however many there are.
    """

    def __init__(self, columns: int, capacity: int = CAPACITY, max_gap: float = MAX_GAP) -> None:
        self._capacity = capacity
        self._columns = columns
        self._max_gap = max_gap
        # Rows go so many at a time that blocks of every size go whole.
        self._levels = 2
        while self._levels < MOST_LEVELS and 2 * FACTOR ** (self._levels + 1) <= capacity:
            self._levels += 1
        self._step = FACTOR**self._levels
        self._most = -(-capacity // self._step) * self._step + self._step
        self._clear()

    def _clear(self) -> None:
        self._pyramid = Pyramid(self._columns, self._levels)
        self._integrals = Integrals(self._columns, self._max_gap)
        self._times = np.empty(0)
        self._values = np.empty((self._columns, 0))
        self._size = 0
        self._gaps: list[tuple[float, float]] = []  # of each: when it ended, how long it was

    def __len__(self) -> int:
        return min(self._size, self._capacity)

    @property
    def capacity(self) -> int:
        """How many rows are kept at most."""
        return self._capacity

    @property
    def columns(self) -> int:
        """How many values a row has beside its time."""
        return self._columns

    @property
    def times(self) -> Floats:
        """The times, oldest first: a view, valid until the next row."""
        return self._times[self._begin : self._size]

    def values(self, column: int) -> Floats:
        """One column's values, oldest first: a view, valid until the next row."""
        return self._values[column, self._begin : self._size]

    @property
    def span(self) -> tuple[float, float] | None:
        """The oldest and the newest time."""
        if not self._size:
            return None
        return float(self._times[self._begin]), float(self._times[self._size - 1])

    # --- Growing ------------------------------------------------------------------------

    def append(self, time: float, *values: float) -> None:
        """Add a row; a time before the newest one is taken for that."""
        self._make_room(1)
        end = self._size
        if end:
            last = float(self._times[end - 1])
            time = max(time, last)
            if time - last > self._max_gap:
                self._gaps.append((time, time - last))
        self._times[end] = time
        self._values[:, end] = values
        self._grow(end + 1)

    def extend(self, times: Floats, values: Sequence[Floats]) -> None:
        """Add rows, a sequence of values for each column; times rise."""
        for first in range(0, len(times), self._step):
            span = slice(first, first + self._step)
            self._extend(times[span], [column[span] for column in values])

    def _extend(self, times: Floats, values: Sequence[Floats]) -> None:
        self._make_room(len(times))
        end, stop = self._size, self._size + len(times)
        self._times[end:stop] = times
        for column, more in enumerate(values):
            self._values[column, end:stop] = more
        begin = max(end, 1)
        width = self._times[begin:stop] - self._times[begin - 1 : stop - 1]
        for at in np.flatnonzero(width > self._max_gap):
            self._gaps.append((float(self._times[begin + at]), float(width[at])))
        self._grow(stop)

    def clear(self) -> None:
        """Forget every row, and give the memory back."""
        self._clear()

    def _grow(self, size: int) -> None:
        if size // FACTOR != self._size // FACTOR:
            self._pyramid.grow(self._values, size)
            self._integrals.grow(self._times, self._values, size)
        self._size = size

    def _make_room(self, rows: int) -> None:
        if self._size + rows > self._most:
            self._drop(self._step)
        room = len(self._times)
        if self._size + rows <= room:
            return
        room = min(self._most, max(2 * room, _FIRST_ROOM, self._size + rows))
        times, values = np.empty(room), np.empty((self._columns, room))
        times[: self._size] = self._times[: self._size]
        values[:, : self._size] = self._values[:, : self._size]
        self._times, self._values = times, values
        self._pyramid.resize(room)
        self._integrals.resize(room)

    def _drop(self, rows: int) -> None:
        left = self._size - rows
        self._times[:left] = self._times[rows : self._size].copy()
        for column in self._values:
            column[:left] = column[rows : self._size].copy()
        self._pyramid.drop(rows)
        self._integrals.drop(rows)
        self._size = left
        oldest = float(self._times[0]) if left else math.inf
        self._gaps = [gap for gap in self._gaps if gap[0] > oldest]

    # --- Looking ------------------------------------------------------------------------

    @property
    def _begin(self) -> int:
        return max(0, self._size - self._capacity)

    def rows(self, start: float, end: float) -> slice:
        """Return which of `times` lie from `start` to `end`."""
        first, stop = self._rows(start, end)
        return slice(first - self._begin, stop - self._begin)

    def _rows(self, start: float, end: float) -> tuple[int, int]:
        times = self.times
        first = int(times.searchsorted(start, side="left"))
        stop = int(times.searchsorted(end, side="right"))
        return self._begin + first, self._begin + max(first, stop)

    def value_at(self, column: int, time: float) -> float:
        """Return the last value before or at a time; NaN before the first and within a gap."""
        _, stop = self._rows(-math.inf, time)
        if stop == self._begin or time - self._times[stop - 1] > self._max_gap:
            return math.nan
        return float(self._values[column, stop - 1])

    def statistics(self, column: int, start: float, end: float) -> Statistics:
        """Sum up a column's samples from `start` to `end`."""
        first, stop = self._rows(start, end)
        _, lows, highs = self._pyramid.blocks(self._values, column, first, stop, 1)
        if not np.isfinite(lows).any():
            return Statistics()
        low, high = float(np.fmin.reduce(lows)), float(np.fmax.reduce(highs))
        sums = self._integrals.between(self._times, self._values, column, first, stop)
        if sums.seconds <= 0:
            return Statistics(low=low, high=high)
        mean = sums.integral / sums.seconds
        rms = math.sqrt(max(0.0, sums.squares / sums.seconds))
        return Statistics(sums.seconds, sums.integral, mean, rms, low, high)

    def points(self, column: int, start: float, end: float, bins: int) -> Points:
        """Return the samples, or two for each of `bins` where they are many more.

        A bin gives its smallest and its greatest value, in the order in which the line goes
        through it. Bins lie at multiples of their width, so that a picture that scrolls does not
        flicker. One sample outside stands at either end, so that the line reaches the edges; the
        newest sample is always the last point.
        """
        first, stop = self._rows(start, end)
        first, stop = max(self._begin, first - 1), min(self._size, stop + 1)
        width = (end - start) / bins
        pieces = []
        for begin, until in self._between_gaps(first, stop, max(self._max_gap, width)):
            pieces.append(self._piece(column, begin, until, width))
            pieces.append((pieces[-1][0][-1:], np.array([math.nan])))
        if not pieces:
            return np.empty(0), np.empty(0)
        pieces.pop()
        times, values = zip(*pieces, strict=True)
        return np.concatenate(times), np.concatenate(values)

    def _between_gaps(self, first: int, stop: int, longest: float) -> list[tuple[int, int]]:
        """Return the rows as spans between which no sample came for longer than that."""
        if first >= stop:
            return []
        low, high = float(self._times[first]), float(self._times[stop - 1])
        ended = itemgetter(0)  # they stand in the order of time
        from_, to = (bisect_right(self._gaps, time, key=ended) for time in (low, high))
        gaps = [gap for gap in self._gaps[from_:to] if gap[1] > longest]
        if len(gaps) > _GAPS_AT_ONCE:
            gaps = sorted(gaps, key=lambda gap: gap[1])[-_GAPS_AT_ONCE:]
        ends = sorted(int(self._times[: self._size].searchsorted(at)) for at, _ in gaps)
        edges = [first, *ends, stop]
        return [(a, b) for a, b in itertools.pairwise(edges) if a < b]

    def _piece(self, column: int, first: int, stop: int, width: float) -> Points:
        """Return the points of rows without a gap between them; see `points`."""
        seconds = float(self._times[stop - 1] - self._times[first])
        bins = max(1, math.ceil(seconds / width))
        if stop - first <= 2 * bins + 2:
            return self._times[first:stop].copy(), self._values[column, first:stop].copy()
        starts, low, high = self._pyramid.blocks(self._values, column, first, stop, 2 * bins)
        of_bin = np.floor(self._times[starts] / width)
        heads = np.flatnonzero(np.diff(of_bin, prepend=math.nan) != 0)
        low, high = np.fmin.reduceat(low, heads), np.fmax.reduceat(high, heads)
        begins = starts[heads]
        ends = np.append(begins[1:], stop) - 1
        column_values = self._values[column]
        falling = column_values[ends] < column_values[begins]
        values = np.empty(2 * len(begins) + 1)
        values[0:-1:2] = np.where(falling, high, low)
        values[1:-1:2] = np.where(falling, low, high)
        times = np.empty_like(values)
        times[0:-1:2] = self._times[begins]
        times[1:-1:2] = (self._times[begins] + self._times[ends]) / 2
        times[-1] = self._times[stop - 1]
        values[-1] = column_values[stop - 1]
        return times, values
