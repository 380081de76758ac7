"""The state machine of the motor output, without a line."""

import itertools
import math

import pytest

from trex_gui.core.errors import BadRequest
from trex_gui.core.session import Outcome
from trex_gui.core.timing import Timeouts
from trex_gui.devices.trex.driving.motor_output import Arming, Motion, MotorOutput, OutputEvent
from trex_gui.devices.trex.driving.requests import (
    Arm,
    Heartbeat,
    MotorsStopped,
    SetMotor,
    Stop,
    StopSent,
)
from trex_gui.devices.trex.protocol.commands import DriveMotor, GetMode
from trex_gui.devices.trex.protocol.driving import Drive

HEARTBEAT = Timeouts().heartbeat
SETPOINT = SetMotor(1, Drive.at(50))
DRIVE = DriveMotor(1, Drive.at(50))


@pytest.fixture
def reports() -> list[Outcome | MotorsStopped | StopSent]:
    return []


@pytest.fixture
def motors(reports: list[Outcome | MotorsStopped | StopSent]) -> MotorOutput:
    return MotorOutput(reports.append)


def passes_setpoints(motors: MotorOutput, now: float) -> bool:
    motors.setpoints.clear()
    motors.take(SETPOINT, now)
    return bool(motors.setpoints)


def passes_commands(motors: MotorOutput, now: float) -> bool:
    try:
        motors.check(DRIVE, now)
    except BadRequest:
        return False
    return True


# --- The tables -------------------------------------------------------------------------


@pytest.mark.parametrize(("arming", "event"), list(itertools.product(Arming, OutputEvent)))
def test_only_arming_lets_setpoints_pass_again(arming: Arming, event: OutputEvent) -> None:
    motors = MotorOutput(lambda _report: None)
    motors.arming = arming
    motors.handle(event, 1.0)
    may_pass = motors.arming in {Arming.INITIAL, Arming.ARMED}
    assert passes_setpoints(motors, 1.0) == may_pass
    if may_pass:
        assert event is OutputEvent.ARM or motors.arming is arming


@pytest.mark.parametrize(("motion", "event"), list(itertools.product(Motion, OutputEvent)))
def test_only_a_confirmed_stop_ends_motion(motion: Motion, event: OutputEvent) -> None:
    motors = MotorOutput(lambda _report: None)
    motors.motion = motion
    motors.handle(event, 1.0)
    if motion is not Motion.STOPPED:
        assert motors.may_move != (event is OutputEvent.STOP_CONFIRMED)


@pytest.mark.parametrize("arming", list(Arming))
@pytest.mark.parametrize(
    "event", [OutputEvent.STOP, OutputEvent.LOCK_OUT, OutputEvent.NOT_RESPONDING]
)
def test_every_stop_disarms_and_drops_setpoints(arming: Arming, event: OutputEvent) -> None:
    motors = MotorOutput(lambda _report: None)
    motors.take(SETPOINT, 0.0)
    motors.arming = arming
    motors.handle(event, 1.0)
    assert not motors.is_armed
    assert not motors.setpoints
    assert motors.seconds_to_drive(1.0, 0.02) == math.inf


# --- Lock-out ---------------------------------------------------------------------------


def test_stop_without_lockout_lets_direct_commands_pass(motors: MotorOutput) -> None:
    motors.take(Stop(1), 0.0)
    assert passes_commands(motors, 0.0)
    assert not passes_setpoints(motors, 0.0)


def test_lockout_rejects_motor_commands_only(motors: MotorOutput) -> None:
    motors.take(Stop(1, lockout=1.0), 0.0)
    assert not passes_commands(motors, 0.9)
    motors.check(GetMode(), 0.9)
    assert passes_commands(motors, 1.0)
    assert not passes_setpoints(motors, 1.0)


def test_shorter_lockout_does_not_end_longer_one(motors: MotorOutput) -> None:
    for lockout in (3.0, 0.0, 1.0):
        motors.take(Stop(1, lockout), 0.0)
    assert not passes_commands(motors, 2.9)
    assert passes_commands(motors, 3.1)


def test_unreachable_board_cannot_be_armed(motors: MotorOutput) -> None:
    motors.handle(OutputEvent.NOT_RESPONDING, 0.0)
    motors.take(Arm(), 1.0)
    assert not motors.is_armed
    assert not passes_commands(motors, 1e9)
    motors.handle(OutputEvent.BOARD_READ, 2.0)
    assert not passes_commands(motors, 1e9)
    motors.take(Arm(), 3.0)
    assert passes_commands(motors, 3.0)
    assert passes_setpoints(motors, 3.0)


# --- Heartbeats -------------------------------------------------------------------------


def has_timed_out(motors: MotorOutput, now: float) -> bool:
    return motors.seconds_to_heartbeat_timeout(now) <= 0


def test_late_heartbeat_does_not_hide_timeout(motors: MotorOutput) -> None:
    motors.take(Arm(), 10.0)
    now = 10.0 + HEARTBEAT + 0.5
    motors.take(Heartbeat(now), now)  # the window goes on before the line has looked
    motors.take(SETPOINT, now)  # and so does a slider that is dragged
    assert has_timed_out(motors, now)


def test_timestamped_heartbeats_prevent_false_timeout(motors: MotorOutput) -> None:
    motors.take(Arm(), 10.0)
    now = 10.0 + 3 * HEARTBEAT
    for number in range(1, 12):
        motors.take(Heartbeat(10.0 + number * HEARTBEAT / 4), now)
        motors.take(Heartbeat(), now)
    assert not has_timed_out(motors, now)


def test_arming_again_clears_heartbeat_timeout(motors: MotorOutput) -> None:
    motors.take(Arm(), 10.0)
    now = 10.0 + 2 * HEARTBEAT
    assert has_timed_out(motors, now)
    motors.take(Arm(), now)
    assert not has_timed_out(motors, now)


# --- Unconfirmed stops ------------------------------------------------------------------


def test_unanswered_stop_is_repeated_only_if_driven(motors: MotorOutput) -> None:
    motors.note_stop(1.0, (), confirmed=False, final=False)
    assert motors.seconds_to_stop_retry(1.0) == math.inf
    motors.take(SETPOINT, 2.0)
    motors.take_setpoints(2.0)
    motors.note_stop(3.0, (), confirmed=False, final=False)
    assert motors.seconds_to_stop_retry(3.0) < math.inf
    motors.note_stop(4.0, (), confirmed=True, final=False)
    assert motors.seconds_to_stop_retry(4.0) == math.inf


def test_setpoint_ends_repetition_of_stop_but_direct_command_does_not() -> None:
    motors = MotorOutput(lambda _report: None, may_move=True)
    motors.note_stop(1.0, (), confirmed=False, final=False)
    motors.handle(OutputEvent.DIRECT_COMMAND_SENT, 2.0)
    assert motors.seconds_to_stop_retry(2.0) < math.inf
    motors.handle(OutputEvent.SETPOINT_SENT, 2.0)
    assert motors.seconds_to_stop_retry(2.0) == math.inf
    assert motors.may_move
