"""Curves over time as CSV (RFC 4180): a row for each sample, units in the header.

The first column is seconds since the origin; each curve has one, headed by its name and its
unit in brackets; the last has the events, in the row of the first sample at or after them.
Unknown values are empty.
"""

import csv
import io
import math
from collections.abc import Iterable, Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import TextIO

import numpy as np

from trex_gui.core.files import atomic_file
from trex_gui.core.recording.kinds import RecordingError
from trex_gui.ui.plotting.data.pyramid import Floats
from trex_gui.ui.plotting.data.traces import Traces
from trex_gui.ui.workers.file_worker import FileSaver, ProgressCallback

_CHUNK = 2000
"""Rows from one report of the progress to the next."""


def write_trace_csv(
    file: TextIO,
    columns: Sequence[tuple[str, str]],
    rows: Iterable[Sequence[float]],
    events: Sequence[tuple[float, str]] = (),
    origin: float = 0.0,
) -> int:
    """Write a table and return its number of samples.

    Args:
        file: open for writing, with `newline=""`.
        columns: name and unit of each curve.
        rows: the time and a value for each curve; times rise.
        events: time and text, in the order of time.
        origin: the time from which the first column counts.

    Raises:
        OSError: the file could not be written.
    """
    writer = csv.writer(file)
    heads = [f"{name} ({unit})" if unit else name for name, unit in columns]
    writer.writerow(["time (s)", *heads, "event"])
    pending, count = list(reversed(events)), 0
    for time, *values in rows:
        texts = []
        while pending and pending[-1][0] <= time:
            texts.append(pending.pop()[1])
        numbers = (f"{value:.10g}" if math.isfinite(value) else "" for value in values)
        writer.writerow([f"{time - origin:.4f}", *numbers, "; ".join(texts)])
        count += 1
    for time, text in reversed(pending):
        writer.writerow([f"{time - origin:.4f}", *([""] * len(columns)), text])
    return count


class TableSaver(FileSaver):
    """Writes the samples of a source in a thread of its own: a million rows take seconds."""

    def save(self, path: Path, source: Traces, span: tuple[float, float], origin: float) -> None:
        """Write every curve within a span; `saved` or `failed` follows."""
        if self.is_saving:
            self.failed.emit(self.tr("Another export is still being written."))
            return
        times, values = source.samples(*span)
        heads = [(trace.name, trace.unit) for trace in source.traces]
        # Copies: the history goes on. A million take 0.1 to 0.3 s, as rows they would take longer.
        columns = [column.copy() for column in (times, *values)]
        events = [(event.time, event.text) for event in source.events_between(*span)]
        table = partial(_write, path, heads=heads, columns=columns, events=events, origin=origin)
        self.begin(path, table)


def _write(
    path: Path,
    progress: ProgressCallback,
    *,
    heads: Sequence[tuple[str, str]],
    columns: Sequence[Floats],
    events: Sequence[tuple[float, str]],
    origin: float,
) -> int:
    try:
        with (
            atomic_file(path) as data,
            io.TextIOWrapper(data, encoding="utf-8", newline="") as file,
        ):
            return write_trace_csv(file, heads, _rows(columns, progress), events, origin)
    except OSError as error:
        reason = error.strerror or str(error)
        raise RecordingError(path.name, f"It was not written: {reason.rstrip('.')}.") from error


def _rows(columns: Sequence[Floats], progress: ProgressCallback) -> Iterator[list[float]]:
    count = len(columns[0])
    for first in range(0, count, _CHUNK):
        progress(first / count)
        yield from np.column_stack([column[first : first + _CHUNK] for column in columns]).tolist()
