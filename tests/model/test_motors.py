"""What a person wants the motors to do, and when it may be sent."""

import pytest
from pytestqt.qtbot import QtBot

from trex_gui.link.messages import SetAuxiliary, SetDrive
from trex_gui.model.motors import Motors
from trex_gui.protocol.commands import Drive
from trex_gui.protocol.errors import BadRequest


class Asked:
    """Motors, and what they asked for."""

    def __init__(self) -> None:
        self.motors = Motors()
        self.wishes: list[SetDrive | SetAuxiliary] = []
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
    assert [wish.accelerate for wish in armed.wishes] == [accelerate, accelerate]


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
