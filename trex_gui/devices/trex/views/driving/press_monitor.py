"""Detects that the release of a held control can no longer arrive as an event."""

from PySide6.QtCore import QObject, Signal, Slot
from PySide6.QtWidgets import QApplication, QWidget

from trex_gui.ui.runtime import runtime

_LOOK_MS = 50


class PressMonitor(QObject):
    """Looks at a widget again and again, but only while something in it is held.

    The end of a hold may never arrive as an event: a menu or a dialog that opens swallows the
    mouse button or the key that goes up.

    Signals:
        blinded: a menu, a dialog or another window is in front now, or the widget is hidden.
    """

    lost = Signal()

    def __init__(self, widget: QWidget) -> None:
        super().__init__(widget)
        self._widget = widget
        self._was_active = False
        self._timer = runtime().timer(self)
        self._timer.setInterval(_LOOK_MS)
        self._timer.timeout.connect(self._on_look)

    def begin(self) -> None:
        """Look from now on; beginning again is fine."""
        if not self._timer.isActive():
            self._was_active = self._widget.isActiveWindow()
            self._timer.start()

    def end(self) -> None:
        """Do not look any more."""
        self._timer.stop()

    @Slot()
    def _on_look(self) -> None:
        in_front = QApplication.activePopupWidget() or QApplication.activeModalWidget()
        left = self._was_active and not self._widget.isActiveWindow()
        if in_front is not None or left or not self._widget.isVisible():
            self.end()
            self.lost.emit()
