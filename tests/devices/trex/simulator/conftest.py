"""A board, its line and a host."""

from collections.abc import Callable

import pytest

from tests.devices.trex.simulator.ports import SETTLED
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import SimulatedBoards
from trex_gui.devices.trex.simulator.uart import SerialPort

Exchange = Callable[[str], str]


def create_exchange(line: SimulatedBoards) -> Exchange:
    def exchange(packet: str) -> str:
        """Send a packet. Return the bytes until the line is silent."""
        line.send(bytes.fromhex(packet))
        while (event := line.next_event) is not None:
            line.advance_to(event)
        return line.receive().hex(" ")

    return exchange


@pytest.fixture
def board() -> Board:
    return Board()


@pytest.fixture
def port(board: Board) -> SerialPort:
    return SerialPort(board)


@pytest.fixture
def line(board: Board) -> SimulatedBoards:
    return SimulatedBoards([board])


@pytest.fixture
def exchange(line: SimulatedBoards) -> Exchange:
    return create_exchange(line)


@pytest.fixture
def rc() -> Board:
    """A board in RC mode that has left safe-start."""
    board = Board(mode="rc")
    board.advance(SETTLED)
    assert not board.sticks.safe_start
    return board
