"""Packets that the user typed."""

import pytest

from tests.devices.trex.session.helpers import (
    error_code,
    is_stopped,
    motor_commands_in,
    of_type,
    outcomes,
    read_at,
    run_for,
    samples,
    schedule_heartbeats,
)
from tests.support.virtual import SessionHarness
from trex_gui.core.errors import BadRequest, NoReply
from trex_gui.devices.trex.client.telemetry import LatchedStatus
from trex_gui.devices.trex.driving.requests import Arm, Stop
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import ErrorCode
from trex_gui.devices.trex.protocol.flags import UartError
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.devices.trex.protocol.raw_packets import packets_of
from trex_gui.devices.trex.session.messages import Connected, SendPacket


def packet(number: int, text: str) -> SendPacket:
    """Return a request that sends a packet in hex."""
    (typed,) = packets_of(bytes.fromhex(text), None)
    return SendPacket(number, typed)


def test_outcome_of_typed_packet_contains_reply_bytes(harness: SessionHarness) -> None:
    harness.script.at(1.0, packet(1, "81")).at(1.0, packet(2, "80 07 1F 07")).at(
        1.0, packet(3, "41")
    )
    harness.script.at(1.0, packet(4, "80 09 1F 07"))  # no board has the number 9
    found = outcomes(run_for(harness, 3.0))
    assert found[1].value == b"TReX1.2"
    assert found[2].value == bytes(1)
    assert found[3].value == b""
    assert isinstance(found[4].error, NoReply)


def test_typed_motor_command_is_sent_only_while_armed(harness: SessionHarness) -> None:
    harness.script.at(1.0, packet(1, "C2 50"))
    before = read_at(harness, 1.1, lambda: harness.board.motors[0].speed)
    harness.script.at(1.2, Arm()).at(1.2, packet(2, "C2 50"))
    schedule_heartbeats(harness, 1.2, 1.6)
    during = read_at(harness, 1.6, lambda: harness.board.motors[0].speed)
    harness.script.at(2.0, Stop(3)).at(2.0, packet(4, "C2 50"))
    harness.script.at(2.5, packet(5, "C2 50"))
    reports = run_for(harness, 4.0)
    found = outcomes(reports)
    assert (before, during) == ([0], [80])
    assert found[3].error is None
    for number in (1, 4, 5):
        assert isinstance(found[number].error, BadRequest)
    assert error_code(reports, 1) is ErrorCode.NOT_ARMED
    assert is_stopped(harness.board)


def test_missing_heartbeat_stops_typed_motor_command(harness: SessionHarness) -> None:
    harness.script.at(1.0, Arm()).at(1.0, packet(1, "CA 50"))
    during = read_at(harness, 1.3, lambda: harness.board.motors[1].speed)
    stopped = read_at(harness, 2.0, lambda: is_stopped(harness.board))
    run_for(harness, 3.0)
    assert (during, stopped) == ([80], [True])


def test_close_stops_typed_motor_command(harness: SessionHarness) -> None:
    harness.script.at(1.0, Arm()).at(1.0, packet(1, "C2 50"))
    run_for(harness, 1.3)
    assert is_stopped(harness.board)


def test_line_error_does_not_brake_typed_motor_command(harness: SessionHarness) -> None:
    harness.script.at(1.0, Arm()).at(1.1, harness.fault(to_drop=1)).at(1.3, packet(1, "C2 50"))
    schedule_heartbeats(harness, 1.4, 1.6)
    speeds = read_at(harness, 1.7, lambda: harness.board.motors[0].speed)
    harness.script.at(1.7, Stop(2))
    run_for(harness, 4.5)
    assert speeds == [80]
    assert outcomes(harness.reports)[2].error is None


@pytest.mark.parametrize("text", ["C2 50", "80 09 42 50", "C2"])
def test_motor_command_for_another_board_is_rejected(harness: SessionHarness, text: str) -> None:
    settings = ConnectionSettings("virtual", device_number=7)
    harness.script.at(1.0, Arm()).at(1.0, packet(1, text))
    assert error_code(run_for(harness, 1.3, settings), 1) is ErrorCode.MOVES_ANOTHER_BOARD


def test_bits_cleared_by_typed_packet_are_reported(harness: SessionHarness) -> None:
    harness.script.at(1.0, packet(1, "41")).at(1.0, packet(2, "85")).at(1.5, packet(3, "41"))
    harness.script.at(1.5, packet(4, "84"))
    latched = samples(run_for(harness, 3.0), LatchedStatus)
    assert [UartError.FORMAT in sample.uart for sample in latched].count(True) == 2


def test_uart_errors_are_read_after_lost_reply_to_typed_packet(harness: SessionHarness) -> None:
    harness.script.at(1.0, lambda: harness.board.report_error(UartError.PARITY))
    harness.script.at(1.0, harness.fault(to_drop=1)).at(1.0, packet(1, "84"))
    latched = samples(run_for(harness, 2.0), LatchedStatus)
    assert [sample.uart for sample in latched] == [UartError.PARITY]


@pytest.mark.parametrize("lost", [0, 1])
def test_typed_write_reads_board_again(harness: SessionHarness, lost: int) -> None:
    harness.script.at(1.0, harness.fault(to_drop=lost)).at(1.0, packet(1, "AF 07 0F 55 2A"))
    reports = run_for(harness, 6.0)
    assert outcomes(reports)[1].value == (None if lost else b"\0")
    assert isinstance(outcomes(reports)[1].error, NoReply) is bool(lost)
    assert of_type(reports, Connected)[-1].state.parameters["serial_timeout"] == 15
    assert not motor_commands_in(harness.transport.sent)


def test_board_reconnects_at_line_settings_of_typed_packet(harness: SessionHarness) -> None:
    harness.script.at(1.0, packet(1, "AF 7E 0A 55 2A"))
    harness.script.at(2.0, harness.board.power_off).at(4.0, harness.board.power_on)
    reports = run_for(harness, 12.0)
    assert of_type(reports, Connected)[-1].settings.line == LineSettings(115200)
