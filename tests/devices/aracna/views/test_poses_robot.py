"""What the panel asks for, at a simulated robot in a process of its own."""

from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from tests.devices.aracna.views.poses_stage import PosesPanelDriver
from tests.support.simulator import StartSimulator
from trex_gui.core.timing import Timeouts
from trex_gui.core.transport.settings import PortSettings
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.poses.project import SequenceStep
from trex_gui.devices.aracna.session.messages import Ending, Moving, PlayEnded
from trex_gui.ui.devices.connection_state import ConnectionState


class ConnectedPanelDriver(PosesPanelDriver):
    """A panel wired to a robot as the page does it, and what the robot reported."""

    def __init__(self, qtbot: QtBot, robot: Robot) -> None:
        super().__init__(qtbot)
        self.robot = robot
        self.reports: list[object] = []
        robot.reported.connect(self.reports.append)
        robot.notifier.error.connect(self.messages.append)
        self.panel.play_requested.connect(robot.play)
        self.panel.go_to_requested.connect(robot.move)
        self.panel.scale_changed.connect(robot.set_time_scale)
        robot.changed.connect(self.follow)
        robot.link_changed.connect(self.follow)
        self.follow()

    def follow(self) -> None:
        self.panel.show_link(self.robot.link is ConnectionState.CONNECTED)
        self.panel.show_present(self.robot.state.present)
        self.panel.show_playing(self.robot.state.playing)

    @property
    def endings(self) -> list[Ending]:
        return [report.why for report in self.reports if isinstance(report, PlayEnded)]

    @property
    def sent(self) -> list[tuple[int, ...]]:
        return [report.goals for report in self.reports if isinstance(report, Moving)]


@pytest.fixture
def driver(qtbot: QtBot, start_simulator: StartSimulator) -> Iterator[ConnectedPanelDriver]:
    simulator = start_simulator("--aracna", "--unpaced")
    robot = Robot()
    driver = ConnectedPanelDriver(qtbot, robot)
    robot.open(PortSettings(simulator.url, timeouts=Timeouts(extra=2.0)))
    qtbot.waitUntil(lambda: robot.link is ConnectionState.CONNECTED, timeout=15_000)
    robot.set_speeds((800,) * 8)
    yield driver
    robot.changed.disconnect(driver.follow)
    robot.link_changed.disconnect(driver.follow)
    driver.close()
    robot.close()
    qtbot.waitUntil(lambda: robot.link is ConnectionState.DISCONNECTED, timeout=15_000)
    assert robot.shut_down()
    simulator.end()


def test_go_to_capture_and_play_work_with_simulated_robot(
    driver: ConnectedPanelDriver, qtbot: QtBot
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
    assert driver.messages == []


def test_end_play_ends_loop_after_current_step(driver: ConnectedPanelDriver, qtbot: QtBot) -> None:
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
    assert driver.robot.state.playing is None
