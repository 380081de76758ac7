"""UART of a board without a line: packets and replies in hex."""

from trex_gui.devices.trex.protocol.errors import ResultCode
from trex_gui.devices.trex.protocol.flags import UartError
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.memory import Eeprom
from trex_gui.devices.trex.simulator.uart import SerialPort

NO_REPLY = ""

SETTLED = 0.12
"""Seconds after power-up until the signals of all channels are known."""


def feed(port: SerialPort, packet: str) -> None:
    for byte in bytes.fromhex(packet):
        port.feed(byte)


def answer(port: SerialPort) -> str:
    """Empty the send buffer."""
    data = bytes(port.outgoing)
    port.outgoing.clear()
    return data.hex(" ").upper()


def pass_pause(port: SerialPort) -> None:
    """End one pause of the parser, as the line does."""
    port.board.advance(port.pause)
    port.resume()


def exchange(port: SerialPort, packet: str) -> str:
    """Send packets and wait for writes. Return the replies."""
    feed(port, packet)
    while port.pause:
        pass_pause(port)
    return answer(port)


def errors(port: SerialPort) -> UartError:
    return port.board.serial.pop_uart_errors()


def create_board(
    number: int = 7, settings: int = 0x05, model: str = "trex", **parameters: int
) -> Board:
    """Return a board with these stored values."""
    eeprom = Eeprom(model)
    cells = {"device_number": number, "uart_settings": settings, **parameters}
    for key, value in cells.items():
        eeprom.write(key, value)
    return Board(eeprom=eeprom)


def write(board: Board, key: str, value: int) -> None:
    """Write a parameter and wait until it is stored."""
    spec = board.memory.parameters[key]
    assert board.set_parameter(spec.number, value) is ResultCode.OK
    board.advance(0.005)
