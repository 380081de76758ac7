"""Motor output of one board, without a session."""

import itertools
import math

import pytest

from tests.devices.trex.session.helpers import create_harness, motor_commands_in, of_type
from trex_gui.core.errors import NoReply, PortUnavailable
from trex_gui.core.session import Outcome
from trex_gui.core.timing import Timeouts
from trex_gui.devices.trex.client.telemetry import StatusReader
from trex_gui.devices.trex.driving.motor_driver import DRIVE_INTERVAL, MotorDriver, stop_together
from trex_gui.devices.trex.driving.motor_output import Arming, Motion, MotorOutput, OutputEvent
from trex_gui.devices.trex.driving.requests import (
    Arm,
    Heartbeat,
    MotorReport,
    SetAuxiliary,
    SetMotor,
    Stop,
    StopSent,
)
from trex_gui.devices.trex.driving.setpoints import REPEATS
from trex_gui.devices.trex.protocol.commands import STOP, DriveAuxiliary, DriveMotor
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.flags import UartError
from trex_gui.devices.trex.simulator.motors import MotorDirection


class MotorsHarness:
    """`MotorDriver` connected to a simulated board, and its reports."""

    def __init__(self) -> None:
        harness, _ = create_harness()
        self.board, self.line, self.transport = harness.board, harness.line, harness.transport
        self.reports: list[Outcome | MotorReport] = []
        self.motors = MotorOutput(self.reports.append)
        clock = self.transport.clock
        self.driver = MotorDriver(self.motors, harness.client(), StatusReader(clock))

    @property
    def now(self) -> float:
        return self.transport.clock()

    def set(self, *setpoints: SetMotor | SetAuxiliary) -> None:
        for setpoint in setpoints:
            self.motors.handle_request(setpoint, self.now)

    def stop(self) -> None:
        self.motors.handle_request(Stop(1), self.now)
        stop_together([run for run in [self.driver.due_stop()] if run])

    def arm(self) -> None:
        self.motors.handle_request(Arm(), self.now)

    def drive(self, speed: int) -> None:
        self.set(SetMotor(1, Drive.at(speed)))
        self.advance(DRIVE_INTERVAL)

    def advance(self, seconds: float) -> None:
        """Advance the time, and send due packets like a session."""
        end = self.now + seconds
        while (due := self.driver.seconds_to_drive()) < math.inf:
            if self.now + due > end:
                break
            if due > 0:
                self.transport.wait(max(due, 1e-5))
            else:
                self.driver.serve()


@pytest.fixture
def harness() -> MotorsHarness:
    return MotorsHarness()


def test_newest_setpoint_is_sent_and_next_one_waits(harness: MotorsHarness) -> None:
    harness.line.advance(1.0)
    harness.set(SetMotor(1, Drive.at(10)))
    assert harness.driver.seconds_to_drive() <= 0
    harness.drive(20)
    assert motor_commands_in(harness.transport.sent) == [DriveMotor(1, Drive.at(20))]
    assert harness.motors.may_move
    harness.set(SetMotor(1, Drive.at(30)))
    seconds = harness.driver.seconds_to_drive()
    assert seconds >= DRIVE_INTERVAL


def test_lost_setpoint_is_resent(harness: MotorsHarness) -> None:
    harness.line.faults.to_drop_sent = 2  # the whole packet, so the board latches no error
    harness.drive(20)
    assert harness.board.motors[0].target_speed == 0
    harness.advance(4.0)
    sent = motor_commands_in(harness.transport.sent)
    assert sent == [DriveMotor(1, Drive.at(20))] * (1 + len(REPEATS))
    assert harness.board.motors[0].target_speed == 20
    assert harness.driver.seconds_to_drive() == math.inf


def test_newer_setpoint_replaces_unconfirmed_one(harness: MotorsHarness) -> None:
    harness.drive(20)
    harness.advance(0.2)
    harness.set(SetAuxiliary(9))
    harness.set(SetMotor(1, Drive.at(30)))
    harness.advance(4.0)
    sent = motor_commands_in(harness.transport.sent)
    assert sent[:2] == [DriveMotor(1, Drive.at(20))] * 2
    assert sent[2:] == [DriveMotor(1, Drive.at(30)), DriveAuxiliary(9)] * (1 + len(REPEATS))


def test_no_setpoint_is_pending_after_stop(harness: MotorsHarness) -> None:
    harness.drive(20)
    harness.stop()
    assert harness.driver.seconds_to_drive() == math.inf
    harness.arm()
    harness.drive(20)
    assert harness.driver.seconds_to_drive() < math.inf
    harness.motors.handle(OutputEvent.NOT_RESPONDING, harness.now)
    assert harness.driver.seconds_to_drive() == math.inf


def test_setpoint_interrupted_by_stop_is_not_sent_again(harness: MotorsHarness) -> None:
    def stop_instead(data: bytes) -> None:
        del data
        harness.motors.handle_request(Stop(1), harness.now)
        harness.arm()
        raise NoReply("the guardian has used the line")

    harness.transport.write = stop_instead  # type: ignore[method-assign]
    with pytest.raises(NoReply):
        harness.drive(20)
    assert harness.driver.seconds_to_drive() == math.inf


def test_confirmed_stop_is_reported_and_clears_may_move(harness: MotorsHarness) -> None:
    harness.drive(90)
    harness.stop()
    assert harness.reports == [StopSent(), StopSent(), Outcome(1)]
    assert not harness.motors.may_move
    assert harness.board.motors[0].direction is MotorDirection.BRAKE


def test_unanswered_stop_is_repeated_and_reported(harness: MotorsHarness) -> None:
    harness.drive(90)
    harness.board.power_off()
    harness.stop()
    *sent, outcome = harness.reports
    assert set(sent) == {StopSent()}
    assert isinstance(outcome, Outcome)
    assert isinstance(outcome.error, NoReply)
    assert "cut its power" in str(outcome.error)
    assert harness.motors.may_move
    assert motor_commands_in(harness.transport.sent).count(STOP[0]) >= 10


def test_stop_is_not_confirmed_while_the_board_reports_line_errors(
    harness: MotorsHarness,
) -> None:
    def write_with_error(data: bytes) -> None:
        write(data)
        harness.board.report_error(UartError.FRAMING)

    harness.drive(90)
    write, harness.transport.write = harness.transport.write, write_with_error  # type: ignore[method-assign]
    harness.stop()
    (outcome,) = of_type(harness.reports, Outcome)
    assert isinstance(outcome.error, NoReply)
    assert harness.motors.may_move


@pytest.mark.parametrize(("corrupted", "rounds"), [(0, 2), (1, 8)])
def test_final_stop_needs_more_statuses_on_damaged_line(
    harness: MotorsHarness, corrupted: int, rounds: int
) -> None:
    harness.driver.client.counters.corrupted = corrupted
    assert harness.driver.stop_and_confirm()
    assert motor_commands_in(harness.transport.sent).count(STOP[0]) == rounds


def test_beginning_of_a_stop_ends_refreshes_of_speeds(harness: MotorsHarness) -> None:
    harness.drive(90)
    assert harness.motors.refresh.running
    harness.driver.final_stop()
    assert not harness.motors.refresh.running


@pytest.mark.parametrize("is_waiting", [False, True])
def test_speed_is_not_refreshed_without_a_status(
    harness: MotorsHarness, *, is_waiting: bool
) -> None:
    harness.drive(90)
    harness.motors.retry.clear()
    harness.driver.client.counters.corrupted = 1
    harness.line.faults.mute = not is_waiting
    if is_waiting:
        harness.line.advance(1.0)
        assert harness.driver.seconds_to_drive() <= 0
        harness.driver.refresh_while_waiting(1.0)
    else:
        harness.advance(0.5)
    refreshed = motor_commands_in(harness.transport.sent)[1:]
    assert set(refreshed) == {DriveMotor(2, Drive.brake())}


def test_stop_is_queued_again_when_port_is_lost(harness: MotorsHarness) -> None:
    harness.drive(90)
    harness.transport.fail = PortUnavailable("gone")
    with pytest.raises(PortUnavailable):
        harness.stop()
    assert harness.motors.stops == [Stop(1)]
    assert not harness.reports
    assert harness.motors.may_move


def test_unresponsive_board_gets_a_stop_only_if_driven(harness: MotorsHarness) -> None:
    harness.driver.stop_without_reply()
    assert not harness.transport.sent
    harness.drive(90)
    harness.driver.stop_without_reply()
    assert len(motor_commands_in(harness.transport.sent)) == 3


# --- Transitions without a line ---------------------------------------------------------


HEARTBEAT = Timeouts().heartbeat
SETPOINT = SetMotor(1, Drive.at(50))


@pytest.fixture
def motors() -> MotorOutput:
    return MotorOutput(lambda _report: None)


def passes_setpoints(motors: MotorOutput, now: float) -> bool:
    motors.setpoints.clear()
    motors.handle_request(SETPOINT, now)
    return bool(motors.setpoints)


@pytest.mark.parametrize(("arming", "event"), list(itertools.product(Arming, OutputEvent)))
def test_only_arming_lets_setpoints_pass_again(
    motors: MotorOutput, arming: Arming, event: OutputEvent
) -> None:
    motors.arming = arming
    motors.handle(event, 1.0)
    may_pass = motors.arming in {Arming.INITIAL, Arming.ARMED}
    assert passes_setpoints(motors, 1.0) == may_pass
    if may_pass:
        assert event is OutputEvent.ARM or motors.arming is arming


@pytest.mark.parametrize("motion", [Motion.DRIVEN, Motion.STOP_UNCONFIRMED])
@pytest.mark.parametrize("event", OutputEvent)
def test_only_a_confirmed_stop_ends_motion(
    motors: MotorOutput, motion: Motion, event: OutputEvent
) -> None:
    motors.motion = motion
    motors.handle(event, 1.0)
    assert motors.may_move != (event is OutputEvent.STOP_CONFIRMED)


@pytest.mark.parametrize("arming", list(Arming))
@pytest.mark.parametrize("event", [OutputEvent.STOP, OutputEvent.NOT_RESPONDING])
def test_every_stop_disarms_and_drops_setpoints(
    motors: MotorOutput, arming: Arming, event: OutputEvent
) -> None:
    motors.handle_request(SETPOINT, 0.0)
    motors.arming = arming
    motors.handle(event, 1.0)
    assert not motors.is_armed
    assert not motors.setpoints
    assert motors.seconds_to_drive(1.0, 0.02) == math.inf


def test_unreachable_board_cannot_be_armed(motors: MotorOutput) -> None:
    motors.handle(OutputEvent.NOT_RESPONDING, 0.0)
    motors.handle_request(Arm(), 1.0)
    assert not motors.is_armed
    assert not passes_setpoints(motors, 1.0)
    motors.handle(OutputEvent.BOARD_READ, 2.0)
    assert not passes_setpoints(motors, 2.0)
    motors.handle_request(Arm(), 3.0)
    assert passes_setpoints(motors, 3.0)


# --- Heartbeats -------------------------------------------------------------------------


def has_timed_out(motors: MotorOutput, now: float) -> bool:
    return motors.seconds_to_heartbeat_timeout(now) <= 0


def test_late_heartbeat_does_not_hide_timeout(motors: MotorOutput) -> None:
    motors.handle_request(Arm(), 10.0)
    now = 10.0 + HEARTBEAT + 0.5
    motors.handle_request(Heartbeat(now), now)  # a late heartbeat
    motors.handle_request(SETPOINT, now)  # a late setpoint
    assert has_timed_out(motors, now)


def test_timestamped_heartbeats_prevent_false_timeout(motors: MotorOutput) -> None:
    motors.handle_request(Arm(), 10.0)
    now = 10.0 + 3 * HEARTBEAT
    for number in range(1, 12):
        motors.handle_request(Heartbeat(10.0 + number * HEARTBEAT / 4), now)
        motors.handle_request(Heartbeat(), now)
    assert not has_timed_out(motors, now)


def test_arming_again_clears_heartbeat_timeout(motors: MotorOutput) -> None:
    motors.handle_request(Arm(), 10.0)
    now = 10.0 + 2 * HEARTBEAT
    assert has_timed_out(motors, now)
    motors.handle_request(Arm(), now)
    assert not has_timed_out(motors, now)


# --- Unconfirmed stops ------------------------------------------------------------------


def test_unanswered_stop_is_repeated_only_if_driven(motors: MotorOutput) -> None:
    motors.record_stop(1.0, (), confirmed=False, final=False)
    assert motors.seconds_to_stop_retry(1.0) == math.inf
    motors.handle_request(SETPOINT, 2.0)
    motors.pop_setpoints(2.0)
    motors.record_stop(3.0, (), confirmed=False, final=False)
    assert motors.seconds_to_stop_retry(3.0) < math.inf
    motors.record_stop(4.0, (), confirmed=True, final=False)
    assert motors.seconds_to_stop_retry(4.0) == math.inf


def test_only_a_setpoint_ends_the_repetition_of_a_stop() -> None:
    motors = MotorOutput(lambda _report: None, may_move=True)
    motors.record_stop(1.0, (), confirmed=False, final=False)
    motors.handle(OutputEvent.DIRECT_COMMAND_SENT, 2.0)
    assert motors.seconds_to_stop_retry(2.0) < math.inf
    motors.handle(OutputEvent.SETPOINT_SENT, 2.0)
    assert motors.seconds_to_stop_retry(2.0) == math.inf
    assert motors.may_move
