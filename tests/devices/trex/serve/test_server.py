"""Permissions, leases and reports of a board server."""

import heapq
import random
from collections.abc import Callable
from dataclasses import replace
from itertools import count
from typing import Any

import pytest

from tests.devices.trex.session.helpers import of_type
from trex_gui.core.errors import NoReply
from trex_gui.core.session import Closed, Outcome
from trex_gui.devices.trex.client.client import Counters
from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.driving.requests import (
    Arm,
    Heartbeat,
    MotorsStopped,
    SetAuxiliary,
    SetMotor,
    SetMotors,
    Stop,
)
from trex_gui.devices.trex.protocol.commands import (
    Command,
    DriveMotor,
    GetSignature,
    SetParameter,
    Signature,
)
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.driving import Direction, Drive
from trex_gui.devices.trex.protocol.errors import ErrorCode
from trex_gui.devices.trex.protocol.flags import Mode
from trex_gui.devices.trex.protocol.framing import Framing, Malformed
from trex_gui.devices.trex.protocol.raw_packets import RawPacket
from trex_gui.devices.trex.serve.codec import (
    MAX_REQUEST_SIZE,
    VERSION,
    Alive,
    Hello,
    Leave,
    Refused,
    Tick,
    Welcome,
    decode_report,
    encode_request,
)
from trex_gui.devices.trex.serve.lease import LEASE_TIMEOUT, Party, Role
from trex_gui.devices.trex.serve.server import MAX_JOBS, MAX_REQUESTS, BoardServer
from trex_gui.devices.trex.session.messages import (
    AskLease,
    Batch,
    Connected,
    HandOver,
    LeaseChanged,
    NotResponding,
    OfBoard,
    ProbeNumber,
    ReadReason,
    Reload,
    ReturnLease,
    SendPacket,
    SetpointsChanged,
    SetWatched,
    TakeLease,
    ToBoard,
    Traffic,
    Write,
    Written,
)

STATE = DeviceState(Signature(device_table().models[0], "1.2"), Mode.SERIAL_RC, True, {}, {}, 0)
CONNECTED = Connected(STATE, False, ReadReason.RETURNED, ConnectionSettings("/dev/ttyUSB0"))


class ServerHarness:
    """Board server with its clients, and the requests to its session."""

    def __init__(self) -> None:
        self.now = 100.0
        self.session: list[Any] = []
        self.received: dict[str, list[Any]] = {}
        self.server = BoardServer("arm", self.session.append, self._send, lambda: self.now)
        self._counters: dict[str, count[int]] = {}
        self.parties: dict[str, Party] = {}

    def _send(self, party: Party, message: bytes) -> None:
        _, report = decode_report(message, 3)
        if not isinstance(report, Tick):
            self.received.setdefault(party.user, []).append(report)

    def join(self, user: str, role: Role = Role.DRIVE, version: int = VERSION) -> Party:
        party = self.parties[user] = Party(f"id-{user}", user, role)
        self._counters[user] = count(1)
        self.send(user, Hello(version, "test"))
        return party

    def message(self, user: str, request: Any, *, age: float = 0.0) -> bytes:
        return encode_request(request, next(self._counters[user]), self.now - age, self.now)

    def send(self, user: str, *requests: Any, age: float = 0.0) -> None:
        for request in requests:
            self.server.handle(self.parties[user], self.message(user, request, age=age))

    def kinds(self) -> list[type]:
        """Return the types of the requests to the session, except `SetWatched`."""
        return [type(request) for request in self.session if not isinstance(request, SetWatched)]

    def lease_of(self, user: str) -> LeaseChanged:
        """Return the last lease that a user received."""
        return of_type(self.received[user], LeaseChanged)[-1]

    def outcome(self, user: str) -> Outcome:
        """Return the only outcome that a user received."""
        (outcome,) = of_type(self.received[user], Outcome)
        return outcome


@pytest.fixture
def harness() -> ServerHarness:
    harness = ServerHarness()
    harness.server.report(CONNECTED)
    harness.join("alice")
    harness.join("bob")
    harness.join("watcher", Role.WATCH)
    harness.join("owner", Role.OWN)
    return harness


def packet(command: Command[Any]) -> SendPacket:
    return SendPacket(5, RawPacket(Malformed(Framing(None, None).encode(command), "")))


# --- Clients ------------------------------------------------------------------------------


def test_new_client_receives_board_driver_and_silence(harness: ServerHarness) -> None:
    harness.send("alice", AskLease())
    harness.server.report(NotResponding("no reply", Counters()))
    harness.join("late")
    welcome, lease, board, silence = harness.received["late"]
    assert welcome == Welcome("arm")
    assert (lease.driver, lease.is_mine) == ("alice", False)
    assert board.occasion is ReadReason.OPENED, "for this client the board is new"
    assert isinstance(silence, NotResponding)


def test_client_of_another_version_is_rejected(harness: ServerHarness) -> None:
    harness.join("old", version=VERSION + 1)
    (refusal,) = harness.received["old"]
    assert isinstance(refusal, Refused)
    harness.send("old", Stop(1))
    assert harness.kinds() == []


def test_new_client_receives_error_of_lost_board(harness: ServerHarness) -> None:
    harness.server.end(NoReply("no board"), may_move=False)
    harness.join("late")
    closed = harness.received["late"][-1]
    assert isinstance(closed, Closed)
    assert str(closed.error) == "no board"


def test_outcome_is_sent_to_its_client_only(harness: ServerHarness) -> None:
    harness.send("alice", packet(GetSignature()))
    harness.send("bob", packet(GetSignature()))
    first, second = (request.id for request in of_type(harness.session, SendPacket))
    assert first != second
    harness.server.report(Outcome(second))
    assert harness.outcome("bob").id == 5
    assert not of_type(harness.received["alice"], Outcome)


def test_written_settings_are_reported_to_other_clients(harness: ServerHarness) -> None:
    harness.send("alice", AskLease(), Write(7, (("serial_timeout", 5),)))
    state = replace(STATE, parameters={"serial_timeout": 5})
    harness.server.report(Outcome(harness.session[-1].id, Written((), state, CONNECTED.settings)))
    assert harness.received["bob"][-1].state == state
    assert harness.received["bob"][-1].occasion is ReadReason.RELOADED
    assert isinstance(harness.received["alice"][-1], Outcome)
    harness.join("late")
    assert harness.received["late"][-1].state == state


def speeds_of(harness: ServerHarness, user: str) -> tuple[int, int, int]:
    harness.server.report(Batch((), Counters()))
    return of_type(harness.received[user], SetpointsChanged)[-1].speeds


def test_setpoints_end_with_the_line(harness: ServerHarness) -> None:
    harness.send("alice", AskLease(), Arm(), SetMotor(1, Drive.at(-40)))
    harness.server.end(NoReply("no board"), may_move=True)
    harness.server.report(CONNECTED)
    harness.join("watcher", Role.WATCH)
    harness.server.report(Batch((), Counters()))
    assert not of_type(harness.received["watcher"], SetpointsChanged)


@pytest.mark.parametrize(
    "end",
    [
        lambda harness: harness.send("watcher", Stop(4)),
        lambda harness: harness.send("alice", ReturnLease()),
        lambda harness: harness.server.stop(lambda _: None),
        lambda harness: harness.server.report(MotorsStopped(ErrorCode.NO_HEARTBEAT, True)),
    ],
    ids=["stop by watcher", "returned lease", "stop by server", "stop by session"],
)
def test_watchers_receive_setpoints_until_the_motors_stop(
    harness: ServerHarness, end: Callable[[ServerHarness], object]
) -> None:
    harness.send("alice", AskLease(), Arm(), SetMotor(1, Drive.at(-40)), SetAuxiliary(90))
    assert speeds_of(harness, "watcher") == (-40, 0, 90)
    harness.server.report(CONNECTED)
    harness.join("late")
    assert SetpointsChanged((-40, 0, 90)) in harness.received["late"]
    end(harness)
    assert speeds_of(harness, "watcher") == (0, 0, 0)


def test_polling_is_fast_while_any_client_watches(harness: ServerHarness) -> None:
    for user in harness.parties:
        harness.send(user, SetWatched(False))
    assert harness.session[-1] == SetWatched(False)
    harness.send("bob", SetWatched(True))
    assert harness.session[-1] == SetWatched(True)


def test_samples_and_traffic_are_sent_only_on_request(harness: ServerHarness) -> None:
    harness.send("alice", SetWatched(False))
    before = len(harness.received["alice"])
    harness.server.report(Batch((), Counters()))
    assert type(harness.received["bob"][-1]) is Batch
    assert len(harness.received["alice"]) == before
    harness.server.report(Traffic(()))
    assert not of_type(harness.received["bob"], Traffic)
    harness.send("bob", SetWatched(True, traffic=True))
    harness.server.report(Traffic(()))
    assert of_type(harness.received["bob"], Traffic)


def test_silent_client_is_removed(harness: ServerHarness) -> None:
    for _ in range(60):
        harness.now += 0.1
        harness.send("bob", Alive())
        harness.server.step()
    assert harness.server.users == ("bob",)


# --- Several boards -----------------------------------------------------------------------

GROUP = replace(CONNECTED, settings=CONNECTED.settings.with_group((7, 9)))
NINTH = replace(CONNECTED, settings=CONNECTED.settings.of_board(9))


@pytest.fixture
def line() -> ServerHarness:
    harness = ServerHarness()
    harness.server.report(GROUP)
    harness.server.report(OfBoard(9, NINTH))
    harness.join("alice")
    harness.join("watcher", Role.WATCH)
    return harness


def test_client_receives_reports_of_every_board_of_a_line(line: ServerHarness) -> None:
    first, second = line.received["watcher"][2:4]
    assert first.settings.group == (7, 9)
    assert second.number == 9
    assert second.report.occasion is ReadReason.OPENED
    line.server.report(OfBoard(9, Batch((), Counters())))
    assert line.received["watcher"][-1] == OfBoard(9, Batch((), Counters()))
    line.send("watcher", SetWatched(False))
    before = len(line.received["watcher"])
    line.server.report(OfBoard(9, Batch((), Counters())))
    assert len(line.received["watcher"]) == before


def test_driver_drives_each_board_of_a_line(line: ServerHarness) -> None:
    setpoint = ToBoard(9, SetMotor(1, Drive.at(-40)))
    line.send("watcher", AskLease(), setpoint)
    line.send("alice", setpoint)
    assert line.kinds() == []
    line.send("alice", AskLease(), Arm(), Stop(3), setpoint)
    assert line.session[-1] == setpoint
    line.send("alice", ToBoard(9, SetMotor(3, Drive.at(1))), ToBoard(5, setpoint.request))
    assert line.session[-1] == setpoint, "motor 3 and board 5 do not exist"
    line.send("alice", ToBoard(9, Arm()), ToBoard(9, Heartbeat()))
    assert line.session[-1] == setpoint, "only all boards are armed"
    line.send("watcher", ToBoard(9, Stop(4)))
    assert isinstance(line.session[-1], Stop), "a stop applies to all boards"


def test_late_client_receives_settings_of_other_boards(line: ServerHarness) -> None:
    line.send("alice", AskLease(), ToBoard(9, Write(7, (("serial_timeout", 5),))))
    forwarded: Any = line.session[-1]
    state = replace(STATE, parameters={"serial_timeout": 5})
    written = Written((), state, NINTH.settings)
    line.server.report(OfBoard(9, Outcome(forwarded.request.id, written)))
    assert line.received["alice"][-1] == OfBoard(9, Outcome(7, written))
    assert line.received["watcher"][-1].report.state == state
    line.join("late")
    assert line.received["late"][-1].report.state == state
    assert line.received["late"][2].state == STATE


# --- Permissions --------------------------------------------------------------------------

MOTOR_REQUESTS = (SetMotor(1, Drive.at(50)), SetAuxiliary(5), Arm(), Heartbeat())


@pytest.mark.parametrize("user", ["watcher", "bob"])
@pytest.mark.parametrize(
    "request_",
    [
        *MOTOR_REQUESTS,
        Write(1, (("serial_timeout", 5),)),
        Reload(1),
        packet(DriveMotor(1, Drive.at(50))),
        packet(SetParameter(4, 5)),
        SendPacket(1, RawPacket(Malformed(b"\xc1", ""))),
    ],
    ids=lambda request: type(request).__name__,
)
def test_only_the_driver_sends_motor_commands_and_writes(
    harness: ServerHarness, user: str, request_: object
) -> None:
    harness.send("alice", AskLease())
    harness.send(user, request_)
    assert harness.kinds() == []
    if hasattr(request_, "id"):
        error = harness.outcome(user).error
        expected = ErrorCode.MAY_NOT_DRIVE if user == "watcher" else ErrorCode.OTHER_DRIVES
        assert getattr(error, "code", None) is expected
    harness.send("alice", request_)
    assert harness.kinds() == [type(request_)]


@pytest.mark.parametrize("request_", [Stop(1), packet(GetSignature())], ids=["stop", "query"])
def test_every_client_sends_stops_and_queries(harness: ServerHarness, request_: object) -> None:
    harness.send("alice", AskLease())
    harness.send("watcher", request_)
    assert harness.kinds() == [type(request_)]


def test_watcher_receives_no_lease(harness: ServerHarness) -> None:
    harness.send("watcher", AskLease(), TakeLease(), *MOTOR_REQUESTS)
    assert harness.kinds() == []
    lease = harness.lease_of("watcher")
    assert (lease.driver, lease.may_drive, lease.may_take) == ("", False, False)


@pytest.mark.parametrize(
    "request_",
    [
        SetMotor(7, Drive.at(50)),
        SetMotor(1, Drive(Direction.FORWARD, 128)),
        SetMotors((SetMotor(1, Drive.at(5)), SetMotor(1, Drive.at(6)))),
        SetAuxiliary(-1),
    ],
)
def test_invalid_setpoint_is_rejected(harness: ServerHarness, request_: object) -> None:
    harness.send("alice", AskLease(), request_)
    assert harness.kinds() == []
    assert harness.server.refused == {"impossible setpoint": 1}


@pytest.mark.parametrize("request_", MOTOR_REQUESTS[:3], ids=lambda request: type(request).__name__)
def test_late_motor_request_is_discarded(harness: ServerHarness, request_: object) -> None:
    harness.send("alice", AskLease())
    harness.send("alice", request_, age=LEASE_TIMEOUT + 0.01)
    assert harness.kinds() == []
    harness.send("alice", Stop(1), age=60.0)
    assert harness.kinds() == [Stop], "a late stop is served"


def test_replayed_message_is_discarded(harness: ServerHarness) -> None:
    harness.send("alice", AskLease())
    old, new = (harness.message("alice", SetAuxiliary(speed)) for speed in (1, 2))
    for data in (new, old, new):
        harness.server.handle(harness.parties["alice"], data)
    assert harness.session[-1] == SetAuxiliary(2)
    assert harness.kinds() == [SetAuxiliary]
    assert harness.server.refused == {"replayed": 2}


def test_stop_overtakes_only_motor_requests(harness: ServerHarness) -> None:
    harness.send("alice", AskLease())
    late = [harness.message("alice", request) for request in (Arm(), SetAuxiliary(1), Reload(3))]
    stop = harness.message("alice", Stop(1))
    for data in (stop, *late, stop):
        harness.server.handle(harness.parties["alice"], data)
    assert harness.kinds() == [Stop, Reload]
    assert harness.server.refused == {"overtaken by a stop": 2, "replayed": 1}
    harness.send("alice", Arm())
    assert harness.kinds() == [Stop, Reload, Arm]


def test_stranger_large_and_malformed_messages_are_rejected(harness: ServerHarness) -> None:
    stranger = Party("id-alice", "mallory", Role.OWN)
    harness.server.handle(stranger, harness.message("alice", Stop(1)))
    harness.server.handle(harness.parties["alice"], b"\x00" * (MAX_REQUEST_SIZE + 1))
    harness.server.handle(harness.parties["alice"], b"\xc1")
    assert harness.kinds() == []
    assert harness.server.refused == {"unknown client": 1, "too large": 1, "malformed": 1}


def test_flood_from_one_user_does_not_delay_other_users(harness: ServerHarness) -> None:
    harness.send("alice", AskLease())
    for speed in range(2 * MAX_REQUESTS):
        harness.send("bob", SetAuxiliary(speed % 100))
    assert harness.kinds() == []
    assert harness.server.refused["too many"] > MAX_REQUESTS / 2
    harness.send("watcher", Stop(1))
    assert harness.kinds() == [Stop]
    harness.now += 1.0
    harness.send("bob", packet(GetSignature()))
    assert harness.kinds()[-1] is SendPacket


def test_stop_is_served_beside_a_flood_of_the_same_user(harness: ServerHarness) -> None:
    for speed in range(2 * MAX_REQUESTS):
        harness.send("bob", SetAuxiliary(speed % 100))
    harness.send("bob", Stop(1))
    assert harness.kinds() == [Stop]


def test_pending_stop_completes_later_stop_requests(harness: ServerHarness) -> None:
    for number in range(1, 6):
        harness.send("watcher", Stop(number), Stop(number))
    harness.send("bob", Stop(9))
    assert harness.kinds() == [Stop]
    harness.server.report(Outcome(harness.session[-1].id))
    outcomes = of_type(harness.received["watcher"], Outcome)
    assert [outcome.id for outcome in outcomes] == [1, 2, 3, 4, 5]
    assert harness.outcome("bob").id == 9


@pytest.mark.parametrize(
    "setpoint", [(Arm(), SetAuxiliary(5)), (packet(DriveMotor(1, Drive.at(50))),)]
)
def test_stop_after_a_setpoint_is_sent_again(
    harness: ServerHarness, setpoint: tuple[object, ...]
) -> None:
    harness.send("alice", AskLease(), Stop(1), *setpoint, Stop(2))
    assert harness.kinds() == [Stop, *map(type, setpoint), Stop]


@pytest.mark.parametrize(
    ("user", "job"), [("alice", Reload(5)), ("watcher", packet(GetSignature()))]
)
def test_client_has_one_pending_request_in_the_session(
    harness: ServerHarness, user: str, job: object
) -> None:
    harness.send(user, AskLease(), *[job] * 14)
    assert harness.kinds() == [type(job)]
    assert len(of_type(harness.received[user], Outcome)) == 14 - MAX_JOBS - 1
    harness.server.report(Outcome(harness.session[-1].id))
    assert harness.kinds() == [type(job)] * 2


def test_lost_lease_cancels_queued_requests(harness: ServerHarness) -> None:
    writes = [Write(number, (("serial_timeout", number),)) for number in (1, 2, 3)]
    harness.send("alice", AskLease(), *writes)
    harness.send("owner", TakeLease())
    (write,) = of_type(harness.session, Write)
    harness.server.report(Outcome(write.id))
    assert harness.kinds() == [Write, Stop], "the pending write continues"
    errors = [outcome.error for outcome in of_type(harness.received["alice"], Outcome)]
    codes = [getattr(error, "code", None) for error in errors]
    assert codes == [ErrorCode.OTHER_DRIVES] * 2 + [None]


@pytest.mark.parametrize(
    "request_",
    [
        ProbeNumber(1, 9, attempts=10**9),
        ProbeNumber(1, 9, attempts=-1),
        SendPacket(1, RawPacket(Malformed(b"\x84" * 200, ""))),
    ],
    ids=["endless", "negative", "long"],
)
def test_request_that_would_delay_a_stop_is_rejected(
    harness: ServerHarness, request_: object
) -> None:
    harness.send("alice", AskLease(), request_)
    assert harness.kinds() == []


def test_hello_is_not_replayed(harness: ServerHarness) -> None:
    hello = harness.message("alice", Hello(VERSION, "test"))
    harness.send("alice", AskLease())
    harness.server.handle(harness.parties["alice"], hello)
    assert harness.lease_of("alice").is_mine
    assert harness.server.refused == {"replayed": 1}


# --- Leases -------------------------------------------------------------------------------


def test_lease_without_heartbeats_ends_with_a_stop(harness: ServerHarness) -> None:
    harness.send("alice", AskLease(), Arm())
    for _ in range(20):
        harness.now += 0.1
        harness.send("alice", Alive())
        harness.server.step()
    assert harness.kinds() == [Arm]
    harness.now += LEASE_TIMEOUT - 0.001
    harness.server.step()
    assert harness.kinds() == [Arm]
    harness.now += 0.002
    harness.send("bob", Alive(), Heartbeat())
    harness.server.step()
    assert harness.kinds() == [Arm, Stop]
    harness.server.report(Outcome(harness.session[-1].id))
    assert harness.received["bob"][-1] == MotorsStopped(ErrorCode.LEASE_LOST, confirmed=True)
    assert harness.lease_of("bob").driver == ""
    harness.send("alice", Alive(), SetAuxiliary(5))
    assert harness.kinds() == [Arm, Stop], "a late heartbeat restores no lease"


def test_session_receives_heartbeats_without_the_time_of_the_client(harness: ServerHarness) -> None:
    harness.send("alice", AskLease(), Heartbeat(1e9))
    assert harness.session[-1] == Heartbeat()


def test_late_heartbeats_do_not_extend_a_lease(harness: ServerHarness) -> None:
    harness.send("alice", AskLease())
    for _ in range(6):
        harness.now += 0.1
        harness.send("alice", Alive(), age=LEASE_TIMEOUT + 0.1)
        harness.server.step()
    assert harness.kinds() == [Stop]


@pytest.mark.parametrize("end", [Leave(), ReturnLease()], ids=["leave", "return"])
def test_leaving_driver_causes_a_stop_at_once(harness: ServerHarness, end: object) -> None:
    harness.send("alice", AskLease(), Arm(), end)
    assert harness.kinds() == [Arm, Stop]
    harness.send("bob", AskLease(), Arm())
    assert harness.lease_of("bob").is_mine


def test_lost_connection_of_driver_causes_a_stop(harness: ServerHarness) -> None:
    harness.send("alice", AskLease(), Arm())
    harness.server.remove(harness.parties["bob"])
    assert harness.kinds() == [Arm]
    harness.server.remove(harness.parties["alice"])
    assert harness.kinds() == [Arm, Stop]


def test_driver_hands_lease_over_to_waiting_user(harness: ServerHarness) -> None:
    harness.send("alice", AskLease(), Arm())
    harness.send("bob", AskLease())
    assert harness.lease_of("alice").waiting == ("bob",)
    harness.send("bob", ReturnLease())
    assert harness.lease_of("alice").waiting == ()
    harness.send("bob", AskLease(), HandOver("bob"))
    assert harness.lease_of("alice").is_mine, "only the driver hands the lease over"
    harness.send("alice", HandOver("nobody"))
    assert harness.lease_of("alice").is_mine
    harness.send("alice", HandOver("bob"), SetAuxiliary(1))
    assert (harness.lease_of("bob").is_mine, harness.lease_of("bob").waiting) == (True, ())
    assert harness.kinds() == [Arm, Stop], "the motors stop before the next driver"
    harness.send("bob", Arm())
    assert harness.kinds() == [Arm, Stop, Arm]
    harness.server.report(Outcome(harness.session[-2].id))
    assert type(harness.received["alice"][-1]) is MotorsStopped
    assert type(harness.received["bob"][-1]) is not MotorsStopped, "bob has armed again"


def test_owner_takes_the_lease(harness: ServerHarness) -> None:
    harness.send("alice", AskLease(), Arm())
    harness.send("bob", TakeLease())
    assert harness.lease_of("bob").driver == "alice"
    harness.send("owner", TakeLease())
    assert harness.lease_of("alice").driver == "owner"
    assert harness.kinds() == [Arm, Stop]


class LossyNetwork:
    """Two drivers on a network that loses, delays and reorders messages in both directions.

    While a client assumes to have the lease, it sends heartbeats and setpoints ten times a second.
    """

    LOSS = 0.1
    DELAY = 0.05, 0.05  # mean and deviation, seconds

    def __init__(self, seed: int) -> None:
        self.chance = random.Random(seed)
        self.now = 10.0
        self.events: list[tuple[float, int, Callable[[], None]]] = []
        self._order = count()
        self.server = BoardServer("arm", self.on_session, self.on_sent, lambda: self.now)
        self.drivers = {user: SimulatedClient(self, user) for user in ("alice", "bob")}
        self.armed = ""  # user who armed the motors
        self.moves = 0

    def schedule(self, seconds: float, action: Callable[[], None]) -> None:
        heapq.heappush(self.events, (self.now + seconds, next(self._order), action))

    def deliver(self, action: Callable[[], None]) -> None:
        if self.chance.random() >= self.LOSS:
            self.schedule(max(0.0, self.chance.gauss(*self.DELAY)), action)

    def on_sent(self, party: Party, message: bytes) -> None:
        self.deliver(lambda: self.drivers[party.user].receive(message))

    def on_session(self, request: object) -> None:
        holder = self.server.lease.holder
        match request:
            case Stop():
                self.armed = ""
            case Arm():
                assert holder is not None
                assert self.server.lease.seconds_left(self.now) > -1e-9
                assert self.armed in {"", holder.user}, "both clients drive"
                self.armed = holder.user
            case SetMotor(drive=drive):
                assert holder is not None
                assert self.server.lease.seconds_left(self.now) > -1e-9
                assert drive.speed == self.drivers[holder.user].speed, "setpoint of other client"
                self.moves += bool(self.armed)

    def run_until(self, number: int) -> None:
        """Run until the lease has this number."""
        end = self.now + 60 * (number - self.server.lease.number)
        while self.server.lease.number < number:
            assert self.now < end, "the lease has no new holder"
            due, _, action = heapq.heappop(self.events)
            self.now = max(self.now, due)
            self.server.step()
            action()


class SimulatedClient:
    def __init__(self, network: LossyNetwork, user: str) -> None:
        self.network, self.user = network, user
        self.speed = 10 if user == "alice" else 20
        self.party = Party(f"id-{user}", user, Role.OWN)
        self._counter = count(1)
        self._seen = 0.0
        self._has_lease = False
        self.hello()
        network.schedule(0.0, self.step)

    def hello(self) -> None:
        self.send(Hello(VERSION, "test"))

    def send(self, request: Any) -> None:
        network = self.network
        data = encode_request(request, next(self._counter), self._seen, network.now)
        network.deliver(lambda: network.server.handle(self.party, data))

    def receive(self, message: bytes) -> None:
        (_, time, _), report = decode_report(message, 3)
        self._seen = max(self._seen, time)
        if isinstance(report, LeaseChanged):
            self._has_lease = report.is_mine

    def step(self) -> None:
        chance = self.network.chance
        self.send(Alive())
        if self._has_lease:
            self.send(Arm())
            self.send(SetMotor(1, Drive.at(self.speed)))
        roll = chance.random()
        if roll < 0.3:
            other = "bob" if self.user == "alice" else "alice"
            requests = AskLease(), TakeLease(), HandOver(other), ReturnLease(), Leave(), Stop(0)
            self.send(chance.choice(requests))
        if roll < 0.05:
            self.hello()
        pause = chance.choice((0.1, 0.1, 0.1, 0.1, 0.7))
        self.network.schedule(pause, self.step)


def test_two_drivers_never_drive_at_once(request: pytest.FixtureRequest) -> None:
    """`LossyNetwork` checks each request to the session."""
    network = LossyNetwork(seed=request.config.getoption("randomly_seed", 1))
    network.run_until(500)
    assert network.moves > 100
    assert network.server.refused["replayed"] > 10
