"""Fixtures and helpers for tests of the TReX."""

import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager

import pytest

from tests.support.simulator import SimulatedDevice
from trex_gui.devices.trex.simulator.motors import SerialControl

STOPPED = ("brake", 127)
"""State of a motor after a stop."""


def motor(simulator: SimulatedDevice, number: int = 1) -> tuple[str, int]:
    """Return the direction and speed of a motor."""
    state = simulator.show()["motors"][number - 1]
    return state["direction"], state["speed"]


def target_speeds(line: SimulatedDevice) -> list[int]:
    """Return the target speed of motor 1 of boards 7 and 9."""
    return [line.show(name)["motors"][0]["target_speed"] for name in ("@7", "@9")]


@contextmanager
def running_script(script: str, url: str) -> Iterator[subprocess.Popen[bytes]]:
    """Run a script until the end of the block. Start the block when the script prints `ready`."""
    command = [sys.executable, "-c", script, url]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as process:
        assert process.stdout is not None
        try:
            assert process.stdout.readline() == b"ready\n"
            yield process
        finally:
            process.kill()


@pytest.fixture
def motor_commands(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Record the motor commands that any simulated board executes, including stops."""
    commands: list[str] = []

    def drive(_control: SerialControl, *arguments: object, **options: object) -> None:
        commands.append(f"motor {arguments} {options}")

    def drive_aux(_control: SerialControl, *arguments: object, **options: object) -> None:
        commands.append(f"auxiliary {arguments} {options}")

    monkeypatch.setattr(SerialControl, "drive", drive)
    monkeypatch.setattr(SerialControl, "drive_aux", drive_aux)
    return commands
