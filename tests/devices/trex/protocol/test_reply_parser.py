"""Parser of replies, with or without echo and CRC."""

from typing import Any

import pytest

from trex_gui.devices.trex.protocol.commands import (
    Command,
    GetCurrent,
    GetMode,
    GetRawChannels,
    GetSignature,
)
from trex_gui.devices.trex.protocol.framing import Framing, Malformed, NeedData, Reply, ReplyParser


def test_parser_reports_missing_bytes_of_the_reply() -> None:
    assert ReplyParser(GetRawChannels()).feed() == NeedData(10)
    assert ReplyParser(GetSignature()).feed(b"TReXJr1") == NeedData(2)


@pytest.mark.parametrize(
    ("command", "received", "words"),
    [
        (GetSignature(), b"ERROR\r\n", "not the signature of a TReX"),
        (GetMode(), b"x", "not a TReX mode"),
        (GetMode(), b"rr", "1 byte"),
        (GetMode(), b"\x82r", "1 byte"),  # an unexpected echo
    ],
)
def test_bytes_that_are_no_reply_are_malformed_with_reason(
    command: Command[Any], received: bytes, words: str
) -> None:
    result = ReplyParser(command).feed(received)
    assert isinstance(result, Malformed)
    assert words in result.reason
    assert "1 bytes" not in result.reason


def test_wrong_crc_makes_reply_malformed_with_both_values() -> None:
    raw = bytes.fromhex("81 49")
    result = ReplyParser(GetCurrent(1), Framing(None, 0x89)).feed(raw)
    assert result == Malformed(raw, "the CRC is 49, not 48")


def test_later_extra_byte_makes_reply_malformed() -> None:
    parser = ReplyParser(GetMode())
    assert isinstance(parser.feed(b"r"), Reply)
    assert isinstance(parser.feed(b"\x00"), Malformed)


def test_wrong_echo_is_detected_at_first_wrong_byte() -> None:
    parser = ReplyParser(GetRawChannels(0x13), echo=True)
    assert isinstance(parser.feed(b"\x86"), NeedData)
    result = parser.feed(b"\x93")
    assert isinstance(result, Malformed)
    assert "86 13" in result.reason
    assert isinstance(ReplyParser(GetMode(), echo=True).feed(b"r"), Malformed)
