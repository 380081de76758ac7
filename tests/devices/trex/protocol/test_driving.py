"""Motor commands: directions, speeds and stops."""

import pytest

from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.protocol.commands import STOP, DriveMotor
from trex_gui.devices.trex.protocol.driving import Direction, Drive
from trex_gui.devices.trex.protocol.framing import Framing


@pytest.mark.parametrize(
    ("drive", "packet"),
    [
        (Drive.at(127), "c2 7f"),
        (Drive.at(1), "c2 01"),
        (Drive.at(0), "c2 00"),
        (Drive.at(-1), "c1 01"),
        (Drive.at(-127), "c1 7f"),
        (Drive.brake(), "c0 7f"),
        (Drive.brake(0), "c0 00"),
    ],
)
def test_drive_becomes_direction_and_magnitude(drive: Drive, packet: str) -> None:
    assert Framing().encode(DriveMotor(1, drive)) == bytes.fromhex(packet)


@pytest.mark.parametrize("speed", [-128, 128])
def test_signed_speed_beyond_127_is_rejected_with_limits(speed: int) -> None:
    with pytest.raises(BadRequest, match=f"-127 to 127, not {speed}"):
        Drive.at(speed)


def test_signed_speeds_round_trip() -> None:
    assert all(Drive.at(speed).signed == speed for speed in range(-127, 128))


def test_signed_speed_of_a_brake_is_0() -> None:
    assert Drive.brake(100).signed == 0
    assert Drive(Direction.BRAKE_ALTERNATIVE, 100).signed == 0


@pytest.mark.parametrize("duty", [-1, 128])
def test_invalid_brake_duty_is_rejected_with_limits(duty: int) -> None:
    with pytest.raises(BadRequest, match=f"brake duty must be 0 to 127, not {duty}"):
        Drive.brake(duty)


def test_stop_brakes_both_motors_and_turns_auxiliary_off() -> None:
    packets = b"".join(Framing().encode(command) for command in STOP)
    assert packets == bytes.fromhex("d0 7f 7f f0 00")
