"""Setpoints and stops in a session."""

import itertools

import pytest

from tests.devices.trex.session.helpers import (
    commands,
    create_harness,
    is_stopped,
    motor_commands_in,
    of_type,
    outcomes,
    packet,
    read_at,
    run_for,
    samples,
)
from tests.support.matrix import sampled
from tests.support.virtual import SessionHarness
from trex_gui.core.session import Closed
from trex_gui.devices.trex.client.telemetry import Control
from trex_gui.devices.trex.driving.motor_driver import DRIVE_INTERVAL
from trex_gui.devices.trex.driving.requests import Arm, Heartbeat, SetAuxiliary, SetMotor, Stop
from trex_gui.devices.trex.driving.setpoints import REPEATS
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.commands import (
    STOP,
    DriveMotor,
    GetMode,
    GetSignature,
    GetStatus,
    SetCalibration,
    SetParameter,
)
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.line_settings import Detection
from trex_gui.devices.trex.session.messages import Connected, Reload, Request, Write
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.motors import MotorDirection

STOP_PACKET = bytes.fromhex("D0 7F 7F")
SETPOINTS, RATE = 1_500, 1000  # number of setpoints, and setpoints per second


# --- Driving ----------------------------------------------------------------------------


@pytest.mark.parametrize("baud", [1200, 19200, 115200])
def test_drag_sends_newest_setpoints_and_delivers_last_one(baud: int) -> None:
    harness, settings = create_harness(baud)
    start = 1.0 + 4.0 * 1200 / baud
    for number in range(SETPOINTS):
        harness.script.at(start + number / RATE, SetMotor(1, Drive.at(number % 128)))
    end = start + SETPOINTS / RATE
    delay = 0.3 if baud == 1200 else 0.04
    speeds = read_at(harness, end + delay, lambda: harness.board.motors[0].speed)
    run_for(harness, end + 0.4, settings)
    opcode = DriveMotor(1, Drive.at(1)).opcode
    sent = [(time, data[1]) for time, data in harness.transport.written if data[0] == opcode]
    assert speeds == [(SETPOINTS - 1) % 128]
    assert len(sent) <= SETPOINTS / RATE / DRIVE_INTERVAL + 1 + len(REPEATS)
    for time, speed in sent:
        newest = min(int((time - start) * RATE + 1e-6), SETPOINTS - 1)
        assert (newest - speed) % 128 <= 1, "an outdated setpoint was sent"


def test_driving_leaves_time_for_polling() -> None:
    harness, settings = create_harness(1200)
    for step in range(600):
        harness.script.at(5.0 + step / 200, SetMotor(1 + step % 2, Drive.at(step % 100)))
    run_for(harness, 8.0, settings)
    times = [sample.time for sample in samples(harness.reports, Control)]
    polls = [time for time in times if 5.0 < time < 8.0]
    assert len(polls) > 1
    assert max(later - sooner for sooner, later in itertools.pairwise(polls)) < 2.5


def test_setpoint_is_sent_during_reload() -> None:
    harness, settings = create_harness(1200)
    harness.script.at(4.0, Reload(1)).at(4.5, SetMotor(1, Drive.at(60)))
    speeds = read_at(harness, 4.8, lambda: harness.board.motors[0].speed)
    run_for(harness, 8.0, settings)
    assert speeds == [60]
    assert outcomes(harness.reports)[1].error is None


# --- Stop -------------------------------------------------------------------------------


def test_stop_is_confirmed_by_status_reply(harness: SessionHarness) -> None:
    harness.script.at(1.0, SetMotor(1, Drive.at(100))).at(1.0, SetAuxiliary(100))
    harness.script.at(1.5, Stop(1))
    stopped = read_at(harness, 1.52, lambda: is_stopped(harness.board))
    run_for(harness, 2.0)
    assert stopped == [True]
    assert outcomes(harness.reports)[1].error is None
    sent = commands(harness.transport.sent)
    first = sent.index(STOP[0])
    assert sent[first : first + 6] == [*STOP, GetStatus(), *STOP, GetStatus()]


@pytest.mark.parametrize(("baud", "limit"), [(1200, 0.35), (9600, 0.05), (115200, 0.01)])
def test_stop_is_sent_within_one_transaction(baud: int, limit: float) -> None:
    harness, settings = create_harness(baud)
    start = 4.5 if baud == 1200 else 0.5
    requested = [start + number * 1.017 for number in range(1, 5)]
    for number, time in enumerate(requested):
        harness.script.at(time - 0.5, SetMotor(1, Drive.at(50)))
        harness.script.at(time, Stop(number))
    run_for(harness, start + 4.5, settings)
    stops = [time for time, data in harness.transport.written if data == STOP_PACKET]
    for sent, time in zip(stops[: 2 * len(requested) : 2], requested, strict=True):
        assert 0 <= sent - time <= limit


def test_stop_overtakes_remaining_parameter_writes(harness: SessionHarness) -> None:
    keys = ("serial_timeout", "motor1_acceleration", "motor2_acceleration", "aux_acceleration")
    harness.script.at(1.0, SetMotor(1, Drive.at(100)))
    harness.script.at(1.1, Write(1, tuple((key, 9) for key in keys)))
    harness.script.at(1.19, Stop(2))
    run_for(harness, 2.0)
    sent = commands(harness.transport.sent)
    writes = [index for index, command in enumerate(sent) if isinstance(command, SetParameter)]
    stop = sent.index(STOP[0])
    assert writes[0] < stop < writes[-1]
    assert sent[stop : stop + 6] == [*STOP, GetStatus(), *STOP, GetStatus()]
    found = outcomes(harness.reports)
    assert list(found) == [2, 1]  # the write continues after the stop
    assert found[1].error is None
    assert all(harness.board.eeprom[key] == 9 for key in keys)


def test_stop_overtakes_remaining_calibration_writes(harness: SessionHarness) -> None:
    calibrations = tuple(
        (key, Calibration(2400, 3700, 5100, 80)) for key in CalibrationKey if "rc" in key
    )
    harness.script.at(1.1, Write(1, calibrations=calibrations)).at(1.2, Stop(2))
    run_for(harness, 2.0)
    sent = commands(harness.transport.sent)
    writes = [index for index, command in enumerate(sent) if isinstance(command, SetCalibration)]
    assert writes[0] < sent.index(STOP[0]) < writes[-1]
    assert list(outcomes(harness.reports)) == [2, 1]


def test_stop_overtakes_reload(harness: SessionHarness) -> None:
    harness.script.at(1.0, Reload(1)).at(1.05, Stop(2))
    run_for(harness, 2.0)
    found = outcomes(harness.reports)
    assert list(found) == [2, 1]
    assert found[1].error is None


def test_stop_overtakes_queued_requests(harness: SessionHarness) -> None:
    for number in range(1, 20):
        harness.script.at(1.0, packet(number, GetMode()))
    harness.script.at(1.0, Stop(20))
    run_for(harness, 2.0)
    assert next(iter(outcomes(harness.reports))) == 20


def test_simultaneous_stops_share_packets_and_get_outcomes(harness: SessionHarness) -> None:
    harness.script.at(1.0, Stop(1)).at(1.0, Stop(2)).at(1.0, Stop(3))
    run_for(harness, 2.0)
    assert sorted(outcomes(harness.reports)) == [1, 2, 3]
    assert motor_commands_in(harness.transport.sent) == [*STOP, *STOP]


def test_stop_in_rc_mode_is_confirmed() -> None:
    """The models warn that the channels drive the motors in this mode."""
    harness, settings = create_harness(mode="rc")
    harness.script.at(1.0, Stop(1))
    run_for(harness, 2.0, settings)
    assert outcomes(harness.reports)[1].error is None


@pytest.mark.parametrize("lost", [1, 5, 12])
def test_stop_with_lost_bytes_is_resent(harness: SessionHarness, lost: int) -> None:
    harness.script.at(1.0, SetMotor(1, Drive.at(100)))
    harness.script.at(1.5, harness.fault(to_drop_sent=lost)).at(1.5, Stop(1))
    stopped = read_at(harness, 1.7, lambda: harness.board.motors[0].speed == 127)
    run_for(harness, 2.0)
    assert stopped == [True]
    assert outcomes(harness.reports)[1].error is None


@pytest.mark.parametrize("seed", sampled(range(5), every=2))
def test_stop_succeeds_on_noisy_line_with_crc(seed: int) -> None:
    harness, settings = create_harness(detection=Detection.CRC7)
    harness.line.faults._random.seed(seed)
    harness.script.at(1.0, harness.fault(noise=0.05)).at(1.0, Stop(1))
    run_for(harness, 1.5, settings)
    assert outcomes(harness.reports)[1].error is None
    assert is_stopped(harness.board)


def test_stop_on_rs232_side_survives_corrupted_echo(board: Board) -> None:
    harness = SessionHarness(board, echo=True)
    harness.script.at(1.0, harness.fault(to_drop=2)).at(1.0, Stop(1))
    run_for(harness, 2.0)
    assert outcomes(harness.reports)[1].error is None
    assert is_stopped(board)


@pytest.mark.parametrize(
    "request_", [SetMotor(1, Drive.at(70)), packet(2, DriveMotor(1, Drive.at(70)))]
)
def test_stop_drops_motor_command_that_waits_for_a_late_reply(
    harness: SessionHarness, request_: Request
) -> None:
    harness.transport.latency = 0.5  # of a network, so the stop arrives during the wait
    harness.script.at(2.4, Arm()).at(2.5, harness.fault(mute=True))
    harness.script.at(2.9, Heartbeat()).at(2.9, request_)
    harness.script.at(3.1, Stop(1)).at(3.3, harness.fault(mute=False))
    run_for(harness, 4.0)
    assert DriveMotor(1, Drive.at(70)) not in motor_commands_in(harness.transport.sent)
    assert outcomes(harness.reports)[1].error is None


def test_stop_drops_setpoint_whose_echo_is_missing(board: Board) -> None:
    harness = SessionHarness(board, echo=True)
    harness.transport.latency = 0.5  # of a network, so the stop arrives during the wait
    harness.script.at(2.5, Arm()).at(2.5, harness.fault(mute=True))
    harness.script.at(2.5, SetMotor(1, Drive.at(70))).at(2.6, Stop(1))
    harness.script.at(3.2, harness.fault(mute=False))
    run_for(harness, 6.0)
    sent = motor_commands_in(harness.transport.sent)
    assert DriveMotor(1, Drive.at(70)) not in sent[sent.index(STOP[0]) :]


# --- Motors that may be moving ----------------------------------------------------------


def test_motors_left_running_are_stopped_before_reading(harness: SessionHarness) -> None:
    harness.board.serial.drive(1, MotorDirection.FORWARD, 100)
    reports = run_for(harness, 1.0, may_move=True)
    sent = commands(harness.transport.sent)
    assert sent.index(STOP[0]) < sent.index(GetSignature())
    assert is_stopped(harness.board)
    assert of_type(reports, Connected)[0].may_move is False


def test_silent_board_is_stopped_before_and_after_its_return(
    harness: SessionHarness,
) -> None:
    harness.script.at(1.0, SetMotor(1, Drive.at(100)))
    harness.script.at(1.5, harness.fault(mute=True)).at(3.0, harness.fault(mute=False))
    before = read_at(harness, 2.0, lambda: is_stopped(harness.board))
    after = read_at(harness, 4.0, lambda: is_stopped(harness.board))
    reports = run_for(harness, 4.0)
    assert before == after == [True]
    assert of_type(reports, Connected)[-1].may_move is False
    assert reports[-1] == Closed(None)


def test_confirmed_stop_is_not_repeated_on_close(harness: SessionHarness) -> None:
    harness.script.at(1.0, SetMotor(1, Drive.at(100))).at(1.2, Stop(1))
    reports = run_for(harness, 2.0)
    sent = motor_commands_in(harness.transport.sent)
    assert [command for command in sent if command in STOP] == [*STOP, *STOP]
    assert reports[-1] == Closed(None, may_move=False)


def test_unconfirmed_stop_on_close_is_reported(harness: SessionHarness) -> None:
    harness.script.at(1.0, SetMotor(1, Drive.at(100))).at(1.5, harness.fault(mute=True))
    assert run_for(harness, 1.5)[-1] == Closed(None, may_move=True)
    assert is_stopped(harness.board)


@pytest.mark.parametrize("lost", [1, 5, 11])
def test_stop_on_close_with_lost_bytes_is_resent(harness: SessionHarness, lost: int) -> None:
    harness.script.at(1.0, SetMotor(1, Drive.at(100))).at(1.5, harness.fault(to_drop_sent=lost))
    assert run_for(harness, 1.5)[-1] == Closed(None, may_move=False)
    assert is_stopped(harness.board)


def test_setpoint_with_corrupted_echo_is_resent(board: Board) -> None:
    harness = SessionHarness(board, echo=True)
    harness.script.at(1.0, harness.fault(to_drop=1)).at(1.0, SetMotor(1, Drive.at(50)))
    harness.script.at(2.0, packet(1, GetMode()))
    reports = run_for(harness, 3.0)
    sent = motor_commands_in(harness.transport.sent)
    assert sent.count(DriveMotor(1, Drive.at(50))) == 2
    assert outcomes(reports)[1].error is None
