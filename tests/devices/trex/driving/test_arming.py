"""Motor output is locked after a stop and without heartbeats."""

from collections.abc import Callable

import pytest

from tests.devices.trex.session.helpers import (
    among,
    is_stopped,
    outcomes,
    packet,
    run_for,
    seen_at,
    staged,
)
from tests.support.matrix import sampled
from tests.support.virtual import Stage
from trex_gui.core.errors import PortUnavailable
from trex_gui.core.session import Close, Closed
from trex_gui.core.timing import Timeouts
from trex_gui.devices.trex.driving.requests import (
    Arm,
    Heartbeat,
    MotorsStopped,
    SetAuxiliary,
    SetMotor,
    Stop,
)
from trex_gui.devices.trex.protocol.commands import DriveMotor
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.errors import ErrorCode
from trex_gui.devices.trex.session.messages import NotResponding, Reload, Request
from trex_gui.devices.trex.session.session import TrexSession

STOP_BYTES = bytes.fromhex("D0 7F 7F")

HEARTBEAT = Timeouts().heartbeat


# --- The lock after a stop --------------------------------------------------------------


def test_setpoints_after_stop_are_dropped_until_armed(stage: Stage) -> None:
    stage.script.at(1.0, Arm()).at(1.0, SetMotor(1, Drive.at(80))).at(1.2, Stop(1))
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
    stage.script.at(2.5, Heartbeat()).at(2.5, SetMotor(1, Drive.at(80)))  # late requests
    reports = run_for(stage, 3.0)
    assert before == [80]
    assert after == [True]
    (halted,) = among(reports, MotorsStopped)
    assert halted.confirmed
    assert halted.reason is ErrorCode.NO_HEARTBEAT
    assert is_stopped(stage.board), "late wishes count no more"


def test_heartbeat_timeout_stops_motors_during_reload() -> None:
    stage, settings = staged(1200)
    stage.script.at(4.0, Arm()).at(4.0, SetMotor(1, Drive.at(80))).at(4.5, Reload(1))
    after = seen_at(stage, 4.0 + HEARTBEAT + 0.5, lambda: is_stopped(stage.board))
    run_for(stage, 8.0, settings)
    assert after == [True]
    assert outcomes(stage.reports)[1].error is None


# --- Repeated stops --------------------------------------------------------------------


def test_stop_is_repeated_until_confirmed(stage: Stage) -> None:
    """The line corrupts requests, but not replies."""
    stage.script.at(1.0, SetMotor(1, Drive.at(80)))
    for step in range(40):  # packets lose bytes for two seconds
        stage.script.at(1.5 + step * 0.05, stage.fault(to_drop_sent=2))
    stage.script.at(3.6, Stop(2))
    run_for(stage, 8.0)
    assert outcomes(stage.reports)[2].error is None
    assert is_stopped(stage.board)


# --- One transaction before a stop --------------------------------------------------


@pytest.mark.parametrize("baud", [1200, 19200, 115200])
@pytest.mark.parametrize("echo", [False, True])
@pytest.mark.parametrize("share", sampled([step / 12 for step in range(12)], every=7))
def test_stop_while_connecting_waits_for_one_transaction(
    baud: int, share: float, echo: bool
) -> None:
    """Covers all of opening: echo probes, signature, mode, parameters, calibrations."""
    opening = {1200: 3.0, 19200: 0.4, 115200: 0.2}[baud]
    stage, settings = staged(baud, echo=echo)
    longest = settings.line.seconds(16) + stage.transport.latency + 0.01
    pressed = 0.001 + share * opening
    stage.script.at(pressed, Stop(1))
    run_for(stage, opening + 1.0, settings)
    sent = [moment for moment, data in stage.transport.written if data == STOP_BYTES]
    assert 0 <= sent[0] - pressed <= longest
    assert outcomes(stage.reports)[1].error is None


# --- Stops during other events --------------------------------------------


Step = Callable[[], Request | None]


class Looks:
    """Inbox with scripted contents for each read, from one second on."""

    def __init__(self, stage: Stage, *steps: Step) -> None:
        self._stage = stage
        self._steps = list(steps)

    def get(self, seconds: float) -> Request | None:
        self._stage.line.advance(seconds)
        if self._stage.line.now < 1 or not self._steps:
            return None
        return self._steps.pop(0)()


def serve(stage: Stage, *steps: Step) -> None:
    inbox = Looks(stage, *steps)
    settings = ConnectionSettings("virtual")
    TrexSession(settings, inbox, stage.reports.append, lambda _: stage.transport).run()


def nothing() -> None:
    return None


def test_requested_motor_command_never_follows_stop(stage: Stage) -> None:
    """The stop may arrive before the command is sent, or later."""
    for looks in range(4):
        stage = staged()[0]
        serve(
            stage,
            Arm,
            lambda: packet(5, DriveMotor(1, Drive.at(100))),
            *([nothing] * looks),
            lambda: Stop(6),
            *([nothing] * 100),
            Close,
        )
        found = outcomes(stage.reports)
        assert found[6].error is None
        assert among(stage.reports, Closed) == [Closed(None, may_move=False)]
        assert is_stopped(stage.board)


def test_stops_during_confirmation_get_outcome_on_port_loss(stage: Stage) -> None:
    def mute() -> Request:
        stage.line.faults.mute = True
        return Stop(7)

    def pull() -> Request:
        stage.transport.fail = PortUnavailable("gone")
        return Stop(8)

    serve(stage, mute, nothing, pull)
    found = outcomes(stage.reports)
    assert set(found) == {7, 8}
    assert found[7].error is not None
    assert found[8].error is not None
    assert isinstance(stage.reports[-1], Closed)


@pytest.mark.parametrize("seconds", [0.02, 0.05, 7.0])
def test_stop_while_board_returns_gets_its_outcome(stage: Stage, seconds: float) -> None:
    """The board responds for some time after the stop. 7 s last until the test ends."""
    stage.script.at(1.0, Arm()).at(1.1, SetMotor(1, Drive.at(80)))
    for step in range(1, 8):
        stage.script.at(1.1 + step / 5, Heartbeat())
    stage.script.at(2.0, stage.fault(mute=True)).at(2.7, Stop(7))
    stage.script.at(2.75, stage.fault(mute=False))
    stage.script.at(2.75 + seconds, stage.fault(mute=True))
    seen = seen_at(stage, 10.0, lambda: 7 in outcomes(stage.reports))
    run_for(stage, 10.1)
    assert among(stage.reports, NotResponding)
    assert seen == [True]


@pytest.mark.parametrize("number", [None, 7])
def test_echo_of_our_own_requests_confirms_no_stop(stage: Stage, number: int | None) -> None:
    """The wires to the board come off and touch: the host receives its own bytes."""

    def short_circuit() -> None:
        stage.line.echo = True
        stage.line.faults.to_drop_sent = 10**9

    stage.script.at(1.0, Arm()).at(1.1, SetMotor(1, Drive.at(80))).at(1.5, short_circuit)
    stage.script.at(1.6, Stop(7))
    run_for(stage, 10.0, ConnectionSettings("virtual", device_number=number))
    assert outcomes(stage.reports)[7].error is not None
    (closed,) = among(stage.reports, Closed)
    assert closed.may_move
    assert not is_stopped(stage.board)
