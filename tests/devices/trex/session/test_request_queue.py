"""Queue of requests to a line."""

from collections import deque

from hypothesis import given
from hypothesis import strategies as st

from tests.devices.trex.session.helpers import packet
from tests.support.matrix import examples
from trex_gui.core.errors import BadRequest
from trex_gui.core.session import Close, Outcome
from trex_gui.core.timing import Timeouts
from trex_gui.devices.trex.driving.motor_output import MotorOutput
from trex_gui.devices.trex.driving.requests import (
    Arm,
    SetAuxiliary,
    SetMotor,
    SetMotors,
    Stop,
    packets,
)
from trex_gui.devices.trex.driving.setpoints import SetpointSlots
from trex_gui.devices.trex.protocol.commands import DriveAuxiliary, DriveBoth, DriveMotor, GetMode
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.session.messages import Reload, Request, SetReconnectCandidates, Write
from trex_gui.devices.trex.session.reconnecting import LivenessMonitor
from trex_gui.devices.trex.session.request_queue import BoardQueue, TrexRequestQueue

modest = examples(40)


class FixedInbox:
    """An inbox that holds some requests."""

    def __init__(self, *requests: Request) -> None:
        self.requests = deque(requests)
        self.waits: list[float] = []

    def get(self, seconds: float) -> Request | None:
        self.waits.append(seconds)
        return self.requests.popleft() if self.requests else None


class Queue(TrexRequestQueue):
    """A queue and a motor output at time 0."""

    def __init__(self, *requests: Request) -> None:
        self.bag = FixedInbox(*requests)
        self.outcomes: list[Outcome] = []
        self.motors = MotorOutput(lambda _report: None)
        self.liveness = LivenessMonitor(Timeouts())
        board = BoardQueue(self.motors, self.liveness, self.outcomes.append, lambda: 0.0)
        self.jobs = board.jobs
        super().__init__(self.bag, {None: board})


def collected(*requests: Request) -> Queue:
    queue = Queue(*requests)
    queue.collect()
    return queue


# --- Slots ------------------------------------------------------------------------------


def test_setpoints_of_same_kind_share_one_packet() -> None:
    slots = SetpointSlots()
    slots.put(SetMotor(2, Drive.brake(5), accelerate=True))
    slots.put(SetMotor(1, Drive.at(-10), accelerate=True))
    assert packets(slots.pop()) == [DriveBoth(Drive.at(-10), Drive.brake(5), accelerate=True)]


def test_requeued_setpoint_does_not_replace_newer_one() -> None:
    slots = SetpointSlots()
    damaged: list[SetMotor | SetAuxiliary] = [
        SetMotor(1, Drive.at(1)),
        SetMotor(2, Drive.at(1)),
        SetAuxiliary(1),
    ]
    newer: list[SetMotor | SetAuxiliary] = [SetMotor(1, Drive.at(9)), SetAuxiliary(0)]
    for setpoint in newer:
        slots.put(setpoint)
    slots.put_back(damaged)
    assert slots.pop() == [newer[0], damaged[1], newer[1]]


all_setpoints = st.one_of(
    st.builds(
        SetMotor,
        st.sampled_from([1, 2]),
        st.builds(Drive.at, st.integers(-127, 127)),
        st.booleans(),
    ),
    st.builds(SetAuxiliary, st.integers(0, 127), st.booleans()),
)


@modest
@given(st.lists(all_setpoints, max_size=20))
def test_packets_contain_newest_setpoint_of_each_motor(
    given_setpoints: list[SetMotor | SetAuxiliary],
) -> None:
    slots = SetpointSlots()
    newest: dict[int, object] = {}
    for setpoint in given_setpoints:
        slots.put(setpoint)
        newest[setpoint.motor if isinstance(setpoint, SetMotor) else 0] = setpoint
    sent: dict[int, object] = {}
    for command in packets(slots.pop()):
        match command:
            case DriveBoth(first, second, accelerate):
                sent[1] = SetMotor(1, first, accelerate)
                sent[2] = SetMotor(2, second, accelerate)
            case DriveMotor(motor, drive, accelerate):
                sent[motor] = SetMotor(motor, drive, accelerate)
            case DriveAuxiliary(speed, accelerate):
                sent[0] = SetAuxiliary(speed, accelerate)
    assert sent == newest


# --- Queue ------------------------------------------------------------------------------


def test_newest_setpoint_wins_with_two_motor_messages() -> None:
    both = SetMotors((SetMotor(1, Drive.at(9)), SetMotor(2, Drive.at(-9))))
    older, newer = SetMotor(2, Drive.at(50)), SetMotor(1, Drive.at(7))
    setpoints = collected(older, both, newer).motors.setpoints.pop()
    assert setpoints == [newer, SetMotor(2, Drive.at(-9))]
    assert not collected(both, Stop(1)).motors.setpoints


def test_stops_are_queued_separately_and_taken_once() -> None:
    queue = collected(Reload(1), Stop(2), Stop(3))
    assert queue.motors.pop_stops() == [Stop(2), Stop(3)]
    assert queue.motors.pop_stops() == []


def test_stop_discards_later_setpoints_until_armed() -> None:
    setpoint = SetMotor(2, Drive.at(5))
    assert not collected(SetMotor(1, Drive.at(9)), Stop(1), setpoint).motors.setpoints
    queue = collected(SetMotor(1, Drive.at(9)), Stop(1), SetAuxiliary(9), Arm(), setpoint)
    assert queue.motors.setpoints.pop() == [SetMotor(2, Drive.at(5))]


def test_collect_waits_only_for_first_request() -> None:
    queue = Queue(Reload(1), Reload(2))
    queue.collect(0.5)
    assert queue.bag.waits == [0.5, 0.0, 0.0]
    queue.collect(-1.0)
    assert queue.bag.waits[3:] == [0.0]


def test_close_keeps_pending_jobs() -> None:
    queue = collected(Reload(1), Close(), Reload(2))
    assert queue.is_closing
    assert queue.abandon() == [1, 2]


def test_close_discards_earlier_and_later_setpoints() -> None:
    before, after = SetMotor(1, Drive.at(9)), SetAuxiliary(9)
    assert not collected(before, Close(), after).motors.setpoints


def test_abandon_returns_each_request_once() -> None:
    queue = collected(
        packet(1, GetMode()), Stop(2), SetMotor(1, Drive.at(1)), Write(3), Reload(4), Stop(5)
    )
    assert sorted(queue.abandon()) == [1, 2, 3, 4, 5]
    assert queue.abandon() == []
    assert not queue.motors.setpoints


def test_motor_command_overtaken_by_stop_is_rejected() -> None:
    queue = collected(packet(1, GetMode()), packet(2, DriveMotor(1, Drive.at(9))), Stop(3))
    assert [job.id for job in queue.jobs] == [1]
    (outcome,) = queue.outcomes
    assert outcome.id == 2
    assert isinstance(outcome.error, BadRequest)


def test_last_reconnect_candidates_replace_earlier_ones() -> None:
    here, there = ConnectionSettings("here"), ConnectionSettings("there")
    assert collected().liveness.candidates == ()
    first = SetReconnectCandidates((here,))
    queue = collected(first, Stop(1), SetReconnectCandidates((there, here)))
    assert queue.liveness.candidates == (there, here)
    assert collected(first, SetReconnectCandidates(())).liveness.candidates == ()
