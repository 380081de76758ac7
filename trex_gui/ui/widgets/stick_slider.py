"""A slim slider that fills from where it rests, and goes back there with a double click."""

from PySide6.QtCore import QRect, QSignalBlocker, QSize, Qt
from PySide6.QtGui import QMouseEvent, QPainter, QPen, QWheelEvent
from PySide6.QtWidgets import QWidget

from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.painted_slider import PaintedSlider


class StickSlider(PaintedSlider):
    """Horizontal; `rest` is where its fill begins.

    `follow` shows what is so and leaves the hand alone; `valueChanged` is what a person did.
    """

    def __init__(
        self, lowest: int, highest: int, rest: int, color: str, parent: QWidget | None = None
    ) -> None:
        super().__init__(lowest, highest, parent)
        self._rest = rest
        self._color = color
        self.setValue(rest)

    def set_scale(self, lowest: int, highest: int, rest: int) -> None:
        """Change the range; nothing is announced."""
        if (lowest, highest, rest) != (self.minimum(), self.maximum(), self._rest):
            self._rest = rest
            with QSignalBlocker(self):
                self.setRange(lowest, highest)
            self.update()

    def follow(self, value: int) -> None:
        """Show a value that no person chose, unless a person holds the handle."""
        if not self.isSliderDown() and value != self.value():
            with QSignalBlocker(self):
                self.setValue(value)

    def sizeHint(self) -> QSize:
        return QSize(120, super().sizeHint().height())

    def minimumSizeHint(self) -> QSize:
        return QSize(60, super().minimumSizeHint().height())

    def wheelEvent(self, event: QWheelEvent) -> None:
        if self.hasFocus():
            super().wheelEvent(event)
        else:
            event.ignore()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        if event.button() is Qt.MouseButton.LeftButton:
            self.setSliderDown(False)
            self.setValue(self._rest)
            event.accept()

    def paint_groove(self, painter: QPainter, handle: QRect) -> None:
        """Paint the groove, the fill from rest, and a mark there."""
        color = theme().color
        middle = handle.center().y()
        left, right = self.x_of(self.minimum(), handle), self.x_of(self.maximum(), handle)
        painter.setPen(QPen(color("track_edge")))
        painter.setBrush(color("track" if self.isEnabled() else "track_off"))
        painter.drawRoundedRect(QRect(left, middle - 2, right - left, 5), 2, 2)
        rest, here = self.x_of(self._rest, handle), handle.center().x()
        if self.isEnabled():
            start, end = max(min(rest, here), left + 2), max(rest, here)
            painter.fillRect(start, middle - 1, max(end - start, 0), 4, color(self._color))
        if self.minimum() < self._rest < self.maximum():
            painter.fillRect(rest, middle - 6, 1, 13, color("mark"))
