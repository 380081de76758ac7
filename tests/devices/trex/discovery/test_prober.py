"""Scans that find a board at any settings without a motor command.

Two groups of tests check the safety. Some run whole scans on boards with each line settings. The
others send probes in any order to boards with any polynomial, device number and clock error. Tests
marked `slow` check full scans.
"""

from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import cache
from itertools import permutations, product

import pytest

from tests.devices.trex.simulator.ports import create_board
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
ALL_LINES = [
    LineSettings(baud, detection, stop_bits)
    for detection, stop_bits, baud in product(Detection, (1, 2), baud_rates())
]
ONE_STOP_BIT = [line for line in ALL_LINES if line.stop_bits == 1]
"""The number of stop bits has no effect on single bytes."""

REPEATED_PROBES = 9
"""Probes at the end of a scan: at five likely line settings, then four more at the default."""


class Wire(VirtualTransport):
    """Simulated line whose host can change its line settings."""

    unsupported_rates: frozenset[int] = frozenset()

    def __init__(self, line: SimulatedBoards) -> None:
        super().__init__(line)
        self.configured: list[SerialFormat] = []

    def reconfigure(self, line: SerialFormat) -> None:
        if line.baud in self.unsupported_rates:
            raise BadRequest("unsupported rate")
        self.configured.append(line)
        self.line.host = line


def wire_of(*boards: Board, echo: bool = False) -> Wire:
    line = SimulatedBoards(boards, echo=echo)
    line.host = FLUSH_LINE
    return Wire(line)


def scan(
    wire: Wire,
    *,
    full: bool = False,
    progress: Callable[[ScanProgress], None] = lambda _: None,
    cancelled: Callable[[], bool] = lambda: False,
) -> PortScan:
    return scan_port(
        VIRTUAL,
        {"trex": TREX_PROBER},
        full=full,
        progress=progress,
        cancelled=cancelled,
        open_wire=lambda _settings: wire,
    )


def found_board(result: PortScan) -> FoundBoard:
    """Return the only board that a scan has found."""
    (found,) = result.found
    assert isinstance(found, FoundBoard)
    return found


def diagnosis_of(wire: Wire) -> str:
    (line,) = scan(wire).lines
    return line


# --- Whole scans ------------------------------------------------------------------------


@pytest.mark.parametrize("settings", sampled(ALL_LINES, every=9), ids=lambda line: line.text())
def test_scan_finds_every_board_and_commands_no_motor(
    settings: LineSettings, motor_commands: list[str]
) -> None:
    for shutdown in (0, 1):
        board = create_board(settings=settings.to_wire(), uart_error_shutdown=shutdown)
        stored = board.memory.stored()
        wire = wire_of(board)
        found = found_board(scan(wire))
        assert found.settings == ConnectionSettings("virtual", settings)
        assert (str(found.signature), found.device_number) == ("TReX 1.2", 7)
        assert (found.note, found.echo) == ("", False)
        assert not motor_commands
        assert (board.memory.stored(), board.memory.writes) == (stored, 0)
        assert wire.closed


SILENT_SCANS = [
    *sampled(product([False], ONE_STOP_BIT), every=7),
    *sampled(product([True], ALL_LINES), every=len(ALL_LINES)),
]


@pytest.mark.parametrize(("full", "settings"), SILENT_SCANS)
def test_scan_without_replies_commands_no_motor(
    settings: LineSettings, motor_commands: list[str], *, full: bool
) -> None:
    board = create_board(settings=settings.to_wire(), uart_error_shutdown=0)
    wire = wire_of(board)
    wire.line.faults.mute = True
    assert not scan(wire, full=full).found
    assert not motor_commands
    assert not board.memory.writes


# --- Sequences of probes ----------------------------------------------------------------

SKEWS = (-0.03, -0.01, -1e-6, 1e-6, 0.01, 0.03)
"""Clock errors of a board. The smallest decide samples on an edge."""

SAMPLES = (0.5, 0.55, 0.6)
"""Fractions of a bit after which a board may sample it."""

BAD = -1
"""Byte that the UART rejects. It ends a partial packet."""

Word = tuple[int, ...]
"""Bytes that a board receives."""

State = tuple[int, ...]
"""Bytes of a partial packet."""


@cache
def received_words(packet: bytes, host: SerialFormat, own: LineSettings) -> frozenset[Word]:
    """Return all words that a board may receive when the host sends a packet.

    A board receives nothing while it replies, so bytes after a query may be missing.
    """
    words: set[Word] = set()
    for skew, sample in product(SKEWS, SAMPLES):
        sampling._SAMPLE_AT = sample
        receiver = Receiver(own, own.baud)
        receiver._bit /= 1 + skew
        received = [
            item
            for index, byte in enumerate(packet)
            for item in receiver.receive(index * host.seconds(1), byte, host, host.baud)
        ]
        received += receiver.idle(1.0)
        word = tuple(BAD if item.error else item.value for item in received)
        words.add(word)
        for index, value in enumerate(word):
            if 0x81 <= value <= 0x9F:  # a query
                ends = range(index + 1, len(word) + 1)
                words |= {word[: index + 1] + word[end:] for end in ends}
    sampling._SAMPLE_AT = _SAMPLE_AT
    return frozenset(words)


def next_states(state: State, value: int, *, crc: bool) -> Iterator[State | str]:
    """Yield each partial packet or executed command after one more byte.

    Accepts every device number and every checksum.
    """
    if value in {BAD, 0xFF}:
        yield ()
        return
    packet = (value,) if value & 0x80 else (*state, value) if state else ()
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


def receive(
    states: Iterable[State], packet: bytes, host: SerialFormat, own: LineSettings, *, crc: bool
) -> tuple[set[State], set[str]]:
    """Return the partial packets after the host has sent a packet, and the executed commands."""
    ends: set[State] = set()
    executed: set[str] = set()
    for start, word in product(states, received_words(packet, host, own)):
        current: set[State] = {start}
        for value in word:
            results = {result for state in current for result in next_states(state, value, crc=crc)}
            executed |= {result for result in results if isinstance(result, str)}
            current = {result for result in results if not isinstance(result, str)}
        ends |= current
    return ends, executed


PARITIES = (Detection.NONE, Detection.EVEN, Detection.ODD)
BOARD_LINES = [LineSettings(baud, detection) for detection in PARITIES for baud in baud_rates()]


def executed_commands(probes: Sequence[Attempt], own: LineSettings, *, crc: bool) -> set[str]:
    """Return all commands that a board may execute when probes are sent in any order and number."""
    states: set[State] = {()}
    waiting = deque(states)
    executed: set[str] = set()
    while waiting:
        state = waiting.popleft()
        flushed, commands = receive({state}, FLUSH_BYTE, FLUSH_LINE, own, crc=crc)
        executed |= commands
        for probe in probes:
            if probe.line == own:
                continue  # this probe finds the board
            ends, commands = receive(flushed, probe.data, probe.line, own, crc=crc)
            executed |= commands
            waiting.extend(ends - states)
            states |= ends
    return executed


@pytest.mark.slow
@pytest.mark.timeout(900)
def test_no_sequence_of_full_scan_forms_a_motor_command() -> None:
    for own in BOARD_LINES:
        for crc in (False, True) if own.detection is Detection.NONE else (False,):
            assert not executed_commands(list(attempts(full=True)), own, crc=crc)


def test_flush_byte_ends_partial_packets() -> None:
    states = [(first, *rest) for first in range(0x80, 0xF2) for rest in ((), (1,), (1, 2))]
    for own in BOARD_LINES:
        ends, executed = receive(states, FLUSH_BYTE, FLUSH_LINE, own, crc=False)
        assert ends <= {(), (0x80,)}
        assert not executed


def test_probes_without_flush_byte_can_start_motors() -> None:
    """Without this danger, the tests above would show nothing."""
    for own, command in (
        (LineSettings(19200, Detection.ODD), "f0 01"),  # only 81 is sent
        (LineSettings(9600), "f0 30"),
    ):
        plain = own.detection is Detection.ODD
        probes = [attempt for attempt in attempts() if not (plain and attempt.polynomials)]
        states: set[State] = {()}
        executed: set[str] = set()
        for probe in probes * 2:
            if probe.line != own:
                ends, commands = receive(states, probe.data, probe.line, own, crc=False)
                states |= ends
                executed |= commands
        assert command in executed


# --- Order of probes --------------------------------------------------------------------


def test_likely_line_settings_are_probed_first() -> None:
    first = [attempt.line for attempt in attempts()][:5]
    assert first == [LineSettings(baud) for baud in (19200, 115200, 9600, 38400, 57600)]


def test_every_line_setting_is_probed_once() -> None:
    probed = [attempt.line for attempt in attempts()]
    assert len(probed) == len(ALL_LINES)
    assert set(probed) == set(ALL_LINES)


def test_scan_requests_only_signatures() -> None:
    assert {attempt.data[:1] for attempt in attempts(full=True)} == {b"\x81"}
    plain = [attempt for attempt in attempts() if attempt.line.detection is not Detection.CRC7]
    assert {attempt.data for attempt in plain} == {b"\x81"}


def test_flush_byte_precedes_each_probe() -> None:
    wire = wire_of(create_board())
    wire.line.faults.mute = True
    scan(wire)
    assert bytes(wire.sent).startswith(FLUSH_BYTE + b"\x81" + FLUSH_BYTE + b"\x81")
    probes = len(ALL_LINES) + REPEATED_PROBES
    assert wire.sent.count(FLUSH_BYTE) == probes + 1  # one before the port is closed
    assert wire.configured[0:-1:2] == [FLUSH_LINE] * (probes + 1)


# --- Lost bytes -------------------------------------------------------------------------


@pytest.mark.parametrize("fault", ["to_drop", "to_drop_sent"])
@pytest.mark.parametrize("count", [1, 7, 40])
def test_scan_finds_board_on_line_that_loses_bytes(fault: str, count: int) -> None:
    wire = wire_of(create_board(9))
    setattr(wire.line.faults, fault, count)
    found = found_board(scan(wire))
    assert found.settings.line == LineSettings()
    assert found.device_number == 9


@pytest.mark.parametrize("baud", [115200, 9600])
def test_likely_rate_is_probed_again_at_the_end(baud: int) -> None:
    wire = wire_of(create_board(settings=LineSettings(baud).to_wire()))
    wire.line.faults.to_drop = 14  # the replies to the probes with and without a checksum
    assert found_board(scan(wire)).settings.line.baud == baud


def test_repeated_probes_take_a_tenth_of_the_scan_time() -> None:
    wire = wire_of(create_board())
    wire.line.faults.mute = True
    starts: list[float] = []
    scan(wire, progress=lambda _: starts.append(wire.clock()))
    assert starts[-1] - starts[len(ALL_LINES)] < 0.1 * (starts[len(ALL_LINES)] - starts[0])


# --- Progress and results ---------------------------------------------------------------


def test_progress_names_next_probe() -> None:
    steps: list[ScanProgress] = []
    wire = wire_of(create_board(settings=LineSettings(9600).to_wire()))
    scan(wire, progress=steps.append)
    assert [(step.done, step.line.baud) for step in steps] == [(0, 19200), (1, 115200), (2, 9600)]
    assert {step.total for step in steps} == {len(ALL_LINES) + REPEATED_PROBES}


def test_scan_can_be_cancelled() -> None:
    steps: list[ScanProgress] = []
    wire = wire_of(create_board())
    wire.line.faults.mute = True
    result = scan(wire, progress=steps.append, cancelled=lambda: len(steps) == 4)
    assert result.cancelled
    assert len(steps) == 4
    assert wire.closed


def test_device_number_scan_reports_progress_and_cancels() -> None:
    steps: list[ScanProgress] = []
    wire = wire_of(create_board(9))
    result = scan(wire, full=True, progress=steps.append, cancelled=lambda: len(steps) > 11)
    assert found_board(result).device_number == 9
    assert [step.number for step in steps] == [None, *range(11)]


def test_fixed_rate_port_is_probed_once() -> None:
    wire = wire_of(create_board(settings=LineSettings(9600).to_wire()))
    wire.is_configurable = False
    assert "set at the other end" in diagnosis_of(wire)
    assert bytes(wire.sent) == FLUSH_BYTE + b"\x81"


def test_trex_jr_on_rs232_side_is_found_with_its_number() -> None:
    wire = wire_of(create_board(12, LineSettings(57600).to_wire(), "trexjr"), echo=True)
    found = found_board(scan(wire))
    assert (str(found.signature), found.device_number, found.echo) == ("TReX Jr 1.2", 12, True)


@pytest.mark.parametrize("baud", [28800, 38400])
def test_half_baud_rate_of_old_firmware_is_explained(baud: int) -> None:
    board = Board("trex", "1.1", eeprom=create_board(settings=LineSettings(baud).to_wire()).eeprom)
    found = found_board(scan(wire_of(board)))
    assert found.settings.line == LineSettings(baud // 2)
    assert f"set to {baud} baud" in found.note


def test_line_settings_pending_power_cycle_are_reported() -> None:
    board = create_board()
    board.set_parameter(0x7E, LineSettings(115200).to_wire())
    board.advance(0.1)
    found = found_board(scan(wire_of(board)))
    assert found.settings.line == LineSettings()
    assert found.note.startswith("After a power cycle, it will run at 115200 baud")


def test_other_polynomial_is_found_only_by_full_scan() -> None:
    line = LineSettings(19200, Detection.CRC7)
    for polynomial in (0x83, 0xFF):
        board = create_board(settings=line.to_wire(), crc7_polynomial=polynomial & 0x7F)
        assert not scan(wire_of(board)).found
        found = found_board(scan(wire_of(board), full=True))
        assert found.settings == ConnectionSettings("virtual", line, polynomial=polynomial)


@pytest.mark.parametrize("model", ["trex", "trexjr"])
def test_boards_on_one_line_are_found_by_number(model: str) -> None:
    boards = [create_board(9), create_board(12, model=model)]
    found = scan(wire_of(*boards)).found
    name = {"trex": "TReX 1.2", "trexjr": "TReX Jr 1.2"}[model]
    assert [(board.name, board.device_number) for board in found] == [("TReX 1.2", 9), (name, 12)]


def test_board_with_unique_number_is_found_among_duplicates() -> None:
    boards = [create_board(9), create_board(9, model="trexjr"), create_board(12)]
    found = found_board(scan(wire_of(*boards)))
    assert (str(found.signature), found.settings.device_number) == ("TReX 1.2", 12)


def test_boards_that_share_a_device_number_are_reported() -> None:
    diagnosis = diagnosis_of(wire_of(create_board(9), create_board(9, model="trexjr")))
    assert "Several boards reply at once" in diagnosis


@pytest.mark.parametrize(
    ("echo", "words"), [(True, ["comes back"]), (False, ["No TReX responds on virtual", "power"])]
)
def test_missing_reply_is_explained(words: list[str], *, echo: bool) -> None:
    board = create_board()
    board.power_off()
    diagnosis = diagnosis_of(wire_of(board, echo=echo))
    assert all(word in diagnosis for word in words)


@pytest.mark.parametrize("full", [False, True])
def test_full_search_is_proposed_unless_it_was_done(*, full: bool) -> None:
    board = create_board()
    board.power_off()
    (line,) = scan(wire_of(board), full=full).lines
    assert ("Only the full search" in line) is not full


@pytest.mark.parametrize("full", [False, True])
def test_board_in_boot_loader_ends_the_scan(*, full: bool) -> None:
    board = create_board()
    board.mode_jumper, board.mix, board.so_ground = "serial", True, True
    board.power_off()
    board.power_on()
    wire = wire_of(board)
    board.mix = False
    wire.line.advance(0.1)
    board.so_ground = False
    wire.line.advance(0.1)
    (line,) = scan(wire, full=full).lines
    assert "waiting for new firmware" in line
    assert wire.line.now < 2


def test_unsupported_baud_rates_are_skipped() -> None:
    wire = wire_of(create_board(settings=LineSettings(4800).to_wire()))
    wire.unsupported_rates = frozenset({14400, 76800})
    assert found_board(scan(wire)).settings.line == LineSettings(4800)


def test_port_loss_ends_scan() -> None:
    wire = wire_of(create_board())
    wire.fail = PortUnavailable("The port is lost.")
    assert isinstance(scan(wire).error, PortUnavailable)
    assert wire.closed


def test_scan_finds_board_on_noisy_line() -> None:
    wire = wire_of(create_board(settings=LineSettings(1200).to_wire()))
    wire.line.faults.noise = 0.02
    assert found_board(scan(wire)).settings.line.baud == 1200


class PolledWire(Wire):
    """Line on which another host requests the signature of board 7 before each read."""

    def read(self, size: int, seconds: float) -> bytes:
        self.line.send(b"\x80\x07\x01")
        return super().read(size, seconds)


def test_replies_to_another_host_find_no_further_boards() -> None:
    client = TrexClient(PolledWire(SimulatedBoards([create_board()])), VIRTUAL)
    found = boards_by_number(client, lambda _number: None, lambda: False)
    assert {board.device_number for board in found} <= {7}


# --- Sessions without a reply -----------------------------------------------------------


def moving_packets(line: SimulatedBoards, board: Board, packets: list[bytes]) -> list[str]:
    """Send packets with gaps. Return the packets that start a motor, even briefly."""
    moving = []
    for packet in packets:
        line.send(packet)
        driven = False
        while (event := line.next_event) is not None:
            line.advance_to(event)
            driven |= any(motor.target_direction.value != "brake" for motor in board.motors)
            driven |= board.aux.target_speed > 0
        if driven:
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
    harness = SessionHarness(Board())
    harness.line.faults.mute = True
    harness.run(settings)
    packets = [data for _, data in harness.transport.written]
    assert packets
    for own_detection in Detection:
        for own, host in permutations(baud_rates(), 2):
            board = create_board(settings=LineSettings(own, own_detection).to_wire())
            line = SimulatedBoards([board])
            line.host = LineSettings(host, detection)
            moving = moving_packets(line, board, packets)
            assert not moving, f"{host} to {own} baud, {own_detection.name}: {moving}"
            assert not board.memory.writes


def test_misread_packets_can_start_a_motor() -> None:
    """Without this danger, the test above would show nothing."""
    board = create_board()
    line = SimulatedBoards([board])
    line.host = LineSettings(38400)
    queries = [bytes.fromhex("80 07 04 50"), bytes.fromhex("80 07 05 59")]
    assert moving_packets(line, board, queries) == ["80 07 05 59"]
