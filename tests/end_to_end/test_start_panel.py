"""First connection of a new user, and state that is restored at the next start."""

from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager

import pytest
from PySide6.QtCore import QCoreApplication, QRect
from PySide6.QtWidgets import QApplication, QLabel, QPushButton, QSpinBox, QWidget
from pytestqt.qtbot import QtBot
from serial.tools.list_ports_common import ListPortInfo

from tests.support.keyboard import check_keyboard
from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.window import WindowDriver
from trex_gui.composition import build
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.frame.wiring_sketch import WiringSketch
from trex_gui.ui.theme.theme import theme


@pytest.mark.usefixtures("computer")
def test_panel_shows_each_wiring_without_connection(window: WindowDriver) -> None:
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
    assert drawing.height() == height, "the button keeps its room"

    window.disconnect()
    assert status.find(QWidget, "startPanel").isVisible()
    for way, wires, jumpers in (
        (1, "TReX: TX – SI, RX – SO, GND – GND", "Mode: remove it. SO–G: remove it"),
        (2, "RS-232 port – TReX: TX, pin 3 – RX", "Mode: remove it"),
        (3, "Receiver – TReX: CH 1 – CH1", "Mode: set it to RC"),
    ):
        window.click(f"startWay{way}")
        check_keyboard(window.window)
        shown = [number for number in (1, 2, 3) if window.has(f"wiringSketch{number}")]
        assert shown == [way]
        sketch = window.find(WiringSketch, f"wiringSketch{way}")
        assert wires in sketch.accessibleName()
        assert jumpers in sketch.spoken_state()


def test_first_start_leads_to_a_turning_motor_in_four_clicks(window: WindowDriver) -> None:
    window.click("startDemo")
    window.wait(lambda: window.device.link is ConnectionState.CONNECTED)
    window.open_page("motorsPage")
    window.click("runButton")
    window.wait(lambda: window.is_enabled("motor1Slider"))
    window.drag("motor1Slider", 30, release=False)
    window.wait(lambda: "motor 1 +" in window.motors.text)


def test_port_that_is_plugged_in_is_offered_and_connected(
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
def test_typed_address_is_listed_once_a_board_was_found_there(
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


def test_panel_of_the_robot_leads_to_robots(
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


Start = Callable[[], AbstractContextManager[WindowDriver]]


@pytest.fixture
def start(qtbot: QtBot, qapp: QApplication) -> Start:
    """Start the program. Unless its window is closed, it ends like a crash."""
    theme().install(qapp)

    @contextmanager
    def started() -> Iterator[WindowDriver]:
        program = build()
        program.window.show()
        program.complete()
        try:
            yield WindowDriver(program, qtbot)
            QCoreApplication.processEvents()
        finally:
            program.window.hide()
            assert program.close(), "a thread of the program lives on"

    return started


@pytest.mark.parametrize("is_closed", [True, False])
def test_device_and_pages_return(
    start: Start, quick_simulator: SimulatedDevice, is_closed: bool
) -> None:
    place = QRect(50, 60, 1000, 650)
    with start() as window:
        window.window.setGeometry(place)
        window.open_page("motorsPage")
        window.program.device_manager.switch_to("aracna", lambda: None)
        window.open_page("aracnaPosesPage")
        if is_closed:
            assert window.window.close()
    with start() as window:
        assert window.has("aracnaPosesPage")
        assert window.program.device_manager.current.plugin.key == "aracna"
        if is_closed:
            assert window.window.geometry() == place
        window.connect(quick_simulator.url)
        assert window.has("motorsPage")
        assert window.window.close()
    with start() as window:
        assert window.has("motorsPage")
        assert window.device.link is ConnectionState.DISCONNECTED


def test_focus_goes_where_the_next_key_is_wanted(window: WindowDriver) -> None:
    def focused() -> QWidget | None:
        return window.window.focusWidget()

    connect, places = window.button("connectButton"), window.window.pages.tabBar()
    assert focused() is connect
    window.open_page("boardPage")
    window.button("startDemo").setFocus()
    window.click("startDemo")
    window.wait(lambda: window.device.link is ConnectionState.CONNECTED)
    assert focused() is places
    connect.setFocus()
    window.click("connectButton")
    window.wait(lambda: window.device.link is ConnectionState.DISCONNECTED)
    assert focused() is connect


def test_name_of_the_board_is_whole_beside_the_demo_panel(window: WindowDriver) -> None:
    window.click("startDemo")
    window.wait(lambda: window.device.link is ConnectionState.CONNECTED)
    window.window.resize(1024, 600)
    name = window.find(QLabel, "statusLabel")
    window.wait(lambda: name.text().startswith("TReX 1.2"))
    window.wait(lambda: not window.find(QWidget, "lineButton").isVisible())
    assert name.width() >= name.sizeHint().width()
    window.window.resize(1600, 900)
    window.wait(lambda: window.find(QWidget, "lineButton").isVisible())
