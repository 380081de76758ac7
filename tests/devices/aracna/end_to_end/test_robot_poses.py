"""Poses and gaits with a connected robot."""

from collections.abc import Iterator

import pytest
from PySide6.QtWidgets import QPushButton, QSpinBox

from tests.support.pages.robot import POSES_PAGE, RobotWindow
from tests.support.program import aracna
from trex_gui.devices.aracna.session.messages import Moving
from trex_gui.ui.runtime import now


@pytest.fixture
def window(connected_window: RobotWindow) -> Iterator[RobotWindow]:
    yield connected_window
    aracna(connected_window.program).library.new()  # otherwise closing would prompt the user


def test_poses_page_explains_its_drawing_and_offers_one_end_button(window: RobotWindow) -> None:
    window.show_page(POSES_PAGE)
    caption = window.page_text("aracnaPosesPage", "aracnaCaption")
    assert "* The order of the legs is assumed" in caption
    buttons = window.find_all(QPushButton)
    ends = [
        each.objectName() for each in buttons if each.isVisible() and each.text().startswith("End")
    ]
    assert ends == ["aracnaEndButton"]


def test_gait_plays_until_stopped(window: RobotWindow) -> None:
    robot = window.robot
    window.move()
    window.show_page(POSES_PAGE)
    assert window.is_enabled("aracnaPlay"), "a gait is preselected"
    window.select_row("aracnaMotions", "push-ups")
    window.find(QSpinBox, "aracnaRounds").setValue(0)
    window.trigger("aracna_play")
    window.wait(lambda: robot.state.step is not None and robot.state.step.index == 1)
    assert "Playing" in window.text("aracnaMotionLabel")
    assert not window.is_enabled("aracnaPlay")
    reports: list[object] = []
    robot.reported.connect(reports.append)
    window.press_escape()
    stopped = now()  # a command sent earlier may be reported later
    window.wait(lambda: robot.state.play is None and robot.state.moving is None)
    motions = [report for report in reports if isinstance(report, Moving)]
    assert len([motion for motion in motions if motion.time > stopped]) <= 1
    assert window.is_enabled("aracnaPlay")
