"""Curves as a table in a file, by a thread of its own: a million rows take seconds."""

import io
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np

from trex_gui.core.files.atomic import atomic_file
from trex_gui.core.recording.errors import RecordingError
from trex_gui.ui.plotting.data.pyramid import Floats
from trex_gui.ui.plotting.data.traces import Traces
from trex_gui.ui.plotting.trace_csv import Happening, write_trace_csv
from trex_gui.ui.workers.file_saver import FileSaver
from trex_gui.ui.workers.file_worker import ProgressCallback

_AT_ONCE = 2000
"""Rows after which the window gets its turn."""


class TableSaver(FileSaver):
    """Writes what a plot has, a row a sample."""

    def save(self, path: Path, source: Traces, span: tuple[float, float], origin: float) -> None:
        """Write every curve within a span; times count from `origin`.

        `saved` or `failed` says how it went.
        """
        if self.is_saving:
            self.failed.emit(self.tr("Another export is still being written."))
            return
        times, values = source.samples(*span)
        # Copies: the history goes on. A million take 0.1 to 0.3 s, as rows they would take longer.
        table = _Table(
            [(trace.name, trace.unit) for trace in source.traces],
            [column.copy() for column in (times, *values)],
            [(one.time, one.text) for one in source.events_between(*span)],
            origin,
        )
        self.begin(path, partial(_write, path, table))


@dataclass(frozen=True, slots=True)
class _Table:
    """What is written: name and unit of each curve, times and values, what happened."""

    heads: Sequence[tuple[str, str]]
    columns: Sequence[Floats]
    events: Sequence[Happening]
    origin: float

    def rows(self, tell: ProgressCallback) -> Iterator[list[float]]:
        count = len(self.columns[0])
        for first in range(0, count, _AT_ONCE):
            tell(first / count)
            rows = [column[first : first + _AT_ONCE] for column in self.columns]
            yield from np.column_stack(rows).tolist()


def _write(path: Path, table: _Table, tell: ProgressCallback) -> int:
    try:
        with (
            atomic_file(path) as data,
            io.TextIOWrapper(data, encoding="utf-8", newline="") as file,
        ):
            return write_trace_csv(file, table.heads, table.rows(tell), table.events, table.origin)
    except OSError as error:
        reason = error.strerror or str(error)
        raise RecordingError(path.name, f"It was not written: {reason.rstrip('.')}.") from error
