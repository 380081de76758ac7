"""Plot of the setpoint and current of a bench test. Importing this module loads pyqtgraph."""

import math

import numpy as np
from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QAccessible
from PySide6.QtWidgets import QWidget

from trex_gui.core.texts import title_of
from trex_gui.core.translation import Number, tr
from trex_gui.devices.trex.bench.run import Profile, Run
from trex_gui.ui.plotting.axes import count_labels, round_up, ticks, value_labels
from trex_gui.ui.plotting.canvas import PlotCanvas
from trex_gui.ui.plotting.history import Floats
from trex_gui.ui.widgets.bar import MINUS
from trex_gui.ui.widgets.builders import column, named, row
from trex_gui.ui.widgets.labels import LegendKey
from trex_gui.ui.widgets.painted import Painted

_SPEED_REACH = 134.0  # limit of the speed axis in both directions
_AFTER = 0.6  # seconds shown after the end of a test
_MIN_CURRENT = 2.0  # A; the current axis extends at least to this value
_MAX_SECONDS_LABELS = 8
_MAX_CURRENT_LABELS = 4


class BenchPlot(Painted):
    spoken_role = QAccessible.Role.Chart

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        named(self, "benchPlot", accessible=title_of(tr("&Bench test…")))
        self.setAccessibleDescription(tr("The table contains the results as numbers."))
        self._run: Run | None = None
        self._before: Run | None = None
        self._profile: Profile | None = None
        self._axes = (0.0, 0.0)
        self.highest = _MIN_CURRENT  # upper limit of the current axis, in A

        self._speeds = PlotCanvas(tr("Speed setpoint against time"), self)
        self._currents = PlotCanvas(tr("Motor current against time"), self)
        canvases = {"benchSpeeds": self._speeds, "benchCurrents": self._currents}
        half = self.fontMetrics().height() // 2 + 2
        side = self.fontMetrics().horizontalAdvance("000.0 s") // 2 + 2
        for name, canvas in canvases.items():
            canvas.viewport.setObjectName(name)
            canvas.setMinimumHeight(70)
            has_labels = canvas is self._currents
            canvas.set_margins(left=f"{MINUS}127", top=half, right=side, x_axis=has_labels)
        dash = Qt.PenStyle.DashLine
        self._planned = self._speeds.add_curve("muted", 1, dash)
        self._setpoints = self._speeds.add_curve("window_text")
        self._abort_line = self._currents.add_line("danger", dash)
        self._limit_line = self._currents.add_line("warning", dash)
        self._previous_current = self._currents.add_curve("muted")
        self._current = self._currents.add_curve("accent")
        self._ends = [
            canvas.add_line("neutral", dash, vertical=True) for canvas in canvases.values()
        ]
        self._before_key = LegendKey(tr("Compared"), "muted", self)
        self._abort_key = LegendKey("", "danger", self, dash)
        self._limit_key = LegendKey("", "warning", self, dash)
        setpoint = LegendKey(tr("Setpoint"), "window_text", self)
        planned = LegendKey(tr("Planned"), "muted", self, dash)
        current = LegendKey(tr("Current"), "accent", self)
        keys = setpoint, planned, current, self._before_key, self._abort_key, self._limit_key
        gap = self.fontMetrics().averageCharWidth() * 2
        legend = row(*keys, 1, spacing=gap)
        column(legend, (self._speeds, 2), (self._currents, 3), into=self, margins=0, spacing=2)
        self.show_runs(None, None)

    @property
    def seconds(self) -> float:
        """Time at the right edge of the plots."""
        lengths = [run.ended for run in (self._run, self._before) if run is not None]
        if self._profile is not None:
            lengths.append(self._profile.duration)
        return max(lengths, default=1.0) + _AFTER

    def show_plan(self, profile: Profile, abort: float, limit: float | None) -> None:
        """Show the planned profile, its abort current and the current limit of the motor, in A."""
        if profile != self._profile:
            self._profile = profile
            self._planned.set_points(*_arrays(profile.course()))
        self._abort_line.set_value(abort)
        self._abort_key.setText(tr("Abort {0:g} A").format(Number(abort)))
        self._limit_line.set_value(limit)
        self._limit_key.setVisible(limit is not None)
        self._limit_key.setText(tr("Limit {0:g} A").format(Number(limit or 0)))

    def show_runs(self, run: Run | None, before: Run | None) -> None:
        """Show a test, which may still be running, and an earlier test for comparison."""
        self._run, self._before = run, before
        peak = max((amps for test in (run, before) if test for _, amps in test.currents), default=0)
        peak = max(_MIN_CURRENT, 1.05 * peak)
        axes = self.seconds, round_up(peak / _MAX_CURRENT_LABELS)
        highest = axes[1] * math.ceil(peak / axes[1] - 1e-9)
        if axes != self._axes or highest != self.highest:
            self._axes, self.highest = axes, highest
            self._show_axes(*axes)
        self._setpoints.set_points(*_steps(run))
        for curve, test in ((self._current, run), (self._previous_current, before)):
            curve.set_points(*_arrays(test.currents if test is not None else ()))
        self._before_key.setVisible(before is not None)
        for end in self._ends:
            end.set_value(run.ended if run is not None else None)

    def sizeHint(self) -> QSize:
        return QSize(self.fontMetrics().averageCharWidth() * 70, self.fontMetrics().height() * 16)

    def _show_axes(self, end: float, step: float) -> None:
        marks = ticks(0, end, round_up(end / _MAX_SECONDS_LABELS))
        x, margin = (0.0, end), 0.02 * self.highest
        self._speeds.set_axes(
            x, (-_SPEED_REACH, _SPEED_REACH), [(mark, "") for mark in marks], count_labels()
        )
        self._currents.set_axes(
            x,
            (-margin, self.highest + margin),
            [(mark, f"{Number(mark):g} s") for mark in marks],
            value_labels(ticks(0, self.highest, step), tr("A")),
        )


def _arrays(points: object) -> tuple[Floats, Floats]:
    """Return times and values as arrays for the canvas."""
    table = np.array(points, dtype=float).reshape(-1, 2)
    return np.ascontiguousarray(table[:, 0]), np.ascontiguousarray(table[:, 1])


def _steps(run: Run | None) -> tuple[Floats, Floats]:
    if run is None or not run.setpoints:
        return _arrays(())
    times, speeds = _arrays(run.setpoints)
    ends = np.append(times[1:], max(run.ended, times[-1]))
    x = np.column_stack([times, ends]).ravel()
    return np.append(x, x[-1]), np.append(np.repeat(speeds, 2), 0.0)
