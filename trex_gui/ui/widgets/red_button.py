"""The red button that stops: the same look and the same way to press it, whatever the device."""

from collections.abc import Callable

from PySide6.QtCore import QEvent
from PySide6.QtWidgets import QPushButton, QWidget

from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.theme.theme import tint


class RedButton(QPushButton):
    """Stops at the press, not when it is let go: a finger that slips off takes nothing back.

    Enter in a dialog never presses it.
    """

    def __init__(
        self, name: str, stop: Callable[[], object], parent: QWidget | None = None
    ) -> None:
        """Call `stop` when it is pressed; `name` is what the button is found by."""
        super().__init__(parent)
        self.setObjectName(name)
        self.setAutoDefault(False)
        self._show_font()
        tint(self, "stop")
        set_icon(self, "stop", "stop_text")
        self.pressed.connect(stop)

    def describe(self, text: str, tip: str) -> None:
        """Say in two words what it stops, and in a sentence what that means."""
        self.setText(text)
        self.setAccessibleName(text)
        self.setToolTip(tip)

    def _show_font(self) -> None:
        font = self.font()
        if not font.bold():
            font.setBold(True)
            self.setFont(font)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:
            self._show_font()
