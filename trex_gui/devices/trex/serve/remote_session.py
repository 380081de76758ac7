"""Session of a served board. It uses the same messages as a local session."""

import logging
import math
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from itertools import count

from trex_gui.core.errors import BadRequest, NoReply, PortUnavailable
from trex_gui.core.session import Close, Closed, Closing, Inbox, Outcome, run_until_closed
from trex_gui.core.translation import tr
from trex_gui.core.transport.urls import Address
from trex_gui.devices.trex.client.client import Counters
from trex_gui.devices.trex.driving.blockers import DriveBlocker, Reason
from trex_gui.devices.trex.driving.requests import (
    Arm,
    Heartbeat,
    MotorsStopped,
    SetAuxiliary,
    SetMotor,
    SetMotors,
    SetpointRequest,
    Stop,
)
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import ErrorCode, TrexInternalError, TrexRequestError
from trex_gui.devices.trex.protocol.raw_packets import RawPacket
from trex_gui.devices.trex.serve.codec import (
    VERSION,
    Alive,
    ClientRequest,
    Hello,
    Leave,
    Refused,
    ServerReport,
    Tick,
    Welcome,
    decode_report,
    encode_request,
    inner_request,
)
from trex_gui.devices.trex.serve.network import ClientLink
from trex_gui.devices.trex.session.messages import (
    AskLease,
    Batch,
    BoardReport,
    Connected,
    LeaseChanged,
    LeaseRequest,
    NetworkDelay,
    NotResponding,
    OfBoard,
    ProbeNumber,
    ReadReason,
    Reload,
    Report,
    Request,
    SelectBoard,
    SendPacket,
    SetReconnectCandidates,
    SetWatched,
    Traffic,
    Write,
    Written,
)
from trex_gui.version import __version__

log = logging.getLogger(__name__)

_SLICE = 0.005  # seconds by which a received report may be delayed
_HEARTBEAT = 0.1  # seconds between two heartbeats

# The server sends at least six reports a second. It stops the motors if the driving client is
# silent for half a second.
_SILENT_AFTER = 0.7  # seconds without a report after which the network counts as silent
_LOST_AFTER = 5.0  # seconds without a report after which the connection ends

_REPLY_TIMEOUT = 3.0  # seconds until the server replies to a `Hello` or a lease request
_STOP_TIMEOUT = 1.0  # seconds until the last stop is confirmed
_STOP_INTERVAL = 0.25  # seconds until an unconfirmed stop is repeated
_OWN_STOP_ID = -2  # id of the stops of the session itself, after `Welcome` and before `Leave`
_DELAY_INTERVAL = 1.0  # seconds between two reports of the network delay


@dataclass(slots=True)
class _WaitingRequests:
    requests: list[Request]
    deadline: float


class RemoteSession:
    """Session of a served board. `TrexSession` explains the arguments.

    The session requests the lease before the first request that needs it. It returns the lease
    when it closes.
    """

    def __init__(
        self,
        settings: ConnectionSettings,
        inbox: Inbox[Request],
        emit: Callable[[Report], None],
        clock: Callable[[], float],
        *,
        may_move: bool = False,
    ) -> None:
        self._settings, self._inbox, self._emit = settings, inbox, emit
        self._clock = clock
        self._link: ClientLink | None = None
        self._may_move = may_move
        self._received: deque[tuple[float, bytes]] = deque()
        self._counter = count(1)
        self._seen = 0.0  # newest server time in a report
        self._offset = math.inf  # this clock minus the server's clock (upper bound)
        self._heard_at = 0.0  # time of the last report
        self._heartbeat_at = 0.0  # time of the next heartbeat
        self._watched = SetWatched(True)
        self._welcome: Welcome | None = None
        self._lease = LeaseChanged()
        self._waiting: _WaitingRequests | None = None
        self._candidates: SetReconnectCandidates | None = None  # sent before the next `Write`
        self._board: Connected | None = None
        self._is_silent = False
        self._has_armed = False  # True from arming by this client until the next stop
        self._closed: Closed | None = None
        self._counters = Counters()
        self._unanswered: set[int] = set()
        self._stops: dict[int, Request] = {}  # unconfirmed stops, by id
        self._stop_at = 0.0  # time to repeat the unconfirmed stops
        self._delay_at = 0.0  # time of the last delay report

    def run(self) -> None:
        """Run until `Close` arrives or the server is lost. This method never raises."""
        error = run_until_closed(
            self._open, self._step, lambda detail: TrexInternalError(ErrorCode.INTERNAL, detail)
        )
        self._close()
        if self._waiting is not None:
            self._unanswered |= {getattr(inner_request(r), "id", 0) for r in self._waiting.requests}
        for number in self._unanswered - {0, _OWN_STOP_ID}:
            self._emit(Outcome(number, error=error or NoReply(self._lost_text)))
        self._emit(self._closed or Closed(error, self._may_move))

    # --- Opening and closing ------------------------------------------------------------

    def _open(self) -> None:
        address = Address.of(self._settings.url)
        self._link = ClientLink(address, self._receive)
        deadline = self._clock() + _REPLY_TIMEOUT
        hello_at = 0.0
        while self._welcome is None:
            now = self._clock()
            if now >= deadline:
                text = tr("{0} serves no board named {1} to this user.")
                raise PortUnavailable(text.format(address.host, address.name))
            if now >= hello_at:
                hello_at = now + 0.5
                self._send(Hello(VERSION, f"TReX Studio {__version__}"))
            self._handle_requests(_SLICE)
            self._handle_reports()
        self._heard_at = self._clock()

    def _close(self) -> None:
        if self._link is None:
            return
        try:
            if self._may_move and self._closed is None:
                self._forward(Stop(_OWN_STOP_ID))
                deadline = self._clock() + _STOP_TIMEOUT
                while self._may_move and self._clock() < deadline:
                    self._inbox.get(_SLICE)
                    self._handle_reports()
                    self._repeat_stops()
        except Exception:  # the engine may raise any error when the connection is lost
            log.info("the connection ended before the last stop was confirmed", exc_info=True)
        for end in (partial(self._send, Leave()), self._link.close):
            try:
                end()
            except Exception:
                log.info("the connection was not closed properly", exc_info=True)

    # --- The loop -----------------------------------------------------------------------

    def _step(self) -> None:
        now = self._clock()
        if now >= self._heartbeat_at:
            self._heartbeat_at = now + _HEARTBEAT
            self._send(Alive())
        self._handle_requests(min(_SLICE, max(0.0, self._heartbeat_at - now)))
        self._handle_reports()
        self._repeat_stops()
        self._check_silence()
        if self._waiting is not None and self._clock() >= self._waiting.deadline:
            self._reject_waiting()

    def _repeat_stops(self) -> None:
        """Repeat unconfirmed stops, because a cut connection loses messages."""
        if self._stops and self._clock() >= self._stop_at:
            self._stop_at = self._clock() + _STOP_INTERVAL
            for request in self._stops.values():
                self._send(request)

    def _check_silence(self) -> None:
        silence = self._clock() - self._heard_at
        if silence >= _LOST_AFTER:
            raise NoReply(self._lost_text)
        if silence >= _SILENT_AFTER and not self._is_silent and self._board is not None:
            self._is_silent = True
            self._emit(NotResponding(self._lost_text, self._counters, is_network=True))

    @property
    def _lost_text(self) -> str:
        silence = Reason(DriveBlocker.NETWORK_SILENT)
        return f"{silence.text()} {silence.remedy()}"

    # --- Requests -----------------------------------------------------------------------

    def _handle_requests(self, seconds: float) -> None:
        request = self._inbox.get(seconds)
        while request is not None:
            self._handle(request)
            request = self._inbox.get(0.0)

    def _handle(self, request: Request) -> None:
        match inner_request(request):
            case Close():
                raise Closing
            case SetWatched() as watched:
                self._watched = watched
                if self._welcome is not None:
                    self._send(watched)
            case Stop():
                self._drop_waiting_commands()
                self._forward(request)
            case SendPacket(packet=RawPacket(is_query=True)):
                self._forward(request)
            case _ if isinstance(request, LeaseRequest) or self._lease.is_mine:
                self._forward(request)
            case SetMotor() | SetMotors() | SetAuxiliary() if self._waiting is not None:
                self._waiting.requests.append(request)  # sent after a waiting `Arm`
            case SetReconnectCandidates() as candidates:
                self._candidates = candidates
            case Arm() | Write() | SelectBoard() | ProbeNumber() | Reload() | SendPacket() as inner:
                if self._waiting is None:
                    self._waiting = _WaitingRequests([], self._clock() + _REPLY_TIMEOUT)
                    self._send(AskLease())
                if isinstance(inner, Write) and self._candidates is not None:
                    self._waiting.requests.append(self._candidates)
                    self._candidates = None
                self._waiting.requests.append(request)

    def _forward(self, request: Request) -> None:
        inner = inner_request(request)
        if isinstance(inner, Heartbeat):
            request = Heartbeat()
        if isinstance(inner, Stop):
            self._has_armed = False
            self._stops[inner.id] = request
            self._stop_at = self._clock() + _STOP_INTERVAL
        elif isinstance(inner, Arm):
            self._has_armed = True
            for stop in self._stops.values():  # in case they were lost
                self._send(stop)
            self._stops.clear()  # a stop that is repeated later would stop the armed motors
        if (number := getattr(inner, "id", None)) is not None:
            self._unanswered.add(number)
        self._may_move = self._may_move or isinstance(inner, SetpointRequest)
        self._send(request)

    def _drop_waiting_commands(self) -> None:
        """Drop arming and motor commands that wait for the lease. A stop precedes them."""
        if self._waiting is None:
            return
        remaining: list[Request] = []
        for request in self._waiting.requests:
            match inner_request(request):
                case Arm() | SetMotor() | SetMotors() | SetAuxiliary():
                    pass
                case SendPacket(id=number, packet=packet) if packet.moves:
                    error = TrexRequestError(ErrorCode.OVERTAKEN_BY_STOP)
                    self._emit(Outcome(number, error=error))
                case _:
                    remaining.append(request)
        self._waiting.requests[:] = remaining

    def _reject_waiting(self) -> None:
        waiting, self._waiting = self._waiting, None
        code = ErrorCode.OTHER_DRIVES if self._lease.may_drive else ErrorCode.MAY_NOT_DRIVE
        for request in waiting.requests if waiting else ():
            if number := getattr(inner_request(request), "id", 0):
                self._emit(Outcome(number, error=TrexRequestError(code)))
            elif isinstance(request, Arm):
                self._emit(MotorsStopped(code, confirmed=True))

    def _send(self, request: Request | ClientRequest) -> None:
        if self._link is not None:
            header = next(self._counter), self._seen, self._clock()
            data = encode_request(request, *header)
            self._link.send(data, is_stop=isinstance(request, Stop))

    # --- Reports ------------------------------------------------------------------------

    def _receive(self, message: bytes) -> None:
        """Queue a received message. The engine calls this in its own threads."""
        self._received.append((self._clock(), message))

    def _handle_reports(self) -> None:
        while self._received:
            arrived, data = self._received.popleft()
            try:
                (_, time, echo), report = decode_report(data, 3)
            except BadRequest as error:
                log.warning("ignored an invalid message from the server: %s", error)
                continue
            self._seen = max(self._seen, time)
            self._offset = min(self._offset, arrived - time)
            self._heard_at = arrived
            if arrived - self._delay_at >= _DELAY_INTERVAL:
                self._delay_at = arrived
                self._emit(NetworkDelay(max(0.0, arrived - echo)))
            if self._is_silent:
                self._is_silent = False
                if self._board is not None:
                    self._emit(replace(self._board, occasion=ReadReason.RETURNED))
            self._report(report)

    def _report(self, report: Report | ServerReport) -> None:
        match report:
            case Welcome():
                self._welcome = report
                self._send(self._watched)
                if self._may_move:
                    self._forward(Stop(_OWN_STOP_ID))
            case Refused(reason=reason):
                raise PortUnavailable(reason)
            case Tick():
                pass
            case LeaseChanged():
                self._handle_lease(report)
            case Closed():
                self._closed = report
                raise report.error or Closing
            case _:
                self._emit_local(report)

    def _emit_local(self, report: Report | ServerReport, board: int | None = None) -> None:
        """Emit a report after converting its times and URL for this computer.

        `board` is the number of a board in the group, or `None` for the first board.
        """

        def emit(local: BoardReport) -> None:
            self._emit(local if board is None else OfBoard(board, local))

        match report:
            case OfBoard(number=number, report=inner):
                self._emit_local(inner, number)
            case Outcome(id=number) if number in self._unanswered:
                if (local := self._local_outcome(report, board)) is not None:
                    emit(local)
            case Connected():
                has_more = bool(report.settings.group or self._stops)  # boards or stops
                self._may_move = report.may_move or (self._may_move and has_more)
                settings = self._local_settings(report.settings)
                report = replace(report, settings=settings, may_move=self._may_move)
                if board is None:
                    self._board = report
                emit(report)
            case Batch():
                self._counters = report.counters
                samples = tuple(
                    replace(sample, time=sample.time + self._offset) for sample in report.samples
                )
                emit(replace(report, samples=samples))
            case Traffic(events=events):
                local_events = (replace(event, time=event.time + self._offset) for event in events)
                self._emit(Traffic(tuple(local_events)))
            case MotorsStopped(reason=reason, confirmed=confirmed):
                # The end of a lease stops every board. Any other stop is reported by each board.
                is_group = self._board is not None and bool(self._board.settings.group)
                stops_all = not is_group or reason is ErrorCode.LEASE_LOST
                self._may_move = self._may_move and not (confirmed and stops_all)
                if self._has_armed or reason is None:  # otherwise, another client was driving
                    emit(report)
                if stops_all:
                    self._has_armed = self._has_armed and reason is None
            case Welcome() | Refused() | Tick() | Outcome():  # `Outcome`: of a repeated stop
                pass
            case _:
                emit(report)

    def _local_outcome(self, outcome: Outcome, board: int | None) -> BoardReport | None:
        """Return the report for this computer. The stops of the session itself have no outcome."""
        self._unanswered.discard(outcome.id)
        confirmed = self._stops.pop(outcome.id, None) is not None and outcome.error is None
        if confirmed:
            self._may_move = False
        if outcome.id == _OWN_STOP_ID:
            return MotorsStopped(None, confirmed=True) if confirmed else None
        if not isinstance(written := outcome.value, Written):
            return outcome
        written = replace(written, settings=self._local_settings(written.settings))
        if self._board is not None and board is None:
            self._board = replace(self._board, state=written.state, settings=written.settings)
        return replace(outcome, value=written)

    def _local_settings(self, settings: ConnectionSettings) -> ConnectionSettings:
        return replace(settings, url=self._settings.url, name=self._settings.name)

    def _handle_lease(self, report: LeaseChanged) -> None:
        self._lease = report
        self._emit(report)
        if self._waiting is None:
            return
        if report.is_mine:
            waiting, self._waiting = self._waiting, None
            for request in waiting.requests:
                self._forward(request)
        elif report.driver or not report.may_drive:
            self._reject_waiting()
