"""Thinning of samples for plots: what a pixel column would hide is left out, peaks are kept."""

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]


def reduce_min_max(
    times: Floats, values: Floats, start: float, end: float, bins: int
) -> tuple[Floats, Floats]:
    """Return the samples from `start` to `end`, or two for each of `bins` where they are more.

    `times` rise. A bin gives its smallest and its greatest value, in the order in which the
    line goes through it. Bins lie at multiples of their width and not at `start`, so that a
    picture which scrolls does not flicker. NaN is a gap; within a bin it is ignored. The last
    sample is always the last result, so that the line ends at the current value.
    """
    first = int(np.searchsorted(times, start, side="left"))
    stop = int(np.searchsorted(times, end, side="right"))
    times, values = times[first:stop], values[first:stop]
    if len(times) <= 2 * bins:
        return times, values
    width = (end - start) / bins
    edges = (np.floor(start / width) + np.arange(1, bins + 1)) * width
    starts = np.concatenate(([0], np.searchsorted(times, edges, side="left")))
    starts = np.unique(starts[starts < len(times)])  # reduceat cannot do empty bins
    low = np.fmin.reduceat(values, starts)
    high = np.fmax.reduceat(values, starts)
    ends = np.append(starts[1:], len(times)) - 1
    falling = values[ends] < values[starts]
    reduced_values = np.empty(2 * len(starts) + 1)
    reduced_values[0:-1:2] = np.where(falling, high, low)
    reduced_values[1:-1:2] = np.where(falling, low, high)
    reduced_times = np.empty_like(reduced_values)
    reduced_times[0:-1:2] = times[starts]
    reduced_times[1:-1:2] = (times[starts] + times[ends]) / 2
    reduced_times[-1] = times[-1]
    reduced_values[-1] = values[-1]
    return reduced_times, reduced_values
