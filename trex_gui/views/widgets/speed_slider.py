"""A slider whose middle is rest: filled from zero, with zero marked."""

from PySide6.QtCore import QEvent, QRect, QSize, Qt, Signal, Slot
from PySide6.QtGui import (
    QFocusEvent,
    QHideEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
)
from PySide6.QtWidgets import QSlider, QStyle, QStyleOptionSlider, QWidget

from trex_gui.views.driving.hold_watch import HoldWatch
from trex_gui.views.theme import theme

_MARKS = (-127, -64, 0, 64, 127)

_MOVING_KEYS = {
    *(Qt.Key.Key_Left, Qt.Key.Key_Right, Qt.Key.Key_Up, Qt.Key.Key_Down),
    *(Qt.Key.Key_PageUp, Qt.Key.Key_PageDown),
}


class SpeedSlider(QSlider):
    """Horizontal, from `lowest` to 127; the groove is filled from zero to the handle.

    Qt's own slider fills from the left end and has no tick at zero for such a range. Home is
    zero, and End does nothing: one key must not mean full speed.

    Signals:
        grabbed: a mouse button or a key that moves it went down.
        released: that is over, or cannot be told any more: the focus is gone, or it is hidden,
            disabled, or covered by a menu or a dialog.
    """

    grabbed = Signal()
    released = Signal()

    def __init__(self, lowest: int, parent: QWidget | None = None) -> None:
        super().__init__(Qt.Orientation.Horizontal, parent)
        self._ceiling = 127
        self._held = False
        self._watch = HoldWatch(self)
        self.setRange(lowest, 127)
        self.setPageStep(16)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

        self._watch.blinded.connect(self.let_go)
        theme().changed.connect(self.update)

    @property
    def held(self) -> bool:
        """Whether a hand is on it."""
        return self._held

    def set_ceiling(self, ceiling: int) -> None:
        """Show up to which speed, 1-127, it is of use, either way."""
        if ceiling != self._ceiling:
            self._ceiling = ceiling
            self.update()

    @Slot()
    def let_go(self) -> None:
        """End a hold, whatever the hand does; it has to press anew."""
        if self._held:
            self._held = False
            self._watch.end()
            self.setSliderDown(False)
            self.setRepeatAction(QSlider.SliderAction.SliderNoAction)
            self.released.emit()

    # --- Hands --------------------------------------------------------------------------

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take the left button only: a middle one would make Qt jump to where it is."""
        if event.button() is not Qt.MouseButton.LeftButton:
            event.ignore()
            return
        self._grab()
        super().mousePressEvent(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self.isSliderDown() and not event.buttons() & Qt.MouseButton.LeftButton:
            self.let_go()
        if self._held:  # one that was let go meanwhile is not to follow the mouse
            super().mouseMoveEvent(event)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if event.button() is not Qt.MouseButton.LeftButton:
            event.ignore()
            return
        super().mouseReleaseEvent(event)
        self.let_go()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        match event.key():
            case Qt.Key.Key_Home | Qt.Key.Key_0:
                self.setValue(0)
            case Qt.Key.Key_End:
                pass
            case key if key in _MOVING_KEYS:
                if event.isAutoRepeat() and not self._held:
                    return  # it was let go meanwhile; the key has to go down anew
                self._grab()
                super().keyPressEvent(event)
            case _:
                super().keyPressEvent(event)

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        """Let go with any key: what went down as an arrow may go up as a digit (Num Lock)."""
        super().keyReleaseEvent(event)
        if not event.isAutoRepeat() and not self.isSliderDown():
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

    def _grab(self) -> None:
        if not self._held:
            self._held = True
            self._watch.begin()
            self.grabbed.emit()

    # --- Looks --------------------------------------------------------------------------

    def sizeHint(self) -> QSize:
        hint = super().sizeHint()
        return QSize(max(hint.width(), 240), hint.height() + self.fontMetrics().height() + 10)

    def minimumSizeHint(self) -> QSize:
        return QSize(150, self.sizeHint().height())

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
        painter.setPen(QPen(theme().color("track_edge")))
        painter.setBrush(theme().color("track_off"))
        painter.drawRoundedRect(groove, 3, 3)
        if self.isEnabled():  # as far as the ceiling lets it go
            start = self._x_of(max(-self._ceiling, self.minimum()), handle)
            end = self._x_of(self._ceiling, handle)
            painter.setBrush(theme().color("track"))
            painter.drawRoundedRect(QRect(start, middle - 3, end - start, 7), 3, 3)
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
