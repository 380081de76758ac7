"""The commands `raw` and `decode`, and the option `--traffic`."""

import signal
from pathlib import Path

import pytest

from tests.devices.trex.cli.conftest import becomes, outputs
from tests.devices.trex.conftest import STOPPED, motor
from tests.support.simulator import SimulatedDevice
from tests.support.virtual_command import RunCommand, StartCommand
from trex_gui.core.transport.transcript import read_transcript
from trex_gui.devices.trex.protocol.commands import COMMANDS
from trex_gui.devices.trex.protocol.descriptions import describe
from trex_gui.devices.trex.protocol.framing import Packet, PacketParser
from trex_gui.devices.trex.session.traffic_decoder import TrexDecoder


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
    assert trexcmd("decode", packet).stdout.rstrip("\n") == words


def test_every_command_has_a_description() -> None:
    for opcode, cls in COMMANDS.items():
        data = bytes(cls.data_size)
        if 0xA0 <= opcode <= 0xAF:
            data = bytes([0, 0, 1, 0, 2, 0, 0, 0])[: cls.data_size - 2] + b"\x55\x2a"
        (event,) = PacketParser().feed(bytes([opcode]) + data)
        assert isinstance(event, Packet)
        assert describe(event.command) != type(event.command).__name__


def test_decode_verifies_the_crc(trexcmd: RunCommand) -> None:
    trexcmd("decode", "--crc", "86 1F 07")
    assert "the CRC is 08, not 07" in trexcmd("decode", "--crc", "86", "1F", "08", exits=1).stdout


def test_decode_explains_invalid_bytes(trexcmd: RunCommand) -> None:
    result = trexcmd("decode", "81 05 86 C2 AF 07", exits=1)
    assert "a data byte outside a packet" in result.stdout
    assert "a command byte inside a packet" in result.stdout
    assert "the packet is not complete" in result.stdout
    assert "Not a packet: 4 of 5 parts" in result.stderr


# --- raw ----------------------------------------------------------------------------------


def test_raw_prints_meaning_and_each_reply(trexcmd: RunCommand) -> None:
    result = trexcmd("raw", "81 82 80 07 1F 00 FF 41")
    assert result.stdout.splitlines() == ["54 52 65 58 31 2E 32", "72", "07"]
    meanings = result.stderr.splitlines()
    assert meanings[0] == "81: get signature"
    assert meanings[2] == "80 07 1F 00: device 7: get Device Number"
    assert meanings[4] == "41: not a TReX packet: a data byte outside a packet"


def test_raw_write_prints_a_warning(trexcmd: RunCommand, quick_simulator: SimulatedDevice) -> None:
    result = trexcmd("raw", "AF 07 0F 55 2A")
    assert result.stdout == "00\n"
    assert "set Serial Timeout to 1.5 s (15). The board stores this at once" in result.stderr
    assert quick_simulator.show()["parameters"]["serial_timeout"] == 15
    result = trexcmd("raw", "--protocol", "expanded", "AF 07 0F 55 2A")
    assert "(15). Every board on the line stores this at once" in result.stderr


@pytest.mark.parametrize("packet", ["C2 50", "80 07 42 50", "81 F0 20", "80 07", "05 D0"])
def test_raw_motor_command_needs_permission(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice, packet: str
) -> None:
    before = quick_simulator.show()["counters"]
    result = trexcmd("raw", packet, exits=2)
    assert "PACKET may move a motor" in result.stderr
    assert "--motors" in result.stderr
    assert quick_simulator.show()["counters"] == before, "nothing is sent"


def test_raw_motor_command_is_followed_by_a_stop(
    start: StartCommand, trexcmd: RunCommand, quick_simulator: SimulatedDevice
) -> None:
    command = start("raw", "--motors", "C2 50 82")
    assert becomes(lambda: outputs(quick_simulator), [80, 0, 0])
    command.send_signal(signal.SIGINT)
    output, errors = command.communicate()
    assert command.returncode == 0, errors
    assert output == "72\n"
    assert "set motor 1 to forward 80. This may move a motor" in errors
    assert errors.endswith("Stopped.\n")
    assert motor(quick_simulator) == STOPPED

    words = ("raw", "--motors", "--seconds", "0.5")
    trexcmd(*words, "F0 20")
    rejected = trexcmd(*words, "--protocol", "expanded", "C2 50", exits=1)
    assert "another board, which a stop on this connection does not reach" in rejected.stderr
    assert outputs(quick_simulator) == [0, 0, 0]


# --- --traffic ----------------------------------------------------------------------------


def test_traffic_of_a_command_is_written_to_a_file(
    trexcmd: RunCommand, quick_simulator: SimulatedDevice, tmp_path: Path
) -> None:
    file = tmp_path / "traffic.txt"
    trexcmd("set", "serial_timeout", "1.5 s", "--traffic", str(file))
    rows = list(read_transcript(file.read_text(encoding="utf-8"), "it", TrexDecoder()))
    meanings = [row.meaning for row in rows]
    assert "get signature → TReX 1.2" in meanings
    assert "set Serial Timeout to 1.5 s (15) → stored" in meanings
    assert [row.time for row in rows] == sorted(row.time for row in rows)

    words = ("--seconds", "0.5", "--traffic", str(file))
    trexcmd("motor", "1", "40", *words)
    text = file.read_text(encoding="utf-8")
    assert "\tOpened " in text
    assert "set motor 1 to forward 40" in text
    assert "set motor 1 to brake with 127, motor 2 to brake with 127" in text
    assert "Serial Timeout to 1.5 s (15) → stored" not in text, "the old file is replaced"

    before = file.read_bytes()
    trexcmd("get", "--traffic", str(file), exits=2)
    assert file.read_bytes() == before, "wrong usage overwrites nothing"
    for command in ("status", "find"):
        trexcmd(command, "--port", "/dev/none", "--traffic", str(file), exits=1)
    assert file.read_bytes() == before, "a missing port overwrites nothing"
    trexcmd("status", "--traffic", str(tmp_path / "no" / "file"), exits=1)
