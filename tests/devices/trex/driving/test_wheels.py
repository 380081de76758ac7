"""Motors of several boards as the wheels of one robot."""

import pytest

from trex_gui.devices.trex.driving.requests import SetMotor, SetMotors
from trex_gui.devices.trex.driving.wheels import (
    LEFT,
    RIGHT,
    Wheel,
    both_sides_of_each,
    packed,
    setpoints_of,
    unpacked,
)
from trex_gui.devices.trex.protocol.driving import Drive

BOTH = SetMotors((SetMotor(LEFT, Drive.at(30), True), SetMotor(RIGHT, Drive.at(-20), True)))

LEFT_AND_RIGHT = tuple(
    Wheel(board, motor, side) for board, side in ((7, LEFT), (9, RIGHT)) for motor in (1, 2)
)


def speeds(setpoints: dict[int, SetMotor | SetMotors]) -> dict[int, dict[int, int]]:
    """Return the speed of each motor by board."""
    return {
        board: {
            setpoint.motor: setpoint.drive.signed
            for setpoint in (request.drives if isinstance(request, SetMotors) else (request,))
        }
        for board, request in setpoints.items()
    }


def test_each_side_drives_its_motors() -> None:
    assert speeds(setpoints_of(both_sides_of_each((7, 9)), BOTH)) == {
        7: {1: 30, 2: -20},
        9: {1: 30, 2: -20},
    }
    assert speeds(setpoints_of(LEFT_AND_RIGHT, BOTH)) == {
        7: {1: 30, 2: 30},
        9: {1: -20, 2: -20},
    }


def test_reversed_motor_turns_backwards_and_brakes_equally() -> None:
    wheels = (Wheel(7, 1, LEFT), Wheel(7, 2, LEFT, is_reversed=True))
    assert speeds(setpoints_of(wheels, SetMotor(LEFT, Drive.at(30)))) == {7: {1: 30, 2: -30}}
    assert setpoints_of(wheels, SetMotor(RIGHT, Drive.at(30))) == {}
    brake = Drive.brake(50)
    (setpoint,) = setpoints_of(wheels[1:], SetMotor(LEFT, brake)).values()
    assert setpoint == SetMotor(2, brake)


def test_packed_wheels_are_unpacked_unchanged() -> None:
    wheels = (*LEFT_AND_RIGHT, Wheel(127, 2, RIGHT, is_reversed=True))
    assert unpacked(packed(wheels)) == wheels
    assert unpacked("") == ()


@pytest.mark.parametrize("text", ["7.3.1+", "7.1+", "x", "7.1.1"])
def test_text_that_contains_no_wheels_is_rejected(text: str) -> None:
    with pytest.raises(ValueError, match="is not a list of wheels"):
        unpacked(text)
