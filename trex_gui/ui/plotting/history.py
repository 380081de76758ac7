"""Sample history in bounded memory, with fast plots and statistics of any span.

`SampleColumn` stores the extremes of each block of rows. Therefore, plotting a million samples
takes no longer than plotting ten thousand samples.
"""

import itertools
import math
from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from operator import itemgetter
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.floating[Any]]

Points = tuple[Floats, Floats]  # times and values; NaN interrupts the curve
CAPACITY = 1_000_000  # rows
MAX_GAP = 0.5  # seconds, or 40 samples of currents; a longer gap interrupts a curve
_INITIAL_ROWS = 4096
_MAX_GAPS_DRAWN = 200  # only the longest gaps of a span are drawn
BLOCK = 64  # rows per summary
_STEPS = 16  # parts of the capacity; one part is dropped at a time


class SampleColumn:
    """Values of one column, with a summary of each complete block.

    Extremes ignore NaN, unless a block contains only NaN. Integrals use the trapezoidal rule.
    The interval before a row belongs to that row. An interval counts as zero if it is longer
    than `max_gap` seconds, or if the value at one of its ends is NaN.
    """

    def __init__(self, kind: str, max_gap: float) -> None:
        self._max_gap = max_gap
        self.values: Floats = np.empty(0, kind)
        self._blocks = 0  # number of summarized blocks
        self._extremes: Floats = np.empty((2, 0), kind)  # lowest and highest value
        self._integrals: Floats = np.empty((3, 0))  # seconds, integral, integral of squares

    def resize(self, rows: int, size: int) -> None:
        self.values = _resized(self.values, rows, size)
        self._extremes = _resized(self._extremes, rows // BLOCK, self._blocks)
        self._integrals = _resized(self._integrals, rows // BLOCK, self._blocks)

    def summarize(self, times: Floats, size: int) -> None:
        first, stop = self._blocks, size // BLOCK
        if first == stop:
            return
        start, end = first * BLOCK, stop * BLOCK
        values = self.values[start:end].reshape(-1, BLOCK)
        for reduce, summary in zip((np.fmin, np.fmax), self._extremes, strict=True):
            reduce.reduce(values, axis=1, out=summary[first:stop])
        integrals = self._intervals(times, start, end).reshape(3, -1, BLOCK)
        np.add.reduce(integrals, axis=2, out=self._integrals[:, first:stop])
        self._blocks = stop

    def drop(self, rows: int, remaining: int) -> None:
        """Drop the first `rows` rows. `rows` must be a multiple of `BLOCK`."""
        self.values[:remaining] = self.values[rows : rows + remaining].copy()
        dropped, blocks = rows // BLOCK, self._blocks
        self._blocks -= dropped
        for summaries in (self._extremes, self._integrals):
            summaries[:, : self._blocks] = summaries[:, dropped:blocks].copy()

    def extremes(
        self, first: int, stop: int, min_blocks: int
    ) -> tuple[NDArray[np.intp], Floats, Floats]:
        """Split rows `first` to `stop` into parts. Return the first row and extremes of each part.

        A part is a complete block, or a single row before or after the blocks. If there are
        fewer than `min_blocks` complete blocks, every part is a single row.
        """
        start, end = self._complete_blocks(first, stop)
        if end - start < min_blocks * BLOCK:
            start = end = stop
        ends = np.arange(first, start), np.arange(end, stop)
        starts = np.concatenate([ends[0], np.arange(start, end, BLOCK), ends[1]])
        before, after = self.values[first:start], self.values[end:stop]
        blocks = self._extremes[:, start // BLOCK : end // BLOCK]
        low, high = (np.concatenate([before, extremes, after]) for extremes in blocks)
        return starts, low, high

    def integrals(self, times: Floats, first: int, stop: int) -> tuple[float, float, float]:
        """Return the seconds, integral and integral of squares for rows `first` to `stop`."""
        start, end = self._complete_blocks(first + 1, stop)
        total = self._integrals[:, start // BLOCK : end // BLOCK].sum(axis=1)
        for part in ((first + 1, start), (end, stop)):
            total += self._intervals(times, *part).sum(axis=1)
        seconds, integral, squares = total.tolist()
        return seconds, integral, squares

    def _complete_blocks(self, first: int, stop: int) -> tuple[int, int]:
        start, end = -(-first // BLOCK) * BLOCK, min(stop // BLOCK, self._blocks) * BLOCK
        return (start, end) if start < end else (stop, stop)

    def _intervals(self, times: Floats, first: int, stop: int) -> Floats:
        """Integrate the interval before each row. The result has the shape (3, rows)."""
        integrals = np.zeros((3, stop - first))
        start = max(first, 1)  # row 0 has no interval
        values = self.values[start - 1 : stop].astype(np.float64)
        before, after = values[:-1], values[1:]
        width = times[start:stop] - times[start - 1 : stop - 1]
        is_valid = np.isfinite(after) & np.isfinite(before) & (width <= self._max_gap)
        part = integrals[:, start - first :]
        np.copyto(part[0], width, where=is_valid)
        np.copyto(part[1], (before + after) / 2 * width, where=is_valid)
        np.copyto(part[2], (before * before + after * after) / 2 * width, where=is_valid)
        return integrals


def _resized(array: Floats, size: int, used: int) -> Floats:
    """Return a copy whose last dimension has another size.

    Only the first `used` values are copied.
    """
    resized = np.empty((*array.shape[:-1], size), array.dtype)
    resized[..., :used] = array[..., :used]
    return resized


@dataclass(frozen=True, slots=True)
class Statistics:
    """Statistics of a curve over a span, excluding gaps. NaN: unknown."""

    seconds: float = 0.0  # total time with samples
    integral: float = 0.0  # unit × seconds
    mean: float = math.nan  # weighted by time
    rms: float = math.nan  # weighted by time
    low: float = math.nan
    high: float = math.nan


class SampleHistory:
    """The last `capacity` rows, in chronological order. NaN stands for an unknown value.

    `columns`: number of columns, or numpy type of each column. "float16" stores integers up to
    2048 exactly. `max_gap`: seconds. Adding a row takes constant time on average.
    """

    def __init__(
        self, columns: int | Sequence[str], capacity: int = CAPACITY, max_gap: float = MAX_GAP
    ) -> None:
        self.capacity = capacity
        self._kinds = ["float64"] * columns if isinstance(columns, int) else columns
        self._max_gap = max_gap
        # Excess rows are dropped in steps, and a step consists of complete blocks.
        self._step = max(1, capacity // (_STEPS * BLOCK)) * BLOCK
        self._max_rows = -(-capacity // self._step) * self._step + self._step
        self.clear()

    def clear(self) -> None:
        self._times: Floats = np.empty(0)
        self._columns = [SampleColumn(kind, self._max_gap) for kind in self._kinds]
        self._size = 0
        self._gaps: list[tuple[float, float]] = []  # end and length of each gap

    def __len__(self) -> int:
        return min(self._size, self.capacity)

    @property
    def times(self) -> Floats:
        """View of the times, oldest first. Valid until a row is added."""
        return self._times[self._start : self._size]

    def values(self, column: int) -> Floats:
        """Return a view of the values, oldest first. Valid until a row is added."""
        return self._columns[column].values[self._start : self._size]

    @property
    def span(self) -> tuple[float, float] | None:
        return (float(self.times[0]), float(self.times[-1])) if self._size else None

    def append(self, time: float, *values: float) -> None:
        """Add a row. If `time` is before the newest row, use the time of that row."""
        self._reserve(1)
        end = self._size
        if end:
            last = float(self._times[end - 1])
            time = max(time, last)
            if time - last > self._max_gap:
                self._gaps.append((time, time - last))
        self._times[end] = time
        for column, value in zip(self._columns, values, strict=True):
            column.values[end] = value
        self._grow(end + 1)

    def extend(self, times: Floats, values: Sequence[Floats]) -> None:
        """Add rows in chronological order. `values`: one array per column."""
        for first in range(0, len(times), self._step):
            span = slice(first, first + self._step)
            self._extend(times[span], [column[span] for column in values])

    def _extend(self, times: Floats, values: Sequence[Floats]) -> None:
        self._reserve(len(times))
        end, stop = self._size, self._size + len(times)
        self._times[end:stop] = times
        for column, new in zip(self._columns, values, strict=True):
            column.values[end:stop] = new
        start = max(end, 1)
        width = self._times[start:stop] - self._times[start - 1 : stop - 1]
        for index in np.flatnonzero(width > self._max_gap):
            self._gaps.append((float(self._times[start + index]), float(width[index])))
        self._grow(stop)

    def _grow(self, size: int) -> None:
        has_block = size // BLOCK > self._size // BLOCK
        self._size = size
        if has_block:
            for column in self._columns:
                column.summarize(self._times, size)

    def _reserve(self, rows: int) -> None:
        if self._size + rows > self._max_rows:
            self._drop(self._step)
        allocated = len(self._times)
        if self._size + rows <= allocated:
            return
        allocated = min(self._max_rows, max(2 * allocated, _INITIAL_ROWS, self._size + rows))
        self._times = _resized(self._times, allocated, self._size)
        for column in self._columns:
            column.resize(allocated, self._size)

    def _drop(self, rows: int) -> None:
        remaining = self._size - rows
        self._times[:remaining] = self._times[rows : self._size].copy()
        for column in self._columns:
            column.drop(rows, remaining)
        self._size = remaining
        oldest = float(self._times[0]) if remaining else math.inf
        self._gaps = [gap for gap in self._gaps if gap[0] > oldest]

    @property
    def _start(self) -> int:
        return max(0, self._size - self.capacity)

    def rows(self, start: float, end: float) -> slice:
        first, stop = self._rows(start, end)
        return slice(first - self._start, stop - self._start)

    def _rows(self, start: float, end: float) -> tuple[int, int]:
        times = self.times
        first = int(times.searchsorted(start, side="left"))
        stop = int(times.searchsorted(end, side="right"))
        return self._start + first, self._start + max(first, stop)

    def value_at(self, column: int, time: float) -> float:
        """Return the last value at or before a time, or NaN in a gap or before the first value."""
        _, stop = self._rows(-math.inf, time)
        if stop == self._start or time - self._times[stop - 1] > self._max_gap:
            return math.nan
        return float(self._columns[column].values[stop - 1])

    def statistics(self, column: int, start: float, end: float) -> Statistics:
        first, stop = self._rows(start, end)
        _, lows, highs = self._columns[column].extremes(first, stop, 1)
        if not np.isfinite(lows).any():
            return Statistics()
        low, high = float(np.fmin.reduce(lows)), float(np.fmax.reduce(highs))
        seconds, integral, squares = self._columns[column].integrals(self._times, first, stop)
        if seconds <= 0:
            return Statistics(low=low, high=high)
        rms = math.sqrt(max(0.0, squares / seconds))
        return Statistics(seconds, integral, integral / seconds, rms, low, high)

    def points(self, column: int, start: float, end: float, bins: int) -> Points:
        """Return the samples of a span, or two points per bin if there are many samples.

        The two points are the lowest and the highest value of the bin. They rise if the samples
        rise, and fall if the samples fall. Bins start at multiples of their width, so that a
        scrolling plot does not flicker. An additional sample at each end extends the curve to the
        edges. The last point is always a sample.
        """
        first, stop = self._rows(start, end)
        first, stop = max(self._start, first - 1), min(self._size, stop + 1)
        width = (end - start) / bins
        pieces = []
        for start_row, end_row in self._between_gaps(first, stop, max(self._max_gap, width)):
            pieces.append(self._piece(column, start_row, end_row, width))
            pieces.append((pieces[-1][0][-1:], np.array([math.nan])))
        if not pieces:
            return np.empty(0), np.empty(0)
        pieces.pop()
        times, values = zip(*pieces, strict=True)
        return np.concatenate(times), np.concatenate(values)

    def _between_gaps(self, first: int, stop: int, max_gap: float) -> list[tuple[int, int]]:
        """Split a range of rows at gaps longer than `max_gap`."""
        if first >= stop:
            return []
        low, high = float(self._times[first]), float(self._times[stop - 1])
        gap_end = itemgetter(0)
        after, until = (bisect_right(self._gaps, time, key=gap_end) for time in (low, high))
        gaps = [gap for gap in self._gaps[after:until] if gap[1] > max_gap]
        if len(gaps) > _MAX_GAPS_DRAWN:
            gaps = sorted(gaps, key=itemgetter(1))[-_MAX_GAPS_DRAWN:]
        starts = sorted(int(self._times[: self._size].searchsorted(end)) for end, _ in gaps)
        edges = [first, *starts, stop]
        return [(start, end) for start, end in itertools.pairwise(edges) if start < end]

    def _piece(self, column: int, first: int, stop: int, width: float) -> Points:
        seconds = float(self._times[stop - 1] - self._times[first])
        bins = max(1, math.ceil(seconds / width))
        column_values = self._columns[column].values
        if stop - first <= 2 * bins + 2:
            return self._times[first:stop].copy(), column_values[first:stop].copy()
        starts, low, high = self._columns[column].extremes(first, stop, 2 * bins)
        times = self._times[first:stop]
        edges = np.arange(math.floor(times[0] / width), math.floor(times[-1] / width)) + 1
        first_rows = [first, *(first + times.searchsorted(edges * width))]
        indices = np.unique(starts.searchsorted(first_rows))
        indices = indices[indices < len(starts)]
        low, high = np.fmin.reduceat(low, indices), np.fmax.reduceat(high, indices)
        bin_starts = starts[indices]
        bin_ends = np.append(bin_starts[1:], stop) - 1
        falling = column_values[bin_ends] < column_values[bin_starts]
        values = np.empty(2 * len(bin_starts) + 1)
        values[0:-1:2] = np.where(falling, high, low)
        values[1:-1:2] = np.where(falling, low, high)
        times = np.empty_like(values)
        times[0:-1:2] = self._times[bin_starts]
        times[1:-1:2] = (self._times[bin_starts] + self._times[bin_ends]) / 2
        times[-1] = self._times[stop - 1]
        values[-1] = column_values[stop - 1]
        return times, values
