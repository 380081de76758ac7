"""Time of a frame of the plot, by the length of its history.

The lengths alternate within a run, so that other processes affect all lengths equally.
"""

import time
from collections.abc import Callable

import numpy as np
from pytestqt.qtbot import QtBot

from tests.benchmarks.conftest import ReportFigure
from trex_gui.ui.plotting.history import SampleHistory
from trex_gui.ui.plotting.panel import TracePanel
from trex_gui.ui.plotting.traces import TraceInfo, Traces

LENGTHS = (1_000, 10_000, 100_000, 1_000_000)
_ROUNDS = 60
_RATE = 80


def traces_of(count: int) -> Traces:
    """Return two curves with `count` samples."""
    noise = np.random.default_rng(count)
    history = SampleHistory(2)
    history.extend(np.arange(count) / _RATE, list(noise.normal(5, 1, size=(2, count))))
    return Traces(
        [TraceInfo("motor1", "Motor 1", "A", "motor1"), TraceInfo("motor2", "2", "A", "motor2")],
        history,
    )


def draw_and_paint(panel: TracePanel) -> None:
    panel.plot.draw()
    panel.plot.grab()


def milliseconds(work: Callable[[TracePanel], object], panel: TracePanel) -> float:
    start = time.perf_counter()
    work(panel)
    return (time.perf_counter() - start) * 1000


def test_frame_time_does_not_depend_on_history_length(qtbot: QtBot, figure: ReportFigure) -> None:
    panels = {}
    for count in LENGTHS:
        panel = TracePanel()
        qtbot.addWidget(panel)
        panel.resize(1000, 600)
        panel.set_source(traces_of(count))
        panel.plot.show_span(0, count / _RATE)
        panel.show()
        panels[count] = panel
    kinds: dict[str, Callable[[TracePanel], object]] = {
        "points": lambda panel: panel.plot.draw(),
        "points and paint": draw_and_paint,
        "texts": lambda panel: panel.refresh(),
    }
    for name, work in kinds.items():
        durations: dict[int, list[float]] = {count: [] for count in LENGTHS}
        for _ in range(_ROUNDS):
            for count, panel in panels.items():
                durations[count].append(milliseconds(work, panel))
        medians = {count: float(np.median(times)) for count, times in durations.items()}
        # A thousand samples are drawn individually. More samples are reduced to points.
        reduced = medians[LENGTHS[1]]
        for count, median in medians.items():
            figure(f"plot frame, {name}, {count:,} samples, median", median, "ms")
            figure(f"plot frame, {name}, {count:,} samples, worst", max(durations[count]), "ms")
        figure(
            f"plot frame, {name}, {LENGTHS[-1]:,} to {LENGTHS[1]:,} samples",
            medians[LENGTHS[-1]] / reduced,
            "ratio",
            at_most=2,
        )


def test_duration_of_append_is_measured_for_each_length(figure: ReportFigure) -> None:
    for count in LENGTHS:
        history = SampleHistory(9)
        history.extend(np.arange(count) / _RATE, [np.zeros(count)] * 9)
        row, times = [1.0] * 9, []
        for sample_time in count / _RATE + np.arange(20_000) / _RATE:
            start = time.perf_counter()
            history.append(sample_time, *row)
            times.append((time.perf_counter() - start) * 1e6)
        figure(f"append to {count:,} samples, mean", float(np.mean(times)), "us")
        figure(f"append to {count:,} samples, worst", max(times) / 1000, "ms")
