"""Steps of a check, and what each of them requires."""

import subprocess
import tempfile
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

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
