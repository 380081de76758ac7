"""Seconds from the start of a command to its help, and to its end with a board."""

import subprocess
import sys
import time

from tests.benchmarks.conftest import ReportFigure
from tests.support.simulator import SimulatedDevice


def seconds(*words: str) -> float:
    """Return the duration of the fastest of five runs."""
    command = [sys.executable, "-m", "trex_gui.cli", *words]
    durations = []
    for _ in range(5):
        start = time.perf_counter()
        subprocess.run(command, capture_output=True, check=True)
        durations.append(time.perf_counter() - start)
    return min(durations)


def test_durations_of_commands_are_measured(
    simulator: SimulatedDevice, figure: ReportFigure
) -> None:
    port = ("--port", simulator.url)
    figure("trexcmd --help", seconds("--help"), "s")
    figure("trexcmd get", seconds("get", "device_number", *port), "s")
    figure("trexcmd find, factory settings", seconds("find", *port), "s")
