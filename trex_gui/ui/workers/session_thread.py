"""Line sessions of a device: requests in, reports out, one thread per session."""

import itertools
from collections.abc import Callable

from PySide6.QtCore import QCoreApplication, QEvent, QObject, Qt, Signal, Slot

from trex_gui.core.errors import StudioError
from trex_gui.core.session.messages import Close, Closed, Outcome
from trex_gui.core.transport.traffic_log import TrafficLog
from trex_gui.ui.workers import orphaned_threads
from trex_gui.ui.workers.line_worker import LineWorker, MakeSession

NOBODY = 0
"""Number of a request without a handler for its outcome."""

_TIMEOUT_MS = 1000
_WRITING_TIMEOUT_MS = 3000
"""How long the end waits: line settings and polynomial must be stored together."""


class SessionThread(QObject):
    """One session after another, never two at a time.

    Attributes:
        log: traffic log, if `traffic_log.logged` opens the line.

    Signals:
        started: a session starts.
        reported: a report that is neither an outcome nor the last one.
        closed: the port is closed; the `Closed` of the session. After an internal error it says
            that motors may move if any was driven. Not emitted for a session that ends within
            `shut_down`.
    """

    started = Signal()
    reported = Signal(object)
    closed = Signal(object)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.log = TrafficLog()
        self._worker: LineWorker | None = None
        self._late: LineWorker | None = None  # shut down; its last report still counts
        self._ending: list[LineWorker] = []  # orphaned, or between last report and end
        self._last: Closed | None = None
        self._may_move = False
        self._ids = itertools.count(1)
        self._waiting: dict[int, Callable[[Outcome], None]] = {}
        self._writes: set[int] = set()

    def moves(self, request: object) -> bool:
        """Return whether a motor may turn because of this request; if unknown, it may."""
        del request
        return True

    def writes(self, request: object) -> bool:
        """Return whether this request stores something; the end of the program waits for it."""
        del request
        return False

    @property
    def is_open(self) -> bool:
        """Whether a session owns the port, or is about to."""
        return self._worker is not None

    @property
    def last(self) -> Closed | None:
        """How the last session ended; `None` before its last report, or before any session."""
        return self._last

    def start(self, make_session: MakeSession, *, may_move: bool) -> None:
        """Start a session; `may_move` says that motors may be turning from an earlier one."""
        self._may_move = may_move
        self._late = self._last = None
        self._worker = LineWorker(make_session)
        self._worker.reported.connect(self._on_reported, Qt.ConnectionType.QueuedConnection)
        self._worker.finished.connect(self._on_worker_finished, Qt.ConnectionType.QueuedConnection)
        self._worker.start()
        self.started.emit()

    def submit(self, request: object) -> bool:
        """Hand a request to the session; return whether there is one."""
        if (worker := self._worker) is None:
            return False
        self._may_move = self._may_move or self.moves(request)
        worker.submit(request)
        return True

    def submit_now(self, *requests: object) -> None:
        """Submit requests that move nothing to the same session, if there is one.

        For emergencies, from any thread: the session may end, and another start, meanwhile.
        """
        if (worker := self._worker) is not None:
            for request in requests:
                worker.submit(request)

    def ask(self, make: Callable[[int], object], then: Callable[[Outcome], None]) -> bool:
        """Submit the request that `make` returns for a number; `then` gets its outcome.

        Return whether there is a session; where there is none, `then` is not called.
        """
        if (worker := self._worker) is None:
            return False
        number = next(self._ids)
        request = make(number)
        self._waiting[number] = then
        if self.writes(request):
            self._writes.add(number)
        self._may_move = self._may_move or self.moves(request)
        worker.submit(request)
        return True

    def close(self) -> None:
        """Let the session end; `closed` follows."""
        self.submit(Close())

    def shut_down(self) -> bool:
        """Close and wait for it, at most a second; return whether it ended in time.

        While something is written it waits for up to three seconds, and the outcome of a write is
        delivered before this returns, if it comes in time. `last` says how the session ended;
        nothing else is reported. A thread that does not end in time is kept, and the process must
        end without destroying it: `closed` follows if it ends after all, and calling this again
        waits again.
        """
        worker, self._worker = self._worker, None
        if worker is None:
            in_time = all(ending.wait(_TIMEOUT_MS) for ending in self._ending)
            self._take_reports()
            return in_time
        self._waiting = {number: self._waiting[number] for number in self._writes}
        in_time = worker.close(_WRITING_TIMEOUT_MS if self._writes else _TIMEOUT_MS)
        self._late = worker
        if in_time:
            worker.finished.disconnect(self._on_worker_finished)
        else:
            self._keep(worker)
        self._take_reports()
        self._forget_requests()
        if in_time:
            worker.reported.disconnect(self._on_reported)
            self._late = None
            self._last = self._last or self._fault()
        return in_time

    def _keep(self, worker: LineWorker) -> None:
        self._ending.append(worker)
        orphaned_threads.adopt(worker)

    def _take_reports(self) -> None:
        """Deliver queued reports; no event loop may be running any more."""
        QCoreApplication.sendPostedEvents(self, QEvent.Type.MetaCall)

    @Slot(object)
    def _on_reported(self, report: object) -> None:
        worker = self.sender()
        if worker is None or worker not in {self._worker, self._late}:
            return  # of an orphaned session; another may have started
        match report:
            case Outcome(id=number):
                self._writes.discard(number)
                if then := self._waiting.pop(number, None):
                    then(report)
            case Closed() if self._worker is None:
                self._last = report
            case _ if self._worker is None:
                pass  # it was on its way when the line was shut down
            case Closed():
                self._leave(report)
            case _:
                self.reported.emit(report)

    def _forget_requests(self) -> None:
        self._waiting.clear()
        self._writes.clear()

    def _fault(self) -> Closed:
        """Return the result of a session without a last report."""
        error = StudioError(self.tr("Internal error: the connection was closed."))
        return Closed(error, self._may_move)

    def _leave(self, last: Closed) -> None:
        if self._worker is not None:
            self._keep(self._worker)
            self._worker = None
        self._last = last
        self._forget_requests()
        self.closed.emit(last)

    @Slot()
    def _on_worker_finished(self) -> None:
        worker = self.sender()
        if not isinstance(worker, LineWorker):
            return
        if worker is self._worker:
            self._leave(self._fault())  # the line is closed all the same
        elif worker is self._late and worker in self._ending:
            self._late = None
            self.closed.emit(self._last or self._fault())
        if worker in self._ending:
            self._ending.remove(worker)
            orphaned_threads.release(worker)
            worker.deleteLater()
