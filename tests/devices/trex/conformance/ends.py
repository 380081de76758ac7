"""The two ends at which the board is met: its parser alone, and the end of its wire."""

import math
from dataclasses import replace
from typing import Any, Protocol

from trex_gui.devices.trex.simulator.command import simulate
from trex_gui.devices.trex.simulator.control import control
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import SimulatedBoards
from trex_gui.devices.trex.simulator.uart import SerialPort

LONG_TIMEOUT = 15.0
"""Seconds after which what should have happened will not, however loaded the machine."""

_ON_ITS_WAY = 0.05
"""Seconds after which a byte that is due by now has come."""


class End(Protocol):
    """Wires and controls of a board under test."""

    def now(self) -> float:
        """Seconds on the clock by which the board lives."""

    def wait(self, seconds: float) -> None:
        """Let time pass."""

    def write(self, data: bytes) -> None:
        """Send bytes."""

    def settle(self) -> None:
        """Wait until the board has heard all that was sent."""

    def read(self, size: int, seconds: float) -> bytes:
        """Return that many bytes, or fewer if no more come within the time."""

    def come(self) -> bytes:
        """Return what has come, without waiting."""

    def late(self) -> bytes:
        """Return a byte that is due by now, if there is one, though the other end stood still."""

    def do(self, text: str) -> str:
        """Send a control line, return the answer."""

    def run_at(self, baud: int) -> None:
        """Set the host's rate, and forget what has come."""

    def on_the_wire(self, size: int) -> float:
        """Seconds that bytes take on their way."""


class ParserEnd:
    """The parser in this process. Bytes take no time, all else does, in virtual time.

    The line carries nothing; it only keeps the errors that `line error` orders. The timeout of this
    board needs UART-Error Shutdown, unlike that of the other end: the documents hold for both.
    """

    def __init__(self, model: str, firmware: str) -> None:
        self._board = Board(model, firmware)
        self._board.timeout_needs_shutdown = True
        self._line = SimulatedBoards([self._board])
        self._port = SerialPort(self._board)
        self._resumes_at = math.inf
        self._come = bytearray()

    def now(self) -> float:
        return self._board.now

    def wait(self, seconds: float) -> None:
        end = self._board.now + seconds
        while self._resumes_at <= end:
            self._resume()
        self._board.advance(max(0.0, end - self._board.now))

    def write(self, data: bytes) -> None:
        for byte in data:
            if self._line.faults.errors:
                self._port.feed_error(self._line.faults.errors.popleft())
            else:
                self._port.feed(byte)
            self._look()

    def settle(self) -> None:
        """Nothing to do: bytes arrive as they are written."""

    def read(self, size: int, seconds: float) -> bytes:
        end = self._board.now + seconds
        while len(self._come) < size and self._resumes_at <= end:
            self._resume()
        if len(self._come) < size:
            self._board.advance(max(0.0, end - self._board.now))
        data = bytes(self._come[:size])
        del self._come[:size]
        return data

    def come(self) -> bytes:
        data = bytes(self._come)
        self._come.clear()
        return data

    def late(self) -> bytes:
        return b""  # everything here happens in its time

    def do(self, text: str) -> str:
        return control(self._line, text)

    def run_at(self, baud: int) -> None:
        self._come.clear()

    def on_the_wire(self, size: int) -> float:
        return 0.0

    def _resume(self) -> None:
        self._board.advance(max(0.0, self._resumes_at - self._board.now))
        self._resumes_at = math.inf
        self._port.resume()
        self._look()

    def _look(self) -> None:
        """Take what the parser has answered, and note when it will go on."""
        while self._port.outgoing:
            self._come.append(self._port.outgoing.popleft())
        if self._port.pause and self._resumes_at == math.inf:
            self._resumes_at = self._board.now + self._port.pause


class WireEnd:
    """The whole simulator behind its wire, at the pace of the wire, in virtual time.

    The host's parity and stop bits are always those of the board. `options` are those of
    `simulate`.
    """

    def __init__(self, **options: Any) -> None:
        self._simulation = simulate(**options)
        self._line = self._simulation.line
        self._line.host = self._line.host_format

    def now(self) -> float:
        return self._line.now

    def wait(self, seconds: float) -> None:
        self._line.advance_to(self.now() + seconds)

    def write(self, data: bytes) -> None:
        self._line.send(data)

    def settle(self) -> None:
        self.wait(self._line.backlog)

    def read(self, size: int, seconds: float) -> bytes:
        assert isinstance(self._line, SimulatedBoards)
        return self._line.read(size, seconds)

    def come(self) -> bytes:
        return self._line.receive()

    def late(self) -> bytes:
        return self.read(1, _ON_ITS_WAY)

    def do(self, text: str) -> str:
        return self._simulation.control(text)

    def run_at(self, baud: int) -> None:
        self._line.host = replace(self._line.host_format, baud=baud)
        self._line.receive()

    def on_the_wire(self, size: int) -> float:
        assert self._line.host is not None
        return self._line.host.seconds(size)
