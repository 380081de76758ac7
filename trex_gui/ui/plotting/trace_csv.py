"""Curves over time as a table that spreadsheets read: a row a sample, units in the header.

The first column counts seconds from the beginning; each curve has one, headed by its name and
its unit in brackets; the last has what happened, in the row of the first sample at or after it.
A value that was not known is empty. Numbers have a point, columns are parted by commas (RFC 4180).
"""

import csv
import math
from collections.abc import Iterable, Iterator, Sequence
from typing import TextIO

Happening = tuple[float, str]
"""When something happened, on the clock of the rows, and what."""


def write_trace_csv(
    file: TextIO,
    columns: Sequence[tuple[str, str]],
    rows: Iterable[Sequence[float]],
    events: Sequence[Happening] = (),
    origin: float = 0.0,
) -> int:
    """Write a table and return how many rows of samples it has.

    Args:
        file: open for writing, with `newline=""`.
        columns: name and unit of each curve.
        rows: the time and a value for each curve; times rise.
        events: what happened, in the order of time.
        origin: the time from which the first column counts.

    Raises:
        OSError: the file could not be written.
    """
    writer = csv.writer(file)
    heads = [f"{name} ({unit})" if unit else name for name, unit in columns]
    writer.writerow(["time (s)", *heads, "event"])
    waiting = list(reversed(events))
    count = 0
    for time, *values in rows:
        happened = "; ".join(_until(waiting, time))
        writer.writerow([_seconds(time - origin), *map(_number, values), happened])
        count += 1
    for time, text in reversed(waiting):
        writer.writerow([_seconds(time - origin), *([""] * len(columns)), text])
    return count


def _until(waiting: list[Happening], time: float) -> Iterator[str]:
    while waiting and waiting[-1][0] <= time:
        yield waiting.pop()[1]


def _seconds(time: float) -> str:
    return f"{time:.4f}"


def _number(value: float) -> str:
    return f"{value:.10g}" if math.isfinite(value) else ""
