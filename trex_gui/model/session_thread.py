"""A line to a device as the models see it: requests in, reports out, a thread a session."""

import itertools
from collections.abc import Callable

from PySide6.QtCore import QCoreApplication, QEvent, QObject, Signal, Slot

from trex_gui.link.messages import Close, Closed, Outcome
from trex_gui.link.transcript import Tape
from trex_gui.protocol.errors import TrexError
from trex_gui.worker.line_worker import LineWorker, MakeSession

_ENDING: list[LineWorker] = []
"""Threads between their last report and their end; Qt aborts when one is destroyed running."""

NOBODY = 0
"""The number of a request of which nobody waits for the outcome."""

_PATIENCE_MS = 1000
_PATIENCE_WHILE_WRITING_MS = 3000
"""How long the end waits: line settings and polynomial are not parted, whatever they take."""


class SessionThread(QObject):
    """One session after another, never two at a time.

    Attributes:
        tape: what their bytes are noted on, where `transcript.taped` opens the line.

    Signals:
        started: a session begins.
        reported: a report that is neither an outcome nor the last one.
        closed: the port is given back; the `messages.Closed` of the session. A fault of the
            program leaves none: then motors that were driven at all may move.
    """

    started = Signal()
    reported = Signal(object)
    closed = Signal(object)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.tape = Tape()
        self._worker: LineWorker | None = None
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

    def start(self, make_session: MakeSession, *, may_move: bool) -> None:
        """Start a session; `may_move` says that motors may be turning from an earlier one."""
        self._may_move = may_move
        self._worker = LineWorker(make_session)
        self._worker.reported.connect(self._on_reported)
        self._worker.finished.connect(self._on_worker_finished)
        self._worker.start()
        self.started.emit()

    def submit(self, request: object) -> bool:
        """Hand a request to the session; return whether there is one."""
        if self._worker is None:
            return False
        self._may_move = self._may_move or self.moves(request)
        self._worker.submit(request)
        return True

    def ask(self, make: Callable[[int], object], then: Callable[[Outcome], None]) -> bool:
        """Hand over a request that `make` gives a number; `then` gets its outcome.

        Return whether there is a session; where there is none, `then` is not called.
        """
        if self._worker is None:
            return False
        number = next(self._ids)
        request = make(number)
        self._waiting[number] = then
        if self.writes(request):
            self._writes.add(number)
        self._may_move = self._may_move or self.moves(request)
        self._worker.submit(request)
        return True

    def close(self) -> None:
        """Let the session end: `closed` tells when the port is given back."""
        self.submit(Close())

    def shut_down(self) -> bool:
        """Close and wait for it, at most a second; return whether it ended in time.

        While something is written it is waited for up to three seconds, and what was asked to
        be written has its outcome before this returns, if it came in time. Nothing else is told
        any more. A thread that does not end in time is kept, and the process must end without
        destroying it.
        """
        worker, self._worker = self._worker, None
        if worker is None:
            return all(ending.wait(_PATIENCE_MS) for ending in _ENDING)
        worker.finished.disconnect(self._on_worker_finished)
        self._waiting = {number: self._waiting[number] for number in self._writes}
        in_time = worker.close(_PATIENCE_WHILE_WRITING_MS if self._writes else _PATIENCE_MS)
        # Reports come as events of this object; no event loop may run any more to bring them.
        QCoreApplication.sendPostedEvents(self, QEvent.Type.MetaCall)
        worker.reported.disconnect(self._on_reported)
        self._forget_requests()
        if not in_time:
            _ENDING.append(worker)
        return in_time

    @Slot(object)
    def _on_reported(self, report: object) -> None:
        match report:
            case Outcome(id=number):
                self._writes.discard(number)
                if then := self._waiting.pop(number, None):
                    then(report)
            case _ if self._worker is None:
                pass  # it was on its way when the line was shut down
            case Closed():
                self._leave(report)
            case _:
                self.reported.emit(report)

    def _forget_requests(self) -> None:
        self._waiting.clear()
        self._writes.clear()

    def _leave(self, last: Closed) -> None:
        if self._worker is not None:
            _ENDING.append(self._worker)
            self._worker = None
        self._forget_requests()
        self.closed.emit(last)

    @Slot()
    def _on_worker_finished(self) -> None:
        worker = self.sender()
        if worker is self._worker:
            # Its last report never came: a fault of the program, and yet the line is closed.
            error = TrexError(self.tr("The line was closed by a fault of the program."))
            self._leave(Closed(error, self._may_move))
        if isinstance(worker, LineWorker) and worker in _ENDING:
            _ENDING.remove(worker)
            worker.deleteLater()
