"""Replies compared with the command documentation."""

import pytest

from trex_gui.core.errors import BadReply
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.commands import (
    Command,
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
from trex_gui.devices.trex.protocol.errors import ResultCode
from trex_gui.devices.trex.protocol.flags import Mode, Status, UartError


# The documentation prints 2716 for channel 5, but its bytes 9B 0A and its 1.086 ms are 2715.
@pytest.mark.parametrize(
    ("command", "reply", "value"),
    [
        (GetMode(), "52", Mode.RC),
        (GetMode(), "41", Mode.ANALOG),
        (GetMode(), "72", Mode.SERIAL_RC),
        (GetMode(), "61", Mode.SERIAL_ANALOG),
        (GetSerialControl(), "00", False),
        (GetSerialControl(), "01", True),
        (GetStatus(), "00", Status(0)),
        (GetStatus(), "81", Status.MOTOR2_OVER_LIMIT | Status.UART_ERROR),
        (GetUartErrors(), "00", UartError(0)),
        (GetUartErrors(), "60", UartError.FORMAT | UartError.CRC),
        (GetRawChannels(0x13), "35 0e ff ff 9b 0a", {1: 3637, 2: None, 5: 2715}),
        (GetRawChannels(0x08), "fe ff", {4: 0xFFFE}),
        (GetRawChannels(), "01 00 02 00 03 00 04 00 05 00", {1: 1, 2: 2, 3: 3, 4: 4, 5: 5}),
        (GetRawChannels(0), "", {}),
        (GetRemappedChannels(), "00 7f ff 01 81", {1: 0, 2: 127, 3: -127, 4: 1, 5: -1}),
        (GetRemappedChannels(0x06), "64 e4", {2: 100, 3: -100}),
        (GetRemappedChannels(0x01), "80", {1: 0}),
        (GetRemappedChannels(0), "", {}),
        (GetCurrent(1), "37", 55),
        (GetCurrent(2), "ff", 255),
        (GetCurrents(), "37 00", (55, 0)),
        (GetCalibration(1), "c4 09 a6 0e 88 13 4b 00", Calibration(2500, 3750, 5000, 75)),
        (GetCalibration(5), "00 00 00 02 ff 03 14 00", Calibration(0, 512, 1023, 20)),
        (GetCalibratedChannels(), "00", 0),
        (GetCalibratedChannels(), "12", 0x12),
        (GetParameter(0x00), "07", 7),
        (GetParameter(0x7E), "7f", 127),
        (Null(), "", None),
    ],
)
def test_replies_are_decoded_as_documented(
    command: Command[object], reply: str, value: object
) -> None:
    raw = bytes.fromhex(reply)
    assert command.reply_size(raw) == len(raw)
    assert command.parse(raw) == value


@pytest.mark.parametrize(
    ("reply", "model", "firmware", "text"),
    [
        (b"TReX1.0", "trex", "1.0", "TReX 1.0"),
        (b"TReX2.9", "trex", "2.9", "TReX 2.9"),
        (b"TReXJr1.0", "trexjr", "1.0", "TReX Jr 1.0"),
    ],
)
def test_signature_gives_model_and_firmware(
    reply: bytes, model: str, firmware: str, text: str
) -> None:
    signature = GetSignature().parse(reply)
    assert (signature.model.key, signature.firmware) == (model, firmware)
    assert str(signature) == text


@pytest.mark.parametrize(
    ("head", "size"), [(b"", 7), (b"TReXJ", 7), (b"TReXJr", 9), (b"TReX1.0", 7)]
)
def test_signature_has_nine_bytes_only_for_trex_jr(head: bytes, size: int) -> None:
    assert GetSignature().reply_size(head) == size


@pytest.mark.parametrize(
    "reply",
    [
        b"Arduino",
        b"TREX1.0",
        b"TReX1,0",
        b"TReX1.x",
        b"TReX\xb2.0",
        b"TReXJr1",
        b"TReXJr1-2",
        b"\xe8#\x00x'\\1",
    ],
)
def test_other_signature_is_rejected_and_shown_in_hexadecimal(reply: bytes) -> None:
    with pytest.raises(BadReply) as rejected:
        GetSignature().parse(reply)
    digits = " ".join(f"{byte:02X}" for byte in reply)
    assert str(rejected.value) == f"{digits} is not the signature of a TReX"


@pytest.mark.parametrize(
    ("command", "reply"),
    [
        (GetMode(), "00"),
        (GetMode(), "53"),
        (GetMode(), "ff"),
        (GetSerialControl(), "02"),
        (GetSerialControl(), "ff"),
        (GetCalibratedChannels(), "20"),
        (GetCalibratedChannels(), "ff"),
        (GetParameter(1), "80"),
        (GetParameter(1), "ff"),
    ],
)
def test_undocumented_reply_is_rejected(command: Command[object], reply: str) -> None:
    with pytest.raises(BadReply):
        command.parse(bytes.fromhex(reply))


def test_unused_status_bits_do_not_hide_used_bits() -> None:
    assert Status.MOTOR1_FAULT in GetStatus().parse(b"\x1e")


# --- Replies to writes ------------------------------------------------------------------

WRITES: list[Command[ResultCode]] = [
    SetParameter(7, 5),
    SetCalibration(1, Calibration(2500, 3750, 5000, 75)),
]


@pytest.mark.parametrize("command", WRITES)
def test_write_reply_is_a_result_code(command: Command[ResultCode]) -> None:
    assert [command.parse(bytes([code])) for code in range(4)] == [
        ResultCode.OK,
        ResultCode.BAD_PARAMETER,
        ResultCode.BAD_VALUE,
        ResultCode.NOT_SERIAL_MODE,
    ]
    for code in (4, 0x55, 0xFF):
        with pytest.raises(BadReply, match="not a TReX result code"):
            command.parse(bytes([code]))


def test_writes_have_their_documented_reply_time() -> None:
    assert [command.max_reply_delay for command in WRITES] == pytest.approx([0.05, 0.1])
