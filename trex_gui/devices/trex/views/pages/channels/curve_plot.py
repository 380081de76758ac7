"""Channel curve with draggable handles. Importing this module loads pyqtgraph."""

from dataclasses import replace

import numpy as np
from PySide6.QtCore import QSize, Qt, Signal, Slot
from PySide6.QtGui import QAccessible, QBrush, QFontMetrics, QPen, QResizeEvent
from PySide6.QtWidgets import QGraphicsEllipseItem, QGraphicsItem, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.model.calibration_moves import Handle, limit_to_input, move_handle
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.views.bars import DEFAULT_AXIS, input_labels, widened
from trex_gui.devices.trex.views.pages.channels.curve_handles import HandleLayer, Threshold
from trex_gui.ui.plotting.axes import count_labels
from trex_gui.ui.plotting.canvas import PlotCanvas
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.bar import MINUS
from trex_gui.ui.widgets.builders import column
from trex_gui.ui.widgets.painted import Painted

_OUTPUT_REACH = FULL_SCALE + 14.0  # limit of the output axis in both directions
_DOT = 5.0  # radius in pixels
_WIDEST_X_LABEL = "5000 µs"
_MIN_CURVE_LINES = 4
_DRAG_MARGIN = {InputSource.RC: 125, InputSource.ANALOG: 0}  # counts outside the outer handles


class CurvePlot(Painted):
    """Plot of a channel's output against its input. The stored curve is dashed."""

    spoken_role = QAccessible.Role.Chart

    previewed = Signal(object)  # `Calibration` at the position of the held handle
    released = Signal()  # the held handle was released, even if it was not moved
    edited = Signal(object)  # `Calibration` after the user has moved and released a handle

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._source = InputSource.RC
        self._channel = 1
        self.axis = DEFAULT_AXIS[self._source]  # raw counts at both ends of the axis
        self._stored: ChannelCurve | None = None
        self._shown: ChannelCurve | None = None
        self._preview: ChannelCurve | None = None
        self._raw: int | None = None
        self.setAccessibleName(tr("Curve of the channel"))
        description = tr("Its handles can be dragged; the fields below set the same values.")
        self.setAccessibleDescription(description)

        self._canvas = PlotCanvas(self.accessibleName(), self)
        self._canvas.viewport.setObjectName("curveViewport")
        self._canvas.viewport.setAutoFillBackground(False)  # a card has its own background
        self._deadband = self._canvas.add_band("deadband")
        self._stored_line = self._canvas.add_curve("muted", 1, Qt.PenStyle.DashLine)
        self._line = self._canvas.add_curve("pointer", 2)
        self._dot = QGraphicsEllipseItem(-_DOT, -_DOT, 2 * _DOT, 2 * _DOT)
        self._dot.setFlag(QGraphicsItem.GraphicsItemFlag.ItemIgnoresTransformations)
        self._dot.setZValue(60)
        self._canvas.add_item(self._dot)
        self.handles = HandleLayer(self._canvas.small_font())  # drawn over the curve
        self._canvas.add_overlay(self.handles)
        column(self._canvas, into=self, margins=0)

        self.handles.dragged.connect(self._on_dragged)
        self.handles.released.connect(self._on_released)
        theme().changed.connect(self._on_theme_changed)
        self._canvas.arranged.connect(self._place_handles)
        self._on_theme_changed()
        self._show_axis()
        self._show_dot()

    def show_channel(
        self,
        channel: int,
        source: InputSource,
        stored: ChannelCurve | None,
        shown: ChannelCurve | None,
        *,
        editable: bool,
    ) -> None:
        """Show the curve that the board stores now (`stored`) and after Apply (`shown`)."""
        if (channel, source) != (self._channel, self._source):
            self._cancel_drag()
            self._raw = None
        editable = editable and shown is not None
        if not editable:
            self._cancel_drag()
        self._channel, self._source = channel, source
        self._stored, self._shown = stored, shown
        self.handles.set_editable(editable)
        if self.handles.held is None:
            self._fit_axis()
        self._show_curves()

    def set_raw(self, raw: int | None) -> None:
        if raw != self._raw:
            self._raw = raw
            low, high = self.axis
            if raw is not None and not low <= raw <= high and self.handles.held is None:
                self._fit_axis()
                self._show_curves()
            self._show_dot()

    @property
    def curve(self) -> ChannelCurve | None:
        return self._preview or self._shown

    @property
    def dot(self) -> tuple[int, int] | None:
        curve, raw = self.curve, self._raw
        return None if raw is None or curve is None else (raw, curve.output(raw))

    def x_of(self, count: float) -> float:
        return self._canvas.x_of(count)

    def sizeHint(self) -> QSize:
        return QSize(self.fontMetrics().averageCharWidth() * 60, self.fontMetrics().height() * 18)

    def _fit_axis(self) -> None:
        counts = [] if self._raw is None else [self._raw]
        for curve in filter(None, (self._stored, self._shown)):
            calibration = curve.calibration
            counts += [calibration.minimum, calibration.neutral, calibration.maximum]
        margin = _DRAG_MARGIN[self._source]
        limits = (limit for count in counts for limit in (count - margin, count + margin))
        self.axis = widened(DEFAULT_AXIS[self._source], limits)
        self._show_axis()

    def _show_axis(self) -> None:
        low, high = self.axis
        margin = (high - low) * 0.02
        x = low - margin, high + margin
        widest = self._canvas.fontMetrics().horizontalAdvance(_WIDEST_X_LABEL) * 1.3
        labels = input_labels(self._source, self.axis, max(2, int(self.width() / widest)))
        self._canvas.set_axes(x, (-_OUTPUT_REACH, _OUTPUT_REACH), labels, count_labels())

    def _show_curves(self) -> None:
        shown, stored = self.curve, self._stored
        for line, curve in ((self._line, shown), (self._stored_line, stored)):
            visible = curve is not None and (curve is shown or curve != shown)
            line.set_visible(visible)
            if curve is not None and visible:
                counts, outputs = curve.corners(*self.axis)
                line.set_points(np.array(counts, dtype=float), np.array(outputs, dtype=float))
        band = None
        if shown is not None:
            neutral, deadband = shown.calibration.neutral, shown.calibration.deadband
            band = neutral - deadband, neutral + deadband
        self._deadband.set_range(band)
        self._place_handles()
        self._show_dot()

    @Slot()
    def _place_handles(self) -> None:
        curve, threshold = self.curve, None
        positions = {}
        if curve is not None:
            positions = {handle: self.x_of(handle.count(curve.calibration)) for handle in Handle}
            if (count := curve.threshold(self._channel)) is not None:
                name = tr("flip on") if self._channel == 4 else tr("override on")
                text = f"{name} ▸" if curve.reversed_ else f"◂ {name}"
                threshold = Threshold(self.x_of(count), curve.reversed_, text)
        self.handles.arrange(self._canvas.frame, positions, threshold)

    def _show_dot(self) -> None:
        dot = self.dot
        self._dot.setVisible(dot is not None)
        if dot is not None:
            self._dot.setPos(*dot)

    @Slot()
    def _on_theme_changed(self) -> None:
        self.handles.set_font(self._canvas.small_font())
        metrics, above = self._canvas.fontMetrics(), self.handles.height_above()
        side = metrics.horizontalAdvance(_WIDEST_X_LABEL) // 2 + 4
        texts = tr("Output"), f"{MINUS}{FULL_SCALE}"
        left = max(texts, key=QFontMetrics(self._canvas.small_font()).horizontalAdvance)
        self._canvas.set_margins(left=left, top=above, right=side, x_axis=True)
        self._canvas.setMinimumHeight((_MIN_CURVE_LINES + 2) * metrics.height() + above)
        self._dot.setPen(QPen(theme().color("plot_background"), 1.5))
        self._dot.setBrush(QBrush(theme().color("accent")))

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._show_axis()

    @Slot(float)
    def _on_dragged(self, x: float) -> None:
        handle, shown = self.handles.held, self._shown
        if handle is None or shown is None:
            return
        count = round(self._canvas.x_at(x))
        count, input_limit = limit_to_input(shown.calibration, handle, count, self._source)
        calibration, move_limit = move_handle(shown.calibration, handle, count)
        self._preview = replace(shown, calibration=calibration)
        # Extend the axis to the handle, so that the handle can follow the mouse.
        low, high = self.axis
        count = handle.count(calibration)
        if not low <= count <= high:
            self.axis = min(low, count), max(high, count)
            self._show_axis()
        self.handles.show_message(move_limit or input_limit)
        self._show_curves()
        self.previewed.emit(calibration)

    def _cancel_drag(self) -> None:
        self._preview = None
        self.handles.release()

    @Slot()
    def _on_released(self) -> None:
        preview, self._preview = self._preview, None
        self.released.emit()
        if preview is not None and preview != self._shown:
            self.edited.emit(preview.calibration)
        self._fit_axis()
        self._show_curves()
