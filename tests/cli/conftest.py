"""trexcmd in this process and as one of its own, against a simulated board."""

import contextlib
import os
import subprocess
import sys
import time
from collections.abc import Callable, Iterator

import pytest
from click.testing import CliRunner, Result

from tests.support.simulator import SimulatorProcess
from trex_gui.cli import main

Run = Callable[..., Result]
Start = Callable[..., "subprocess.Popen[str]"]


@pytest.fixture
def trexcmd(quick_simulator: SimulatorProcess) -> Iterator[Run]:
    """Run the program to its end, on a simulated board as it comes from the factory."""

    def run(*words: str, stdin: str | None = None, **environment: str) -> Result:
        variables = {"TREX_PORT": quick_simulator.url, **environment}
        return CliRunner().invoke(main, list(words), env=variables, input=stdin)

    quick_simulator.do("factory")
    yield run
    with contextlib.suppress(AssertionError, OSError):
        quick_simulator.do("factory")  # calibrations too, which nobody looks at otherwise


@pytest.fixture
def start(quick_simulator: SimulatorProcess) -> Iterator[Start]:
    """Start the program as a process; whatever still runs in the end is killed."""
    running: list[subprocess.Popen[str]] = []

    def begin(*words: str, url: str | None = None, patience: float = 0.5) -> subprocess.Popen[str]:
        process = subprocess.Popen(
            [sys.executable, "-m", "trex_gui.cli", *words, f"--timeout={patience}"],
            env={**os.environ, "TREX_PORT": url or quick_simulator.url},
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        running.append(process)
        return process

    yield begin
    for process in running:
        process.kill()
        process.communicate()


def becomes(look: Callable[[], object], wanted: object, seconds: float = 30) -> bool:
    """Look again and again until it is as wanted; return whether that was in time.

    Looks with pauses: a simulator that is asked all the time has none left for the program.
    """
    end = time.monotonic() + seconds
    while look() != wanted:
        if time.monotonic() > end:
            return False
        time.sleep(0.02)
    return True


def outputs(simulator: SimulatorProcess) -> list[int]:
    """Return the signed speeds of both motors and the auxiliary one; braking is 0."""
    state = simulator.show()
    signs = {"forward": 1, "reverse": -1, "brake": 0}
    speeds = [signs[motor["direction"]] * motor["speed"] for motor in state["motors"]]
    return [*speeds, state["aux"]["speed"]]
