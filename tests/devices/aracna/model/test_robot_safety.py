"""Speeds, limits and awaited motors keep the robot from moving unexpectedly."""

from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from tests.devices.aracna.model.test_robot import HIGH, LOW, RobotHarness, steps
from tests.support.simulator import SimulatedDevice, StartSimulator
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.session.messages import Play, SpeedsHeld


@pytest.fixture
def simulator(start_simulator: StartSimulator) -> SimulatedDevice:
    return start_simulator("--aracna", "--unpaced")


@pytest.fixture
def harness(simulator: SimulatedDevice, qtbot: QtBot) -> Iterator[RobotHarness]:
    harness = RobotHarness(simulator, qtbot)
    yield harness
    harness.end()


@pytest.fixture
def robot(harness: RobotHarness) -> Robot:
    harness.connect()
    return harness.robot


def test_move_needs_servo_power_and_keeps_chosen_speed(
    harness: RobotHarness,
) -> None:
    harness.simulator.do("servo power off")
    harness.connect()
    robot = harness.robot
    robot.set_speeds((30,) * 8)
    assert robot.move((440,) * 8)
    harness.wait(lambda: any("Not moved" in text for text in harness.messages))
    assert "Check the servo power" in harness.messages[-1]
    assert not harness.sent
    harness.simulator.do("servo power on")
    harness.move((440,) * 8)
    assert harness.speeds == [30] * 8
    assert robot.state.moved is not None
    assert robot.state.moved.seconds > 0.9, "72 units at 30 are 1.05 s"


def test_latest_speed_applies_to_next_motion(robot: Robot, harness: RobotHarness) -> None:
    harness.move((512,) * 8)
    robot.set_speeds((40,) * 8)
    robot.move((200,) * 8)  # 3.4 s, in which all of this is requested
    harness.wait(lambda: robot.state.moving is not None)
    robot.set_speeds((700,) * 8)
    robot.set_speeds((20,) * 8)
    robot.move((210,) * 8)
    harness.wait(lambda: (210,) * 8 in harness.sent and robot.state.moving is None)
    assert harness.speeds == [20] * 8
    held = [report.held for report in harness.reports if isinstance(report, SpeedsHeld)]
    assert held[-1] == (20,) * 8
    assert harness.messages == []


def test_changed_limits_apply_to_next_steps_of_playback(
    robot: Robot, harness: RobotHarness
) -> None:
    harness.move(LOW)
    robot.play(Play(0, steps(HIGH, LOW), rounds=0))
    harness.wait(lambda: robot.state.step is not None and robot.state.step.round >= 1)
    for motor in range(robot.state.motors):
        robot.limits.set(motor, 340, 360)
    harness.wait(lambda: (360,) * 8 in harness.sent and (340,) * 8 in harness.sent)
    first = min(harness.sent.index((goal,) * 8) for goal in (340, 360))
    assert set(harness.sent[first:]) == {(340,) * 8, (360,) * 8}
    robot.halt()
    harness.wait(lambda: robot.state.play is None and robot.state.moving is None)


def test_commands_while_motor_is_stuck_are_never_sent(robot: Robot, harness: RobotHarness) -> None:
    harness.move((512,) * 8)
    harness.lose_motor_3((500,) * 8)
    robot.move((300,) * 8)  # waits, and is dropped
    harness.wait(lambda: robot.state.stuck is not None)
    assert not robot.move((350,) * 8)
    assert not robot.play(Play(0, steps(HIGH, LOW)))
    assert "is waiting for motor 3" in harness.messages[-1]
    harness.simulator.do("servo 3 alive")
    harness.wait(lambda: robot.state.moving is None)
    harness.move((490,) * 8)
    assert harness.sent == [(512,) * 8, (500,) * 8, (490,) * 8]


def test_drag_with_rejected_speed_is_reported_once(robot: Robot, harness: RobotHarness) -> None:
    harness.move(LOW)
    harness.simulator.do("servo 5 dead")
    robot.speeds, robot.speeds_chosen = (200,) * 8, True
    robot.begin_drag()
    for goal in range(300, 340):
        robot.drag((goal,) * 8)
    harness.wait(lambda: not robot.dragging)
    robot.drag(HIGH)
    harness.simulator.do("servo 5 alive")
    harness.move((310,) * 8)
    assert harness.sent == [LOW, (310,) * 8]
    assert len(harness.messages) == 1
    assert "Motor 5 did not accept speed 200" in harness.messages[0]
