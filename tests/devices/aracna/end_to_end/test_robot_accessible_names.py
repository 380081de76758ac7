"""What a screen reader finds on the robot's pages."""

from PySide6.QtWidgets import QAbstractButton, QWidget

from tests.support.accessible_names import assert_named
from tests.support.pages.robot import RobotWindow
from tests.support.window import WidgetDriver


def test_robot_widgets_have_accessible_names(connected_window: RobotWindow) -> None:
    window = connected_window
    window.click("aracnaLimitsBox")
    for index in range(window.window.pages.count()):
        window.window.pages.setCurrentIndex(index)
        assert_named(window.window)

    page = WidgetDriver(window.find(QWidget, "aracnaRobotPage"), window.qtbot)
    buttons = page.find_all(QAbstractButton)
    assert buttons
    assert all(button.objectName().startswith("aracna") for button in buttons)
