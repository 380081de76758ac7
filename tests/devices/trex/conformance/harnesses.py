"""Test harnesses of a board in virtual time: its parser alone, and the simulator behind its line.

Both have the same methods.
"""

import math
from dataclasses import replace
from typing import Any

from trex_gui.devices.trex.simulator.command import simulate
from trex_gui.devices.trex.simulator.control import control
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import SimulatedBoards
from trex_gui.devices.trex.simulator.uart import SerialPort

LONG_TIMEOUT = 15.0
"""Seconds after which an expected event is considered missing."""


class ParserHarness:
    """Parser of the board without a line. Bytes take no time.

    The line only holds the errors that the control line `line error` requests. The timeout of this
    board needs UART-Error Shutdown, but that of the other harness does not, because the
    documentation allows both.
    """

    def __init__(self, model: str, firmware: str) -> None:
        self._board = Board(model, firmware)
        self._board.timeout_needs_shutdown = True
        self._line = SimulatedBoards([self._board])
        self._port = SerialPort(self._board)
        self._resumes_at = math.inf
        self._received = bytearray()

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
            self._collect_replies()

    def settle(self) -> None:
        """Wait until the board has received all sent bytes."""

    def read(self, size: int, seconds: float) -> bytes:
        """Return `size` bytes, or fewer after the timeout."""
        end = self._board.now + seconds
        while len(self._received) < size and self._resumes_at <= end:
            self._resume()
        if len(self._received) < size:
            self._board.advance(max(0.0, end - self._board.now))
        data = bytes(self._received[:size])
        del self._received[:size]
        return data

    def read_available(self) -> bytes:
        """Return all received bytes without waiting."""
        data = bytes(self._received)
        self._received.clear()
        return data

    def control(self, text: str) -> str:
        """Send a control line. Return the reply."""
        return control(self._line, text)

    def set_host_baud(self, baud: int) -> None:
        """Set the rate of the host, and discard all received bytes."""
        self._received.clear()

    def transfer_time(self, size: int) -> float:
        """Return the seconds that bytes take on the line."""
        return 0.0

    def _resume(self) -> None:
        self._board.advance(max(0.0, self._resumes_at - self._board.now))
        self._resumes_at = math.inf
        self._port.resume()
        self._collect_replies()

    def _collect_replies(self) -> None:
        """Receive the replies of the parser, and set the time at which it resumes."""
        while self._port.outgoing:
            self._received.append(self._port.outgoing.popleft())
        if self._port.pause and self._resumes_at == math.inf:
            self._resumes_at = self._board.now + self._port.pause


class WireHarness:
    """Whole simulator behind its line. Bytes take the time of the line.

    Parity and stop bits of the host are always those of the board. `options` are those of
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

    def read_available(self) -> bytes:
        return self._line.receive()

    def control(self, text: str) -> str:
        return self._simulation.control(text)

    def set_host_baud(self, baud: int) -> None:
        self._line.host = replace(self._line.host_format, baud=baud)
        self._line.receive()

    def transfer_time(self, size: int) -> float:
        assert self._line.host is not None
        return self._line.host.seconds(size)


Harness = ParserHarness | WireHarness
