"""One search for a TReX and an Aracna: in one order, and moving neither, in whatever order."""

from collections import deque

import pytest

from tests.devices.trex.conftest import orders
from tests.devices.trex.discovery.test_prober import BOARDS, OWN, State, Wire, hear
from tests.devices.trex.simulator.ports import a_board
from tests.support.aracna import AracnaStage
from tests.support.matrix import sampled
from trex_gui.core.discovery.prober import FLUSH_BYTE, FLUSH_LINE
from trex_gui.core.discovery.scan import PortScan, scan_port
from trex_gui.core.transport.serial_port import Transport
from trex_gui.core.transport.settings import PortSettings, SerialFormat
from trex_gui.devices.aracna.discovery import ARACNA_PROBER, PROBE
from trex_gui.devices.aracna.session.client import LINE
from trex_gui.devices.trex.discovery import TREX_PROBER, attempts
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.simulator.line import TrexLine

VIRTUAL = ConnectionSettings("virtual")
PROBERS = {"trex": TREX_PROBER, "aracna": ARACNA_PROBER}

__all__ = ["orders"]  # a fixture


def search(wire: Transport, first: str | None = None) -> PortScan:
    return scan_port(VIRTUAL, PROBERS, first=first, open_wire=lambda _settings: wire)


# --- What is found, and how soon ------------------------------------------------------------


def test_aracna_is_found_before_long_trex_search() -> None:
    stage = AracnaStage()
    begun = stage.now
    result = search(stage.transport)
    assert (result.device, result.found[0].name) == ("aracna", "Aracna 1")
    assert stage.now - begun < 3.0
    assert stage.transport.closed


def test_trex_is_found_on_port_of_earlier_aracna() -> None:
    wire = Wire(TrexLine([a_board()]))
    assert search(wire, "aracna").device == "trex"


@pytest.mark.parametrize("ago", [0.0, 0.5, 0.9])
@pytest.mark.parametrize("first", [None, "aracna"])
def test_aracna_reset_by_opening_port_is_found(first: str | None, ago: float) -> None:
    stage = AracnaStage(booted=False)
    stage.line.advance(ago)
    if ago:
        stage.line.receive()
    result = search(stage.transport, first)
    assert result.device == "aracna"
    assert ("has reset the board" in result.found[0].note) == (ago == 0.0)
    assert stage.now < 3.0
    assert stage.line.station.firmware.boots == 1, "the port was opened once"


def test_found_aracna_answers_first_query() -> None:
    """The probes leave nothing in its line buffer."""
    stage = AracnaStage()
    search(stage.transport)
    stage.line.host = LINE
    assert stage.ask(b".q\n") == b".q1,8\r\n"


# --- Messages if nothing was found ------------------------------------------------------------


def test_silent_port_is_reported_for_both_devices() -> None:
    stage = AracnaStage()
    stage.do("power off")
    trex, aracna = search(stage.transport).lines
    assert trex.startswith("No TReX responds on virtual at any baud rate")
    assert aracna.startswith("No Aracna responds on virtual at 38400 baud")
    assert "does not listen while it moves" in aracna


def test_echo_is_reported_for_both_devices() -> None:
    board = a_board()
    board.power_off()
    trex, aracna = search(Wire(TrexLine([board], echo=True))).lines
    assert trex.startswith("No TReX responds on virtual: everything sent comes back")
    assert "RS-232 side" in trex
    assert aracna.startswith("No Aracna responds on virtual at 38400 baud")
    assert "everything sent comes back" in aracna


def test_reply_to_aracna_probe_is_reported_first() -> None:
    """A moving robot answers once it stops, which may be among the probes for a TReX."""
    stage = AracnaStage()
    stage.do("power off")
    sent = 0

    def hear_something(settings: PortSettings) -> Transport:
        write = stage.transport.write

        def writes(data: bytes) -> None:
            nonlocal sent
            write(data)
            if data == PROBE:
                sent += 1
                stage.line.inject(b"ERR 7\r\n")

        stage.transport.write = writes  # type: ignore[method-assign]
        return stage.transport

    aracna, trex = scan_port(VIRTUAL, PROBERS, open_wire=hear_something).lines
    assert sent == 5
    assert "not like an Aracna" in aracna
    assert trex.startswith("No TReX responds")


def test_fixed_rate_port_is_probed_for_aracna_only_if_known() -> None:
    stage = AracnaStage()
    stage.transport.is_configurable = False
    stage.line.host = LINE
    stage.transport.reconfigure = lambda line: None  # type: ignore[method-assign]
    trex, aracna = search(stage.transport).lines
    assert "set at the other end" in trex
    assert "No probe for an Aracna was sent" in aracna
    assert search(stage.transport, "aracna").device == "aracna"


# --- What moves -----------------------------------------------------------------------------


@pytest.mark.parametrize("first", ["trex", "aracna"])
@pytest.mark.parametrize("mute", [False, True])
def test_search_does_not_move_aracna(first: str, *, mute: bool) -> None:
    stage = AracnaStage(positions=tuple(range(100, 900, 100)))
    stage.line.faults.mute = mute
    result = search(stage.transport, first)
    assert bool(result.found) != mute
    stage.line.advance(5.0)
    assert not any(servo.torque for servo in stage.line.servos)
    assert stage.speeds == (0,) * 8


@pytest.mark.parametrize(
    "settings",
    sampled((each for each in BOARDS if each.stop_bits == 1), every=5),
    ids=lambda settings: settings.text(),
)
@pytest.mark.parametrize("first", ["trex", "aracna"])
def test_search_sends_no_command_that_trex_obeys(
    settings: LineSettings, first: str, orders: list[str]
) -> None:
    board = a_board(settings=settings.to_wire(), uart_error_shutdown=0)
    wire = Wire(TrexLine([board]))
    assert search(wire, first).device == "trex"
    assert not orders
    assert not board.memory.writes


@pytest.mark.parametrize("own", OWN, ids=lambda own: own.text())
def test_mixed_probes_cannot_form_motor_command(own: LineSettings) -> None:
    """For any order and number of probes, any device number and any polynomial."""
    for crc in (False, True) if own.detection is Detection.NONE else (False,):
        questions: list[tuple[bytes, SerialFormat]] = [
            (each.data, each.line) for each in attempts() if each.line != own
        ]
        questions.append((PROBE, LINE))
        begun: set[State] = {()}
        waiting = deque(begun)
        while waiting:
            rinsed, obeyed = hear({waiting.popleft()}, FLUSH_BYTE, FLUSH_LINE, own, crc=crc)
            for question, line in questions:
                left, more = hear(rinsed, question, line, own, crc=crc)
                obeyed |= more
                waiting.extend(left - begun)
                begun |= left
            assert not obeyed
