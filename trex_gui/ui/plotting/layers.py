"""What lies in the plot: curves on two axes, levels across it, lines through it.

Importing it loads the plotting library.
"""

import math
from collections.abc import Callable, Collection, Sequence

import numpy as np
from PySide6.QtCore import Qt

from trex_gui.ui.devices.event_log import Event
from trex_gui.ui.plotting.axes import ValueAxis, ago_labels, since_labels
from trex_gui.ui.plotting.canvas import Curve, PlotCanvas
from trex_gui.ui.plotting.data.history import Points
from trex_gui.ui.plotting.data.pyramid import Floats
from trex_gui.ui.plotting.data.traces import TraceInfo, Traces
from trex_gui.ui.plotting.marks import COLOURS
from trex_gui.ui.plotting.span import Span

BINS = 500
"""Parts of the width that get two points each."""


class Layers:
    """Draws a source onto a canvas; x counts seconds from the right edge, so live it stands still.

    Curves of the source's first unit are on the left axis, all others on the right one: they are
    drawn in values of the left axis, for a second view box would cost as much as a second plot.
    """

    def __init__(self, canvas: PlotCanvas) -> None:
        self._canvas = canvas
        self._source: Traces | None = None
        self.curves: dict[str, Curve] = {}
        self._limits: dict[str, Curve] = {}
        self._peaks: dict[str, Curve] = {}
        self._left, self._right = ValueAxis(""), ValueAxis("")
        self._drawn_axes: object = None
        self.points_drawn = 0
        self._has_lines = False
        self._events = {
            kind: canvas.add_curve(color, 1, Qt.PenStyle.DotLine) for kind, color in COLOURS.items()
        }
        self._cursor = canvas.add_curve("pointer")
        self._mark = canvas.add_curve("pointer", 1, Qt.PenStyle.DashDotLine)

    @property
    def unit(self) -> str:
        """The unit of the left axis."""
        return self._left.unit

    def set_source(self, source: Traces) -> None:
        """Make a curve for each trace; those of a source before are emptied."""
        for curve in (*self.curves.values(), *self._limits.values(), *self._peaks.values()):
            curve.clear()
        self._source = source
        units = [trace.unit for trace in source.traces]
        self._left = ValueAxis(units[0])
        self._right = ValueAxis(next((unit for unit in units if unit != units[0]), ""))
        add = self._canvas.add_curve
        for trace in source.traces:
            line = Qt.PenStyle.DotLine if self._is_right(trace) else Qt.PenStyle.SolidLine
            self._limits[trace.name] = add(trace.color, 1, Qt.PenStyle.DashLine)
            self._peaks[trace.name] = add(trace.color, 1, Qt.PenStyle.DashDotDotLine)
            self.curves[trace.name] = add(trace.color, 1, line)

    def draw(self, span: Span, origin: float, shown: Collection[str]) -> dict[str, float]:
        """Draw the curves and the axes; return in which pixel from the top each curve ends."""
        if self._source is None:
            return {}
        lines: dict[str, Points] = {}
        extremes: dict[bool, list[tuple[float, float]]] = {False: [], True: []}
        for trace in self._source.traces:
            if trace.name not in shown:
                continue
            times, values = self._source.points(trace.name, span.start, span.end, BINS)
            if np.isfinite(values).any():
                lines[trace.name] = times - span.end, values
                ends = float(np.nanmin(values)), float(np.nanmax(values))
                extremes[self._is_right(trace)].append(ends)
        self._left.fit(extremes[False])
        self._right.fit(extremes[True])
        self._show_axes(span, origin, has_right=bool(extremes[True]))
        self.points_drawn = sum(len(x) for x, _ in lines.values())
        ends_at = {}
        for trace in self._source.traces:
            if trace.name not in lines:
                self.curves[trace.name].clear()
                continue
            x, values = lines[trace.name]
            y = self._height_of(trace, values)
            self.curves[trace.name].set_points(x, y, gaps=not np.isfinite(y).all())
            ends_at[trace.name] = float(y[-1])
        self._has_lines = bool(lines)
        # Not before the axes are those of this frame.
        return {name: self._canvas.y_of(y) for name, y in ends_at.items() if math.isfinite(y)}

    @property
    def is_empty(self) -> bool:
        """Whether there was nothing to draw."""
        return not self._has_lines

    def _is_right(self, trace: TraceInfo) -> bool:
        return trace.unit != self._left.unit

    def _height_of(self, trace: TraceInfo, values: Floats) -> Floats:
        """Return values as values of the left axis."""
        if not self._is_right(trace):
            return values
        at0, at1 = (self._right.onto(self._left, value) for value in (0.0, 1.0))
        return at0 + values * (at1 - at0)

    def _show_axes(self, span: Span, origin: float, *, has_right: bool) -> None:
        now = (
            *(span.live, span.length, self._left.reach, has_right, self._right.reach),
            None if span.live else (span.start, origin),
        )
        if now == self._drawn_axes:
            return
        self._drawn_axes = now
        start, end = span.start - origin, span.end - origin
        x_labels = ago_labels(span.length) if span.live else since_labels(start, end)
        # First the axis that takes room from the plot.
        marks = self._right.labels() if has_right else []
        heights = [(self._right.onto(self._left, value), text) for value, text in marks]
        widest = max((text for _, text in marks), key=len, default="")
        self._canvas.set_right_axis(heights, widest)
        x = -span.length, 0.0
        self._canvas.set_axes(x, self._left.reach, x_labels, self._left.labels())

    def draw_levels(
        self, span: Span, shown: Collection[str], peak_of: Callable[[str], float | None]
    ) -> None:
        """Draw limits dashed and held peaks dash-dotted, where they are in reach."""
        if self._source is None:
            return
        low, high = self._left.reach
        ends = np.array([-span.length, 0.0])
        for trace in self._source.traces:
            levels: list[tuple[Curve, float | None]] = [
                (self._limits[trace.name], self._source.limits.get(trace.name)),
                (self._peaks[trace.name], peak_of(trace.name)),
            ]
            for line, level in levels:
                height = None
                if level is not None and trace.name in shown:
                    height = float(self._height_of(trace, np.array([level]))[0])
                visible = height is not None and low <= height <= high
                line.set_visible(visible)
                if visible and height is not None:
                    line.set_points(ends, np.full_like(ends, height))

    def draw_events(self, span: Span, events: Sequence[Event]) -> list[tuple[float, Event]]:
        """Draw a line through each event; return their pixels from the left."""
        low, high = self._left.reach
        for kind, line in self._events.items():
            at = np.array([one.time - span.end for one in events if one.kind is kind])
            if len(at):
                y = np.tile([low, high, math.nan], len(at))
                line.set_points(np.repeat(at, 3), y, gaps=True)
            line.set_visible(bool(len(at)))
        return [(self._canvas.x_of(one.time - span.end), one) for one in events]

    def draw_cursors(self, span: Span, cursor: float | None, mark: float | None) -> None:
        """Draw the lines of the cursor and of the mark where they are in the picture."""
        low, high = self._left.reach
        for line, time in ((self._cursor, cursor), (self._mark, mark)):
            visible = time is not None and span.start <= time <= span.end
            line.set_visible(visible)
            if visible and time is not None:
                x = time - span.end
                line.set_points(np.array([x, x]), np.array([low, high]))
