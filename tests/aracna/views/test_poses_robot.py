"""What the panel asks for, at a simulated robot in a process of its own."""

from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from tests.aracna.views.poses_stage import Stage
from tests.support.simulator import StartSimulator
from trex_gui.aracna.link.messages import Ending, Moving, PlayEnded
from trex_gui.aracna.model.robot import Robot
from trex_gui.aracna.poses.sequence import SequenceStep
from trex_gui.link.settings import LinkSettings
from trex_gui.link.timeouts import Timeouts
from trex_gui.model.connection import Link


class Wired(Stage):
    """A panel wired to a robot as the page does it, and what the robot reported."""

    def __init__(self, qtbot: QtBot, robot: Robot) -> None:
        super().__init__(qtbot)
        self.robot = robot
        self.reports: list[object] = []
        robot.reported.connect(self.reports.append)
        robot.refused.connect(self.said.append)
        self.panel.play_requested.connect(robot.play)
        self.panel.go_to_requested.connect(robot.move)
        self.panel.scale_changed.connect(robot.set_time_scale)
        robot.changed.connect(self.follow)
        robot.link_changed.connect(self.follow)
        self.follow()

    def follow(self) -> None:
        self.panel.show_link(self.robot.link is Link.UP)
        self.panel.show_present(self.robot.present)
        self.panel.show_playing(self.robot.playing)

    @property
    def endings(self) -> list[Ending]:
        return [report.why for report in self.reports if isinstance(report, PlayEnded)]

    @property
    def sent(self) -> list[tuple[int, ...]]:
        return [report.goals for report in self.reports if isinstance(report, Moving)]


@pytest.fixture
def wired(qtbot: QtBot, start_simulator: StartSimulator) -> Iterator[Wired]:
    simulator = start_simulator("--aracna", "--unpaced")
    robot = Robot()
    wired = Wired(qtbot, robot)
    robot.connect_to(LinkSettings(simulator.url, timeouts=Timeouts(extra=2.0)))
    qtbot.waitUntil(lambda: robot.link is Link.UP, timeout=15_000)
    robot.set_speeds((800,) * 8)
    yield wired
    robot.changed.disconnect(wired.follow)
    robot.link_changed.disconnect(wired.follow)
    wired.panel.close()
    wired.panel.deleteLater()
    robot.disconnect_line()
    qtbot.waitUntil(lambda: robot.link is Link.NONE, timeout=15_000)
    assert robot.shut_down()
    simulator.end()


def test_go_to_capture_and_play_work_together_at_a_robot(wired: Wired, qtbot: QtBot) -> None:
    wired.choose("aracnaPoses", "half-stand")
    wired.click("aracnaGoTo")
    qtbot.waitUntil(lambda: wired.robot.known.moved is not None, timeout=15_000)
    wired.click("aracnaCapture")
    wired.type_name(wired.names("aracnaPoses"), "here")
    here = wired.library.pose("here")
    assert here is not None
    assert here.positions == wired.robot.present

    wired.library.add_sequence("bob", [SequenceStep("stand", 300), SequenceStep("here", 300)])
    wired.choose("aracnaMotions", "bob")
    wired.check("aracnaBlendIn", False)
    wired.spin("aracnaRounds").setValue(2)
    wired.click("aracnaPlay")
    assert not wired.button("aracnaPlay").isEnabled()
    qtbot.waitUntil(lambda: wired.endings == [Ending.DONE], timeout=15_000)
    stand = (512, 550) * 4
    assert wired.sent[-4:] == [stand, here.positions] * 2
    qtbot.waitUntil(wired.button("aracnaPlay").isEnabled, timeout=15_000)
    assert wired.said == []


def test_a_loop_ends_after_its_step_when_a_person_wants_it(wired: Wired, qtbot: QtBot) -> None:
    wired.choose("aracnaPoses", "half-stand")
    wired.click("aracnaGoTo")
    qtbot.waitUntil(lambda: wired.robot.known.moved is not None, timeout=15_000)
    wired.choose("aracnaMotions", "push-ups (built in)")
    wired.check("aracnaLoop", True)
    wired.check("aracnaBlendIn", False)
    wired.spin("aracnaSpeedScale").setValue(400)
    wired.click("aracnaPlay")
    qtbot.waitUntil(lambda: len(wired.sent) >= 4, timeout=15_000)
    marked = [wired.steps.model().index(row, 0).data() for row in (0, 1)]
    assert sum(mark.startswith("▶") for mark in marked) == 1
    wired.robot.end_play()
    qtbot.waitUntil(lambda: wired.endings == [Ending.ENDED], timeout=15_000)
    assert wired.robot.playing is None
