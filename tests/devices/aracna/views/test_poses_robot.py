"""What the panel asks for, at a simulated robot in a process of its own."""

from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from tests.devices.aracna.views.poses_stage import PosesPageDriver
from tests.support.simulator import StartSimulator
from trex_gui.core.timing import Timeouts
from trex_gui.core.transport.settings import PortSettings
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.poses.project import SequenceStep
from trex_gui.devices.aracna.session.messages import Ending, Moving, PlayEnded
from trex_gui.ui.devices.connection import ConnectionState


class ConnectedPageDriver(PosesPageDriver):
    """A page on a robot, and what the robot reported."""

    def __init__(self, qtbot: QtBot, robot: Robot) -> None:
        super().__init__(qtbot, robot)
        self.robot = robot
        self.reports: list[object] = []
        robot.reported.connect(self.reports.append)

    @property
    def endings(self) -> list[Ending]:
        return [report.why for report in self.reports if isinstance(report, PlayEnded)]

    @property
    def sent(self) -> list[tuple[int, ...]]:
        return [report.goals for report in self.reports if isinstance(report, Moving)]


@pytest.fixture
def driver(qtbot: QtBot, start_simulator: StartSimulator) -> Iterator[ConnectedPageDriver]:
    simulator = start_simulator("--aracna", "--unpaced")
    robot = Robot()
    driver = ConnectedPageDriver(qtbot, robot)
    robot.open(PortSettings(simulator.url, timeouts=Timeouts(extra=2.0)))
    qtbot.waitUntil(lambda: robot.link is ConnectionState.CONNECTED, timeout=15_000)
    robot.set_speeds((800,) * 8)
    yield driver
    robot.close()
    qtbot.waitUntil(lambda: robot.link is ConnectionState.DISCONNECTED, timeout=15_000)
    assert robot.shut_down()
    driver.close()
    simulator.end()


def test_go_to_capture_and_play_work_with_simulated_robot(
    driver: ConnectedPageDriver, qtbot: QtBot
) -> None:
    driver.choose_row("aracnaPoses", "half-stand")
    driver.click("aracnaGoTo")
    qtbot.waitUntil(lambda: driver.robot.state.moved is not None, timeout=15_000)
    driver.click("aracnaCapture")
    driver.type_name("aracnaPoses", "here")
    here = driver.library.project.pose("here")
    assert here is not None
    assert here.positions == driver.robot.state.present

    driver.library.add_sequence("bob", [SequenceStep("stand", 300), SequenceStep("here", 300)])
    driver.choose_row("aracnaMotions", "bob")
    driver.check("aracnaBlendIn", False)
    driver.spin("aracnaRounds").setValue(2)
    driver.click("aracnaPlay")
    assert not driver.button("aracnaPlay").isEnabled()
    qtbot.waitUntil(lambda: driver.endings == [Ending.DONE], timeout=15_000)
    stand = (512, 550) * 4
    assert driver.sent[-4:] == [stand, here.positions] * 2
    qtbot.waitUntil(driver.button("aracnaPlay").isEnabled, timeout=15_000)
    assert all(text.startswith("Cropped") for text in driver.messages)


def test_end_play_ends_loop_after_current_step(driver: ConnectedPageDriver, qtbot: QtBot) -> None:
    driver.choose_row("aracnaPoses", "half-stand")
    driver.click("aracnaGoTo")
    qtbot.waitUntil(lambda: driver.robot.state.moved is not None, timeout=15_000)
    driver.choose_row("aracnaMotions", "push-ups (built in)")
    driver.check("aracnaLoop", True)
    driver.check("aracnaBlendIn", False)
    driver.spin("aracnaSpeedScale").setValue(400)
    driver.click("aracnaPlay")
    qtbot.waitUntil(lambda: len(driver.sent) >= 4, timeout=15_000)
    marked = [driver.steps.model().index(row, 0).data() for row in (0, 1)]
    assert sum(mark.startswith("▶") for mark in marked) == 1
    driver.robot.end_play()
    qtbot.waitUntil(lambda: driver.endings == [Ending.ENDED], timeout=15_000)
    assert driver.robot.state.play is None
