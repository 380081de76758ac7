"""Stops that come at the very moment at which something else is on its way."""

from collections.abc import Callable
from dataclasses import replace

import pytest

from tests.devices.trex.session.helpers import among, is_stopped, outcomes, staged
from tests.support.virtual import Stage
from trex_gui.core.errors import PortUnavailable
from trex_gui.core.session import Close, Closed
from trex_gui.devices.trex.driving.requests import Arm, Heartbeat, SetMotor, Stop
from trex_gui.devices.trex.protocol.commands import DriveMotor
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.session.messages import NotResponding, Request, RunCommand
from trex_gui.devices.trex.session.session import TrexSession

Step = Callable[[], Request | None]


class Looks:
    """An inbox that says what each look into it finds, from three seconds on."""

    def __init__(self, stage: Stage, *steps: Step) -> None:
        self._stage = stage
        self._steps = list(steps)

    def get(self, seconds: float) -> Request | None:
        self._stage.line.advance(seconds)
        if self._stage.line.now < 3 or not self._steps:
            return None
        return self._steps.pop(0)()


def serve(stage: Stage, *steps: Step) -> None:
    _, settings = staged()
    inbox = Looks(stage, *steps)
    TrexSession(settings, inbox, stage.reports.append, lambda _: stage.transport).run()


@pytest.fixture
def stage() -> Stage:
    return staged()[0]


def nothing() -> None:
    return None


def test_requested_motor_command_never_follows_stop(stage: Stage) -> None:
    """Whichever look finds the stop: the one before the command goes out, or a later one."""
    for looks in range(4):
        stage = staged()[0]
        serve(
            stage,
            lambda: RunCommand(5, DriveMotor(1, Drive.at(100))),
            *([nothing] * looks),
            lambda: Stop(6, 0.0),
            *([nothing] * 200),
            Close,
        )
        found = outcomes(stage.reports)
        assert found[6].error is None
        assert among(stage.reports, Closed) == [Closed(None, may_move=False)]
        assert is_stopped(stage.board)


def test_stops_during_confirmation_get_outcome_on_port_loss(
    stage: Stage,
) -> None:
    def mute() -> Request:
        stage.line.faults.mute = True
        return Stop(7, 0.0)

    def pull() -> Request:
        stage.transport.fail = PortUnavailable("gone")
        return Stop(8, 0.0)

    serve(stage, mute, nothing, pull)
    found = outcomes(stage.reports)
    assert set(found) == {7, 8}
    assert found[7].error is not None
    assert found[8].error is not None
    assert isinstance(stage.reports[-1], Closed)


@pytest.mark.parametrize("seconds", [0.02, 0.05, 11.0])
def test_stop_while_board_returns_gets_its_outcome(seconds: float) -> None:
    """The board responds for so long after the stop; 11 s is the rest of the test."""
    stage, settings = staged()
    seen: list[bool] = []
    faults = stage.line.faults
    stage.script.at(3.0, Arm()).at(3.1, SetMotor(1, Drive.at(80)))
    for step in range(1, 8):
        stage.script.at(3.1 + step / 5, Heartbeat())
    stage.script.at(4.0, lambda: setattr(faults, "mute", True)).at(4.7, Stop(7, 3.0))
    stage.script.at(4.75, lambda: setattr(faults, "mute", False))
    stage.script.at(4.75 + seconds, lambda: setattr(faults, "mute", True))
    stage.script.at(15.0, lambda: seen.append(7 in outcomes(stage.reports))).at(15.1, Close())
    stage.run(settings)
    assert among(stage.reports, NotResponding)
    assert seen == [True]


@pytest.mark.parametrize("number", [None, 7])
def test_echo_of_our_own_requests_confirms_no_stop(number: int | None) -> None:
    """The wires to the board come off and touch each other: the host receives what it sends."""
    stage, settings = staged()
    faults = stage.line.faults

    def short_circuit() -> None:
        stage.line.echo = True
        faults.to_drop_sent = 10**9

    stage.script.at(3.0, Arm()).at(3.1, SetMotor(1, Drive.at(80))).at(3.5, short_circuit)
    stage.script.at(3.6, Stop(7, 3.0)).at(12.0, Close())
    stage.run(replace(settings, device_number=number))
    assert outcomes(stage.reports)[7].error is not None
    (closed,) = among(stage.reports, Closed)
    assert closed.may_move
    assert not is_stopped(stage.board)
