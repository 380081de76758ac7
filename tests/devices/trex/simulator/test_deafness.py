"""Whoever missed the beginning of a byte does not have the byte."""

import pytest

from tests.devices.trex.simulator.conftest import make_ask
from trex_gui.devices.trex.protocol.flags import UartError
from trex_gui.devices.trex.simulator.control import control
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import TrexLine
from trex_gui.devices.trex.simulator.memory import Eeprom
from trex_gui.devices.trex.simulator.motors import MotorDirection

BYTE = 10 / 19200


@pytest.fixture
def line() -> TrexLine:
    line = TrexLine([Board()])
    line.advance(1)
    return line


@pytest.mark.parametrize("overlap", [0.05, 0.5, 0.95])
def test_byte_that_begins_during_reply_is_lost(line: TrexLine, overlap: float) -> None:
    line.send(b"\x81")
    line.advance((8 - overlap) * BYTE)
    line.send(b"\xc2\x40")
    line.advance(0.01)
    assert line.receive() == b"TReX1.2"
    assert line.boards[0].motors[0].direction is MotorDirection.BRAKE
    assert line.boards[0].counters["bytes_missed"] == 1


def test_byte_that_spans_power_up_is_lost(line: TrexLine) -> None:
    control(line, "power off")
    line.send(b"\x81")
    line.advance(0.9 * BYTE)
    control(line, "power on")
    line.advance(0.05)
    assert line.receive() == b""


@pytest.mark.parametrize("question", ["81", "FF 81"])
def test_byte_that_spans_plugging_in_is_lost(line: TrexLine, question: str) -> None:
    control(line, "line unplug")
    line.send(bytes.fromhex(question))
    line.advance((len(bytes.fromhex(question)) - 0.1) * BYTE)
    control(line, "line plug")
    line.advance(0.05)
    assert line.receive() == b""
    assert make_ask(line)("82") == "72"


def test_overlapping_replies_are_garbled() -> None:
    """Two answers, the second a millisecond later: nobody reads either, and bytes are few."""
    late = Eeprom()
    late.write("uart_response_delay", 1)
    late.write("device_number", 8)
    line = TrexLine([Board(), Board(eeprom=late)])
    line.advance(0.2)
    line.send(b"\x81")
    begun = line.now + BYTE
    line.advance(0.02)
    got = line.receive()
    assert got[:1] == b"T"  # before the other begins
    assert got != b"TReX1.2"
    assert line.faults.counters["collisions"]
    longest = (0.001 + 7 * BYTE) / BYTE
    assert len(got) <= longest + 1
    assert line.now > begun
    assert make_ask(line)("80 08 02") == "72"


def test_injected_bytes_take_line_time_and_collide_with_reply(line: TrexLine) -> None:
    control(line, "line garbage " + "00" * 100)
    control(line, "line garbage " + "00" * 100)
    line.advance(150 * BYTE)
    assert 140 <= len(line.receive()) <= 150
    line.advance(60 * BYTE)
    line.receive()
    line.send(b"\x81")
    line.advance(1.5 * BYTE)
    control(line, "line garbage " + "00" * 7)
    line.advance(0.02)
    assert line.receive() != b"TReX1.2"
    assert line.faults.counters["collisions"]


@pytest.mark.parametrize("boards", [1, 2])
def test_up_to_10000_injected_bytes_are_delivered(boards: int) -> None:
    line = TrexLine([Board() for _ in range(boards)], echo=True)
    assert control(line, "line garbage " + "A5" * 10_001).startswith("error")
    assert control(line, "line garbage " + "A5" * 10_000).startswith("ok")
    line.advance(10_000 * BYTE + 0.01)
    assert line.receive() == b"\xa5" * 10_000


def test_drop_unsent_discards_queued_bytes(line: TrexLine) -> None:
    line.send(b"\xc2\x40" * 100)
    line.drop_unsent()
    assert line.backlog == 0
    line.advance(1)
    assert line.boards[0].counters["bytes_received"] == 0
    assert make_ask(line)("81") == "54 52 65 58 31 2e 32"
    assert not line.boards[0].serial.take_uart_errors() & UartError.FORMAT
