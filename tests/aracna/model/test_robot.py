"""The robot as the window sees it, at the simulated one in a process of its own."""

import threading
from collections.abc import Callable, Iterator

import pytest
from PySide6.QtCore import QSettings
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice, StartSimulator
from trex_gui.aracna.link.messages import Moved, Moving, Play, SpeedsHeld, Step
from trex_gui.aracna.model.robot import Robot
from trex_gui.aracna.model.speeds import FIRST_SPEED
from trex_gui.link.settings import LinkSettings
from trex_gui.link.timeouts import Timeouts
from trex_gui.model.connection import Link
from trex_gui.protocol.errors import BadRequest
from trex_gui.runtime import now

LOW = (300,) * 8
HIGH = (400,) * 8


class Watched:
    """A robot, its simulator, and everything that was told of it."""

    def __init__(self, simulator: SimulatedDevice, qtbot: QtBot) -> None:
        self.simulator = simulator
        self.qtbot = qtbot
        self.robot = Robot()
        self.reports: list[object] = []
        self.said: list[str] = []
        self.robot.reported.connect(self.reports.append)
        self.links: list[tuple[Link, str]] = []
        for signal in (self.robot.told, self.robot.refused, self.robot.failed):
            signal.connect(self.said.append)
        self.robot.link_changed.connect(self._note_link)

    def _note_link(self) -> None:
        self.links.append((self.robot.link, self.robot.status))

    def connect(self) -> None:
        self.robot.connect_to(LinkSettings(self.simulator.url, timeouts=Timeouts(extra=2.0)))
        self.wait(lambda: self.robot.link is Link.UP)

    def wait(self, condition: Callable[[], bool]) -> None:
        self.qtbot.waitUntil(condition, timeout=15_000)

    def rest(self) -> None:
        """Wait until an answer is complete and nothing is on its way."""
        known = self.robot.known
        self.wait(lambda: known.moved is not None and known.play is None)

    def move(self, goals: tuple[int, ...]) -> None:
        before = len(self.of(Moved))
        assert self.robot.move(goals)
        self.wait(lambda: len(self.of(Moved)) > before)

    def lose_motor_3(self, goals: tuple[int, ...]) -> None:
        """Let a motor die on its way: one that is dead before does not even take its speed."""
        self.simulator.do("servo 3 block")  # it is on its way for as long as that
        assert self.robot.move(goals)
        self.wait(lambda: self.robot.known.moving is not None)
        self.simulator.do("servo 3 dead")
        self.simulator.do("servo 3 free")

    def sent_after(self, moment: float) -> int:
        """How many motions went out later; one that went out before may be told later."""
        return sum(isinstance(each, Moving) and each.time > moment for each in self.reports)

    def drag(self, goals: tuple[int, ...]) -> None:
        before = len(self.of(Moved))
        self.robot.drag(goals)
        self.wait(lambda: len(self.of(Moved)) > before)

    def end(self) -> None:
        """Give the line back, which may take longer than a program waits that ends."""
        self.robot.disconnect_line()
        self.wait(lambda: self.robot.link is Link.NONE)
        assert self.robot.shut_down()

    def of(self, kind: type) -> list[object]:
        return [report for report in self.reports if isinstance(report, kind)]

    @property
    def sent(self) -> list[tuple[int, ...]]:
        """The goals of every motion that went out."""
        return [report.goals for report in self.reports if isinstance(report, Moving)]

    @property
    def speeds(self) -> list[int]:
        return [servo["speed"] for servo in self.simulator.show()["servos"]]


@pytest.fixture
def simulator(start_simulator: StartSimulator) -> SimulatedDevice:
    return start_simulator("--aracna", "--unpaced")


@pytest.fixture
def watched(simulator: SimulatedDevice, qtbot: QtBot) -> Iterator[Watched]:
    watched = Watched(simulator, qtbot)
    yield watched
    watched.end()


@pytest.fixture
def robot(watched: Watched) -> Robot:
    watched.connect()
    return watched.robot


def test_where_the_motors_are_is_not_known_before_the_first_move(
    robot: Robot, watched: Watched
) -> None:
    assert robot.version == 1
    assert robot.motors == 8
    assert robot.present == (None,) * 8
    assert not watched.sent
    watched.move((512,) * 8)
    assert all(position is not None for position in robot.present)


def test_the_first_move_goes_slowly(robot: Robot, watched: Watched) -> None:
    watched.move((480,) * 8)
    assert watched.speeds == [FIRST_SPEED] * 8
    order = [type(report) for report in watched.reports]
    assert order.index(SpeedsHeld) < order.index(Moving)


def test_the_first_move_goes_as_fast_as_a_person_has_chosen(robot: Robot, watched: Watched) -> None:
    robot.set_speeds((0, 300, 300, 300, 300, 300, 300, 1023))
    watched.move((480,) * 8)
    assert watched.speeds == [0, 300, 300, 300, 300, 300, 300, 1023]


def test_speeds_that_cannot_be_are_refused(robot: Robot) -> None:
    with pytest.raises(BadRequest, match="0 to 1023"):
        robot.set_speeds((1024,) * 8)
    with pytest.raises(BadRequest, match="8 speeds"):
        robot.set_speeds((100,) * 7)
    assert robot.speeds.wanted == (FIRST_SPEED,) * 8


def test_goals_are_kept_within_the_limits_and_that_is_said(robot: Robot, watched: Watched) -> None:
    robot.set_speeds((0,) * 8)
    watched.move((0, 1023, 512, 512, 512, 512, 512, 512))
    assert watched.sent == [(50, 550, 512, 512, 512, 512, 512, 512)]
    assert "motor 0 to 50 instead of 0, motor 1 to 550 instead of 1023" in watched.said[0]


def test_limits_are_remembered_and_can_be_reset(robot: Robot) -> None:
    robot.limits.set(3, 200, 300)
    assert robot.targets.goals[3] == 300
    again = Robot()
    assert (again.limits.of(3).low, again.limits.of(3).high) == (200, 300)
    again.limits.reset()
    assert Robot().limits.are_factory


@pytest.mark.parametrize("kept", ["nonsense", "1-2", "900-100 " * 8, "0-2000 " * 8])
def test_limits_that_were_kept_badly_are_those_of_the_authors(kept: str) -> None:
    QSettings().setValue("aracna/limits", kept)
    assert Robot().limits.are_factory


def test_a_drag_sends_the_newest_goal_and_knows_its_rate(robot: Robot, watched: Watched) -> None:
    watched.move(LOW)
    robot.set_speeds((0,) * 8)
    robot.begin_drag()
    for goal in range(300, 360):
        robot.drag((goal,) * 8)
    watched.wait(lambda: (359,) * 8 in watched.sent and robot.known.moving is None)
    assert len(watched.sent) < 30, "the newest goal replaces those that wait"
    for goal in (330, 340) * 25:  # after a pause of a second the rate is reckoned anew
        watched.drag((goal,) * 8)
        assert watched.sent[-1] == (goal,) * 8
        if robot.rate is not None:
            break
    assert robot.rate is not None
    assert 1 < robot.rate < 60
    robot.end_drag()
    count = len(watched.sent)
    robot.drag((350,) * 8)
    watched.move(LOW)
    assert len(watched.sent) == count + 1, "nothing is dragged after it was let go"


def test_a_motor_that_does_not_reach_its_goal_is_told(robot: Robot, watched: Watched) -> None:
    watched.move((512,) * 8)
    assert not list(robot.known.missed)
    watched.simulator.do("servo 2 lose position")
    watched.move((480,) * 8)
    assert [(each.motor, each.unreadable) for each in robot.known.missed] == [(2, True)]
    assert robot.present[2] is None
    assert "Motor 2 did not say where it is (−1)." in [event.text for event in robot.events.all]


def test_a_speed_that_a_servo_does_not_take_is_told(robot: Robot, watched: Watched) -> None:
    watched.simulator.do("servo 5 dead")
    robot.set_speeds((200,) * 8)
    watched.wait(lambda: bool(watched.of(SpeedsHeld)))
    assert [(each.motor, each.held) for each in robot.known.speeds_refused] == [(5, -1)]


def test_a_motor_that_is_waited_for_is_named_until_it_answers(
    robot: Robot, watched: Watched
) -> None:
    watched.move((512,) * 8)
    watched.lose_motor_3((500,) * 8)
    watched.wait(lambda: robot.known.stuck is not None)
    stuck = robot.known.stuck
    assert stuck is not None
    assert stuck.motor == 3
    assert any("waits for motor 3" in event.text for event in robot.events.all)
    watched.simulator.do("servo 3 alive")
    watched.wait(lambda: robot.known.moved is not None)
    assert robot.known.stuck is None


def test_how_long_the_motion_lasts_counts_down(robot: Robot, watched: Watched) -> None:
    watched.move((512,) * 8)
    robot.set_speeds((25,) * 8)
    robot.move((284,) * 8)
    watched.wait(lambda: robot.known.moving is not None)
    ends_at = robot.known.ends_at
    assert ends_at is not None
    before, left, after = now(), robot.remaining(), now()
    assert ends_at - after <= left <= ends_at - before
    moving = robot.known.moving
    assert moving is not None
    assert ends_at == moving.time + moving.expected
    assert moving.expected == pytest.approx(4, abs=0.05), "228 units at a speed of 25: 4 s"
    watched.wait(lambda: robot.known.moving is None)
    assert robot.remaining() == 0


def steps(*goals: tuple[int, ...]) -> tuple[Step, ...]:
    return tuple(Step(goal, 0.2, f"step {index}") for index, goal in enumerate(goals))


def test_what_is_played_begins_slowly_where_nobody_knows_where_the_motors_are(
    robot: Robot, watched: Watched
) -> None:
    assert robot.play(Play(0, steps((500,) * 8, (520,) * 8)))
    assert robot.playing is not None
    watched.wait(lambda: bool(watched.of(SpeedsHeld)))
    assert max(watched.speeds) <= FIRST_SPEED
    watched.wait(lambda: robot.playing is None)
    assert watched.sent == [(500,) * 8, (500,) * 8, (520,) * 8]


def test_halt_ends_what_is_played_and_holds_what_is_reported(
    robot: Robot, watched: Watched
) -> None:
    watched.move(LOW)
    robot.play(Play(0, steps(HIGH, LOW), rounds=0))
    watched.wait(lambda: robot.playing is not None and robot.playing.round >= 1)
    robot.halt()
    halted = now()
    watched.wait(lambda: robot.playing is None and robot.known.moving is None)
    assert watched.sent_after(halted) <= 1  # one may have been on its way
    assert robot.targets.goals == robot.present
    assert watched.said == []


def test_an_emergency_ends_what_is_played_from_any_thread(robot: Robot, watched: Watched) -> None:
    watched.move(LOW)
    robot.play(Play(0, steps(HIGH, LOW), rounds=0))
    watched.wait(lambda: robot.playing is not None and robot.playing.round >= 1)
    thread = threading.Thread(target=robot.halt_now)
    thread.start()
    thread.join()
    watched.wait(lambda: robot.playing is None)
    assert robot.link is Link.UP


def test_a_sequence_is_not_disturbed_by_a_move(robot: Robot, watched: Watched) -> None:
    watched.move(LOW)
    robot.play(Play(0, steps(HIGH, LOW), rounds=0))
    assert not robot.move((500,) * 8)
    assert watched.said == ["A sequence is playing. Stop it first."]
    robot.end_play()
    watched.wait(lambda: robot.playing is None)
    assert (500,) * 8 not in watched.sent


def test_after_a_sequence_the_speeds_are_again_those_that_were_chosen(
    robot: Robot, watched: Watched
) -> None:
    robot.set_speeds((150,) * 8)
    watched.move(LOW)
    robot.play(Play(0, steps(HIGH, LOW)))
    watched.wait(lambda: robot.playing is None)
    watched.move((310,) * 8)
    assert watched.speeds == [150] * 8


def test_a_board_that_restarts_is_told_and_has_its_speeds_set_anew(
    robot: Robot, watched: Watched
) -> None:
    robot.set_speeds((150,) * 8)
    watched.move(LOW)
    watched.links.clear()
    watched.simulator.do("power cycle")
    watched.wait(lambda: bool(watched.links))
    link, status = watched.links[0]
    assert link is Link.SILENT
    assert "restarted" in status
    watched.wait(lambda: robot.link is Link.UP)
    watched.move((310,) * 8)
    assert watched.speeds == [150] * 8


def test_a_pulled_plug_is_told(robot: Robot, watched: Watched) -> None:
    watched.move(LOW)
    watched.simulator.do("line unplug")
    watched.wait(lambda: robot.link is Link.NONE)
    assert len(watched.said) == 1
    assert robot.present == (None,) * 8
    assert not robot.move(LOW)
    assert "No robot is connected" in watched.said[-1]


def test_a_robot_of_two_motors_has_two_of_everything(
    qtbot: QtBot, start_simulator: StartSimulator
) -> None:
    simulator = start_simulator("--aracna", "--unpaced", "--motors", "2")
    watched = Watched(simulator, qtbot)
    watched.connect()
    robot = watched.robot
    assert robot.motors == len(robot.targets.goals) == len(robot.speeds.wanted) == 2
    watched.move((500, 500))
    assert robot.present == (500, 500) or not robot.known.missed
    watched.end()
