"""Seconds from a command to its help, and to the first reply of a board."""

import subprocess
import sys
import time

from tests.benchmarks.conftest import ReportFigure
from tests.support.simulator import SimulatedDevice


def seconds(*words: str) -> float:
    """Return the shortest of five runs."""
    command = [sys.executable, "-m", "trex_gui.cli", *words]
    best = float("inf")
    for _ in range(5):
        begun = time.perf_counter()
        subprocess.run(command, capture_output=True, check=True)
        best = min(best, time.perf_counter() - begun)
    return best


def test_command_start_time_is_measured(simulator: SimulatedDevice, figure: ReportFigure) -> None:
    port = ("--port", simulator.url)
    figure("trexcmd --help", seconds("--help"), "s")
    figure("trexcmd get", seconds("get", "device_number", *port), "s")
    figure("trexcmd find, factory settings", seconds("find", *port), "s")
