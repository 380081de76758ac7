"""Poses and gaits with a connected robot."""

from collections.abc import Iterator

import pytest
from PySide6.QtWidgets import QPushButton, QSpinBox

from tests.support.pages.robot import POSES_PAGE, RobotWindow
from tests.support.program import aracna


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
    window.press_escape()
    window.wait(lambda: robot.state.play is None and robot.state.moving is None)
    assert window.is_enabled("aracnaPlay")
