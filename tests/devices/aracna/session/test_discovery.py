"""Search for a robot, alone or with a TReX, without motion."""

from collections.abc import Iterable, Sequence

import pytest

from tests.devices.trex.conftest import motor_commands
from tests.devices.trex.discovery.test_prober import ALL_LINES, BOARD_LINES, State, Wire, receive
from tests.devices.trex.simulator.ports import create_board
from tests.support.aracna import AracnaHarness
from tests.support.matrix import sampled
from trex_gui.core.discovery.prober import FLUSH_BYTE, FLUSH_LINE
from trex_gui.core.discovery.scan import PortScan, scan_port
from trex_gui.core.errors import BadRequest
from trex_gui.core.transport.serial_port import Transport
from trex_gui.core.transport.settings import PortSettings, SerialFormat
from trex_gui.devices.aracna.discovery import ARACNA_PROBER, PROBE, FoundRobot, recall
from trex_gui.devices.aracna.protocol.commands import EMPTY, QUERY
from trex_gui.devices.aracna.session.client import LINE
from trex_gui.devices.trex.discovery import TREX_PROBER, attempts
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.simulator.line import SimulatedBoards

VIRTUAL = ConnectionSettings("virtual")
TREX, ARACNA = {"trex": TREX_PROBER}, {"aracna": ARACNA_PROBER}

__all__ = ["motor_commands"]  # a fixture


def search(harness: AracnaHarness) -> PortScan:
    settings = ConnectionSettings("virtual", LineSettings(9600, Detection.ODD), device_number=9)
    return scan_port(settings, ARACNA, open_wire=lambda _settings: harness.transport)


def search_both(wire: Transport, first: str | None = None) -> PortScan:
    return scan_port(VIRTUAL, TREX | ARACNA, first=first, open_wire=lambda _settings: wire)


def unpowered() -> AracnaHarness:
    harness = AracnaHarness()
    harness.do("power off")
    return harness


def diagnosis(harness: AracnaHarness) -> str:
    [found] = search(harness).diagnoses
    return found.text


# --- Found devices --------------------------------------------------------------------------


def test_robot_is_found_at_its_only_line_setting() -> None:
    harness = AracnaHarness()
    start = harness.now
    result = search(harness)
    [found] = result.found
    assert isinstance(found, FoundRobot)
    assert found.settings == PortSettings("virtual", SerialFormat(38_400))
    assert (found.name, found.motors, found.device_number, found.echo) == (
        "Aracna 1",
        8,
        None,
        False,
    )
    assert harness.now - start < 0.6
    assert harness.transport.closed


def test_aracna_is_found_before_long_trex_search_and_answers_first_query() -> None:
    harness = AracnaHarness()
    start = harness.now
    result = search_both(harness.transport)
    assert (result.device, result.found[0].name) == ("aracna", "Aracna 1")
    assert harness.now - start < 3.0
    assert harness.transport.closed
    harness.line.host = LINE
    assert harness.request(b".q\n") == b".q1,8\r\n", "the line buffer is empty after the probes"


def test_trex_is_found_on_port_where_aracna_is_expected() -> None:
    wire = Wire(SimulatedBoards([create_board()]))
    assert search_both(wire, "aracna").device == "trex"


@pytest.mark.parametrize(
    ("ago", "keeps_last"), [(0.0, True), (0.2, False), (0.5, True), (0.9, False), (1.05, True)]
)
@pytest.mark.parametrize(("first", "seconds"), [(None, 3.0), ("aracna", 2.0)])
def test_aracna_reset_by_opening_port_is_found_after_boot(
    first: str | None, seconds: float, ago: float, *, keeps_last: bool
) -> None:
    harness = AracnaHarness(booted=False, keeps_last=keeps_last)
    harness.line.advance(ago)
    if ago:
        harness.line.receive()  # opening a port usually discards earlier bytes
    result = search_both(harness.transport, first)
    assert result.device == "aracna"
    assert ("reset the board" in result.found[0].note) == (ago == 0.0)
    assert harness.now < seconds
    assert harness.line.station.firmware.boots == 1, "no probe restarts the firmware"


def test_early_build_with_two_motors_is_found() -> None:
    [found] = search(AracnaHarness(motors=2, reports_motors=False)).found
    assert isinstance(found, FoundRobot)
    assert (found.name, found.motors) == ("Aracna 0", 2)


def test_known_robot_is_recalled_even_on_fixed_rate_port() -> None:
    harness = AracnaHarness()
    harness.transport.is_configurable = False
    found = recall(harness.transport, VIRTUAL, "")
    assert found is not None
    assert found.name == "Aracna 1"
    harness.do("power off")
    assert recall(harness.transport, VIRTUAL, "") is None


# --- Messages if nothing is found -------------------------------------------------------------


def test_silent_port_is_reported_for_both_devices() -> None:
    harness = unpowered()
    start = harness.now
    assert not search(harness).found
    assert harness.now - start < 3.0
    trex, aracna = search_both(harness.transport).lines
    assert trex.startswith("No TReX responds on virtual at any baud rate")
    assert aracna.startswith("No Aracna responds on virtual at 38400 baud")
    assert "wait until it stops: it does not listen while it moves" in aracna
    assert "power" in aracna


def test_booting_robot_without_reply_is_reported() -> None:
    harness = unpowered()
    harness.line.inject(b".h\r\n")
    assert "restarting repeatedly" in diagnosis(harness)


def test_noise_is_not_reported_as_echo() -> None:
    harness = unpowered()
    harness.line.inject(b"\xff\x00\xff")
    assert "not from an Aracna: FF 00 FF" in diagnosis(harness)


def test_echo_is_reported_for_both_devices() -> None:
    board = create_board()
    board.power_off()
    trex, aracna = search_both(Wire(SimulatedBoards([board], echo=True))).lines
    assert trex.startswith("No TReX responds on virtual: at every rate, everything sent comes back")
    assert "RS-232 side" in trex
    assert aracna.startswith("No Aracna responds on virtual at 38400 baud")
    assert "everything sent comes back" in aracna


def test_reply_to_aracna_probe_is_reported_first() -> None:
    """A moving robot replies after its motion, perhaps between probes for a TReX."""
    harness = unpowered()
    sent = 0
    write = harness.transport.write

    def reply_to_probe(data: bytes) -> None:
        nonlocal sent
        write(data)
        if data == PROBE:
            sent += 1
            harness.line.inject(b"ERR 7\r\n")

    harness.transport.write = reply_to_probe  # type: ignore[method-assign]
    aracna, trex = search_both(harness.transport).lines
    assert sent == 5
    assert "not from an Aracna" in aracna
    assert trex.startswith("No TReX responds")


def test_fixed_rate_port_is_probed_for_aracna_only_if_known() -> None:
    harness = AracnaHarness()
    harness.transport.is_configurable = False
    assert "--device aracna --port virtual" in diagnosis(harness)
    assert not harness.transport.sent
    harness.line.host = LINE
    harness.transport.reconfigure = lambda line: None  # type: ignore[method-assign]
    trex, aracna = search_both(harness.transport).lines
    assert "set at the other end" in trex
    assert "No probe for an Aracna was sent" in aracna
    assert search_both(harness.transport, "aracna").device == "aracna"


def test_port_without_rate_of_robot_is_reported_and_not_probed() -> None:
    harness = AracnaHarness()

    def reject(line: SerialFormat) -> None:
        if line == LINE:
            raise BadRequest("38400 baud is not supported")

    harness.transport.reconfigure = reject  # type: ignore[method-assign]
    assert "virtual cannot be set to 38400 baud" in diagnosis(harness)
    assert PROBE not in harness.transport.sent


# --- Motion ---------------------------------------------------------------------------------


@pytest.mark.parametrize("mute", [False, True])
def test_search_does_not_move_aracna(*, mute: bool) -> None:
    """The search may be for a TReX or for both devices."""
    harness = AracnaHarness(positions=tuple(range(100, 900, 100)))
    harness.line.faults.mute = mute
    wire = harness.transport
    for full in (False, True):
        assert not scan_port(VIRTUAL, TREX, full=full, open_wire=lambda _settings: wire).found
    for first in ("trex", "aracna"):
        harness.line.advance(5.0)
        harness.line.receive()
        wire.closed = False
        assert bool(search_both(wire, first).found) != mute
    harness.line.advance(5.0)
    assert not any(servo.torque for servo in harness.line.servos)
    assert harness.speeds == (0,) * 8


@pytest.mark.parametrize(
    "settings",
    sampled((each for each in ALL_LINES if each.stop_bits == 1), every=9),
    ids=lambda settings: settings.text(),
)
@pytest.mark.parametrize("first", ["trex", "aracna"])
def test_search_sends_no_command_that_trex_executes(
    settings: LineSettings, first: str, motor_commands: list[str]
) -> None:
    board = create_board(settings=settings.to_wire(), uart_error_shutdown=0)
    wire = Wire(SimulatedBoards([board]))
    assert search_both(wire, first).device == "trex"
    assert not motor_commands
    assert not board.memory.writes


INCOMPLETE_PACKETS: list[State] = [
    (first, *rest) for first in range(0x80, 0xF2) for rest in ((), (1,), (1, 2))
]


def executed_commands(
    probes: Sequence[tuple[bytes, SerialFormat]],
    own: LineSettings,
    states: Iterable[State],
    *,
    flushed: bool,
) -> set[str]:
    """Return every command that a board may execute, for any sequence of the probes.

    `states`: initial states of the board. Every device number and every checksum counts as valid.
    """
    executed: set[str] = set()
    for crc in (False, True) if own.detection is Detection.NONE else (False,):
        known = set(states)
        new = known
        while new:
            before, after = new, set()
            if flushed:
                before, commands = receive(before, FLUSH_BYTE, FLUSH_LINE, own, crc=crc)
                executed |= commands
            for probe, line in probes:
                reached, commands = receive(before, probe, line, own, crc=crc)
                executed |= commands
                after |= reached
            new = after - known
            known |= after
    return executed


def test_probe_and_session_query_cannot_form_trex_motor_command() -> None:
    """This applies to any device number, any polynomial, and any bytes before the probe."""
    for own in BOARD_LINES:
        states = [(), *INCOMPLETE_PACKETS]
        assert not executed_commands([(PROBE, LINE)], own, states, flushed=True), own.text()
        assert not executed_commands([(QUERY, LINE)], own, [()], flushed=False), own.text()


@pytest.mark.parametrize("own", sampled(BOARD_LINES, every=3), ids=lambda own: own.text())
def test_mixed_probes_cannot_form_motor_command(own: LineSettings) -> None:
    """This applies to any sequence of probes, any device number and any polynomial."""
    probes = [(each.data, each.line) for each in attempts() if each.line != own]
    assert not executed_commands([*probes, (PROBE, LINE)], own, [()], flushed=True)


@pytest.mark.parametrize("detection", [Detection.NONE, Detection.EVEN, Detection.ODD])
def test_trex_at_rate_of_robot_finds_no_command_in_probe(detection: Detection) -> None:
    own = LineSettings(LINE.baud, detection)
    assert receive([()], PROBE, LINE, own, crc=False) == ({()}, set())


def test_newlines_apart_from_queries_would_start_trex_motor() -> None:
    """The query is read as E1, and a newline as a data byte."""
    settings = LineSettings(LINE.baud, Detection.ODD)
    lines = [(EMPTY, LINE), (QUERY, LINE)]
    assert executed_commands(lines, settings, [()], flushed=False) == {"e1 0a 0a"}


def test_probe_without_flush_byte_would_start_trex_motor() -> None:
    """Without the flush byte, the tests above would fail."""
    settings = LineSettings(28800)
    assert "c5 05" in executed_commands([(PROBE, LINE)], settings, [()], flushed=False)


def test_probe_at_fixed_rate_would_start_trex_motor() -> None:
    """The flush byte has no effect at another rate."""
    probes = [(FLUSH_BYTE, LINE), (PROBE, LINE)]
    assert "c5 05" in executed_commands(probes, LineSettings(28800), [()], flushed=False)
