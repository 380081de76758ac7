"""Steps of a check, and what each of them requires."""

import json
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import IO

from bootstrap import BootstrapError, say

PATIENCE_S = 120.0
"""Seconds for what takes some on a fast computer."""
TOUR_S = 600.0
"""Seconds for the pictures of every page, which take a minute or two."""


class StepFailedError(Exception):
    """The steps that follow cannot be done."""


class Steps:
    """Runs the steps of a check and says how each has ended."""

    def __init__(self) -> None:
        self.failed: list[str] = []
        self._place = ""

    @contextmanager
    def place(self, name: str) -> Iterator[Path]:
        """Give a new folder to install into; a required step that fails ends the block."""
        self._place = name
        say(f"\n{name}")
        temporary = tempfile.TemporaryDirectory(prefix="trex-package-")
        try:
            with temporary as folder, suppress(StepFailedError):
                yield Path(folder)
        finally:
            self._place = ""

    @contextmanager
    def step(self, name: str) -> Iterator[None]:
        """Report how the block ends; after an error the next step follows."""
        started, failures = time.monotonic(), len(self.failed)
        try:
            yield
        except (BootstrapError, OSError, subprocess.SubprocessError) as error:
            self.failed.append(f"{self._place}: {name}" if self._place else name)
            say(f"  FAILED  {name}\n{error}")
        else:
            if len(self.failed) == failures:  # of the steps within this one, too
                say(f"  ok      {name} ({time.monotonic() - started:.0f} s)")

    @contextmanager
    def required(self, name: str) -> Iterator[None]:
        """Report how the block ends; after an error the other steps are left out."""
        failures = len(self.failed)
        with self.step(name):
            yield
        if len(self.failed) > failures:
            raise StepFailedError


def require(fact: object, text: str) -> None:
    if not fact:
        raise BootstrapError(text)


def require_gone(paths: Iterable[Path]) -> None:
    left = [str(path) for path in paths if path.exists() or path.is_symlink()]
    require(not left, f"left behind: {', '.join(left)}")


def wait_until(fact: Callable[[], object], text: str, seconds: float = PATIENCE_S) -> None:
    end = time.monotonic() + seconds
    while not fact():
        require(time.monotonic() < end, f"{text} within {seconds:.0f} s")
        time.sleep(0.1)


class SimulatedBoard:
    """The simulated board of `trex-sim`, by its control lines."""

    def __init__(self, writing: IO[bytes], reading: IO[bytes]) -> None:
        self._writing, self._reading = writing, reading

    @property
    def is_at_rest(self) -> bool:
        """Whether no motor is driven."""
        self._writing.write(b"show\n")
        self._writing.flush()
        while line := self._reading.readline():
            if line.startswith(b"ok {"):
                motors = json.loads(line[3:])["motors"]
                return all(motor["direction"] == "brake" or not motor["speed"] for motor in motors)
        raise BootstrapError("The simulator has ended.")


def simulated_board(process: "subprocess.Popen[bytes]") -> tuple[str, SimulatedBoard]:
    """Return the port that `trex-sim` names when it is ready, and its board."""
    assert process.stdin is not None
    assert process.stdout is not None
    line = process.stdout.readline().decode()
    require(line.startswith("ready "), "trex-sim does not start")
    return line.removeprefix("ready ").strip(), SimulatedBoard(process.stdin, process.stdout)


def use_board(trexcmd: Callable[..., str], home: Path, steps: Steps, board: SimulatedBoard) -> None:
    """Do with the command line what a user does who has connected a board.

    Args:
        trexcmd: runs `trexcmd` on the port of the board, with paths as it sees them.
        home: takes the files.
        steps: of the check.
        board: on that port.
    """
    settings, recording = home / "board.txt", home / "recording.csv"
    with steps.step("read"):
        require('"TReX"' in trexcmd("status", "--json"), "no TReX")
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
