"""What a frame of the plot costs, by the length of the history behind it.

Run with `.venv/bin/pytest tests/benchmarks/test_plot_frame.py -s -n 0`. All lengths take turns
within one run, so that what else the computer does falls on each alike; the ratios count.
"""

import time
from collections.abc import Callable

import numpy as np
import pytest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from trex_gui.ui.plotting.history import SampleHistory
from trex_gui.ui.plotting.panel import TracePanel
from trex_gui.ui.plotting.traces import TraceInfo, Traces
from trex_gui.ui.theme.theme import theme

LENGTHS = (1_000, 10_000, 100_000, 1_000_000)
_ROUNDS = 60
_RATE = 80


def traces_of(count: int) -> Traces:
    """Two curves and their history, `count` samples long."""
    noise = np.random.default_rng(count)
    history = SampleHistory(2)
    history.extend(np.arange(count) / _RATE, list(noise.normal(5, 1, size=(2, count))))
    return Traces(
        [TraceInfo("motor1", "Motor 1", "A", "motor1"), TraceInfo("motor2", "2", "A", "motor2")],
        history,
    )


def points(panel: TracePanel) -> None:
    panel.plot.draw()


def points_and_paint(panel: TracePanel) -> None:
    panel.plot.draw()
    panel.plot.grab()


def figures(panel: TracePanel) -> None:
    panel.refresh()


def milliseconds(work: Callable[[TracePanel], None], panel: TracePanel) -> float:
    begun = time.perf_counter()
    work(panel)
    return (time.perf_counter() - begun) * 1000


def test_frame_time_does_not_depend_on_history_length(
    qapp: QApplication, qtbot: QtBot, capsys: pytest.CaptureFixture[str]
) -> None:
    theme().install(qapp)
    panels = {}
    for count in LENGTHS:
        panel = TracePanel()
        qtbot.addWidget(panel)
        panel.resize(1000, 600)
        panel.set_source(traces_of(count))
        panel.plot.show_span(0, count / _RATE)
        panel.show()
        panels[count] = panel
    kinds = {"points": points, "points and paint": points_and_paint, "figures": figures}
    lines = []
    for name, work in kinds.items():
        spent: dict[int, list[float]] = {count: [] for count in LENGTHS}
        for _ in range(_ROUNDS):
            for count, panel in panels.items():
                spent[count].append(milliseconds(work, panel))
        medians = {count: float(np.median(taken)) for count, taken in spent.items()}
        # A thousand samples are drawn one by one; more are two points for each part of the width.
        reduced = medians[LENGTHS[1]]
        lines += [
            f"{name:>17} {count:>9,} samples: {median:6.2f} ms, "
            f"{median / reduced:4.2f} of that of {LENGTHS[1]:,}, "
            f"worst {max(spent[count]):6.2f} ms, {panels[count].plot.points_drawn} points"
            for count, median in medians.items()
        ]
        assert medians[LENGTHS[-1]] < 2 * reduced
    with capsys.disabled():
        print("\n" + "\n".join(lines))


def test_append_time_is_measured_for_each_history_length(
    capsys: pytest.CaptureFixture[str],
) -> None:
    lines = []
    for count in LENGTHS:
        history = SampleHistory(9)
        history.extend(np.arange(count) / _RATE, [np.zeros(count)] * 9)
        row, spent = [1.0] * 9, []
        for time_of_row in count / _RATE + np.arange(20_000) / _RATE:
            begun = time.perf_counter()
            history.append(time_of_row, *row)
            spent.append((time.perf_counter() - begun) * 1e6)
        lines.append(
            f"{count:>9,} samples before: {np.mean(spent):5.1f} us a sample of 9 values, "
            f"worst {max(spent) / 1000:5.1f} ms"
        )
    with capsys.disabled():
        print("\n" + "\n".join(lines))
