"""A thread for one long piece of work on a file, so that the window lives on meanwhile."""

import logging
import threading
from collections.abc import Callable
from dataclasses import dataclass

from PySide6.QtCore import QObject, Signal

from trex_gui.core.errors import StudioError
from trex_gui.ui.runtime import now, runtime
from trex_gui.ui.workers.thread import WorkerThread

log = logging.getLogger(__name__)

_TELL = 0.05
"""Seconds between two reports of how far it is."""

_WORK, _REST = 0.01, 0.001
"""Seconds of work after which line and window get their turn, and how long that is.

Python changes threads by itself only every 5 ms, and both of them ask often and for little.
"""

ProgressCallback = Callable[[float], None]


class _CancelledError(Exception):
    """Nobody wants the result any more."""


@dataclass(frozen=True, slots=True)
class Done:
    """How the work ended: with its result, or with an error."""

    result: object = None
    error: StudioError | None = None


class FileWorker(WorkerThread):
    """Runs one function, which is given a function to tell how far it is with.

    The object lives in the GUI thread; only `run` executes in the new one. What the work is
    given belongs to that thread until it is done. Its owner keeps it until it is finished.

    Signals:
        progressed: the share that is done, 0 to 1.
        done: a `Done`, once, unless it was cancelled. A fault of the work is an error, too.
    """

    progressed = Signal(float)
    done = Signal(object)

    def __init__(
        self, work: Callable[[ProgressCallback], object], parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self.setObjectName("FileWorker")
        self._work = work
        self._cancelled = threading.Event()
        self._last_flush = self._rested_at = 0.0

    def run(self) -> None:
        """Do the work; called by Qt in the new thread."""
        self._rested_at = now()
        try:
            result = self._work(self._tell)
        except _CancelledError:
            return
        except StudioError as error:
            self.done.emit(Done(error=error))
        except Exception as error:
            log.exception("work on a file")
            text = self.tr("A fault of the program has ended the work on this file ({0}).")
            self.done.emit(Done(error=StudioError(text.format(type(error).__name__))))
        else:
            if not self._cancelled.is_set():
                self.done.emit(Done(result))

    def cancel(self) -> None:
        """Let it end where it tells how far it is the next time."""
        self._cancelled.set()

    def close(self, timeout_ms: int = 1000) -> bool:
        """Cancel and wait; return whether the thread ended in time."""
        self.cancel()
        return self.wait(timeout_ms)

    def _tell(self, share: float) -> None:
        if self._cancelled.is_set():
            raise _CancelledError
        moment = now()
        if moment >= self._last_flush + _TELL:
            self._last_flush = moment
            self.progressed.emit(share)
        if moment >= self._rested_at + _WORK:
            runtime().sleep(_REST)
            self._rested_at = now()
