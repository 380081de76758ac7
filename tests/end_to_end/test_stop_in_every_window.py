"""Windows that may cover the main one stop the motors with the mouse, too."""

from pathlib import Path

from PySide6.QtGui import QAccessible
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QPushButton, QWidget

from tests.support.pages.every_window import WINDOWS_WITH_STOP, stop_button
from tests.support.pages.motors import BRAKE, MotorsPage
from tests.support.simulator import SimulatedDevice
from tests.support.window import LEFT, WindowDriver
from trex_gui.ui.devices.connection import ConnectionState


def spoken(button: QAbstractButton) -> str:
    return QAccessible.queryAccessibleInterface(button).text(QAccessible.Text.Name)


def test_stop_button_of_every_window_stops_motors(
    connected_window: WindowDriver, quick_simulator: SimulatedDevice, tmp_path: Path
) -> None:
    page = MotorsPage(connected_window, quick_simulator)
    page.motors.lockout = 0
    page.motors.accelerate = False
    assert spoken(page.button("stopButton")) == "Stop motors"
    opened: list[tuple[QWidget, QPushButton]] = []
    for open_window in WINDOWS_WITH_STOP:
        case = open_window.__name__
        window = open_window(page, tmp_path)
        page.wait(window.isVisible)
        assert not window.isModal(), case
        button = stop_button(window)
        assert spoken(button) == "Stop motors", case
        page.motors.arm()
        page.motors.set_speed(1, 60)
        page.wait_for_targets(("forward", 60), None, case)
        QTest.mousePress(button, LEFT)
        page.wait_for_targets(BRAKE, BRAKE, case)
        page.wait(lambda: quick_simulator.show()["motors"][0]["direction"] == "brake")
        assert not page.is_armed(), case
        QTest.mouseRelease(button, LEFT)
        opened.append((window, button))

    page.device.disconnect_line()
    page.wait(lambda: page.device.link is ConnectionState.DISCONNECTED)
    for window, button in opened:
        assert not button.isEnabled(), window.objectName()
        window.close()
