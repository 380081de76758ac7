"""Threads for the line sessions of a device."""

import itertools
from collections.abc import Callable
from typing import Protocol

from PySide6.QtCore import QCoreApplication, QEvent, QObject, Qt, Signal, Slot

from trex_gui.core.errors import InternalError
from trex_gui.core.session import Close, Closed, Outcome, RequestQueue
from trex_gui.core.translation import tr
from trex_gui.core.transport.traffic import TrafficLog
from trex_gui.ui.runtime import runtime
from trex_gui.ui.workers.threads import WorkerThread, adopt_orphan, release_orphan

NO_HANDLER = 0  # id of a request without a handler for its outcome
# Timeouts of `shut_down`, without and with a pending write.
_TIMEOUT_MS, _WRITING_TIMEOUT_MS = 1000, 3000


class Session(Protocol):
    def run(self) -> None:
        """Serve the line until it is lost or closed by `Close`. Never raise."""
        ...


# Creates a session from its request queue and a function that receives its reports.
SessionFactory = Callable[[RequestQueue, Callable[[object], None]], Session]


class LineWorker(WorkerThread):
    """Thread of one line session. `submit` and `close` are thread-safe.

    The owner must retain the worker until the thread ends.
    """

    reported = Signal(object)  # a report, emitted in the new thread; the last report is `Closed`

    def __init__(self, create_session: SessionFactory) -> None:
        super().__init__()
        self.setObjectName("LineWorker")
        self._requests = RequestQueue(runtime().condition())
        self._session = create_session(self._requests, self.reported.emit)

    def run(self) -> None:
        self._session.run()

    def submit(self, request: object) -> None:
        self._requests.put(request)

    def close(self, timeout_ms: int = _TIMEOUT_MS) -> bool:
        self.submit(Close())
        return self.wait(timeout_ms)


class SessionThread(QObject):
    started = Signal()
    reported = Signal(object)  # a report other than `Outcome` and `Closed`
    closed = Signal(object)  # `Closed`, once the port is closed; not for an end in `shut_down`

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.log = TrafficLog()  # contains traffic if `traffic.logged` opens the line
        self._worker: LineWorker | None = None
        self._late: LineWorker | None = None  # worker from `shut_down` until its last report
        self._ending: list[LineWorker] = []  # orphans, and workers that have sent `Closed`
        self.last: Closed | None = None
        self._may_move = False
        self._ids = itertools.count(1)
        self._handlers: dict[int, Callable[[Outcome], None]] = {}  # request id → handler
        self._writes: set[int] = set()  # request ids of pending writes

    def moves(self, request: object) -> bool:
        """Return whether a request may start a motor."""
        del request
        return True

    def writes(self, request: object) -> bool:
        """Return whether a request writes to the device. `shut_down` waits for writes."""
        del request
        return False

    @property
    def is_open(self) -> bool:
        return self._worker is not None

    def start(self, create_session: SessionFactory, *, may_move: bool) -> None:
        """Start a session. `may_move`: motors may still be turning after an earlier session."""
        self._may_move = may_move
        self._late = self.last = None
        self._worker = LineWorker(create_session)
        self._worker.reported.connect(self._on_reported, Qt.ConnectionType.QueuedConnection)
        self._worker.finished.connect(self._on_worker_finished, Qt.ConnectionType.QueuedConnection)
        self._worker.start()
        self.started.emit()

    def submit(self, request: object) -> bool:
        """Queue a request. Return whether a session is open."""
        if (worker := self._worker) is None:
            return False
        self._may_move = self._may_move or self.moves(request)
        worker.submit(request)
        return True

    def submit_now(self, *requests: object) -> None:
        """Queue requests that start no motor. Thread-safe, for emergencies.

        All requests go to the same session, even if another session starts.
        """
        if (worker := self._worker) is not None:
            for request in requests:
                worker.submit(request)

    def request(self, create: Callable[[int], object], then: Callable[[Outcome], None]) -> bool:
        """Queue a request. Pass its outcome to `then`.

        `create` returns the request for an id. Return whether a session is open. Without an open
        session, `then` is not called.
        """
        if not self.is_open:
            return False
        number = next(self._ids)
        request = create(number)
        self._handlers[number] = then
        if self.writes(request):
            self._writes.add(number)
        return self.submit(request)

    def close(self) -> None:
        """Close the session without waiting. `closed` is emitted later."""
        self.submit(Close())

    def shut_down(self) -> bool:
        """Close the session within a second. Return whether it ended in time.

        With pending writes, wait up to three seconds and deliver their outcomes. Other reports
        are dropped, but `last` is set. A thread that does not end in time is orphaned, and
        `closed` is emitted when the thread ends. A repeated call waits again.
        """
        worker, self._worker = self._worker, None
        if worker is None:
            in_time = all(ending.wait(_TIMEOUT_MS) for ending in self._ending)
            self._handle_reports()
            return in_time
        self._handlers = {number: self._handlers[number] for number in self._writes}
        in_time = worker.close(_WRITING_TIMEOUT_MS if self._writes else _TIMEOUT_MS)
        self._late = worker
        if in_time:
            worker.finished.disconnect(self._on_worker_finished)
        else:
            self._retain(worker)
        self._handle_reports()
        self._clear_requests()
        if in_time:
            worker.reported.disconnect(self._on_reported)
            self._late = None
            self.last = self.last or self._fault()
        return in_time

    def _retain(self, worker: LineWorker) -> None:
        self._ending.append(worker)
        adopt_orphan(worker)

    def _handle_reports(self) -> None:
        QCoreApplication.sendPostedEvents(self, QEvent.Type.MetaCall)

    @Slot(object)
    def _on_reported(self, report: object) -> None:
        worker = self.sender()
        if worker is None or worker not in {self._worker, self._late}:
            return  # from an orphaned session
        match report:
            case Outcome():
                self.deliver(report)
            case Closed() if self._worker is None:
                self.last = report
            case _ if self._worker is None:
                pass  # reported before `shut_down`
            case Closed():
                self._end(report)
            case _:
                self.reported.emit(report)

    def deliver(self, outcome: Outcome) -> None:
        self._writes.discard(outcome.id)
        if then := self._handlers.pop(outcome.id, None):
            then(outcome)

    def _clear_requests(self) -> None:
        self._handlers.clear()
        self._writes.clear()

    def _fault(self) -> Closed:
        """Return the report of an internal error. Motors may move if any motor was driven."""
        error = InternalError(tr("Internal error: the connection was closed."))
        return Closed(error, self._may_move)

    def _end(self, last: Closed) -> None:
        if self._worker is not None:
            self._retain(self._worker)
            self._worker = None
        self.last = last
        self._clear_requests()
        self.closed.emit(last)

    @Slot()
    def _on_worker_finished(self) -> None:
        worker = self.sender()
        if not isinstance(worker, LineWorker):
            return
        if worker is self._worker:
            self._end(self._fault())
        elif worker is self._late and worker in self._ending:
            self._late = None
            self.closed.emit(self.last or self._fault())
        if worker in self._ending:
            self._ending.remove(worker)
            release_orphan(worker)
            worker.deleteLater()
