"""The simulator as a process of its own."""

import json
import subprocess
import sys
import tempfile
from abc import ABC, abstractmethod
from collections.abc import Callable
from pathlib import Path
from typing import Any

_OWN_PLACES = {"--link", "--tcp", "--rfc2217"}


class SimulatedDevice(ABC):
    """A simulated device and its control line.

    Attributes:
        url: what the program opens.
    """

    url: str

    @abstractmethod
    def obey(self, line: str) -> str:
        """Send a control line; return the answer."""

    @abstractmethod
    def end(self) -> None:
        """End it, as pulling the plug would."""

    def do(self, line: str) -> str:
        """Send a control line; return what follows `ok`."""
        answer = self.obey(line)
        assert answer.startswith("ok"), f"{line}: {answer}"
        return answer.removeprefix("ok").strip()

    def show(self) -> dict[str, Any]:
        """What the device is and does."""
        state: dict[str, Any] = json.loads(self.do("show"))
        return state


StartSimulator = Callable[..., SimulatedDevice]
"""Starts a simulator with these options of `trex-sim`."""


class SimulatorProcess(SimulatedDevice):
    """`trex-sim` in a process of its own, and its control line.

    Its pseudo-terminal has a name of its own: the number of one that was unplugged may become
    that of another simulator, of a test that runs at the same time.
    """

    def __init__(self, *arguments: str) -> None:
        self._folder = tempfile.TemporaryDirectory(prefix="trex-sim")
        command = [sys.executable, "-m", "trex_gui.cli.simulator", *arguments]
        if sys.platform != "win32" and not _OWN_PLACES & set(arguments):
            command += ["--link", str(Path(self._folder.name) / "port")]
        self._process = subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1
        )
        ready = self._answer()
        assert ready.startswith("ready "), ready
        self.url = ready.removeprefix("ready ")

    def obey(self, line: str) -> str:
        assert self._process.stdin is not None
        self._process.stdin.write(f"{line}\n")
        self._process.stdin.flush()
        return self._answer()

    def end(self) -> None:
        self._process.terminate()
        self._process.wait(30)
        self._folder.cleanup()
        for stream in (self._process.stdin, self._process.stdout):
            if stream is not None:
                stream.close()

    def _answer(self) -> str:
        assert self._process.stdout is not None
        return self._process.stdout.readline().strip()
