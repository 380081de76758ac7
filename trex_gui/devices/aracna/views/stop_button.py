"""The red button of the robot, below its pages and in windows that may cover them."""

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QWidget

from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.widgets.red_button import RedButton


class StopSequenceButton(RedButton):
    """The same words, colour and effect wherever it stands; Esc does the same."""

    def __init__(self, robot: Robot, name: str, parent: QWidget | None = None) -> None:
        """Send nothing more to `robot`; `name` is what the button is found by."""
        super().__init__(name, robot.halt, parent)
        self.describe(
            self.tr("Stop sequence"),
            self.tr("End the sequence, send nothing more, stay where the robot is (Esc, anywhere)"),
        )
        self._robot = robot
        robot.link_changed.connect(self._on_link_changed)
        self._on_link_changed()

    @Slot()
    def _on_link_changed(self) -> None:
        self.setEnabled(
            self._robot.link
            in {
                ConnectionState.CONNECTING,
                ConnectionState.CONNECTED,
                ConnectionState.NOT_RESPONDING,
            }
        )
