"""Devices that are no TReX share the line: nothing reaches them that they could obey.

A qik obeys compact bytes from 81 on, and older Pololu controllers take `80 00 01 4C` for a speed of
motor 0 and FF for the start of a position: every packet has to begin with 80 and another number.
"""

from dataclasses import replace

import pytest

from tests.devices.trex.discovery.test_prober import Wire, wire_of
from tests.devices.trex.session.helpers import outcomes, run_for
from tests.devices.trex.simulator.ports import a_board
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
from trex_gui.devices.trex.protocol.errors import ErrorCode, TrexRequestError
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.session.messages import ProbeNumber, SetReconnectCandidates, Write
from trex_gui.devices.trex.simulator.firmware import Board

RESERVED = frozenset({0, 1, 9})
SHARED = ConnectionSettings("virtual", device_number=7, reserved=RESERVED)
CRC = replace(SHARED, line=LineSettings(detection=Detection.CRC7))


def addressed(sent: bytes | bytearray) -> set[int]:
    """Return the device numbers of the sent packets. Fail if any is compact."""
    first, *packets = bytes(sent).split(b"\x80")
    assert not first
    assert all(byte < 0x80 for packet in packets for byte in packet), bytes(sent).hex(" ")
    return {packet[0] for packet in packets}


class TunedHarness(SessionHarness):
    """A stage with a configurable line."""

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
    harness = TunedHarness(a_board(7, settings.line.to_wire(), serial_timeout=5), echo=echo)
    harness.script.at(1.5, Write(1, (("device_number", 9),)))
    harness.script.at(2.0, ProbeNumber(2, 9)).at(2.1, ProbeNumber(3, 0))
    harness.script.at(2.5, Arm()).at(2.6, SetMotor(1, Drive.at(90))).at(2.9, Stop(4))
    harness.script.at(3.0, SetReconnectCandidates((replace(settings, line=LineSettings(57600)),)))
    harness.script.at(3.5, harness.fault(mute=True)).at(6.5, harness.fault(mute=False))
    reports = run_for(harness, 9.0, settings)
    assert addressed(harness.wire.sent) == {7}
    assert {*harness.wire.tuned} == {settings.line}, "at no other rate"
    assert addressed(harness.client(settings).stop_sequence("TReX").packets) == {7}, (
        "by the guardian"
    )
    refused = outcomes(reports)[1].error
    assert isinstance(refused, TrexRequestError)
    assert refused.code is ErrorCode.NUMBER_TAKEN
    assert outcomes(reports)[2].value is None


@pytest.mark.parametrize("settings", [SHARED, CRC], ids=["plain", "CRC"])
def test_board_that_may_move_is_stopped_alone(settings: ConnectionSettings) -> None:
    harness = TunedHarness(a_board(7, settings.line.to_wire()))
    harness.script.at(2.0, Stop(1))
    assert outcomes(harness.run(settings, may_move=True))[1].error is None
    assert addressed(harness.transport.sent) == {7}


def test_failed_connection_is_followed_by_no_probes() -> None:
    harness = TunedHarness(a_board(8))
    run_for(harness, 30.0, CRC)
    assert addressed(harness.transport.sent) == {7}


def test_reserved_numbers_are_not_probed() -> None:
    wire = wire_of(a_board(7), a_board(9))
    wire.reconfigure(SHARED.line)
    found = boards_by_number(TrexClient(wire, SHARED), lambda _number: None, lambda: False)
    assert [board.device_number for board in found] == [7]
    assert addressed(wire.sent) == set(range(128)) - RESERVED


def search(wire: Wire, settings: ConnectionSettings) -> PortScan:
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
def test_search_sends_one_addressed_query(settings: ConnectionSettings, number: int) -> None:
    wire = wire_of(a_board(number, settings.line.to_wire()))
    found = [device.settings for device in search(wire, settings).found]
    assert addressed(wire.sent) == {7}
    assert found == ([settings] if number == 7 else [])


# --- The settings -----------------------------------------------------------------------


def test_reserved_numbers_are_packed_with_the_line_settings() -> None:
    for settings in (SHARED, replace(SHARED, reserved=frozenset())):
        assert ConnectionSettings("virtual").unpacked(settings.packed) == settings


@pytest.mark.parametrize("number", [None, 9])
def test_board_needs_a_number_of_its_own(number: int | None) -> None:
    with pytest.raises(BadRequest, match="a number that no other device has"):
        _ = replace(SHARED, device_number=number).framing
