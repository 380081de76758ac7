"""What a screen reader finds on the robot's pages."""

from PySide6.QtWidgets import QAbstractButton, QWidget

from tests.support.accessible_names import assert_named
from tests.support.pages.robot import RobotWindow


def test_everything_of_the_robot_has_a_name(connected_window: RobotWindow) -> None:
    window = connected_window
    window.click("aracnaLimitsBox")
    for page in range(window.window.pages.count()):
        window.window.pages.setCurrentIndex(page)
        assert_named(window.window)

    buttons = window.find(QWidget, "aracnaRobotPage").findChildren(QAbstractButton)
    assert buttons
    assert all(button.objectName().startswith("aracna") for button in buttons)
