"""Dialog that arms a board without a serial timeout."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QPushButton, QWidget
from pytestqt.qtbot import QtBot

from tests.support.keyboard import check_keyboard
from tests.support.simulator import SimulatedDevice
from tests.support.window import WidgetDriver
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.views.motor_controls import ArmButton, ArmDialog
from trex_gui.ui.theme.theme import theme


class ArmingDriver(WidgetDriver):
    """Window that contains only the *Arm motors* button."""

    def __init__(self, device: Device, simulator: SimulatedDevice, qtbot: QtBot) -> None:
        super().__init__(QWidget(), qtbot)
        self.device, self.simulator = device, simulator
        ArmButton(device, "runButton", self.root)
        qtbot.addWidget(self.root)
        self.root.show()

    def connect(self, *, name: str = "") -> None:
        self.device.connect_to(ConnectionSettings(self.simulator.url, name=name))
        self.wait(lambda: self.device.motors.can_arm)

    def open_dialog(self) -> WidgetDriver:
        """Click the button. Return the dialog that opens."""
        self.click("runButton")
        return WidgetDriver(self.find_only(ArmDialog), self.qtbot)

    def stored(self) -> tuple[int, int]:
        parameters = self.simulator.show()["parameters"]
        return parameters["serial_timeout"], parameters["uart_error_shutdown"]


@pytest.fixture
def arming(
    quick_simulator: SimulatedDevice, qtbot: QtBot, qapp: QApplication
) -> Iterator[ArmingDriver]:
    theme().install(qapp)
    device = Device()
    yield ArmingDriver(device, quick_simulator, qtbot)
    device.disconnect_line()
    qtbot.waitUntil(device.shut_down)


@pytest.mark.parametrize("command", ["eeprom serial_timeout 0", "eeprom uart_error_shutdown 0"])
def test_both_settings_are_written_before_arming(arming: ArmingDriver, command: str) -> None:
    arming.simulator.do("eeprom serial_timeout 5", command, "power cycle")
    arming.connect()
    dialog = arming.open_dialog()
    check_keyboard(dialog.root)
    assert dialog.find(QPushButton, "writeAndArmButton").isDefault()
    dialog.click("writeAndArmButton")
    assert not arming.device.motors.armed, "the settings are not written yet"
    arming.wait(lambda: arming.device.motors.armed)
    assert arming.stored() == (5, 1)


def test_arming_without_timeout_is_remembered(arming: ArmingDriver) -> None:
    arming.connect()
    arming.open_dialog().click("armWithoutButton")
    assert arming.device.motors.armed
    assert arming.stored() == (0, 1)
    arming.device.motors.stop()
    arming.wait(lambda: arming.device.motors.can_arm)
    arming.click("runButton")
    assert arming.device.motors.armed


def test_failed_write_arms_nothing(arming: ArmingDriver) -> None:
    arming.connect()
    dialog = arming.open_dialog()
    arming.simulator.do("eeprom motor1_acceleration 9")  # by another program
    dialog.click("writeAndArmButton")
    dialog.wait(lambda: dialog.text("armNote") not in {"", "Writing …"})
    assert not arming.device.motors.armed
    assert dialog.is_enabled("writeAndArmButton")


def test_demo_board_is_armed_without_a_dialog(arming: ArmingDriver) -> None:
    arming.connect(name="Demo")
    arming.click("runButton")
    assert arming.device.motors.armed


def test_key_or_click_after_a_stop_does_not_arm_again(arming: ArmingDriver) -> None:
    arming.connect(name="Demo")
    motors, button = arming.device.motors, arming.find(ArmButton, "runButton")

    def is_armed() -> bool:
        return motors.armed

    arming.click("runButton")
    assert is_armed()
    button.setFocus()
    for _ in range(2):
        QTest.keyClick(button, Qt.Key.Key_Space)
    assert not is_armed()

    arming.wait(lambda: motors.can_arm and button.accepts_clicks)
    arming.click("runButton")
    assert is_armed()
    arming.wait(lambda: button.accepts_clicks)
    QTest.mousePress(button, Qt.MouseButton.LeftButton)
    motors.stop("The board restarted.")
    QTest.mouseRelease(button, Qt.MouseButton.LeftButton)
    assert not is_armed()
