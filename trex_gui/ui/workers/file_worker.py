"""Long file operations in a separate thread."""

import logging
import threading
from collections.abc import Callable
from dataclasses import dataclass

from PySide6.QtCore import QObject, Qt, Signal, Slot

from trex_gui.core.errors import StudioError
from trex_gui.core.translation import tr
from trex_gui.ui.runtime import now, runtime
from trex_gui.ui.workers.threads import WorkerThread, adopt_orphan

log = logging.getLogger(__name__)

_PROGRESS_INTERVAL = 0.05  # seconds

# Seconds of work between pauses, and seconds of a pause, in which the session threads and the
# GUI thread can run. Python switches threads only every 5 ms, which would delay the many short
# tasks of these threads.
_WORK, _PAUSE = 0.01, 0.001

ProgressCallback = Callable[[float], None]  # receives the completed fraction, 0 to 1


class _CancelledError(Exception): ...


@dataclass(frozen=True, slots=True)
class Done:
    """Outcome of a worker's function. Cancelled work has neither a result nor an error."""

    result: object = None
    error: StudioError | None = None


class FileWorker(WorkerThread):
    """Thread that runs one function. The owner must retain the worker until the thread ends."""

    progressed = Signal(float)  # completed fraction, 0 to 1

    def __init__(
        self, work: Callable[[ProgressCallback], object], parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self.setObjectName("FileWorker")
        self.outcome = Done()  # valid once the thread has ended
        self._work = work
        self._cancelled = threading.Event()
        self._last_progress = self._last_pause = 0.0

    def run(self) -> None:
        self._last_pause = now()
        try:
            result = self._work(self._report)
        except _CancelledError:
            return
        except StudioError as error:
            self.outcome = Done(error=error)
        except Exception as error:
            log.exception("Internal error while processing a file")
            text = tr("Internal error while processing this file ({0}).")
            self.outcome = Done(error=StudioError(text.format(type(error).__name__)))
        else:
            if not self._cancelled.is_set():
                self.outcome = Done(result)

    @property
    def is_cancelled(self) -> bool:
        return self._cancelled.is_set()

    def cancel(self) -> None:
        """End the work at its next progress report."""
        self._cancelled.set()

    def _report(self, progress: float) -> None:
        if self._cancelled.is_set():
            raise _CancelledError
        moment = now()
        if moment >= self._last_progress + _PROGRESS_INTERVAL:
            self._last_progress = moment
            self.progressed.emit(progress)
        if moment >= self._last_pause + _WORK:
            runtime().sleep(_PAUSE)
            self._last_pause = now()


class FileTask(QObject):
    progressed = Signal(float)  # completed fraction, 0 to 1
    done = Signal(object)  # `Done`; not emitted after `close`

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._worker: FileWorker | None = None
        self._abandoned: FileWorker | None = None  # worker that outlasted `close`

    @property
    def is_running(self) -> bool:
        return self._worker is not None

    def start(self, work: Callable[[ProgressCallback], object]) -> None:
        worker = FileWorker(work, self)
        worker.progressed.connect(self.progressed, Qt.ConnectionType.QueuedConnection)
        worker.finished.connect(self._on_finished, Qt.ConnectionType.QueuedConnection)
        self._worker = worker
        worker.start(FileWorker.Priority.LowPriority)

    def cancel(self) -> None:
        if self._worker is not None:
            self._worker.cancel()

    def close(self, timeout_ms: int, *, finish_ms: int = 0) -> bool:
        """Cancel the work after `finish_ms`. Wait up to `timeout_ms` for its end.

        Return whether the thread has ended.
        """
        worker, self._worker = self._worker, None
        if worker is not None and not worker.wait(finish_ms):
            worker.cancel()
            if not worker.wait(timeout_ms):
                adopt_orphan(worker)
                self._abandoned = worker
                return False
        if worker is not None:
            worker.setParent(None)  # Python deletes the worker
        return self._abandoned is None or self._abandoned.wait(0)

    @Slot()
    def _on_finished(self) -> None:
        worker = self._worker
        if worker is not None and self.sender() is worker:
            self._worker = None
            worker.wait()
            worker.setParent(None)  # Python deletes the worker
            self.done.emit(worker.outcome)
