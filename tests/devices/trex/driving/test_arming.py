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
from trex_gui.core.timing import Timeouts
from trex_gui.devices.trex.driving.requests import (
    Arm,
    Heartbeat,
    MotorsStopped,
    SetAuxiliary,
    SetMotor,
    Stop,
)
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.errors import ErrorCode
from trex_gui.devices.trex.session.messages import Reload

STOP_BYTES = bytes.fromhex("D0 7F 7F")

HEARTBEAT = Timeouts().heartbeat


# --- The lock after a stop --------------------------------------------------------------


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
    run_for(stage, opening + 2.0, settings)
    sent = [moment for moment, data in stage.transport.written if data == STOP_BYTES]
    assert 0 <= sent[0] - pressed <= longest
    assert outcomes(stage.reports)[1].error is None
