"""Line of simulated boards: timing, line settings, faults and reproducible noise."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.devices.trex.simulator.ports import create_board, query
from tests.support.matrix import examples
from trex_gui.core.simulator.sampling import ReceiveError
from trex_gui.devices.trex.protocol.flags import UartError
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.simulator.control import control
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import SimulatedBoards
from trex_gui.devices.trex.simulator.motors import MotorDirection

BYTE = 10 / 19200
"""Time of a byte in seconds, with the factory settings."""

SIGNATURE = b"TReX1.2"


class TestPace:
    def test_request_and_reply_take_line_time(self, line: SimulatedBoards) -> None:
        line.send(b"\x81")
        assert line.read(7, 7.9 * BYTE) == SIGNATURE[:6]
        assert line.now == pytest.approx(7.9 * BYTE)
        assert line.read(1, 1) == SIGNATURE[6:]
        assert line.now == pytest.approx(8 * BYTE)

    def test_read_returns_at_its_timeout(self, line: SimulatedBoards) -> None:
        assert line.read(1, 0.5) == b""
        assert line.now == pytest.approx(0.5)
        assert line.boards[0].now == pytest.approx(0.5)

    def test_parity_and_stop_bits_lengthen_each_byte(self) -> None:
        line = SimulatedBoards([create_board(settings=0x55)])
        line.send(b"\x82")
        line.read(1, 1)
        assert line.now == pytest.approx(2 * 12 / 19200)

    def test_unpaced_bytes_take_no_time(self, board: Board) -> None:
        line = SimulatedBoards([board], paced=False)
        line.send(b"\x81")
        line.advance(0)
        assert line.receive() == SIGNATURE
        assert line.now == 0

    def test_unpaced_line_waits_for_eeprom_write(self, board: Board) -> None:
        line = SimulatedBoards([board], paced=False)
        line.send(bytes.fromhex("AF 07 0F 55 2A"))
        assert line.read(1, 0.0039) == b""
        assert line.read(1, 0.001) == b"\x00"
        assert line.now == pytest.approx(0.004)

    def test_backlog_is_line_time_of_queued_bytes(self, line: SimulatedBoards) -> None:
        line.send(bytes(1920))
        assert line.backlog == pytest.approx(1)
        line.advance(0.4)
        assert line.backlog == pytest.approx(0.6)
        line.advance(1)
        assert line.backlog == 0

    @examples(40)
    @given(cuts=st.lists(st.floats(0, 0.01), max_size=20))
    def test_line_result_does_not_depend_on_time_steps(self, cuts: list[float]) -> None:
        line = SimulatedBoards([Board()])
        line.send(bytes.fromhex("AF 07 0F 55 2A"))
        received = b""
        for seconds in (*cuts, 0.02):
            line.advance(seconds)
            received += line.receive()
        assert received == b"\x00"
        assert line.boards[0].memory.get(0x07) == 15

    @pytest.mark.parametrize(
        ("board_settings", "host", "error"),
        [
            (0x05, LineSettings(stop_bits=2), UartError.FRAMING),
            (0x05, LineSettings(detection=Detection.EVEN), UartError.FRAMING),
            (0x45, LineSettings(), UartError.PARITY),
            (0x45, LineSettings(detection=Detection.ODD), UartError.PARITY),
        ],
    )
    def test_wrong_parity_or_stop_bits_give_error_and_no_reply(
        self, board_settings: int, host: LineSettings, error: UartError
    ) -> None:
        line = SimulatedBoards([create_board(settings=board_settings)])
        line.host = host
        line.send(bytes.fromhex("81 F0 7F"))
        line.advance(1)
        assert line.receive() == b""
        assert line.boards[0].serial.uart_errors == error
        assert line.boards[0].aux.speed == 0


class TestEcho:
    def test_echo_works_without_board_power(self, board: Board) -> None:
        board.power_off()
        line = SimulatedBoards([board], echo=True)
        line.send(b"\xff")
        assert line.read(2, 1) == b"\xff"

    def test_byte_sent_during_reply_corrupts_echo_and_reply(self, board: Board) -> None:
        line = SimulatedBoards([board], echo=True)
        line.send(b"\x81\x81")
        assert line.read(9, 1) == bytes([0x81, ord("T") & 0x81]) + b"ReX1.2"


class TestSeveralBoards:
    @pytest.mark.parametrize("paced", [True, False])
    def test_compact_request_makes_all_boards_reply_at_once(self, paced: bool) -> None:
        line = SimulatedBoards([create_board(7), create_board(9, model="trexjr")], paced=paced)
        both = bytes(a & b for a, b in zip(b"TReX1.2\xff\xff", b"TReXJr1.2", strict=True))
        assert query(line, "81") == both
        assert line.faults.counters["collisions"] == 7

    def test_identical_replies_are_received_as_one_reply(self) -> None:
        assert query(SimulatedBoards([create_board(7), create_board(9)]), "82") == b"r"

    def test_compact_motor_command_reaches_all_boards(self) -> None:
        line = SimulatedBoards([create_board(7), create_board(9), create_board(11)])
        query(line, "F0 7F")
        query(line, "80 09 70 05")
        assert [board.aux.speed for board in line.boards] == [127, 5, 127]

    def test_line_without_board_is_rejected(self) -> None:
        with pytest.raises(ValueError, match="board"):
            SimulatedBoards([])


class TestFaults:
    def test_requested_number_of_receive_errors_occurs(self, line: SimulatedBoards) -> None:
        line.faults.errors.extend([ReceiveError.FRAMING] * 3)
        assert query(line, "82 82 82") == b""
        assert query(line, "82") == b"r"

    def test_all_boards_on_line_detect_the_same_error(self) -> None:
        line = SimulatedBoards([create_board(7), create_board(9)])
        line.faults.errors.append(ReceiveError.OVERRUN)
        query(line, "82")
        errors = [board.serial.uart_errors for board in line.boards]
        assert errors == [UartError.DATA_OVERRUN] * 2

    def test_muted_line_carries_commands_but_no_replies(self, line: SimulatedBoards) -> None:
        line.faults.mute = True
        assert query(line, "81") == b""
        assert query(line, "F0 7F") == b""
        assert line.boards[0].aux.speed == 127
        line.faults.mute = False
        assert query(line, "82") == b"r"

    @pytest.mark.parametrize(
        ("fault", "count", "reply"), [("to_drop", 3, b"X1.2"), ("to_double", 2, b"TTRReX1.2")]
    )
    def test_fault_drops_or_doubles_bytes_of_reply(
        self, line: SimulatedBoards, fault: str, count: int, reply: bytes
    ) -> None:
        setattr(line.faults, fault, count)
        assert query(line, "81") == reply
        assert query(line, "82") == b"r"

    def test_drop_sent_loses_bytes_of_request(self, line: SimulatedBoards) -> None:
        line.faults.to_drop_sent = 1
        assert query(line, "F0 7F") == b""
        assert line.boards[0].aux.speed == 0
        assert query(line, "85") == b"\x40"

    def test_requested_number_of_reply_bytes_is_corrupted(self, line: SimulatedBoards) -> None:
        line.faults.to_corrupt = 2
        reply = query(line, "81")
        assert [a == b for a, b in zip(reply, SIGNATURE, strict=True)] == [False] * 2 + [True] * 5
        assert query(line, "82") == b"r"

    def test_delayed_reply_arrives_late_and_in_order(self, line: SimulatedBoards) -> None:
        line.faults.delay = 0.5
        line.send(b"\x81")
        line.advance(8 * BYTE)
        line.faults.delay = 0.0
        line.send(b"\x82")
        line.advance(0.4)
        assert line.receive() == b""
        line.advance(0.2)
        assert line.receive() == b"TReX1.2r"

    def test_delayed_reply_is_lost_when_unplugged(self, line: SimulatedBoards) -> None:
        line.faults.delay = 0.5
        line.send(b"\x81")
        line.advance(0.1)
        line.unplug()
        line.advance(1)
        assert line.receive() == b""

    def test_full_noise_corrupts_every_byte(self, line: SimulatedBoards) -> None:
        line.inject(bytes(500))
        line.faults.noise = 1.0
        received = line.read(500, 10)
        assert len(received) == 500
        assert 0 not in received

    def test_noise_towards_board_latches_uart_errors(self) -> None:
        line = SimulatedBoards([create_board(settings=0x45)])
        line.faults.noise = 1.0
        line.send(b"\x81" * 100)
        line.advance(10)
        assert line.receive() == b""
        assert line.boards[0].serial.uart_errors == UartError.PARITY | UartError.FRAMING

    def test_unplugged_line_carries_nothing(self, line: SimulatedBoards) -> None:
        line.unplug()
        assert query(line, "81") == b""
        assert query(line, "F0 7F") == b""
        assert line.boards[0].aux.speed == 0
        line.plug()
        assert query(line, "82") == b"r"


# --- Incomplete bytes -----------------------------------------------------------------


@pytest.fixture
def running_line(line: SimulatedBoards) -> SimulatedBoards:
    """A line whose board was switched on a second ago."""
    line.advance(1)
    return line


@pytest.mark.parametrize("overlap", [0.05, 0.5, 0.95])
def test_byte_that_begins_during_reply_is_lost(
    running_line: SimulatedBoards, overlap: float
) -> None:
    running_line.send(b"\x81")
    running_line.advance((8 - overlap) * BYTE)
    running_line.send(b"\xc2\x40")
    running_line.advance(0.01)
    assert running_line.receive() == b"TReX1.2"
    assert running_line.boards[0].motors[0].direction is MotorDirection.BRAKE
    assert running_line.boards[0].counters["bytes_missed"] == 1


def test_byte_that_spans_power_up_is_lost(running_line: SimulatedBoards) -> None:
    control(running_line, "power off")
    running_line.send(b"\x81")
    running_line.advance(0.9 * BYTE)
    control(running_line, "power on")
    running_line.advance(0.05)
    assert running_line.receive() == b""


@pytest.mark.parametrize("packet", ["81", "FF 81"])
def test_byte_that_spans_plugging_in_is_lost(running_line: SimulatedBoards, packet: str) -> None:
    control(running_line, "line unplug")
    running_line.send(bytes.fromhex(packet))
    running_line.advance((len(bytes.fromhex(packet)) - 0.1) * BYTE)
    control(running_line, "line plug")
    running_line.advance(0.05)
    assert running_line.receive() == b""
    assert query(running_line, "82") == b"r"


def test_overlapping_replies_are_garbled() -> None:
    """The second reply begins 1 ms after the first."""
    line = SimulatedBoards([create_board(7), create_board(8, uart_response_delay=1)])
    line.advance(0.2)
    line.send(b"\x81")
    line.advance(0.02)
    received = line.receive()
    assert received[:1] == b"T"  # sent before the second reply begins
    assert received != b"TReX1.2"
    assert line.faults.counters["collisions"]
    longest = (0.001 + 7 * BYTE) / BYTE
    assert len(received) <= longest + 1
    assert query(line, "80 08 02") == b"r"


def test_injected_bytes_take_line_time_and_collide_with_reply(
    running_line: SimulatedBoards,
) -> None:
    control(running_line, "line garbage " + "00" * 100)
    control(running_line, "line garbage " + "00" * 100)
    running_line.advance(150 * BYTE)
    assert 140 <= len(running_line.receive()) <= 150
    running_line.advance(60 * BYTE)
    running_line.receive()
    running_line.send(b"\x81")
    running_line.advance(1.5 * BYTE)
    control(running_line, "line garbage " + "00" * 7)
    running_line.advance(0.02)
    assert running_line.receive() != b"TReX1.2"
    assert running_line.faults.counters["collisions"]


@pytest.mark.parametrize("boards", [1, 2])
def test_up_to_10000_injected_bytes_are_delivered(boards: int) -> None:
    line = SimulatedBoards([Board() for _ in range(boards)], echo=True)
    assert control(line, "line garbage " + "A5" * 10_001).startswith("error")
    assert control(line, "line garbage " + "A5" * 10_000).startswith("ok")
    line.advance(10_000 * BYTE + 0.01)
    assert line.receive() == b"\xa5" * 10_000


def test_drop_unsent_discards_queued_bytes(running_line: SimulatedBoards) -> None:
    running_line.send(b"\xc2\x40" * 100)
    running_line.drop_unsent()
    assert running_line.backlog == 0
    running_line.advance(1)
    assert running_line.boards[0].counters["bytes_received"] == 0
    assert query(running_line, "81") == SIGNATURE
    assert not running_line.boards[0].serial.pop_uart_errors() & UartError.FORMAT


# --- Seeds of noise -------------------------------------------------------------------


def replies_with_seed(
    seed: int, lines: tuple[str, ...], packet: str, mode: str = "serial"
) -> bytes:
    """Send control lines, and then the same packet forty times. Return all replies."""
    line = SimulatedBoards([Board(mode=mode, seed=seed)], seed=seed)
    for text in lines:
        assert control(line, text).startswith("ok")
    line.advance(0.5)
    result = b""
    for _ in range(40):
        line.send(bytes.fromhex(packet))
        line.advance(0.021)
        result += line.receive()
    return result


@pytest.mark.parametrize(
    ("lines", "packet", "mode"),
    [
        (("channel 1 1500us noise 3us",), "86 01", "serial"),
        (("channel 1 1500us lost 0.9",), "86 01", "serial"),
        (("line noise 0.1",), "81", "serial"),
        (("load 1 8", "load 2 8"), "DA 7F 7F 8F", "serial"),
        (("channel 3 2.5V noise 50mV",), "86 04", "analog"),
    ],
    ids=["noisy pulses", "lost pulses", "a noisy wire", "noisy currents", "noisy voltage"],
)
def test_same_seed_gives_same_bytes(lines: tuple[str, ...], packet: str, mode: str) -> None:
    first = replies_with_seed(1, lines, packet, mode)
    assert len(set(first)) > 2
    assert (
        replies_with_seed(1, lines, packet, mode)
        == first
        != replies_with_seed(2, lines, packet, mode)
    )


@pytest.mark.parametrize("host", [LineSettings(stop_bits=2), LineSettings(115200)])
def test_same_seed_gives_same_garbage(host: LineSettings) -> None:
    def garbage(seed: int) -> bytes:
        line = SimulatedBoards([Board()], seed=seed)
        result = b""
        for _ in range(50):
            line.host = None
            line.send(b"\x81")
            line.advance(0.0004)
            line.host = host
            line.advance(0.02)
            result += line.receive()
        return result

    first = garbage(1)
    assert len(first) > 50
    assert garbage(1) == first
    if host.stop_bits == 2:  # sampling at another rate has no noise
        assert garbage(2) != first


def test_motors_of_one_board_have_independent_noise() -> None:
    readings = replies_with_seed(1, ("load 1 8", "load 2 8"), "DA 7F 7F 8F")
    assert readings[::2] != readings[1::2]
