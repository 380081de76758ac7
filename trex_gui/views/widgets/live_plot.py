"""A scrolling plot of live values.

Importing it loads the plotting library, which takes as long as all of Qt: do so when a plot is
to be shown, not at the start.
"""

import math
from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import QEvent, QSize, Qt, Slot
from PySide6.QtGui import QFontMetrics, QPalette
from PySide6.QtWidgets import QHBoxLayout, QLabel, QVBoxLayout, QWidget

from trex_gui.views.theme import theme
from trex_gui.views.widgets.axis import AutoRange, round_up, ticks
from trex_gui.views.widgets.bar import MINUS
from trex_gui.views.widgets.plot_canvas import PlotCanvas, signed
from trex_gui.views.widgets.plot_legend import CurveStyle, LegendEntry, Tags
from trex_gui.views.widgets.reduction import Floats, reduce_min_max

__all__ = ["CurveStyle", "LivePlot"]

BINS = 500
_TIME_STEPS = (0.5, 1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 60.0, 120.0, 300.0, 600.0)
_MOST_TIME_TICKS = 7


class LivePlot(QWidget):
    """Curves over the last seconds; the newest value is at the right edge.

    Colour is not the only thing that tells the curves apart: each ends in a tag with its
    letters, and the legend repeats them.
    """

    def __init__(
        self,
        curves: Sequence[CurveStyle],
        unit: str,
        window: float = 30.0,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._unit = unit
        self._window = window
        self._range = AutoRange()
        self._extremes: dict[str, tuple[float, float]] = {}
        self._latest: dict[str, float] = {}
        self._limits: dict[str, float] = {}
        self.setAccessibleName(self.tr("Live plot"))

        self._legend = {style.name: LegendEntry(style, unit, self) for style in curves}
        self._plot = PlotCanvas(self)
        self._plot.setMinimumSize(160, 90)
        self._limit_lines = {
            style.name: self._plot.add_curve(style.color, style=Qt.PenStyle.DashLine)
            for style in curves
        }
        self._curves = {style.name: self._plot.add_curve(style.color) for style in curves}
        self._tags = Tags(curves, self._plot)
        self._empty = QLabel(self.tr("No data yet"), self._plot)
        self._empty.setObjectName("emptyLabel")
        self._empty.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._empty.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)

        legend = QHBoxLayout()
        legend.setSpacing(self.fontMetrics().averageCharWidth() * 3)
        for entry in self._legend.values():
            legend.addWidget(entry)
        legend.addStretch()
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addLayout(legend)
        layout.addWidget(self._plot, 1)

        theme().changed.connect(self._on_theme_changed)
        self._plot.arranged.connect(self._on_arranged)

        self._on_theme_changed()
        self._show_margins()
        self._show_ranges()

    @property
    def window_seconds(self) -> float:
        """How far back the left edge is."""
        return self._window

    @property
    def y_range(self) -> tuple[float, float]:
        """The values at the bottom and the top."""
        return self._range.low, self._range.high

    def set_window(self, seconds: float) -> None:
        """Show this many seconds; the curves follow with their next samples."""
        if seconds <= 0:
            raise ValueError(f"a window of {seconds} s shows nothing")
        if seconds == self._window:
            return
        self._window = seconds
        self._show_ranges()

    def set_samples(self, name: str, times: Floats, values: Floats, now: float) -> None:
        """Show these samples of one curve; `times` rise and count in seconds, as `now` does."""
        start = now - self._window
        x, y = reduce_min_max(times, values, start, now, BINS)
        finite = np.isfinite(y)
        if not finite.any():
            self._extremes.pop(name, None)
            self._latest.pop(name, None)
            self._curves[name].clear()
        else:
            self._extremes[name] = (float(np.nanmin(y)), float(np.nanmax(y)))
            last = float(y[-1])
            if math.isfinite(last):
                self._latest[name] = last
            else:
                self._latest.pop(name, None)
            self._curves[name].set_points(x - now, y, gaps=not finite.all())
        self._legend[name].set_value(self._latest.get(name))
        self._fit()
        self._show_tags()
        self._empty.setVisible(not self._extremes)

    def set_limit(self, name: str, value: float | None) -> None:
        """Draw a dashed line at a curve's limit; one above the range is only in the legend."""
        if value is None:
            self._limits.pop(name, None)
        else:
            self._limits[name] = value
        self._legend[name].set_limit(value)
        self._show_limits()

    def forget_values(self) -> None:
        """Show no values of the present beside the names; the curves stay."""
        for entry in self._legend.values():
            entry.set_value(None)

    def clear(self) -> None:
        """Forget all samples; limits and window stay."""
        self._extremes.clear()
        self._latest.clear()
        for name, curve in self._curves.items():
            curve.clear()
            self._legend[name].set_value(None)
        self._range.reset()
        self._show_ranges()
        self._empty.show()

    def sizeHint(self) -> QSize:
        return QSize(self.fontMetrics().averageCharWidth() * 80, self.fontMetrics().height() * 16)

    def _fit(self) -> None:
        extremes = list(self._extremes.values())
        if not extremes:
            return
        lowest = min(low for low, _ in extremes)
        highest = max(high for _, high in extremes)
        if self._range.include(lowest, highest):
            self._show_ranges()

    def _show_ranges(self) -> None:
        low, high = self._range.low, self._range.high
        # A margin of a hundredth keeps lines at the ends of the range visible.
        margin = (high - low) * 0.012
        y_ticks = ticks(low, high, round_up((high - low) / 5.5))
        x_ticks = ticks(-self._window, 0, self._time_step())
        names = [signed(y) for y in y_ticks]
        names[-1] += f" {self._unit}"
        self._plot.set_axes(
            (-self._window, 0),
            (low - margin, high + margin),
            [(x, self._time_text(x)) for x in x_ticks],
            list(zip(y_ticks, names, strict=True)),
        )
        self._show_limits()

    def _time_step(self) -> float:
        for step in _TIME_STEPS:
            if self._window / step <= _MOST_TIME_TICKS:
                return step
        return round_up(self._window / _MOST_TIME_TICKS)

    def _time_text(self, x: float) -> str:
        if x == 0:
            return self.tr("now")
        if self._window >= 120 and -x % 60 == 0:
            return self.tr("{n} min").format(n=f"{-x / 60:g}")
        return self.tr("{n} s").format(n=f"{-x:g}")

    def _show_limits(self) -> None:
        ends = np.array([-self._window, 0.0])
        for name, line in self._limit_lines.items():
            limit = self._limits.get(name)
            visible = limit is not None and self._range.low <= limit <= self._range.high
            line.set_visible(visible)
            if limit is not None and visible:
                line.set_points(ends, np.full_like(ends, limit))

    def _show_tags(self) -> None:
        # The strip over the plot starts at its top, so y needs no further mapping.
        where = {name: self._plot.y_of(value) for name, value in self._latest.items()}
        self._tags.set_heights(where)

    def _show_margins(self) -> None:
        metrics = QFontMetrics(self._plot.small_font())
        # Half a label must fit beside the ends of the axes.
        half = metrics.height() // 2 + 2
        now = metrics.horizontalAdvance(self.tr("now")) // 2
        side = max(now, self._tags.sizeHint().width()) + 2
        widest = f"{MINUS}0.005 {self._unit}"
        self._plot.set_margins(left=widest, top=half, right=side, x_axis=True)

    @Slot()
    def _on_theme_changed(self) -> None:
        palette = QPalette()
        palette.setColor(QPalette.ColorRole.WindowText, theme().color("muted"))
        self._empty.setPalette(palette)

    @Slot()
    def _on_arranged(self) -> None:
        box = self._plot.frame.toRect()
        self._empty.setGeometry(box)
        width = self._tags.sizeHint().width()
        self._tags.setGeometry(box.left() + box.width() + 1, 0, width, box.bottom() + 6)
        self._show_tags()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange and hasattr(self, "_empty"):
            self._show_margins()
