"""A slider whose middle is rest: filled from zero, with zero marked."""

from PySide6.QtCore import QRect, QSize, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSlider, QStyle, QStyleOptionSlider, QWidget

from trex_gui.views.theme import theme

_MARKS = (-127, -64, 0, 64, 127)


class SpeedSlider(QSlider):
    """Horizontal, from `lowest` to 127; the groove is filled from zero to the handle.

    Qt's own slider fills from the left end and has no tick at zero for such a range.
    """

    def __init__(self, lowest: int, parent: QWidget | None = None) -> None:
        super().__init__(Qt.Orientation.Horizontal, parent)
        self.setRange(lowest, 127)
        self.setPageStep(16)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

    def sizeHint(self) -> QSize:
        hint = super().sizeHint()
        return QSize(max(hint.width(), 320), hint.height() + self.fontMetrics().height() + 10)

    def minimumSizeHint(self) -> QSize:
        return QSize(200, self.sizeHint().height())

    def initStyleOption(self, option: QStyleOptionSlider) -> None:
        """Keep groove and handle, painted or clicked on, above the numbers."""
        super().initStyleOption(option)
        below = self.fontMetrics().height() + 6
        option.rect = self.rect().adjusted(0, 0, 0, -below)

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        option = QStyleOptionSlider()
        self.initStyleOption(option)
        style = self.style()
        slider = QStyle.ComplexControl.CC_Slider
        handle = style.subControlRect(slider, option, QStyle.SubControl.SC_SliderHandle, self)
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self._paint_groove(painter, handle)
        self._paint_marks(painter, handle)
        option.subControls = QStyle.SubControl.SC_SliderHandle
        style.drawComplexControl(slider, option, painter, self)
        painter.end()

    def _paint_groove(self, painter: QPainter, handle: QRect) -> None:
        middle = handle.center().y()
        left, right = self._x_of(self.minimum(), handle), self._x_of(self.maximum(), handle)
        groove = QRect(left, middle - 3, right - left, 7)
        painter.setPen(QPen(theme().color("grid")))
        painter.setBrush(theme().color("track"))
        painter.drawRoundedRect(groove, 3, 3)
        if not self.isEnabled():
            return
        zero, here = self._x_of(0, handle), handle.center().x()
        name = "bar_negative" if self.sliderPosition() < 0 else "bar"
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(theme().color(name))
        painter.drawRect(QRect(min(zero, here), middle - 2, abs(here - zero), 5))

    def _paint_marks(self, painter: QPainter, handle: QRect) -> None:
        painter.setPen(self.palette().color(self.foregroundRole()))
        metrics = self.fontMetrics()
        top = handle.bottom() + 2
        for value in _MARKS:
            if value < self.minimum():
                continue
            x = self._x_of(value, handle)
            painter.drawLine(x, top, x, top + 4)
            text = f"+{value}" if value > 0 and self.minimum() < 0 else str(value)
            text = text.replace("-", "−")
            width = metrics.horizontalAdvance(text)
            place = min(max(x - width // 2, 0), self.width() - width)
            painter.drawText(place, top + 6 + metrics.ascent(), text)

    def _x_of(self, value: int, handle: QRect) -> int:
        room = self.width() - handle.width()
        start = handle.width() // 2
        return start + QStyle.sliderPositionFromValue(self.minimum(), self.maximum(), value, room)
