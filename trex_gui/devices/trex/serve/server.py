"""Server of a line for several clients, independent of the network.

Methods may be called from any thread. A stop never waits for a client.
"""

import logging
import threading
from collections import Counter, deque
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace
from itertools import count

from trex_gui.core.errors import BadRequest, StudioError
from trex_gui.core.session import Closed, Outcome
from trex_gui.devices.trex.driving.requests import (
    Arm,
    Heartbeat,
    MotorsStopped,
    SetAuxiliary,
    SetpointRequest,
    Stop,
    is_valid,
    setpoints_in,
)
from trex_gui.devices.trex.protocol.errors import ErrorCode, TrexError, TrexRequestError
from trex_gui.devices.trex.protocol.raw_packets import packets_of
from trex_gui.devices.trex.serve.codec import (
    MAX_REQUEST_SIZE,
    VERSION,
    Alive,
    Hello,
    Leave,
    Refused,
    Report,
    Request,
    Tick,
    Welcome,
    decode_request,
    encode_report,
    inner_request,
    with_header,
)
from trex_gui.devices.trex.serve.lease import LEASE_TIMEOUT, Lease, Party, Role
from trex_gui.devices.trex.session.messages import (
    AskLease,
    Batch,
    BoardReport,
    Connected,
    GuardianChanged,
    HandOver,
    Job,
    LeaseChanged,
    NotResponding,
    OfBoard,
    ProbeNumber,
    ReadReason,
    ReturnLease,
    SendPacket,
    SetpointsChanged,
    SetWatched,
    TakeLease,
    ToBoard,
    Traffic,
    Written,
)

log = logging.getLogger(__name__)

_WAITING_LIMIT = 32  # maximum number of client requests that one stop confirms
MAX_REQUESTS = 600  # requests per second of a user; a window that drives sends about 120
MAX_JOBS = 8  # queued jobs of a client
_PACKET_LIMIT = 16  # bytes; a longer packet would delay a stop for too long
_ATTEMPT_LIMIT = 3  # maximum number of attempts in a `ProbeNumber`
_CLIENT_TIMEOUT = 5.0  # seconds without a message until a client is removed
_TICK_INTERVAL = 0.1  # seconds without a message to a client until it receives a `Tick`
_IDLE_INTERVAL = 0.25  # seconds between steps without clients; half of the lease timeout

_EXPIRING = SetpointRequest | Arm  # ignored if older than the lease timeout

_DEFAULT_WATCHED = SetWatched(True)  # until a client sends a `SetWatched`


@dataclass(slots=True, eq=False)
class _Client:
    party: Party
    counter: float  # counter of the last request
    stopped: float  # counter of the last stop, which may overtake requests
    heard_at: float
    echo: float = 0.0  # client's clock minus server's clock at the last request
    sent: int = 0
    sent_at: float = 0.0
    watched: SetWatched = _DEFAULT_WATCHED
    jobs: deque[Job | ToBoard] = field(default_factory=deque)  # jobs after the job in flight
    in_flight: int = 0  # request id of the client's job in the session, or 0


class BoardServer:
    """Server of a board or group for several clients.

    Args:
        name: name of the served board.
        request: receives the requests to the session.
        send: receives a client and a message to the client. It must not block.
        clock: clock of the session, in seconds.
    """

    def __init__(
        self,
        name: str,
        request: Callable[[object], None],
        send: Callable[[Party, bytes], None],
        clock: Callable[[], float],
    ) -> None:
        self.name = name
        self.lease = Lease()
        self.refused: Counter[str] = Counter()  # reason → number of refused messages
        self.polynomial: int | None = None  # `None` without CRC
        self._request, self._send, self._clock = request, send, clock
        self._lock = threading.RLock()
        self._clients: dict[Party, _Client] = {}
        self._ids = count(1)
        # Request id → waiting clients, each with the id of its own request
        self._outcomes: dict[int, list[tuple[Party, int]]] = {}
        self._pending_stop = 0  # id of the last stop; 0 after a request that may move a motor
        # User, and whether the requests are stops → (second, requests in this second)
        self._rates: dict[tuple[str, bool], tuple[int, int]] = {}
        # Board (`None` for the first) → type of report → newest report, for new clients
        self._newest: dict[int | None, dict[type, BoardReport]] = {None: {}}
        self._watched_stops: dict[int, Callable[[Outcome], None]] = {}  # stop id → callback
        self._lease_stop = 0  # id of the stop at the end of a lease
        # Board (`None` for the first) → motor → speed since the last stop
        self._speeds: dict[int | None, dict[int, int]] = {}

    # --- Time ---------------------------------------------------------------------------

    def step(self) -> float:
        """Apply the timeouts. Return the seconds until the next step."""
        with self._lock:
            now = self._clock()
            if self.lease.seconds_left(now) <= 0 and self.lease.holder is not None:
                log.warning("no heartbeat from %s: stopping the motors", self.lease.holder.user)
                self._end_lease(self.lease.holder)
            for client in self._all_clients:
                if now - client.heard_at > _CLIENT_TIMEOUT:
                    self._remove(client)
                elif now - client.sent_at >= _TICK_INTERVAL:
                    self._post(client, encode_report(Tick()), now)
            longest = _TICK_INTERVAL / 2 if self._clients else _IDLE_INTERVAL
            return max(0.0, min(self.lease.seconds_left(now), longest))

    # --- Clients ------------------------------------------------------------------------

    def handle(self, party: Party, data: bytes) -> None:
        """Handle a message of a client. Invalid messages are only counted."""
        if len(data) > MAX_REQUEST_SIZE:
            self._refuse("too large")
            return
        try:
            (counter, seen, sent), request = decode_request(data, 3)
        except BadRequest as error:
            log.debug("refused a message from %s: %s", party.user, error)
            self._refuse("malformed")
            return
        if self.exceeds_limit(party.user, is_stop=isinstance(request, Stop)):
            self._refuse("too many")
            return
        with self._lock:
            now = self._clock()
            if isinstance(request, Hello):
                self._welcome(party, request, counter, sent, now)
                return
            client, inner = self._clients.get(party), inner_request(request)
            if client is None:
                self._refuse("unknown client")
            elif counter <= (client.stopped if isinstance(request, Stop) else client.counter):
                self._refuse("replayed")
            elif counter < client.stopped and isinstance(inner, _EXPIRING | Heartbeat):
                self._refuse("overtaken by a stop")
            elif isinstance(request, ToBoard) and isinstance(inner, Arm | Heartbeat):
                self._refuse("malformed")
            else:
                client.heard_at, client.echo = now, sent - now
                if isinstance(request, Stop):
                    client.stopped = counter
                else:
                    client.counter = counter
                self._serve(client, request, age=now - seen)

    def remove(self, party: Party) -> None:
        with self._lock:
            if party in self._clients:
                self._remove(self._clients[party])

    def stop(self, on_outcome: Callable[[Outcome], None]) -> None:
        """Stop the motors. `on_outcome` receives the outcome."""
        with self._lock:
            stop_id = next(self._ids)
            self._watched_stops[stop_id] = on_outcome
            self._speeds.clear()
            self._request(Stop(stop_id))

    @property
    def shows_traffic(self) -> bool:
        return any(client.watched.traffic for client in self._all_clients)

    @property
    def parties(self) -> set[Party]:
        with self._lock:
            return set(self._clients)

    @property
    def users(self) -> tuple[str, ...]:
        return tuple(client.party.user for client in self._all_clients)

    def exceeds_limit(self, user: str, *, is_stop: bool) -> bool:
        """Count a request of the user. Return whether the user has exceeded `MAX_REQUESTS`.

        Stops are counted separately, because several programs may have the same user.
        """
        with self._lock:
            now, kind = int(self._clock()), (user, is_stop)
            second, count = self._rates.get(kind, (now, 0))
            count = count + 1 if second == now else 1
            self._rates[kind] = now, count
            return count > MAX_REQUESTS

    def _refuse(self, reason: str) -> None:
        with self._lock:
            self.refused[reason] += 1

    def _welcome(self, party: Party, hello: Hello, counter: float, sent: float, now: float) -> None:
        client = _Client(party, counter, counter, now, sent - now)
        if hello.version != VERSION:
            self._refuse("another version")
            text = f"{self.name} needs messages of version {VERSION}, not {hello.version}."
            self._post(client, encode_report(Refused(text)), now)
            return
        previous = self._clients.get(party)
        if previous is not None and counter <= previous.counter:
            self._refuse("replayed")
            return
        if previous is not None:
            self._remove(previous)
        self._clients[party] = client
        reports: list[Report] = [Welcome(self.name), self._lease_for(client)]
        for board, newest in self._newest.items():
            reports += [_of_board(board, report) for report in newest.values()]
        for report in reports:
            self._post(client, encode_report(report), now)
        self._update_watched()
        log.info("%s has joined (%.60r)", party.user, hello.program)

    def _remove(self, client: _Client) -> None:
        self._clients.pop(client.party, None)
        for waiting in self._outcomes.values():
            waiting[:] = [(party, number) for party, number in waiting if party != client.party]
        self._end_lease(client.party)
        self._update_watched()
        log.info("%s has left", client.party.user)

    # --- Requests -----------------------------------------------------------------------

    def _serve(self, client: _Client, request: Request, age: float) -> None:
        lease, party, now = self.lease, client.party, client.heard_at
        match request:
            case Alive():
                if age <= LEASE_TIMEOUT:
                    lease.record_heartbeat(party, now)
            case SetWatched():
                client.watched = request
                self._update_watched()
            case AskLease():
                before = self._lease_state
                lease.request(party, now)
                if self._lease_state != before or lease.holder != party:
                    self._report_lease(() if self._lease_state != before else (client,))
            case HandOver(user=user):
                self._change(lambda: lease.hand_over(party, user, now))
            case TakeLease():
                self._change(lambda: lease.claim(party, now))
            case ReturnLease():
                self._end_lease(party)
            case Leave():
                self._remove(client)
            case _:
                self._serve_board(client, request, age)

    def _serve_board(
        self, client: _Client, request: Request, age: float, number: int | None = None
    ) -> None:
        if isinstance(request, ToBoard):
            if request.number in self._newest or request.number == self._first_number:
                self._serve_board(client, request.request, age, request.number)
            else:
                self._reject(client, request.request)
            return
        if isinstance(request, SendPacket):  # parse again with the polynomial of the line
            parsed = packets_of(request.packet.packet.raw, self.polynomial)
            request = SendPacket(request.id, parsed[0] if len(parsed) == 1 else request.packet)
        if not self._may_send(client, request):
            self._reject(client, request)
        elif isinstance(request, Job):
            client.jobs.append(request if number is None else ToBoard(number, request))
            self._request_next_job(client)
        elif isinstance(request, _EXPIRING) and age > LEASE_TIMEOUT:
            self._refuse("too old")
        elif isinstance(request, SetpointRequest) and not is_valid(request):
            self._refuse("impossible setpoint")
        elif isinstance(request, Heartbeat):
            self._request(Heartbeat())  # a new heartbeat has the time of this computer
        elif number is not None and isinstance(request, SetpointRequest):
            self._pending_stop = 0
            self._record_speeds(None if number == self._first_number else number, request)
            self._request(ToBoard(number, request))
        else:
            self._forward(client, request)

    def _record_speeds(self, board: int | None, request: SetpointRequest) -> None:
        for setpoint in setpoints_in(request):
            speeds = self._speeds.setdefault(board, {})
            if isinstance(setpoint, SetAuxiliary):
                speeds[setpoint.motor] = setpoint.speed
            else:
                speeds[setpoint.motor] = setpoint.drive.signed

    @property
    def _first_number(self) -> int | None:
        connected = self._newest[None].get(Connected)
        group = connected.settings.group if isinstance(connected, Connected) else ()
        return group[0] if group else None

    def _may_send(self, client: _Client, request: Request) -> bool:
        if isinstance(request, Stop):
            return True
        if isinstance(request, SendPacket):
            raw = request.packet.packet.raw
            if len(raw) > _PACKET_LIMIT or len(client.jobs) >= MAX_JOBS:
                return False
            if request.packet.is_query:
                return True
        if isinstance(request, ProbeNumber) and not 0 < request.attempts <= _ATTEMPT_LIMIT:
            return False
        return self.lease.holder == client.party and len(client.jobs) < MAX_JOBS

    def _request_next_job(self, client: _Client) -> None:
        if client.jobs and not client.in_flight:
            request = client.jobs.popleft()
            job = inner_request(request)
            assert isinstance(job, Job)  # noqa: S101 - nothing else is queued
            if isinstance(job, SendPacket) and job.packet.moves:
                self._pending_stop = 0
            client.in_flight = request_id = next(self._ids)
            self._outcomes[request_id] = [(client.party, job.id)]
            job = replace(job, id=request_id)
            self._request(replace(request, request=job) if isinstance(request, ToBoard) else job)

    def _drop_jobs(self, party: Party) -> None:
        if (client := self._clients.get(party)) is not None:
            jobs, client.jobs = client.jobs, deque()
            for job in jobs:
                self._reject(client, inner_request(job))

    def _change(self, change: Callable[[], bool]) -> None:
        """Change the lease. Stop the motors of the old driver before the new driver may arm."""
        number, old_driver = self.lease.number, self.lease.holder
        if change() and self.lease.number != number:
            if old_driver is not None:
                self._drop_jobs(old_driver)
            self._stop()
            self._report_lease()

    def _end_lease(self, party: Party) -> None:
        waiting = list(self.lease.waiting)
        if self.lease.remove(party):
            self._drop_jobs(party)
            self._stop()
            self._report_lease()
        elif waiting != self.lease.waiting:
            self._report_lease()

    def _stop(self) -> None:
        self._lease_stop = next(self._ids)
        self._speeds.clear()
        self._request(Stop(self._lease_stop))

    def _forward(self, client: _Client, request: Request) -> None:
        """Forward a stop or a motor command. Later stop requests join a pending stop."""
        if not isinstance(request, Stop):
            self._pending_stop = 0
            if isinstance(request, SetpointRequest):
                self._record_speeds(None, request)
            self._request(request)
            return
        self._speeds.clear()
        waiting = self._outcomes.get(self._pending_stop)
        if waiting is None:
            self._pending_stop = stop_id = next(self._ids)
            waiting = self._outcomes[stop_id] = []
            self._request(Stop(stop_id))
        if (client.party, request.id) not in waiting:  # the client may have repeated its stop
            waiting.append((client.party, request.id))

    def _reject(self, client: _Client, request: Request) -> None:
        self._refuse("not permitted")
        number = getattr(request, "id", 0)
        if number:
            may_drive = client.party.role >= Role.DRIVE
            code = ErrorCode.OTHER_DRIVES if may_drive else ErrorCode.MAY_NOT_DRIVE
            report: Report = Outcome(number, error=TrexRequestError(code))
        else:
            report = self._lease_for(client)
        self._post(client, encode_report(report), client.heard_at)

    def _update_watched(self) -> None:
        self._request(SetWatched(any(client.watched.watched for client in self._clients.values())))

    # --- Reports ------------------------------------------------------------------------

    def report(self, report: Report) -> None:
        """Send a report to all clients, or an `Outcome` to the waiting clients."""
        with self._lock:
            now = self._clock()
            match report:
                case Outcome(id=request_id) if request_id == self._lease_stop:
                    self._report_lease_stop(confirmed=report.error is None)
                    return
                case Outcome(id=request_id) if request_id in self._watched_stops:
                    self._watched_stops.pop(request_id)(report)
                    return
                case Outcome():
                    self._report_outcome(report, now)
                    return
                case OfBoard(number=number, report=Outcome() as outcome):
                    self._report_outcome(outcome, now, number)
                    return
                case MotorsStopped() | OfBoard(report=MotorsStopped()):
                    self._speeds.clear()
                case Batch():
                    self._report_setpoints()
                case Closed():
                    self._newest = {None: {Closed: report}}
                case OfBoard(number=number, report=state):
                    self._record_state(number, state)
                case Connected() | GuardianChanged() | NotResponding() | SetpointsChanged():
                    self._record_state(None, report)
            clients = (client for client in self._all_clients if _is_for(report, client.watched))
            self._post_all(report, clients)

    def _record_state(self, board: int | None, report: BoardReport) -> None:
        newest = self._newest.setdefault(board, {})
        match report:
            case Connected():
                retained = {GuardianChanged, SetpointsChanged} & newest.keys()
                opened = replace(report, occasion=ReadReason.OPENED)
                self._newest[board] = {
                    Connected: opened,
                    **{kind: newest[kind] for kind in retained},
                }
                if board is None:
                    self.polynomial = report.settings.framing.polynomial
                    boards = (None, *report.settings.group[1:])
                    self._newest = {number: self._newest.get(number, {}) for number in boards}
            case GuardianChanged() | NotResponding() | SetpointsChanged():
                newest[type(report)] = report

    def _report_lease_stop(self, *, confirmed: bool) -> None:
        holder = self.lease.holder if confirmed else None
        others = (client for client in self._all_clients if client.party != holder)
        self._post_all(MotorsStopped(ErrorCode.LEASE_LOST, confirmed), others)

    def _report_setpoints(self) -> None:
        for board, newest in list(self._newest.items()):
            get = self._speeds.get(board, {}).get
            setpoints = SetpointsChanged((get(1, 0), get(2, 0), get(3, 0)))
            if setpoints != newest.get(SetpointsChanged, SetpointsChanged()):
                self.report(_of_board(board, setpoints))

    def _report_outcome(self, outcome: Outcome, now: float, board: int | None = None) -> None:
        """Send an outcome to the waiting clients. `board` is `None` for the first board.

        Then request the next job of the client whose job has ended.
        """
        waiting = self._outcomes.pop(outcome.id, [])
        if isinstance(outcome.value, Written):
            self._report_written(outcome.value, [party for party, _ in waiting], board)
        for party, number in waiting[:_WAITING_LIMIT]:
            if client := self._clients.get(party):
                report = _of_board(board, replace(outcome, id=number))
                self._post(client, encode_report(report), now)
        for client in self._clients.values():
            if client.in_flight == outcome.id:
                client.in_flight = 0
                self._request_next_job(client)

    def _report_written(self, written: Written, writers: list[Party], board: int | None) -> None:
        connected = self._newest.get(board, {}).get(Connected)
        if not isinstance(connected, Connected):
            return
        connected = replace(connected, state=written.state, settings=written.settings)
        self._newest[board][Connected] = connected
        reloaded = replace(connected, occasion=ReadReason.RELOADED)
        others = (client for client in self._all_clients if client.party not in writers)
        self._post_all(_of_board(board, reloaded), others)

    def end(self, error: StudioError | None, *, may_move: bool) -> None:
        """Report the end of the session, and remove all clients."""
        with self._lock:
            self.report(Closed(error or TrexError(ErrorCode.CLOSED), may_move))
            self._clients.clear()
            self._outcomes.clear()
            self._speeds.clear()
            self.lease = Lease()

    def _lease_for(self, client: _Client) -> LeaseChanged:
        lease = self.lease
        party = client.party
        return LeaseChanged(
            user=party.user,
            driver=lease.holder.user if lease.holder else "",
            is_mine=lease.holder == party,
            waiting=tuple(dict.fromkeys(waiting.user for waiting in lease.waiting)),
            may_drive=party.role >= Role.DRIVE,
            may_take=party.role >= Role.OWN,
        )

    @property
    def _lease_state(self) -> tuple[object, ...]:
        return self.lease.holder, self.lease.number, tuple(self.lease.waiting)

    def _report_lease(self, clients: Sequence[_Client] = ()) -> None:
        now = self._clock()
        for client in clients or self._all_clients:
            self._post(client, encode_report(self._lease_for(client)), now)

    @property
    def _all_clients(self) -> list[_Client]:
        return list(self._clients.values())

    def _post_all(self, report: Report, clients: Iterable[_Client]) -> None:
        body, now = encode_report(report), self._clock()
        for client in clients:
            self._post(client, body, now)

    def _post(self, client: _Client, body: object, now: float) -> None:
        client.sent, client.sent_at = client.sent + 1, now
        self._send(client.party, with_header(body, client.sent, now, client.echo + now))


def _of_board(board: int | None, report: BoardReport) -> Report:
    return report if board is None else OfBoard(board, report)


def _is_for(report: Report, watched: SetWatched) -> bool:
    if isinstance(report, OfBoard):
        return _is_for(report.report, watched)
    if isinstance(report, Traffic):
        return watched.traffic
    return watched.watched or not isinstance(report, Batch)
