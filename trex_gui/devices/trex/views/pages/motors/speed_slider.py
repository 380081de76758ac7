"""A slider whose middle is rest: filled from zero, with zero marked."""

from PySide6.QtCore import QRect, QSize, Qt
from PySide6.QtGui import QKeyEvent, QMouseEvent, QPainter, QPen
from PySide6.QtWidgets import QWidget

from trex_gui.devices.trex.views.driving.press_monitor import PressMonitor
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.press_slider import PressSlider

_MARKS = (-127, -64, 0, 64, 127)

_MOVING_KEYS = {
    *(Qt.Key.Key_Left, Qt.Key.Key_Right, Qt.Key.Key_Up, Qt.Key.Key_Down),
    *(Qt.Key.Key_PageUp, Qt.Key.Key_PageDown),
}


class SpeedSlider(PressSlider):
    """Horizontal, from `lowest` to 127; the groove is filled from zero to the handle.

    Qt's own slider fills from the left end and has no tick at zero for such a range. Home is
    zero, and End does nothing: one key must not mean full speed.

    Signals:
        grabbed: a mouse button or a key that moves it went down.
        released: that is over, or cannot be told any more: the focus is gone, or it is hidden,
            disabled, or covered by a menu or a dialog.
    """

    def __init__(self, lowest: int, parent: QWidget | None = None) -> None:
        super().__init__(lowest, 127, parent)
        self._ceiling = 127
        self._watch = PressMonitor(self)
        self.setPageStep(16)

        self._watch.lost.connect(self.let_go)
        self.grabbed.connect(self._watch.begin)
        self.released.connect(self._watch.end)

    def set_ceiling(self, ceiling: int) -> None:
        """Show up to which speed, 1-127, it is of use, either way."""
        if ceiling != self._ceiling:
            self._ceiling = ceiling
            self.update()

    # --- Hands --------------------------------------------------------------------------

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Let go where the button went up unseen."""
        if self.isSliderDown() and not event.buttons() & Qt.MouseButton.LeftButton:
            self.let_go()
        super().mouseMoveEvent(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        match event.key():
            case Qt.Key.Key_Home | Qt.Key.Key_0:
                self.setValue(0)
            case Qt.Key.Key_End:
                pass
            case key if key in _MOVING_KEYS:
                if event.isAutoRepeat() and not self.held:
                    return  # it was let go meanwhile; the key has to go down anew
                self.grab_handle()
                super().keyPressEvent(event)
            case _:
                super().keyPressEvent(event)

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        """Let go with any key: what went down as an arrow may go up as a digit (Num Lock)."""
        super().keyReleaseEvent(event)
        if not event.isAutoRepeat() and not self.isSliderDown():
            self.let_go()

    # --- Looks --------------------------------------------------------------------------

    def sizeHint(self) -> QSize:
        hint = super().sizeHint()
        return QSize(max(hint.width(), 240), hint.height() + self.fontMetrics().height() + 10)

    def minimumSizeHint(self) -> QSize:
        return QSize(150, self.sizeHint().height())

    def room_below(self) -> int:
        """Leave room for the numbers."""
        return self.fontMetrics().height() + 6

    def paint_groove(self, painter: QPainter, handle: QRect) -> None:
        """Paint the groove, its useful part, and the fill from zero."""
        middle = handle.center().y()
        left, right = self.x_of(self.minimum(), handle), self.x_of(self.maximum(), handle)
        groove = QRect(left, middle - 3, right - left, 7)
        painter.setPen(QPen(theme().color("track_edge")))
        painter.setBrush(theme().color("track_off"))
        painter.drawRoundedRect(groove, 3, 3)
        if self.isEnabled():  # as far as the ceiling lets it go
            start = self.x_of(max(-self._ceiling, self.minimum()), handle)
            end = self.x_of(self._ceiling, handle)
            painter.setBrush(theme().color("track"))
            painter.drawRoundedRect(QRect(start, middle - 3, end - start, 7), 3, 3)
        if not self.isEnabled():
            return
        zero, here = self.x_of(0, handle), handle.center().x()
        name = "bar_negative" if self.sliderPosition() < 0 else "bar"
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(theme().color(name))
        painter.drawRect(QRect(min(zero, here), middle - 2, abs(here - zero), 5))

    def paint_below(self, painter: QPainter, handle: QRect) -> None:
        """Paint ticks and numbers."""
        painter.setPen(self.palette().color(self.foregroundRole()))
        metrics = self.fontMetrics()
        top = handle.bottom() + 2
        for value in _MARKS:
            if value < self.minimum():
                continue
            x = self.x_of(value, handle)
            painter.drawLine(x, top, x, top + 4)
            text = f"+{value}" if value > 0 and self.minimum() < 0 else str(value)
            text = text.replace("-", "−")
            width = metrics.horizontalAdvance(text)
            place = min(max(x - width // 2, 0), self.width() - width)
            painter.drawText(place, top + 6 + metrics.ascent(), text)
