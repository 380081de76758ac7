"""A slim slider that fills from where it rests, and goes back there with a double click."""

from PySide6.QtCore import QRect, QSignalBlocker, QSize, Qt
from PySide6.QtGui import QMouseEvent, QPainter, QPaintEvent, QPen, QWheelEvent
from PySide6.QtWidgets import QSlider, QStyle, QStyleOptionSlider, QWidget

from trex_gui.views.theme import theme


class StickSlider(QSlider):
    """Horizontal; `rest` is where its fill begins.

    `follow` shows what is so and leaves the hand alone; `valueChanged` is what a person did.
    """

    def __init__(
        self, lowest: int, highest: int, rest: int, color: str, parent: QWidget | None = None
    ) -> None:
        super().__init__(Qt.Orientation.Horizontal, parent)
        self._rest = rest
        self._color = color
        self.setRange(lowest, highest)
        self.setValue(rest)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        theme().changed.connect(self.update)

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

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        option = QStyleOptionSlider()
        self.initStyleOption(option)
        slider, part = QStyle.ComplexControl.CC_Slider, QStyle.SubControl.SC_SliderHandle
        handle = self.style().subControlRect(slider, option, part, self)
        option.subControls = part
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            self._paint_groove(painter, handle)
            self.style().drawComplexControl(slider, option, painter, self)

    def _paint_groove(self, painter: QPainter, handle: QRect) -> None:
        color = theme().color
        middle = handle.center().y()
        left, right = self._x_of(self.minimum(), handle), self._x_of(self.maximum(), handle)
        painter.setPen(QPen(color("track_edge")))
        painter.setBrush(color("track" if self.isEnabled() else "track_off"))
        painter.drawRoundedRect(QRect(left, middle - 2, right - left, 5), 2, 2)
        rest, here = self._x_of(self._rest, handle), handle.center().x()
        if self.isEnabled():
            start, end = max(min(rest, here), left + 2), max(rest, here)
            painter.fillRect(start, middle - 1, max(end - start, 0), 4, color(self._color))
        if self.minimum() < self._rest < self.maximum():
            painter.fillRect(rest, middle - 6, 1, 13, color("mark"))

    def _x_of(self, value: int, handle: QRect) -> int:
        room = self.width() - handle.width()
        return handle.width() // 2 + QStyle.sliderPositionFromValue(
            self.minimum(), self.maximum(), value, room
        )
