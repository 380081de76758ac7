"""Plot of traces, live or for a past span.

Importing this module loads pyqtgraph, so import it lazily.
"""

import math
from collections.abc import Sequence
from itertools import chain
from typing import TypeVar

import numpy as np
from PySide6.QtCore import QEvent, QSize, Qt, Signal, Slot
from PySide6.QtGui import QAccessible, QFontMetrics, QKeyEvent
from PySide6.QtWidgets import QWidget

from trex_gui.core.events import Event
from trex_gui.core.translation import tr, tr_noop
from trex_gui.ui.plotting.axes import Span, ValueAxis, ago_labels, since_labels
from trex_gui.ui.plotting.canvas import Curve, Line, PlotCanvas
from trex_gui.ui.plotting.history import Floats, Points
from trex_gui.ui.plotting.marks import EVENT_LOOKS, MAX_MARKS, CurveTags, EventMarks, Readout
from trex_gui.ui.plotting.traces import TraceInfo, Traces
from trex_gui.ui.widgets.bar import MINUS
from trex_gui.ui.widgets.builders import column, named
from trex_gui.ui.widgets.labels import Muted
from trex_gui.ui.widgets.painted import Painted

BINS = 500  # parts of the plot's width; each part has two points
_PAN = 0.25  # fraction of the span per key press
_ZOOM = 0.7  # factor per key press
_FINE, _COARSE = 0.002, 0.05  # steps of the cursor, as fractions of the span
_NEAR_MARK = 6  # pixels; a click this close to the mark removes it

_KEYS = tr_noop(
    "Left and Right move the cursor, with Shift in large steps. The values at the cursor are "
    "read out here. M sets a mark, Plus and Minus zoom, and L returns to the live view."
)

FloatsT = TypeVar("FloatsT", float, Floats)


class TracePlot(Painted):
    """Curves on up to two axes, with limits, events, a cursor and a mark.

    Curves with the source's first unit use the left axis. Other curves use the right axis, and
    their values are converted to the left axis, because a second view box is as slow as a second
    plot. x is relative to the right edge, so that only the curves move in a live plot.
    """

    spoken_role = QAccessible.Role.Chart

    view_changed = Signal()  # the visible span or `span.live` has changed
    cursor_changed = Signal()  # `cursor_time` or `mark_time` has changed
    shown_changed = Signal()  # `shown` has changed
    colors_changed = Signal()  # the colour of a curve has changed

    def __init__(
        self, parent: QWidget | None = None, *, name: str = "", line_width: float = 1
    ) -> None:
        super().__init__(parent)
        self._line_width = line_width
        self.span = Span()
        self.source: Traces | None = None
        self.shown: set[str] = set()  # names of the visible curves
        self.origin: float | None = None  # time of the first sample, displayed as 0
        self.peaks_since: float | None = None  # start of peak hold; `None`: off
        self.cursor_time: float | None = None
        self.mark_time: float | None = None
        self.top: float | None = None  # upper limit of the left axis; `None`: fit the values
        self._left, self._right = ValueAxis(""), ValueAxis("")
        self._shapes: dict[str, tuple[Curve, Line, Line]] = {}  # name → curve, limit, peak
        self._drawn_axes: object = None  # parameters of the drawn axes
        self._hovered: float | None = None  # x pixel of the mouse
        self.setObjectName("tracePlot")
        self.setAccessibleName(name or tr("Plot of currents and speeds against time"))
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

        self._marks = EventMarks(self)
        self._canvas = PlotCanvas(self.accessibleName(), self, is_navigable=True)
        self._canvas.setMinimumSize(160, 90)
        self._canvas.viewport.setFocusProxy(self)
        self._events = {
            kind: self._canvas.add_curve(color, 1, Qt.PenStyle.DotLine)
            for kind, (color, _) in EVENT_LOOKS.items()
        }
        self._cursor_line = self._canvas.add_line("pointer", vertical=True)
        self._mark_line = self._canvas.add_line("pointer", Qt.PenStyle.DashDotLine, vertical=True)
        self._tags = CurveTags(self._canvas)
        self._empty = named(Muted(tr("No data yet"), self._canvas), "emptyLabel")
        self._empty.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._empty.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._readout = Readout(self._canvas)
        column(self._marks, (self._canvas, 1), into=self, margins=0, spacing=0)

        self._canvas.hovered.connect(self._on_hovered)
        self._canvas.unhovered.connect(lambda: self.set_cursor(None))
        self._canvas.clicked.connect(self._on_clicked)
        self._canvas.selected.connect(
            lambda x0, x1: self.show_span(self._time_at(x0), self._time_at(x1))
        )
        self._canvas.zoomed.connect(lambda factor, x: self._zoom(factor, self._time_at(x)))
        self._canvas.panned.connect(
            lambda pixels: self._pan(-pixels / max(1.0, self._canvas.frame.width()))
        )
        self._canvas.arranged.connect(self._on_arranged)

    def set_source(self, source: Traces) -> None:
        for shape in chain.from_iterable(self._shapes.values()):
            shape.set_visible(False)
        self.source = source
        self.origin = None
        self.shown = {trace.name for trace in source.traces if trace.shown}
        self._left = ValueAxis(source.left_unit, self.top)
        self._right = ValueAxis(source.right_unit)
        self._drawn_axes = None
        canvas, pens = self._canvas, Qt.PenStyle
        for trace in source.traces:
            style = pens.DotLine if self.uses_right_axis(trace) else pens.SolidLine
            self._shapes[trace.name] = (
                canvas.add_curve(trace.color, self._line_width, style),
                canvas.add_line(trace.color, pens.DashLine),
                canvas.add_line(trace.color, pens.DashDotDotLine),
            )
        self._tags.set_traces(source.traces)
        self._show_margins()
        self.draw()

    def set_empty_text(self, text: str) -> None:
        if text != self._empty.text():
            self._empty.setText(text)
            self._show_readout()

    def set_shown(self, name: str, shown: bool) -> None:
        (self.shown.add if shown else self.shown.discard)(name)
        self.shown_changed.emit()
        self.draw()

    def set_color(self, name: str, color: str) -> None:
        if self.source is None:
            return
        self.source.set_color(name, color)
        for shape in self._shapes[name]:
            shape.set_color(color)
        self._tags.set_traces(self.source.traces)
        self._tags.update()
        self.colors_changed.emit()

    def set_top(self, top: float | None) -> None:
        """Set the upper limit of the left axis. `None`: fit the visible curves."""
        self.top = top
        self._left = ValueAxis(self._left.unit, top)
        self.draw()

    def set_cursor(self, time: float | None) -> None:
        if time is None:
            self._hovered = None
        self.cursor_time = time
        self._show_cursors()
        self.cursor_changed.emit()

    def set_mark(self, time: float | None) -> None:
        self.mark_time = time
        self._show_cursors()
        self.cursor_changed.emit()

    def select_length(self, seconds: float) -> None:
        self.span.select_length(seconds)
        self._on_view_changed()

    def show_span(self, start: float, end: float) -> None:
        self.span.show(start, end)
        self._on_view_changed()

    def set_live(self, live: bool) -> None:
        (self.span.go_live if live else self.span.freeze)()
        self._on_view_changed()

    def _on_view_changed(self) -> None:
        self.draw()
        self.view_changed.emit()

    def draw(self) -> None:
        """Draw a frame. The drawing time does not depend on the number of samples."""
        source, span = self.source, self.span
        if source is None:
            return
        available = source.span
        if available is None:
            self.origin = None
        else:
            span.set_available(*available)
            # The origin does not move when a full history drops its oldest samples.
            if self.origin is None or available[0] < self.origin:
                self.origin = available[0]
        lines = self._fit_axes(source)
        heights = self._draw_curves(source, lines)
        for trace in source.traces:
            levels = (source.limits.get(trace.name), self.peak_of(trace.name))
            for line, level in zip(self._shapes[trace.name][1:], levels, strict=True):
                height = None if level is None else self._height(trace, level)
                line.set_value(height if trace.name in self.shown else None)
        self._draw_events(source.events_between(span.start, span.end)[-MAX_MARKS:])
        self._empty.setVisible(not lines)
        self._show_cursors()
        self._tags.set_heights(heights)

    def _fit_axes(self, source: Traces) -> dict[str, Points]:
        """Fit the axes to the visible curves. Return curve name → points."""
        span, lines = self.span, {}
        extremes: dict[bool, list[tuple[float, float]]] = {False: [], True: []}
        for trace in source.traces:
            if trace.name not in self.shown:
                continue
            times, values = source.points(trace.name, span.start, span.end, BINS)
            if np.isfinite(values).any():
                lines[trace.name] = times - span.end, values
                ends = float(np.nanmin(values)), float(np.nanmax(values))
                extremes[self.uses_right_axis(trace)].append(ends)
        self._left.fit(extremes[False])
        self._right.fit(extremes[True])
        self._show_axes(has_right=bool(extremes[True]))
        return lines

    def _show_axes(self, *, has_right: bool) -> None:
        span, origin, left, right = self.span, self.origin or 0.0, self._left, self._right
        limit = self._canvas.labels_in_height()
        axes = (
            *(span.live, span.length, left.reach, has_right, right.reach, limit),
            None if span.live else (span.start, origin),
        )
        if axes == self._drawn_axes:
            return
        self._drawn_axes = axes
        since = since_labels(span.start - origin, span.end - origin)
        x_labels = ago_labels(span.length) if span.live else since
        # Set the right axis first, since it changes the width of the plot.
        labels = right.labels(limit) if has_right else []
        self._canvas.set_right_axis([(right.map_to(left, value), text) for value, text in labels])
        self._canvas.set_axes((-span.length, 0.0), left.reach, x_labels, left.labels(limit))

    def _draw_curves(self, source: Traces, lines: dict[str, Points]) -> dict[str, float]:
        """Draw the curves. Return curve name → y pixel of its end."""
        heights = {}
        for trace in source.traces:
            curve, line = self._shapes[trace.name][0], lines.get(trace.name)
            curve.set_visible(line is not None)
            if line is not None:
                y = self._height(trace, line[1])
                curve.set_points(line[0], y, gaps=not np.isfinite(y).all())
                if math.isfinite(y[-1]):
                    heights[trace.name] = self._canvas.y_of(float(y[-1]))
        return heights

    def _draw_events(self, events: Sequence[Event]) -> None:
        low, high = self._left.reach
        end = self.span.end
        for kind, line in self._events.items():
            x = np.array([event.time - end for event in events if event.kind is kind])
            line.set_visible(bool(len(x)))
            if len(x):
                y = np.tile([low, high, math.nan], len(x))
                line.set_points(np.repeat(x, 3), y, gaps=True)
        self._marks.set_marks([(self._canvas.x_of(event.time - end), event) for event in events])

    def uses_right_axis(self, trace: TraceInfo) -> bool:
        """Return whether a curve uses the right axis. Such curves are dotted."""
        return trace.unit != self._left.unit

    def _height(self, trace: TraceInfo, value: FloatsT) -> FloatsT:
        if not self.uses_right_axis(trace):
            return value
        height0, height1 = (self._right.map_to(self._left, level) for level in (0.0, 1.0))
        return height0 + value * (height1 - height0)

    def peak_of(self, name: str) -> float | None:
        """Return the held peak of a curve, or `None`."""
        if self.source is None or self.peaks_since is None:
            return None
        high = self.source.statistics(name, self.peaks_since, math.inf).high
        return high if math.isfinite(high) else None

    def _show_cursors(self) -> None:
        if self._hovered is not None:
            self.cursor_time = self._time_at(self._hovered)
        end = self.span.end
        for line, time in (
            (self._cursor_line, self.cursor_time),
            (self._mark_line, self.mark_time),
        ):
            line.set_value(None if time is None else time - end)
        self._show_readout()

    def _show_readout(self) -> None:
        time, source = self.cursor_time, self.source
        if time is None or source is None or not self.span.start <= time <= self.span.end:
            self._readout.hide()
            is_empty = self._empty.isVisibleTo(self)
            self.setAccessibleDescription(self._empty.text() if is_empty else tr(_KEYS))
            return
        self._readout.show_values(source, time, self.mark_time, self.origin or 0.0, self.shown)
        if self._hovered is None:  # otherwise a screen reader would read each frame aloud
            self.setAccessibleDescription(self._readout.text())
        self._readout.show_beside(self._canvas.x_of(time - self.span.end), self._canvas.frame)

    def _time_at(self, x: float) -> float:
        return self.span.end + min(0.0, max(-self.span.length, self._canvas.x_at(x)))

    @Slot(float)
    def _on_hovered(self, x: float) -> None:
        if self.source is not None:
            self._hovered = x
            self.set_cursor(self._time_at(x))

    @Slot(float)
    def _on_clicked(self, x: float) -> None:
        mark = self.mark_time
        mark_x = None if mark is None else self._canvas.x_of(mark - self.span.end)
        is_near = mark_x is not None and abs(mark_x - x) < _NEAR_MARK
        self.set_mark(None if is_near else self._time_at(x))

    def _zoom(self, factor: float, around: float) -> None:
        self.span.zoom(factor, around)
        self._on_view_changed()

    def _pan(self, fraction: float) -> None:
        self.span.pan(fraction * self.span.length)
        self._on_view_changed()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        span, modifiers = self.span, event.modifiers()
        cursor = self.cursor_time if self.cursor_time is not None else span.end
        match event.key():
            case Qt.Key.Key_Left | Qt.Key.Key_Right as key:
                sign = -1 if key == Qt.Key.Key_Left else 1
                if modifiers & Qt.KeyboardModifier.ControlModifier:
                    self._pan(sign * _PAN)
                else:
                    with_shift = modifiers & Qt.KeyboardModifier.ShiftModifier
                    step = sign * (_COARSE if with_shift else _FINE) * span.length
                    self._hovered = None
                    self.set_cursor(min(span.end, max(span.start, cursor + step)))
            case Qt.Key.Key_Home:
                self.set_cursor(span.start)
            case Qt.Key.Key_End:
                self.set_cursor(span.end)
            case Qt.Key.Key_Plus | Qt.Key.Key_Equal:
                self._zoom(_ZOOM, cursor)
            case Qt.Key.Key_Minus:
                self._zoom(1 / _ZOOM, cursor)
            case Qt.Key.Key_M:
                self.set_mark(self.cursor_time if self.mark_time is None else None)
            case Qt.Key.Key_L:
                self.set_live(True)
            case _:
                super().keyPressEvent(event)

    def sizeHint(self) -> QSize:
        return QSize(self.fontMetrics().averageCharWidth() * 80, self.fontMetrics().height() * 16)

    def _show_margins(self) -> None:
        metrics = QFontMetrics(self._canvas.small_font())
        now = metrics.horizontalAdvance(tr("now")) // 2
        right = max(now, self._tags.sizeHint().width()) + 2
        widest = f"{MINUS}0.005 {self._left.unit}"
        self._canvas.set_margins(
            left=widest, top=metrics.height() // 2 + 2, right=right, x_axis=True
        )

    @Slot()
    def _on_arranged(self) -> None:
        box = self._canvas.frame.toRect()
        self._empty.setGeometry(box)
        left = int(self._canvas.right_edge) + 1
        self._tags.setGeometry(left, 0, self._tags.sizeHint().width(), box.bottom() + 6)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange and hasattr(self, "_readout"):
            self._show_margins()
