"""Packets of every command in both protocols.

The expected bytes are from the TReX 1.0 command documentation and the guide, 5.b.
"""

import pytest

from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.commands import (
    COMMANDS,
    Command,
    DriveAuxiliary,
    DriveBoth,
    DriveMotor,
    GetCalibratedChannels,
    GetCalibration,
    GetCurrent,
    GetCurrents,
    GetMode,
    GetParameter,
    GetRawChannels,
    GetRemappedChannels,
    GetSerialControl,
    GetSignature,
    GetStatus,
    GetUartErrors,
    Null,
    SetCalibration,
    SetParameter,
)
from trex_gui.devices.trex.protocol.driving import Direction, Drive
from trex_gui.devices.trex.protocol.framing import Framing, Packet, PacketParser

TYPICAL = Calibration(2500, 3750, 5000, 75)
TYPICAL_BYTES = "44 13 26 1d 08 27 4b 00 55 2a"

REVERSE_100 = Drive(Direction.REVERSE, 100)
FORWARD_127 = Drive(Direction.FORWARD, 127)
FULL_BRAKE = Drive(Direction.BRAKE, 127)
OTHER_BRAKE = Drive(Direction.BRAKE_ALTERNATIVE, 1)

PACKETS: list[tuple[Command[object], str, str]] = [
    (GetSignature(), "81", "80 07 01"),
    (GetMode(), "82", "80 07 02"),
    (GetSerialControl(), "83", "80 07 03"),
    (GetStatus(), "84", "80 07 04"),
    (GetUartErrors(), "85", "80 07 05"),
    (GetRawChannels(), "86 1f", "80 07 06 1f"),
    (GetRawChannels(0x13), "86 13", "80 07 06 13"),
    (GetRawChannels(0), "86 00", "80 07 06 00"),
    (GetRemappedChannels(), "87 1f", "80 07 07 1f"),
    (GetRemappedChannels(0x04), "87 04", "80 07 07 04"),
    (GetCurrent(1), "8d", "80 07 0d"),
    (GetCurrent(2), "8e", "80 07 0e"),
    (GetCurrents(), "8f", "80 07 0f"),
    (GetCalibration(1), "90", "80 07 10"),
    (GetCalibration(5), "94", "80 07 14"),
    (GetCalibratedChannels(), "95", "80 07 15"),
    (GetParameter(0x7E), "9f 7e", "80 07 1f 7e"),
    (SetCalibration(1, TYPICAL), "a0" + TYPICAL_BYTES, "80 07 20" + TYPICAL_BYTES),
    (SetCalibration(5, TYPICAL), "a4" + TYPICAL_BYTES, "80 07 24" + TYPICAL_BYTES),
    (SetParameter(0x7B, 1), "af 7b 01 55 2a", "80 07 2f 7b 01 55 2a"),
    (SetParameter(0x7F, 0x7F), "af 7f 7f 55 2a", "80 07 2f 7f 7f 55 2a"),
    (DriveMotor(1, FULL_BRAKE), "c0 7f", "80 07 40 7f"),
    (DriveMotor(1, REVERSE_100), "c1 64", "80 07 41 64"),
    (DriveMotor(1, FORWARD_127), "c2 7f", "80 07 42 7f"),
    (DriveMotor(1, OTHER_BRAKE), "c3 01", "80 07 43 01"),
    (DriveMotor(1, FULL_BRAKE, accelerate=True), "c4 7f", "80 07 44 7f"),
    (DriveMotor(1, FORWARD_127, accelerate=True), "c6 7f", "80 07 46 7f"),
    (DriveMotor(2, FULL_BRAKE), "c8 7f", "80 07 48 7f"),
    (DriveMotor(2, REVERSE_100), "c9 64", "80 07 49 64"),
    (DriveMotor(2, REVERSE_100, accelerate=True), "cd 64", "80 07 4d 64"),
    (DriveBoth(FORWARD_127, REVERSE_100), "d6 7f 64", "80 07 56 7f 64"),
    (DriveBoth(FORWARD_127, REVERSE_100, accelerate=True), "e6 7f 64", "80 07 66 7f 64"),
    (DriveAuxiliary(127), "f0 7f", "80 07 70 7f"),
    (DriveAuxiliary(0), "f0 00", "80 07 70 00"),
    (DriveAuxiliary(64, accelerate=True), "f1 40", "80 07 71 40"),
    (Null(), "ff", "80 07 7f"),
]


def test_command_bytes_match_documentation() -> None:
    assert set(COMMANDS) == {
        *(0x81, 0x82, 0x83, 0x84, 0x85, 0x86, 0x87),
        *(0x8D, 0x8E, 0x8F),
        *(0x90, 0x91, 0x92, 0x93, 0x94, 0x95),
        0x9F,
        *(0xA0, 0xA1, 0xA2, 0xA3, 0xA4),
        0xAF,
        *range(0xC0, 0xF2),
        0xFF,
    }


@pytest.mark.parametrize(("base", "accelerate"), [(0xD0, False), (0xE0, True)])
@pytest.mark.parametrize("m2", Direction)
@pytest.mark.parametrize("m1", Direction)
def test_drive_both_command_byte_holds_both_directions(
    m1: Direction, m2: Direction, base: int, accelerate: bool
) -> None:
    # The formula of the documentation. For accelerating, it has 0xD0 in place of 0xE0 by mistake.
    raw = bytes([base | m2 * 4 | m1, 5, 0x60])
    command = DriveBoth(Drive(m1, 5), Drive(m2, 0x60), accelerate)
    assert Framing().encode(command) == raw
    assert PacketParser().feed(raw) == [Packet(raw, command, None)]


def test_examples_cover_every_command() -> None:
    assert {type(command) for command, _, _ in PACKETS} == set(COMMANDS.values())


@pytest.mark.parametrize(
    ("command", "compact", "expanded"), PACKETS, ids=[packet for _, packet, _ in PACKETS]
)
def test_packets_of_both_protocols_match_documentation(
    command: Command[object], compact: str, expanded: str
) -> None:
    assert Framing().encode(command) == bytes.fromhex(compact)
    assert Framing(7).encode(command) == bytes.fromhex(expanded)


@pytest.mark.parametrize(
    ("command", "sentence"),
    [
        *((GetRawChannels(mask), "channel mask must be 0 to 31, not") for mask in (-1, 0x20, 0x80)),
        *((GetRemappedChannels(mask), "channel mask must be 0 to 31, not") for mask in (-1, 0x20)),
        *((GetCurrent(motor), "the motor number must be 1 or 2, not") for motor in (-1, 0, 3)),
        *(
            (DriveMotor(motor, FULL_BRAKE), "motor number must be 1 or 2, not")
            for motor in (-1, 0, 3)
        ),
        *(
            (GetCalibration(channel), "the channel number must be 1 to 5, not")
            for channel in (0, 6)
        ),
        *(
            (SetCalibration(channel, TYPICAL), "channel number must be 1 to 5, not")
            for channel in (-1, 0, 6)
        ),
        *((GetParameter(number), "parameter number must be 0 to 127, not") for number in (-1, 128)),
        *(
            (SetParameter(number, 0), "parameter number must be 0 to 127, not")
            for number in (-1, 128)
        ),
        *((SetParameter(0, value), "parameter value must be 0 to 127, not") for value in (-1, 128)),
        *(
            (DriveMotor(1, Drive(Direction.FORWARD, speed)), "must be 0 to 127")
            for speed in (-1, 128)
        ),
        (DriveBoth(Drive(Direction.FORWARD, 128), FULL_BRAKE), "must be 0 to 127, not 128"),
        (DriveBoth(FULL_BRAKE, Drive(Direction.FORWARD, 128)), "must be 0 to 127, not 128"),
        *((DriveAuxiliary(speed), "must be 0 to 127, not") for speed in (-1, 128)),
    ],
)
def test_number_outside_its_limits_is_rejected_with_limits(
    command: Command[object], sentence: str
) -> None:
    with pytest.raises(BadRequest, match=sentence):
        Framing().encode(command)


def test_only_motor_and_null_commands_have_no_reply() -> None:
    for command, compact, _ in PACKETS:
        has_reply = command.opcode < 0xC0 and compact != "86 00"  # 86 00 requests no channel
        assert (command.reply_size() > 0) is has_reply


def test_only_motor_commands_move_motors() -> None:
    assert {opcode for opcode, cls in COMMANDS.items() if cls.moves} == set(range(0xC0, 0xF2))
