"""What keeps the robot from going as nobody wants: speeds, limits, motors that are waited for."""

from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from tests.aracna.model.test_robot import HIGH, LOW, Watched, steps
from tests.support.simulator import SimulatedDevice, StartSimulator
from trex_gui.aracna.link.messages import Play, SpeedsHeld
from trex_gui.aracna.model.robot import Robot


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


def test_without_servo_power_nothing_is_moved_and_with_it_the_motion_is_as_slow_as_asked(
    watched: Watched,
) -> None:
    watched.simulator.do("servo power off")
    watched.connect()
    robot = watched.robot
    robot.set_speeds((30,) * 8)
    assert robot.move((440,) * 8)
    watched.wait(lambda: any("Not moved" in text for text in watched.said))
    assert "do the servos have power?" in watched.said[-1]
    assert not watched.sent
    watched.simulator.do("servo power on")
    watched.move((440,) * 8)
    assert watched.speeds == [30] * 8
    assert robot.known.moved is not None
    assert robot.known.moved.seconds > 0.9, "72 units at 30 are 1.05 s"


def test_the_speed_that_was_chosen_last_while_a_motion_runs_holds_for_the_next(
    robot: Robot, watched: Watched
) -> None:
    watched.move((512,) * 8)
    robot.set_speeds((40,) * 8)
    robot.move((200,) * 8)  # 3.4 s, in which all of this has to be asked for
    watched.wait(lambda: robot.known.moving is not None)
    robot.set_speeds((700,) * 8)
    robot.set_speeds((20,) * 8)
    robot.move((210,) * 8)
    watched.wait(lambda: (210,) * 8 in watched.sent and robot.known.moving is None)
    assert watched.speeds == [20] * 8
    held = [report.held for report in watched.reports if isinstance(report, SpeedsHeld)]
    assert held[-1] == (20,) * 8
    assert watched.said == []


def test_limits_that_are_changed_while_something_plays_count_for_its_next_steps(
    robot: Robot, watched: Watched
) -> None:
    watched.move(LOW)
    robot.play(Play(0, steps(HIGH, LOW), rounds=0))
    watched.wait(lambda: robot.playing is not None and robot.playing.round >= 1)
    for motor in range(robot.motors):
        robot.limits.set(motor, 340, 360)
    watched.wait(lambda: (360,) * 8 in watched.sent and (340,) * 8 in watched.sent)
    first = min(watched.sent.index((goal,) * 8) for goal in (340, 360))
    assert set(watched.sent[first:]) == {(340,) * 8, (360,) * 8}
    robot.halt()
    watched.wait(lambda: robot.playing is None and robot.known.moving is None)


def test_what_is_asked_for_while_a_motor_is_waited_for_is_refused_and_never_begins(
    robot: Robot, watched: Watched
) -> None:
    watched.move((512,) * 8)
    watched.lose_motor_3((500,) * 8)
    robot.move((300,) * 8)  # waits, and is dropped
    watched.wait(lambda: robot.known.stuck is not None)
    assert not robot.move((350,) * 8)
    assert not robot.play(Play(0, steps(HIGH, LOW)))
    assert "stuck" in watched.said[-1]
    watched.simulator.do("servo 3 alive")
    watched.wait(lambda: robot.known.moving is None)
    watched.move((490,) * 8)
    assert watched.sent == [(512,) * 8, (500,) * 8, (490,) * 8]


def test_a_drag_that_cannot_go_at_its_speed_is_told_once(robot: Robot, watched: Watched) -> None:
    watched.move(LOW)
    watched.simulator.do("servo 5 dead")
    robot.speeds.choose((200,) * 8)
    robot.begin_drag()
    for goal in range(300, 340):
        robot.drag((goal,) * 8)
    watched.wait(lambda: not robot.dragging)
    robot.drag(HIGH)
    watched.simulator.do("servo 5 alive")
    watched.move((310,) * 8)
    assert watched.sent == [LOW, (310,) * 8]
    assert len(watched.said) == 1
    assert "Motor 5 did not take its speed of 200" in watched.said[0]
