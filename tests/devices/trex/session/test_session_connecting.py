"""Connections of a session, and errors of failed connections."""

import pytest

from tests.devices.trex.session.helpers import (
    create_harness,
    motor_commands_in,
    of_type,
    outcomes,
    packet,
    run_for,
)
from tests.support.matrix import sampled
from tests.support.virtual import SessionHarness, VirtualTransport
from trex_gui.core.errors import BadReply, BadRequest, NoReply, PortUnavailable
from trex_gui.core.session import Closed, Progress
from trex_gui.core.transport.serial_port import Transport
from trex_gui.devices.trex.driving.requests import SetMotor, Stop
from trex_gui.devices.trex.protocol.commands import GetMode
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.errors import BoardElsewhere
from trex_gui.devices.trex.protocol.flags import Mode
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.session.messages import (
    Batch,
    Connected,
    ReadReason,
    Reload,
    Report,
    Write,
)
from trex_gui.devices.trex.session.session import TrexSession
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.memory import Eeprom


def connection_of(harness: SessionHarness) -> Connected:
    """Return the only `Connected` report."""
    (report,) = of_type(harness.reports, Connected)
    return report


def test_connection_reports_state_of_board(harness: SessionHarness) -> None:
    harness.board.eeprom.write("serial_timeout", 15)
    reports = run_for(harness, 1.0)
    assert (reports[-1], harness.transport.closed) == (Closed(None), True)
    report = connection_of(harness)
    assert str(report.state.signature) == "TReX 1.2"
    assert report.state.mode is Mode.SERIAL_RC
    assert report.state.parameters == harness.board.memory.stored()
    assert report.state.parameters["serial_timeout"] == 15
    assert report.occasion is ReadReason.OPENED
    assert report.echo is False


def test_setpoint_before_board_is_read_is_sent(harness: SessionHarness) -> None:
    harness.script.at(0.0, SetMotor(1, Drive.at(30)))
    run_for(harness, 1.0)
    assert len(of_type(harness.reports, Connected)) == 1
    assert motor_commands_in(harness.transport.sent)


def test_echo_is_detected_with_device_number(board: Board) -> None:
    harness = SessionHarness(board, echo=True)
    run_for(harness, 1.0, ConnectionSettings("virtual", device_number=7))
    assert connection_of(harness).echo


# --- Failed connections -----------------------------------------------------------------


def failed_connection(
    harness: SessionHarness, settings: ConnectionSettings | None = None
) -> Closed:
    """Run a session that finds no board. Return its last report."""
    reports = run_for(harness, 30.0, settings)
    assert not of_type(reports, Connected)
    assert harness.transport.closed
    closed = reports[-1]
    assert isinstance(closed, Closed)
    return closed


def test_missing_board_is_reported_quickly(harness: SessionHarness) -> None:
    harness.board.power_off()
    harness.transport.latency = 0.06
    assert "No TReX responds" in str(failed_connection(harness).error)
    assert harness.line.now < 2.5


def test_board_at_other_line_settings_is_reported() -> None:
    harness, settings = create_harness(detection=Detection.EVEN)
    harness.line.host = LineSettings()
    error = failed_connection(harness).error
    assert isinstance(error, BoardElsewhere)
    assert error.settings == settings
    steps = of_type(harness.reports, Progress)
    assert "19200 baud, even parity, 1 stop bit" in [step.what for step in steps]


def test_close_ends_probes_without_error() -> None:
    harness, _ = create_harness(detection=Detection.ODD)
    harness.line.host = LineSettings()
    reports = run_for(harness, 0.4)
    steps = [step.what for step in of_type(reports, Progress)]
    assert "19200 baud, no error detection, 1 stop bit" in steps
    assert reports[-1] == Closed(None)
    assert harness.line.now < 0.6


def test_motors_left_running_are_stopped_without_probes() -> None:
    harness, _ = create_harness(detection=Detection.EVEN)
    harness.line.host = LineSettings()
    reports = run_for(harness, 30.0, may_move=True)
    closed = reports[-1]
    assert isinstance(closed, Closed)
    assert not isinstance(closed.error, BoardElsewhere)
    assert closed.may_move
    assert [step.what for step in of_type(reports, Progress)] == ["signature"]


def test_error_contains_port_name_instead_of_url(harness: SessionHarness) -> None:
    harness.board.power_off()
    error = failed_connection(
        harness, ConnectionSettings("/dev/pts/9", name="the simulated board")
    ).error
    assert "the simulated board" in str(error)
    assert "/dev/pts/9" not in str(error)


def test_echo_without_board_is_reported(board: Board) -> None:
    harness = SessionHarness(board, echo=True)
    board.power_off()
    error = failed_connection(harness).error
    assert isinstance(error, NoReply)
    for words in ("comes back", "RS-232", "TX and RX are joined"):
        assert words in str(error)


class TextTransport(VirtualTransport):
    """Transport of a device that sends text."""

    def read(self, size: int, seconds: float) -> bytes:
        self.wait(seconds)
        return (b"ERROR unknown command\r\n" * 9)[:size]


def test_unknown_device_is_reported(harness: SessionHarness) -> None:
    harness.transport = TextTransport(harness.line)
    error = failed_connection(harness).error
    assert isinstance(error, BadReply)
    for words in ("not like a TReX", "45 52 52 4F 52", "baud rate", "another device"):
        assert words in str(error)


# --- Lost bytes -------------------------------------------------------------------------


@pytest.mark.parametrize("echo", [False, True])
@pytest.mark.parametrize("count", [1, 7, 40])
def test_session_connects_although_first_bytes_are_lost(
    board: Board, count: int, *, echo: bool
) -> None:
    harness = SessionHarness(board, echo=echo)
    harness.line.faults.to_drop = count
    run_for(harness, 2.5)
    report = connection_of(harness)
    assert report.echo is echo
    assert report.state.parameters == board.memory.stored()
    assert report.state.unread == {}


@pytest.mark.parametrize("moment", sampled([number / 200 for number in range(30)], every=6))
def test_session_connects_although_bytes_are_lost_later(
    harness: SessionHarness, moment: float
) -> None:
    harness.script.at(moment, harness.fault(to_drop=40))
    run_for(harness, 2.5)
    report = connection_of(harness)
    assert report.state.parameters == harness.board.memory.stored()
    assert report.state.unread == {}
    assert harness.line.faults.to_drop == 0


def test_power_loss_while_reading_is_reported(harness: SessionHarness) -> None:
    harness.script.at(0.05, harness.board.power_off)
    error = failed_connection(harness).error
    assert isinstance(error, NoReply)
    assert of_type(harness.reports, Progress)


def test_close_while_reading_reports_no_error(harness: SessionHarness) -> None:
    reports = run_for(harness, 0.05)
    assert reports[-1] == Closed(None)
    assert not of_type(reports, Connected)
    assert harness.line.now < 0.1


def test_requests_fail_when_port_does_not_open() -> None:
    harness = SessionHarness(Board(eeprom=Eeprom()))
    reports: list[Report] = []
    error = PortUnavailable("There is no port /dev/ttyUSB9.")

    def fail_to_open(_settings: ConnectionSettings) -> Transport:
        raise error

    for request in (packet(1, GetMode()), Stop(2), Write(3), Reload(4)):
        harness.script.at(0.0, request)
    TrexSession(
        ConnectionSettings("/dev/ttyUSB9"), harness.script, reports.append, fail_to_open
    ).run()
    assert sorted(outcomes(reports)) == [1, 2, 3, 4]
    assert all(outcome.error is error for outcome in outcomes(reports).values())
    assert reports[-1] == Closed(error)


def test_requests_fail_when_no_board_is_found(harness: SessionHarness) -> None:
    harness.board.power_off()
    harness.script.at(0.0, packet(1, GetMode())).at(0.0, Write(3)).at(0.0, Reload(4))
    closed = failed_connection(harness)
    found = outcomes(harness.reports)
    assert sorted(found) == [1, 3, 4]
    assert all(outcome.error is closed.error for outcome in found.values())
    assert not of_type(harness.reports, Batch)


@pytest.mark.parametrize(
    "settings",
    [
        ConnectionSettings("x", device_number=300),
        ConnectionSettings("x", LineSettings(detection=Detection.CRC7), polynomial=3),
    ],
    ids=str,
)
def test_port_is_not_opened_with_invalid_settings(
    harness: SessionHarness, settings: ConnectionSettings
) -> None:
    def open_port(_settings: ConnectionSettings) -> Transport:
        pytest.fail("the port was opened")

    TrexSession(settings, harness.script, harness.reports.append, open_port).run()
    (closed,) = of_type(harness.reports, Closed)
    assert isinstance(closed.error, BadRequest)
