"""Packets that the user typed."""

import pytest

from tests.devices.trex.session.helpers import (
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
from trex_gui.devices.trex.protocol.errors import ErrorCode, TrexError
from trex_gui.devices.trex.protocol.flags import UartError
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.devices.trex.protocol.raw_packets import packets_of
from trex_gui.devices.trex.session.messages import Connected, SendPacket


def packet(number: int, text: str) -> SendPacket:
    """Return the request to send these bytes, which are one packet."""
    (only,) = packets_of(bytes.fromhex(text), None)
    return SendPacket(number, only)


def code_of(error: object) -> object:
    assert isinstance(error, TrexError)
    return error.code


def test_reply_is_the_outcome_as_bytes(harness: SessionHarness) -> None:
    harness.script.at(1.0, packet(1, "81")).at(1.0, packet(2, "80 07 1F 07")).at(
        1.0, packet(3, "41")
    )
    harness.script.at(1.0, packet(4, "80 09 1F 07"))
    found = outcomes(run_for(harness, 3.0))
    assert found[1].value == b"TReX1.2"
    assert found[2].value == bytes(1)
    assert found[3].value == b""
    assert isinstance(found[4].error, NoReply), "there is no such board"


def test_packet_that_moves_is_sent_only_while_armed(harness: SessionHarness) -> None:
    harness.script.at(1.0, packet(1, "C2 50"))
    before = read_at(harness, 1.1, lambda: harness.board.motors[0].speed)
    harness.script.at(1.2, Arm()).at(1.2, packet(2, "C2 50"))
    schedule_heartbeats(harness, 1.2, 1.6)
    during = read_at(harness, 1.6, lambda: harness.board.motors[0].speed)
    harness.script.at(2.0, Stop(3)).at(2.0, packet(4, "C2 50"))
    harness.script.at(2.5, packet(5, "C2 50"))
    found = outcomes(run_for(harness, 4.0))
    assert (before, during) == ([0], [80])
    assert found[3].error is None
    for number in (1, 4, 5):
        assert isinstance(found[number].error, BadRequest)
    assert code_of(found[1].error) is ErrorCode.NOT_ARMED
    assert is_stopped(harness.board)


def test_packet_that_moves_is_stopped_by_a_missing_heartbeat(harness: SessionHarness) -> None:
    harness.script.at(1.0, Arm()).at(1.0, packet(1, "CA 50"))
    during = read_at(harness, 1.3, lambda: harness.board.motors[1].speed)
    run_for(harness, 3.0)
    assert during == [80]
    assert is_stopped(harness.board)


@pytest.mark.parametrize("text", ["C2 50", "80 09 42 50", "C2"])
def test_board_beyond_a_stop_is_not_moved(harness: SessionHarness, text: str) -> None:
    settings = ConnectionSettings("virtual", device_number=7)
    harness.script.at(1.0, Arm()).at(1.0, packet(1, text))
    found = outcomes(run_for(harness, 1.3, settings))
    assert code_of(found[1].error) is ErrorCode.MOVES_ANOTHER_BOARD


def test_bits_that_a_packet_clears_are_reported(harness: SessionHarness) -> None:
    harness.script.at(1.0, packet(1, "41 ")).at(1.0, packet(2, "85")).at(1.5, packet(3, "41"))
    harness.script.at(1.5, packet(4, "84"))
    seen = [sample.uart for sample in samples(run_for(harness, 3.0), LatchedStatus)]
    assert [UartError.FORMAT in bits for bits in seen].count(True) == 2


def test_board_is_read_again_after_a_packet_that_writes(harness: SessionHarness) -> None:
    harness.script.at(1.0, packet(1, "AF 07 0F 55 2A"))
    reports = run_for(harness, 3.0)
    assert outcomes(reports)[1].value == b"\0"
    assert of_type(reports, Connected)[-1].state.parameters["serial_timeout"] == 15
    assert not motor_commands_in(harness.transport.sent)


def test_board_is_found_where_a_packet_has_put_it(harness: SessionHarness) -> None:
    harness.script.at(1.0, packet(1, "AF 7E 0A 55 2A"))
    harness.script.at(2.0, harness.board.power_off).at(4.0, harness.board.power_on)
    reports = run_for(harness, 12.0)
    assert of_type(reports, Connected)[-1].settings.line == LineSettings(115200)


def test_write_without_a_reply_is_read_again(harness: SessionHarness) -> None:
    harness.script.at(1.0, harness.fault(to_drop=1))
    harness.script.at(1.0, packet(1, "AF 0E 0F 55 2A"))
    reports = run_for(harness, 6.0)
    assert isinstance(outcomes(reports)[1].error, NoReply)
    assert of_type(reports, Connected)[-1].state.parameters["motor1_acceleration"] == 15
