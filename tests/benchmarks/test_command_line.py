"""Seconds from the command to its help, and to a first answer of a simulated board."""

import subprocess
import sys
import time

import pytest

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


def test_command_start_time_is_measured(
    simulator: SimulatedDevice, capsys: pytest.CaptureFixture[str]
) -> None:
    port = ("--port", simulator.url)
    to_help, to_answer = seconds("--help"), seconds("get", "device_number", *port)
    to_find = seconds("find", *port)
    with capsys.disabled():
        print(
            f"\ntrexcmd --help {to_help:.2f} s, get {to_answer:.2f} s, "
            f"find at the factory's settings {to_find:.2f} s"
        )
    assert to_help > 0
