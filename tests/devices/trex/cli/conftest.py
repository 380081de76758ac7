"""Fixtures that run trexcmd on a simulated board, in virtual time or as a process."""

import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from click.testing import Result

from tests.support.simulator import SimulatedDevice
from tests.support.virtual_command import RunCommand, StartCommand, VirtualCommand
from tests.support.virtual_time import VirtualRuntime
from trex_gui.ui.runtime import runtime

StartProcess = Callable[..., "subprocess.Popen[str]"]

LONG_TIMEOUT = 1.0
"""Seconds for which a process waits for a reply, because a busy computer slows the simulator."""


@pytest.fixture
def start(virtual_time: VirtualRuntime, quick_simulator: SimulatedDevice) -> StartCommand:
    """Start the program on a new simulated board."""

    def start_program(
        *words: str, url: str | None = None, stdin: str | None = None, **environment: str
    ) -> VirtualCommand:
        variables: dict[str, str | None] = {"TREX_PORT": url or quick_simulator.url, **environment}
        return VirtualCommand(virtual_time, words, variables, stdin)

    return start_program


@pytest.fixture
def trexcmd(start: StartCommand) -> RunCommand:
    """Run the program to its end and check its exit code."""

    def run(*words: str, stdin: str | None = None, exits: int = 0, **environment: str) -> Result:
        return start(*words, stdin=stdin, **environment).ends(exits)

    return run


@pytest.fixture
def saved(trexcmd: RunCommand, tmp_path: Path) -> Path:
    """Settings file of the simulated board."""
    path = tmp_path / "board.txt"
    trexcmd("get-settings", str(path))
    return path


@pytest.fixture
def start_process(quick_simulator: SimulatedDevice) -> Iterator[StartProcess]:
    """Start the program as a process, and kill it after the test."""
    running: list[subprocess.Popen[str]] = []

    def start_program(*words: str) -> subprocess.Popen[str]:
        process = subprocess.Popen(
            [sys.executable, "-m", "trex_gui.cli", *words, f"--timeout={LONG_TIMEOUT:g}"],
            env={**os.environ, "TREX_PORT": quick_simulator.url},
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        running.append(process)
        return process

    yield start_program
    for process in running:
        process.kill()
        process.communicate()


def changed(path: Path, **values: object) -> Path:
    """Return a copy of a settings file with these values."""
    lines = []
    for line in path.read_text(encoding="utf-8").splitlines():
        key = line.partition(":")[0]
        lines.append(f"{key}: {values[key]}" if key in values else line)
    copy = path.with_name("changed.txt")
    copy.write_text("\n".join(lines) + "\n", encoding="utf-8")
    return copy


def becomes(read: Callable[[], object], expected: object, seconds: float = 30) -> bool:
    """Let virtual time pass until a value is `expected`. Return whether it was in time."""
    virtual = runtime()
    assert isinstance(virtual, VirtualRuntime)
    return virtual.run_until(lambda: read() == expected, seconds)


def outputs(simulator: SimulatedDevice) -> list[int]:
    """Return the signed speeds of motors 1, 2 and auxiliary. The speed of a braking motor is 0."""
    state = simulator.show()
    signs = {"forward": 1, "reverse": -1, "brake": 0}
    speeds = [signs[motor["direction"]] * motor["speed"] for motor in state["motors"]]
    return [*speeds, state["aux"]["speed"]]
