"""Server of a board: permissions of users, and the lease."""

import heapq
import random
from collections.abc import Callable
from dataclasses import replace
from itertools import count
from typing import Any

import pytest

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


class ServedDriver:
    """A server, its clients, and the requests to the session."""

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
        return [type(one) for one in self.session if not isinstance(one, SetWatched)]

    def lease_of(self, user: str) -> LeaseChanged:
        return [one for one in self.received[user] if isinstance(one, LeaseChanged)][-1]

    def outcome(self, user: str) -> Outcome:
        (found,) = (one for one in self.received[user] if isinstance(one, Outcome))
        return found


@pytest.fixture
def served() -> ServedDriver:
    driver = ServedDriver()
    driver.server.report(CONNECTED)
    driver.join("alice")
    driver.join("bob")
    driver.join("watcher", Role.WATCH)
    driver.join("owner", Role.OWN)
    return driver


def packet(command: Command[Any]) -> SendPacket:
    return SendPacket(5, RawPacket(Malformed(Framing(None, None).encode(command), "")))


# --- Clients ------------------------------------------------------------------------------


def test_new_client_learns_of_board_and_driver(served: ServedDriver) -> None:
    served.send("alice", AskLease())
    served.server.report(NotResponding("no reply", Counters()))
    served.join("late")
    welcome, lease, board, silence = served.received["late"]
    assert welcome == Welcome("arm")
    assert (lease.driver, lease.is_mine) == ("alice", False)
    assert board.occasion is ReadReason.OPENED, "its line was opened just now"
    assert isinstance(silence, NotResponding)


def test_client_of_another_version_is_refused(served: ServedDriver) -> None:
    served.join("old", version=VERSION + 1)
    (refusal,) = served.received["old"]
    assert isinstance(refusal, Refused)
    served.send("old", Stop(1))
    assert served.kinds() == []


def test_client_learns_that_the_board_is_not_connected(served: ServedDriver) -> None:
    served.server.end(NoReply("no board"), may_move=False)
    served.join("late")
    closed = served.received["late"][-1]
    assert isinstance(closed, Closed)
    assert str(closed.error) == "no board"


def test_outcome_goes_to_the_client_that_waits(served: ServedDriver) -> None:
    served.send("alice", packet(GetSignature()))
    served.send("bob", packet(GetSignature()))
    first, second = (one.id for one in served.session if isinstance(one, SendPacket))
    assert first != second
    served.server.report(Outcome(second))
    assert served.outcome("bob").id == 5
    assert not any(isinstance(one, Outcome) for one in served.received["alice"])


def test_written_settings_are_reported_to_other_clients(served: ServedDriver) -> None:
    served.send("alice", AskLease(), Write(7, (("serial_timeout", 5),)))
    state = replace(STATE, parameters={"serial_timeout": 5})
    served.server.report(Outcome(served.session[-1].id, Written((), state, CONNECTED.settings)))
    assert served.received["bob"][-1].state == state
    assert served.received["bob"][-1].occasion is ReadReason.RELOADED
    assert isinstance(served.received["alice"][-1], Outcome)
    served.join("late")
    assert served.received["late"][-1].state == state


def speeds_of(served: ServedDriver, user: str) -> tuple[int, int, int]:
    served.server.report(Batch((), Counters()))
    found = [one for one in served.received[user] if isinstance(one, SetpointsChanged)]
    return found[-1].speeds


@pytest.mark.parametrize(
    "end",
    [
        lambda served: served.send("watcher", Stop(4)),
        lambda served: served.send("alice", ReturnLease()),
        lambda served: served.server.stop(lambda _: None),
        lambda served: served.server.report(MotorsStopped(ErrorCode.NO_HEARTBEAT, True)),
    ],
    ids=["stop of a watcher", "lease returned", "stop of a command", "stopped by the session"],
)
def test_watchers_see_the_setpoints_of_the_driver(
    served: ServedDriver, end: Callable[[ServedDriver], object]
) -> None:
    served.send("alice", AskLease(), Arm(), SetMotor(1, Drive.at(-40)), SetAuxiliary(90))
    assert speeds_of(served, "watcher") == (-40, 0, 90)
    served.server.report(CONNECTED)
    served.join("late")
    assert SetpointsChanged((-40, 0, 90)) in served.received["late"]
    end(served)
    assert speeds_of(served, "watcher") == (0, 0, 0)


def test_rate_is_full_while_somebody_watches(served: ServedDriver) -> None:
    for user in served.parties:
        served.send(user, SetWatched(False))
    assert served.session[-1] == SetWatched(False)
    served.send("bob", SetWatched(True))
    assert served.session[-1] == SetWatched(True)
    before = len(served.received["alice"])
    served.server.report(Batch((), Counters()))
    assert type(served.received["bob"][-1]) is Batch
    assert len(served.received["alice"]) == before, "samples are for who watches"
    served.server.report(Traffic(()))
    kinds = [type(one) for one in served.received["bob"]]
    assert kinds[-1] is Batch, "and bytes for who wants them"
    served.send("bob", SetWatched(True, traffic=True))
    served.server.report(Traffic(()))
    assert type(served.received["bob"][-1]).__name__ == "Traffic"


def test_silent_client_is_removed(served: ServedDriver) -> None:
    for _ in range(60):
        served.now += 0.1
        served.send("bob", Alive())
        served.server.step()
    assert served.server.users == ("bob",)


# --- Several boards -----------------------------------------------------------------------

GROUP = replace(CONNECTED, settings=CONNECTED.settings.with_group((7, 9)))
NINTH = replace(CONNECTED, settings=CONNECTED.settings.of_board(9))


@pytest.fixture
def line() -> ServedDriver:
    driver = ServedDriver()
    driver.server.report(GROUP)
    driver.server.report(OfBoard(9, NINTH))
    driver.join("alice")
    driver.join("watcher", Role.WATCH)
    return driver


def test_client_learns_of_every_board_of_a_line(line: ServedDriver) -> None:
    first, other = line.received["watcher"][2:4]
    assert first.settings.group == (7, 9)
    assert other.number == 9
    assert other.report.occasion is ReadReason.OPENED
    line.server.report(OfBoard(9, Batch((), Counters())))
    assert line.received["watcher"][-1] == OfBoard(9, Batch((), Counters()))
    line.send("watcher", SetWatched(False))
    before = len(line.received["watcher"])
    line.server.report(OfBoard(9, Batch((), Counters())))
    assert len(line.received["watcher"]) == before


def test_driver_drives_each_board_of_a_line(line: ServedDriver) -> None:
    setpoint = ToBoard(9, SetMotor(1, Drive.at(-40)))
    line.send("watcher", AskLease(), setpoint)
    line.send("alice", setpoint)
    assert line.kinds() == []
    line.send("alice", AskLease(), Arm(), setpoint)
    assert line.session[-1] == setpoint
    line.send("alice", ToBoard(9, SetMotor(3, Drive.at(1))), ToBoard(5, setpoint.request))
    assert line.session[-1] == setpoint, "no such motor, no such board"
    line.send("watcher", ToBoard(9, Stop(4)))
    assert isinstance(line.session[-1], Stop), "it is for all"


def test_late_client_receives_settings_of_other_boards(line: ServedDriver) -> None:
    line.send("alice", AskLease(), ToBoard(9, Write(7, (("serial_timeout", 5),))))
    job: Any = line.session[-1]
    state = replace(STATE, parameters={"serial_timeout": 5})
    written = Written((), state, NINTH.settings)
    line.server.report(OfBoard(9, Outcome(job.request.id, written)))
    assert line.received["alice"][-1] == OfBoard(9, Outcome(7, written))
    assert line.received["watcher"][-1].report.state == state
    line.join("late")
    assert line.received["late"][-1].report.state == state
    assert line.received["late"][2].state == STATE


# --- Permissions --------------------------------------------------------------------------

MOVING = (SetMotor(1, Drive.at(50)), SetAuxiliary(5), Arm(), Heartbeat())


@pytest.mark.parametrize("user", ["watcher", "bob"])
@pytest.mark.parametrize(
    "request_",
    [
        *MOVING,
        Write(1, (("serial_timeout", 5),)),
        Reload(1),
        packet(DriveMotor(1, Drive.at(50))),
        packet(SetParameter(4, 5)),
        SendPacket(1, RawPacket(Malformed(b"\xc1", ""))),
    ],
    ids=lambda one: type(one).__name__,
)
def test_only_the_driver_moves_and_changes(
    served: ServedDriver, user: str, request_: object
) -> None:
    served.send("alice", AskLease())
    served.send(user, request_)
    assert served.kinds() == []
    if hasattr(request_, "id"):
        error = served.outcome(user).error
        wanted = ErrorCode.MAY_NOT_DRIVE if user == "watcher" else ErrorCode.OTHER_DRIVES
        assert getattr(error, "code", None) is wanted
    served.send("alice", request_)
    assert served.kinds() == [type(request_)]


@pytest.mark.parametrize("request_", [Stop(1), packet(GetSignature())], ids=["stop", "query"])
def test_every_client_stops_and_asks(served: ServedDriver, request_: object) -> None:
    served.send("alice", AskLease())
    served.send("watcher", request_)
    assert served.kinds() == [type(request_)]


def test_watcher_gets_no_lease(served: ServedDriver) -> None:
    served.send("watcher", AskLease(), TakeLease(), *MOVING)
    assert served.kinds() == []
    lease = served.lease_of("watcher")
    assert (lease.driver, lease.may_drive, lease.may_take) == ("", False, False)


@pytest.mark.parametrize(
    "request_",
    [SetMotor(7, Drive.at(50)), SetMotor(1, Drive(Direction.FORWARD, 128)), SetAuxiliary(-1)],
)
def test_impossible_setpoint_is_refused(served: ServedDriver, request_: object) -> None:
    served.send("alice", AskLease(), request_)
    assert served.kinds() == []
    assert served.server.refused == {"impossible setpoint": 1}


@pytest.mark.parametrize("request_", MOVING[:3], ids=lambda one: type(one).__name__)
def test_command_that_is_late_moves_nothing(served: ServedDriver, request_: object) -> None:
    served.send("alice", AskLease())
    served.send("alice", request_, age=LEASE_TIMEOUT + 0.01)
    assert served.kinds() == []
    served.send("alice", Stop(1), age=60.0)
    assert served.kinds() == [Stop], "a stop is never too late"


def test_message_counts_once_and_in_order(served: ServedDriver) -> None:
    served.send("alice", AskLease())
    old, new = (served.message("alice", SetAuxiliary(speed)) for speed in (1, 2))
    for data in (new, old, new):
        served.server.handle(served.parties["alice"], data)
    assert served.session[-1] == SetAuxiliary(2)
    assert served.kinds() == [SetAuxiliary]
    assert served.server.refused == {"replayed": 2}


def test_stop_overtakes_motor_commands_and_nothing_else(served: ServedDriver) -> None:
    served.send("alice", AskLease())
    late = [served.message("alice", one) for one in (Arm(), SetAuxiliary(1), Reload(3))]
    stop = served.message("alice", Stop(1))
    for data in (stop, *late, stop):
        served.server.handle(served.parties["alice"], data)
    assert served.kinds() == [Stop, Reload]
    assert served.server.refused == {"overtaken by a stop": 2, "replayed": 1}
    served.send("alice", Arm())
    assert served.kinds() == [Stop, Reload, Arm]


def test_strangers_and_large_messages_are_refused(served: ServedDriver) -> None:
    stranger = Party("id-alice", "mallory", Role.OWN)
    served.server.handle(stranger, served.message("alice", Stop(1)))
    served.server.handle(served.parties["alice"], b"\x00" * (MAX_REQUEST_SIZE + 1))
    served.server.handle(served.parties["alice"], b"\xc1")
    assert served.kinds() == []
    assert served.server.refused == {"unknown client": 1, "too large": 1, "malformed": 1}


def test_flood_of_one_user_costs_the_others_nothing(served: ServedDriver) -> None:
    served.send("alice", AskLease())
    for speed in range(2 * MAX_REQUESTS):
        served.send("bob", SetAuxiliary(speed % 100))
    assert served.kinds() == []
    assert served.server.refused["too many"] > MAX_REQUESTS / 2
    served.send("alice", Stop(1))
    served.send("watcher", Stop(1))
    assert Stop in served.kinds()
    served.now += 1.0
    served.send("bob", packet(GetSignature()))
    assert served.kinds()[-1] is SendPacket


def test_pending_stop_serves_who_stops_meanwhile(served: ServedDriver) -> None:
    for number in range(1, 6):
        served.send("watcher", Stop(number))
    served.send("bob", Stop(9))
    assert served.kinds() == [Stop]
    served.server.report(Outcome(served.session[-1].id))
    ids = [one.id for one in served.received["watcher"] if isinstance(one, Outcome)]
    assert ids == [1, 2, 3, 4, 5]
    assert served.outcome("bob").id == 9


def test_stop_behind_a_setpoint_is_sent_again(served: ServedDriver) -> None:
    served.send("alice", AskLease(), Stop(1), Arm(), SetAuxiliary(5), Stop(2))
    assert served.kinds() == [Stop, Arm, SetAuxiliary, Stop]


def test_stop_behind_a_typed_motor_command_is_sent_again(served: ServedDriver) -> None:
    served.send("alice", AskLease(), Stop(1), packet(DriveMotor(1, Drive.at(50))), Stop(2))
    assert served.kinds() == [Stop, SendPacket, Stop]


def test_client_has_one_request_in_flight(served: ServedDriver) -> None:
    served.send("alice", AskLease(), *(Reload(number) for number in range(1, 15)))
    assert served.kinds() == [Reload]
    rejected = [one for one in served.received["alice"] if isinstance(one, Outcome)]
    assert len(rejected) == 14 - MAX_JOBS - 1
    served.server.report(Outcome(served.session[-1].id))
    assert served.kinds() == [Reload, Reload]


def test_requests_of_a_former_driver_end_with_its_lease(served: ServedDriver) -> None:
    writes = [Write(number, (("serial_timeout", number),)) for number in (1, 2, 3)]
    served.send("alice", AskLease(), *writes)
    served.send("owner", TakeLease())
    (write,) = (one for one in served.session if isinstance(one, Write))
    served.server.report(Outcome(write.id))
    assert served.kinds() == [Write, Stop], "what was in flight is written to its end"
    errors = [one.error for one in served.received["alice"] if isinstance(one, Outcome)]
    assert [getattr(one, "code", None) for one in errors] == [ErrorCode.OTHER_DRIVES] * 2 + [None]


@pytest.mark.parametrize(
    "request_",
    [
        ProbeNumber(1, 9, attempts=10**9),
        ProbeNumber(1, 9, attempts=-1),
        SendPacket(1, RawPacket(Malformed(b"\x84" * 200, ""))),
    ],
    ids=["endless", "negative", "long"],
)
def test_request_that_would_hold_up_a_stop_is_refused(
    served: ServedDriver, request_: object
) -> None:
    served.send("alice", AskLease(), request_)
    assert served.kinds() == []


def test_hello_is_not_replayed(served: ServedDriver) -> None:
    hello = served.message("alice", Hello(VERSION, "test"))
    served.send("alice", AskLease())
    served.server.handle(served.parties["alice"], hello)
    assert served.lease_of("alice").is_mine
    assert served.server.refused == {"replayed": 1}


# --- The lease ----------------------------------------------------------------------------


def test_lease_ends_without_heartbeats_and_motors_are_stopped(served: ServedDriver) -> None:
    served.send("alice", AskLease(), Arm())
    for _ in range(20):
        served.now += 0.1
        served.send("alice", Alive())
        served.server.step()
    assert served.kinds() == [Arm]
    served.now += LEASE_TIMEOUT - 0.001
    served.server.step()
    assert served.kinds() == [Arm]
    served.now += 0.002
    served.server.step()
    assert served.kinds() == [Arm, Stop]
    served.server.report(Outcome(served.session[-1].id))
    assert served.received["bob"][-1] == MotorsStopped(ErrorCode.LEASE_LOST, confirmed=True)
    assert served.lease_of("bob").driver == ""
    served.send("alice", Alive(), SetAuxiliary(5))
    assert served.kinds() == [Arm, Stop], "a late heartbeat brings no lease back"


def test_old_heartbeats_do_not_keep_a_lease(served: ServedDriver) -> None:
    served.send("alice", AskLease())
    for _ in range(6):
        served.now += 0.1
        served.send("alice", Alive(), age=LEASE_TIMEOUT + 0.1)
        served.server.step()
    assert served.kinds() == [Stop]


@pytest.mark.parametrize("end", [Leave(), ReturnLease()], ids=lambda one: type(one).__name__)
def test_driver_that_leaves_is_stopped_at_once(served: ServedDriver, end: object) -> None:
    served.send("alice", AskLease(), Arm(), end)
    assert served.kinds() == [Arm, Stop]
    served.send("bob", AskLease(), Arm())
    assert served.lease_of("bob").is_mine


def test_connection_that_ends_stops_its_driver(served: ServedDriver) -> None:
    served.send("alice", AskLease(), Arm())
    served.server.remove(served.parties["bob"])
    assert served.kinds() == [Arm]
    served.server.remove(served.parties["alice"])
    assert served.kinds() == [Arm, Stop]


def test_lease_is_handed_over_to_who_waits(served: ServedDriver) -> None:
    served.send("alice", AskLease(), Arm())
    served.send("bob", AskLease())
    assert served.lease_of("alice").waiting == ("bob",)
    served.send("bob", HandOver("bob"))
    assert served.lease_of("alice").is_mine, "only its holder hands it over"
    served.send("alice", HandOver("nobody"))
    assert served.lease_of("alice").is_mine
    served.send("alice", HandOver("bob"), SetAuxiliary(1))
    assert served.lease_of("bob").is_mine
    assert served.kinds() == [Arm, Stop], "motors of one driver stop before the next"
    served.send("bob", Arm())
    assert served.kinds() == [Arm, Stop, Arm]
    served.server.report(Outcome(served.session[-2].id))
    assert type(served.received["alice"][-1]) is MotorsStopped
    assert type(served.received["bob"][-1]) is not MotorsStopped, "it has armed them since"


def test_owner_takes_the_lease(served: ServedDriver) -> None:
    served.send("alice", AskLease(), Arm())
    served.send("bob", TakeLease())
    assert served.lease_of("bob").driver == "alice"
    served.send("owner", TakeLease())
    assert served.lease_of("alice").driver == "owner"
    assert served.kinds() == [Arm, Stop]


class LossyNetwork:
    """Two drivers on a network that loses, delays and reorders messages both ways.

    Each sends a heartbeat ten times a second while it believes to drive, and setpoints.
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
        self.armed = ""  # who armed the motors, if they are
        self.handovers = 0
        self.moves = 0

    def later(self, seconds: float, action: Callable[[], None]) -> None:
        heapq.heappush(self.events, (self.now + seconds, next(self._order), action))

    def carry(self, action: Callable[[], None]) -> None:
        if self.chance.random() >= self.LOSS:
            self.later(max(0.0, self.chance.gauss(*self.DELAY)), action)

    def on_sent(self, party: Party, message: bytes) -> None:
        self.carry(lambda: self.drivers[party.user].receive(message))

    def on_session(self, request: object) -> None:
        holder = self.server.lease.holder
        match request:
            case Stop():
                self.armed = ""
            case Arm():
                assert holder is not None
                assert self.server.lease.seconds_left(self.now) > -1e-9
                assert self.armed in {"", holder.user}, "two drive at once"
                self.armed = holder.user
            case SetMotor(drive=drive):
                assert holder is not None
                assert self.server.lease.seconds_left(self.now) > -1e-9
                assert drive.speed == self.drivers[holder.user].speed, "a setpoint of another one"
                self.moves += bool(self.armed)

    def run_until(self, handovers: int) -> None:
        numbers = {self.server.lease.number}
        while self.server.lease.number < handovers:
            due, _, action = heapq.heappop(self.events)
            self.now = max(self.now, due)
            self.server.step()
            action()
            numbers.add(self.server.lease.number)
        self.handovers = len(numbers)


class SimulatedClient:
    def __init__(self, network: LossyNetwork, user: str) -> None:
        self.network, self.user = network, user
        self.speed = 10 if user == "alice" else 20
        self.party = Party(f"id-{user}", user, Role.OWN)
        self._counter = count(1)
        self._seen = 0.0
        self._drives = False
        self.hello()
        network.later(0.0, self.step)

    def hello(self) -> None:
        self.send(Hello(VERSION, "test"))

    def send(self, request: Any) -> None:
        network = self.network
        data = encode_request(request, next(self._counter), self._seen, network.now)
        network.carry(lambda: network.server.handle(self.party, data))

    def receive(self, message: bytes) -> None:
        (_, time, _), report = decode_report(message, 3)
        self._seen = max(self._seen, time)
        if isinstance(report, LeaseChanged):
            self._drives = report.is_mine

    def step(self) -> None:
        chance = self.network.chance
        self.send(Alive())
        if self._drives:
            self.send(Arm())
            self.send(SetMotor(1, Drive.at(self.speed)))
        roll = chance.random()
        if roll < 0.3:
            other = "bob" if self.user == "alice" else "alice"
            acts = AskLease(), TakeLease(), HandOver(other), ReturnLease(), Leave(), Stop(0)
            self.send(chance.choice(acts))
        if roll < 0.05:
            self.hello()
        pause = chance.choice((0.1, 0.1, 0.1, 0.1, 0.7))
        self.network.later(pause, self.step)


def test_two_drivers_never_drive_at_once(request: pytest.FixtureRequest) -> None:
    """`LossyNetwork` checks each request."""
    network = LossyNetwork(seed=request.config.getoption("randomly_seed", 1))
    network.run_until(500)
    assert network.moves > 100
    assert network.server.refused["replayed"] > 10
