"""Transactions as tab-separated text, and a thread that writes them to a file."""

import io
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from functools import partial
from pathlib import Path
from typing import TextIO

from PySide6.QtCore import QObject

from trex_gui import __version__
from trex_gui.core.files import atomic_file
from trex_gui.core.recording.kinds import RecordingError
from trex_gui.core.transport.traffic import Transaction
from trex_gui.ui.traffic.model import TrafficModel
from trex_gui.ui.workers.file_worker import FileSaver, ProgressCallback

_AT_ONCE = 100
"""Rows between two progress reports."""

_TIMEOUT_MS = 3000
"""Longest wait for the file at the end of the program."""


@dataclass(frozen=True, slots=True)
class TrafficRow:
    """One row: `time` in seconds since 1970, bytes as text, seconds until the reply if any.

    Its columns are separated by tabs, for spreadsheets.
    """

    time: float
    sent: str
    received: str
    seconds: float | None
    words: str
    is_fault: bool

    def text(self) -> str:
        """Return the row as one line without its end."""
        moment = datetime.fromtimestamp(self.time).astimezone()
        took = "" if self.seconds is None else f"{self.seconds * 1e3:.1f}"
        mark = "!" if self.is_fault else ""
        when = moment.isoformat(sep=" ", timespec="milliseconds")
        return "\t".join([when, mark, self.sent, self.received, took, self.words])


_HEAD = "\t".join(["time", "fault", "sent", "received", "took_ms", "meaning"])


def write_traffic(file: TextIO, about: Iterable[str], rows: Iterable[TrafficRow]) -> int:
    """Write comment lines, column names and rows; return the number of rows."""
    file.writelines(f"# {line}\n" for line in about)
    file.write(f"{_HEAD}\n")
    count = 0
    for row in rows:
        file.write(f"{row.text()}\n")
        count += 1
    return count


class TrafficSaver(FileSaver):
    """Writes rows of one traffic log."""

    def __init__(self, traffic: TrafficModel, parent: QObject | None = None) -> None:
        super().__init__(parent, finishing_ms=_TIMEOUT_MS)
        self._traffic = traffic

    def save(self, path: Path, rows: Sequence[Transaction]) -> None:
        """Write rows; `saved` or `failed` follows."""
        if self.is_saving:
            self.failed.emit(self.tr("Another traffic log is still being written."))
        else:
            self.begin(path, partial(_write, path, self._traffic, tuple(rows)))


def _write(
    path: Path, traffic: TrafficModel, rows: Sequence[Transaction], progress: ProgressCallback
) -> int:
    about = [
        f"TReX Studio {__version__}: traffic on the line",
        f"written {datetime.now(UTC).astimezone().isoformat(sep=' ', timespec='seconds')}",
    ]
    try:
        with (
            atomic_file(path) as data,
            # Names of ports may contain undecodable bytes.
            io.TextIOWrapper(data, "utf-8", errors="backslashreplace", newline="") as file,
        ):
            return write_traffic(file, about, _rows(traffic, rows, progress))
    except OSError as error:
        reason = error.strerror or str(error)
        raise RecordingError(path.name, f"It was not written: {reason.rstrip('.')}.") from error


def _rows(
    traffic: TrafficModel, rows: Sequence[Transaction], progress: ProgressCallback
) -> Iterator[TrafficRow]:
    for done, row in enumerate(rows):
        if done % _AT_ONCE == 0:
            progress(done / len(rows))
        yield row_of(traffic, row)


def row_of(traffic: TrafficModel, row: Transaction) -> TrafficRow:
    """Return a row as it is written to files and the clipboard."""
    words = traffic.decoded(row)
    return TrafficRow(
        traffic.wall_time(row),
        traffic.shown(row.sent),
        traffic.shown(row.received),
        row.seconds,
        words.text,
        words.is_fault,
    )
