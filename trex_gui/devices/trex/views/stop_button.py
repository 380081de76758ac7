"""The red button that brakes both motors, below the pages and in windows that may cover them."""

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QWidget

from trex_gui.devices.trex.model.device import Device
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.widgets.red_button import RedButton


class StopButton(RedButton):
    """The same words, colour and effect wherever it stands; Esc does the same."""

    def __init__(self, device: Device, name: str, parent: QWidget | None = None) -> None:
        """Stop the motors of `device`; `name` is what the button is found by."""
        super().__init__(name, device.motors.press_stop, parent)
        self.describe(self.tr("Stop motor"), self.tr("Brake both motors, now (Esc, anywhere)"))
        self._device = device
        device.link_changed.connect(self._on_link_changed)
        self._on_link_changed()

    @Slot()
    def _on_link_changed(self) -> None:
        self.setEnabled(
            self._device.link
            in {
                ConnectionState.CONNECTING,
                ConnectionState.CONNECTED,
                ConnectionState.NOT_RESPONDING,
            }
        )
