"""A line to a device as the models see it: requests in, reports out, a thread a session."""

import itertools
from collections.abc import Callable

from PySide6.QtCore import QCoreApplication, QEvent, QObject, Qt, Signal, Slot

from trex_gui.core.errors import StudioError
from trex_gui.core.session.messages import Close, Closed, Outcome
from trex_gui.core.transport.traffic_log import TrafficLog
from trex_gui.ui.workers import orphaned_threads
from trex_gui.ui.workers.line_worker import LineWorker, MakeSession

NOBODY = 0
"""The number of a request of which nobody waits for the outcome."""

_PATIENCE_MS = 1000
_PATIENCE_WHILE_WRITING_MS = 3000
"""How long the end waits: line settings and polynomial are not parted, whatever they take."""


class SessionThread(QObject):
    """One session after another, never two at a time.

    Attributes:
        tape: what their bytes are noted on, where `traffic.logged` opens the line.

    Signals:
        started: a session begins.
        reported: a report that is neither an outcome nor the last one.
        closed: the port is given back; the `messages.Closed` of the session. A fault of the
            program leaves none: then motors that were driven at all may move. Not told of a
            session that `shut_down` has seen end.
    """

    started = Signal()
    reported = Signal(object)
    closed = Signal(object)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.log = TrafficLog()
        self._worker: LineWorker | None = None
        self._late: LineWorker | None = None  # it was shut down; its last word still counts
        self._ending: list[LineWorker] = []  # each is given up, or between last report and end
        self._last: Closed | None = None
        self._may_move = False
        self._ids = itertools.count(1)
        self._waiting: dict[int, Callable[[Outcome], None]] = {}
        self._writes: set[int] = set()

    def moves(self, request: object) -> bool:
        """Return whether a motor may turn for this request; where nobody knows, it may."""
        del request
        return True

    def writes(self, request: object) -> bool:
        """Return whether this request stores something, for whose end the program waits."""
        del request
        return False

    @property
    def is_open(self) -> bool:
        """Whether a session owns the port, or is about to."""
        return self._worker is not None

    @property
    def last(self) -> Closed | None:
        """How the last session ended; `None` while it has not said so, or before any."""
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
        """Hand requests that move nothing to one and the same session, if there is one.

        For emergencies, from any thread: the session may end, and another begin, meanwhile.
        """
        if (worker := self._worker) is not None:
            for request in requests:
                worker.submit(request)

    def ask(self, make: Callable[[int], object], then: Callable[[Outcome], None]) -> bool:
        """Hand over a request that `make` gives a number; `then` gets its outcome.

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
        """Let the session end: `closed` tells when the port is given back."""
        self.submit(Close())

    def shut_down(self) -> bool:
        """Close and wait for it, at most a second; return whether it ended in time.

        While something is written it is waited for up to three seconds, and what was asked to
        be written has its outcome before this returns, if it came in time. Of the session that
        has ended `last` tells how; nothing else is told any more. A thread that does not end in
        time is kept, and the process must end without destroying it: `closed` follows if it ends
        after all, and asking again waits for it again.
        """
        worker, self._worker = self._worker, None
        if worker is None:
            in_time = all(ending.wait(_PATIENCE_MS) for ending in self._ending)
            self._take_reports()
            return in_time
        self._waiting = {number: self._waiting[number] for number in self._writes}
        in_time = worker.close(_PATIENCE_WHILE_WRITING_MS if self._writes else _PATIENCE_MS)
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
        """Take what comes as events of this object; no event loop may run any more to bring it."""
        QCoreApplication.sendPostedEvents(self, QEvent.Type.MetaCall)

    @Slot(object)
    def _on_reported(self, report: object) -> None:
        worker = self.sender()
        if worker is None or worker not in {self._worker, self._late}:
            return  # of a session that was given up; another may have begun
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
        """Return what to make of a session whose last report never came."""
        error = StudioError(self.tr("The line was closed by a fault of the program."))
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
            self._leave(self._fault())  # and yet the line is closed
        elif worker is self._late and worker in self._ending:
            self._late = None
            self.closed.emit(self._last or self._fault())
        if worker in self._ending:
            self._ending.remove(worker)
            orphaned_threads.release(worker)
            worker.deleteLater()
