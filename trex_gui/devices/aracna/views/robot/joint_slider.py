"""A slider over the whole travel of a servo: limits, goal and present position in one line."""

from PySide6.QtCore import QPointF, QRect, QSize, Qt, Slot
from PySide6.QtGui import QKeyEvent, QPainter, QPen, QPolygonF, QWheelEvent
from PySide6.QtWidgets import QWidget

from trex_gui.devices.aracna.protocol.joints import Limits
from trex_gui.devices.aracna.protocol.units import HIGHEST
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.sliders import PressSlider

_BELOW = 7


class JointSlider(PressSlider):
    """Horizontal, 0-1023; the handle is the goal, the wedge below is where the motor is.

    The handle goes no further than the limits; beyond them the groove is thin and grey.

    Signals:
        grabbed: a mouse button went down on it.
        released: that is over, or cannot be told any more.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(0, HIGHEST, parent)
        self._limits = Limits()
        self._present: int | None = None
        self.setSingleStep(4)
        self.setPageStep(50)
        self.valueChanged.connect(self._on_value_changed)

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

    @Slot(int)
    def _on_value_changed(self, value: int) -> None:
        if not self._limits.allow(value):
            self.setValue(self._limits.crop(value))

    # --- Hands --------------------------------------------------------------------------

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

    # --- Looks --------------------------------------------------------------------------

    def sizeHint(self) -> QSize:
        hint = super().sizeHint()
        return QSize(max(hint.width(), 200), hint.height() + _BELOW)

    def minimumSizeHint(self) -> QSize:
        return QSize(90, self.sizeHint().height())

    def room_below(self) -> int:
        """Leave room for the wedge."""
        return _BELOW

    def paint_groove(self, painter: QPainter, handle: QRect) -> None:
        """Paint the whole travel, and what of it is within the limits."""
        middle = handle.center().y()
        left, right = self.x_of(0, handle), self.x_of(HIGHEST, handle)
        groove = QRect(left, middle - 3, right - left, 7)
        painter.setPen(QPen(theme().color("track_edge")))
        painter.setBrush(theme().color("track_off"))
        painter.drawRect(groove)
        start, end = self.x_of(self._limits.low, handle), self.x_of(self._limits.high, handle)
        painter.setBrush(theme().color("track" if self.isEnabled() else "track_off"))
        painter.setPen(QPen(theme().color("neutral")))
        painter.drawRect(QRect(start, middle - 4, max(end - start, 1), 9))

    def paint_below(self, painter: QPainter, handle: QRect) -> None:
        """Paint where the motor is."""
        if self._present is None:
            return
        x, bottom = self.x_of(self._present, handle) + 0.5, float(self.height())
        top = handle.bottom() + 1.0
        wedge = [QPointF(x, top), QPointF(x - 4.5, bottom), QPointF(x + 4.5, bottom)]
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(theme().color("bar"))
        painter.drawPolygon(QPolygonF(wedge))
