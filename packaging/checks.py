"""Steps and requirements of package checks."""

import json
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import IO

from bootstrap import BootstrapError, say

TIMEOUT_S = 120.0  # for actions that take a few seconds on a fast computer
TOUR_TIMEOUT_S = 600.0  # for the pictures of every page, which take one or two minutes


class StepFailedError(Exception):
    """Failure of a required step. The later steps of its group cannot run."""


class Steps:
    """Runs the steps of a check and reports their results. `failed`: titles of failed steps."""

    def __init__(self) -> None:
        self.failed: list[str] = []
        self._group = ""

    @contextmanager
    def group(self, title: str) -> Iterator[Path]:
        """Open a group of steps, and yield a temporary folder.

        A failed required step ends the block.
        """
        self._group = title
        say(f"\n{title}")
        temporary = tempfile.TemporaryDirectory(prefix="trex-package-")
        try:
            with temporary as folder, suppress(StepFailedError):
                yield Path(folder)
        finally:
            self._group = ""

    @contextmanager
    def step(self, name: str) -> Iterator[None]:
        """Report the result of the block. Suppresses an error of the block."""
        started, failures = time.monotonic(), len(self.failed)
        try:
            yield
        except (BootstrapError, OSError, subprocess.SubprocessError) as error:
            self.failed.append(f"{self._group}: {name}" if self._group else name)
            say(f"  FAILED  {name}\n{error}")
        else:
            if len(self.failed) == failures:  # nor has a step within this step failed
                say(f"  ok      {name} ({time.monotonic() - started:.0f} s)")

    @contextmanager
    def required(self, name: str) -> Iterator[None]:
        """Report the result of the block. An error ends the group of steps."""
        failures = len(self.failed)
        with self.step(name):
            yield
        if len(self.failed) > failures:
            raise StepFailedError


def require(condition: object, message: str) -> None:
    """Raise BootstrapError unless the condition is true."""
    if not condition:
        raise BootstrapError(message)


def require_gone(paths: Iterable[Path]) -> None:
    remaining = [str(path) for path in paths if path.exists() or path.is_symlink()]
    require(not remaining, f"not removed: {', '.join(remaining)}")


def wait_until(condition: Callable[[], object], message: str, timeout: float = TIMEOUT_S) -> None:
    """Poll a condition until it is true. Raise BootstrapError after `timeout` seconds."""
    end = time.monotonic() + timeout
    while not condition():
        require(time.monotonic() < end, f"{message} within {timeout:.0f} s")
        time.sleep(0.1)


class SimulatedBoard:
    """Simulated board of `trex-sim`, queried through its standard streams."""

    def __init__(self, requests: IO[bytes], replies: IO[bytes]) -> None:
        self._requests, self._replies = requests, replies

    @property
    def is_at_rest(self) -> bool:
        """True if no motor is driven."""
        self._requests.write(b"show\n")
        self._requests.flush()
        while line := self._replies.readline():
            if line.startswith(b"ok {"):
                motors = json.loads(line[3:])["motors"]
                return all(motor["direction"] == "brake" or not motor["speed"] for motor in motors)
        raise BootstrapError("The simulator has ended.")


def simulated_board(process: "subprocess.Popen[bytes]") -> tuple[str, SimulatedBoard]:
    """Wait until `trex-sim` is ready. Return its port and board."""
    assert process.stdin is not None
    assert process.stdout is not None
    line = process.stdout.readline().decode()
    require(line.startswith("ready "), "trex-sim did not start")
    return line.removeprefix("ready ").strip(), SimulatedBoard(process.stdin, process.stdout)


def check_board(
    trexcmd: Callable[..., str], home: Path, steps: Steps, board: SimulatedBoard
) -> None:
    """Use the command line with a connected board.

    Args:
        trexcmd: runs `trexcmd` on the port of the board, and converts paths for it.
        home: folder for the files that the steps write.
        steps: steps of the check.
        board: the connected board.
    """
    settings, recording = home / "board.txt", home / "recording.csv"
    with steps.step("read"):
        require('"TReX"' in trexcmd("status", "--json"), "no TReX found")
    with steps.step("change a parameter"):
        trexcmd("set", "serial_timeout", "0.5 s")
        value = trexcmd("get", "serial_timeout")
        require("0.5 s" in value, f"serial_timeout is {value}")
    with steps.step("save settings"):
        trexcmd("get-settings", settings)
        trexcmd("check-settings", settings)
        trexcmd("set-settings", "--dry-run", settings)
    with steps.step("record"):
        trexcmd("stream", "--limit", "5", "--csv", recording)
        rows = len(recording.read_text(encoding="utf-8").splitlines())
        require(rows == 6, f"{rows} rows instead of 6")
    with steps.step("drive"):
        trexcmd("motor", "1", "40", "--seconds", "1")
        require(board.is_at_rest, "motor 1 was not stopped")
