"""Motor output is locked after a stop and without heartbeats."""

from collections.abc import Callable

import pytest

from tests.devices.trex.session.helpers import (
    create_harness,
    is_stopped,
    motor_commands_in,
    of_type,
    outcomes,
    packet,
    read_at,
    run_for,
)
from tests.support.matrix import sampled
from tests.support.virtual import SessionHarness
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
from trex_gui.devices.trex.protocol.commands import STOP, DriveMotor
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.errors import ErrorCode
from trex_gui.devices.trex.session.messages import NotResponding, Reload, Request
from trex_gui.devices.trex.session.session import TrexSession

STOP_BYTES = bytes.fromhex("D0 7F 7F")

HEARTBEAT = Timeouts().heartbeat

Step = Callable[[], Request | None]


# --- The lock after a stop --------------------------------------------------------------


def test_setpoints_after_stop_are_dropped_until_armed(harness: SessionHarness) -> None:
    harness.script.at(1.0, Arm()).at(1.0, SetMotor(1, Drive.at(80))).at(1.2, Stop(1))
    harness.script.at(1.2, SetMotor(1, Drive.at(80))).at(2.5, SetMotor(1, Drive.at(40)))
    dropped = read_at(harness, 2.8, lambda: is_stopped(harness.board))
    harness.script.at(3.0, Arm()).at(3.0, SetMotor(1, Drive.at(50)))
    speeds = read_at(harness, 3.2, lambda: harness.board.motors[0].speed)
    run_for(harness, 3.5)
    assert dropped == [True], "a setpoint after the stop has no effect"
    assert speeds == [50]


# --- Missing heartbeat ------------------------------------------------------------------


def test_armed_motors_stop_after_heartbeat_timeout(harness: SessionHarness) -> None:
    harness.script.at(1.0, Arm()).at(1.0, SetMotor(1, Drive.at(80))).at(1.0, SetAuxiliary(30))
    before = read_at(harness, 1.0 + HEARTBEAT - 0.05, lambda: harness.board.motors[0].speed)
    after = read_at(harness, 1.0 + HEARTBEAT + 0.05, lambda: is_stopped(harness.board))
    harness.script.at(2.5, Heartbeat()).at(2.5, SetMotor(1, Drive.at(90)))  # late requests
    reports = run_for(harness, 3.0)
    assert before == [80]
    assert after == [True]
    (stopped,) = of_type(reports, MotorsStopped)
    assert stopped.confirmed
    assert stopped.reason is ErrorCode.NO_HEARTBEAT
    late = DriveMotor(1, Drive.at(90))
    assert late not in motor_commands_in(harness.transport.sent), "late setpoints are ignored"


def test_heartbeat_timeout_stops_motors_during_reload() -> None:
    harness, settings = create_harness(1200)
    harness.script.at(4.0, Arm()).at(4.0, SetMotor(1, Drive.at(80))).at(4.5, Reload(1))
    after = read_at(harness, 4.0 + HEARTBEAT + 0.5, lambda: is_stopped(harness.board))
    run_for(harness, 8.0, settings)
    assert after == [True]
    assert outcomes(harness.reports)[1].error is None


# --- Repeated stops ---------------------------------------------------------------------


def test_stop_is_repeated_until_confirmed(harness: SessionHarness) -> None:
    """The line corrupts requests, but not replies."""
    harness.script.at(1.0, SetMotor(1, Drive.at(80)))
    for step in range(20):  # packets lose bytes for a second
        if step == 10:
            harness.script.at(2.0, Stop(2))
        harness.script.at(1.5 + step * 0.05, harness.fault(to_drop_sent=2))
    early = read_at(harness, 2.5, lambda: outcomes(harness.reports))
    stopped = read_at(harness, 7.9, lambda: is_stopped(harness.board))
    run_for(harness, 8.0)
    assert (early, stopped) == ([{}], [True])
    assert outcomes(harness.reports)[2].error is None
    assert motor_commands_in(harness.transport.sent).count(STOP[0]) > 4


# --- One transaction before a stop ------------------------------------------------------


@pytest.mark.parametrize("baud", [1200, 19200, 115200])
@pytest.mark.parametrize("echo", [False, True])
@pytest.mark.parametrize("share", sampled([step / 12 for step in range(12)], every=7))
def test_stop_while_connecting_waits_for_one_transaction(
    baud: int, share: float, echo: bool
) -> None:
    """Covers all of opening: echo probes, signature, mode, parameters, calibrations."""
    opening = {1200: 3.0, 19200: 0.4, 115200: 0.2}[baud]
    harness, settings = create_harness(baud, echo=echo)
    limit = settings.line.seconds(16) + harness.transport.latency + 0.01
    requested = 0.001 + share * opening
    harness.script.at(requested, Stop(1))
    run_for(harness, opening + 1.0, settings)
    sent_at = [moment for moment, data in harness.transport.written if data == STOP_BYTES]
    assert 0 <= sent_at[0] - requested <= limit
    assert outcomes(harness.reports)[1].error is None


# --- Stops during other events ----------------------------------------------------------


class DelayedInbox:
    """Inbox that returns one scripted request for each read after the first second."""

    def __init__(self, harness: SessionHarness, *steps: Step) -> None:
        self._harness = harness
        self._steps = list(steps)

    def get(self, seconds: float) -> Request | None:
        self._harness.line.advance(seconds)
        if self._harness.line.now < 1 or not self._steps:
            return None
        return self._steps.pop(0)()


def run_session(harness: SessionHarness, *steps: Step) -> None:
    inbox = DelayedInbox(harness, *steps)
    settings = ConnectionSettings("virtual")
    TrexSession(settings, inbox, harness.reports.append, lambda _: harness.transport).run()


def no_request() -> None:
    return None


def test_requested_motor_command_never_follows_stop() -> None:
    """The stop may arrive before the command is sent, or later."""
    for reads in range(4):
        harness = create_harness()[0]
        run_session(
            harness,
            Arm,
            lambda: packet(5, DriveMotor(1, Drive.at(100))),
            *([no_request] * reads),
            lambda: Stop(6),
            *([no_request] * 100),
            Close,
        )
        assert outcomes(harness.reports)[6].error is None
        assert of_type(harness.reports, Closed) == [Closed(None, may_move=False)]
        sent = motor_commands_in(harness.transport.sent)
        assert {*sent[sent.index(STOP[0]) :]} == {*STOP}


def test_stops_during_confirmation_get_outcome_on_port_loss(harness: SessionHarness) -> None:
    def mute() -> Request:
        harness.line.faults.mute = True
        return Stop(7)

    def pull() -> Request:
        harness.transport.fail = PortUnavailable("gone")
        return Stop(8)

    run_session(harness, mute, no_request, pull)
    results = outcomes(harness.reports)
    assert set(results) == {7, 8}
    assert all(outcome.error is not None for outcome in results.values())
    assert isinstance(harness.reports[-1], Closed)


@pytest.mark.parametrize("seconds", [0.02, 0.05, 7.0])
def test_stop_while_board_returns_gets_its_outcome(harness: SessionHarness, seconds: float) -> None:
    """The board responds for some seconds after the stop, or for 7 s until the test ends."""
    harness.script.at(1.0, Arm()).at(1.1, SetMotor(1, Drive.at(80)))
    for step in range(1, 8):
        harness.script.at(1.1 + step / 5, Heartbeat())
    harness.script.at(2.0, harness.fault(mute=True)).at(2.7, Stop(7))
    harness.script.at(2.75, harness.fault(mute=False))
    harness.script.at(2.75 + seconds, harness.fault(mute=True))
    has_outcome = read_at(harness, 10.0, lambda: 7 in outcomes(harness.reports))
    run_for(harness, 10.1)
    assert of_type(harness.reports, NotResponding)
    assert has_outcome == [True]


@pytest.mark.parametrize("number", [None, 7])
def test_echo_of_sent_requests_confirms_no_stop(
    harness: SessionHarness, number: int | None
) -> None:
    """The wires come off the board and touch. The host receives its own bytes."""

    def short_circuit() -> None:
        harness.line.echo = True
        harness.line.faults.to_drop_sent = 10**9

    harness.script.at(1.0, Arm()).at(1.1, SetMotor(1, Drive.at(80))).at(1.5, short_circuit)
    harness.script.at(1.6, Stop(7))
    run_for(harness, 10.0, ConnectionSettings("virtual", device_number=number))
    assert outcomes(harness.reports)[7].error is not None
    (closed,) = of_type(harness.reports, Closed)
    assert closed.may_move
    assert not is_stopped(harness.board)
