"""A session in its thread, with a robot at its real pace."""

import sys
from collections.abc import Iterator
from typing import TypeVar

import pytest
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice, StartSimulator
from trex_gui.aracna.link.discovery import find_aracna
from trex_gui.aracna.link.messages import (
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
from trex_gui.aracna.link.session import AracnaSession
from trex_gui.aracna.protocol.units import travel_seconds
from trex_gui.link.messages import Closed, Outcome
from trex_gui.link.settings import LinkSettings
from trex_gui.link.timeouts import Timeouts
from trex_gui.protocol.errors import PortUnavailable
from trex_gui.runtime import open_transport
from trex_gui.worker.line_worker import LineWorker

KindT = TypeVar("KindT")

HERE = (512,) * 8
THERE = (700,) * 8
SLOW = (100,) * 8
CREEPING = (20,) * 8


class Talk:
    """A session that runs, and what it has reported."""

    def __init__(self, url: str, qtbot: QtBot) -> None:
        self._qtbot = qtbot
        self.reports: list[object] = []
        settings = LinkSettings(url, timeouts=Timeouts(extra=3.0))
        self.worker = LineWorker(
            lambda inbox, tell: AracnaSession(settings, inbox, tell, open_transport)
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
def talk(robot: SimulatedDevice, qtbot: QtBot) -> Iterator[Talk]:
    talk = Talk(robot.url, qtbot)
    yield talk
    assert talk.worker.close(15_000)
    qtbot.waitUntil(lambda: bool(talk.of(Closed)), timeout=15_000)
    assert talk.reports[-1] == talk.of(Closed)[0]


@pytest.mark.realtime
@pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")
def test_a_robot_that_was_just_switched_on_is_found_and_talked_to(
    robot: SimulatedDevice, qtbot: QtBot
) -> None:
    [found] = find_aracna(LinkSettings(robot.url, timeouts=Timeouts(extra=0.2))).found
    assert found.motors == 8
    talk = Talk(robot.url, qtbot)
    assert talk.wait(Connected).motors == 8
    assert talk.worker.close(15_000)


def test_a_move_takes_as_long_as_the_formula_says(talk: Talk) -> None:
    talk.wait(Connected)
    talk.do(SetSpeeds(1, SLOW), Move(2, THERE))
    moved = talk.wait(Moved)
    assert all(abs(position - 700) <= 2 for position in moved.present)
    assert moved.seconds == pytest.approx(travel_seconds(188, 100), abs=0.1)
    assert len(talk.of(Passed)) >= 1
    assert all(outcome.error is None for outcome in talk.of(Outcome))


def _restart_is_survived(talk: Talk, robot: SimulatedDevice) -> None:
    robot.do("reset")
    talk.wait(Restarted)
    assert talk.wait(Connected, 2).restarted
    talk.do(Move(99, HERE))
    talk._qtbot.waitUntil(lambda: any(one.id == 99 for one in talk.of(Outcome)), timeout=15000)
    [outcome] = [one for one in talk.of(Outcome) if one.id == 99]
    assert outcome.error is None
    # Of a line that was on its way three bytes may be left, which restart the board once more.
    assert robot.show()["boots"] in {2, 3}


def test_a_restart_while_idle(talk: Talk, robot: SimulatedDevice) -> None:
    talk.wait(Connected)
    _restart_is_survived(talk, robot)


def test_a_restart_among_speeds_and_motions_that_take_turns(
    talk: Talk, robot: SimulatedDevice
) -> None:
    talk.wait(Connected)
    talk.do(*(Move(number, HERE, (500 + number % 2,) * 8) for number in range(60)))
    talk.wait(SpeedsHeld, 2)
    _restart_is_survived(talk, robot)
    assert any("restarted" in str(one.error) for one in talk.of(Outcome))


def test_a_restart_during_a_c(talk: Talk, robot: SimulatedDevice) -> None:
    talk.wait(Connected)
    talk.do(SetSpeeds(1, CREEPING), Move(2, THERE))
    talk.wait(Moving)
    _restart_is_survived(talk, robot)
    assert "restarted" in str(next(one for one in talk.of(Outcome) if one.id == 2).error)


def test_a_restart_while_playing(talk: Talk, robot: SimulatedDevice) -> None:
    talk.wait(Connected)
    talk.do(Play(1, (Step((560,) * 8, 0.4), Step((460,) * 8, 0.4)), 0))
    talk.wait(StepBegun, 3)
    _restart_is_survived(talk, robot)
    assert talk.of(PlayEnded)[0].why is Ending.RESTARTED


def test_a_restart_while_opening(robot: SimulatedDevice, talk: Talk) -> None:
    talk._qtbot.waitUntil(lambda: robot.show()["counters"]["line"]["sent"] > 0, timeout=15_000)
    robot.do("reset")
    assert talk.wait(Connected).motors == 8


@pytest.mark.parametrize("comes_back", [True, False])
def test_a_servo_that_dies_in_mid_motion(
    talk: Talk, robot: SimulatedDevice, qtbot: QtBot, *, comes_back: bool
) -> None:
    talk.wait(Connected)
    talk.do(SetSpeeds(1, SLOW), Move(2, HERE))
    talk.wait(Moved)
    robot.do("servo 3 load 0.98")  # on its way for 40 s, as long as this may take
    talk.do(Move(3, THERE))
    talk.wait(Moving, 2)
    qtbot.waitUntil(lambda: robot.show()["servos"][3]["moving"])  # the line takes its time
    robot.do("servo 3 dead")
    robot.do("servo 3 load 0")
    assert talk.wait(Stuck).motor == 3
    if comes_back:
        robot.do("servo 3 alive")
        assert abs(talk.wait(Moved, 2).present[3] - 700) <= 2
        talk.do(Move(4, HERE))
        assert abs(talk.wait(Moved, 3).present[3] - 512) <= 2
    else:
        robot.do("reset")
        assert talk.wait(Connected, 2).restarted
        assert talk.of(Outcome)[-1].error is not None


def test_a_reply_that_is_cut_in_the_middle(talk: Talk, robot: SimulatedDevice) -> None:
    talk.wait(Connected)
    talk.do(SetSpeeds(1, CREEPING), Move(2, THERE))
    talk.wait(Moving)
    robot.do("line drop 9")
    talk.wait(Outcome, 2)
    talk.do(Move(3, HERE))
    assert talk.wait(Outcome, 3).error is None


def test_a_line_that_is_pulled_out_in_mid_motion(talk: Talk, robot: SimulatedDevice) -> None:
    talk.wait(Connected)
    talk.do(SetSpeeds(1, SLOW), Move(2, THERE))
    talk.wait(Moving)
    robot.do("line unplug")
    assert isinstance(talk.wait(Closed).error, PortUnavailable)
    assert {one.id for one in talk.of(Outcome)} == {1, 2}


def test_a_halt_lets_the_running_step_end_and_nothing_else(
    talk: Talk, robot: SimulatedDevice
) -> None:
    talk.wait(Connected)
    talk.do(Play(1, (Step((560,) * 8, 0.6), Step((460,) * 8, 0.6)), 0))
    talk.wait(Moving, 3)
    talk.do(Halt())
    assert talk.wait(PlayEnded).why is Ending.HALTED
    talk.wait(Moved, len(talk.of(Moving)))
    goals = robot.show()["servos"][0]["goal"]
    talk._qtbot.waitUntil(lambda: not robot.show()["servos"][0]["moving"])
    assert robot.show()["servos"][0]["goal"] == goals
    assert len(talk.of(Moved)) == len(talk.of(Moving))


def test_what_is_played_keeps_its_clock(talk: Talk) -> None:
    talk.wait(Connected)
    talk.do(SetSpeeds(1, (500,) * 8), Move(2, HERE))
    talk.wait(Moved)
    talk.do(Play(3, (Step((560,) * 8, 0.5), Step((460,) * 8, 0.5)), 4))
    assert talk.wait(PlayEnded).why is Ending.DONE
    steps = talk.of(StepBegun)
    assert len(steps) == 8
    for index, step in enumerate(steps):
        assert step.time - step.late == pytest.approx(steps[0].time + 0.5 * index, abs=0.001)
        assert step.late < 0.1
