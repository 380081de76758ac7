"""Simulated TReX for testing your own program.

Import the pytest fixture in your `conftest.py`: `from trex_gui.testing import simulated_trex`.
`resources/examples/test_robot.py` has two tests that use the fixture.
"""

import json
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Self

import pytest


class SimulatedTrex:
    """Process that runs `trex-sim`. Use it in a `with` statement.

    Attributes:
        url: address for `Trex`: a pseudo-terminal, or a TCP port on Windows.
        process: the simulator's process.
    """

    def __init__(self, *options: str) -> None:
        """Start the simulator with options, such as `--model trexjr`. See `trex-sim --help`."""
        command = [sys.executable, "-m", "trex_gui.cli.simulator", *options]
        self.process = subprocess.Popen(  # noqa: S603 - our own program, without a shell
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1
        )
        ready = self._read_reply()
        if not ready.startswith("ready "):
            self.close()
            raise RuntimeError(f"trex-sim did not start: {ready or 'see its error message'}")
        self.url = ready.removeprefix("ready ")

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def control(self, line: str) -> str:
        """Send a control line. Return the reply, which may report an error."""
        assert self.process.stdin is not None  # noqa: S101 - for the type checker
        self.process.stdin.write(f"{line}\n")
        self.process.stdin.flush()
        return self._read_reply()

    def do(self, line: str) -> str:
        """Send a control line, such as `fault 1 on`. Return the reply without `ok`.

        Raises:
            ValueError: the simulator rejected the line.
        """
        reply = self.control(line)
        if not reply.startswith("ok"):
            raise ValueError(f"{line}: {reply}")
        return reply.removeprefix("ok").strip()

    def show(self) -> dict[str, Any]:
        """Return the state of the board, as reported by the control line `show`."""
        state: dict[str, Any] = json.loads(self.do("show"))
        return state

    def close(self) -> None:
        """Terminate the simulator. To your program this looks like an unplugged cable."""
        self.process.terminate()
        self.process.communicate(timeout=30)

    def _read_reply(self) -> str:
        assert self.process.stdout is not None  # noqa: S101 - for the type checker
        return self.process.stdout.readline().strip()


@pytest.fixture
def simulated_trex(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Iterator[SimulatedTrex]:
    """Simulated board in its factory state. Its snapshots are saved in `tmp_path`."""
    monkeypatch.setenv("TREX_STUDIO_DATA", str(tmp_path / "trex-studio"))
    with SimulatedTrex() as board:
        yield board
