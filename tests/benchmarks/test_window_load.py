"""Processor time, memory and event-loop gaps of the window with a connected board.

The window and the simulated board are separate processes. The line is paced at 115200 baud.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.benchmarks.conftest import ReportFigure, fast_board
from tests.benchmarks.loaded_window import BAUD
from tests.support.simulator import StartSimulator

_RUNS = 3
_SECONDS = 5.0
_GAP_SECONDS = float(os.environ.get("TREX_GAP_SECONDS", "60"))
"""Ten minutes are 600; a minute already shows every page eight times."""

_AT_MOST = {"Board": 12.0, "minimised": 3.0, "hidden": 3.0}  # percent of a core


@pytest.fixture
def url(start_simulator: StartSimulator, tmp_path: Path) -> str:
    return start_simulator("--demo", *fast_board(tmp_path, BAUD)).url


def _measure(what: str, url: str, seconds: float, folder: Path) -> dict[str, float]:
    command = [sys.executable, "-m", "tests.benchmarks.loaded_window", what, url, str(seconds)]
    own = {name: str(folder) for name in ("HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME")}
    environment = {**os.environ, **own, "QT_QPA_PLATFORM": "offscreen"}
    done = subprocess.run(command, env=environment, stdout=subprocess.PIPE, text=True, check=True)
    found: dict[str, float] = json.loads(done.stdout)
    return found


@pytest.mark.timeout(600)
def test_processor_time_of_the_window(url: str, tmp_path: Path, figure: ReportFigure) -> None:
    runs = [_measure("load", url, _SECONDS, tmp_path) for _ in range(_RUNS)]
    for state in runs[0]:
        least = min(run[state] for run in runs)  # other processes only add time
        figure(f"cpu of the window, {state}", least, "%", at_most=_AT_MOST.get(state))


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
@pytest.mark.timeout(600)
def test_memory_after_an_hour_of_telemetry(url: str, tmp_path: Path, figure: ReportFigure) -> None:
    found = _measure("memory", url, 3600.0, tmp_path)
    figure("memory of the window, connected", found["start"], "MiB")
    figure("memory of the window, after an hour", found["end"], "MiB", at_most=165)
    figure(
        "memory of the window, growth in a quarter of an hour", found["growth"], "MiB", at_most=1
    )


@pytest.mark.timeout(900)
def test_event_loop_gaps_with_all_pages_in_turn(
    url: str, tmp_path: Path, figure: ReportFigure
) -> None:
    found = _measure("gaps", url, _GAP_SECONDS, tmp_path)
    figure("longest gap of the event loop", found["longest"], "ms", at_most=50)
    figure("longest work between two turns of the event loop", found["worked"], "ms", at_most=50)


@pytest.mark.timeout(300)
def test_event_loop_gaps_while_dialogs_open(url: str, tmp_path: Path, figure: ReportFigure) -> None:
    found = _measure("dialogs", url, 0, tmp_path)
    figure("longest gap of the event loop, two dialogs open", found["longest"], "ms")
    figure("longest work in one turn, two dialogs open", found["worked"], "ms", at_most=100)
