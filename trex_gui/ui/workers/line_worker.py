"""One thread a line."""

from collections.abc import Callable
from typing import Protocol

from PySide6.QtCore import QObject, Signal

from trex_gui.core.session.messages import Close
from trex_gui.core.session.request_queue import RequestQueue
from trex_gui.ui.runtime import runtime
from trex_gui.ui.workers.thread import WorkerThread


class Runs(Protocol):
    """A session of a line, of whatever device."""

    def run(self) -> None:
        """Serve the line until it is lost or `Close` comes; never raise."""
        ...


MakeSession = Callable[[RequestQueue, Callable[[object], None]], Runs]
"""Makes a session from where its requests come and where its reports go."""


class LineWorker(WorkerThread):
    """Runs one line session.

    The object lives in the GUI thread; only `run` executes in the new one. `submit` and
    `close` may be called from any thread. Its owner keeps it until it is finished.

    Signals:
        reported: a report of the session, in the thread of the receiver. The last one is `Closed`.
    """

    reported = Signal(object)

    def __init__(self, make_session: MakeSession, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("LineWorker")
        self._inbox = RequestQueue(runtime().condition())
        self._session = make_session(self._inbox, self._report)

    def run(self) -> None:
        """Serve the line; called by Qt in the new thread."""
        self._session.run()

    def submit(self, request: object) -> None:
        """Hand a request to the session."""
        self._inbox.put(request)

    def close(self, timeout_ms: int = 1000) -> bool:
        """Let the session end, and wait for it; return whether it did in time."""
        self.submit(Close())
        return self.wait(timeout_ms)

    def _report(self, report: object) -> None:
        self.reported.emit(report)
