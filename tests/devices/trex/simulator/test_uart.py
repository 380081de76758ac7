"""Packets that the suite of the documents leaves out, and the reply to each parameter."""

import pytest

from tests.devices.trex.simulator.ports import NO_REPLY, a_board, ask, errors
from trex_gui.core.simulator.sampling import ReceiveError
from trex_gui.devices.trex.protocol.flags import UartError
from trex_gui.devices.trex.simulator.command import simulate
from trex_gui.devices.trex.simulator.control import report
from trex_gui.devices.trex.simulator.line import TrexLine
from trex_gui.devices.trex.simulator.uart import SerialPort


@pytest.mark.parametrize("settings", [0x05, 0x25], ids=["plain", "crc"])
def test_null_command_of_either_protocol_needs_no_checksum(settings: int) -> None:
    port = SerialPort(a_board(settings=settings))
    assert ask(port, "FF 80 07 7F") == NO_REPLY
    assert not errors(port)


def test_packets_for_other_boards_are_counted(port: SerialPort) -> None:
    assert ask(port, "80 08 06 1F 80 01 2F 7B 01 55 2A 80 03 04 02 01 40") == NO_REPLY
    assert report(port.board)["counters"]["packets_for_others"] == 3


def test_bad_byte_discards_its_packet(port: SerialPort) -> None:
    port.feed(0xF0)
    port.feed_error(ReceiveError.PARITY)
    assert errors(port) == UartError.PARITY
    assert ask(port, "7F") == NO_REPLY
    assert errors(port) == UartError.FORMAT
    assert port.board.aux.speed == 0


def test_unpowered_board_ignores_packets(port: SerialPort) -> None:
    port.board.power_off()
    assert ask(port, "81") == NO_REPLY
    port.feed_error(ReceiveError.FRAMING)
    port.board.power_on()
    assert not errors(port)


def test_board_may_behave_like_the_twin() -> None:
    """Guide of the qik 2s12v10, 5.d."""
    line = simulate(unknown_parameter="byte", rejected_write="error").line
    assert isinstance(line, TrexLine)
    (board,) = line.boards
    port = SerialPort(board)
    assert ask(port, "C0 20 9F 60 85") == "FF 40"
    assert board.motors[0].speed == 127, "errors stop the motors"
    assert ask(port, "AF 60 00 55 2A 85") == "01 40"
    assert ask(port, "AF 07 00 55 2A 85") == "00 00"
