"""After a stop nothing drives for a while, and nothing does while nobody is there."""

import math

import pytest

from tests.devices.trex.session.helpers import (
    among,
    is_stopped,
    moving,
    outcomes,
    run_for,
    seen_at,
    staged,
)
from tests.support.matrix import sampled
from tests.support.virtual import Stage
from trex_gui.core.errors import BadRequest, NoReply
from trex_gui.core.session import Close, Closed, Outcome
from trex_gui.core.timing import Timeouts
from trex_gui.devices.trex.driving.requests import (
    HEARTBEAT_INTERVAL,
    Arm,
    Heartbeat,
    MotorsStopped,
    SetAuxiliary,
    SetMotor,
    Stop,
)
from trex_gui.devices.trex.protocol.commands import STOP, DriveMotor, GetMode
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.errors import ErrorCode
from trex_gui.devices.trex.session.messages import Reload, Report, RunCommand
from trex_gui.devices.trex.session.session import TrexSession

STOP_BYTES = bytes.fromhex("D0 7F 7F")

HEARTBEAT = Timeouts().heartbeat


def pulses(stage: Stage, start: float, end: float) -> None:
    """Plan the signs of life of a window between two moments."""
    for number in range(int((end - start) / HEARTBEAT_INTERVAL) + 1):
        stage.script.at(start + number * HEARTBEAT_INTERVAL, Heartbeat())


# --- The lock after a stop --------------------------------------------------------------


def test_setpoints_during_lockout_are_dropped(stage: Stage) -> None:
    stage.script.at(1.0, Stop(1, lockout=3.0))
    for step in range(20):
        stage.script.at(1.0 + step * 0.1, SetMotor(1, Drive.at(100)))
        stage.script.at(1.0 + step * 0.1, SetAuxiliary(100))
    run_for(stage, 3.5)
    assert moving(stage.transport.sent) == [*STOP, *STOP]
    assert is_stopped(stage.board)


@pytest.mark.parametrize("lockout", [0.0, 1.0, math.inf])
def test_setpoints_after_stop_are_dropped_until_armed(stage: Stage, lockout: float) -> None:
    stage.script.at(1.0, Arm()).at(1.0, SetMotor(1, Drive.at(80))).at(1.2, Stop(1, lockout))
    stage.script.at(1.2, SetMotor(1, Drive.at(80))).at(2.5, SetMotor(1, Drive.at(40)))
    dropped = seen_at(stage, 2.8, lambda: is_stopped(stage.board))
    stage.script.at(3.0, Arm()).at(3.0, SetMotor(1, Drive.at(50)))
    obeyed = seen_at(stage, 3.2, lambda: stage.board.motors[0].speed)
    run_for(stage, 3.5)
    assert dropped == [True], "it was on its way when the motors were stopped"
    assert obeyed == [50]


def test_arming_ends_lockout_of_earlier_stop(stage: Stage) -> None:
    stage.script.at(1.0, Stop(1, lockout=3.0)).at(1.2, Arm()).at(1.2, SetMotor(1, Drive.at(40)))
    speeds = seen_at(stage, 1.4, lambda: stage.board.motors[0].speed)
    run_for(stage, 1.5)
    assert speeds == [40]


def test_requested_motor_commands_are_rejected_in_lockout(stage: Stage) -> None:
    stage.script.at(1.0, RunCommand(1, GetMode())).at(
        1.0, RunCommand(2, DriveMotor(1, Drive.at(99)))
    )
    stage.script.at(1.0, Stop(3, lockout=1.0)).at(1.5, RunCommand(4, DriveMotor(1, Drive.at(99))))
    run_for(stage, 1.8)
    found = outcomes(stage.reports)
    assert isinstance(found[2].error, BadRequest), "overtaken by the stop"
    assert isinstance(found[4].error, BadRequest), "locked"
    assert found[1].error is None
    assert found[3].error is None
    assert DriveMotor(1, Drive.at(99)) not in moving(stage.transport.sent)


# --- Missing heartbeat ------------------------------------------------------------------


def test_armed_motors_stop_after_heartbeat_timeout(stage: Stage) -> None:
    stage.script.at(1.0, Arm()).at(1.0, SetMotor(1, Drive.at(80))).at(1.0, SetAuxiliary(30))
    before = seen_at(stage, 1.0 + HEARTBEAT - 0.05, lambda: stage.board.motors[0].speed)
    after = seen_at(stage, 1.0 + HEARTBEAT + 0.05, lambda: is_stopped(stage.board))
    stage.script.at(2.5, Heartbeat()).at(2.5, SetMotor(1, Drive.at(80)))  # what was late
    reports = run_for(stage, 3.0)
    assert before == [80]
    assert after == [True]
    (halted,) = among(reports, MotorsStopped)
    assert halted.confirmed
    assert halted.reason is ErrorCode.NO_HEARTBEAT
    assert is_stopped(stage.board), "late wishes count no more"


def test_heartbeats_keep_motors_running(stage: Stage) -> None:
    stage.script.at(1.0, Arm()).at(1.0, SetMotor(1, Drive.at(80)))
    pulses(stage, 1.0, 5.0)
    speeds = seen_at(stage, 5.2, lambda: stage.board.motors[0].speed)
    reports = run_for(stage, 5.3)
    assert speeds == [80]
    assert not among(reports, MotorsStopped)


def test_missing_heartbeat_is_ignored_if_never_armed(stage: Stage) -> None:
    reports = run_for(stage, 5.0)
    assert not among(reports, MotorsStopped)
    assert not moving(stage.transport.sent)


def test_heartbeat_timeout_stops_motors_during_reload() -> None:
    stage, settings = staged(1200)
    stage.script.at(4.0, Arm()).at(4.0, SetMotor(1, Drive.at(80))).at(4.5, Reload(1))
    after = seen_at(stage, 4.0 + HEARTBEAT + 0.5, lambda: is_stopped(stage.board))
    run_for(stage, 8.0, settings)
    assert after == [True]
    assert outcomes(stage.reports)[1].error is None


# --- Again and again --------------------------------------------------------------------


def test_stop_is_repeated_until_confirmed(stage: Stage) -> None:
    """A line that spoils what it carries to the board, but not what it brings back."""

    def corrupt(number: int) -> None:
        stage.line.faults.to_drop_sent = number

    stage.script.at(1.0, SetMotor(1, Drive.at(80)))
    for step in range(40):  # packets lose bytes, for two seconds
        stage.script.at(1.5 + step * 0.05, lambda: corrupt(2))
    stage.script.at(3.6, Stop(2))
    run_for(stage, 8.0)
    assert outcomes(stage.reports)[2].error is None
    assert is_stopped(stage.board)


def test_late_confirmation_of_failed_stop_is_reported(stage: Stage) -> None:
    def lose_our_ears() -> None:
        stage.line.faults.mute = True

    def hear_again_when_it_was_given_up(report: Report) -> None:
        stage.reports.append(report)
        if isinstance(report, Outcome):
            stage.line.faults.mute = False

    stage.script.at(1.0, SetMotor(1, Drive.at(80))).at(1.5, lose_our_ears).at(1.5, Stop(1))
    stage.script.at(5.0, Close())
    TrexSession(
        ConnectionSettings("virtual"),
        stage.script,
        hear_again_when_it_was_given_up,
        lambda _settings: stage.transport,
    ).run()
    assert isinstance(outcomes(stage.reports)[1].error, NoReply)
    assert among(stage.reports, MotorsStopped) == [MotorsStopped(None, confirmed=True)]
    assert stage.reports[-1] == Closed(None, may_move=False)
    assert is_stopped(stage.board)


# --- At most one transaction before it --------------------------------------------------


@pytest.mark.parametrize("baud", [1200, 19200, 115200])
@pytest.mark.parametrize("echo", [False, True])
@pytest.mark.parametrize("share", sampled([step / 12 for step in range(12)], every=7))
def test_stop_while_connecting_waits_for_one_transaction(
    baud: int, share: float, echo: bool
) -> None:
    """The probes for an echo, signature, mode, parameters, calibrations: all of opening."""
    opening = {1200: 3.0, 19200: 0.4, 115200: 0.2}[baud]
    stage, settings = staged(baud, echo=echo)
    longest = settings.line.seconds(16) + stage.transport.latency + 0.01
    pressed = 0.001 + share * opening
    stage.script.at(pressed, Stop(1))
    sent: list[float] = []
    write = stage.transport.write

    def note(data: bytes) -> None:
        if data == STOP_BYTES:
            sent.append(stage.line.now)
        write(data)

    stage.transport.write = note  # type: ignore[method-assign] # to see when
    run_for(stage, opening + 2.0, settings)
    assert 0 <= sent[0] - pressed <= longest
    assert outcomes(stage.reports)[1].error is None
