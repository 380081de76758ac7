"""A channel's curve with handles to drag and a live dot, above the trace of its input.

Importing it loads the plotting library: do so when it is to be shown.
"""

import numpy as np
from PySide6.QtCore import QEvent, QObject, QPointF, QRectF, QSize, Qt, Signal, Slot
from PySide6.QtGui import QBrush, QMouseEvent, QPen, QResizeEvent
from PySide6.QtWidgets import (
    QGraphicsEllipseItem,
    QGraphicsItem,
    QGraphicsRectItem,
    QVBoxLayout,
    QWidget,
)

from trex_gui.devices.trex.model.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.model.calibration.moves import Handle, moved, within_input
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE, Calibration
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.views.pages.calibration.curve_handles import GRIP, HandleLayer, Threshold
from trex_gui.devices.trex.views.pages.calibration.input_axis import axis_for, input_ticks
from trex_gui.devices.trex.views.pages.calibration.input_trace import InputTrace
from trex_gui.ui.plotting.axes import count_labels
from trex_gui.ui.plotting.canvas import PlotCanvas
from trex_gui.ui.plotting.data.pyramid import Floats
from trex_gui.ui.theme.theme import theme

_OUTPUT_ROOM = 14
_OUTPUT_TICKS = (-127, -64, 0, 64, 127)
_DOT = 5.0
_WIDEST_TICK = "Output"
_LEAST_LINES = 6


class CurvePlot(QWidget):
    """Shows what a channel makes of its input, and lets its calibration be dragged.

    What is stored stays to be seen, dashed, beneath what is edited. Both plots share the
    input axis.

    Signals:
        previewed: the calibration as a handle that is held would leave it.
        let_go: no handle is held any more, whether or not one was moved.
        wished: the calibration that the released handle left; one edit.
    """

    previewed = Signal(object)
    let_go = Signal()
    wished = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._source = InputSource.RC
        self._channel = 1
        self._axis = axis_for(self._source, ())
        self._stored: ChannelCurve | None = None
        self._shown: ChannelCurve | None = None
        self._held: Handle | None = None
        self._grabbed_at = 0.0
        self._preview: ChannelCurve | None = None
        self._editable = True
        self._raw: int | None = None
        self.setAccessibleName(self.tr("Curve of the channel"))

        self._canvas = PlotCanvas(self.accessibleName(), self)
        self._canvas.viewport.setObjectName("curveViewport")
        self._canvas.viewport.setMouseTracking(True)
        self._canvas.viewport.installEventFilter(self)
        self._deadband = QGraphicsRectItem()
        self._deadband.setZValue(-20)
        self._canvas.add_item(self._deadband)
        self._stored_line = self._canvas.add_curve("muted", 1, Qt.PenStyle.DashLine)
        self._line = self._canvas.add_curve("motor1", 2)
        self._now = QGraphicsRectItem()  # a line that is as wide as nothing
        self._canvas.add_item(self._now)
        self._dot = QGraphicsEllipseItem(-_DOT, -_DOT, 2 * _DOT, 2 * _DOT)
        self._dot.setFlag(QGraphicsItem.GraphicsItemFlag.ItemIgnoresTransformations)
        self._dot.setZValue(60)
        self._canvas.add_item(self._dot)
        names = {
            Handle.MINIMUM: self.tr("Minimum"),
            Handle.NEUTRAL: self.tr("Neutral"),
            Handle.MAXIMUM: self.tr("Maximum"),
        }
        self._handles = HandleLayer(
            names, self.tr("deadband"), self.tr("Output"), self._canvas.small_font()
        )
        self._canvas.add_overlay(self._handles)
        self._trace = InputTrace(self)

        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addWidget(self._canvas, 2)
        layout.addWidget(self._trace, 1)

        side = self._canvas.fontMetrics().horizontalAdvance("5000 µs") // 2 + 4
        self._canvas.set_margins(
            left=_WIDEST_TICK, top=self._handles.room_above(), right=side, x_axis=True
        )
        line = self._canvas.fontMetrics().height()
        self._canvas.setMinimumHeight((_LEAST_LINES + 2) * line + self._handles.room_above())
        self._trace.set_margins(left=_WIDEST_TICK, right=side)
        theme().changed.connect(self._on_theme_changed)
        self._canvas.arranged.connect(self._place_handles)
        self._on_theme_changed()
        self._show_axis()
        self._show_dot()

    # --- What is shown ------------------------------------------------------------------

    def show_channel(
        self,
        channel: int,
        source: InputSource,
        stored: ChannelCurve | None,
        shown: ChannelCurve | None,
        *,
        editable: bool,
    ) -> None:
        """Show a channel: what the board stores and what it would store after Apply."""
        if (channel, source) != (self._channel, self._source):
            self._let_go()
            self._handles.set_message(None, "")
            self._raw = None
            self._trace.clear()
        if not editable or shown is None:
            self._let_go()
        self._channel, self._source = channel, source
        self._stored, self._shown = stored, shown
        self._editable = editable and shown is not None
        self._handles.set_editable(self._editable)
        if self._held is None:
            self._fit_axis()
        self._show_curves()

    def set_raw(self, raw: int | None) -> None:
        """Let the dot stand at a count; `None`: there is no valid signal."""
        if raw != self._raw:
            self._raw = raw
            low, high = self._axis
            if raw is not None and not low <= raw <= high and self._held is None:
                self._fit_axis()
                self._show_curves()
            self._show_dot()

    def set_trace(self, times: Floats, counts: Floats, now: float) -> None:
        """Draw the input of the last seconds; `times` rise."""
        self._trace.set_samples(times, counts, now)

    def show_trace(self, wanted: bool) -> None:
        """Show the trace of the input, or leave its room to the curve: nothing comes in."""
        self._trace.setVisible(wanted)

    @property
    def axis(self) -> tuple[int, int]:
        """The raw counts at the left and the right end."""
        return self._axis

    @property
    def curve(self) -> ChannelCurve | None:
        """What is drawn: as a held handle has it, else as it would be stored."""
        return self._preview or self._shown

    @property
    def dot(self) -> tuple[int, int] | None:
        """Where the live dot is: raw count and output; `None`: there is none."""
        curve = self.curve
        if self._raw is None or curve is None:
            return None
        return self._raw, curve.output(self._raw)

    @property
    def message(self) -> str:
        """What is said beside a handle: why it goes no further, or was not set so."""
        return self._handles.message

    @property
    def message_at(self) -> Handle | None:
        """The handle beside which something is said."""
        return self._handles.message_at

    def say_beside(self, handle: Handle, message: str) -> None:
        """Say why a handle was not set as was wished, until it is held or that is taken back.

        An empty message takes it back. While a handle is held it has the word.
        """
        if self._held is None:
            self._handles.set_message(handle, message)

    def place_of(self, handle: Handle) -> QPointF:
        """Return where a handle can be taken, in pixels of the viewport."""
        curve = self.curve
        if curve is None:
            return QPointF()
        frame = self._canvas.frame
        y = frame.bottom() - GRIP if handle.is_deadband else frame.top() + 2
        return QPointF(self._canvas.x_of(handle.count(curve.calibration)), y)

    def x_of(self, count: float) -> float:
        """Return where a count lies, in pixels from the left of the viewport."""
        return self._canvas.x_of(count)

    def sizeHint(self) -> QSize:
        return QSize(self.fontMetrics().averageCharWidth() * 60, self.fontMetrics().height() * 18)

    # --- Drawing ------------------------------------------------------------------------

    def _fit_axis(self) -> None:
        counts = [] if self._raw is None else [self._raw]
        for curve in (self._stored, self._shown):
            if curve is not None:
                counts += [curve.calibration.minimum, curve.calibration.neutral]
                counts += [curve.calibration.maximum]
        axis = axis_for(self._source, counts)
        if axis != self._axis:
            self._axis = axis
        self._show_axis()

    def _show_axis(self) -> None:
        low, high = self._axis
        margin = (high - low) * 0.02
        widest = self._canvas.fontMetrics().horizontalAdvance("5000 µs") * 1.3
        most = max(2, int(self.width() / widest))
        x_ticks = input_ticks(self._source, self._axis, most)
        reach = float(FULL_SCALE + _OUTPUT_ROOM)
        self._canvas.set_axes(
            (low - margin, high + margin),
            (-reach, reach),
            x_ticks,
            count_labels(),
        )
        self._trace.set_axis((low - margin, high + margin), [(at, "") for at, _ in x_ticks])

    def _show_curves(self) -> None:
        shown, stored = self.curve, self._stored
        low, high = self._axis
        for line, curve in ((self._line, shown), (self._stored_line, stored)):
            visible = curve is not None and (curve is shown or curve != shown)
            line.set_visible(visible)
            if curve is not None and visible:
                counts, outputs = curve.corners(low, high)
                line.set_points(np.array(counts, dtype=float), np.array(outputs, dtype=float))
        calibration = shown.calibration if shown is not None else None
        self._deadband.setVisible(calibration is not None)
        if calibration is not None:
            left = calibration.neutral - calibration.deadband
            reach = FULL_SCALE + _OUTPUT_ROOM
            self._deadband.setRect(QRectF(left, -reach, 2 * calibration.deadband, 2 * reach))
        self._trace.set_marks(calibration)
        self._place_handles()
        self._show_dot()

    @Slot()
    def _place_handles(self) -> None:
        curve = self.curve
        if curve is None:
            self._handles.arrange(self._canvas.frame, {}, None)
            return
        places = {handle: self._canvas.x_of(handle.count(curve.calibration)) for handle in Handle}
        self._handles.arrange(self._canvas.frame, places, self._threshold(curve))

    def _threshold(self, curve: ChannelCurve) -> Threshold | None:
        at = curve.threshold(self._channel)
        if at is None:
            return None
        name = self.tr("flip on") if self._channel == 4 else self.tr("override on")
        text = f"{name} ▸" if curve.reversed_ else f"◂ {name}"
        return Threshold(self._canvas.x_of(at), curve.reversed_, text)

    def _show_dot(self) -> None:
        dot = self.dot
        self._dot.setVisible(dot is not None)
        self._now.setVisible(dot is not None)
        if dot is not None:
            self._dot.setPos(*dot)
            reach = FULL_SCALE + _OUTPUT_ROOM
            self._now.setRect(QRectF(dot[0], -reach, 0, reach + dot[1]))

    @Slot()
    def _on_theme_changed(self) -> None:
        color = theme().color
        self._deadband.setPen(QPen(Qt.PenStyle.NoPen))
        self._deadband.setBrush(QBrush(color("deadband")))
        self._dot.setPen(QPen(color("plot_background"), 1.5))
        self._dot.setBrush(QBrush(color("motor2")))
        now = QPen(color("motor2"), 1)
        now.setCosmetic(True)
        self._now.setPen(now)
        self._handles.update()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._show_axis()

    # --- Dragging -----------------------------------------------------------------------

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Take the mouse over the curve; the plot itself can do nothing with it."""
        if watched is not self._canvas.viewport or not isinstance(event, QMouseEvent):
            if event.type() == QEvent.Type.Leave and self._held is None:
                self._handles.set_active(None)
            return super().eventFilter(watched, event)
        match event.type():
            case QEvent.Type.MouseButtonPress if event.button() == Qt.MouseButton.LeftButton:
                self._take(event.position())
            case QEvent.Type.MouseMove if self._held is not None:
                self._drag(event.position())
            case QEvent.Type.MouseMove:
                self._hover(event.position())
            case QEvent.Type.MouseButtonRelease if event.button() == Qt.MouseButton.LeftButton:
                self._release()
        return True

    def _hover(self, where: QPointF) -> None:
        handle = self._handles.handle_at(where)
        self._handles.set_active(handle)
        shape = Qt.CursorShape.ArrowCursor if handle is None else Qt.CursorShape.SizeHorCursor
        if self._canvas.viewport.cursor().shape() is not shape:
            self._canvas.viewport.setCursor(shape)

    def _take(self, where: QPointF) -> None:
        handle = self._handles.handle_at(where)
        if handle is None or self._shown is None:
            return
        self._handles.set_message(None, "")
        self._held = handle
        self._grabbed_at = where.x() - self._canvas.x_of(handle.count(self._shown.calibration))
        self._handles.set_active(handle)

    def _drag(self, where: QPointF) -> None:
        if self._held is None or self._shown is None:
            return
        calibration = self._shown.calibration
        wished = round(self._canvas.x_at(where.x() - self._grabbed_at))
        count, why = within_input(calibration, self._held, wished, self._source)
        move = moved(calibration, self._held, count)
        self._preview = _with(self._shown, move.calibration)
        self._reach(self._held.count(move.calibration))
        self._handles.set_message(self._held, move.why or why)
        self._show_curves()
        self.previewed.emit(move.calibration)

    def _reach(self, count: int) -> None:
        """Let the axis go as far as a handle is pulled, and no further: it stays at the mouse."""
        low, high = self._axis
        if not low <= count <= high:
            self._axis = min(low, count), max(high, count)
            self._show_axis()

    def _release(self) -> None:
        preview, shown = self._preview, self._shown
        was_held = self._held is not None
        self._let_go()
        if preview is not None and shown is not None and preview != shown:
            self.wished.emit(preview.calibration)
        if was_held:
            self._fit_axis()
            self._show_curves()

    def _let_go(self) -> None:
        was_held = self._held is not None
        self._held = None
        self._preview = None
        self._handles.set_active(None)
        if was_held:
            self._handles.set_message(None, "")
            self.let_go.emit()


def _with(curve: ChannelCurve, calibration: Calibration) -> ChannelCurve:
    return ChannelCurve(calibration, curve.reversed_, curve.parabolic, curve.ignored)
