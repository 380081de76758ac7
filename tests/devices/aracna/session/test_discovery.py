"""Finding a robot, and moving nothing on the way: neither it nor a TReX that is there instead."""

from collections import deque
from collections.abc import Iterable

import pytest

from tests.devices.trex.conftest import orders
from tests.devices.trex.discovery.test_prober import OWN, State, hear
from tests.support.aracna import AracnaStage
from trex_gui.core.discovery.prober import FLUSH_BYTE, FLUSH_LINE
from trex_gui.core.discovery.scan import PortScan, scan_port
from trex_gui.core.transport.serial_port import Transport
from trex_gui.core.transport.settings import PortSettings, SerialFormat
from trex_gui.devices.aracna.discovery import ARACNA_PROBER, PROBE, FoundRobot
from trex_gui.devices.aracna.protocol.commands import QUERY
from trex_gui.devices.aracna.session.client import LINE
from trex_gui.devices.trex.discovery import TREX_PROBER
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings

VIRTUAL = ConnectionSettings("virtual", LineSettings(9600, Detection.ODD), device_number=9)

__all__ = ["orders"]  # a fixture


def search(stage: AracnaStage) -> PortScan:
    return search_at(stage.transport)


def search_at(wire: Transport) -> PortScan:
    return scan_port(VIRTUAL, {"aracna": ARACNA_PROBER}, open_wire=lambda _settings: wire)


def diagnosis(stage: AracnaStage) -> str:
    [found] = search(stage).diagnoses
    return found.text


# --- Aracna ---------------------------------------------------------------------------------


def test_robot_is_found_at_its_only_line_setting() -> None:
    stage = AracnaStage()
    begun = stage.now
    result = search(stage)
    [found] = result.found
    assert isinstance(found, FoundRobot)
    assert found.settings == PortSettings("virtual", SerialFormat(38_400))
    assert (found.name, found.motors, found.device_number, found.echo) == (
        "Aracna 1",
        8,
        None,
        False,
    )
    assert stage.now - begun < 0.6
    assert stage.transport.closed


@pytest.mark.parametrize("ago", [0.0, 0.2, 0.5, 0.9, 1.05])
@pytest.mark.parametrize("keeps_last", [True, False])
def test_robot_reset_by_opening_port_is_found_after_boot(ago: float, *, keeps_last: bool) -> None:
    stage = AracnaStage(booted=False, keeps_last=keeps_last)
    stage.line.advance(ago)
    if ago:
        stage.line.receive()  # opening a port commonly discards what came before
    [found] = search(stage).found
    assert ("has reset the board" in found.note) == (ago == 0.0)
    assert stage.now < 2.0
    assert stage.line.station.firmware.boots == 1


def test_early_build_with_two_motors_is_found() -> None:
    [found] = search(AracnaStage(motors=2, reports_motors=False)).found
    assert isinstance(found, FoundRobot)
    assert (found.name, found.motors) == ("Aracna 0", 2)


@pytest.mark.parametrize("full", [False, True])
@pytest.mark.parametrize("mute", [False, True])
def test_trex_search_does_not_move_robot(*, full: bool, mute: bool) -> None:
    stage = AracnaStage(positions=tuple(range(100, 900, 100)))
    stage.line.faults.mute = mute
    result = scan_port(
        ConnectionSettings("virtual"),
        {"trex": TREX_PROBER},
        full=full,
        open_wire=lambda _settings: stage.transport,
    )
    stage.line.advance(5.0)
    assert not result.found
    assert not any(servo.torque for servo in stage.line.servos)
    assert stage.speeds == (0,) * 8
    stage.line.faults.mute = False
    stage.line.receive()
    stage.transport.closed = False
    assert len(search(stage).found) == 1


# --- What else may be there -----------------------------------------------------------------


def test_silent_port_is_reported_with_hint_within_3_s() -> None:
    stage = AracnaStage()
    stage.do("power off")
    begun = stage.now
    result = search(stage)
    assert not result.found
    assert stage.now - begun < 3.0
    assert "No Aracna responds on virtual at 38400" in result.diagnoses[0].text
    assert "power" in result.diagnoses[0].text


def test_robot_that_boots_but_never_answers_is_reported() -> None:
    stage = AracnaStage()
    stage.do("power off")
    stage.line.inject(b".h\r\n")
    assert "restarting repeatedly" in diagnosis(stage)


def test_network_port_of_fixed_rate_is_not_probed() -> None:
    stage = AracnaStage()
    stage.transport.is_configurable = False
    result = search(stage)
    assert not stage.transport.sent
    assert "No probe for an Aracna was sent" in result.diagnoses[0].text
    assert "--device aracna --port virtual" in result.diagnoses[0].text


def test_noise_is_not_reported_as_echo() -> None:
    stage = AracnaStage()
    stage.do("power off")
    stage.line.inject(b"\xff\x00\xff")
    assert "not like an Aracna: FF 00 FF" in diagnosis(stage)


# --- A TReX ---------------------------------------------------------------------------------


def _orders_obeyed(
    begun: Iterable[State],
    questions: Iterable[bytes],
    own: LineSettings,
    *,
    crc: bool,
    rinsed: bool,
) -> set[str]:
    """Return every order that a board may obey, for these probes in any order and number.

    Takes every device number for the board's own and every checksum for the right one, so that
    it stands for all of both.
    """
    states = set(begun)
    waiting = deque(states)
    obeyed: set[str] = set()
    while waiting:
        before = {waiting.popleft()}
        if rinsed:
            before, first = hear(before, FLUSH_BYTE, FLUSH_LINE, own, crc=crc)
            obeyed |= first
        for question in questions:
            left, more = hear(before, question, LINE, own, crc=crc)
            obeyed |= more
            waiting.extend(left - states)
            states |= left
    return obeyed


BEGUN: list[State] = [(first, *rest) for first in range(0x80, 0xF2) for rest in ((), (1,), (1, 2))]


@pytest.mark.parametrize("own", OWN, ids=lambda own: own.text())
def test_probe_cannot_form_trex_motor_command(own: LineSettings) -> None:
    """For any device number, any polynomial, and whatever the board received before."""
    for crc in (False, True) if own.detection is Detection.NONE else (False,):
        assert not _orders_obeyed([(), *BEGUN], [PROBE], own, crc=crc, rinsed=True)


@pytest.mark.parametrize("own", OWN, ids=lambda own: own.text())
def test_session_query_cannot_form_trex_motor_command(own: LineSettings) -> None:
    for crc in (False, True) if own.detection is Detection.NONE else (False,):
        assert not _orders_obeyed([()], [QUERY], own, crc=crc, rinsed=False)


def test_probe_without_flush_byte_would_start_trex_motor() -> None:
    """Shows that the tests above can fail."""
    own = LineSettings(28800)
    assert "c5 05" in _orders_obeyed([()], [PROBE], own, crc=False, rinsed=False)


def test_probe_at_fixed_rate_would_start_trex_motor() -> None:
    """Why such ports are not probed: the flush byte has no effect at another rate."""
    own, host = LineSettings(28800), LINE
    begun: set[State] = {()}
    obeyed: set[str] = set()
    for question in (FLUSH_BYTE, PROBE) * 2:
        left, more = hear(begun, question, host, own, crc=False)
        begun |= left
        obeyed |= more
    assert "c5 05" in obeyed
