"""What the list of ports shows is what Connect connects to, whichever device it leads to."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from serial.tools.list_ports_common import ListPortInfo

from tests.support.pages.robot import RobotWindow
from tests.support.simulator import SimulatedDevice
from tests.support.window import LEFT
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.widgets.behaviour import ConfirmButton

DEMO_TREX, DEMO_ARACNA = "Demo TReX (no hardware)", "Demo Aracna (no hardware)"
NONE = "Not connected"


@pytest.fixture
def computer(monkeypatch: pytest.MonkeyPatch) -> list[ListPortInfo]:
    """Serial ports of this computer; a test plugs adapters in. Ask for it before the window."""
    ports: list[ListPortInfo] = []
    monkeypatch.setattr("serial.tools.list_ports.comports", lambda: ports)
    return ports


def choose(window: RobotWindow, label: str) -> None:
    """Choose an entry of the list of ports."""
    combo = window.combo("portCombo")
    window.select("portCombo", combo.itemData(combo.findText(label, Qt.MatchFlag.MatchExactly)))


def test_connect_uses_selected_demo(computer: list[ListPortInfo], window: RobotWindow) -> None:
    computer.append(ListPortInfo("/dev/ttyNothing9"))  # the only port: what is offered first
    window.program.ports.refresh()
    assert window.port == "/dev/ttyNothing9"
    window.choose_demo()
    window.press_disconnect()
    assert window.port == DEMO_ARACNA
    window.press_connect()

    window.choose_demo("trex")
    assert window.port == DEMO_TREX
    window.choose_demo()
    assert window.port == DEMO_ARACNA
    window.press_disconnect()
    assert window.port == DEMO_ARACNA

    window.choose_demo("trex")
    window.press_disconnect()
    assert window.port == DEMO_TREX
    window.trigger("connect")
    window.wait_until_up("trex")
    assert window.robot.link is ConnectionState.DISCONNECTED
    window.press_disconnect()
    window.press_connect("trex")


@pytest.mark.qt_log_ignore("This plugin does not support")  # offscreen opens no list
def test_port_list_keeps_selected_port(
    computer: list[ListPortInfo], window: RobotWindow, quick_simulator: SimulatedDevice
) -> None:
    ports = window.program.ports
    here, gone = ListPortInfo("/dev/ttyNothing8"), ListPortInfo("/dev/ttyNothing9")
    computer += [here, gone]
    ports.refresh()
    assert window.port == NONE
    choose(window, "/dev/ttyNothing9")
    assert window.is_idle()
    window.click("connectButton")
    window.wait(window.is_idle)
    assert window.port == "/dev/ttyNothing9"
    assert "There is no port /dev/ttyNothing9" in window.text("bannerText")

    computer.remove(gone)
    ports.refresh()
    assert window.port == NONE, "the other one was not chosen"
    computer.append(gone)
    ports.refresh()
    assert window.port == "/dev/ttyNothing9"

    window.connect(quick_simulator.url)
    choose(window, quick_simulator.url)
    assert window.button("connectButton").text() == "Dis&connect"
    choose(window, "/dev/ttyNothing8")
    assert window.button("connectButton").text() == "&Connect"
    choose(window, NONE)
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
    choose(window, quick_simulator.url)
    connect = window.button("connectButton")
    window.wait(lambda: window.find(ConfirmButton, "connectButton").takes_clicks)
    QTest.mouseClick(connect, LEFT)
    QTest.mouseClick(connect, LEFT)
    window.wait_until_up("trex")
    window.press_disconnect()
    assert window.port == quick_simulator.url
