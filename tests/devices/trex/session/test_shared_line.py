"""Lines that a TReX shares with other devices. No packet may be a command to another device.

A qik obeys compact bytes from 81 on. Older Pololu controllers read `80 00 01 4C` as a speed of
motor 0, and FF as the start of a position. So every packet must begin with 80 and the number of the
TReX.
"""

from dataclasses import replace

import pytest

from tests.devices.trex.discovery.test_prober import Wire, wire_of
from tests.devices.trex.session.helpers import error_code, outcomes, run_for
from tests.devices.trex.simulator.ports import create_board
from tests.support.virtual import SessionHarness
from trex_gui.core.discovery.scan import PortScan, scan_port
from trex_gui.core.errors import BadRequest
from trex_gui.core.transport.settings import PortSettings, SerialFormat
from trex_gui.devices.aracna.discovery import ARACNA_PROBER
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.discovery import TREX_PROBER, boards_by_number
from trex_gui.devices.trex.driving.requests import Arm, SetMotor, Stop
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.errors import ErrorCode
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.session.messages import ProbeNumber, SetReconnectCandidates, Write
from trex_gui.devices.trex.simulator.firmware import Board

RESERVED = frozenset({0, 1, 9})
SHARED = ConnectionSettings("virtual", device_number=7, reserved=RESERVED)
CRC = replace(SHARED, line=LineSettings(detection=Detection.CRC7))


def device_numbers(sent: bytes | bytearray) -> set[int]:
    """Return the device numbers of the sent packets. Fail if any is compact."""
    first, *packets = bytes(sent).split(b"\x80")
    assert not first
    assert all(byte < 0x80 for packet in packets for byte in packet), bytes(sent).hex(" ")
    return {packet[0] for packet in packets}


class SharedLineHarness(SessionHarness):
    """Harness with a configurable line."""

    def __init__(self, board: Board, *, echo: bool = False) -> None:
        super().__init__(board, echo=echo)
        self.transport = self.wire = Wire(self.line)
        self.line.host = SHARED.line


@pytest.mark.parametrize(
    ("settings", "echo"), [(SHARED, True), (CRC, False)], ids=["RS-232", "TTL with CRC"]
)
def test_session_addresses_one_board_in_every_packet(
    settings: ConnectionSettings, echo: bool
) -> None:
    harness = SharedLineHarness(
        create_board(7, settings.line.to_wire(), serial_timeout=5), echo=echo
    )
    harness.script.at(1.5, Write(1, (("device_number", 9),)))
    harness.script.at(2.0, ProbeNumber(2, 9)).at(2.1, ProbeNumber(3, 0))
    harness.script.at(2.5, Arm()).at(2.6, SetMotor(1, Drive.at(90))).at(2.9, Stop(4))
    harness.script.at(3.0, SetReconnectCandidates((replace(settings, line=LineSettings(57600)),)))
    harness.script.at(3.5, harness.fault(mute=True)).at(6.5, harness.fault(mute=False))
    reports = run_for(harness, 9.0, settings)
    assert device_numbers(harness.wire.sent) == {7}
    assert {*harness.wire.configured} == {settings.line}, "no other line settings"
    assert device_numbers(harness.client(settings).stop_sequence("TReX").packets) == {7}
    assert error_code(reports, 1) is ErrorCode.NUMBER_TAKEN
    assert outcomes(reports)[2].value is None


@pytest.mark.parametrize("settings", [SHARED, CRC], ids=["plain", "CRC"])
def test_stop_of_board_that_may_move_reaches_only_this_board(settings: ConnectionSettings) -> None:
    harness = SharedLineHarness(create_board(7, settings.line.to_wire()))
    harness.script.at(2.0, Stop(1))
    assert outcomes(harness.run(settings, may_move=True))[1].error is None
    assert device_numbers(harness.transport.sent) == {7}


def test_failed_connection_sends_only_addressed_packets() -> None:
    harness = SharedLineHarness(create_board(8))
    run_for(harness, 30.0, CRC)
    assert device_numbers(harness.transport.sent) == {7}


def test_reserved_numbers_are_not_probed() -> None:
    wire = wire_of(create_board(7), create_board(9))
    wire.reconfigure(SHARED.line)
    found = boards_by_number(TrexClient(wire, SHARED), lambda _number: None, lambda: False)
    assert [board.device_number for board in found] == [7]
    assert device_numbers(wire.sent) == set(range(128)) - RESERVED


def scan(wire: Wire, settings: ConnectionSettings) -> PortScan:
    return scan_port(
        PortSettings("virtual", SerialFormat(9600)),
        {"trex": TREX_PROBER, "aracna": ARACNA_PROBER},
        first="trex",
        packed=settings.packed,
        full=True,
        open_wire=lambda _settings: wire,
    )


@pytest.mark.parametrize("settings", [SHARED, CRC], ids=["plain", "CRC"])
@pytest.mark.parametrize("number", [7, 8])
def test_scan_sends_only_addressed_queries(settings: ConnectionSettings, number: int) -> None:
    wire = wire_of(create_board(number, settings.line.to_wire()))
    found = [device.settings for device in scan(wire, settings).found]
    assert device_numbers(wire.sent) == {7}
    assert found == ([settings] if number == 7 else [])


# --- Connection settings ----------------------------------------------------------------


def test_reserved_numbers_are_packed_with_the_line_settings() -> None:
    for settings in (SHARED, replace(SHARED, reserved=frozenset())):
        assert ConnectionSettings("virtual").unpacked(settings.packed) == settings


@pytest.mark.parametrize("number", [None, 9])
def test_board_on_shared_line_needs_a_unique_number(number: int | None) -> None:
    with pytest.raises(BadRequest, match="a device number that no other device on the line has"):
        _ = replace(SHARED, device_number=number).framing
