"""Finding a board at any settings, and moving nothing on the way there.

The search is proved safe twice: as a whole, in the order in which it asks, on every board there
is; and question by question, after anything else, for boards whose polynomial and device number
nobody knows and whose clock is off. What the full search adds is proved with `-m slow`.
"""

from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import cache
from itertools import permutations, product

import pytest

from tests.devices.trex.simulator.ports import a_board
from tests.support.matrix import sampled
from tests.support.virtual import SessionHarness, VirtualTransport
from trex_gui.core.discovery.prober import FLUSH_BYTE, FLUSH_LINE, ScanProgress
from trex_gui.core.discovery.scan import PortScan, scan_port
from trex_gui.core.errors import BadRequest, PortUnavailable
from trex_gui.core.simulator import sampling
from trex_gui.core.simulator.sampling import _SAMPLE_AT, Receiver
from trex_gui.core.transport.settings import SerialFormat
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.discovery import TREX_PROBER, FoundBoard, attempts, boards_by_number
from trex_gui.devices.trex.probe import Attempt
from trex_gui.devices.trex.protocol.commands import COMMANDS
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings, baud_rates
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import SimulatedBoards

VIRTUAL = ConnectionSettings("virtual")
PARITIES = (Detection.NONE, Detection.EVEN, Detection.ODD)
ALL_LINES = [
    LineSettings(baud, detection, stop_bits)
    for detection, stop_bits, baud in product(Detection, (1, 2), baud_rates())
]
ONE_STOP_BIT = [settings for settings in ALL_LINES if settings.stop_bits == 1]
"""What a board hears of lone bytes does not hang on how long it may rest behind them."""

LIKELY_AGAIN = 9
"""Probes that end the search: the five likely ones, and the default four times more."""


class Wire(VirtualTransport):
    """A simulated wire whose host can change its settings."""

    unable: frozenset[int] = frozenset()

    def __init__(self, line: SimulatedBoards) -> None:
        super().__init__(line)
        self.configured: list[SerialFormat] = []

    def reconfigure(self, line: SerialFormat) -> None:
        if line.baud in self.unable:
            raise BadRequest("no such rate")
        self.configured.append(line)
        self.line.host = line


def wire_of(*boards: Board, echo: bool = False) -> Wire:
    line = SimulatedBoards(boards, echo=echo)
    line.host = FLUSH_LINE
    return Wire(line)


def never() -> bool:
    return False


def search(
    wire: Wire,
    *,
    full: bool = False,
    progress: Callable[[ScanProgress], None] = lambda _: None,
    cancelled: Callable[[], bool] = never,
) -> PortScan:
    return scan_port(
        VIRTUAL,
        {"trex": TREX_PROBER},
        full=full,
        progress=progress,
        cancelled=cancelled,
        open_wire=lambda _settings: wire,
    )


def only(result: PortScan) -> FoundBoard:
    (found,) = result.found
    assert isinstance(found, FoundBoard)
    return found


def diagnosis_of(wire: Wire) -> str:
    (line,) = search(wire).lines
    return line


# --- The whole search -------------------------------------------------------------------


@pytest.mark.parametrize(
    "settings", sampled(ALL_LINES, every=9), ids=lambda settings: settings.text()
)
def test_search_finds_every_board_and_commands_no_motor(
    settings: LineSettings, motor_commands: list[str]
) -> None:
    for shutdown in (0, 1):
        board = a_board(settings=settings.to_wire(), uart_error_shutdown=shutdown)
        stored = board.memory.stored()
        wire = wire_of(board)
        found = only(search(wire))
        assert found.settings == ConnectionSettings("virtual", settings)
        assert (str(found.signature), found.device_number) == ("TReX 1.2", 7)
        assert (found.note, found.echo) == ("", False)
        assert not motor_commands
        assert (board.memory.stored(), board.memory.writes) == (stored, 0)
        assert wire.closed


@pytest.mark.parametrize(
    "settings", sampled(ONE_STOP_BIT, every=7), ids=lambda settings: settings.text()
)
def test_search_without_replies_commands_no_motor(
    settings: LineSettings, motor_commands: list[str]
) -> None:
    board = a_board(settings=settings.to_wire(), uart_error_shutdown=0)
    wire = wire_of(board)
    wire.line.faults.mute = True
    assert not search(wire).found
    assert not motor_commands
    assert not board.memory.writes


def a_full_search_moves_nothing(settings: LineSettings, motor_commands: list[str]) -> None:
    board = a_board(settings=settings.to_wire(), uart_error_shutdown=0)
    wire = wire_of(board)
    wire.line.faults.mute = True
    search(wire, full=True)
    assert not motor_commands
    assert not board.memory.writes


def test_full_search_commands_no_motor(motor_commands: list[str]) -> None:
    a_full_search_moves_nothing(LineSettings(9600), motor_commands)


@pytest.mark.slow
@pytest.mark.timeout(900)
def test_full_search_commands_no_motor_on_any_board(motor_commands: list[str]) -> None:
    for settings in ALL_LINES:
        a_full_search_moves_nothing(settings, motor_commands)


# --- Each question by itself ------------------------------------------------------------

SKEWS = (-0.03, -0.01, -1e-6, 1e-6, 0.01, 0.03)
"""How far the clock of a board may be off; the smallest decide samples on an edge."""

SAMPLES = (0.5, 0.55, 0.6)
"""Where in a bit a board may read it."""

BAD = -1
"""Stands for a byte that the hardware found bad: whatever began is over then."""

Word = tuple[int, ...]
State = tuple[int, ...]


@cache
def words(packet: bytes, host: SerialFormat, own: LineSettings) -> frozenset[Word]:
    """Return all that a board may hear of a packet that comes alone.

    A board is deaf while it answers, so behind a question any part of the rest may be missing.
    """
    heard: set[Word] = set()
    for skew, sample in product(SKEWS, SAMPLES):
        sampling._SAMPLE_AT = sample
        receiver = Receiver(own, own.baud)
        receiver._bit /= 1 + skew
        each = [
            heard_byte
            for index, byte in enumerate(packet)
            for heard_byte in receiver.receive(index * host.seconds(1), byte, host, host.baud)
        ]
        each += receiver.idle(1.0)
        word = tuple(BAD if it.error else it.value for it in each)
        heard.add(word)
        for index, value in enumerate(word):
            if 0x81 <= value <= 0x9F:  # is answered
                is_at_rest = range(index + 1, len(word) + 1)
                heard |= {word[: index + 1] + word[rest:] for rest in is_at_rest}
    sampling._SAMPLE_AT = _SAMPLE_AT
    return frozenset(heard)


def after(begun: State, value: int, *, crc: bool) -> Iterator[State | str]:
    """Yield what a byte can make of a begun packet: what is begun then, or an order obeyed.

    Takes every device number for the board's own and every checksum for the right one.
    """
    if value in {BAD, 0xFF}:
        yield ()
        return
    packet = (value,) if value & 0x80 else (*begun, value) if begun else ()
    if not packet:
        yield ()
        return
    head = 3 if packet[0] == 0x80 else 1
    if len(packet) < head:
        yield packet
        yield ()  # a packet for another board
        return
    command = packet[head - 1] | 0x80
    known = COMMANDS.get(command)
    if known is None or command == 0xFF:
        yield ()
    elif len(packet) < head + known.data_size + crc:
        yield packet
    elif command >= 0xA0:
        yield bytes(packet).hex(" ")
    else:
        yield ()


def hear(
    begun: Iterable[State], packet: bytes, host: SerialFormat, own: LineSettings, *, crc: bool
) -> tuple[set[State], set[str]]:
    """Return what packets may be begun after one more was sent, and the orders obeyed."""
    left: set[State] = set()
    obeyed: set[str] = set()
    for start, word in product(begun, words(packet, host, own)):
        states: set[State] = {start}
        for value in word:
            results = {result for state in states for result in after(state, value, crc=crc)}
            obeyed |= {result for result in results if isinstance(result, str)}
            states = {result for result in results if not isinstance(result, str)}
        left |= states
    return left, obeyed


OWN = [LineSettings(baud, detection) for detection in PARITIES for baud in baud_rates()]


def orders_obeyed(questions: Sequence[Attempt], own: LineSettings, *, crc: bool) -> set[str]:
    """Return every order that a board may obey when these are asked in any order and number."""
    begun: set[State] = {()}
    waiting = deque(begun)
    obeyed: set[str] = set()
    while waiting:
        state = waiting.popleft()
        rinsed, first = hear({state}, FLUSH_BYTE, FLUSH_LINE, own, crc=crc)
        obeyed |= first
        for attempt in questions:
            if attempt.line == own:
                continue  # it is understood, and found
            left, more = hear(rinsed, attempt.data, attempt.line, own, crc=crc)
            obeyed |= more
            waiting.extend(left - begun)
            begun |= left
    return obeyed


@pytest.mark.slow
@pytest.mark.timeout(900)
def test_no_full_search_sequence_forms_a_motor_command() -> None:
    for own in OWN:
        for crc in (False, True) if own.detection is Detection.NONE else (False,):
            assert not orders_obeyed(list(attempts(full=True)), own, crc=crc)


def test_flush_byte_ends_partial_packets() -> None:
    begun = [(first, *rest) for first in range(0x80, 0xF2) for rest in ((), (1,), (1, 2))]
    for own in OWN:
        left, obeyed = hear(begun, FLUSH_BYTE, FLUSH_LINE, own, crc=False)
        assert left <= {(), (0x80,)}
        assert not obeyed


def test_probes_without_flush_byte_can_start_motors() -> None:
    """The danger is real: else the tests above would say nothing."""
    for own, order in (
        (LineSettings(19200, Detection.ODD), "f0 01"),  # though 81 is all that is sent
        (LineSettings(9600), "f0 30"),
    ):
        plain = own.detection is Detection.ODD
        questions = [attempt for attempt in attempts() if not (plain and attempt.polynomials)]
        begun: set[State] = {()}
        obeyed: set[str] = set()
        for attempt in questions * 2:
            if attempt.line != own:
                left, more = hear(begun, attempt.data, attempt.line, own, crc=False)
                begun |= left
                obeyed |= more
        assert order in obeyed


# --- What it asks, and in which order ---------------------------------------------------


def test_likely_line_settings_are_probed_first() -> None:
    first = [attempt.line for attempt in attempts()][:5]
    assert first == [LineSettings(baud) for baud in (19200, 115200, 9600, 38400, 57600)]


def test_every_line_setting_is_probed_once() -> None:
    requested = [attempt.line for attempt in attempts()]
    assert len(requested) == len(set(requested)) == len(ALL_LINES)
    assert set(requested) == set(ALL_LINES)


def test_search_requests_only_signatures() -> None:
    assert {attempt.data[:1] for attempt in attempts(full=True)} == {b"\x81"}
    plain = [attempt for attempt in attempts() if attempt.line.detection is not Detection.CRC7]
    assert {attempt.data for attempt in plain} == {b"\x81"}


def test_flush_byte_precedes_each_probe() -> None:
    wire = wire_of(a_board())
    wire.line.faults.mute = True
    search(wire)
    assert bytes(wire.sent).startswith(FLUSH_BYTE + b"\x81" + FLUSH_BYTE + b"\x81")
    probes = len(ALL_LINES) + LIKELY_AGAIN
    assert wire.sent.count(FLUSH_BYTE) == probes + 1  # one before the port is closed
    assert wire.configured[0:-1:2] == [FLUSH_LINE] * (probes + 1)


# --- A line that swallows bytes ---------------------------------------------------------


@pytest.mark.parametrize("fault", ["to_drop", "to_drop_sent"])
@pytest.mark.parametrize("count", [1, 7, 40])
def test_board_is_found_on_line_that_swallows_bytes(fault: str, count: int) -> None:
    wire = wire_of(a_board(9))
    setattr(wire.line.faults, fault, count)
    found = only(search(wire))
    assert found.settings.line == LineSettings()
    assert found.device_number == 9


@pytest.mark.parametrize("baud", [115200, 9600])
def test_likely_rate_is_probed_again_at_the_end(baud: int) -> None:
    wire = wire_of(a_board(settings=LineSettings(baud).to_wire()))
    wire.line.faults.to_drop = 14  # the replies to the probes with and without a checksum
    assert only(search(wire)).settings.line.baud == baud


def test_second_look_at_silent_line_takes_a_tenth_of_the_search() -> None:
    wire = wire_of(a_board())
    wire.line.faults.mute = True
    began: list[float] = []
    search(wire, progress=lambda _: began.append(wire.clock()))
    assert began[-1] - began[len(ALL_LINES)] < 0.1 * (began[len(ALL_LINES)] - began[0])


# --- What it tells ----------------------------------------------------------------------


def test_progress_names_next_probe() -> None:
    steps: list[ScanProgress] = []
    wire = wire_of(a_board(settings=LineSettings(9600).to_wire()))
    search(wire, progress=steps.append)
    assert [(step.done, step.line.baud) for step in steps] == [(0, 19200), (1, 115200), (2, 9600)]
    assert {step.total for step in steps} == {len(ALL_LINES) + LIKELY_AGAIN}


def test_search_can_be_cancelled() -> None:
    steps: list[ScanProgress] = []
    wire = wire_of(a_board())
    wire.line.faults.mute = True
    result = search(wire, progress=steps.append, cancelled=lambda: len(steps) == 4)
    assert result.cancelled
    assert len(steps) == 4
    assert wire.closed


def test_device_number_scan_reports_progress_and_cancels() -> None:
    steps: list[ScanProgress] = []
    wire = wire_of(a_board(9))
    result = search(wire, full=True, progress=steps.append, cancelled=lambda: len(steps) > 11)
    assert only(result).device_number == 9
    assert [step.number for step in steps] == [None, *range(11)]


def test_fixed_rate_port_is_probed_once() -> None:
    wire = wire_of(a_board(settings=LineSettings(9600).to_wire()))
    wire.is_configurable = False
    assert "set at the other end" in diagnosis_of(wire)
    assert bytes(wire.sent) == FLUSH_BYTE + b"\x81"


def test_trex_jr_on_rs232_side_is_found_with_its_number() -> None:
    wire = wire_of(a_board(12, LineSettings(57600).to_wire(), "trexjr"), echo=True)
    found = only(search(wire))
    assert (str(found.signature), found.device_number, found.echo) == ("TReX Jr 1.2", 12, True)


@pytest.mark.parametrize("chosen", [28800, 38400])
def test_half_baud_rate_of_old_firmware_is_explained(chosen: int) -> None:
    board = Board("trex", "1.1", eeprom=a_board(settings=LineSettings(chosen).to_wire()).eeprom)
    found = only(search(wire_of(board)))
    assert found.settings.line == LineSettings(chosen // 2)
    assert f"set to {chosen} baud" in found.note


def test_line_settings_pending_power_cycle_are_reported() -> None:
    board = a_board()
    board.set_parameter(0x7E, LineSettings(115200).to_wire())
    board.advance(0.1)
    found = only(search(wire_of(board)))
    assert found.settings.line == LineSettings()
    assert found.note.startswith("After a power cycle, it will run at 115200 baud")


def test_other_polynomial_is_found_only_by_full_search() -> None:
    line = LineSettings(19200, Detection.CRC7)
    for polynomial in (0x83, 0xFF):
        board = a_board(settings=line.to_wire(), crc7_polynomial=polynomial & 0x7F)
        assert not search(wire_of(board)).found
        found = only(search(wire_of(board), full=True))
        assert found.settings == ConnectionSettings("virtual", line, polynomial=polynomial)


@pytest.mark.parametrize("model", ["trex", "trexjr"])
def test_boards_on_one_line_are_found_by_number(model: str) -> None:
    boards = [a_board(9), a_board(12, model=model)]
    found = search(wire_of(*boards)).found
    name = {"trex": "TReX 1.2", "trexjr": "TReX Jr 1.2"}[model]
    assert [(each.name, each.device_number) for each in found] == [("TReX 1.2", 9), (name, 12)]


def test_board_with_unique_number_is_found_among_duplicates() -> None:
    boards = [a_board(9), a_board(9, model="trexjr"), a_board(12)]
    found = only(search(wire_of(*boards)))
    assert (str(found.signature), found.settings.device_number) == ("TReX 1.2", 12)


def test_boards_that_share_a_number_are_recognised() -> None:
    diagnosis = diagnosis_of(wire_of(a_board(9), a_board(9, model="trexjr")))
    assert "Several boards reply at once" in diagnosis


def test_echo_without_reply_is_reported() -> None:
    board = a_board()
    board.power_off()
    assert "comes back" in diagnosis_of(wire_of(board, echo=True))


def test_missing_reply_diagnosis_suggests_checking_power() -> None:
    board = a_board()
    board.power_off()
    diagnosis = diagnosis_of(wire_of(board))
    assert "No TReX responds on virtual" in diagnosis
    assert "power" in diagnosis


@pytest.mark.parametrize("full", [False, True])
def test_board_waiting_for_firmware_ends_the_search(*, full: bool) -> None:
    board = a_board()
    board.mode_jumper, board.mix, board.so_ground = "serial", True, True
    board.power_off()
    board.power_on()
    wire = wire_of(board)
    board.mix = False
    wire.line.advance(0.1)
    board.so_ground = False
    wire.line.advance(0.1)
    (line,) = search(wire, full=full).lines
    assert "waiting for new firmware" in line
    assert wire.line.now < 2


def test_unsupported_baud_rates_are_skipped() -> None:
    wire = wire_of(a_board(settings=LineSettings(4800).to_wire()))
    wire.unable = frozenset({14400, 76800})
    assert only(search(wire)).settings.line == LineSettings(4800)


def test_port_loss_ends_search() -> None:
    wire = wire_of(a_board())
    wire.fail = PortUnavailable("It is gone.")
    assert isinstance(search(wire).error, PortUnavailable)
    assert wire.closed


def test_search_finds_board_on_noisy_line() -> None:
    wire = wire_of(a_board(settings=LineSettings(1200).to_wire()))
    wire.line.faults.noise = 0.02
    assert only(search(wire)).settings.line.baud == 1200


class PolledWire(Wire):
    """A wire on which another master asks board 7 for its signature whenever one listens."""

    def read(self, size: int, seconds: float) -> bytes:
        self.line.send(b"\x80\x07\x01")
        return super().read(size, seconds)


def test_replies_to_another_master_are_no_answers() -> None:
    client = TrexClient(PolledWire(SimulatedBoards([a_board()])), VIRTUAL)
    found = boards_by_number(client, lambda _number: None, lambda: False)
    assert {board.device_number for board in found} <= {7}


# --- A session without a reply --------------------------------------------------------


def _sent_to_nobody(settings: ConnectionSettings) -> list[bytes]:
    """Return what a session sends while nothing answers."""
    harness = SessionHarness(Board())
    harness.line.faults.mute = True
    harness.run(settings)
    return [data for _, data in harness.transport.written]


def _moves(line: SimulatedBoards, board: Board, packets: list[bytes]) -> list[str]:
    """Send packets with gaps. Return those on which a motor is told to run, however briefly."""
    moving = []
    for packet in packets:
        line.send(packet)
        runs = False
        while (event := line.next_event) is not None:
            line.advance_to(event)
            runs |= any(motor.target_direction.value != "brake" for motor in board.motors)
            runs |= board.aux.target_speed > 0
        if runs:
            moving.append(packet.hex(" "))
            board.serial.stop_motors()
    return moving


@pytest.mark.parametrize(
    ("detection", "device_number"), sampled(product(Detection, (None, 7)), every=3)
)
def test_connection_probes_start_no_motor_at_any_rate(
    detection: Detection, device_number: int | None
) -> None:
    settings = ConnectionSettings("virtual", LineSettings(detection=detection), device_number)
    packets = _sent_to_nobody(settings)
    assert packets
    for own_detection in Detection:
        for own, host in permutations(baud_rates(), 2):
            board = a_board(settings=LineSettings(own, own_detection).to_wire())
            line = SimulatedBoards([board])
            line.host = LineSettings(host, detection)
            moving = _moves(line, board, packets)
            assert not moving, f"{host} to {own} baud, {own_detection.name}: {moving}"
            assert not board.memory.writes


def test_misread_packets_can_start_a_motor() -> None:
    """The danger is real: else the test above would say nothing."""
    board = a_board()
    line = SimulatedBoards([board])
    line.host = LineSettings(38400)
    queries = [bytes.fromhex("80 07 04 50"), bytes.fromhex("80 07 05 59")]
    assert _moves(line, board, queries) == ["80 07 05 59"]
