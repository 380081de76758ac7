"""Reading what a board answers to one command, with an echo or a CRC before or behind it."""

import pytest

from trex_gui.devices.trex.protocol.commands import (
    Command,
    DriveAuxiliary,
    GetCurrent,
    GetMode,
    GetRawChannels,
    GetSignature,
    Null,
    SetParameter,
)
from trex_gui.devices.trex.protocol.errors import ResultCode
from trex_gui.devices.trex.protocol.flags import Mode
from trex_gui.devices.trex.protocol.framing import (
    Framing,
    Malformed,
    NeedData,
    Reply,
    ReplyParser,
    crc7,
)

WITH_CRC = Framing(None, 0x89)


def test_documented_reply_to_86_13_is_read() -> None:
    raw = bytes.fromhex("35 0e ff ff 9b 0a")
    assert ReplyParser(GetRawChannels(0x13)).feed(raw) == Reply(raw, {1: 3637, 2: None, 5: 2715})


def test_reply_may_arrive_byte_by_byte() -> None:
    parser = ReplyParser(GetRawChannels(0x13))
    raw = bytes.fromhex("35 0e ff ff 9b 0a")
    lacking = [parser.feed(raw[i : i + 1]) for i in range(5)]
    assert lacking == [NeedData(5), NeedData(4), NeedData(3), NeedData(2), NeedData(1)]
    assert parser.feed(raw[5:]) == Reply(raw, {1: 3637, 2: None, 5: 2715})


def test_parser_initially_needs_whole_reply() -> None:
    assert ReplyParser(GetRawChannels()).feed() == NeedData(10)


@pytest.mark.parametrize("command", [Null(), DriveAuxiliary(127), GetRawChannels(0)])
def test_command_without_reply_is_complete_at_once(command: Command[object]) -> None:
    reply = ReplyParser(command).feed()
    assert isinstance(reply, Reply)
    assert reply.raw == b""


@pytest.mark.parametrize(
    ("signature", "model"), [(b"TReX1.0", "TReX 1.0"), (b"TReXJr1.2", "TReX Jr 1.2")]
)
@pytest.mark.parametrize("cut", range(1, 7))
def test_signature_cut_anywhere_is_read(signature: bytes, model: str, cut: int) -> None:
    parser = ReplyParser(GetSignature())
    assert isinstance(parser.feed(signature[:cut]), NeedData)
    reply = parser.feed(signature[cut:])
    assert isinstance(reply, Reply)
    assert str(reply.value) == model


def test_trex_jr_signature_needs_two_more_bytes() -> None:
    assert ReplyParser(GetSignature()).feed(b"TReXJr1") == NeedData(2)


def test_trex_signature_ends_after_seven_bytes() -> None:
    assert ReplyParser(GetSignature()).feed(b"TReX1.") == NeedData(1)


@pytest.mark.parametrize("signature", [b"TReX1.0", b"TReXJr1.2"])
def test_signature_with_crc_is_read(signature: bytes) -> None:
    raw = signature + bytes([crc7(signature)])
    parser = ReplyParser(GetSignature(), WITH_CRC)
    assert parser.feed(signature) == NeedData(1)
    assert isinstance(parser.feed(raw[-1:]), Reply)


def test_reply_of_other_device_is_malformed() -> None:
    result = ReplyParser(GetSignature()).feed(b"ERROR\r\n")
    assert isinstance(result, Malformed)
    assert "not the signature of a TReX" in result.reason


def test_one_byte_reply_with_crc_is_read() -> None:
    # 81, as a packet of one byte: the vector whose CRC is 48.
    raw = bytes.fromhex("81 48")
    assert ReplyParser(GetCurrent(1), WITH_CRC).feed(raw) == Reply(raw, 0x81)


def test_wrong_crc_makes_reply_malformed_and_names_both() -> None:
    raw = bytes.fromhex("81 49")
    result = ReplyParser(GetCurrent(1), WITH_CRC).feed(raw)
    assert result == Malformed(raw, "the CRC is 49, not 48")


def test_empty_reply_has_no_crc() -> None:
    assert isinstance(ReplyParser(DriveAuxiliary(127), WITH_CRC).feed(), Reply)


def test_bytes_after_reply_make_it_malformed() -> None:
    result = ReplyParser(GetMode()).feed(b"rr")
    assert isinstance(result, Malformed)
    assert result.raw == b"rr"
    assert "more than the reply has" in result.reason


def test_one_extra_byte_is_reported_in_singular() -> None:
    result = ReplyParser(GetMode()).feed(b"rr")
    assert isinstance(result, Malformed)
    assert "1 bytes" not in result.reason


def test_later_extra_byte_makes_reply_malformed() -> None:
    parser = ReplyParser(GetMode())
    assert isinstance(parser.feed(b"r"), Reply)
    assert isinstance(parser.feed(b"\x00"), Malformed)


def test_byte_after_command_without_reply_is_malformed() -> None:
    assert isinstance(ReplyParser(DriveAuxiliary(127)).feed(b"\x00"), Malformed)


def test_invalid_reply_is_malformed_with_reason() -> None:
    result = ReplyParser(GetMode()).feed(b"x")
    assert isinstance(result, Malformed)
    assert "not a TReX mode" in result.reason


@pytest.mark.parametrize(
    ("framing", "echo"),
    [
        (Framing(), "86 01"),
        (Framing(7), "80 07 06 01"),
    ],
)
def test_echo_is_read_before_reply(framing: Framing, echo: str) -> None:
    raw = bytes.fromhex(echo + "a6 0e")
    parser = ReplyParser(GetRawChannels(1), framing, echo=True)
    assert parser.feed() == NeedData(len(raw))
    assert parser.feed(raw) == Reply(raw, {1: 3750})


def test_echo_includes_crc_of_packet() -> None:
    raw = bytes.fromhex("af 00 07 55 2a 47 00 00")
    parser = ReplyParser(SetParameter(0, 7), WITH_CRC, echo=True)
    assert parser.feed(raw) == Reply(raw, ResultCode.OK)


def test_echo_of_null_command_is_read() -> None:
    parser = ReplyParser(Null(), echo=True)
    assert parser.feed() == NeedData(1)
    assert parser.feed(b"\xff") == Reply(b"\xff", None)


def test_motor_command_returns_only_its_echo() -> None:
    raw = bytes.fromhex("f0 7f")
    assert ReplyParser(DriveAuxiliary(127), echo=True).feed(raw) == Reply(raw, None)


def test_wrong_echo_is_malformed_and_names_sent_packet() -> None:
    result = ReplyParser(GetRawChannels(0x13), echo=True).feed(bytes.fromhex("86 12"))
    assert isinstance(result, Malformed)
    assert "86 13" in result.reason


def test_wrong_echo_is_detected_at_first_wrong_byte() -> None:
    parser = ReplyParser(GetRawChannels(0x13), echo=True)
    assert isinstance(parser.feed(b"\x86"), NeedData)
    assert isinstance(parser.feed(b"\x93"), Malformed)


def test_reply_without_expected_echo_is_malformed() -> None:
    assert isinstance(ReplyParser(GetMode(), echo=True).feed(b"r"), Malformed)


def test_unexpected_echo_is_malformed() -> None:
    assert isinstance(ReplyParser(GetMode()).feed(b"\x82r"), Malformed)


def test_reply_value_has_type_of_its_command() -> None:
    reply = ReplyParser(GetMode()).feed(b"a")
    assert isinstance(reply, Reply)
    assert reply.value is Mode.SERIAL_ANALOG
