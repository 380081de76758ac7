"""The simulator as a process of its own."""

import json
import subprocess
import sys
from typing import Any


class SimulatorProcess:
    """`trex-sim` in a process of its own, and its control line."""

    def __init__(self, *arguments: str) -> None:
        command = [sys.executable, "-m", "trex_gui.emulator", *arguments]
        self._process = subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1
        )
        ready = self._answer()
        assert ready.startswith("ready "), ready
        self.url = ready.removeprefix("ready ")

    def do(self, line: str) -> str:
        """Send a control line; return what follows `ok`."""
        assert self._process.stdin is not None
        self._process.stdin.write(f"{line}\n")
        self._process.stdin.flush()
        answer = self._answer()
        assert answer.startswith("ok"), f"{line}: {answer}"
        return answer.removeprefix("ok").strip()

    def show(self) -> dict[str, Any]:
        """What the board is and does."""
        state: dict[str, Any] = json.loads(self.do("show"))
        return state

    def end(self) -> None:
        self._process.terminate()
        self._process.wait(5)
        for stream in (self._process.stdin, self._process.stdout):
            if stream is not None:
                stream.close()

    def _answer(self) -> str:
        assert self._process.stdout is not None
        return self._process.stdout.readline().strip()
