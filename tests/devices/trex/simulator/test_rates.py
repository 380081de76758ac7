"""Hosts at a wrong baud rate: a board ignores their packets and latches errors."""

from collections.abc import Iterable
from itertools import permutations

import pytest

from tests.devices.trex.simulator.ports import create_board, query
from trex_gui.devices.trex.protocol.flags import UartError
from trex_gui.devices.trex.protocol.line_settings import LineSettings, baud_rates
from trex_gui.devices.trex.simulator.line import SimulatedBoards

COMPACT = (
    *("81", "82", "83", "84", "85", "86 1F", "87 1F", "8D", "8E", "8F"),
    *("90", "91", "92", "93", "94", "95", "9F 00"),
)

Replies = dict[tuple[int, int], list[tuple[str, bytes, UartError]]]
"""Packet, reply and errors of each query, by the rates of host and board."""

ANY_ERROR = ~UartError(0)


def expanded(packet: str) -> str:
    data = bytes.fromhex(packet)
    return bytes([0x80, 7, data[0] & 0x7F, *data[1:]]).hex(" ")


QUERIES = COMPACT + tuple(expanded(packet) for packet in COMPACT)


def create_line(code: int, *, paced: bool) -> SimulatedBoards:
    """Return a line whose board uses the baud rate with this code."""
    return SimulatedBoards([create_board(settings=code)], paced=paced)


@pytest.fixture(scope="module")
def correct_replies() -> dict[str, bytes]:
    """Reply to each query of a host at the correct rate."""
    line = create_line(5, paced=False)
    line.host = LineSettings()
    replies = {packet: query(line, packet) for packet in QUERIES}
    assert all(replies.values())
    return replies


@pytest.fixture(scope="module", params=[True, False], ids=["paced", "unpaced"])
def replies(request: pytest.FixtureRequest) -> Replies:
    """Replies and errors of each query at each wrong rate."""
    rates = baud_rates()
    replies: Replies = {}
    for code, host in permutations(range(len(rates)), 2):
        line = create_line(code, paced=request.param)
        line.host = LineSettings(rates[host])
        serial = line.boards[0].serial
        replies[rates[host], rates[code]] = [
            (packet, query(line, packet), serial.pop_uart_errors()) for packet in QUERIES
        ]
    assert len(replies) == 110
    return replies


def share(replies: Replies, kind: UartError, pairs: Iterable[tuple[int, int]]) -> float:
    """Return the share of the packets after which errors of this kind were latched."""
    errors = [errors for pair in pairs for _, _, errors in replies[pair]]
    return sum(bool(each & kind) for each in errors) / len(errors)


def test_host_at_wrong_rate_never_gets_correct_reply(
    replies: Replies, correct_replies: dict[str, bytes]
) -> None:
    for pair, rows in replies.items():
        for packet, reply, _ in rows:
            assert reply != correct_replies[packet], (pair, packet)


def test_nearly_every_packet_of_slower_host_latches_errors(replies: Replies) -> None:
    slower = [(host, board) for host, board in replies if host < board]
    assert share(replies, ANY_ERROR, slower) > 0.95
    assert share(replies, UartError.FRAMING, slower) > 0.85
    for pair in slower:
        assert share(replies, UartError.FRAMING, [pair]) > 0.25, pair


def test_reply_at_another_rate_is_garbage_of_varying_length() -> None:
    lengths = set()
    for code, host in permutations(range(len(baud_rates())), 2):
        line = create_line(code, paced=True)
        line.send(b"\x81")
        byte_time = LineSettings(baud_rates()[code]).seconds(1)
        line.advance(0.5 * byte_time)
        line.host = LineSettings(baud_rates()[host])  # changed while the query is sent
        line.advance(20 * byte_time + 0.01)
        reply = line.receive()
        assert reply != b"TReX1.2"
        lengths.add(len(reply))
        assert line.boards[0].counters["bytes_garbled"] == len(reply)
    assert {1, 2} < lengths
    assert max(lengths) > 7


def test_board_replies_again_at_correct_rate() -> None:
    for code, host in permutations(range(len(baud_rates())), 2):
        line = create_line(code, paced=True)
        line.host = LineSettings(baud_rates()[host])
        query(line, "81")
        line.host = LineSettings(baud_rates()[code])
        line.advance(0.02)
        query(line, "FF")
        assert query(line, "81") == b"TReX1.2"


def test_board_at_other_rate_latches_error_and_ignores_command() -> None:
    line = SimulatedBoards([create_board(7, settings=0x05), create_board(9, settings=0x0A)])
    line.host = LineSettings(19200)
    assert query(line, "81") == b"TReX1.2"
    assert query(line, "F0 7F") == b""
    same_rate, other_rate = line.boards
    assert (same_rate.aux.speed, other_rate.aux.speed) == (127, 0)
    assert not same_rate.serial.uart_errors
    assert UartError.FRAMING in other_rate.serial.uart_errors


def test_power_cut_discards_half_received_byte() -> None:
    line = create_line(10, paced=True)
    line.host = LineSettings(1200)
    board = line.boards[0]
    line.send(b"\x55")
    line.advance(0.002)
    board.power_off()
    line.advance(0.001)
    board.power_on()
    line.advance(0.1)
    line.host = LineSettings(115200)
    assert query(line, "82") == b"r"


def garbage(host: int, *, so_ground: bool) -> bytes:
    """Return the bytes that a host at this rate receives after sending every byte."""
    board = create_board()
    board.so_ground = so_ground
    line = SimulatedBoards([board])
    line.host = LineSettings(host)
    for byte in range(256):
        line.send(bytes([byte]))
        line.advance(0.02)
    return line.receive()


def test_board_with_so_grounded_sends_nothing() -> None:
    rates = [rate for rate in baud_rates() if rate >= 9600 and rate != 19200]
    assert any(garbage(rate, so_ground=False) for rate in rates)
    assert not any(garbage(rate, so_ground=True) for rate in rates)
