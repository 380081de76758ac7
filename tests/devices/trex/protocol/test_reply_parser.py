"""Reading what a board answers to one command, with an echo or a CRC before or behind it."""

from trex_gui.devices.trex.protocol.commands import (
    GetCurrent,
    GetMode,
    GetRawChannels,
    GetSignature,
)
from trex_gui.devices.trex.protocol.framing import (
    Framing,
    Malformed,
    NeedData,
    Reply,
    ReplyParser,
)

WITH_CRC = Framing(None, 0x89)


def test_parser_initially_needs_whole_reply() -> None:
    assert ReplyParser(GetRawChannels()).feed() == NeedData(10)


def test_trex_jr_signature_needs_two_more_bytes() -> None:
    assert ReplyParser(GetSignature()).feed(b"TReXJr1") == NeedData(2)


def test_reply_of_other_device_is_malformed() -> None:
    result = ReplyParser(GetSignature()).feed(b"ERROR\r\n")
    assert isinstance(result, Malformed)
    assert "not the signature of a TReX" in result.reason


def test_wrong_crc_makes_reply_malformed_and_names_both() -> None:
    raw = bytes.fromhex("81 49")
    result = ReplyParser(GetCurrent(1), WITH_CRC).feed(raw)
    assert result == Malformed(raw, "the CRC is 49, not 48")


def test_one_extra_byte_is_reported_in_singular() -> None:
    result = ReplyParser(GetMode()).feed(b"rr")
    assert isinstance(result, Malformed)
    assert "1 bytes" not in result.reason


def test_later_extra_byte_makes_reply_malformed() -> None:
    parser = ReplyParser(GetMode())
    assert isinstance(parser.feed(b"r"), Reply)
    assert isinstance(parser.feed(b"\x00"), Malformed)


def test_invalid_reply_is_malformed_with_reason() -> None:
    result = ReplyParser(GetMode()).feed(b"x")
    assert isinstance(result, Malformed)
    assert "not a TReX mode" in result.reason


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
