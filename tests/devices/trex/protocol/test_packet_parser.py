"""Reading what a host sends, damaged or not."""

import pytest

from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.protocol.commands import (
    GetMode,
    GetSignature,
    SetCalibration,
)
from trex_gui.devices.trex.protocol.framing import Malformed, Packet, PacketParser


def raws(events: list[Packet | Malformed]) -> list[str]:
    return [event.raw.hex(" ") for event in events]


def test_data_byte_outside_packet_is_malformed() -> None:
    (event,) = PacketParser().feed(bytes.fromhex("1f"))
    assert isinstance(event, Malformed)
    assert "data byte outside a packet" in event.reason


def test_stray_data_bytes_leave_adjacent_packet_intact() -> None:
    stray, packet, other = PacketParser().feed(bytes.fromhex("1f 81 2a"))
    assert isinstance(stray, Malformed)
    assert packet == Packet(b"\x81", GetSignature(), None)
    assert isinstance(other, Malformed)


def test_command_byte_inside_packet_starts_new_packet() -> None:
    broken, packet = PacketParser().feed(bytes.fromhex("af 07 05 82"))
    assert broken == Malformed(bytes.fromhex("af 07 05"), "a command byte inside a packet")
    assert packet == Packet(b"\x82", GetMode(), None)


def test_expanded_packet_start_ends_compact_packet() -> None:
    events = PacketParser().feed(bytes.fromhex("86 80 07 01"))
    assert raws(events) == ["86", "80 07 01"]
    assert isinstance(events[0], Malformed)
    assert events[1] == Packet(bytes.fromhex("80 07 01"), GetSignature(), 7)


@pytest.mark.parametrize("cut", ["80", "80 07"])
def test_command_byte_ends_expanded_packet_without_command(cut: str) -> None:
    events = PacketParser().feed(bytes.fromhex(cut + "81"))
    assert raws(events) == [cut, "81"]
    assert isinstance(events[0], Malformed)
    assert isinstance(events[1], Packet)


@pytest.mark.parametrize(
    "opcode",
    [0x88, 0x8C, 0x96, 0x9E, 0xA5, 0xAE, 0xB0, 0xBF, 0xF2, 0xFE],
)
def test_unknown_command_is_malformed_at_once(opcode: int) -> None:
    (event,) = PacketParser().feed(bytes([opcode]))
    assert isinstance(event, Malformed)
    assert f"{opcode:#04x} is not a TReX command" in event.reason


@pytest.mark.parametrize("command", ["00", "08", "25", "72", "7e"])
def test_unknown_expanded_command_is_malformed_at_once(command: str) -> None:
    raw = bytes.fromhex("80 07" + command)
    (event,) = PacketParser().feed(raw)
    assert isinstance(event, Malformed)
    assert event.raw == raw


def test_data_after_unknown_command_is_stray() -> None:
    events = PacketParser().feed(bytes.fromhex("f2 10 81"))
    assert raws(events) == ["f2", "10", "81"]
    assert [type(event) for event in events] == [Malformed, Malformed, Packet]


def test_wrong_crc_makes_packet_malformed_and_names_both() -> None:
    raw = bytes.fromhex("86 1f 08")
    assert PacketParser(0x89).feed(raw) == [Malformed(raw, "the CRC is 08, not 07")]


def test_unexpected_crc_is_stray_byte() -> None:
    packet, stray = PacketParser().feed(bytes.fromhex("81 48"))
    assert isinstance(packet, Packet)
    assert stray == Malformed(b"\x48", "a data byte outside a packet")


@pytest.mark.parametrize("ending", ["2a 55", "55 2b", "00 00"])
def test_wrong_format_bytes_make_write_malformed(ending: str) -> None:
    raw = bytes.fromhex("af 00 07" + ending)
    (event,) = PacketParser().feed(raw)
    assert isinstance(event, Malformed)
    assert event.raw == raw
    assert "55 2A" in event.reason


def test_mask_with_sixth_channel_is_malformed() -> None:
    (event,) = PacketParser().feed(bytes.fromhex("86 20"))
    assert isinstance(event, Malformed)
    assert "channel mask is 0 to 31" in event.reason


def test_unordered_calibration_is_still_a_packet() -> None:
    # The board answers result code 2 to it, so it is no format error.
    raw = bytes.fromhex("a0 01 00 00 00 01 00 00 00 55 2a")
    (event,) = PacketParser().feed(raw)
    assert isinstance(event, Packet)
    assert isinstance(event.command, SetCalibration)
    assert event.command.calibration.minimum == 1


def test_unfinished_packet_is_malformed_on_flush() -> None:
    parser = PacketParser()
    assert parser.feed(bytes.fromhex("81 af 07")) == [Packet(b"\x81", GetSignature(), None)]
    assert parser.flush() == [Malformed(bytes.fromhex("af 07"), "the packet is not complete")]


def test_flush_empties_parser() -> None:
    parser = PacketParser()
    parser.feed(bytes.fromhex("af 07"))
    parser.flush()
    assert parser.flush() == []
    assert parser.feed(b"\x81") == [Packet(b"\x81", GetSignature(), None)]


@pytest.mark.parametrize("polynomial", [0x00, 0x09, 0x100])
def test_parser_rejects_polynomial_without_top_bit(
    polynomial: int,
) -> None:
    with pytest.raises(BadRequest, match="0x80 to 0xFF"):
        PacketParser(polynomial)
