"""One thread a line."""

import queue

from PySide6.QtCore import QObject, QThread, Signal

from trex_gui.link.messages import Close, Report, Request
from trex_gui.link.session import Session
from trex_gui.link.settings import LinkSettings


class QueueInbox:
    """An inbox that any thread may put requests into."""

    def __init__(self) -> None:
        self._queue: queue.SimpleQueue[Request] = queue.SimpleQueue()

    def put(self, request: Request) -> None:
        """Leave a request for the session."""
        self._queue.put(request)

    def get(self, seconds: float) -> Request | None:
        """Return the next request, waiting up to `seconds` for one; else `None`."""
        try:
            if seconds <= 0:
                return self._queue.get_nowait()
            return self._queue.get(timeout=seconds)
        except queue.Empty:
            return None


class LineWorker(QThread):
    """Runs one line session.

    The object lives in the GUI thread; only `run` executes in the new one. `submit` and
    `close` may be called from any thread. Its owner keeps it until it is finished.

    Signals:
        reported: a `messages.Report`, in the thread of the receiver. The last one is `Closed`.
    """

    reported = Signal(object)

    def __init__(
        self, settings: LinkSettings, parent: QObject | None = None, *, may_move: bool = False
    ) -> None:
        super().__init__(parent)
        self.setObjectName("LineWorker")
        self._inbox = QueueInbox()
        self._session = Session(settings, self._inbox, self._report, may_move=may_move)

    def run(self) -> None:
        """Serve the line; called by Qt in the new thread."""
        self._session.run()

    def submit(self, request: Request) -> None:
        """Hand a request to the session."""
        self._inbox.put(request)

    def close(self, timeout_ms: int = 1000) -> bool:
        """Stop the motors if they were driven, end the thread; return whether it did in time."""
        self.submit(Close())
        return self.wait(timeout_ms)

    def _report(self, report: Report) -> None:
        self.reported.emit(report)
