"""Rows of a transcript to a file, by a thread of its own."""

import io
from collections.abc import Iterator, Sequence
from datetime import UTC, datetime
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject

from trex_gui import __version__
from trex_gui.core.files.atomic import atomic_file
from trex_gui.core.recording.errors import RecordingError
from trex_gui.core.transport.transactions import Transaction
from trex_gui.ui.traffic.model import TrafficModel
from trex_gui.ui.traffic.traffic_text import TrafficRow, write_traffic
from trex_gui.ui.workers.file_worker import FileSaver, ProgressCallback

_AT_ONCE = 100
"""Rows after which the window gets its turn."""

_PATIENCE_MS = 3000
"""How long the end of the program waits for a file to become whole."""


class TrafficSaver(FileSaver):
    """Writes rows of one transcript."""

    def __init__(self, traffic: TrafficModel, parent: QObject | None = None) -> None:
        super().__init__(parent, finishing_ms=_PATIENCE_MS)
        self._traffic = traffic

    def save(self, path: Path, rows: Sequence[Transaction]) -> None:
        """Write rows; `saved` or `failed` says how it went."""
        if self.is_saving:
            self.failed.emit(self.tr("Another transcript is still being written."))
        else:
            self.begin(path, partial(_write, path, self._traffic, tuple(rows)))


def _write(
    path: Path, traffic: TrafficModel, rows: Sequence[Transaction], tell: ProgressCallback
) -> int:
    about = [
        f"TReX Studio {__version__}: what went over the line",
        f"written {datetime.now(UTC).astimezone().isoformat(sep=' ', timespec='seconds')}",
    ]
    try:
        with (
            atomic_file(path) as data,
            # Names of ports may hold what is no text on any system.
            io.TextIOWrapper(data, "utf-8", errors="backslashreplace", newline="") as file,
        ):
            return write_traffic(file, about, _rows(traffic, rows, tell))
    except OSError as error:
        reason = error.strerror or str(error)
        raise RecordingError(path.name, f"It was not written: {reason.rstrip('.')}.") from error


def _rows(
    traffic: TrafficModel, rows: Sequence[Transaction], tell: ProgressCallback
) -> Iterator[TrafficRow]:
    for done, row in enumerate(rows):
        if done % _AT_ONCE == 0:
            tell(done / len(rows))
        yield row_of(traffic, row)


def row_of(traffic: TrafficModel, row: Transaction) -> TrafficRow:
    """Return a row as it is written and copied."""
    words = traffic.decoded(row)
    return TrafficRow(
        traffic.wall_time(row),
        traffic.shown(row.sent),
        traffic.shown(row.received),
        row.seconds,
        words.text,
        words.is_fault,
    )
