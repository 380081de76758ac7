"""Simulated devices: their common interface, and the simulator in a separate process."""

import json
import os
import signal
import sys
import tempfile
import threading
from abc import ABC, abstractmethod
from collections.abc import Callable
from contextlib import suppress
from enum import Enum
from pathlib import Path
from typing import Any

from trex_gui.testing import SimulatedTrex

_SLOW_S = 0.1  # pause of a slow port
_PORT_OPTIONS = {"--link", "--tcp", "--rfc2217"}


class PortFault(Enum):
    """Fault of the computer's port."""

    NONE = "none"
    SLOW = "slow"  # each write takes long
    JAMMED = "jammed"  # neither sends nor receives
    STOLEN = "stolen"  # another program reads the received bytes


class SimulatedDevice(ABC):
    """Simulated device that obeys control lines.

    Attributes:
        url: address of its port.
    """

    url: str

    @abstractmethod
    def set_port_fault(self, fault: PortFault) -> None:
        """Start a fault of the port. `NONE` ends it. A jammed port obeys no control lines."""

    @abstractmethod
    def control(self, line: str) -> str:
        """Send a control line. Return the reply."""

    @abstractmethod
    def end(self) -> None:
        """End the simulator, like an unplugged cable."""

    def do(self, *lines: str) -> str:
        """Send control lines. Return the text after the last `ok`."""
        reply = ""
        for line in lines:
            reply = self.control(line)
            assert reply.startswith("ok"), f"{line}: {reply}"
        return reply.removeprefix("ok").strip()

    def show(self, board: str = "") -> dict[str, Any]:
        """Return the state of the device. `board` selects one of several, such as `@9`."""
        state: dict[str, Any] = json.loads(self.do(f"{board} show".strip()))
        return state


StartSimulator = Callable[..., SimulatedDevice]
"""Function that starts a simulator with options of `trex-sim`."""


class SimulatorProcess(SimulatedDevice):
    """`trex-sim` in a separate process.

    Its pseudo-terminal has a unique name, because the system may give the number of an unplugged
    terminal to another simulator.
    """

    def __init__(self, *arguments: str) -> None:
        self._folder = tempfile.TemporaryDirectory(prefix="trex-sim")
        link: tuple[str, ...] = ()
        if sys.platform != "win32" and not _PORT_OPTIONS & set(arguments):
            link = "--link", str(Path(self._folder.name) / "port")
        self._simulated = SimulatedTrex(*arguments, *link)
        self._process, self.url = self._simulated.process, self._simulated.url
        self._end_fault: Callable[[], object] = lambda: None

    def set_port_fault(self, fault: PortFault) -> None:
        self._end_fault()
        self._end_fault = lambda: None
        if fault is PortFault.JAMMED:
            self._process.send_signal(signal.SIGSTOP)
            self._end_fault = lambda: self._process.send_signal(signal.SIGCONT)
        elif fault is not PortFault.NONE:
            act = self._slow_down if fault is PortFault.SLOW else self._steal
            is_over = threading.Event()
            thread = threading.Thread(target=act, args=(is_over,))
            thread.start()

            def end() -> None:
                is_over.set()
                thread.join()

            self._end_fault = end

    def _slow_down(self, is_over: threading.Event) -> None:
        while not is_over.is_set():
            self._process.send_signal(signal.SIGSTOP)
            is_over.wait(_SLOW_S)
            self._process.send_signal(signal.SIGCONT)
            is_over.wait(_SLOW_S / 5)

    def _steal(self, is_over: threading.Event) -> None:
        """Read bytes meant for the program, if the system allows it in spite of a lock."""
        with suppress(OSError):
            port = os.open(self.url, os.O_RDONLY | os.O_NOCTTY | os.O_NONBLOCK)
            try:
                while not is_over.wait(0.001):
                    with suppress(BlockingIOError):
                        os.read(port, 4096)
            finally:
                os.close(port)

    def control(self, line: str) -> str:
        return self._simulated.control(line)

    def end(self) -> None:
        self._end_fault()
        self._simulated.close()
        self._folder.cleanup()
