"""Window for a TReX and an Aracna."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel
from pytestqt.qtbot import QtBot
from serial.tools.list_ports_common import ListPortInfo

from tests.support.pages.robot import RobotWindow
from tests.support.program import aracna, trex
from tests.support.simulator import SimulatedDevice
from tests.support.window import LEFT
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.widgets.behaviour import ConfirmButton


def assert_trex_workspace(window: RobotWindow) -> None:
    assert window.robot.link is ConnectionState.DISCONNECTED
    assert window.has("tabs")
    assert not window.has("aracnaTabs")
    assert window.menus == ["File", "Edit", "Device", "Window", "Help"]
    assert window.has("demoPanel")
    assert not window.has("aracnaDemoPanel")
    assert trex(window.program).controller.demo_in_use
    assert window.action("stop").text() == "&Stop motors"


def press_control(window: RobotWindow, key: Qt.Key) -> None:
    QTest.keyClick(window.window, key, Qt.KeyboardModifier.ControlModifier)


def test_workspace_follows_port(window: RobotWindow, qtbot: QtBot) -> None:
    qtbot.waitActive(window.window)
    board_tabs, robot_tabs = (
        trex(window.program).workspace.pages,
        aracna(window.program).workspace.pages,
    )
    window.select_demo("trex")
    assert_trex_workspace(window)
    press_control(window, Qt.Key.Key_2)
    assert (board_tabs.currentIndex(), robot_tabs.currentIndex()) == (1, 0)

    window.select_demo()
    assert window.device.link is ConnectionState.DISCONNECTED, "one device at a time"
    assert window.has("aracnaTabs")
    assert not window.has("tabs")
    assert window.menus == ["File", "Device", "Aracna", "Poses", "Window", "Help"]
    assert not window.has("demoPanel")
    assert window.has("aracnaDemoPanel")
    assert not trex(window.program).controller.demo_in_use
    status = window.find(QLabel, "statusLabel")
    assert status.text() == "Aracna"
    assert status.toolTip() == "Connected to Aracna: firmware 1, 8 motors."
    assert not window.is_enabled("lineButton")
    assert window.action("stop").text() == "&Stop sequence"
    press_control(window, Qt.Key.Key_3)
    assert (board_tabs.currentIndex(), robot_tabs.currentIndex()) == (1, 2)
    press_control(window, Qt.Key.Key_1)
    assert robot_tabs.currentIndex() == 0

    window.select_demo("trex")
    assert_trex_workspace(window)


def test_escape_stops_robot_from_each_page(connected_window: RobotWindow) -> None:
    window = connected_window
    halts: list[bool] = []
    window.robot.halted.connect(lambda: halts.append(True))
    for page in range(aracna(window.program).workspace.pages.count()):
        before = len(halts)
        aracna(window.program).workspace.pages.setCurrentIndex(page)
        window.press_escape()
        assert len(halts) > before, f"page {page}"


NONE = "Not connected"


def select_port(window: RobotWindow, label: str) -> None:
    combo = window.combo("portCombo")
    window.select("portCombo", combo.itemData(combo.findText(label, Qt.MatchFlag.MatchExactly)))


def test_connect_uses_selected_demo(computer: list[ListPortInfo], window: RobotWindow) -> None:
    computer.append(ListPortInfo("/dev/ttyNothing9"))  # the only port, which is preselected
    window.program.ports.refresh()
    assert window.port == "/dev/ttyNothing9"
    window.select_demo()
    window.press_disconnect()
    assert window.port == "Demo Aracna (no hardware)"
    window.press_connect()

    window.select_demo("trex")
    window.press_disconnect()
    assert window.port == "Demo TReX (no hardware)"
    window.trigger("connect")
    window.wait_until_up("trex")
    assert window.robot.link is ConnectionState.DISCONNECTED


@pytest.mark.qt_log_ignore("This plugin does not support")  # the offscreen platform opens no list
def test_port_list_keeps_selected_port(
    computer: list[ListPortInfo], window: RobotWindow, quick_simulator: SimulatedDevice
) -> None:
    ports = window.program.ports
    here, gone = ListPortInfo("/dev/ttyNothing8"), ListPortInfo("/dev/ttyNothing9")
    computer += [here, gone]
    ports.refresh()
    assert window.port == NONE
    select_port(window, "/dev/ttyNothing9")
    assert window.is_idle()
    window.click("connectButton")
    window.wait(window.is_idle)
    assert window.port == "/dev/ttyNothing9"
    assert "There is no port /dev/ttyNothing9" in window.text("bannerText")

    computer.remove(gone)
    ports.refresh()
    assert window.port == NONE, "the other port is not selected"
    computer.append(gone)
    ports.refresh()
    assert window.port == "/dev/ttyNothing9"

    window.connect(quick_simulator.url)
    select_port(window, quick_simulator.url)
    assert window.button("connectButton").text() == "Dis&connect"
    select_port(window, "/dev/ttyNothing8")
    assert window.button("connectButton").text() == "&Connect"
    select_port(window, NONE)
    ports.refresh()
    assert window.port == NONE
    assert window.device.link is ConnectionState.CONNECTED
    window.press_disconnect()
    assert window.port == NONE
    combo = window.combo("portCombo")
    window.click("connectButton")
    window.wait(lambda: combo.view().isVisible())
    assert window.is_idle()
    combo.hidePopup()
    select_port(window, quick_simulator.url)
    connect = window.button("connectButton")
    window.wait(lambda: window.find(ConfirmButton, "connectButton").accepts_clicks)
    QTest.mouseClick(connect, LEFT)
    QTest.mouseClick(connect, LEFT)
    window.wait_until_up("trex")
    window.press_disconnect()
    assert window.port == quick_simulator.url
