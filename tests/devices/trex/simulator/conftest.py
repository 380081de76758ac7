"""A simulated board, its UART and its line."""

import pytest

from tests.devices.trex.simulator.ports import SETTLED
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import SimulatedBoards
from trex_gui.devices.trex.simulator.uart import SerialPort


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
def rc() -> Board:
    """A board in RC mode after the end of safe-start."""
    board = Board(mode="rc")
    board.advance(SETTLED)
    assert not board.sticks.safe_start
    return board
