"""The server of one board: its session, the lease, and the clients, without a network.

`take` gets what clients sent, and `send` is called with what they get. Every method may be called
from any thread; a stop never waits for a client.
"""

import logging
import threading
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import count
from typing import Any, TypeVar

from trex_gui.core.errors import BadRequest, StudioError
from trex_gui.core.session import Closed, Outcome
from trex_gui.devices.trex.driving.requests import (
    Arm,
    Heartbeat,
    MotorsStopped,
    SetAuxiliary,
    SetMotor,
    SetMotors,
    Stop,
    packets,
    setpoints_in,
)
from trex_gui.devices.trex.protocol.errors import ErrorCode, TrexError, TrexRequestError
from trex_gui.devices.trex.protocol.framing import Framing
from trex_gui.devices.trex.protocol.raw_packets import RawPacket, packets_of
from trex_gui.devices.trex.serve.codec import (
    LARGEST_REQUEST,
    Report,
    Request,
    decode_request,
    encode_report,
    with_head,
)
from trex_gui.devices.trex.serve.lease import LEASE_TIMEOUT, Lease, Party, Role
from trex_gui.devices.trex.serve.messages import (
    VERSION,
    Alive,
    Hello,
    Leave,
    Refused,
    Tick,
    Welcome,
)
from trex_gui.devices.trex.session.messages import (
    AskLease,
    Batch,
    Connected,
    GuardianChanged,
    HandOver,
    LeaseChanged,
    NotResponding,
    ReadReason,
    ReturnLease,
    SendPacket,
    SetWatched,
    TakeLease,
    Traffic,
    Written,
)

log = logging.getLogger(__name__)

NumberedT = TypeVar("NumberedT", bound=Any)

MOST_CLIENTS = 32
MOST_REQUESTS = 300  # of a client in a second: a window that drives sends some 120
_CLIENT_TIMEOUT = 5.0  # seconds without any message after which a client is gone
_TICK_INTERVAL = 0.1
_NO_OUTCOME = 0

_STALE = SetMotor | SetMotors | SetAuxiliary | Arm
"""Requests that have no effect once they are older than a lease lives without a heartbeat."""


_WATCHES = SetWatched(True)  # what a client does that has not said otherwise


@dataclass(slots=True, eq=False)
class _Client:
    party: Party
    counter: float  # of its last request
    stopped: float  # the same of its last stop, which may overtake the others
    heard_at: float
    echo: float = 0.0  # its clock at its last request, on that of the server
    sent: int = 0
    sent_at: float = 0.0
    watched: SetWatched = _WATCHES
    second: int = 0  # in which `in_second` requests came
    in_second: int = 0


class BoardServer:
    """Lets clients share one board.

    Args:
        name: of the board, as it is served.
        request: receives the requests for the session.
        send: receives a client and a message for it; must not wait.
        clock: of the reports of the session, in seconds.
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
        self.refused: Counter[str] = Counter()  # why messages were refused, and how many
        self.polynomial: int | None = None  # of packets on the line; `None`: without CRC
        self._request, self._send, self._clock = request, send, clock
        self._lock = threading.RLock()
        self._clients: dict[str, _Client] = {}
        self._ids = count(1)
        self._outcomes: dict[int, tuple[str, int]] = {}  # client and its id of each request
        self._newest: dict[type, Report] = {}  # reports that a new client gets
        self._watched_stops: dict[int, Callable[[Outcome], None]] = {}  # by id
        self._lease_stop = 0  # id of the stop at the end of a lease

    # --- Time ---------------------------------------------------------------------------

    def step(self) -> float:
        """Do what is due, and return the seconds until something may be due again."""
        with self._lock:
            now = self._clock()
            if self.lease.seconds_left(now) <= 0 and self.lease.holder is not None:
                log.warning("no heartbeat of %s: the motors are stopped", self.lease.holder.user)
                self._end_lease(self.lease.holder)
            for client in list(self._clients.values()):
                if now - client.heard_at > _CLIENT_TIMEOUT:
                    self._remove(client)
                elif now - client.sent_at >= _TICK_INTERVAL:
                    self._post(client, encode_report(Tick()), now)
            return max(0.0, min(self.lease.seconds_left(now), _TICK_INTERVAL / 2))

    # --- Clients ------------------------------------------------------------------------

    def take(self, party: Party, data: bytes) -> None:
        """Take a message of a client."""
        if len(data) > LARGEST_REQUEST:
            self._refuse("too large")
            return
        try:
            (counter, seen, sent), request = decode_request(data, 3)
        except BadRequest as error:
            log.debug("refused a message of %s: %s", party.user, error)
            self._refuse("malformed")
            return
        with self._lock:
            now = self._clock()
            if isinstance(request, Hello):
                self._welcome(party, request, counter, sent, now)
                return
            client = self._clients.get(party.id)
            if client is None or client.party != party:
                self._refuse("unknown client")
            elif counter <= (client.stopped if isinstance(request, Stop) else client.counter):
                self._refuse("replayed")
            elif self._floods(client, now) and not isinstance(request, Stop | Alive):
                self._refuse("too many")
            elif counter < client.stopped and isinstance(request, _STALE | Heartbeat):
                self._refuse("overtaken by a stop")
            else:
                client.heard_at, client.echo = now, sent - now
                if isinstance(request, Stop):
                    client.stopped = counter
                else:
                    client.counter = counter
                self._serve(client, request, age=now - seen)

    def remove(self, client_id: str) -> None:
        """Remove a client whose connection ended."""
        with self._lock:
            if client_id in self._clients:
                self._remove(self._clients[client_id])

    def stop(self, then: Callable[[Outcome], None]) -> None:
        """Stop the motors for a user who need not be a client; `then` gets the confirmation."""
        with self._lock:
            own = next(self._ids)
            self._watched_stops[own] = then
            self._request(Stop(own))

    @property
    def shows_traffic(self) -> bool:
        """Whether a client wants the bytes on the line."""
        return any(client.watched.traffic for client in list(self._clients.values()))

    @property
    def users(self) -> tuple[str, ...]:
        """The users of the clients."""
        return tuple(client.party.user for client in list(self._clients.values()))

    def _floods(self, client: _Client, now: float) -> bool:
        if client.second != int(now):
            client.second, client.in_second = int(now), 0
        client.in_second += 1
        return client.in_second > MOST_REQUESTS

    def _refuse(self, why: str) -> None:
        with self._lock:
            self.refused[why] += 1

    def _welcome(self, party: Party, hello: Hello, counter: float, sent: float, now: float) -> None:
        client = _Client(party, counter, counter, now, sent - now)
        if hello.version != VERSION:
            self._refuse("another version")
            text = f"{self.name} speaks version {VERSION} of the messages, not {hello.version}."
            self._post(client, encode_report(Refused(text)), now)
            return
        if len(self._clients) >= MOST_CLIENTS and party.id not in self._clients:
            self._refuse("too many clients")
            self._post(client, encode_report(Refused(f"{self.name} has too many clients.")), now)
            return
        if (former := self._clients.get(party.id)) is not None:
            self._remove(former)
        self._clients[party.id] = client
        news: list[Report] = [
            Welcome(self.name),
            self._lease_for(client),
            *self._newest.values(),
        ]
        for report in news:
            self._post(client, encode_report(report), now)
        self._update_watched()
        log.info("%s has joined (%s)", party.user, hello.program)

    def _remove(self, client: _Client) -> None:
        self._clients.pop(client.party.id, None)
        gone = [own for own, (owner, _) in self._outcomes.items() if owner == client.party.id]
        for own in gone:
            del self._outcomes[own]
        self._end_lease(client.party)
        self._update_watched()
        log.info("%s has left", client.party.user)

    # --- Requests -----------------------------------------------------------------------

    def _serve(self, client: _Client, request: Request, age: float) -> None:
        """Serve what concerns client and lease; the rest is for the board."""
        lease, party, now = self.lease, client.party, client.heard_at
        match request:
            case Alive():
                if age <= LEASE_TIMEOUT:
                    lease.record_heartbeat(party, now)
            case SetWatched():
                client.watched = request
                self._update_watched()
            case AskLease():
                lease.ask(party, now)
                self._report_lease()
            case HandOver(user=user):
                self._change(lambda: lease.hand_over(party, user, now))
            case TakeLease():
                self._change(lambda: lease.take(party, now))
            case ReturnLease():
                self._end_lease(party)
            case Leave():
                self._remove(client)
            case _:
                self._serve_board(client, request, age)

    def _serve_board(self, client: _Client, request: Request, age: float) -> None:
        holds_lease = self.lease.holder == client.party
        if isinstance(request, SendPacket):
            request = SendPacket(request.id, self._cut(request.packet))
            may_send = holds_lease or request.packet.is_query
        else:
            may_send = holds_lease or isinstance(request, Stop)
        if not may_send:
            self._reject(client, request)
        elif isinstance(request, _STALE) and age > LEASE_TIMEOUT:
            self._refuse("too old")
        elif isinstance(request, SetMotor | SetMotors | SetAuxiliary) and not _is_possible(request):
            self._refuse("impossible setpoint")
        elif isinstance(request, Heartbeat):
            self._request(Heartbeat())  # on the clock of this computer
        else:
            self._forward(client, request)

    def _change(self, change: Callable[[], bool]) -> None:
        """Stop the motors of one driver before another one may arm them."""
        before = self.lease.number
        if change() and self.lease.number != before:
            self._stop()
        self._report_lease()

    def _end_lease(self, party: Party) -> None:
        waiting = list(self.lease.waiting)
        if self.lease.leave(party):
            self._stop()
            self._report_lease()
        elif waiting != self.lease.waiting:
            self._report_lease()

    def _stop(self) -> None:
        self._lease_stop = next(self._ids)
        self._request(Stop(self._lease_stop))

    def _forward(self, client: _Client, request: Request) -> None:
        number = getattr(request, "id", None)
        if number is None:
            self._request(request)
            return
        own = next(self._ids)
        if number != _NO_OUTCOME:
            self._outcomes[own] = client.party.id, number
        self._request(_numbered(request, own))

    def _reject(self, client: _Client, request: Request) -> None:
        self._refuse("without the lease")
        number = getattr(request, "id", _NO_OUTCOME)
        if number:
            may_drive = client.party.role >= Role.DRIVE
            code = ErrorCode.OTHER_DRIVES if may_drive else ErrorCode.MAY_NOT_DRIVE
            outcome = Outcome(number, error=TrexRequestError(code))
            self._post(client, encode_report(outcome), client.heard_at)
        else:
            self._post(client, encode_report(self._lease_for(client)), client.heard_at)

    def _cut(self, packet: RawPacket) -> RawPacket:
        """Return the packet that its bytes are on this line; what is none stays as it is."""
        cut = packets_of(packet.packet.raw, self.polynomial)
        return cut[0] if len(cut) == 1 else packet

    def _update_watched(self) -> None:
        self._request(SetWatched(any(client.watched.watched for client in self._clients.values())))

    # --- Reports ------------------------------------------------------------------------

    def report(self, report: Report) -> None:
        """Pass a report of the session on to every client, an `Outcome` to the one that waits."""
        with self._lock:
            now = self._clock()
            match report:
                case Outcome(id=own) if own == self._lease_stop:
                    report = MotorsStopped(ErrorCode.LEASE_LOST, report.error is None)
                case Outcome(id=own) if own in self._watched_stops:
                    self._watched_stops.pop(own)(report)
                    return
                case Outcome(id=own, value=value):
                    client_id, number = self._outcomes.pop(own, ("", 0))
                    if client := self._clients.get(client_id):
                        self._post(client, encode_report(_numbered(report, number)), now)
                    if isinstance(value, Written):
                        self._report_written(value, client_id, now)
                    return
                case Connected():
                    self.polynomial = report.settings.framing.polynomial
                    guardian = self._newest.get(GuardianChanged)
                    first = replace(report, occasion=ReadReason.OPENED)
                    self._newest = {Connected: first}
                    if guardian is not None:
                        self._newest[GuardianChanged] = guardian
                case GuardianChanged() | NotResponding():
                    self._newest[type(report)] = report
                case Closed():
                    self._newest = {Closed: report}
            form = encode_report(report)
            for client in list(self._clients.values()):
                if _is_for(report, client.watched):
                    self._post(client, form, now)

    def _report_written(self, written: Written, writer: str, now: float) -> None:
        """Let everybody but its writer know what the board stores now."""
        connected = self._newest.get(Connected)
        if not isinstance(connected, Connected):
            return
        connected = replace(connected, state=written.state, settings=written.settings)
        self._newest[Connected] = connected
        form = encode_report(replace(connected, occasion=ReadReason.RELOADED))
        for client in self._clients.values():
            if client.party.id != writer:
                self._post(client, form, now)

    def end(self, error: StudioError | None, *, may_move: bool) -> None:
        """Tell every client that the line was closed."""
        with self._lock:
            self.report(Closed(error or TrexError(ErrorCode.CLOSED), may_move))
            self._clients.clear()
            self._outcomes.clear()
            self.lease = Lease(number=self.lease.number)

    def _lease_for(self, client: _Client) -> LeaseChanged:
        lease = self.lease
        party = client.party
        return LeaseChanged(
            user=party.user,
            driver=lease.holder.user if lease.holder else "",
            is_mine=lease.holder == party,
            waiting=tuple(dict.fromkeys(one.user for one in lease.waiting)),
            may_drive=party.role >= Role.DRIVE,
            may_take=party.role >= Role.OWN,
        )

    def _report_lease(self) -> None:
        now = self._clock()
        for client in list(self._clients.values()):
            self._post(client, encode_report(self._lease_for(client)), now)

    def _post(self, client: _Client, form: object, now: float) -> None:
        client.sent, client.sent_at = client.sent + 1, now
        self._send(client.party, with_head(form, client.sent, now, client.echo + now))


def _is_for(report: Report, watched: SetWatched) -> bool:
    """Return whether a client that watches like this gets a report."""
    if isinstance(report, Traffic):
        return watched.traffic
    return watched.watched or not isinstance(report, Batch)


def _numbered(message: NumberedT, number: int) -> NumberedT:
    return replace(message, id=number)


def _is_possible(request: SetMotor | SetMotors | SetAuxiliary) -> bool:
    """Return whether a board has such motors and speeds."""
    setpoints = setpoints_in(request)
    motors = [one.motor for one in setpoints]
    try:
        for command in packets(setpoints):
            Framing(None, None).encode(command)
    except BadRequest:
        return False
    return len(set(motors)) == len(motors)
