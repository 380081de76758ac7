"""Drawing of the robot with clickable wheels."""

from PySide6.QtCore import QTimer
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from tests.support.window import LEFT
from trex_gui.devices.trex.model.setup.wiring import Movement, Side
from trex_gui.devices.trex.views.robot_view import RobotView, WheelPart


def test_clicked_half_of_a_wheel_is_reported_and_filled(qtbot: QtBot) -> None:
    robot, clicked = RobotView(with_buttons=True), list[Movement]()
    qtbot.addWidget(robot)
    robot.wheel_clicked.connect(clicked.append)
    robot.show()
    parts = {part.accessibleName(): part for part in robot.findChildren(WheelPart)}
    for name in ("Right wheel, backward", "Left wheel, forward"):
        QTest.mouseClick(parts[name], LEFT)
        assert [checked for checked, part in parts.items() if part.isChecked()] == [name]
    assert clicked == [Movement.RIGHT_BACKWARD, Movement.LEFT_FORWARD]


def test_treads_move_only_while_a_wheel_turns(qtbot: QtBot) -> None:
    robot = RobotView()
    qtbot.addWidget(robot)
    robot.show()
    timer = robot.findChild(QTimer)
    assert timer is not None
    robot.show_wheel(Side.LEFT, -0.5, "motor1")
    assert robot.spoken_state() == "Left wheel, backward"
    qtbot.waitUntil(timer.isActive)
    robot.show_wheel(Side.LEFT, 0.0, "motor1")
    qtbot.waitUntil(lambda: not timer.isActive())
