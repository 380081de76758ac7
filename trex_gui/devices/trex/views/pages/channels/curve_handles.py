"""Handles and switch threshold, drawn over the curve of a channel."""

from dataclasses import dataclass

from PySide6.QtCore import QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QFont, QFontMetricsF, QPainter, QPen, QPolygonF
from PySide6.QtWidgets import (
    QGraphicsObject,
    QGraphicsSceneHoverEvent,
    QGraphicsSceneMouseEvent,
    QStyleOptionGraphicsItem,
    QWidget,
)

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.calibration_moves import Handle
from trex_gui.ui.plotting.axes import spread
from trex_gui.ui.theme.theme import theme

GRIP = 6.0  # half the width of a grip in pixels
_REACH = 9.0  # maximum distance in pixels at which the mouse grabs a handle
_MAIN = (Handle.MINIMUM, Handle.NEUTRAL, Handle.MAXIMUM)
_EDGES = (Handle.DEADBAND_LOW, Handle.DEADBAND_HIGH)


@dataclass(frozen=True, slots=True)
class Threshold:
    x: float  # pixels
    is_on_right: bool  # True if the switch is on to the right of the threshold
    text: str


class HandleLayer(QGraphicsObject):
    dragged = Signal(float)  # new x of the held handle in pixels
    released = Signal()  # the held handle was released, even if it was not moved

    def __init__(self, font: QFont) -> None:
        super().__init__()
        self._names = {
            Handle.MINIMUM: tr("Minimum"),
            Handle.NEUTRAL: tr("Neutral"),
            Handle.MAXIMUM: tr("Maximum"),
        }
        self.set_font(font)
        self._frame = QRectF()
        self._positions: dict[Handle, float] = {}  # handle → x in pixels
        self._threshold: Threshold | None = None
        self._is_editable = True
        self._active: Handle | None = None
        self._grab_offset = 0.0  # pixels from the held handle to the mouse
        self.held: Handle | None = None  # handle that the mouse drags
        self.message = ""  # reason why the held handle cannot move further
        self.setZValue(50)
        self.setAcceptHoverEvents(True)
        self.setAcceptedMouseButtons(Qt.MouseButton.LeftButton)
        theme().changed.connect(self.update)

    def set_font(self, font: QFont) -> None:
        self._font = font
        self._metrics = QFontMetricsF(font)
        self._width = self._metrics.horizontalAdvance

    def height_above(self) -> int:
        """Return the height in pixels of the names and grips above the plot."""
        return round(self._metrics.height() + GRIP + 5)

    def arrange(
        self, frame: QRectF, positions: dict[Handle, float], threshold: Threshold | None
    ) -> None:
        self.prepareGeometryChange()
        self._frame, self._positions, self._threshold = frame, positions, threshold
        self.update()

    def set_editable(self, editable: bool) -> None:
        """Show grips if the curve is editable. Otherwise release the held handle and hide grips."""
        if not editable:
            self.release()
        self._is_editable = editable
        self.update()

    def show_message(self, message: str) -> None:
        self.message = message
        self.update()

    def _handle_at(self, point: QPointF) -> Handle | None:
        """Return the handle at a point. Deadband handles have priority in the lower half."""
        if not self._is_editable or not self._positions:
            return None
        lower = point.y() > self._frame.center().y()
        for group in (_EDGES, _MAIN) if lower else (_MAIN, _EDGES):
            nearest = min(group, key=lambda handle: abs(self._positions[handle] - point.x()))
            if abs(self._positions[nearest] - point.x()) <= _REACH:
                return nearest
        return None

    def _set_active(self, handle: Handle | None) -> None:
        self._active = handle
        self.update()

    def hoverMoveEvent(self, event: QGraphicsSceneHoverEvent) -> None:
        handle = self._handle_at(event.pos())
        self._set_active(handle)
        self.setCursor(Qt.CursorShape.SizeHorCursor if handle else Qt.CursorShape.ArrowCursor)

    def hoverLeaveEvent(self, event: QGraphicsSceneHoverEvent) -> None:  # noqa: ARG002 - Qt's
        if self.held is None:
            self._set_active(None)

    def mousePressEvent(self, event: QGraphicsSceneMouseEvent) -> None:
        handle = self._handle_at(event.pos())
        if handle is None:
            event.ignore()
            return
        self.held = handle
        self._grab_offset = event.pos().x() - self._positions[handle]
        self._set_active(handle)

    def mouseMoveEvent(self, event: QGraphicsSceneMouseEvent) -> None:
        if self.held is not None:
            self.dragged.emit(event.pos().x() - self._grab_offset)

    def mouseReleaseEvent(self, event: QGraphicsSceneMouseEvent) -> None:  # noqa: ARG002 - Qt's
        self.release()

    def release(self) -> None:
        if self.held is not None:
            self.held = None
            self._set_active(None)
            self.message = ""
            self.released.emit()

    def boundingRect(self) -> QRectF:
        return self._frame.adjusted(-80, -self.height_above() - 2, 80, 2)

    def paint(
        self,
        painter: QPainter,
        option: QStyleOptionGraphicsItem,  # noqa: ARG002 - Qt's
        widget: QWidget | None = None,  # noqa: ARG002 - Qt's
    ) -> None:
        if not self._positions:
            return
        painter.setFont(self._font)
        painter.setLayoutDirection(Qt.LayoutDirection.LeftToRight)
        self._paint_threshold(painter)
        for handle in (*_EDGES, *_MAIN):
            self._paint_handle(painter, handle)
        self._paint_names(painter)
        if self.held is not None and self.message:
            self._paint_message(painter, self._positions[self.held])

    def _paint_line(self, painter: QPainter, x: float, pen: QPen) -> None:
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
        painter.setPen(pen)
        painter.drawLine(QPointF(x, self._frame.top()), QPointF(x, self._frame.bottom()))

    def _paint_handle(self, painter: QPainter, handle: Handle) -> None:
        x, frame = round(self._positions[handle]) + 0.5, self._frame
        active = handle is self._active
        color = theme().color("pointer" if active else "neutral" if handle.is_deadband else "mark")
        style = Qt.PenStyle.SolidLine if active else Qt.PenStyle.DotLine
        if active or not handle.is_deadband:  # the filled deadband already shows these limits
            self._paint_line(painter, x, QPen(color, 2 if active else 1, style))
        if not self._is_editable:
            return
        tip, base = frame.top() + GRIP * 0.9, frame.top() - GRIP * 0.7
        if handle.is_deadband:
            tip, base = frame.bottom() - GRIP * 1.6, frame.bottom() - 1
        # The two deadband handles may coincide, so each has half a grip.
        left = x if handle is Handle.DEADBAND_HIGH else x - GRIP
        right = x if handle is Handle.DEADBAND_LOW else x + GRIP
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(color)
        painter.drawPolygon(QPolygonF([QPointF(left, base), QPointF(right, base), QPointF(x, tip)]))

    def _paint_names(self, painter: QPainter) -> None:
        frame, height = self._frame, self._metrics.height()
        order = sorted(_MAIN, key=lambda handle: self._positions[handle])
        widths = [self._width(self._names[handle]) for handle in order]
        positions = [self._positions[handle] for handle in order]
        centers = spread(positions, widths, frame.left(), frame.right() + 60, 10)
        top = frame.top() - GRIP - height - 2
        for handle, width, center_x in zip(order, widths, centers or (), strict=False):
            color = theme().color("pointer" if handle is self._active else "plot_text")
            box = QRectF(center_x - width / 2, top, width + 1, height)
            self._paint_text(painter, box, self._names[handle], QPen(color))
        muted, name = QPen(theme().color("muted")), tr("deadband")
        left = max(self._positions[handle] for handle in _EDGES) + GRIP + 3
        box = QRectF(left, frame.bottom() - height - 2, self._width(name) + 4, height)
        self._paint_text(painter, box, name, muted, filled=True)
        output = QRectF(0, top, frame.left() - 4, height)
        painter.drawText(output, Qt.AlignmentFlag.AlignRight, tr("Output"))

    def _paint_text(
        self, painter: QPainter, box: QRectF, text: str, pen: QPen, *, filled: bool = False
    ) -> None:
        if filled:
            painter.fillRect(box, theme().color("plot_background"))
        painter.setPen(pen)
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, text)

    def _paint_threshold(self, painter: QPainter) -> None:
        threshold = self._threshold
        if threshold is None:
            return
        x, frame = round(threshold.x) + 0.5, self._frame
        pen = QPen(theme().color("muted"), 1, Qt.PenStyle.DashLine)
        self._paint_line(painter, x, pen)
        width, height = self._width(threshold.text) + 2, self._metrics.height()
        left = x + 5 if threshold.is_on_right else x - 5 - width
        box = QRectF(left, frame.top() + frame.height() * 0.3 - height / 2, width, height)
        self._paint_text(painter, box, threshold.text, pen, filled=True)

    def _paint_message(self, painter: QPainter, x: float) -> None:
        frame = self._frame
        width, height = (self._width(self.message) + 16, self._metrics.height() + 8)
        left = x + 10 if x + 10 + width < frame.right() else x - 10 - width
        box = QRectF(max(left, frame.left() + 4), frame.top() + GRIP * 2, width, height)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(theme().color("warning"), 1))
        painter.setBrush(theme().color("plot_background"))
        painter.drawRoundedRect(box, 3, 3)
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, self.message)
