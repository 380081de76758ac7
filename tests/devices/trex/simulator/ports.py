"""Packets to the UART of a board and its answers, in hex, without a wire."""

from trex_gui.devices.trex.protocol.errors import ResultCode
from trex_gui.devices.trex.protocol.flags import UartError
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.memory import Eeprom
from trex_gui.devices.trex.simulator.uart import SerialPort

NO_REPLY = ""

SETTLED = 0.12
"""Seconds after power-up in which each channel is known to have a signal, or to have none."""


def feed(port: SerialPort, packet: str) -> None:
    for byte in bytes.fromhex(packet):
        port.feed(byte)


def answer(port: SerialPort) -> str:
    """Take what the send buffer holds."""
    data = bytes(port.outgoing)
    port.outgoing.clear()
    return data.hex(" ").upper()


def pass_pause(port: SerialPort) -> None:
    """Let the board's program pass one pause, as the wire does."""
    port.board.advance(port.pause)
    port.resume()


def ask(port: SerialPort, packet: str) -> str:
    """Send packets and return what is answered, waiting for writes."""
    feed(port, packet)
    while port.pause:
        pass_pause(port)
    return answer(port)


def errors(port: SerialPort) -> UartError:
    return port.board.serial.pop_uart_errors()


def a_board(number: int = 7, settings: int = 0x05, model: str = "trex", **parameters: int) -> Board:
    """A board whose memory holds this from the start."""
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
