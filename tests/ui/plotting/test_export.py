"""Tables of what a plot has: there whole or not at all."""

from pathlib import Path

import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from trex_gui.devices.trex.model.telemetry import Series, board_traces
from trex_gui.ui.plotting.history import SampleHistory
from trex_gui.ui.plotting.panel import TracePanel
from trex_gui.ui.plotting.traces import Traces


@pytest.fixture
def panel(qtbot: QtBot) -> TracePanel:
    history = SampleHistory(len(Series))
    times = np.arange(300_000) / 80
    history.extend(times, [times] * len(Series))
    panel = TracePanel()
    qtbot.addWidget(panel)
    panel.set_source(Traces(board_traces(), history))
    return panel


@pytest.mark.realtime
def test_interrupted_export_leaves_the_old_file(panel: TracePanel, tmp_path: Path) -> None:
    path = tmp_path / "all.csv"
    path.write_text("what was there")
    panel.export.save_table(path, -np.inf, np.inf)
    panel.export.finish()
    assert path.read_text() == "what was there"
    assert list(tmp_path.iterdir()) == [path]


def test_export_leaves_only_the_complete_file(
    panel: TracePanel, tmp_path: Path, qtbot: QtBot
) -> None:
    path = tmp_path / "some.csv"
    with qtbot.waitSignal(panel.notifier.info):
        panel.export.save_table(path, 0.0, 10.0)
    assert sum(line[:1].isdigit() for line in path.read_text().splitlines()) == 801
    assert list(tmp_path.iterdir()) == [path]
