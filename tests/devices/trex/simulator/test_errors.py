"""Every bit of the UART error byte by what the documentation says causes it."""

from collections.abc import Callable

import pytest

from tests.devices.trex.simulator.ports import a_board
from trex_gui.devices.trex.protocol.flags import UartError
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.simulator.command import simulate
from trex_gui.devices.trex.simulator.control import control
from trex_gui.devices.trex.simulator.line import TrexLine
from trex_gui.devices.trex.simulator.uart import remainder

Cause = Callable[[TrexLine], None]

SET_CALIBRATION = "A0 28 14 4C 1C 5C 24 2C 02 55 2A"
"""Keeps the board busy for 32 ms, in which 60 bytes can come."""


def send(line: TrexLine, packet: str) -> bytes:
    """Send bytes, wait until the wire is quiet, return what came."""
    line.send(bytes.fromhex(packet))
    while (event := line.next_event) is not None:
        line.advance_to(event)
    return line.receive()


def question(line: TrexLine, packet: str) -> bytes:
    """Ask in the way that the board wants, and take a checksum off."""
    polynomial = line.boards[0].memory.crc_polynomial
    if polynomial is None:
        return send(line, packet)
    data = bytes.fromhex(packet)
    answer = send(line, (data + bytes([remainder(data, polynomial)])).hex())
    assert remainder(answer[:-1], polynomial) == answer[-1]
    return answer[:-1]


def fall_silent(line: TrexLine) -> None:
    assert send(line, "AF 07 01 55 2A") == b"\x00"
    line.advance(0.2)
    line.boards[0].memory.active["serial_timeout"] = 0  # it would go on


def injected(name: str) -> Cause:
    def cause(line: TrexLine) -> None:
        assert control(line, f"line error {name}").startswith("ok ")
        send(line, "82")

    return cause


def sent(packet: str) -> Cause:
    def cause(line: TrexLine) -> None:
        send(line, packet)

    return cause


def set_otherwise(host: LineSettings, packet: str = "00") -> Cause:
    def cause(line: TrexLine) -> None:
        fitting = line.host
        line.host = host
        assert send(line, packet) == b""
        line.host = fitting

    return cause


NONE, CRC, EVEN = 0x05, 0x25, 0x45
CAUSES: list[tuple[str, int, Cause, UartError]] = [
    ("silence longer than the timeout", NONE, fall_silent, UartError.TIMEOUT),
    ("a command that does not exist", NONE, sent("88"), UartError.FORMAT),
    ("a command inside a packet", NONE, sent("86 82"), UartError.FORMAT),
    ("an illogical data byte", NONE, sent("86 20"), UartError.FORMAT),
    ("wrong format bytes", NONE, sent("AF 07 01 55 2B"), UartError.FORMAT),
    ("a wrong checksum", CRC, sent("82 52"), UartError.CRC),
    ("no stop bit", NONE, injected("framing"), UartError.FRAMING),
    ("a slower host", NONE, set_otherwise(LineSettings(1200)), UartError.FRAMING),
    ("a host without parity", EVEN, set_otherwise(LineSettings()), UartError.PARITY),
    ("a full receiver", NONE, injected("overrun"), UartError.DATA_OVERRUN),
    ("a wrong parity", EVEN, injected("parity"), UartError.PARITY),
    (
        "the other parity",
        EVEN,
        set_otherwise(LineSettings(detection=Detection.ODD)),
        UartError.PARITY,
    ),
    ("too much before the answer", NONE, sent(SET_CALIBRATION + "FF" * 34), UartError.READ_OVERRUN),
    (
        "too many questions before the answer",
        NONE,
        sent(SET_CALIBRATION + "81" * 6),
        UartError.SEND_OVERRUN,
    ),
]


@pytest.mark.parametrize(
    ("settings", "cause", "error"), [each[1:] for each in CAUSES], ids=[each[0] for each in CAUSES]
)
def test_error_sets_its_bit_and_board_still_replies(
    settings: int, cause: Cause, error: UartError
) -> None:
    line = TrexLine([a_board(settings=settings)])
    line.host = LineSettings.from_wire(settings)
    assert question(line, "85") == b"\x00"
    cause(line)
    assert question(line, "81") == b"TReX1.2"
    assert question(line, "84") == b"\x01"
    assert question(line, "85") == bytes([error])
    assert question(line, "85") == question(line, "84") == b"\x00"


def test_board_may_behave_like_the_twin() -> None:
    """Guide of the qik 2s12v10, 5.d."""
    simulation = simulate(unknown_parameter="byte", rejected_write="error", paced=False)
    line = simulation.line
    assert isinstance(line, TrexLine)
    assert send(line, "C0 20 9F 60 85") == b"\xff\x40"
    assert line.boards[0].motors[0].speed == 127, "errors stop the motors"
    assert send(line, "AF 60 00 55 2A 85") == b"\x01\x40"
    assert send(line, "AF 07 00 55 2A 85") == b"\x00\x00"


def test_causes_cover_every_uart_error_bit() -> None:
    assert {error for *_, error in CAUSES} == set(UartError)


def test_uart_errors_are_latched_together() -> None:
    line = TrexLine([a_board()])
    for cause in (sent("88"), injected("framing"), injected("overrun")):
        cause(line)
    expected = UartError.FORMAT | UartError.FRAMING | UartError.DATA_OVERRUN
    assert question(line, "85") == bytes([expected])


@pytest.mark.parametrize("name", ["framing", "overrun", "parity"])
def test_corrupted_byte_discards_its_packet(name: str) -> None:
    line = TrexLine([a_board(settings=EVEN)])
    send(line, "F0")
    control(line, f"line error {name}")
    send(line, "7F 7F")
    assert line.boards[0].aux.speed == 0


def test_requested_number_of_bytes_is_corrupted() -> None:
    line = TrexLine([a_board()])
    control(line, "line error framing 3")
    assert send(line, "82 82 82") == b""
    assert send(line, "82") == b"r"


def test_board_without_parity_ignores_parity_errors() -> None:
    line = TrexLine([a_board()])
    control(line, "line error parity")
    assert send(line, "82") == b"r"
    assert question(line, "85") == b"\x00"


def test_all_boards_on_line_detect_the_same_error() -> None:
    line = TrexLine([a_board(7), a_board(9)])
    control(line, "line error overrun")
    send(line, "82")
    assert [board.serial.uart_errors for board in line.boards] == [UartError.DATA_OVERRUN] * 2
