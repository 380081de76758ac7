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
    """Inbox with given requests."""

    def __init__(self, *requests: Request) -> None:
        self.requests = deque(requests)
        self.waits: list[float] = []

    def get(self, seconds: float) -> Request | None:
        self.waits.append(seconds)
        return self.requests.popleft() if self.requests else None


class QueueHarness(TrexRequestQueue):
    """Request queue and motor output at time 0."""

    def __init__(self, *requests: Request) -> None:
        self.inbox = FixedInbox(*requests)
        self.outcomes: list[Outcome] = []
        self.motors = MotorOutput(lambda _report: None)
        self.liveness = LivenessMonitor(Timeouts())
        board = BoardQueue(self.motors, self.liveness, self.outcomes.append, lambda: 0.0)
        self.jobs = board.jobs
        super().__init__(self.inbox, {None: board})


def collect(*requests: Request) -> QueueHarness:
    """Return a queue that has collected requests."""
    queue = QueueHarness(*requests)
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
    requeued: list[SetMotor | SetAuxiliary] = [
        SetMotor(1, Drive.at(1)),
        SetMotor(2, Drive.at(1)),
        SetAuxiliary(1),
    ]
    newer: list[SetMotor | SetAuxiliary] = [SetMotor(1, Drive.at(9)), SetAuxiliary(0)]
    for setpoint in newer:
        slots.put(setpoint)
    slots.put_back(requeued)
    assert slots.pop() == [newer[0], requeued[1], newer[1]]


any_setpoint = st.one_of(
    st.builds(
        SetMotor,
        st.sampled_from([1, 2]),
        st.builds(Drive.at, st.integers(-127, 127)),
        st.booleans(),
    ),
    st.builds(SetAuxiliary, st.integers(0, 127), st.booleans()),
)


@modest
@given(st.lists(any_setpoint, max_size=20))
def test_packets_contain_newest_setpoint_of_each_motor(
    setpoints: list[SetMotor | SetAuxiliary],
) -> None:
    slots = SetpointSlots()
    newest: dict[int, object] = {}
    for setpoint in setpoints:
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


def test_newest_setpoint_replaces_part_of_two_motor_request() -> None:
    both = SetMotors((SetMotor(1, Drive.at(9)), SetMotor(2, Drive.at(-9))))
    older, newer = SetMotor(2, Drive.at(50)), SetMotor(1, Drive.at(7))
    setpoints = collect(older, both, newer).motors.setpoints.pop()
    assert setpoints == [newer, SetMotor(2, Drive.at(-9))]
    assert not collect(both, Stop(1)).motors.setpoints


def test_stops_are_queued_separately_and_returned_once() -> None:
    queue = collect(Reload(1), Stop(2), Stop(3))
    assert queue.motors.pop_stops() == [Stop(2), Stop(3)]
    assert queue.motors.pop_stops() == []


def test_stop_discards_later_setpoints_until_armed() -> None:
    setpoint = SetMotor(2, Drive.at(5))
    assert not collect(SetMotor(1, Drive.at(9)), Stop(1), setpoint).motors.setpoints
    queue = collect(SetMotor(1, Drive.at(9)), Stop(1), SetAuxiliary(9), Arm(), setpoint)
    assert queue.motors.setpoints.pop() == [SetMotor(2, Drive.at(5))]


def test_collect_waits_only_for_first_request() -> None:
    queue = QueueHarness(Reload(1), Reload(2))
    queue.collect(0.5)
    assert queue.inbox.waits == [0.5, 0.0, 0.0]
    queue.collect(-1.0)
    assert queue.inbox.waits[3:] == [0.0]


def test_close_keeps_pending_jobs() -> None:
    queue = collect(Reload(1), Close(), Reload(2))
    assert queue.is_closing
    assert queue.abandon() == [1, 2]


def test_close_discards_earlier_and_later_setpoints() -> None:
    before, after = SetMotor(1, Drive.at(9)), SetAuxiliary(9)
    assert not collect(before, Close(), after).motors.setpoints


def test_abandon_returns_each_request_once() -> None:
    queue = collect(
        packet(1, GetMode()), Stop(2), SetMotor(1, Drive.at(1)), Write(3), Reload(4), Stop(5)
    )
    assert sorted(queue.abandon()) == [1, 2, 3, 4, 5]
    assert queue.abandon() == []
    assert not queue.motors.setpoints


def test_motor_command_overtaken_by_stop_is_rejected() -> None:
    queue = collect(packet(1, GetMode()), packet(2, DriveMotor(1, Drive.at(9))), Stop(3))
    assert [job.id for job in queue.jobs] == [1]
    (outcome,) = queue.outcomes
    assert outcome.id == 2
    assert isinstance(outcome.error, BadRequest)


def test_last_reconnect_candidates_replace_earlier_ones() -> None:
    first, second = ConnectionSettings("first"), ConnectionSettings("second")
    assert collect().liveness.candidates == ()
    earlier = SetReconnectCandidates((first,))
    queue = collect(earlier, Stop(1), SetReconnectCandidates((second, first)))
    assert queue.liveness.candidates == (second, first)
    assert collect(earlier, SetReconnectCandidates(())).liveness.candidates == ()
