"""Selection of a board on a shared line, and motors of the boards."""

from dataclasses import replace

import pytest

from tests.devices.trex.session.helpers import (
    TwoBoards,
    error_code,
    motor_commands_in,
    of_type,
    outcomes,
    packet,
    read_at,
    run_for,
    samples,
)
from tests.devices.trex.simulator.ports import create_board
from tests.support.virtual import SessionHarness
from trex_gui.core.errors import BadReply, BadRequest, NoReply
from trex_gui.core.session import Closed
from trex_gui.devices.trex.client.telemetry import LatchedStatus
from trex_gui.devices.trex.driving.requests import Arm, MotorsStopped, SetMotor, Stop
from trex_gui.devices.trex.protocol.commands import (
    STOP,
    DriveMotor,
    GetStatus,
    GetUartErrors,
    Signature,
)
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.errors import ErrorCode, TrexError
from trex_gui.devices.trex.protocol.flags import UartError
from trex_gui.devices.trex.protocol.framing import Packet, PacketParser
from trex_gui.devices.trex.session.messages import (
    Batch,
    Connected,
    ProbeNumber,
    ReadReason,
    SelectBoard,
    SetReconnectCandidates,
    Write,
)
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.motors import MotorDirection

COMPACT = ConnectionSettings("virtual")
SEVENTH = replace(COMPACT, device_number=7)
FORWARD = SetMotor(1, Drive.at(90))


class Line(TwoBoards):
    @property
    def packets(self) -> list[Packet]:
        return of_type(PacketParser().feed(bytes(self.transport.sent)), Packet)

    def driven_numbers(self) -> set[int | None]:
        """Return the device numbers of motor commands, except stops."""
        driving = [packet for packet in self.packets if packet.command.moves]
        return {packet.device_number for packet in driving if packet.command not in STOP}

    def stopped_numbers(self) -> set[int | None]:
        """Return the device numbers of stops."""
        return {packet.device_number for packet in self.packets if packet.command in STOP}

    @property
    def connections(self) -> list[Connected]:
        return of_type(self.reports, Connected)


@pytest.fixture
def line() -> Line:
    return Line()


def runs_forward(board: Board) -> bool:
    return board.motors[0].direction is MotorDirection.FORWARD and board.motors[0].speed > 0


# --- Motors -----------------------------------------------------------------------------


def test_boards_that_reply_together_are_not_connected(line: Line) -> None:
    reports = run_for(line, 5, COMPACT)
    assert not line.connections
    (closed,) = of_type(reports, Closed)
    assert isinstance(closed.error, TrexError)
    assert closed.error.code is ErrorCode.SEVERAL_BOARDS


def test_driven_board_is_stopped_before_another_is_selected(line: Line) -> None:
    line.script.at(1.0, Arm()).at(1.0, FORWARD)
    before = read_at(line, 1.2, lambda: runs_forward(line.seventh))
    line.script.at(1.2, SelectBoard(1, 9))
    after = read_at(line, 3.0, lambda: runs_forward(line.seventh))
    reports = run_for(line, 3.0, SEVENTH)
    assert (before, after) == ([True], [False])
    assert outcomes(reports)[1].error is None
    assert MotorsStopped(None, confirmed=True) in reports
    selected = line.connections[-1]
    assert (selected.occasion, selected.settings.device_number) == (ReadReason.SELECTED, 9)
    assert not selected.may_move
    assert selected.state.parameters["device_number"] == 9
    assert reports[-1] == Closed(None, may_move=False)


def test_setpoints_for_former_board_reach_no_selected_board(line: Line) -> None:
    line.script.at(1.0, SelectBoard(1, 9))
    for step in range(30):  # from a window that still shows the former board
        line.script.at(1.0 + step / 100, Arm()).at(1.0 + step / 100, FORWARD)
    reports = run_for(line, 3.0, SEVENTH)
    assert outcomes(reports)[1].error is None
    assert line.driven_numbers() <= {7}
    assert not runs_forward(line.seventh)
    assert not runs_forward(line.ninth)


def test_typed_motor_command_after_selection_is_rejected(line: Line) -> None:
    line.script.at(0.9, Arm()).at(1.0, SelectBoard(1, 9))
    line.script.at(1.0, packet(2, DriveMotor(1, Drive.at(90))))
    reports = run_for(line, 3.0, SEVENTH)
    assert error_code(reports, 2) is ErrorCode.NOT_ARMED
    assert not motor_commands_in(line.transport.sent)


def test_board_stays_selected_until_its_stop_is_confirmed(line: Line) -> None:
    line.script.at(1.0, Arm()).at(1.0, FORWARD)
    line.script.at(1.2, line.seventh.power_off)
    line.script.at(1.2, SelectBoard(1, 9))
    reports = run_for(line, 4.0, SEVENTH)
    assert error_code(reports, 1) is ErrorCode.NOT_SELECTED_MOVING
    assert [connection.occasion for connection in line.connections] == [ReadReason.OPENED]
    assert reports[-1] == Closed(None, may_move=True)


def test_stop_after_selection_reaches_only_selected_board(line: Line) -> None:
    line.script.at(1.0, SelectBoard(1, 9))
    line.script.at(2.5, Arm(1)).at(2.5, FORWARD)
    before = read_at(line, 2.8, lambda: (runs_forward(line.seventh), runs_forward(line.ninth)))
    line.script.at(2.8, Stop(2))
    reports = run_for(line, 4.0, SEVENTH)
    assert before == [(False, True)]
    assert not runs_forward(line.ninth)
    assert outcomes(reports)[2].error is None
    assert line.driven_numbers() == {9}


def test_closing_and_guardian_stop_selected_board(line: Line) -> None:
    line.script.at(0.7, Arm()).at(0.7, FORWARD).at(1.0, SelectBoard(1, 9))
    before = read_at(line, 2.4, lambda: list(line.transport.guardian.watched))
    line.script.at(2.5, Arm(1)).at(2.5, FORWARD)
    reports = run_for(line, 2.8, SEVENTH)
    assert not runs_forward(line.ninth)
    assert reports[-1] == Closed(None, may_move=False)
    watched = line.transport.guardian.watched
    numbers = [sequence.packets[1] if sequence else None for sequence in watched]
    count = len(before[0])
    first, later = numbers[:count], numbers[count:]
    assert (set(first), first[-1]) == ({7, None}, None)
    assert (set(later), later[-1]) == ({9, None}, None)


def test_stop_during_selection_is_confirmed(line: Line) -> None:
    line.script.at(1.0, SelectBoard(1, 9)).at(1.2, Stop(2))
    reports = run_for(line, 4.0, SEVENTH)
    assert outcomes(reports)[2].error is None
    assert outcomes(reports)[1].error is None


def test_selection_stops_each_board_after_an_earlier_session(line: Line) -> None:
    line.ninth.power_off()
    line.script.at(1.0, line.ninth.power_on).at(2.0, SelectBoard(2, 9, sharing=(7, 9)))
    reports = run_for(line, 5.0, COMPACT, may_move=True)
    assert outcomes(reports)[2].error is None
    assert line.stopped_numbers() == {None, 7, 9}


def test_other_board_left_running_is_stopped(line: Line) -> None:
    line.ninth.serial.drive(1, MotorDirection.FORWARD, 90)
    reports = run_for(line, 2.0, SEVENTH, may_move=True)
    assert not runs_forward(line.ninth)
    assert reports[-1] == Closed(None, may_move=False)


def test_selection_stops_each_board_after_compact_commands(line: Line) -> None:
    line.ninth.power_off()
    line.script.at(1.0, Arm()).at(1.0, FORWARD).at(1.2, line.ninth.power_on)
    line.script.at(1.3, SetMotor(1, Drive.at(60)))  # reaches both boards
    both = read_at(line, 1.5, lambda: (runs_forward(line.seventh), runs_forward(line.ninth)))
    line.script.at(1.5, Stop(1)).at(2.0, SelectBoard(2, 9, sharing=(7, 9)))
    reports = run_for(line, 5.0, COMPACT)
    assert both == [(True, True)]
    assert outcomes(reports)[2].error is None
    assert line.stopped_numbers() == {None, 7, 9}


# --- Selection --------------------------------------------------------------------------


def test_board_that_does_not_respond_is_not_selected(line: Line) -> None:
    line.script.at(1.0, SelectBoard(1, 5))
    line.script.at(3.0, Arm()).at(3.0, FORWARD)
    before = read_at(line, 3.3, lambda: runs_forward(line.seventh))
    reports = run_for(line, 3.4, SEVENTH)
    assert isinstance(outcomes(reports)[1].error, NoReply)
    assert error_code(reports, 1) is ErrorCode.NOT_SELECTED_SILENT
    assert len(line.connections) == 1
    assert before == [True]  # the former board is still selected, and can be armed again
    assert of_type(reports, Batch)[-1].counters.missing == 0  # the line quality is not affected


def test_other_board_is_selected_while_selected_board_is_silent(line: Line) -> None:
    line.script.at(1.0, line.seventh.power_off).at(3.0, SelectBoard(1, 9))
    reports = run_for(line, 5.0, SEVENTH)
    assert outcomes(reports)[1].error is None
    assert line.connections[-1].settings.device_number == 9


def test_candidates_of_former_board_are_not_probed(line: Line) -> None:
    line.script.at(1.0, SetReconnectCandidates((replace(SEVENTH, polynomial=0x91),)))
    line.script.at(1.0, SelectBoard(1, 9)).at(3.0, line.ninth.power_off)
    run_for(line, 8.0, SEVENTH)
    assert [connection.settings.device_number for connection in line.connections] == [7, 9]


def test_latched_bits_of_other_board_are_reported_on_selection(line: Line) -> None:
    def latch() -> None:
        line.ninth.serial.uart_errors |= UartError.FORMAT

    line.script.at(1.0, latch).at(1.2, ProbeNumber(1, 9)).at(2.0, SelectBoard(2, 9))
    reports = run_for(line, 4.0, SEVENTH)
    selected = reports.index(line.connections[-1])
    assert not samples(reports[:selected], LatchedStatus)
    (latched,) = samples(reports[selected:], LatchedStatus)
    assert latched.uart == UartError.FORMAT


# --- Probing ----------------------------------------------------------------------------


def test_probe_returns_signature_and_clears_no_status(line: Line) -> None:
    line.script.at(1.0, ProbeNumber(1, 9)).at(1.5, ProbeNumber(2, 5))
    reports = run_for(line, 2.0, SEVENTH)
    signature = Signature(device_table().models[0], "1.2")
    assert outcomes(reports)[1].value == signature
    assert outcomes(reports)[2].value is None
    assert outcomes(reports)[2].error is None
    probes = [packet.command for packet in line.packets if packet.device_number in {5, 9}]
    assert probes
    assert not [command for command in probes if isinstance(command, GetStatus | GetUartErrors)]
    assert of_type(reports, Batch)[-1].counters.missing == 0


def test_probe_is_rejected_while_motors_are_armed(line: Line) -> None:
    line.script.at(1.0, Arm()).at(1.0, ProbeNumber(1, 9))
    reports = run_for(line, 1.5, SEVENTH)
    assert isinstance(outcomes(reports)[1].error, BadRequest)
    assert error_code(reports, 1) is ErrorCode.OTHERS_WHILE_DRIVING


def test_probe_of_a_number_that_two_boards_share_fails() -> None:
    harness = SessionHarness(create_board(7), create_board(9), create_board(9, model="trexjr"))
    harness.script.at(1.0, ProbeNumber(1, 9, attempts=2))
    reports = run_for(harness, 2.0, SEVENTH)
    assert isinstance(outcomes(reports)[1].error, BadReply)


@pytest.mark.parametrize("settings", [COMPACT, SEVENTH])
def test_number_of_another_board_is_not_written(line: Line, settings: ConnectionSettings) -> None:
    if settings is COMPACT:
        line.ninth.power_off()
        line.script.at(1.9, line.ninth.power_on)
    line.script.at(2.0, Write(1, (("device_number", 9), ("serial_timeout", 5))))
    line.script.at(4.0, line.ninth.power_off)
    line.script.at(4.5, Write(2, (("device_number", 12),)))
    reports = run_for(line, 6.0, settings)
    assert error_code(reports, 1) is ErrorCode.NUMBER_TAKEN
    assert line.seventh.eeprom["serial_timeout"] == 0
    assert outcomes(reports)[2].error is None
    assert line.seventh.eeprom["device_number"] == 12


def test_driven_board_keeps_its_number(line: Line) -> None:
    line.script.at(1.0, Arm()).at(1.0, FORWARD)
    line.script.at(1.2, Write(1, (("device_number", 12),)))
    reports = run_for(line, 3.0, SEVENTH)
    assert error_code(reports, 1) is ErrorCode.OTHERS_WHILE_DRIVING
    assert line.seventh.eeprom["device_number"] == 7
    assert not runs_forward(line.seventh)
