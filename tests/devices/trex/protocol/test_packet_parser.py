"""Parser of packets from a host."""

import pytest

from trex_gui.devices.trex.protocol.commands import GetSignature, SetCalibration
from trex_gui.devices.trex.protocol.framing import Malformed, Packet, PacketParser

OUTSIDE = "a data byte outside a packet"
INSIDE = "a command byte inside a packet"


def text_of(event: Packet | Malformed) -> str:
    """Return the bytes of an event, with the reason if they are malformed."""
    reason = f": {event.reason}" if isinstance(event, Malformed) else ""
    return event.raw.hex(" ") + reason


@pytest.mark.parametrize(
    ("sent", "events"),
    [
        ("1f 81 2a", [f"1f: {OUTSIDE}", "81", f"2a: {OUTSIDE}"]),
        ("81 48", ["81", f"48: {OUTSIDE}"]),  # an unexpected CRC
        ("af 07 05 82", [f"af 07 05: {INSIDE}", "82"]),
        ("86 80 07 01", [f"86: {INSIDE}", "80 07 01"]),
        ("80 81", [f"80: {INSIDE}", "81"]),
        ("80 07 81", [f"80 07: {INSIDE}", "81"]),
        ("f2 10 81", ["f2: 0xf2 is not a TReX command", f"10: {OUTSIDE}", "81"]),
    ],
)
def test_bytes_that_are_no_packet_are_malformed_with_reason(sent: str, events: list[str]) -> None:
    assert [text_of(event) for event in PacketParser().feed(bytes.fromhex(sent))] == events


@pytest.mark.parametrize("opcode", [0x88, 0x8C, 0x96, 0x9E, 0xA5, 0xAE, 0xB0, 0xBF, 0xF2, 0xFE])
def test_unknown_command_is_malformed_at_once(opcode: int) -> None:
    for raw in (bytes([opcode]), bytes([0x80, 7, opcode & 0x7F])):
        (event,) = PacketParser().feed(raw)
        assert event == Malformed(raw, f"{opcode:#04x} is not a TReX command")


def test_wrong_crc_makes_packet_malformed_with_both_values() -> None:
    raw = bytes.fromhex("86 1f 08")
    assert PacketParser(0x89).feed(raw) == [Malformed(raw, "the CRC is 08, not 07")]


@pytest.mark.parametrize(
    ("sent", "words"),
    [
        ("af 00 07 2a 55", "must end in 55 2A, not 2A 55"),
        ("af 00 07 55 2b", "must end in 55 2A, not 55 2B"),
        ("af 00 07 00 00", "must end in 55 2A, not 00 00"),
        ("86 20", "channel mask must be 0 to 31"),
    ],
)
def test_invalid_data_makes_packet_malformed(sent: str, words: str) -> None:
    raw = bytes.fromhex(sent)
    (event,) = PacketParser().feed(raw)
    assert isinstance(event, Malformed)
    assert event.raw == raw
    assert words in event.reason


def test_unordered_calibration_is_a_valid_packet() -> None:
    # The board replies with result code 2, so this is no format error.
    raw = bytes.fromhex("a0 01 00 00 00 01 00 00 00 55 2a")
    (event,) = PacketParser().feed(raw)
    assert isinstance(event, Packet)
    assert isinstance(event.command, SetCalibration)
    assert event.command.calibration.minimum == 1


def test_unfinished_packet_is_malformed_on_flush() -> None:
    parser = PacketParser()
    parser.feed(bytes.fromhex("81 af 07"))
    assert parser.flush() == [Malformed(bytes.fromhex("af 07"), "the packet is not complete")]
    assert parser.flush() == []
    assert parser.feed(b"\x81") == [Packet(b"\x81", GetSignature(), None)]
