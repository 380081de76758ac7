"""Looking for a board at every rate must not start a motor of one that runs at another."""

from collections import deque
from collections.abc import Iterable, Iterator, Sequence
from functools import cache
from itertools import permutations

import pytest

from tests.devices.trex.simulator.ports import a_board
from trex_gui.core.simulator.sampling import ReceiveError, Receiver, SampledByte
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings, baud_rates
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import TrexLine
from trex_gui.devices.trex.simulator.motors import MotorDirection
from trex_gui.devices.trex.simulator.uart import SerialPort, remainder

NULL = b"\xff"
COMPACT = tuple(bytes([command]) for command in range(0x81, 0x86))
EXPANDED = tuple(bytes([0x80, 7, command]) for command in (0x7F, 1, 2, 3, 4, 5))


def checked(packet: bytes) -> bytes:
    return packet + bytes([remainder(packet, 0x89)])


PLAIN = (NULL, *COMPACT, *EXPANDED)
ALL = PLAIN + tuple(checked(packet) for packet in PLAIN)
SAFE = {
    "plain": (NULL, *COMPACT),
    "one question with a checksum": (NULL, checked(b"\x81")),
}
"""Packets that may follow one another in any order."""

SKEWS = (-0.01, -1e-6, 1e-6, 0.01)
"""How far the clock of a board may be off; the smallest decide samples on an edge."""

Word = tuple[tuple[int, ReceiveError | None], ...]
"""What a receiver makes of one packet."""


def moves(board: Board) -> bool:
    """Whether a motor runs, is told to, or the memory is being written."""
    return bool(
        any(
            MotorDirection.BRAKE not in {motor.direction, motor.target_direction}
            and (motor.speed or motor.target_speed)
            for motor in board.motors
        )
        or board.aux.speed
        or board.aux.target_speed
        or board.memory.busy_for
    )


def a_touchy_board(code: int, detection: Detection) -> Board:
    """A board that line errors do not stop."""
    return a_board(settings=code | detection, uart_error_shutdown=0)


def other_baud_rates() -> Iterator[tuple[int, int]]:
    """Return the code of each board with each wrong rate of the host."""
    for code, host in permutations(range(len(baud_rates())), 2):
        yield code, baud_rates()[host]


def send_alone(line: TrexLine, packet: bytes) -> None:
    """Send a packet and a gap, and look at the board after every event."""
    (board,) = line.boards
    line.send(packet)
    while (event := line.next_event) is not None:
        line.advance_to(event)
        assert not moves(board), packet.hex(" ")
    line.advance(0.005)
    assert not moves(board), packet.hex(" ")


@pytest.mark.parametrize("detection", [Detection.NONE, Detection.CRC7])
@pytest.mark.parametrize("paced", [True, False])
def test_single_packet_never_affects_board_at_another_rate(
    detection: Detection, paced: bool
) -> None:
    for code, baud in other_baud_rates():
        board = a_touchy_board(code, detection)
        stored = board.memory.stored()
        line = TrexLine([board], paced=paced)
        line.host = LineSettings(baud)
        for packet in ALL:
            send_alone(line, packet)
            assert (board.memory.stored(), board.memory.writes) == (stored, 0)
            board.power_cycle()  # nothing is left over of what it heard


@cache
def words(packet: bytes, host: LineSettings, own: LineSettings) -> frozenset[Word]:
    """Return all that a receiver may make of a packet that comes alone."""
    result = set()
    for skew in SKEWS:
        receiver = Receiver(own, own.baud)
        receiver._bit /= 1 + skew
        heard: list[SampledByte] = []
        for index, byte in enumerate(packet):
            heard += receiver.receive(index * host.seconds(1), byte, host, host.baud)
        heard += receiver.idle(1.0)
        result.add(tuple((each.value, each.error) for each in heard))
    return frozenset(result)


def has_run_away(heard: Iterable[Word], board: Board) -> bool:
    """Whether a board that hears these words, in any order and number, ever moves.

    Searches the states of its program: the begun packets that a word can leave behind. To pass
    over a packet for another board is no state of its own: nothing moves then.
    """
    begun: set[bytes] = {b""}
    waiting = deque(begun)
    words = sorted(set(heard), key=repr)
    while waiting:
        start = waiting.popleft()
        for word in words:
            port = SerialPort(board)
            for byte in start:
                port.feed(byte)
            for value, error in word:
                if error is None:
                    port.feed(value)
                else:
                    port.feed_error(error)
                if moves(board):
                    return True
            left = bytes(port._packet)
            if left not in begun:
                begun.add(left)
                waiting.append(left)
    return False


@pytest.mark.parametrize("detection", Detection)
@pytest.mark.parametrize("packets", SAFE.values(), ids=SAFE)
def test_scan_packets_in_any_order_are_safe_at_other_rates(
    packets: Sequence[bytes], detection: Detection
) -> None:
    board = a_touchy_board(5, detection if detection is Detection.CRC7 else Detection.NONE)
    known: set[frozenset[Word]] = set()
    for code, baud in other_baud_rates():
        own = LineSettings(baud_rates()[code], detection)
        host = LineSettings(baud)
        heard = frozenset().union(*(words(packet, host, own) for packet in packets))
        if heard not in known:
            known.add(heard)
            assert not has_run_away(heard, board), (host, own)
    assert not board.memory.writes


@pytest.mark.parametrize(
    ("host", "board"), [(14400, 9600), (28800, 19200), (57600, 38400), (115200, 76800)]
)
def test_mixing_plain_and_crc_requests_can_start_aux_motor(host: int, board: int) -> None:
    # Two thirds of the rate make F0 of 81, and 30 FD of 81 48: a search must not mix them.
    code = baud_rates().index(board)
    for settings in (a_touchy_board(code, Detection.NONE), a_board(settings=code)):
        line = TrexLine([settings])
        line.host = LineSettings(host)
        line.send(b"\x81")
        line.advance(0.05)
        assert not moves(settings)
        line.send(b"\x81\x48")
        speeds = [0]
        while (event := line.next_event) is not None:
            line.advance_to(event)
            speeds.append(settings.aux.speed)
        assert max(speeds) == 0x30
        # FD is no command: where errors stop the motors, it stops this one.
        stops = bool(settings.memory.active["uart_error_shutdown"])
        assert speeds[-1] == (0 if stops else 0x30)
