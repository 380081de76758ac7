"""Export of curves as a table."""

import csv
import io
import math
from pathlib import Path

import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from trex_gui.devices.trex.model.telemetry import Series, board_traces
from trex_gui.ui.files import end_background
from trex_gui.ui.plotting.export import write_csv
from trex_gui.ui.plotting.history import SampleHistory
from trex_gui.ui.plotting.panel import TracePanel
from trex_gui.ui.plotting.traces import Traces

COLUMNS = [("motor1_current", "A"), ("channel1", "")]


def table(rows: list[tuple[float, ...]], events: list[tuple[float, str]]) -> list[list[str]]:
    file = io.StringIO(newline="")
    columns = np.array(rows, dtype=float).reshape(-1, 1 + len(COLUMNS)).T
    written = write_csv(
        file,
        lambda _share: None,
        headers=COLUMNS,
        columns=list(columns),
        events=events,
        origin=100.0,
    )
    assert written == len(rows)
    return list(csv.reader(io.StringIO(file.getvalue())))


def test_header_names_curves_and_units() -> None:
    assert table([], []) == [["time (s)", "motor1_current (A)", "channel1", "event"]]


def test_times_are_relative_and_unknown_values_are_empty() -> None:
    assert table([(100.0, 1.5, -127), (100.0125, math.nan, 3)], [])[1:] == [
        ["0.0000", "1.5", "-127", ""],
        ["0.0125", "", "3", ""],
    ]


def test_event_that_looks_like_a_formula_is_written_as_text() -> None:
    rows = table([(100.0, -1, 0)], [(100.0, "=1+2"), (101.0, "@a")])[1:]
    assert rows == [["0.0000", "-1", "0", "'=1+2"], ["1.0000", "", "", "'@a"]]


def test_event_is_written_to_the_next_row_or_its_own() -> None:
    events = [(100.1, "Stop"), (100.15, 'Apply: "P", more'), (101.0, "Disconnected")]
    rows = table([(100.0, 0, 0), (100.2, 0, 0), (100.3, 0, 0)], events)
    assert [row[-1] for row in rows[1:]] == ["", 'Stop; Apply: "P", more', "", "Disconnected"]
    assert rows[-1] == ["1.0000", "", "", "Disconnected"]


@pytest.mark.realtime
def test_interrupted_export_retains_the_old_file(qtbot: QtBot, tmp_path: Path) -> None:
    history = SampleHistory(len(Series))
    times = np.arange(100_000) / 80
    history.extend(times, [times] * len(Series))
    panel = TracePanel()
    qtbot.addWidget(panel)
    panel.set_source(Traces(board_traces(), history))
    path = tmp_path / "all.csv"
    path.write_text("old content")
    panel.export.save_table(path, -np.inf, np.inf)
    end_background(0)
    assert path.read_text() == "old content"
    assert list(tmp_path.iterdir()) == [path]
