"""What is drawn over a channel's curve: the handles with their names, and where it switches."""

from dataclasses import dataclass

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QFont, QFontMetricsF, QPainter, QPen, QPolygonF
from PySide6.QtWidgets import QGraphicsItem, QStyleOptionGraphicsItem, QWidget

from trex_gui.devices.trex.model.calibration.moves import Handle
from trex_gui.ui.plotting.axes import spread
from trex_gui.ui.theme.theme import theme

GRIP = 6.0
"""Half the width of a grip in pixels."""

REACH = 9.0
"""How far beside a handle the mouse still takes it."""

_MAIN = (Handle.MINIMUM, Handle.NEUTRAL, Handle.MAXIMUM)
_EDGES = (Handle.DEADBAND_LOW, Handle.DEADBAND_HIGH)


@dataclass(frozen=True, slots=True)
class Threshold:
    """Where a switch switches, in pixels; `above`: it is on to the right of it."""

    x: float
    above: bool
    text: str


class HandleLayer(QGraphicsItem):
    """Lines with grips and names: three from the top, the deadband's two from the bottom.

    Everything counts in pixels of the viewport.
    """

    def __init__(
        self, names: dict[Handle, str], deadband_name: str, output_name: str, font: QFont
    ) -> None:
        super().__init__()
        self._output_name = output_name
        self._names = names
        self._deadband_name = deadband_name
        self._font = font
        self._frame = QRectF()
        self._places: dict[Handle, float] = {}
        self._threshold: Threshold | None = None
        self._editable = True
        self._active: Handle | None = None
        self._message = ""
        self._message_at: Handle | None = None
        self.setZValue(50)

    @property
    def metrics(self) -> QFontMetricsF:
        """How wide and high its texts are."""
        return QFontMetricsF(self._font)

    def room_above(self) -> int:
        """How many pixels the names and grips need above the plot."""
        return round(self.metrics.height() + GRIP + 5)

    def arrange(
        self, frame: QRectF, places: dict[Handle, float], threshold: Threshold | None
    ) -> None:
        """Draw the handles at these places, over this inside of the plot."""
        if (frame, places, threshold) != (self._frame, self._places, self._threshold):
            self.prepareGeometryChange()
            self._frame, self._places, self._threshold = frame, places, threshold
            self.update()

    def set_editable(self, editable: bool) -> None:
        """Show whether the handles can be taken."""
        if editable != self._editable:
            self._editable = editable
            self.update()

    def set_active(self, handle: Handle | None) -> None:
        """Let one handle stand out."""
        if handle is not self._active:
            self._active = handle
            self.update()

    def set_message(self, handle: Handle | None, message: str) -> None:
        """Say beside a handle why it goes no further; empty: nothing is said."""
        if (handle, message) != (self._message_at, self._message):
            self._message_at, self._message = handle, message
            self.update()

    @property
    def message(self) -> str:
        """What is said beside a handle."""
        return self._message

    @property
    def message_at(self) -> Handle | None:
        """The handle beside which something is said."""
        return self._message_at if self._message else None

    def handle_at(self, where: QPointF) -> Handle | None:
        """Return the handle under the mouse: the nearest, in the lower half the deadband's."""
        if not self._editable or not self._places:
            return None
        lower = where.y() > self._frame.center().y()
        for group in (_EDGES, _MAIN) if lower else (_MAIN, _EDGES):
            distances = [(abs(self._places[handle] - where.x()), handle.value) for handle in group]
            distance, name = min(distances)
            if distance <= REACH:
                return Handle(name)
        return None

    def boundingRect(self) -> QRectF:
        return self._frame.adjusted(-80, -self.room_above() - 2, 80, 2)

    def paint(
        self,
        painter: QPainter,
        option: QStyleOptionGraphicsItem,  # noqa: ARG002 - it is drawn whole
        widget: QWidget | None = None,  # noqa: ARG002
    ) -> None:
        if not self._places:
            return
        painter.setFont(self._font)
        self._paint_threshold(painter)
        for handle in (*_EDGES, *_MAIN):
            self._paint_handle(painter, handle)
        self._paint_names(painter)
        if self._message and self._message_at is not None:
            self._paint_message(painter, self._places[self._message_at])

    def _paint_handle(self, painter: QPainter, handle: Handle) -> None:
        x, frame = round(self._places[handle]) + 0.5, self._frame
        active = handle is self._active
        color = theme().color("pointer" if active else "neutral" if handle.is_deadband else "mark")
        style = Qt.PenStyle.DotLine if handle.is_deadband else Qt.PenStyle.SolidLine
        painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
        painter.setPen(QPen(color, 2 if active else 1, style))
        painter.drawLine(QPointF(x, frame.top()), QPointF(x, frame.bottom()))
        if not self._editable:
            return
        tip, base = (
            (frame.bottom() - GRIP * 1.6, frame.bottom() - 1)
            if handle.is_deadband
            else (frame.top() + GRIP * 0.9, frame.top() - GRIP * 0.7)
        )
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(color)
        corners = [QPointF(x - GRIP, base), QPointF(x + GRIP, base), QPointF(x, tip)]
        if handle is Handle.DEADBAND_LOW:  # the two may touch: each has one half of the grip
            corners[1] = QPointF(x, base)
        elif handle is Handle.DEADBAND_HIGH:
            corners[0] = QPointF(x, base)
        painter.drawPolygon(QPolygonF(corners))

    def _paint_names(self, painter: QPainter) -> None:
        metrics = self.metrics
        texts = [self._names[handle] for handle in _MAIN]
        widths = [metrics.horizontalAdvance(text) for text in texts]
        xs = [self._places[handle] for handle in _MAIN]
        low, high = self._frame.left(), self._frame.right() + 60
        order = sorted(range(3), key=lambda index: xs[index])
        centres = spread([xs[i] for i in order], [widths[i] for i in order], low, high, 10)
        top = self._frame.top() - GRIP - metrics.height() - 2
        for index, centre in zip(order, centres or [], strict=False):
            active = _MAIN[index] is self._active
            painter.setPen(theme().color("pointer" if active else "plot_text"))
            left = centre - widths[index] / 2
            where = QRectF(left, top, widths[index] + 1, metrics.height())
            painter.drawText(where, Qt.AlignmentFlag.AlignCenter, texts[index])
        x = max(self._places[handle] for handle in _EDGES) + GRIP + 3
        width = metrics.horizontalAdvance(self._deadband_name) + 4
        where = QRectF(x, self._frame.bottom() - metrics.height() - 2, width, metrics.height())
        painter.fillRect(where, theme().color("plot_background"))
        painter.setPen(theme().color("muted"))
        painter.drawText(where, Qt.AlignmentFlag.AlignCenter, self._deadband_name)
        room = QRectF(0, top, self._frame.left() - 4, metrics.height())
        painter.drawText(room, Qt.AlignmentFlag.AlignRight, self._output_name)

    def _paint_threshold(self, painter: QPainter) -> None:
        threshold = self._threshold
        if threshold is None:
            return
        x, frame = round(threshold.x) + 0.5, self._frame
        color = theme().color("limit")
        painter.setPen(QPen(color, 1, Qt.PenStyle.DashLine))
        painter.drawLine(QPointF(x, frame.top()), QPointF(x, frame.bottom()))
        width, high = self.metrics.horizontalAdvance(threshold.text) + 2, self.metrics.height()
        left = x + 5 if threshold.above else x - 5 - width
        top = frame.top() + frame.height() * 0.3 - high / 2
        where = QRectF(left, top, width, high)
        painter.fillRect(where, theme().color("plot_background"))
        painter.drawText(where, Qt.AlignmentFlag.AlignCenter, threshold.text)

    def _paint_message(self, painter: QPainter, x: float) -> None:
        metrics, frame = self.metrics, self._frame
        width, high = metrics.horizontalAdvance(self._message) + 16, metrics.height() + 8
        left = x + 10 if x + 10 + width < frame.right() else x - 10 - width
        left = max(left, frame.left() + 4)
        box = QRectF(left, frame.top() + GRIP * 2, width, high)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(theme().color("warning"), 1))
        painter.setBrush(theme().color("plot_background"))
        painter.drawRoundedRect(box, 3, 3)
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, self._message)
