"""Robot model with a simulated robot."""

import threading
from collections.abc import Callable, Iterator
from typing import TypeVar

import pytest
from PySide6.QtCore import QSettings
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice, StartSimulator
from trex_gui.core.timing import Timeouts
from trex_gui.core.transport.settings import PortSettings
from trex_gui.devices.aracna.model.robot import FIRST_SPEED, Robot
from trex_gui.devices.aracna.session.messages import Moved, Moving, Play, SpeedsHeld, Step
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.runtime import now

KindT = TypeVar("KindT")

LOW = (300,) * 8
HIGH = (400,) * 8
STEP_SECONDS = 0.2


class RobotHarness:
    """Robot with its simulator, reports and messages."""

    def __init__(self, simulator: SimulatedDevice, qtbot: QtBot) -> None:
        self.simulator = simulator
        self.qtbot = qtbot
        self.robot = Robot()
        self.reports: list[object] = []
        self.messages: list[str] = []
        self.robot.reported.connect(self.reports.append)
        self.links: list[tuple[ConnectionState, str]] = []
        for signal in (self.robot.notifier.info, self.robot.notifier.error):
            signal.connect(self.messages.append)
        self.robot.link_changed.connect(self._record_link)

    def _record_link(self) -> None:
        self.links.append((self.robot.link, self.robot.status))

    def connect(self) -> None:
        self.robot.open(PortSettings(self.simulator.url, timeouts=Timeouts(extra=2.0)))
        self.wait(lambda: self.robot.link is ConnectionState.CONNECTED)

    def wait(self, condition: Callable[[], bool]) -> None:
        self.qtbot.waitUntil(condition, timeout=15_000)

    def move(self, goals: tuple[int, ...]) -> None:
        before = len(self.of(Moved))
        assert self.robot.move(goals)
        self.wait(lambda: len(self.of(Moved)) > before)

    def lose_motor_3(self, goals: tuple[int, ...]) -> None:
        """Kill motor 3 during its motion. A motor that is already dead does not accept a speed."""
        self.simulator.do("servo 3 block")  # the motion takes longer
        assert self.robot.move(goals)
        self.wait(lambda: self.robot.state.moving is not None)
        self.simulator.do("servo 3 dead", "servo 3 free")

    def drag(self, goals: tuple[int, ...]) -> None:
        before = len(self.of(Moved))
        self.robot.drag(goals)
        self.wait(lambda: len(self.of(Moved)) > before)

    def end(self) -> None:
        """Close the line, which may take longer than at the end of the program."""
        self.robot.close()
        self.wait(lambda: self.robot.link is ConnectionState.DISCONNECTED)
        assert self.robot.shut_down()

    def of(self, kind: type[KindT]) -> list[KindT]:
        return [report for report in self.reports if isinstance(report, kind)]

    @property
    def sent(self) -> list[tuple[int, ...]]:
        """Goals of all sent motions."""
        return [report.goals for report in self.of(Moving)]

    @property
    def speeds(self) -> list[int]:
        return [servo["speed"] for servo in self.simulator.show()["servos"]]


@pytest.fixture
def harness(start_simulator: StartSimulator, qtbot: QtBot) -> Iterator[RobotHarness]:
    harness = RobotHarness(start_simulator("--aracna", "--unpaced"), qtbot)
    yield harness
    harness.end()


@pytest.fixture
def robot(harness: RobotHarness) -> Robot:
    harness.connect()
    return harness.robot


def test_first_move_is_slow_and_makes_positions_known(robot: Robot, harness: RobotHarness) -> None:
    assert robot.state.version == 1
    assert robot.state.motors == 8
    assert robot.state.present == (None,) * 8
    assert not harness.sent
    harness.move((512,) * 8)
    assert all(position is not None for position in robot.state.present)
    assert harness.speeds == [FIRST_SPEED] * 8
    order = [type(report) for report in harness.reports]
    assert order.index(SpeedsHeld) < order.index(Moving)


def test_goals_are_clamped_to_limits_with_message(robot: Robot, harness: RobotHarness) -> None:
    robot.set_speeds((0,) * 8)
    harness.move((0, 1023, 512, 512, 512, 512, 512, 512))
    assert harness.sent == [(50, 550, 512, 512, 512, 512, 512, 512)]
    assert "motor 0 to 50 instead of 0, motor 1 to 550 instead of 1023" in harness.messages[0]


def test_limits_are_saved_and_can_be_reset(robot: Robot) -> None:
    robot.limits.set(3, 200, 300)
    assert robot.targets.goals[3] == 300
    again = Robot()
    assert (again.limits.of(3).low, again.limits.of(3).high) == (200, 300)
    again.limits.reset()
    assert Robot().limits.are_factory


@pytest.mark.parametrize("saved", ["nonsense", "1-2", "900-100 " * 8, "0-2000 " * 8])
def test_invalid_saved_limits_are_replaced_by_defaults(saved: str) -> None:
    QSettings().setValue("aracna/limits", saved)
    assert Robot().limits.are_factory


def test_drag_sends_nothing_after_release(robot: Robot, harness: RobotHarness) -> None:
    robot.start_drag()
    harness.drag(HIGH)
    robot.end_drag()
    robot.drag((350,) * 8)
    harness.move(LOW)
    assert harness.sent == [HIGH, LOW]


def test_unreadable_position_is_reported_as_missed_goal(
    robot: Robot, harness: RobotHarness
) -> None:
    harness.move((512,) * 8)
    assert not robot.state.missed_goals
    harness.simulator.do("servo 2 lose position")
    harness.move((480,) * 8)
    assert list(robot.state.missed_goals) == [2]
    assert robot.state.present[2] is None
    assert "Motor 2 did not report its position (−1)." in [event.text for event in robot.events.all]


def test_failed_move_is_reported(robot: Robot, harness: RobotHarness) -> None:
    harness.simulator.do("servo power off")
    assert robot.move((440,) * 8)
    harness.wait(lambda: any("Not moved" in text for text in harness.messages))
    assert "Check the servo power" in harness.messages[-1]
    assert not harness.sent


def test_commands_while_motor_is_stuck_are_never_sent(robot: Robot, harness: RobotHarness) -> None:
    harness.move((512,) * 8)
    harness.lose_motor_3((500,) * 8)
    robot.move((300,) * 8)  # queued, then dropped
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
    robot.speeds, robot.has_user_speeds = (200,) * 8, True
    robot.start_drag()
    for goal in range(300, 340):
        robot.drag((goal,) * 8)
    harness.wait(lambda: not robot.dragging)
    assert "Motor 5 did not accept speed" in str(robot.state.speed_error)
    robot.drag(HIGH)
    harness.simulator.do("servo 5 alive")
    harness.move((310,) * 8)
    assert harness.sent == [LOW, (310,) * 8]
    assert len(harness.messages) == 1
    assert "Motor 5 did not accept speed 200" in harness.messages[0]


def test_rejected_speeds_are_reported(robot: Robot, harness: RobotHarness) -> None:
    harness.simulator.do("line mute on")
    robot.set_speeds((200,) * 8)
    harness.wait(lambda: bool(harness.messages))
    assert harness.messages[0].startswith("Speeds not set: ")
    harness.simulator.do("line mute off")


def test_aborted_sequence_is_reported_with_its_cause(robot: Robot, harness: RobotHarness) -> None:
    harness.move(LOW)
    robot.play(Play(0, steps(HIGH, LOW), rounds=0))
    harness.wait(lambda: robot.state.step is not None and robot.state.step.round >= 1)
    harness.simulator.do("servo 3 dead")
    harness.wait(lambda: robot.state.play is None)
    assert len(harness.messages) == 1
    assert harness.messages[0].startswith("Aborted: ")
    assert "otor 3" in harness.messages[0]
    harness.simulator.do("servo 3 alive")


def test_time_scale_slows_running_sequence(robot: Robot, harness: RobotHarness) -> None:
    harness.move(LOW)
    robot.play(Play(0, steps(HIGH, LOW), rounds=3))
    robot.set_time_scale(10.0)
    harness.wait(lambda: robot.state.play is None)
    first, *_, last = [report.time for report in harness.of(Moving)[1:]]
    assert last - first > 4 * 10 * STEP_SECONDS


def test_move_is_logged_once_and_drag_is_not(robot: Robot, harness: RobotHarness) -> None:
    harness.move(LOW)
    logged = [event.text for event in robot.events.all]
    assert logged.count(f"Move to {', '.join(['300'] * 8)}.") == 1
    robot.start_drag()
    harness.drag(HIGH)
    robot.end_drag()
    assert [event.text for event in robot.events.all] == logged


def test_lost_reply_is_logged_once(robot: Robot, harness: RobotHarness) -> None:
    harness.move(HIGH)
    assert robot.move(LOW)
    harness.wait(lambda: robot.state.moving is not None)
    harness.simulator.do("line mute on")
    harness.wait(lambda: robot.state.reply_lost)
    texts = [event.text for event in robot.events.all]
    lost = [text for text in texts if "−1" in text or "reply was lost" in text]
    assert lost == ["The reply was lost, or no motor responds. The positions are unknown."]
    harness.simulator.do("line mute off")


def test_remaining_motion_time_counts_down(robot: Robot, harness: RobotHarness) -> None:
    harness.move((512,) * 8)
    robot.set_speeds((25,) * 8)
    robot.move((284,) * 8)
    harness.wait(lambda: robot.state.moving is not None)
    assert robot.remaining() == pytest.approx(4, abs=0.05), "228 units at speed 25 take 4 s"
    end = now() + 1
    harness.wait(lambda: now() >= end)
    assert robot.remaining() == pytest.approx(3, abs=0.05)
    harness.wait(lambda: robot.state.moving is None)
    assert robot.remaining() == 0


def steps(*goals: tuple[int, ...]) -> tuple[Step, ...]:
    return tuple(Step(goal, STEP_SECONDS, f"step {index}") for index, goal in enumerate(goals))


def test_clamped_steps_of_a_sequence_are_reported(robot: Robot, harness: RobotHarness) -> None:
    robot.play(Play(0, steps((0,) * 8, (500,) * 8, (1023,) * 8)))
    assert harness.messages == ["Clamped to the limits of the joints: 2 steps."]
    harness.wait(lambda: robot.state.play is None)
    assert [robot.limits.clamp(goals) for goals in harness.sent] == harness.sent


def test_halt_ends_playback_and_holds_reported_positions(
    robot: Robot, harness: RobotHarness
) -> None:
    harness.move(LOW)
    robot.targets.set(0, 350)
    robot.halt()
    assert robot.targets.goals == (350, *LOW[1:]), "a halt at rest does not change the goals"
    robot.play(Play(0, steps(HIGH, LOW), rounds=0))
    harness.wait(lambda: robot.state.step is not None and robot.state.step.round >= 1)
    robot.halt()
    halted = now()
    harness.wait(lambda: robot.state.play is None and robot.state.moving is None)
    sent_after = [each for each in harness.of(Moving) if each.time > halted]
    assert len(sent_after) <= 1  # a motion may already have been sent
    assert robot.targets.goals == robot.state.present
    assert harness.messages == []


def test_halt_now_ends_playback_from_other_thread(robot: Robot, harness: RobotHarness) -> None:
    harness.move(LOW)
    robot.play(Play(0, steps(HIGH, LOW), rounds=0))
    harness.wait(lambda: robot.state.step is not None and robot.state.step.round >= 1)
    thread = threading.Thread(target=robot.halt_now)
    thread.start()
    thread.join()
    harness.wait(lambda: robot.state.play is None)
    assert robot.link is ConnectionState.CONNECTED


def test_move_during_sequence_is_rejected(robot: Robot, harness: RobotHarness) -> None:
    harness.move(LOW)
    robot.play(Play(0, steps(HIGH, LOW), rounds=0))
    assert not robot.move((500,) * 8)
    assert harness.messages == ["A sequence is playing: stop it first."]
    robot.end_play()
    harness.wait(lambda: robot.state.play is None)
    assert (500,) * 8 not in harness.sent


def test_board_restart_is_reported_and_speeds_are_resent(
    robot: Robot, harness: RobotHarness
) -> None:
    robot.set_speeds((150,) * 8)
    harness.move(LOW)
    harness.links.clear()
    harness.simulator.do("power cycle")
    harness.wait(lambda: bool(harness.links))
    link, status = harness.links[0]
    assert link is ConnectionState.NOT_RESPONDING
    assert "restarted" in status
    harness.wait(lambda: robot.link is ConnectionState.CONNECTED)
    harness.move((310,) * 8)
    assert harness.speeds == [150] * 8


def test_unplugged_line_is_reported(robot: Robot, harness: RobotHarness) -> None:
    harness.move(LOW)
    harness.simulator.do("line unplug")
    harness.wait(lambda: robot.link is ConnectionState.DISCONNECTED)
    assert len(harness.messages) == 1
    assert robot.state.present == (None,) * 8
    assert not robot.move(LOW)
    assert "No robot is connected" in harness.messages[-1]


def test_two_motor_robot_has_two_goals_and_speeds(
    qtbot: QtBot, start_simulator: StartSimulator
) -> None:
    simulator = start_simulator("--aracna", "--unpaced", "--motors", "2")
    harness = RobotHarness(simulator, qtbot)
    harness.connect()
    robot = harness.robot
    assert robot.state.motors == len(robot.targets.goals) == len(robot.speeds) == 2
    harness.move((500, 500))
    assert robot.state.present == (500, 500)
    harness.end()
