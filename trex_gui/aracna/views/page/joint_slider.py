"""A slider over the whole travel of a servo: limits, goal and present position in one line."""

from PySide6.QtCore import QEvent, QPointF, QRect, QSize, Qt, Signal, Slot
from PySide6.QtGui import (
    QFocusEvent,
    QHideEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QPolygonF,
    QWheelEvent,
)
from PySide6.QtWidgets import QSlider, QStyle, QStyleOptionSlider, QWidget

from trex_gui.aracna.protocol.joints import Limits
from trex_gui.aracna.protocol.units import HIGHEST
from trex_gui.views.theme import theme

_BELOW = 7


class JointSlider(QSlider):
    """Horizontal, 0-1023; the handle is the goal, the wedge below is where the motor is.

    The handle goes no further than the limits; beyond them the groove is thin and grey.

    Signals:
        grabbed: a mouse button went down on it.
        released: that is over, or cannot be told any more.
    """

    grabbed = Signal()
    released = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(Qt.Orientation.Horizontal, parent)
        self._limits = Limits()
        self._present: int | None = None
        self._held = False
        self.setRange(0, HIGHEST)
        self.setSingleStep(4)
        self.setPageStep(50)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.valueChanged.connect(self._on_value_changed)
        theme().changed.connect(self.update)

    @property
    def held(self) -> bool:
        """Whether a hand is on it."""
        return self._held

    def set_limits(self, limits: Limits) -> None:
        """Let the handle go from here to there."""
        if limits != self._limits:
            self._limits = limits
            self.setValue(limits.crop(self.value()))
            self.update()

    def set_present(self, present: int | None) -> None:
        """Show where the motor is; `None`: not known."""
        if present != self._present:
            self._present = present
            self.update()

    @Slot()
    def let_go(self) -> None:
        """End a hold, whatever the hand does; it has to press anew."""
        if self._held:
            self._held = False
            self.setSliderDown(False)
            self.setRepeatAction(QSlider.SliderAction.SliderNoAction)
            self.released.emit()

    @Slot(int)
    def _on_value_changed(self, value: int) -> None:
        if not self._limits.allow(value):
            self.setValue(self._limits.crop(value))

    # --- Hands --------------------------------------------------------------------------

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take the left button only: a middle one would make Qt jump to where it is."""
        if event.button() is not Qt.MouseButton.LeftButton:
            event.ignore()
            return
        self._held = True
        self.grabbed.emit()
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

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Go to the limits with Home and End."""
        match event.key():
            case Qt.Key.Key_Home:
                self.setValue(self._limits.low)
            case Qt.Key.Key_End:
                self.setValue(self._limits.high)
            case _:
                super().keyPressEvent(event)

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Take the wheel only with the focus: else it scrolls the page."""
        if self.hasFocus():
            super().wheelEvent(event)
        else:
            event.ignore()

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

    # --- Looks --------------------------------------------------------------------------

    def sizeHint(self) -> QSize:
        hint = super().sizeHint()
        return QSize(max(hint.width(), 200), hint.height() + _BELOW)

    def minimumSizeHint(self) -> QSize:
        return QSize(90, self.sizeHint().height())

    def initStyleOption(self, option: QStyleOptionSlider) -> None:
        """Keep groove and handle, painted or clicked on, above the wedge."""
        super().initStyleOption(option)
        option.rect = self.rect().adjusted(0, 0, 0, -_BELOW)

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
        option.subControls = QStyle.SubControl.SC_SliderHandle
        style.drawComplexControl(slider, option, painter, self)
        self._paint_present(painter, handle)
        painter.end()

    def _paint_groove(self, painter: QPainter, handle: QRect) -> None:
        middle = handle.center().y()
        left, right = self._x_of(0, handle), self._x_of(HIGHEST, handle)
        groove = QRect(left, middle - 3, right - left, 7)
        painter.setPen(QPen(theme().color("track_edge")))
        painter.setBrush(theme().color("track_off"))
        painter.drawRect(groove)
        start, end = self._x_of(self._limits.low, handle), self._x_of(self._limits.high, handle)
        painter.setBrush(theme().color("track" if self.isEnabled() else "track_off"))
        painter.setPen(QPen(theme().color("neutral")))
        painter.drawRect(QRect(start, middle - 4, max(end - start, 1), 9))

    def _paint_present(self, painter: QPainter, handle: QRect) -> None:
        if self._present is None:
            return
        x, bottom = self._x_of(self._present, handle) + 0.5, float(self.height())
        top = handle.bottom() + 1.0
        wedge = [QPointF(x, top), QPointF(x - 4.5, bottom), QPointF(x + 4.5, bottom)]
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(theme().color("bar"))
        painter.drawPolygon(QPolygonF(wedge))

    def _x_of(self, value: int, handle: QRect) -> int:
        room = self.width() - handle.width()
        start = handle.width() // 2
        return start + QStyle.sliderPositionFromValue(0, HIGHEST, value, room)
