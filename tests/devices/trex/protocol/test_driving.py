"""Motor commands: directions, speeds, and what stops everything."""

import pytest

from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.protocol.commands import (
    STOP,
    Command,
    DriveAuxiliary,
    DriveBoth,
    DriveMotor,
)
from trex_gui.devices.trex.protocol.driving import Direction, Drive
from trex_gui.devices.trex.protocol.framing import Framing


def test_direction_bits_match_documentation() -> None:
    bits = {direction.name: int(direction) for direction in Direction}
    assert bits == {"BRAKE": 0b00, "REVERSE": 0b01, "FORWARD": 0b10, "BRAKE_TOO": 0b11}


@pytest.mark.parametrize(
    ("speed", "packet"),
    [(127, "c2 7f"), (1, "c2 01"), (0, "c2 00"), (-1, "c1 01"), (-127, "c1 7f")],
)
def test_signed_speed_becomes_direction_and_magnitude(speed: int, packet: str) -> None:
    assert Framing().encode(DriveMotor(1, Drive.at(speed))) == bytes.fromhex(packet)


@pytest.mark.parametrize("speed", [-128, 128])
def test_signed_speed_beyond_127_is_rejected_with_limits(speed: int) -> None:
    with pytest.raises(BadRequest, match=f"-127 to 127, not {speed}"):
        Drive.at(speed)


def test_signed_speeds_round_trip() -> None:
    assert all(Drive.at(speed).signed == speed for speed in range(-127, 128))


def test_braking_has_signed_speed_0() -> None:
    assert Drive.brake(100).signed == 0
    assert Drive(Direction.BRAKE_TOO, 100).signed == 0


def test_brake_without_duty_is_full_brake() -> None:
    assert Framing().encode(DriveMotor(2, Drive.brake())) == bytes.fromhex("c8 7f")


def test_brake_with_duty_0_coasts() -> None:
    assert Framing().encode(DriveMotor(2, Drive.brake(0))) == bytes.fromhex("c8 00")


@pytest.mark.parametrize("duty", [-1, 128])
def test_invalid_brake_duty_is_rejected_with_limits(duty: int) -> None:
    with pytest.raises(BadRequest, match=f"brake duty is 0 to 127, not {duty}"):
        Drive.brake(duty)


def test_stop_brakes_both_motors_and_turns_auxiliary_off() -> None:
    packets = b"".join(Framing().encode(command) for command in STOP)
    assert packets == bytes.fromhex("d0 7f 7f f0 00")


@pytest.mark.parametrize("motor", [-1, 0, 3])
def test_motor_number_other_than_1_and_2_is_rejected(motor: int) -> None:
    with pytest.raises(BadRequest, match=f"motors are numbered 1 and 2, not {motor}"):
        _ = DriveMotor(motor, Drive.at(0)).opcode


@pytest.mark.parametrize(
    "command",
    [
        DriveMotor(1, Drive(Direction.FORWARD, 128)),
        DriveMotor(1, Drive(Direction.FORWARD, -1)),
        DriveBoth(Drive(Direction.FORWARD, 128), Drive.at(0)),
        DriveBoth(Drive.at(0), Drive(Direction.FORWARD, 128)),
        DriveAuxiliary(128),
        DriveAuxiliary(-1),
    ],
)
def test_speed_outside_0_to_127_is_rejected_with_limits(command: Command[None]) -> None:
    with pytest.raises(BadRequest, match=r"speed.* is 0 to 127, not"):
        command.data()
