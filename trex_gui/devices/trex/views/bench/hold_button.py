"""A button that acts only while it is held."""

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QPushButton, QWidget

_LOSSES = {
    QEvent.Type.FocusOut,
    QEvent.Type.Hide,
    QEvent.Type.WindowDeactivate,
    QEvent.Type.UngrabMouse,
    QEvent.Type.TouchCancel,
}
"""Events after which it is not certain that the user holds the button."""


class HoldButton(QPushButton):
    """Held with the mouse, a finger or the space bar.

    Every loss of input releases it: another window or widget takes the focus, the mouse leaves
    it, it is hidden or disabled. Then it has to be pressed again: a mouse that comes back with
    its button down does not count.

    Signals:
        hold_started, hold_ended: the user presses it, or no longer holds it.
    """

    hold_started = Signal()
    hold_ended = Signal()

    is_held = False

    def __init__(self, text: str, parent: QWidget | None = None) -> None:
        super().__init__(text, parent)
        self.setAutoDefault(False)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

    def _begin(self) -> None:
        if not self.is_held and self.isEnabled():
            self.is_held = True
            self.hold_started.emit()

    def _end(self) -> None:
        if self.is_held:
            self.is_held = False
            self.setDown(False)
            self.hold_ended.emit()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        super().mousePressEvent(event)
        if event.button() == Qt.MouseButton.LeftButton:
            self._begin()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self.is_held:  # else Qt would press it again when the mouse comes back
            if not self.rect().contains(event.position().toPoint()):
                self._end()
            event.accept()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        self._end()
        super().mouseReleaseEvent(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        super().keyPressEvent(event)
        if event.key() == Qt.Key.Key_Space and not event.isAutoRepeat():
            self._begin()

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Space and not event.isAutoRepeat():
            self._end()
        super().keyReleaseEvent(event)

    def event(self, event: QEvent) -> bool:
        if event.type() in _LOSSES or not self.isEnabled():
            self._end()
        return super().event(event)
