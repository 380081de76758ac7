"""Packets in hexadecimal to the UART of a board, or to a line of boards."""

from trex_gui.devices.trex.protocol.errors import ResultCode
from trex_gui.devices.trex.protocol.flags import UartError
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import SimulatedBoards
from trex_gui.devices.trex.simulator.memory import Eeprom
from trex_gui.devices.trex.simulator.uart import SerialPort

NO_REPLY = ""

SETTLED = 0.12
"""Seconds after power-up until the signals of all channels are known."""


def feed(port: SerialPort, packet: str) -> None:
    for byte in bytes.fromhex(packet):
        port.feed(byte)


def read_replies(port: SerialPort) -> str:
    """Remove the bytes from the send buffer, and return them in hexadecimal."""
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
    return read_replies(port)


def pop_errors(port: SerialPort) -> UartError:
    return port.board.serial.pop_uart_errors()


def query(line: SimulatedBoards, packet: str) -> bytes:
    """Send a packet. Return the bytes that the host receives until the line is silent."""
    line.send(bytes.fromhex(packet))
    while (event := line.next_event) is not None:
        line.advance_to(event)
    return line.receive()


def create_board(
    number: int = 7,
    settings: int = 0x05,
    model: str = "trex",
    mode: str = "serial",
    **parameters: int,
) -> Board:
    """Return a board with these stored values."""
    eeprom = Eeprom(model)
    cells = {"device_number": number, "uart_settings": settings, **parameters}
    for key, value in cells.items():
        eeprom.write(key, value)
    return Board(mode=mode, eeprom=eeprom)


def write(board: Board, key: str, value: int) -> None:
    """Write a parameter and wait until it is stored."""
    spec = board.memory.parameters[key]
    assert board.set_parameter(spec.number, value) is ResultCode.OK
    board.advance(0.005)
