"""Rows of a transcript to a file, by a thread of its own."""

import io
from collections.abc import Iterator, Sequence
from datetime import UTC, datetime
from functools import partial
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QObject, Signal, Slot

from trex_gui import __version__
from trex_gui.export.transcript_text import TranscriptRow, write_transcript
from trex_gui.link.exchanges import Exchange
from trex_gui.model.transcript import Transcript
from trex_gui.recording.errors import RecordingError
from trex_gui.recording.on_disk import whole_file
from trex_gui.worker.file_worker import Done, FileWorker, Tell

_AT_ONCE = 100
"""Rows after which the window gets its turn."""

_PATIENCE_MS = 3000


_abandoned: list[FileWorker] = []
"""Threads that a disk holds up at the end: a `QThread` must outlive its run."""


class TranscriptSaver(QObject):
    """Writes one file at a time; a file that cannot be written whole is not written at all.

    Signals:
        saved: how many rows, and the `Path`.
        failed: why nothing was written, for people.
    """

    saved = Signal(int, object)
    failed = Signal(str)

    def __init__(self, transcript: Transcript, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._transcript = transcript
        self._worker: FileWorker | None = None
        self._path = Path()
        app = QCoreApplication.instance()
        if app is not None:
            app.aboutToQuit.connect(self.finish)

    @property
    def is_saving(self) -> bool:
        """Whether a file is being written."""
        return self._worker is not None

    def save(self, path: Path, rows: Sequence[Exchange]) -> None:
        """Write rows; `saved` or `failed` says how it went."""
        if self._worker is not None:
            self.failed.emit(self.tr("Another transcript is still being written."))
            return
        self._path = path
        work = partial(_write, path, self._transcript, tuple(rows))
        self._worker = FileWorker(work, self)
        self._worker.done.connect(self._on_done)
        self._worker.start()

    @Slot()
    def finish(self) -> None:
        """Wait for what is being written; for the end. A disk that hangs is not waited for."""
        worker, self._worker = self._worker, None
        if worker is not None and not worker.wait(_PATIENCE_MS) and not worker.close():
            worker.setParent(None)
            _abandoned.append(worker)

    @Slot(object)
    def _on_done(self, done: Done) -> None:
        worker, self._worker = self._worker, None
        if worker is not None:
            worker.wait()
            worker.deleteLater()
        if done.error is not None:
            self.failed.emit(str(done.error))
        elif isinstance(done.result, int):
            self.saved.emit(done.result, self._path)


def _write(path: Path, transcript: Transcript, rows: Sequence[Exchange], tell: Tell) -> int:
    about = [
        f"TReX Studio {__version__}: what went over the line",
        f"written {datetime.now(UTC).astimezone().isoformat(sep=' ', timespec='seconds')}",
    ]
    try:
        with (
            whole_file(path) as data,
            io.TextIOWrapper(data, encoding="utf-8", newline="") as file,
        ):
            return write_transcript(file, about, _rows(transcript, rows, tell))
    except OSError as error:
        reason = error.strerror or str(error)
        raise RecordingError(path.name, f"It was not written: {reason.rstrip('.')}.") from error


def _rows(transcript: Transcript, rows: Sequence[Exchange], tell: Tell) -> Iterator[TranscriptRow]:
    for done, row in enumerate(rows):
        if done % _AT_ONCE == 0:
            tell(done / len(rows))
        yield row_of(transcript, row)


def row_of(transcript: Transcript, row: Exchange) -> TranscriptRow:
    """Return a row as it is written and copied."""
    words = transcript.words_of(row)
    return TranscriptRow(
        transcript.wall_time(row),
        transcript.shown(row.sent),
        transcript.shown(row.received),
        row.seconds,
        words.text,
        words.is_fault,
    )
