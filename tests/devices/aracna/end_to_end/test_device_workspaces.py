"""One window for a TReX and an Aracna: the workspace is that of the port."""

from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from tests.support.pages.robot import RobotWindow
from tests.support.program import aracna, trex
from trex_gui.ui.devices.connection import ConnectionState

TREX_MENUS = ["File", "Edit", "Device", "Window", "Help"]
ARACNA_MENUS = ["File", "Device", "Aracna", "Poses", "Window", "Help"]


def assert_trex_workspace(window: RobotWindow) -> None:
    assert window.robot.link is ConnectionState.DISCONNECTED
    assert window.has("tabs")
    assert not window.has("aracnaTabs")
    assert window.menus == TREX_MENUS
    assert window.has("demoPanel")
    assert not window.has("aracnaDemoPanel")
    assert trex(window.program).controller.demo_in_use


def assert_robot_workspace(window: RobotWindow) -> None:
    assert window.device.link is ConnectionState.DISCONNECTED, "one device at a time"
    assert window.has("aracnaTabs")
    assert not window.has("tabs")
    assert window.menus == ARACNA_MENUS
    assert not window.has("demoPanel")
    assert window.has("aracnaDemoPanel")
    assert not trex(window.program).controller.demo_in_use
    assert window.text("statusLabel") == "Connected to Aracna: firmware 1, 8 motors."
    assert not window.is_enabled("lineButton")


def press_control(window: RobotWindow, key: Qt.Key) -> None:
    QTest.keyClick(window.window, key, Qt.KeyboardModifier.ControlModifier)


def test_workspace_follows_port(window: RobotWindow, qtbot: QtBot) -> None:
    qtbot.waitActive(window.window)
    board_tabs, robot_tabs = (
        trex(window.program).workspace.pages,
        aracna(window.program).workspace.pages,
    )
    window.choose_demo("trex")
    assert_trex_workspace(window)
    assert window.action("stop").text() == "&Stop motors"
    press_control(window, Qt.Key.Key_2)
    assert (board_tabs.currentIndex(), robot_tabs.currentIndex()) == (1, 0)

    window.choose_demo()
    assert_robot_workspace(window)
    assert window.action("stop").text() == "&Stop sequence"
    press_control(window, Qt.Key.Key_3)
    assert (board_tabs.currentIndex(), robot_tabs.currentIndex()) == (1, 2)
    press_control(window, Qt.Key.Key_1)
    assert robot_tabs.currentIndex() == 0

    window.choose_demo("trex")
    assert_trex_workspace(window)
    assert window.action("stop").text() == "&Stop motors"
    board, robot = window.device.connection.traffic, window.robot.traffic
    for traffic in (board, robot):
        traffic.pull()
    assert any(row.sent == b"\x81" for row in board.everything.rows)
    assert robot.everything.rows[-1].note == "Closed."
    assert {row.sent for row in robot.everything.rows} <= {b"", b".q\n", b"\n"}


def test_escape_stops_robot_from_each_page(connected_window: RobotWindow) -> None:
    window = connected_window
    halts: list[bool] = []
    window.robot.halted.connect(lambda: halts.append(True))
    for page in range(aracna(window.program).workspace.pages.count()):
        before = len(halts)
        aracna(window.program).workspace.pages.setCurrentIndex(page)
        window.press_escape()
        assert len(halts) > before, f"page {page}"

    window.press_disconnect()
    assert window.has("aracnaTabs")
    assert not window.is_enabled("aracnaMoveButton")
    window.window.pages.setCurrentIndex(0)
    assert window.has("aracna_startPanel")
    assert not window.button("aracnaMoveButton").isVisible()
    window.choose_demo()
