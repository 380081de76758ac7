"""A session in its thread, with a robot at its real pace."""

import sys
from collections.abc import Iterator
from typing import TypeVar

import pytest
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice, StartSimulator
from trex_gui.core.discovery.scan import scan_port
from trex_gui.core.errors import PortUnavailable
from trex_gui.core.session import Closed, Outcome
from trex_gui.core.timing import Timeouts
from trex_gui.core.transport.settings import PortSettings
from trex_gui.devices.aracna.discovery import ARACNA_PROBER
from trex_gui.devices.aracna.protocol.joints import travel_seconds
from trex_gui.devices.aracna.session.messages import (
    Connected,
    Ending,
    Halt,
    Move,
    Moved,
    Moving,
    Passed,
    Play,
    PlayEnded,
    Restarted,
    SetSpeeds,
    SpeedsHeld,
    Step,
    StepBegun,
    Stuck,
)
from trex_gui.devices.aracna.session.session import AracnaSession
from trex_gui.ui.runtime import open_transport
from trex_gui.ui.workers.session_thread import LineWorker

KindT = TypeVar("KindT")

HERE = (512,) * 8
THERE = (700,) * 8
SLOW = (100,) * 8
CREEPING = (20,) * 8


class SessionRunner:
    """Runs a session in a thread and records its reports."""

    def __init__(self, url: str, qtbot: QtBot) -> None:
        self._qtbot = qtbot
        self.reports: list[object] = []
        settings = PortSettings(url, timeouts=Timeouts(extra=3.0))
        self.worker = LineWorker(
            lambda inbox, notify: AracnaSession(settings, inbox, notify, open_transport)
        )
        self.worker.reported.connect(self.reports.append)
        self.worker.start()

    def of(self, kind: type[KindT]) -> list[KindT]:
        return [report for report in self.reports if isinstance(report, kind)]

    def wait(self, kind: type[KindT], count: int = 1, seconds: float = 15.0) -> KindT:
        """Wait for the nth report of a kind."""
        self._qtbot.waitUntil(lambda: len(self.of(kind)) >= count, timeout=int(seconds * 1000))
        return self.of(kind)[count - 1]

    def do(self, *requests: object) -> None:
        for request in requests:
            self.worker.submit(request)


@pytest.fixture
def robot(start_simulator: StartSimulator) -> SimulatedDevice:
    return start_simulator("--aracna")


@pytest.fixture
def session(robot: SimulatedDevice, qtbot: QtBot) -> Iterator[SessionRunner]:
    session = SessionRunner(robot.url, qtbot)
    yield session
    assert session.worker.close(15_000)
    qtbot.waitUntil(lambda: bool(session.of(Closed)), timeout=15_000)
    assert session.reports[-1] == session.of(Closed)[0]


@pytest.mark.realtime
@pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")
def test_just_started_robot_is_found_and_connected(robot: SimulatedDevice, qtbot: QtBot) -> None:
    settings = PortSettings(robot.url, timeouts=Timeouts(extra=0.2))
    [found] = scan_port(settings, {"aracna": ARACNA_PROBER}).found
    assert found.name == "Aracna 1"
    session = SessionRunner(robot.url, qtbot)
    assert session.wait(Connected).motors == 8
    assert session.worker.close(15_000)


def test_move_takes_calculated_time(session: SessionRunner) -> None:
    session.wait(Connected)
    session.do(SetSpeeds(1, SLOW), Move(2, THERE))
    moved = session.wait(Moved)
    assert all(abs(position - 700) <= 2 for position in moved.present)
    assert moved.seconds == pytest.approx(travel_seconds(188, 100), abs=0.1)
    assert len(session.of(Passed)) >= 1
    assert all(outcome.error is None for outcome in session.of(Outcome))


def _restart_is_survived(session: SessionRunner, robot: SimulatedDevice) -> None:
    robot.do("reset")
    session.wait(Restarted)
    assert session.wait(Connected, 2).restarted
    session.do(Move(99, HERE))
    session._qtbot.waitUntil(
        lambda: any(one.id == 99 for one in session.of(Outcome)), timeout=15000
    )
    [outcome] = [one for one in session.of(Outcome) if one.id == 99]
    assert outcome.error is None
    # Of a line that was on its way three bytes may be left, which restart the board once more.
    assert robot.show()["boots"] in {2, 3}


def test_session_survives_restart_while_idle(
    session: SessionRunner, robot: SimulatedDevice
) -> None:
    session.wait(Connected)
    _restart_is_survived(session, robot)


def test_session_survives_restart_among_queued_moves(
    session: SessionRunner, robot: SimulatedDevice
) -> None:
    session.wait(Connected)
    session.do(*(Move(number, HERE, (500 + number % 2,) * 8) for number in range(60)))
    session.wait(SpeedsHeld, 2)
    _restart_is_survived(session, robot)
    assert any("restarted" in str(one.error) for one in session.of(Outcome))


def test_session_survives_restart_during_move(
    session: SessionRunner, robot: SimulatedDevice
) -> None:
    session.wait(Connected)
    session.do(SetSpeeds(1, CREEPING), Move(2, THERE))
    session.wait(Moving)
    _restart_is_survived(session, robot)
    assert "restarted" in str(next(one for one in session.of(Outcome) if one.id == 2).error)


def test_session_survives_restart_during_playback(
    session: SessionRunner, robot: SimulatedDevice
) -> None:
    session.wait(Connected)
    session.do(Play(1, (Step((560,) * 8, 0.4), Step((460,) * 8, 0.4)), 0))
    session.wait(StepBegun, 3)
    _restart_is_survived(session, robot)
    assert session.of(PlayEnded)[0].why is Ending.RESTARTED


def test_session_connects_after_restart_while_connecting(
    robot: SimulatedDevice, session: SessionRunner
) -> None:
    session._qtbot.waitUntil(lambda: robot.show()["counters"]["line"]["sent"] > 0, timeout=15_000)
    robot.do("reset")
    assert session.wait(Connected).motors == 8


@pytest.mark.parametrize("comes_back", [True, False])
def test_servo_failing_in_motion_is_reported_stuck(
    session: SessionRunner, robot: SimulatedDevice, qtbot: QtBot, *, comes_back: bool
) -> None:
    session.wait(Connected)
    session.do(SetSpeeds(1, SLOW), Move(2, HERE))
    session.wait(Moved)
    robot.do("servo 3 load 0.98")  # on its way for 40 s, as long as this may take
    session.do(Move(3, THERE))
    session.wait(Moving, 2)
    qtbot.waitUntil(lambda: robot.show()["servos"][3]["moving"])  # the line takes its time
    robot.do("servo 3 dead")
    robot.do("servo 3 load 0")
    assert session.wait(Stuck).motor == 3
    if comes_back:
        robot.do("servo 3 alive")
        assert abs(session.wait(Moved, 2).present[3] - 700) <= 2
        session.do(Move(4, HERE))
        assert abs(session.wait(Moved, 3).present[3] - 512) <= 2
    else:
        robot.do("reset")
        assert session.wait(Connected, 2).restarted
        assert session.of(Outcome)[-1].error is not None


def test_command_after_truncated_reply_succeeds(
    session: SessionRunner, robot: SimulatedDevice
) -> None:
    session.wait(Connected)
    session.do(SetSpeeds(1, CREEPING), Move(2, THERE))
    session.wait(Moving)
    robot.do("line drop 9")
    session.wait(Outcome, 2)
    session.do(Move(3, HERE))
    assert session.wait(Outcome, 3).error is None


def test_unplugged_line_closes_session_in_motion(
    session: SessionRunner, robot: SimulatedDevice
) -> None:
    session.wait(Connected)
    session.do(SetSpeeds(1, SLOW), Move(2, THERE))
    session.wait(Moving)
    robot.do("line unplug")
    assert isinstance(session.wait(Closed).error, PortUnavailable)
    assert {one.id for one in session.of(Outcome)} == {1, 2}


def test_halt_finishes_only_current_step(session: SessionRunner, robot: SimulatedDevice) -> None:
    session.wait(Connected)
    session.do(Play(1, (Step((560,) * 8, 0.6), Step((460,) * 8, 0.6)), 0))
    session.wait(Moving, 3)
    session.do(Halt())
    assert session.wait(PlayEnded).why is Ending.HALTED
    session.wait(Moved, len(session.of(Moving)))
    goals = robot.show()["servos"][0]["goal"]
    session._qtbot.waitUntil(lambda: not robot.show()["servos"][0]["moving"])
    assert robot.show()["servos"][0]["goal"] == goals
    assert len(session.of(Moved)) == len(session.of(Moving))


def test_playback_keeps_schedule(session: SessionRunner) -> None:
    session.wait(Connected)
    session.do(SetSpeeds(1, (500,) * 8), Move(2, HERE))
    session.wait(Moved)
    session.do(Play(3, (Step((560,) * 8, 0.5), Step((460,) * 8, 0.5)), 4))
    assert session.wait(PlayEnded).why is Ending.DONE
    steps = session.of(StepBegun)
    assert len(steps) == 8
    for index, step in enumerate(steps):
        assert step.time - step.late == pytest.approx(steps[0].time + 0.5 * index, abs=0.001)
        assert step.late < 0.1
