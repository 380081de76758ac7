"""What a screen reader finds on the robot's pages."""

import sys

import pytest
from PySide6.QtWidgets import QAbstractButton, QWidget

from tests.end_to_end.test_names_for_a_screen_reader import assert_named
from tests.support.pages.robot import RobotWindow

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")


def test_everything_of_the_robot_has_a_name(connected_window: RobotWindow) -> None:
    window = connected_window
    window.click("aracnaLimitsBox")
    for page in range(window.window.pages.count()):
        window.window.pages.setCurrentIndex(page)
        assert_named(window.window)

    buttons = window.find(QWidget, "aracnaRobotPage").findChildren(QAbstractButton)
    assert buttons
    assert all(button.objectName().startswith("aracna") for button in buttons)
