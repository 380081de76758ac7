"""One file at a time, written by a thread of its own: the life of that thread."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QObject, Qt, Signal, Slot

from trex_gui.core.recording.errors import RecordingError
from trex_gui.ui.workers import orphaned_threads
from trex_gui.ui.workers.file_worker import Done, FileWorker, ProgressCallback

_PATIENCE_MS = 1000
"""How long a disk that hangs is waited for when nobody wants the file any more."""


class FileSaver(QObject):
    """Writes one file at a time; one that cannot be written whole is not written at all.

    One for each kind of file derives from it: it begins with `begin` once it is not `is_saving`.

    Signals:
        saved: how many rows, and the `Path`.
        failed: why nothing was written, for people.
    """

    saved = Signal(int, object)
    failed = Signal(str)

    def __init__(self, parent: QObject | None = None, *, finishing_ms: int = 0) -> None:
        """Save nothing yet.

        At the end of the program a file has `finishing_ms` to become whole before it is given up.
        """
        super().__init__(parent)
        self._finishing_ms = finishing_ms
        self._worker: FileWorker | None = None
        self._path = Path()
        app = QCoreApplication.instance()
        if app is not None:
            app.aboutToQuit.connect(self.finish)

    @property
    def is_saving(self) -> bool:
        """Whether a file is being written."""
        return self._worker is not None

    def begin(self, path: Path, work: Callable[[ProgressCallback], int]) -> None:
        """Let `work` write the file in a thread; it returns how many rows it has written."""
        self._path = path
        self._worker = FileWorker(work, self)
        self._worker.done.connect(self._on_done, Qt.ConnectionType.QueuedConnection)
        self._worker.finished.connect(self._on_finished, Qt.ConnectionType.QueuedConnection)
        self._worker.start()

    @Slot()
    def finish(self) -> None:
        """Wait for what is being written; for the end. A disk that hangs is not waited for."""
        worker, self._worker = self._worker, None
        if worker is None:
            return
        if worker.wait(self._finishing_ms) or worker.close(_PATIENCE_MS):
            worker.deleteLater()
        else:
            orphaned_threads.adopt(worker)

    @Slot(object)
    def _on_done(self, done: Done) -> None:
        if self._let_go(self.sender()):
            if isinstance(done.error, RecordingError):
                self.failed.emit(str(done.error))
            elif done.error is not None:
                text = self.tr("{0} was not written. {1}")
                self.failed.emit(text.format(self._path.name, done.error))
            elif isinstance(done.result, int):
                self.saved.emit(done.result, self._path)

    @Slot()
    def _on_finished(self) -> None:
        """Where it told nothing before: a fault that nobody could catch."""
        if self._let_go(self.sender()):
            self.failed.emit(self.tr("{0} was not written.").format(self._path.name))

    def _let_go(self, sender: QObject) -> bool:
        """Forget the thread, which is at its end, if it is the one that is waited for."""
        worker = self._worker
        if worker is None or sender is not worker:
            return False
        self._worker = None
        worker.wait()
        worker.deleteLater()
        return True
