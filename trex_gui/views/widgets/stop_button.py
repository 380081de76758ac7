"""The red button that brakes both motors, for windows that may cover the one with the big one."""

from PySide6.QtCore import QEvent, Slot
from PySide6.QtWidgets import QPushButton, QWidget

from trex_gui.model.device import Device, Link
from trex_gui.views.icons import set_icon
from trex_gui.views.theme import tint


class StopButton(QPushButton):
    """The same words, colour, name and effect as the one below the pages; Esc does the same.

    Enter in a dialog never presses it.
    """

    def __init__(self, device: Device, name: str, parent: QWidget | None = None) -> None:
        """Stop the motors of `device`; `name` is what the button is found by."""
        super().__init__(parent)
        self._device = device
        self.setObjectName(name)
        self.setText(self.tr("Stop motor"))
        self.setAccessibleName(self.tr("Stop motor"))
        self.setToolTip(self.tr("Brake both motors, now (Esc, anywhere)"))
        self.setAutoDefault(False)
        self._show_font()
        tint(self, "stop")
        set_icon(self, "stop", "stop_text")

        # At the press, not when it is let go; a finger that slips off it does not take it back.
        self.pressed.connect(device.motors.press_stop)
        device.link_changed.connect(self._on_link_changed)
        self._on_link_changed()

    @Slot()
    def _on_link_changed(self) -> None:
        self.setEnabled(self._device.link in {Link.OPENING, Link.UP, Link.SILENT})

    def _show_font(self) -> None:
        font = self.font()
        if not font.bold():
            font.setBold(True)
            self.setFont(font)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:
            self._show_font()
