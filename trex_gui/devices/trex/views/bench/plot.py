"""What was asked of a motor above what it drew, on one axis of time.

Importing it loads the plotting library: do so when it is to be shown.
"""

import math

import numpy as np
from PySide6.QtCore import QEvent, QObject, QSize, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QVBoxLayout, QWidget

from trex_gui.devices.trex.bench.profile import Profile
from trex_gui.devices.trex.bench.run import Run
from trex_gui.devices.trex.views.bench.legend import LegendKey
from trex_gui.ui.plotting.axes import count_labels, round_up, ticks, value_labels
from trex_gui.ui.plotting.canvas import PlotCanvas
from trex_gui.ui.plotting.data.pyramid import Floats

_WIDEST = "−127"
_AFTER = 0.6
_SMALLEST_CURRENT = 2.0
_MOST_SECONDS_TICKS = 8
_MOST_CURRENT_TICKS = 4
_SPEEDS = (-127, -64, 0, 64, 127)


class BenchPlot(QWidget):
    """A test, the one it is compared with, and what the next one will ask for."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("benchPlot")
        self.setAccessibleName(self.tr("Speed asked for and current drawn, against time"))
        self._run: Run | None = None
        self._before: Run | None = None
        self._profile: Profile | None = None
        self._abort: float | None = None
        self._limit: float | None = None
        self._highest = _SMALLEST_CURRENT
        self._axes = (0.0, 0.0, 0.0)

        self._speeds = PlotCanvas(self.tr("Speed asked for, against time"), self)
        self._currents = PlotCanvas(self.tr("Current drawn, against time"), self)
        for canvas, name in ((self._speeds, "benchSpeeds"), (self._currents, "benchCurrents")):
            canvas.viewport.setObjectName(name)
            canvas.viewport.setMouseTracking(True)
            canvas.viewport.installEventFilter(self)
            canvas.setMinimumHeight(70)
        dash = Qt.PenStyle.DashLine
        self._planned = self._speeds.add_curve("muted", 1, dash)
        self._wished = self._speeds.add_curve("motor1")
        self._abort_line = self._currents.add_curve("danger", 1, dash)
        self._limit_line = self._currents.add_curve("warning", 1, dash)
        self._drawn_before = self._currents.add_curve("muted")
        self._drawn = self._currents.add_curve("motor2")
        self._ends = [canvas.add_curve("neutral", 1, dash) for canvas in self._canvases]
        self._cursors = [canvas.add_curve("pointer") for canvas in self._canvases]
        self._values = QLabel(self)
        self._values.setObjectName("benchValues")
        keys = (
            LegendKey(self.tr("Asked"), "motor1", self),
            LegendKey(self.tr("Planned"), "muted", self, dashed=True),
            LegendKey(self.tr("Current"), "motor2", self),
        )
        self._before_key = LegendKey(self.tr("Compared"), "muted", self)
        self._abort_key = LegendKey(self.tr("Abort"), "danger", self, dashed=True)
        self._limit_key = LegendKey(self.tr("Limit"), "warning", self, dashed=True)

        legend = QHBoxLayout()
        legend.setSpacing(self.fontMetrics().averageCharWidth() * 2)
        for key in (*keys, self._before_key, self._abort_key, self._limit_key):
            legend.addWidget(key)
        legend.addStretch(1)
        legend.addWidget(self._values)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(2)
        layout.addLayout(legend)
        layout.addWidget(self._speeds, 2)
        layout.addWidget(self._currents, 3)

        half = self.fontMetrics().height() // 2 + 2
        side = self.fontMetrics().horizontalAdvance("000.0 s") // 2 + 2
        self._speeds.set_margins(left=_WIDEST, top=half, right=side, x_axis=False)
        self._currents.set_margins(left=_WIDEST, top=half, right=side, x_axis=True)
        self._show()

    @property
    def _canvases(self) -> tuple[PlotCanvas, PlotCanvas]:
        return self._speeds, self._currents

    @property
    def highest(self) -> float:
        """The current in A at the top of the lower plot."""
        return self._highest

    @property
    def seconds(self) -> float:
        """The time at the right end."""
        return self._seconds()

    def show_plan(self, profile: Profile, abort: float, limit: float | None) -> None:
        """Take what the next test asks for, and where it is aborted or limited, in A."""
        if (profile, abort, limit) != (self._profile, self._abort, self._limit):
            self._profile, self._abort, self._limit = profile, abort, limit
            self._planned.set_points(*_arrays(profile.course()))

    def show_runs(self, run: Run | None, before: Run | None) -> None:
        """Draw a test, which may still run, the one it is compared with, and the plan."""
        self._run, self._before = run, before
        self._show()

    def sizeHint(self) -> QSize:
        return QSize(self.fontMetrics().averageCharWidth() * 70, self.fontMetrics().height() * 16)

    # --- Drawing ------------------------------------------------------------------------

    def _seconds(self) -> float:
        lengths = [run.ended for run in (self._run, self._before) if run is not None]
        if self._profile is not None:
            lengths.append(self._profile.duration)
        return max(lengths, default=1.0) + _AFTER

    def _show(self) -> None:
        readings = [run.currents for run in (self._run, self._before) if run is not None]
        peak = max((amps for each in readings for _, amps in each), default=0.0)
        peak = max(_SMALLEST_CURRENT, 1.05 * peak)
        step = round_up(peak / _MOST_CURRENT_TICKS)
        end = self._seconds()
        axes = end, step, step * math.ceil(peak / step - 1e-9)
        if axes != self._axes:
            self._axes = axes
            self._highest = axes[2]
            self._show_axes(end, step)
        self._wished.set_points(*_steps(self._run))
        for curve, run in ((self._drawn, self._run), (self._drawn_before, self._before)):
            curve.set_points(*_arrays(run.currents if run is not None else ()))
        self._before_key.setVisible(self._before is not None)
        for line, key, at, name in (
            (self._abort_line, self._abort_key, self._abort, self.tr("Abort {0:g} A")),
            (self._limit_line, self._limit_key, self._limit, self.tr("Limit {0:g} A")),
        ):
            key.setVisible(at is not None)
            line.set_visible(at is not None and at <= self._highest)
            if at is not None:
                key.set_text(name.format(at))
                line.set_points(np.array([0.0, end]), np.array([at, at]))
        self._show_end()
        self._show_cursor(None)

    def _show_axes(self, end: float, step: float) -> None:
        marks = [(at, f"{at:g} s") for at in ticks(0, end, round_up(end / _MOST_SECONDS_TICKS))]
        x = (0.0, end)
        reach = 134.0
        self._speeds.set_axes(x, (-reach, reach), [(at, "") for at, _ in marks], count_labels())
        amps = ticks(0, self._highest, step)
        labels = value_labels(amps, self.tr("A"))
        self._currents.set_axes(
            x,
            (-0.02 * self._highest, 1.02 * self._highest),
            marks,
            labels,
        )

    def _show_end(self) -> None:
        """Mark where the motor was left to brake."""
        ended = self._run.ended if self._run is not None else None
        for line, low, high in zip(self._ends, (-134.0, 0.0), (134.0, self._highest), strict=True):
            line.set_visible(ended is not None)
            if ended is not None:
                line.set_points(np.array([ended, ended]), np.array([low, high]))

    # --- The cursor ---------------------------------------------------------------------

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Show the values under the mouse, in both plots."""
        if event.type() == QEvent.Type.MouseMove and isinstance(event, QMouseEvent):
            canvas = next(each for each in self._canvases if each.viewport is watched)
            self._show_cursor(canvas.x_at(event.position().x()))
        elif event.type() == QEvent.Type.Leave:
            self._show_cursor(None)
        return super().eventFilter(watched, event)

    def _show_cursor(self, at: float | None) -> None:
        there = at is not None and self._run is not None and 0 <= at <= self._seconds()
        for line, low, high in zip(
            self._cursors, (-134.0, 0.0), (134.0, self._highest), strict=True
        ):
            line.set_visible(there)
            if there and at is not None:
                line.set_points(np.array([at, at]), np.array([low, high]))
        self._values.setText(self._values_text(at) if there and at is not None else "")

    def _values_text(self, at: float) -> str:
        parts = [self.tr("{0:.2f} s").format(at)]
        if self._run is not None:
            parts.append(f"{self._run.wish_at(at):+d}".replace("-", "−"))
            parts.append(_amps_at(self._run, at))
        if self._before is not None:
            parts.append(self.tr("({0})").format(_amps_at(self._before, at)))
        return "  ".join(parts)


def _amps_at(run: Run, at: float) -> str:
    amps = run.current_at(at)
    return "– A" if amps is None else f"{amps:.2f} A"


def _arrays(points: object) -> tuple[Floats, Floats]:
    """Return times and values, as the canvas takes them."""
    table = np.array(points, dtype=float).reshape(-1, 2)
    return np.ascontiguousarray(table[:, 0]), np.ascontiguousarray(table[:, 1])


def _steps(run: Run | None) -> tuple[Floats, Floats]:
    """Return the commands as a line with corners: each holds until the next."""
    if run is None or not run.wishes:
        return _arrays(())
    times, speeds = _arrays(run.wishes)
    ends = np.append(times[1:], max(run.ended, times[-1]))
    x = np.column_stack([times, ends]).ravel()
    y = np.repeat(speeds, 2)
    return np.append(x, x[-1]), np.append(y, 0.0)
