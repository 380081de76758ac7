"""A slider that tells when a hand takes hold of it, and when that is over."""

from PySide6.QtCore import QEvent, Qt, Signal, Slot
from PySide6.QtGui import QFocusEvent, QHideEvent, QMouseEvent
from PySide6.QtWidgets import QSlider, QWidget

from trex_gui.ui.widgets.painted_slider import PaintedSlider


class PressSlider(PaintedSlider):
    """One that is pressed with the left button only, and let go where a hold cannot be told.

    Signals:
        grabbed: a hand is on it.
        released: that is over, or cannot be told any more: the focus is gone, or it is hidden,
            disabled, or another window is in front.
    """

    grabbed = Signal()
    released = Signal()

    def __init__(self, lowest: int, highest: int, parent: QWidget | None = None) -> None:
        super().__init__(lowest, highest, parent)
        self._held = False

    @property
    def held(self) -> bool:
        """Whether a hand is on it."""
        return self._held

    @Slot()
    def let_go(self) -> None:
        """End a hold, whatever the hand does; it has to press anew."""
        if self._held:
            self._held = False
            self.setSliderDown(False)
            self.setRepeatAction(QSlider.SliderAction.SliderNoAction)
            self.released.emit()

    def grab_handle(self) -> None:
        """Take note of a hand."""
        if not self._held:
            self._held = True
            self.grabbed.emit()

    # --- Hands --------------------------------------------------------------------------

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take the left button only: a middle one would make Qt jump to where it is."""
        if event.button() is not Qt.MouseButton.LeftButton:
            event.ignore()
            return
        self.grab_handle()
        super().mousePressEvent(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._held:  # one that was let go meanwhile is not to follow the mouse
            super().mouseMoveEvent(event)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if event.button() is not Qt.MouseButton.LeftButton:
            event.ignore()
            return
        super().mouseReleaseEvent(event)
        self.let_go()

    def event(self, event: QEvent) -> bool:
        if event.type() in {QEvent.Type.UngrabMouse, QEvent.Type.WindowDeactivate}:
            self.let_go()
        return super().event(event)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        self.let_go()
        super().focusOutEvent(event)

    def hideEvent(self, event: QHideEvent) -> None:
        self.let_go()
        super().hideEvent(event)

    def changeEvent(self, event: QEvent) -> None:
        if event.type() == QEvent.Type.EnabledChange and not self.isEnabled():
            self.let_go()
        super().changeEvent(event)
