"""decode: packets are described in words."""

import pytest

from tests.support.virtual_command import RunCommand
from trex_gui.devices.trex.protocol.commands import COMMANDS
from trex_gui.devices.trex.protocol.descriptions import describe
from trex_gui.devices.trex.protocol.framing import Packet, PacketParser


@pytest.mark.parametrize(
    ("packet", "words"),
    [
        ("81", "81  compact  get signature"),
        ("86 05", "86 05  compact  get raw inputs of channels 1, 3"),
        ("C2 50", "C2 50  compact  set motor 1 to forward 80"),
        ("CD 7F", "CD 7F  compact  accelerate motor 2 to reverse 127"),
        ("D0 7F 00", "D0 7F 00  compact  set motor 1 to brake with 127, motor 2 to coast"),
        ("F1 20", "F1 20  compact  accelerate auxiliary motor to 32"),
        ("9F 07", "9F 07  compact  get Serial Timeout"),
        ("AF 07 0F 55 2A", "AF 07 0F 55 2A  compact  set Serial Timeout to 1.5 s (15)"),
        ("80 07 1F 7B", "80 07 1F 7B  to device 7  get Motor Mode"),
        ("0x81,", "81  compact  get signature"),
    ],
)
def test_decode_describes_packets(trexcmd: RunCommand, packet: str, words: str) -> None:
    result = trexcmd("decode", packet)
    assert (result.exit_code, result.stdout.rstrip("\n")) == (0, words)


def test_every_command_has_a_description() -> None:
    for opcode, cls in COMMANDS.items():
        data = bytes(cls.data_size)
        if 0xA0 <= opcode <= 0xAF:
            data = bytes([0, 0, 1, 0, 2, 0, 0, 0])[: cls.data_size - 2] + b"\x55\x2a"
        (event,) = PacketParser().feed(bytes([opcode]) + data)
        assert isinstance(event, Packet)
        assert describe(event.command) != type(event.command).__name__


def test_decode_verifies_the_crc(trexcmd: RunCommand) -> None:
    assert trexcmd("decode", "--crc", "86 1F 07").exit_code == 0
    result = trexcmd("decode", "--crc", "86", "1F", "08")
    assert result.exit_code == 1
    assert "the CRC is 08, not 07" in result.stdout


def test_decode_explains_invalid_bytes(trexcmd: RunCommand) -> None:
    result = trexcmd("decode", "81 05 86 C2 AF 07")
    assert result.exit_code == 1
    assert "a data byte outside a packet" in result.stdout
    assert "a command byte inside a packet" in result.stdout
    assert "the packet is not complete" in result.stdout
    assert "4 of 5 are not packets" in result.stderr


@pytest.mark.parametrize("words", [("8G",), (), (" ",), ("--crc", "--polynomial", "11", "81")])
def test_invalid_decode_arguments_are_usage_errors(
    trexcmd: RunCommand, words: tuple[str, ...]
) -> None:
    assert trexcmd("decode", *words).exit_code == 2
