"""Driver of the gamepad panel on the Motors page."""

from typing import Generic, TypeVar

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDialog
from pytestqt.qtbot import QtBot

from tests.gamepad.virtual_pad import VirtualPad
from tests.support.pads import HeldPads
from tests.support.window import WidgetDriver
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.views.pages.motors.gamepad_panel import GamepadPanel
from trex_gui.gamepad.profile import GamepadProfile

Y = 1
"""Axis that drives forward."""

PadsT = TypeVar("PadsT", bound=HeldPads | VirtualPad)


class GamepadPanelPage(WidgetDriver, Generic[PadsT]):
    """Gamepad panel, in the main window or alone, and its gamepad."""

    def __init__(self, panel: GamepadPanel, device: Device, pads: PadsT, qtbot: QtBot) -> None:
        super().__init__(panel, qtbot)
        self.gamepad = panel.gamepad
        self.motors = device.motors
        self.motors.lockout = 0
        self.pads = pads

    @property
    def profile(self) -> GamepadProfile:
        return self.gamepad.profile

    def select_text(self, name: str, part: str) -> None:
        """Select the entry of a combo box that contains a text."""
        combo = self.combo(name)
        index = combo.findText(part, Qt.MatchFlag.MatchContains)
        assert index >= 0, [combo.itemText(row) for row in range(combo.count())]
        self.select(name, combo.itemData(index))

    def wait_for_state(self, part: str) -> None:
        self.wait_for_text("gamepadState", part)

    def drive(self) -> None:
        """Arm the motors and drive forward at full speed."""
        self.motors.arm()
        self.wait_for_state("Hold")
        assert self.profile.hold is not None
        self.pads.press(self.profile.hold)
        self.wait_for_state("Driving")
        self.pads.move(Y, -1.0)
        self.wait(lambda: self.motors.drive(1) is not None)
        assert self.motors.holder == "gamepad"

    def open_set_up(self) -> None:
        self.click("gamepadSetUpButton")
        self.wait(self.find(QDialog, "gamepadDialog").isVisible)
        self.wait(lambda: self.gamepad.state is not None)
