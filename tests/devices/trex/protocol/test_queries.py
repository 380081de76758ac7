"""Commands 0x81 to 0x9F and 0xFF: what the replies mean, after the command documentation."""

import pytest

from trex_gui.core.errors import BadReply, BadRequest
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
)
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.flags import Mode, Status, UartError


# The documentation prints 2716 for channel 5; its own bytes 9B 0A and its 1.086 ms are 2715.
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
        (GetStatus(), "01", Status.UART_ERROR),
        (GetStatus(), "10", Status.MOTOR1_FAULT),
        (GetStatus(), "20", Status.MOTOR1_OVER_LIMIT),
        (GetStatus(), "40", Status.MOTOR2_FAULT),
        (GetStatus(), "80", Status.MOTOR2_OVER_LIMIT),
        (GetStatus(), "81", Status.MOTOR2_OVER_LIMIT | Status.UART_ERROR),
        (GetUartErrors(), "00", UartError(0)),
        (GetUartErrors(), "80", UartError.TIMEOUT),
        (GetUartErrors(), "40", UartError.FORMAT),
        (GetUartErrors(), "20", UartError.CRC),
        (GetUartErrors(), "10", UartError.FRAMING),
        (GetUartErrors(), "08", UartError.DATA_OVERRUN),
        (GetUartErrors(), "04", UartError.PARITY),
        (GetUartErrors(), "02", UartError.READ_OVERRUN),
        (GetUartErrors(), "01", UartError.SEND_OVERRUN),
        (GetUartErrors(), "60", UartError.FORMAT | UartError.CRC),
        (GetRawChannels(0x13), "35 0e ff ff 9b 0a", {1: 3637, 2: None, 5: 2715}),
        (GetRawChannels(0x01), "a6 0e", {1: 3750}),
        (GetRawChannels(0x10), "ff 03", {5: 1023}),
        (GetRawChannels(0x08), "fe ff", {4: 0xFFFE}),
        (
            GetRawChannels(),
            "01 00 02 00 03 00 04 00 05 00",
            {1: 1, 2: 2, 3: 3, 4: 4, 5: 5},
        ),
        (GetRawChannels(0), "", {}),
        (GetRemappedChannels(), "00 7f ff 01 81", {1: 0, 2: 127, 3: -127, 4: 1, 5: -1}),
        (GetRemappedChannels(0x06), "64 e4", {2: 100, 3: -100}),
        (GetRemappedChannels(0x04), "40", {3: 64}),
        (GetRemappedChannels(0x01), "80", {1: 0}),
        (GetRemappedChannels(0), "", {}),
        (GetCurrent(1), "37", 55),
        (GetCurrent(2), "ff", 255),
        (GetCurrents(), "37 00", (55, 0)),
        (GetCurrents(), "00 ff", (0, 255)),
        (GetCalibration(1), "c4 09 a6 0e 88 13 4b 00", Calibration(2500, 3750, 5000, 75)),
        (GetCalibration(5), "00 00 00 02 ff 03 14 00", Calibration(0, 512, 1023, 20)),
        (GetCalibratedChannels(), "00", 0),
        (GetCalibratedChannels(), "1f", 0x1F),
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
        (b"TReX1.3", "trex", "1.3", "TReX 1.3"),
        (b"TReX2.9", "trex", "2.9", "TReX 2.9"),
        (b"TReXJr1.0", "trexjr", "1.0", "TReX Jr 1.0"),
        (bytes.fromhex("54 52 65 58 4a 72 31 2e 32"), "trexjr", "1.2", "TReX Jr 1.2"),
    ],
)
def test_signature_gives_model_and_firmware(
    reply: bytes, model: str, firmware: str, text: str
) -> None:
    signature = GetSignature().parse(reply)
    assert (signature.model.key, signature.firmware) == (model, firmware)
    assert str(signature) == text


@pytest.mark.parametrize(
    ("head", "size"),
    [
        (b"", 7),
        (b"T", 7),
        (b"TReX", 7),
        (b"TReXJ", 7),
        (b"TReXJr", 9),
        (b"TReXJr1.2", 9),
        (b"TReX1", 7),
        (b"TReX1.0", 7),
    ],
)
def test_signature_has_nine_bytes_only_for_trex_jr(head: bytes, size: int) -> None:
    assert GetSignature().reply_size(head) == size


@pytest.mark.parametrize(
    "reply",
    [
        b"Arduino",
        b"TREX1.0",
        b"TReX1,0",
        b"TReX.10",
        b"TReX1.x",
        b"TReX\xb2.0",
        b"TReX1.\xb9",
        b"TReXJr1",
        b"TReXJR1.2",
        b"TReXJr1-2",
        b"\xff\xff\xff\xff\xff\xff\xff",
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


def test_unused_status_bits_do_not_hide_used_ones() -> None:
    assert Status.MOTOR1_FAULT in GetStatus().parse(b"\x1e")


def test_raw_channel_reply_has_two_bytes_per_channel() -> None:
    for mask in range(32):
        assert GetRawChannels(mask).reply_size() == 2 * mask.bit_count()


def test_remapped_channel_reply_has_one_byte_per_channel() -> None:
    for mask in range(32):
        assert GetRemappedChannels(mask).reply_size() == mask.bit_count()


def test_current_of_55_is_8_25_a_on_trex() -> None:
    count = GetCurrent(1).parse(bytes.fromhex("37"))
    assert count * device_table().model("trex").current_unit == pytest.approx(8.25)


def test_current_of_55_is_2_2_a_on_trex_jr() -> None:
    count = GetCurrent(1).parse(bytes.fromhex("37"))
    assert count * device_table().model("trexjr").current_unit == pytest.approx(2.2)


@pytest.mark.parametrize("mask", [-1, 0x20, 0x7F, 0x80])
@pytest.mark.parametrize("kind", [GetRawChannels, GetRemappedChannels])
def test_mask_beyond_five_channels_is_rejected(
    kind: type[GetRawChannels | GetRemappedChannels], mask: int
) -> None:
    with pytest.raises(BadRequest, match=f"channel mask is 0 to 31, not {mask}"):
        kind(mask).data()


@pytest.mark.parametrize("motor", [-1, 0, 3])
def test_current_of_motor_other_than_1_and_2_is_rejected(motor: int) -> None:
    with pytest.raises(BadRequest, match=f"motors are numbered 1 and 2, not {motor}"):
        _ = GetCurrent(motor).opcode


@pytest.mark.parametrize("channel", [-1, 0, 6])
def test_calibration_of_channel_beyond_1_to_5_is_rejected(channel: int) -> None:
    with pytest.raises(BadRequest, match=f"channels are numbered 1 to 5, not {channel}"):
        _ = GetCalibration(channel).opcode


@pytest.mark.parametrize("number", [-1, 128])
def test_parameter_number_beyond_0_to_127_is_rejected(number: int) -> None:
    with pytest.raises(BadRequest, match=f"parameter number is 0 to 127, not {number}"):
        GetParameter(number).data()
