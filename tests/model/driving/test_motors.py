"""What a person wants the motors to do, and when it may be sent."""

from collections.abc import Callable

import pytest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from trex_gui.link.messages import MotorRequest, SetAuxiliary, SetDrive, SetDrives
from trex_gui.model.driving.held import HeldDrive
from trex_gui.model.driving.lockout import remember_lockout
from trex_gui.model.driving.motors import LOCKOUT, Motors
from trex_gui.protocol.commands import Drive
from trex_gui.protocol.errors import BadRequest


class Asked:
    """Motors, and what they asked for."""

    def __init__(self) -> None:
        self.motors = Motors()
        self.wishes: list[MotorRequest] = []
        self.stops = 0
        self.changes = 0
        self.motors.requested.connect(self.wishes.append)
        self.motors.stop_requested.connect(self._on_stop)
        self.motors.changed.connect(self._on_changed)

    def _on_stop(self) -> None:
        self.stops += 1

    def _on_changed(self) -> None:
        self.changes += 1


@pytest.fixture
def asked(qtbot: QtBot) -> Asked:
    return Asked()


@pytest.fixture
def armed(asked: Asked) -> Asked:
    asked.motors.allow(True)
    asked.motors.arm()
    return asked


def drive_everything(motors: Motors) -> None:
    motors.set_speed(1, 50)
    motors.set_speed(2, -50)
    motors.set_brake(1, 10)
    motors.set_auxiliary(50)


# --- Arming -----------------------------------------------------------------------------


def test_nothing_is_asked_for_before_the_motors_are_armed(asked: Asked) -> None:
    asked.motors.allow(True)
    drive_everything(asked.motors)
    assert asked.wishes == []
    assert asked.motors.drive(1) is None
    assert asked.motors.auxiliary == 0


def test_without_a_board_the_motors_cannot_be_armed(asked: Asked) -> None:
    asked.motors.arm()
    assert not asked.motors.armed
    assert not asked.motors.can_arm
    drive_everything(asked.motors)
    assert asked.wishes == []


def test_arming_asks_for_nothing_by_itself(armed: Asked) -> None:
    assert armed.motors.armed
    assert armed.wishes == []
    assert armed.stops == 0


def test_armed_motors_obey(armed: Asked) -> None:
    armed.motors.accelerate = False
    armed.motors.set_speed(2, -50)
    armed.motors.set_brake(1, 10)
    armed.motors.set_auxiliary(30)
    assert armed.wishes == [
        SetDrive(2, Drive.at(-50)),
        SetDrive(1, Drive.brake(10)),
        SetAuxiliary(30),
    ]
    assert armed.motors.drive(2) == Drive.at(-50)
    assert armed.motors.auxiliary == 30


@pytest.mark.parametrize("accelerate", [False, True])
def test_wishes_say_whether_to_go_there_slowly(armed: Asked, *, accelerate: bool) -> None:
    armed.motors.accelerate = accelerate
    armed.motors.set_speed(1, 1)
    armed.motors.set_auxiliary(1)
    told = [wish.accelerate for wish in armed.wishes if not isinstance(wish, SetDrives)]
    assert told == [accelerate, accelerate]


def test_the_same_wish_again_is_not_sent_again(armed: Asked) -> None:
    for _ in range(3):
        armed.motors.set_speed(1, 50)
        armed.motors.set_auxiliary(50)
    assert len(armed.wishes) == 2


@pytest.mark.parametrize("speed", [-128, 128, 1000])
def test_a_speed_that_no_motor_has_is_refused(armed: Asked, speed: int) -> None:
    with pytest.raises(BadRequest, match="-127 to 127"):
        armed.motors.set_speed(1, speed)
    assert armed.wishes == []


def test_a_braking_that_no_motor_has_is_refused(armed: Asked) -> None:
    with pytest.raises(BadRequest, match="0 to 127"):
        armed.motors.set_brake(1, 128)


def test_arming_twice_does_not_take_wishes_back(armed: Asked) -> None:
    armed.motors.set_speed(1, 50)
    armed.motors.arm()
    assert armed.motors.drive(1) == Drive.at(50)


def test_motors_begin_at_rest_when_they_are_armed_again(armed: Asked) -> None:
    armed.motors.set_speed(1, 50)
    armed.motors.stop()
    armed.motors.arm()
    assert armed.motors.drive(1) is None
    armed.motors.set_speed(1, 50)
    assert len(armed.wishes) == 2


# --- Stopping ---------------------------------------------------------------------------


def test_a_stop_disarms_and_puts_everything_to_rest(armed: Asked) -> None:
    drive_everything(armed.motors)
    armed.motors.stop()
    assert armed.stops == 1
    assert not armed.motors.armed
    assert armed.motors.drive(1) is None
    assert armed.motors.drive(2) is None
    assert armed.motors.auxiliary == 0
    armed.wishes.clear()
    drive_everything(armed.motors)
    assert armed.wishes == []


@pytest.mark.parametrize("allowed", [False, True])
def test_a_stop_is_never_refused(asked: Asked, *, allowed: bool) -> None:
    asked.motors.allow(allowed)
    for _ in range(3):
        asked.motors.stop()
    assert asked.stops == 3


def test_a_board_that_goes_disarms_the_motors_and_asks_nothing(armed: Asked) -> None:
    armed.motors.set_speed(1, 50)
    armed.wishes.clear()
    armed.motors.allow(False)
    assert not armed.motors.armed
    assert not armed.motors.can_arm
    assert armed.motors.drive(1) is None
    assert armed.wishes == []
    assert armed.stops == 0


def test_a_board_that_comes_back_does_not_arm_the_motors(armed: Asked) -> None:
    armed.motors.allow(False)
    armed.motors.allow(True)
    assert armed.motors.can_arm
    assert not armed.motors.armed


def test_each_change_is_announced(asked: Asked) -> None:
    asked.motors.allow(True)
    asked.motors.arm()
    asked.motors.set_speed(1, 5)
    asked.motors.set_auxiliary(5)
    asked.motors.stop()
    assert asked.changes == 5


def test_wishes_are_told_in_few_words(armed: Asked) -> None:
    assert armed.motors.text == ""
    armed.motors.set_brake(2, 127)
    armed.motors.set_speed(1, -90)
    armed.motors.set_auxiliary(40)
    assert armed.motors.text == "motor 1 −90, motor 2 brake, auxiliary 40"
    armed.motors.stop()
    assert armed.motors.text == ""


def test_the_first_wish_is_sent_even_when_it_is_to_brake(armed: Asked) -> None:
    armed.motors.set_brake(1, 127)
    assert armed.wishes == [SetDrive(1, Drive.brake(), accelerate=True)]


# --- The lock after a stop --------------------------------------------------------------


class Clock:
    """A time that a test sets."""

    def __init__(self) -> None:
        self.now = 100.0

    def __call__(self) -> float:
        return self.now


def test_after_stop_was_pressed_the_motors_cannot_be_armed_for_a_while(qtbot: QtBot) -> None:
    clock = Clock()
    motors = Motors(clock=clock)
    motors.allow(True)
    motors.lockout = 3.0
    motors.arm()
    motors.press_stop()
    assert motors.locked_for == 3.0
    clock.now += 2.9
    motors.arm()
    assert not motors.armed
    clock.now += 0.2
    with qtbot.waitSignal(motors.changed):  # the end of the lock is announced
        pass
    assert motors.locked_for == 0
    motors.arm()
    assert motors.armed


def test_a_second_press_lengthens_the_lock_and_never_shortens_it(qtbot: QtBot) -> None:
    clock = Clock()
    motors = Motors(clock=clock)
    motors.press_stop()
    clock.now += 1
    motors.lockout = 1.0
    motors.press_stop()
    assert motors.locked_for == pytest.approx(LOCKOUT - 1)
    motors.lockout = 9.0
    motors.press_stop()
    assert motors.locked_for == pytest.approx(9)


def test_a_stop_of_the_program_locks_nothing_and_says_why(armed: Asked) -> None:
    armed.motors.stop("The gamepad is gone.")
    assert armed.motors.stop_reason == "The gamepad is gone."
    armed.motors.arm()
    assert armed.motors.armed
    assert armed.motors.stop_reason == ""


@pytest.mark.parametrize(("chosen", "kept"), [(60.0, 10.0), (4.5, 4.5), (0.0, 0.0), (-1.0, 0.0)])
def test_lockout_is_remembered_within_its_limits(
    qapp: QApplication, chosen: float, kept: float
) -> None:
    remember_lockout(chosen)
    assert Motors().lockout == kept


# --- Ceiling and link -------------------------------------------------------------------


def test_no_wish_goes_beyond_the_ceiling(armed: Asked) -> None:
    armed.motors.set_ceiling(40)
    armed.motors.set_speed(1, 100)
    armed.motors.set_speed(2, -100)
    armed.motors.set_auxiliary(100)
    assert [wish.drive.signed for wish in armed.wishes if isinstance(wish, SetDrive)] == [40, -40]
    assert armed.motors.auxiliary == 40


def test_a_lower_ceiling_slows_down_what_runs_faster(armed: Asked) -> None:
    armed.motors.set_speed(1, -100)
    armed.motors.set_brake(2, 127)
    armed.motors.set_auxiliary(100)
    armed.wishes.clear()
    armed.motors.set_ceiling(30)
    assert armed.wishes == [SetDrive(1, Drive.at(-30), True), SetAuxiliary(30, True)]


def test_a_higher_ceiling_speeds_nothing_up(armed: Asked) -> None:
    armed.motors.set_ceiling(30)
    armed.motors.set_speed(1, 100)
    armed.wishes.clear()
    armed.motors.set_ceiling(127)
    assert armed.wishes == []


def test_a_higher_ceiling_waits_for_a_control_that_is_held(armed: Asked) -> None:
    armed.motors.set_ceiling(30)
    armed.motors.hold("stick")
    armed.motors.set_speed(1, 127, "stick")
    armed.motors.set_ceiling(100)
    armed.motors.set_speed(1, 127, "stick")  # as a stick that is held still says again and again
    armed.motors.set_auxiliary(127, "stick")
    assert armed.motors.drive(1) == Drive.at(30)
    assert (armed.motors.ceiling, armed.motors.auxiliary) == (100, 30)
    armed.motors.set_ceiling(20)
    assert armed.motors.drive(1) == Drive.at(20)
    armed.motors.set_ceiling(100)
    armed.motors.let_go("stick")
    armed.motors.hold("stick")
    armed.motors.set_speed(1, 127, "stick")
    assert armed.motors.drive(1) == Drive.at(100)


@pytest.mark.parametrize("speed", [0, 128])
def test_a_ceiling_that_is_none_is_refused(asked: Asked, speed: int) -> None:
    with pytest.raises(ValueError, match="1 to 127"):
        asked.motors.set_ceiling(speed)


def test_linked_motors_do_the_same(armed: Asked) -> None:
    armed.motors.set_linked(True)
    armed.motors.set_speed(2, 30)
    armed.motors.set_brake(1, 60)
    assert armed.wishes == [
        SetDrives((SetDrive(1, Drive.at(30), True), SetDrive(2, Drive.at(30), True))),
        SetDrives((SetDrive(1, Drive.brake(60), True), SetDrive(2, Drive.brake(60), True))),
    ]


@pytest.mark.parametrize("drives", [(50, 20), (50, 0), (0, -50)])
def test_motors_that_run_differently_are_not_linked(armed: Asked, drives: tuple[int, int]) -> None:
    armed.motors.set_speeds(*drives)
    armed.wishes.clear()
    assert not armed.motors.can_link
    armed.motors.set_linked(True)
    assert not armed.motors.linked
    assert armed.wishes == []


def test_motors_that_rest_or_run_alike_are_linked_and_go_on_as_they_are(armed: Asked) -> None:
    alike: list[Callable[[Motors], None]] = [
        lambda motors: motors.set_brake(1, 60),
        lambda motors: motors.set_speeds(0, 0),
        lambda motors: motors.set_speeds(40, 40),
    ]
    for drive in alike:
        drive(armed.motors)
        armed.wishes.clear()
        armed.motors.set_linked(True)
        assert armed.wishes == []
        armed.motors.set_speed(2, 10)
        assert armed.motors.drive(1) == Drive.at(10)
        armed.motors.set_linked(False)


def test_linked_motors_stay_linked_however_often_it_is_said(armed: Asked) -> None:
    armed.motors.set_linked(True)
    armed.motors.set_speed(1, 40)
    armed.motors.set_linked(True)
    assert armed.motors.linked


# --- Controls that must be held ---------------------------------------------------------


def test_a_held_control_that_lets_go_leaves_the_motors_braked(armed: Asked) -> None:
    armed.motors.set_release_brake(64)
    assert armed.motors.hold("pad")
    armed.motors.set_speed(1, 50, "pad")
    armed.motors.set_speed(2, 50, "pad")
    armed.wishes.clear()
    armed.motors.let_go("pad")
    assert armed.wishes == [
        SetDrives((SetDrive(1, Drive.brake(64), True), SetDrive(2, Drive.brake(64), True)))
    ]
    assert armed.motors.armed
    assert armed.motors.holder == ""


def test_letting_go_stops_what_was_held_and_nothing_else(armed: Asked) -> None:
    armed.motors.set_speed(2, 30)
    armed.motors.set_auxiliary(30)
    armed.motors.hold("motor1")
    armed.motors.set_speed(1, 50, "motor1")
    armed.motors.let_go("motor1")
    assert armed.motors.drive(1) == Drive.brake(127)
    assert armed.motors.drive(2) == Drive.at(30)
    assert armed.motors.auxiliary == 30


def test_an_auxiliary_motor_that_was_held_is_let_go_too(armed: Asked) -> None:
    armed.motors.hold("aux")
    armed.motors.set_auxiliary(50, "aux")
    armed.motors.let_go("aux")
    assert armed.motors.auxiliary == 0


def test_two_controls_cannot_hold_at_once(armed: Asked) -> None:
    assert armed.motors.hold("pad")
    assert armed.motors.hold("pad")
    assert not armed.motors.hold("keys")
    armed.motors.set_speed(1, 20, "pad")
    armed.motors.set_speed(1, 99, "keys")
    armed.motors.set_speed(1, 99)
    assert armed.motors.drive(1) == Drive.at(20)
    armed.motors.let_go("keys")
    assert armed.motors.holder == "pad"


def test_a_wish_that_comes_after_letting_go_is_dropped(armed: Asked) -> None:
    armed.motors.hold("pad")
    armed.motors.set_speed(1, 20, "pad")
    armed.motors.let_go("pad")
    armed.motors.set_speed(1, 99, "pad")
    assert armed.motors.drive(1) == Drive.brake(127)


def test_nothing_can_be_held_before_the_motors_are_armed(asked: Asked) -> None:
    asked.motors.allow(True)
    assert not asked.motors.hold("pad")


def test_a_control_that_disappears_stops_everything(armed: Asked) -> None:
    armed.motors.hold("gamepad")
    armed.motors.set_speed(1, 20, "gamepad")
    armed.motors.lose("keys", "not held")
    assert armed.stops == 0
    armed.motors.lose("gamepad", "The gamepad is gone.")
    assert armed.stops == 1
    assert not armed.motors.armed
    assert armed.motors.stop_reason == "The gamepad is gone."
    assert armed.motors.holder == ""


@pytest.mark.parametrize("linked", [False, True])
def test_pad_and_keys_ask_both_motors_in_one_message(armed: Asked, *, linked: bool) -> None:
    armed.motors.set_linked(linked)
    drive = HeldDrive(armed.motors, "pad")
    for _ in range(3):
        drive.steer(0.5, 0.1)
        drive.let_go()
    assert len(armed.wishes) == 6
    assert {type(wish) for wish in armed.wishes} == {SetDrives}


def test_held_control_drives_linked_motors_straight(armed: Asked) -> None:
    armed.motors.set_linked(True)
    HeldDrive(armed.motors, "pad").steer(0.5, 0.3)
    assert armed.motors.drive(1) == armed.motors.drive(2) == Drive.at(64)


def test_a_ceiling_slows_both_motors_in_one_message(armed: Asked) -> None:
    armed.motors.set_speeds(100, -100)
    armed.wishes.clear()
    armed.motors.set_ceiling(30)
    both = SetDrive(1, Drive.at(30), True), SetDrive(2, Drive.at(-30), True)
    assert armed.wishes == [SetDrives(both)]


def test_what_a_motor_does_already_is_not_asked_again_with_the_other(armed: Asked) -> None:
    armed.motors.set_speeds(50, 50)
    armed.motors.set_speeds(50, 60)
    armed.motors.set_speeds(50, 60)
    assert armed.wishes[1:] == [SetDrive(2, Drive.at(60), True)]


def test_a_speed_that_no_motor_has_is_refused_for_both(armed: Asked) -> None:
    with pytest.raises(BadRequest, match="-127 to 127"):
        armed.motors.set_speeds(50, 128)
    assert armed.wishes == []
