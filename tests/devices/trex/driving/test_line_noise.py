"""Motors that are released or stopped come to rest on a line that corrupts bytes."""

from itertools import product

import pytest

from tests.devices.trex.client.corruption import corrupt_packet
from tests.devices.trex.session.helpers import (
    commands,
    is_stopped,
    motor_commands_in,
    of_type,
    outcomes,
    read_at,
    run_for,
    samples,
    schedule_heartbeats,
)
from tests.soak.drives import LONGEST_TURN, drive
from tests.support.matrix import sampled
from tests.support.virtual import SessionHarness
from trex_gui.core.errors import NoReply
from trex_gui.core.simulator.sampling import ReceiveError
from trex_gui.core.timing import Timeouts
from trex_gui.devices.trex.client.telemetry import LatchedStatus
from trex_gui.devices.trex.driving.requests import (
    Arm,
    CommandsRepeated,
    MotorsStopped,
    SetAuxiliary,
    SetMotor,
    Stop,
)
from trex_gui.devices.trex.driving.setpoints import MAX_RETRY_SECONDS, LineQuality, SetpointRefresh
from trex_gui.devices.trex.protocol.commands import STOP, DriveAuxiliary, DriveMotor, GetRawChannels
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.flags import Status, UartError
from trex_gui.devices.trex.session.messages import NotResponding, SetWatched, Write
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.memory import Eeprom
from trex_gui.devices.trex.simulator.motors import MotorDirection

FULL_BRAKE = SetMotor(1, Drive.brake(127))
BRAKES = [DriveMotor(1, Drive.brake()), DriveMotor(2, Drive.brake())]


def turn_poll_into_command(harness: SessionHarness) -> None:
    """Corrupt 86 1F, which requests the channels, into C6 1F, which drives motor 1 forward."""
    corrupt_packet(harness, b"\x86\x1f", b"\xc6\x1f")


def is_braked(harness: SessionHarness) -> bool:
    return harness.board.motors[0].direction is MotorDirection.BRAKE


@pytest.mark.parametrize(
    ("seed", "noise"), sampled(product([13, 19, 40, 74, 93, 117], [0.01, 0.02, 0.05]), every=7)
)
def test_released_motor_stops_soon_on_noisy_line(
    harness: SessionHarness, noise: float, seed: int
) -> None:
    harness.line.faults._random.seed(seed)
    harness.script.at(1.0, Arm()).at(1.0, SetMotor(1, Drive.at(80)))
    harness.script.at(1.5, harness.fault(noise=noise)).at(1.6, FULL_BRAKE)
    seen: list[bool] = []
    for step in range(60):
        if step % 10 == 0:
            schedule_heartbeats(harness, 1.7 + step * 0.03, 1.7 + step * 0.03)
        harness.script.at(1.7 + step * 0.03, lambda: seen.append(is_braked(harness)))
    run_for(harness, 3.6)
    duration = longest = 0
    for braked in seen:
        duration = 0 if braked else duration + 1
        longest = max(longest, duration)
    assert longest * 0.03 < 0.25


def test_poll_corrupted_into_motor_command_is_undone_at_once(harness: SessionHarness) -> None:
    harness.script.at(1.0, Arm()).at(1.5, lambda: turn_poll_into_command(harness))
    schedule_heartbeats(harness, 1.5, 2.5)
    started: list[float] = []
    drive = harness.board.serial.drive

    def record(
        number: int, direction: MotorDirection, speed: int, *, accelerate: bool = False
    ) -> None:
        started.append(harness.line.now)
        drive(number, direction, speed, accelerate=accelerate)

    harness.board.serial.drive = record  # type: ignore[method-assign]
    braked = read_at(harness, 2.9, lambda: is_braked(harness))
    run_for(harness, 3.0)
    assert braked == [True]
    assert started[1] - started[0] < 0.06


def test_confirmed_setpoint_is_not_resent(harness: SessionHarness) -> None:
    harness.script.at(1.0, SetMotor(1, Drive.at(50))).at(2.0, SetMotor(1, Drive.brake(127)))
    run_for(harness, 4.0)
    sent = motor_commands_in(harness.transport.sent)
    assert sent.count(DriveMotor(1, Drive.at(50))) == 1, "a repetition bypasses the current limiter"
    assert sent.count(DriveMotor(1, Drive.brake(127))) == 2


def test_brake_is_repeated_until_line_is_quiet(harness: SessionHarness) -> None:
    harness.script.at(1.0, Arm()).at(1.0, SetMotor(1, Drive.at(50))).at(1.4, FULL_BRAKE)
    schedule_heartbeats(harness, 1.5, 2.8)
    harness.script.at(3.0, harness.fault(to_drop=1))
    schedule_heartbeats(harness, 3.0, 8.5)
    quiet, after = (
        read_at(harness, moment, lambda: len(harness.transport.sent)) for moment in (8.6, 8.8)
    )
    run_for(harness, 9.0)
    brake = DriveMotor(1, Drive.brake(127))
    sent = motor_commands_in(harness.transport.sent[: quiet[0]])
    assert 100 <= sent.count(brake) <= 300
    assert quiet[0] < after[0]
    assert not motor_commands_in(harness.transport.sent[quiet[0] : after[0]])


@pytest.mark.parametrize("requests", [(), (Stop(1),)])
def test_line_error_sends_no_command_to_undriven_board(
    harness: SessionHarness, requests: tuple[Stop, ...]
) -> None:
    for request in requests:
        harness.script.at(1.0, request)
    harness.script.at(2.0, lambda: harness.line.faults.errors.append(ReceiveError.FRAMING))
    before, after = (
        read_at(harness, moment, lambda: len(harness.transport.sent)) for moment in (2, 9)
    )
    run_for(harness, 9.1)
    assert UartError.FRAMING in samples(harness.reports, LatchedStatus)[0].uart
    assert not motor_commands_in(harness.transport.sent[before[0] : after[0]])
    assert not of_type(harness.reports, CommandsRepeated)


def test_line_error_brakes_stopped_board_until_line_is_quiet(harness: SessionHarness) -> None:
    harness.script.at(1.0, Arm()).at(1.0, SetMotor(1, Drive.at(50))).at(1.2, Stop(1))
    harness.script.at(1.5, SetWatched(False))  # polls end, so the line stays noisy
    harness.script.at(5.0, lambda: turn_poll_into_command(harness))
    braked = read_at(harness, 5.1, lambda: is_braked(harness))
    moments = (10.5, 12.5)
    quiet, after = (
        read_at(harness, moment, lambda: len(harness.transport.sent)) for moment in moments
    )
    run_for(harness, 12.6)
    assert braked == [True]
    assert 200 <= motor_commands_in(harness.transport.sent[: quiet[0]]).count(BRAKES[0]) <= 300
    assert not motor_commands_in(harness.transport.sent[quiet[0] : after[0]])
    assert of_type(harness.reports, CommandsRepeated) == [CommandsRepeated()]


def test_idle_refresh_skips_running_motor(harness: SessionHarness) -> None:
    harness.script.at(1.0, Arm()).at(1.0, SetMotor(2, Drive.at(50)))
    harness.script.at(1.2, harness.fault(to_drop=1))
    schedule_heartbeats(harness, 1.3, 3.8)
    speeds = read_at(harness, 3.9, lambda: harness.board.motors[1].speed)
    mark = read_at(harness, 3.9, lambda: len(harness.transport.sent))
    run_for(harness, 4.0)
    assert speeds == [50]
    sent = motor_commands_in(harness.transport.sent[: mark[0]])
    assert DriveMotor(1, Drive.brake()) in sent
    assert DriveMotor(2, Drive.brake()) not in sent


def test_stop_of_auxiliary_motor_is_repeated() -> None:
    idle = SetpointRefresh(LineQuality(), lambda: False)
    idle.record_setpoints([SetAuxiliary(50)], 0.0)
    assert idle.idle_commands() == BRAKES, "the auxiliary motor still runs"
    idle.record_stop(0.2, was_driven=True)
    assert idle.idle_commands() == [*BRAKES, DriveAuxiliary(0)]


def test_auxiliary_motor_without_setpoint_gets_no_command() -> None:
    idle = SetpointRefresh(LineQuality(), lambda: False)
    idle.record_setpoints([SetMotor(1, Drive.at(50))], 0.0)
    assert idle.idle_commands() == BRAKES[1:]


def test_speeds_are_held_back_until_a_clean_status() -> None:
    refresh = SetpointRefresh(LineQuality(), lambda: False)
    refresh.record_setpoints([SetMotor(1, Drive.at(50))], 0.0)
    fault = LatchedStatus(0.1, Status.MOTOR1_FAULT, UartError(0))
    refresh.record_status(fault, stops_on_error=False)
    assert refresh.speeds() == []
    refresh.record_status(LatchedStatus(0.2, Status(0), UartError(0)), stops_on_error=False)
    assert refresh.speeds() == [DriveMotor(1, Drive.at(50), accelerate=True)]


def test_risky_polls_are_omitted_while_motors_may_move(harness: SessionHarness) -> None:
    harness.script.at(1.0, Arm()).at(1.2, harness.fault(to_drop=1))
    before = read_at(harness, 1.3, lambda: len(harness.transport.sent))
    after = read_at(harness, 1.9, lambda: len(harness.transport.sent))
    run_for(harness, 2.0)
    kinds = {type(command) for command in commands(harness.transport.sent[before[0] : after[0]])}
    assert GetRawChannels not in kinds
    assert len(kinds) >= 4


# --- Stops ------------------------------------------------------------------------------


@pytest.mark.parametrize(("seed", "noise"), sampled(product(range(4), [0.01, 0.05]), every=7))
def test_stop_holds_on_noisy_line(harness: SessionHarness, noise: float, seed: int) -> None:
    harness.line.faults._random.seed(seed)
    harness.script.at(1.0, Arm()).at(1.0, SetMotor(1, Drive.at(80)))
    harness.script.at(1.5, harness.fault(noise=noise)).at(1.6, Stop(1))
    harness.script.at(3.0, harness.fault(noise=0.0))
    stopped = read_at(harness, 5.5, lambda: is_stopped(harness.board))
    run_for(harness, 5.6)
    assert stopped == [True]
    assert 1 in outcomes(harness.reports)


def test_stop_after_line_error_is_confirmed_on_quiet_line(harness: SessionHarness) -> None:
    harness.script.at(1.0, Arm()).at(1.0, SetMotor(1, Drive.at(80)))
    harness.script.at(1.4, harness.fault(to_drop=1)).at(1.5, Stop(1))
    early = read_at(harness, 2.0, lambda: outcomes(harness.reports))
    late = read_at(harness, 1.5 + Timeouts().stop_confirmation, lambda: outcomes(harness.reports))
    run_for(harness, 5.0)
    assert early == [{}], "a clean status alone confirms nothing on a noisy line"
    assert late[0][1].error is None
    assert of_type(harness.reports, MotorsStopped) == [MotorsStopped(None, confirmed=True)]
    assert motor_commands_in(harness.transport.sent).count(STOP[0]) > 4


def test_unconfirmed_stop_on_bad_line_is_reported(harness: SessionHarness) -> None:
    harness.script.at(1.0, Arm()).at(1.0, SetMotor(1, Drive.at(80)))
    for step in range(60):
        if step == 2:
            harness.script.at(1.5, Stop(1))
        harness.script.at(1.4 + step * 0.1, harness.fault(to_drop=1))
    run_for(harness, 7.5)
    error = outcomes(harness.reports)[1].error
    assert isinstance(error, NoReply)
    assert "corrupts bytes" in str(error)


def test_unconfirmed_stop_is_reported_when_driving_again(harness: SessionHarness) -> None:
    harness.script.at(1.4, harness.fault(to_drop=1)).at(1.5, Stop(1))
    harness.script.at(1.7, Arm()).at(1.7, SetMotor(1, Drive.at(30)))
    results = read_at(harness, 1.9, lambda: outcomes(harness.reports))
    speeds = read_at(harness, 1.9, lambda: harness.board.motors[0].speed)
    run_for(harness, 2.0)
    assert isinstance(results[0][1].error, NoReply)
    assert speeds == [30]


def test_stop_is_confirmed_when_board_responds_again(harness: SessionHarness) -> None:
    harness.script.at(1.0, Arm()).at(1.0, SetMotor(1, Drive.at(80)))
    harness.script.at(1.5, harness.fault(mute=True)).at(1.5, Stop(1))
    mark = read_at(harness, 1.5, lambda: len(harness.transport.sent))

    def unmute_after_failure() -> None:
        if 1 in outcomes(harness.reports):
            harness.line.faults.mute = False

    for hundredths in range(150, 250):
        harness.script.at(hundredths / 100, unmute_after_failure)
    harness.script.at(2.5, SetMotor(1, Drive.at(60)))
    run_for(harness, 5.5)
    assert isinstance(outcomes(harness.reports)[1].error, NoReply)
    assert not of_type(harness.reports, NotResponding)
    assert of_type(harness.reports, MotorsStopped) == [MotorsStopped(None, confirmed=True)]
    assert set(motor_commands_in(harness.transport.sent[mark[0] :])) <= {*STOP, *BRAKES}
    assert is_stopped(harness.board)


# --- Lasting setpoints ------------------------------------------------------------------


@pytest.mark.parametrize(
    ("status", "uart"),
    [
        (Status.MOTOR1_FAULT, UartError(0)),
        (Status.UART_ERROR, UartError.TIMEOUT),
        (Status.UART_ERROR, UartError.FRAMING),  # UART-Error Shutdown is on from the factory
    ],
)
def test_motor_stopped_by_board_is_not_restarted(
    harness: SessionHarness, status: Status, uart: UartError
) -> None:
    def stop_itself() -> None:
        harness.board.serial.status |= status
        harness.board.serial.uart_errors |= uart
        harness.board.serial.stop_motors()

    harness.script.at(1.0, SetMotor(1, Drive.at(50))).at(1.01, stop_itself)
    mark = read_at(harness, 1.01, lambda: len(harness.transport.sent))
    stopped = read_at(harness, 2.9, lambda: is_stopped(harness.board))
    run_for(harness, 3.0)
    assert stopped == [True]
    assert DriveMotor(1, Drive.at(50)) not in motor_commands_in(harness.transport.sent[mark[0] :])


def test_setpoint_is_resent_after_error_shutdown_is_turned_off(harness: SessionHarness) -> None:
    # UART-Error Shutdown is on from the factory.
    harness.script.at(1.0, Write(1, (("uart_error_shutdown", 0),)))
    # One packet loses its speed.
    harness.script.at(1.5, lambda: corrupt_packet(harness, b"\xc2\x32", b"\xc2"))
    harness.script.at(1.5, SetMotor(1, Drive.at(50)))
    speeds = read_at(harness, 1.9, lambda: harness.board.motors[0].speed)
    run_for(harness, 2.0)
    assert outcomes(harness.reports)[1].error is None
    assert speeds == [50]


def test_setpoint_repetition_ends_at_time_limit() -> None:
    eeprom = Eeprom("trex")
    eeprom.write("uart_error_shutdown", 0)
    harness = SessionHarness(Board(eeprom=eeprom))
    harness.script.at(1.0, Arm()).at(1.0, SetMotor(1, Drive.at(50)))

    def report_parity_error() -> None:
        harness.board.serial.report(UartError.PARITY, shut_down=False)

    for step in range(350):
        if step % 10 == 0:
            schedule_heartbeats(harness, 1.01 + step * 0.02, 1.01 + step * 0.02)
        harness.script.at(1.01 + step * 0.02, report_parity_error)
    limit = read_at(harness, 1.2 + MAX_RETRY_SECONDS, lambda: len(harness.transport.sent))
    run_for(harness, 8.9)
    setpoint = DriveMotor(1, Drive.at(50))
    assert motor_commands_in(harness.transport.sent[: limit[0]]).count(setpoint) > 10
    assert setpoint not in motor_commands_in(harness.transport.sent[limit[0] :])


# --- Arming and silence -----------------------------------------------------------------


def test_arming_during_power_loss_causes_no_later_stop(harness: SessionHarness) -> None:
    harness.script.at(1.0, harness.board.power_off).at(1.8, Arm()).at(3.5, harness.board.power_on)
    run_for(harness, 6.0)
    assert of_type(harness.reports, NotResponding)
    assert not of_type(harness.reports, MotorsStopped)
    assert not motor_commands_in(harness.transport.sent)


@pytest.mark.parametrize(
    ("seed", "shutdown"), sampled([(seed, bool(seed % 2)) for seed in range(30)], every=15)
)
def test_wrong_turn_is_short_and_not_taken_for_a_restart(seed: int, shutdown: bool) -> None:
    result = drive(seed, 5.0, shutdown=shutdown)
    assert max(result.turned, default=0.0) <= LONGEST_TURN
    assert result.stopped == []
