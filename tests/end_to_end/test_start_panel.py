"""First connection of a new user, and state that the next start restores."""

from collections.abc import Iterator
from contextlib import contextmanager

import pytest
from PySide6.QtCore import QCoreApplication, QRect
from PySide6.QtWidgets import QLabel, QPushButton, QSpinBox, QWidget
from pytestqt.qtbot import QtBot
from serial.tools.list_ports_common import ListPortInfo

from tests.support.keyboard import check_keyboard
from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.window import WindowDriver
from trex_gui.composition import build
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.frame.wiring_sketch import WiringSketch


@pytest.mark.usefixtures("computer")
def test_panel_shows_each_wiring_while_nothing_is_connected(window: WindowDriver) -> None:
    status = window.open_page("boardPage")
    assert status.find(QWidget, "startPanel").isVisible()
    assert not status.find(QWidget, "boardView").isVisible()
    assert status.find(QWidget, "startNoPort").isVisible()
    window.click("startFind")
    assert window.has("findDialog")
    window.dialog("findDialog").root.close()

    window.click("startDemo")
    window.wait(lambda: window.device.link is ConnectionState.CONNECTED)
    assert not status.find(QWidget, "startPanel").isVisible()
    drawing = status.find(QWidget, "boardView")
    assert drawing.isVisible()
    height = drawing.height()
    with window.qtbot.waitSignal(window.device.applied):
        window.click("timeoutButton")
    window.wait(lambda: not status.has("timeoutButton"))
    assert drawing.height() == height, "the space of the button remains"

    window.disconnect()
    assert status.find(QWidget, "startPanel").isVisible()
    for number, wires, jumpers in (
        (1, "TReX: TX – SI, RX – SO, GND – GND", "Mode: remove it. SO–G: remove it"),
        (2, "RS-232 port – TReX: TX, pin 3 – RX", "Mode: remove it"),
        (3, "Receiver – TReX: CH 1 – CH1", "Mode: set it to RC"),
    ):
        window.click(f"startWay{number}")
        check_keyboard(window.window)
        assert [each for each in (1, 2, 3) if window.has(f"wiringSketch{each}")] == [number]
        sketch = window.find(WiringSketch, f"wiringSketch{number}")
        assert wires in sketch.accessibleName()
        assert jumpers in sketch.spoken_state()


def test_plugged_in_port_is_offered_and_connected(
    computer: list[ListPortInfo], window: WindowDriver, simulator: SimulatedDevice
) -> None:
    adapter = ListPortInfo(simulator.url, skip_link_detection=True)
    adapter.description = "CP2102 & a very long name of a USB to UART bridge controller"
    computer.append(adapter)
    window.wait(lambda: not window.find(QWidget, "startNoPort").isVisible())
    panel = window.find(QWidget, "startPanel")
    button = next(b for b in panel.findChildren(QPushButton) if simulator.url in b.toolTip())
    assert adapter.description in button.toolTip()
    assert button.sizeHint().width() < panel.width() / 2
    button.click()
    window.wait(lambda: window.device.link is ConnectionState.CONNECTED)


@pytest.mark.usefixtures("computer")
def test_typed_address_is_listed_after_a_board_was_found(
    window: WindowDriver, start_simulator: StartSimulator
) -> None:
    window.program.ports.add_typed("socket://nowhere:1")
    board = start_simulator("--unpaced")
    typed = window.program.ports.add_typed(board.url)
    assert not window.has("startPort")
    window.connect_port(typed)
    window.wait(lambda: window.device.link is ConnectionState.CONNECTED)
    window.disconnect()
    window.click("startPort")
    window.wait(lambda: window.device.link is ConnectionState.CONNECTED)
    port = window.program.device_manager.current.port
    assert port is not None
    assert port.url == board.url


def test_start_panel_of_the_robot_connects_robots(
    computer: list[ListPortInfo], window: WindowDriver, start_simulator: StartSimulator
) -> None:
    robot = start_simulator("--aracna", "--unpaced")
    computer.append(ListPortInfo(robot.url, skip_link_detection=True))
    window.program.ports.refresh()
    window.program.device_manager.switch_to("aracna", lambda: None)
    panel = window.find(QWidget, "aracna_startPanel")
    assert panel.isVisible()
    assert "servo power" in window.text("aracna_startNote1")
    assert not window.has("aracnaSlider1")
    window.click("aracna_start_aracna_offline")
    assert not panel.isVisible()
    assert not window.is_enabled("aracnaMoveButton")
    window.type_into("aracnaGoal1", "300")
    window.connect_to_demo("aracna")
    assert window.find(QSpinBox, "aracnaGoal1").value() == 300

    window.disconnect()
    window.click("aracna_startDemo")
    window.wait(lambda: window.robot.link is ConnectionState.CONNECTED)
    assert not panel.isVisible()
    assert window.has("aracnaMoveButton")

    window.program.device_manager.disconnect_device()
    window.wait(lambda: window.has("aracna_startPort"))
    window.click("aracna_startPort")
    window.wait(lambda: window.robot.link is ConnectionState.CONNECTED)
    port = window.program.device_manager.current.port
    assert port is not None
    assert port.url == robot.url


@contextmanager
def start(qtbot: QtBot) -> Iterator[WindowDriver]:
    """Run the program. It ends like a crash unless its window is closed."""
    program = build()
    program.window.show()
    program.complete()
    try:
        yield WindowDriver(program, qtbot)
        QCoreApplication.processEvents()
    finally:
        program.window.hide()
        assert program.close(), "a thread of the program is still running"


@pytest.mark.parametrize("is_closed", [True, False])
def test_device_and_pages_are_restored_at_the_next_start(
    qtbot: QtBot, quick_simulator: SimulatedDevice, is_closed: bool
) -> None:
    geometry = QRect(50, 60, 1000, 650)
    with start(qtbot) as window:
        window.window.setGeometry(geometry)
        window.open_page("motorsPage")
        window.program.device_manager.switch_to("aracna", lambda: None)
        window.open_page("aracnaPosesPage")
        if is_closed:
            assert window.window.close()
    with start(qtbot) as window:
        assert window.has("aracnaPosesPage")
        assert window.program.device_manager.current.plugin.key == "aracna"
        if is_closed:
            assert window.window.geometry() == geometry
        window.connect(quick_simulator.url)
        assert window.has("motorsPage")
        assert window.window.close()
    with start(qtbot) as window:
        assert window.has("motorsPage")
        assert window.device.link is ConnectionState.DISCONNECTED


def test_focus_moves_to_the_next_useful_control(window: WindowDriver) -> None:
    def focused() -> QWidget | None:
        return window.window.focusWidget()

    connect, tabs = window.button("connectButton"), window.window.pages.tabBar()
    assert focused() is connect
    window.open_page("boardPage")
    window.button("startDemo").setFocus()
    window.click("startDemo")
    window.wait(lambda: window.device.link is ConnectionState.CONNECTED)
    assert focused() is tabs
    connect.setFocus()
    window.click("connectButton")
    window.wait(lambda: window.device.link is ConnectionState.DISCONNECTED)
    assert focused() is connect


def test_board_name_is_not_cut_beside_the_demo_panel(window: WindowDriver) -> None:
    window.click("startDemo")
    window.wait(lambda: window.device.link is ConnectionState.CONNECTED)
    window.window.resize(1024, 600)
    name = window.find(QLabel, "statusLabel")
    window.wait(lambda: name.text().startswith("TReX 1.2"))
    window.wait(lambda: not window.find(QWidget, "lineButton").isVisible())
    assert name.width() >= name.sizeHint().width()
    window.window.resize(1600, 900)
    window.wait(lambda: window.find(QWidget, "lineButton").isVisible())
