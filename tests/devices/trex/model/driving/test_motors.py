"""Setpoints, arming and stops of the motors."""

from collections.abc import Callable
from functools import partial

import pytest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from tests.support.virtual_time import VirtualRuntime
from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.driving.requests import (
    SetAuxiliary,
    SetMotor,
    SetMotors,
    SetpointRequest,
)
from trex_gui.devices.trex.model.momentary_drive import MomentaryDrive
from trex_gui.devices.trex.model.motors import LOCKOUT, Motors
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.protocol.driving import Drive


class RequestRecorder:
    """Motors that record their requests, stops and changes."""

    def __init__(self) -> None:
        self.motors = Motors()
        self.motors.set_ceiling(FULL_SCALE)
        self.requests: list[SetpointRequest] = []
        self.stops = 0
        self.changes: list[str] = []
        self.motors.requested.connect(self.requests.append)
        self.motors.stop_requested.connect(self._on_stop)
        for name in ("arming", "setpoints", "holder", "options"):
            signal = getattr(self.motors, f"{name}_changed")
            signal.connect(partial(self.changes.append, name))

    def _on_stop(self) -> None:
        self.stops += 1


@pytest.fixture
def recorder(qtbot: QtBot) -> RequestRecorder:
    return RequestRecorder()


@pytest.fixture
def armed(recorder: RequestRecorder) -> RequestRecorder:
    recorder.motors.set_available(True)
    recorder.motors.arm()
    return recorder


def drive_all_motors(motors: Motors) -> None:
    motors.set_speed(1, 50)
    motors.set_speed(2, -50)
    motors.set_brake(1, 10)
    motors.set_auxiliary(50)


# --- Arming -----------------------------------------------------------------------------


def test_unarmed_motors_send_nothing(recorder: RequestRecorder) -> None:
    recorder.motors.arm()
    assert not recorder.motors.armed, "no board is connected"
    assert not recorder.motors.is_available
    drive_all_motors(recorder.motors)
    recorder.motors.set_available(True)
    drive_all_motors(recorder.motors)
    assert recorder.requests == []
    assert recorder.motors.drive(1) is None
    assert recorder.motors.auxiliary == 0


def test_armed_motors_send_setpoints(armed: RequestRecorder) -> None:
    armed.motors.accelerate = False
    armed.motors.set_speed(2, -50)
    armed.motors.set_brake(1, 10)
    armed.motors.set_auxiliary(30)
    assert armed.requests == [
        SetMotor(2, Drive.at(-50)),
        SetMotor(1, Drive.brake(10)),
        SetAuxiliary(30),
    ]
    assert armed.motors.drive(2) == Drive.at(-50)
    assert armed.motors.auxiliary == 30


def test_repeated_setpoint_is_sent_once(armed: RequestRecorder) -> None:
    for _ in range(3):
        armed.motors.set_speed(1, 50)
        armed.motors.set_auxiliary(50)
    assert len(armed.requests) == 2
    for _ in range(2):
        armed.motors.set_speeds(50, 60)
    assert armed.requests[2:] == [SetMotor(2, Drive.at(60), True)]


@pytest.mark.parametrize("speed", [-128, 128, 1000])
def test_speed_out_of_range_is_rejected(armed: RequestRecorder, speed: int) -> None:
    with pytest.raises(BadRequest, match="-127 to 127"):
        armed.motors.set_speed(1, speed)
    with pytest.raises(BadRequest):
        armed.motors.set_auxiliary(speed)
    assert armed.requests == []


# --- Stopping ---------------------------------------------------------------------------


def test_stop_disarms_and_clears_setpoints(armed: RequestRecorder) -> None:
    drive_all_motors(armed.motors)
    armed.motors.stop()
    assert armed.stops == 1
    assert not armed.motors.armed
    assert armed.motors.drive(1) is None
    assert armed.motors.drive(2) is None
    assert armed.motors.auxiliary == 0
    armed.requests.clear()
    drive_all_motors(armed.motors)
    assert armed.requests == []
    armed.motors.arm()
    assert armed.motors.drive(1) is None
    armed.motors.set_brake(1, 10)
    assert armed.requests == [SetMotor(1, Drive.brake(10), True)]


@pytest.mark.parametrize("available", [False, True])
def test_stop_is_always_accepted(recorder: RequestRecorder, *, available: bool) -> None:
    recorder.motors.set_available(available)
    for _ in range(3):
        recorder.motors.stop()
    assert recorder.stops == 3


def test_lost_board_disarms_without_sending_until_armed_again(armed: RequestRecorder) -> None:
    armed.motors.set_speed(1, 50)
    armed.requests.clear()
    for is_available in (False, True):
        armed.motors.set_available(is_available)
        assert armed.motors.is_available is is_available
        assert not armed.motors.armed
        assert armed.motors.drive(1) is None
    assert armed.requests == []
    assert armed.stops == 0


def test_each_change_emits_its_signal(armed: RequestRecorder) -> None:
    armed.motors.set_speed(1, 5)
    armed.motors.set_auxiliary(5)
    armed.motors.set_ceiling(100)
    armed.motors.acquire("pad")
    armed.motors.stop()
    assert armed.changes == [
        *("arming", "arming", "setpoints", "setpoints", "options", "holder"),
        *("arming", "setpoints", "holder"),
    ]


def test_setpoint_text_names_each_motor(armed: RequestRecorder) -> None:
    assert armed.motors.text == ""
    armed.motors.set_brake(2, 127)
    armed.motors.set_speed(1, -90)
    armed.motors.set_auxiliary(40)
    assert armed.motors.text == "motor 1 −90, motor 2 brake, auxiliary 40"
    armed.motors.stop()
    assert armed.motors.text == ""


def test_first_setpoint_is_sent_even_if_it_brakes(armed: RequestRecorder) -> None:
    armed.motors.set_brake(1, 127)
    assert armed.requests == [SetMotor(1, Drive.brake(), accelerate=True)]


# --- Lockout after a stop ---------------------------------------------------------------


def test_pressed_stop_prevents_arming_during_the_lockout(
    armed: RequestRecorder, qtbot: QtBot, virtual_time: VirtualRuntime
) -> None:
    motors = armed.motors
    motors.lockout = 3.0
    motors.press_stop()
    assert motors.locked_for == pytest.approx(3.0)
    virtual_time.advance(2.9)
    motors.arm()
    assert not motors.armed
    with qtbot.waitSignal(motors.arming_changed):
        virtual_time.advance(0.2)
    assert motors.locked_for == 0
    motors.arm()
    assert motors.armed


def test_second_stop_never_shortens_the_lockout(qtbot: QtBot, virtual_time: VirtualRuntime) -> None:
    motors = Motors()
    motors.press_stop()
    virtual_time.advance(1.0)
    motors.lockout = 1.0
    motors.press_stop()
    assert motors.locked_for == pytest.approx(LOCKOUT - 1)
    motors.lockout = 9.0
    motors.press_stop()
    assert motors.locked_for == pytest.approx(9)


def test_automatic_stop_has_no_lockout_and_gives_a_reason(armed: RequestRecorder) -> None:
    armed.motors.stop("The gamepad is gone.")
    assert armed.motors.stop_reason == "The gamepad is gone."
    armed.motors.arm()
    assert armed.motors.armed
    assert armed.motors.stop_reason == ""


@pytest.mark.parametrize(("seconds", "saved"), [(60.0, 10.0), (4.5, 4.5), (0.0, 0.0), (-1.0, 0.0)])
def test_lockout_is_saved_within_its_limits(
    qapp: QApplication, seconds: float, saved: float
) -> None:
    Motors().set_lockout(seconds)
    assert Motors().lockout == saved


# --- Ceiling and link -------------------------------------------------------------------


def test_setpoints_are_limited_by_the_ceiling(armed: RequestRecorder) -> None:
    armed.motors.set_ceiling(40)
    armed.motors.set_speed(1, 100)
    armed.motors.set_speed(2, -100)
    armed.motors.set_auxiliary(100)
    assert armed.requests == [
        SetMotor(1, Drive.at(40), True),
        SetMotor(2, Drive.at(-40), True),
        SetAuxiliary(40, True),
    ]


def test_lower_ceiling_slows_faster_motors(armed: RequestRecorder) -> None:
    armed.motors.set_speed(1, -100)
    armed.motors.set_brake(2, 127)
    armed.motors.set_auxiliary(100)
    armed.requests.clear()
    armed.motors.set_ceiling(30)
    assert armed.requests == [SetMotor(1, Drive.at(-30), True), SetAuxiliary(30, True)]
    armed.motors.set_speeds(30, -30)
    armed.motors.set_auxiliary(0)
    armed.requests.clear()
    armed.motors.set_ceiling(20)
    setpoints = SetMotor(1, Drive.at(20), True), SetMotor(2, Drive.at(-20), True)
    assert armed.requests == [SetMotors(setpoints)]


def test_higher_ceiling_takes_effect_after_release(armed: RequestRecorder) -> None:
    armed.motors.set_ceiling(30)
    armed.motors.acquire("stick")
    armed.motors.set_speed(1, 127, "stick")
    armed.motors.set_ceiling(100)
    armed.motors.set_speed(1, 127, "stick")  # the stick does not move
    armed.motors.set_auxiliary(127, "stick")
    assert armed.motors.drive(1) == Drive.at(30)
    assert (armed.motors.ceiling, armed.motors.auxiliary) == (100, 30)
    armed.motors.set_ceiling(20)
    assert armed.motors.drive(1) == Drive.at(20)
    armed.motors.set_speed(1, 127, "stick")
    assert armed.motors.drive(1) == Drive.at(20)
    armed.motors.set_ceiling(100)
    armed.motors.release("stick")
    armed.motors.acquire("stick")
    armed.motors.set_speed(1, 127, "stick")
    assert armed.motors.drive(1) == Drive.at(100)


@pytest.mark.parametrize("speed", [0, 128])
def test_ceiling_out_of_range_is_rejected(recorder: RequestRecorder, speed: int) -> None:
    with pytest.raises(ValueError, match="1 to 127"):
        recorder.motors.set_ceiling(speed)


def test_linked_motors_get_equal_setpoints(armed: RequestRecorder) -> None:
    armed.motors.set_linked(True)
    armed.motors.set_speed(2, 30)
    armed.motors.set_brake(1, 60)
    assert armed.requests == [
        SetMotors((SetMotor(1, Drive.at(30), True), SetMotor(2, Drive.at(30), True))),
        SetMotors((SetMotor(1, Drive.brake(60), True), SetMotor(2, Drive.brake(60), True))),
    ]


@pytest.mark.parametrize("drives", [(50, 20), (50, 0), (0, -50)])
def test_motors_with_different_speeds_cannot_be_linked(
    armed: RequestRecorder, drives: tuple[int, int]
) -> None:
    armed.motors.set_speeds(*drives)
    armed.requests.clear()
    assert not armed.motors.can_link
    armed.motors.set_linked(True)
    assert not armed.motors.linked
    assert armed.requests == []


def test_linking_idle_or_equal_motors_sends_nothing(armed: RequestRecorder) -> None:
    drives: list[Callable[[Motors], None]] = [
        lambda motors: motors.set_brake(1, 60),
        lambda motors: motors.set_speeds(0, 0),
        lambda motors: motors.set_speeds(40, 40),
    ]
    for drive in drives:
        drive(armed.motors)
        armed.requests.clear()
        armed.motors.set_linked(True)
        assert armed.requests == []
        armed.motors.set_speed(2, 10)
        assert armed.motors.drive(1) == Drive.at(10)
        armed.motors.set_linked(False)


# --- Held controls ----------------------------------------------------------------------


def test_releasing_a_held_control_brakes_its_motors(armed: RequestRecorder) -> None:
    armed.motors.set_release_brake(64)
    assert armed.motors.acquire("pad")
    armed.motors.set_speed(1, 50, "pad")
    armed.motors.set_speed(2, 50, "pad")
    armed.requests.clear()
    armed.motors.release("pad")
    assert armed.requests == [
        SetMotors((SetMotor(1, Drive.brake(64), True), SetMotor(2, Drive.brake(64), True)))
    ]
    assert armed.motors.armed
    assert armed.motors.holder == ""


def test_release_affects_only_the_held_motor(armed: RequestRecorder) -> None:
    armed.motors.set_speed(2, 30)
    armed.motors.set_auxiliary(30)
    armed.motors.acquire("motor1")
    armed.motors.set_speed(1, 50, "motor1")
    armed.motors.release("motor1")
    assert armed.motors.drive(1) == Drive.brake(127)
    assert armed.motors.drive(2) == Drive.at(30)
    assert armed.motors.auxiliary == 30
    armed.motors.acquire("aux")
    armed.motors.set_auxiliary(50, "aux")
    armed.motors.release("aux")
    assert armed.motors.auxiliary == 0


def test_only_one_control_can_hold_the_motors(armed: RequestRecorder) -> None:
    assert armed.motors.acquire("pad")
    assert armed.motors.acquire("pad")
    assert not armed.motors.acquire("keys")
    armed.motors.set_speed(1, 20, "pad")
    armed.motors.set_speed(1, 99, "keys")
    armed.motors.set_speed(1, 99)
    assert armed.motors.drive(1) == Drive.at(20)
    armed.motors.release("keys")
    assert armed.motors.holder == "pad"
    armed.motors.release("pad")
    armed.motors.set_speed(1, 99, "pad")
    assert armed.motors.drive(1) == Drive.brake(127)


def test_abort_by_the_holding_control_stops_and_disarms(armed: RequestRecorder) -> None:
    armed.motors.acquire("gamepad")
    armed.motors.set_speed(1, 20, "gamepad")
    armed.motors.abort("keys", "not held")
    assert armed.stops == 0
    armed.motors.abort("gamepad", "The gamepad is gone.")
    assert armed.stops == 1
    assert not armed.motors.armed
    assert armed.motors.stop_reason == "The gamepad is gone."
    assert armed.motors.holder == ""


@pytest.mark.parametrize("linked", [False, True])
def test_held_control_sends_both_motors_in_one_request(
    armed: RequestRecorder, *, linked: bool
) -> None:
    armed.motors.set_linked(linked)
    drive = MomentaryDrive(armed.motors, "pad")
    for _ in range(3):
        drive.steer(0.5, 0.1)
        drive.release()
    assert len(armed.requests) == 6
    assert {type(request) for request in armed.requests} == {SetMotors}


def test_held_control_drives_linked_motors_straight(armed: RequestRecorder) -> None:
    armed.motors.set_linked(True)
    armed.motors.set_ceiling(4)
    MomentaryDrive(armed.motors, "pad").steer(0.5, 0.3)
    assert armed.motors.drive(1) == armed.motors.drive(2) == Drive.at(2)
