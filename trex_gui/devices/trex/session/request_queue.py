"""Queues of requests to a session, one for each board. Motor requests have priority."""

from collections import Counter, deque
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from trex_gui.core.session import Close, Inbox, Outcome
from trex_gui.devices.trex.driving.motor_output import MotorOutput
from trex_gui.devices.trex.driving.requests import Arm, Heartbeat, Stop
from trex_gui.devices.trex.protocol.errors import ErrorCode, TrexNoReplyError, TrexRequestError
from trex_gui.devices.trex.session.messages import (
    BoardRequest,
    Job,
    LeaseRequest,
    Request,
    SendPacket,
    SetReconnectCandidates,
    SetWatched,
    ToBoard,
)
from trex_gui.devices.trex.session.reconnecting import LivenessMonitor


@dataclass(slots=True, eq=False)
class BoardQueue:
    """Requests to one board."""

    output: MotorOutput
    _liveness: LivenessMonitor
    report: Callable[[Outcome], None]
    _clock: Callable[[], float]
    jobs: deque[Job] = field(default_factory=deque)
    selection: int = 0  # id of the last `SelectBoard`

    def add(self, request: BoardRequest, *, is_closing: bool) -> None:
        """Queue a request. While the session `is_closing`, drop setpoints and arming.

        A stop drops all setpoints until the next `Arm`, because the sender of a setpoint may not
        know about the stop.
        """
        match request:
            case Stop():
                self.output.handle_request(request, self._clock())
                self._reject_motor_commands()
            case SetReconnectCandidates(settings=settings):
                self._liveness.set_candidates(settings)
            case Arm(selection=selection) if selection != self.selection:
                pass  # for another board
            case _ if isinstance(request, Job):
                self.jobs.append(request)
            case _ if isinstance(request, Heartbeat) or not is_closing:
                self.output.handle_request(request, self._clock())

    def _reject_motor_commands(self) -> None:
        for job in list(self.jobs):
            if isinstance(job, SendPacket) and job.packet.moves:
                self.jobs.remove(job)
                error = TrexRequestError(ErrorCode.OVERTAKEN_BY_STOP)
                self.report(Outcome(job.id, error=error))

    def abandon(self) -> list[int]:
        """Drop all requests. Return the ids of requests without an outcome."""
        ids = [request.id for request in (*self.output.pop_stops(), *self.jobs)]
        self.output.setpoints.clear()
        self.jobs.clear()
        return ids


@dataclass(slots=True, eq=False)
class TrexRequestQueue:
    """Requests to all boards of a line. See `ToBoard` for their addresses."""

    _inbox: Inbox[Request]
    _boards: Mapping[int | None, BoardQueue]  # by device number, in group order
    is_ready: bool = True  # True if every board has been read
    is_closing: bool = False  # True if a `Close` was received
    is_watched: bool = True  # True if samples are shown or recorded
    _awaited: Counter[int] = field(default_factory=Counter)  # id of a stop → outcomes to await
    _failed: dict[int, Outcome] = field(default_factory=dict)  # id of a stop → first error

    def collect(self, seconds: float = 0.0) -> None:
        """Queue the received requests. Wait up to `seconds` for the first one."""
        boards = list(self._boards.values())
        request = self._inbox.get(max(seconds, 0.0))
        while request is not None:
            match request:
                case Close():
                    self.is_closing = True
                    for board in boards:
                        board.output.setpoints.clear()
                case SetWatched(watched=watched):
                    self.is_watched = watched
                case _ if isinstance(request, LeaseRequest):
                    pass  # a line of this computer has no other clients
                case ToBoard(number=number, request=board_request):
                    self._dispatch(number, board_request)
                case Arm() if not self.is_ready:
                    pass  # at least one board has not been read yet
                case Stop() | Arm() | Heartbeat():
                    if isinstance(request, Stop):
                        self._awaited[request.id] += len(boards)
                    for board in boards:
                        board.add(request, is_closing=self.is_closing)
                case _:
                    boards[0].add(request, is_closing=self.is_closing)
            request = self._inbox.get(0.0)

    def _dispatch(self, number: int, request: BoardRequest) -> None:
        if number in self._boards:
            self._boards[number].add(request, is_closing=self.is_closing)
        elif isinstance(request, Job):
            first, *_ = self._boards.values()
            error = TrexRequestError(ErrorCode.NO_SUCH_BOARD, number)
            first.report(Outcome(request.id, error=error))

    def is_for_all(self, outcome: Outcome) -> bool:
        return self._awaited[outcome.id] > 0

    def add_outcome(self, outcome: Outcome, number: int) -> Outcome | None:
        """Record one board's outcome of a stop.

        Returns the common outcome, or `None` until every board has an outcome.
        """
        stop_id = outcome.id
        if outcome.error is not None:
            error = TrexNoReplyError(ErrorCode.OF_BOARD, number, outcome.error)
            self._failed.setdefault(stop_id, Outcome(stop_id, error=error))
        self._awaited[stop_id] -= 1
        if self._awaited[stop_id]:
            return None
        return self._failed.pop(stop_id, outcome)

    def sees_close(self) -> bool:
        """Queue received requests. Return True if a `Close` was received."""
        self.collect()
        return self.is_closing

    def abandon(self) -> list[int]:
        ids = [number for board in self._boards.values() for number in board.abandon()]
        return list(dict.fromkeys(ids))
