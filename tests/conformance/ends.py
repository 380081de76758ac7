"""The two ends at which the board is met: its parser alone, and a serial port in real time."""

import math
import os
import time
from typing import Protocol

import pytest
import serial

from tests.support.simulator import SimulatorProcess
from trex_gui.emulator.control import control
from trex_gui.emulator.firmware import Board
from trex_gui.emulator.line import Line
from trex_gui.emulator.uart import SerialPort

PATIENCE = 15.0
"""Seconds after which what should have happened will not, however loaded the machine."""

_ON_ITS_WAY = 0.05
"""Seconds that a byte takes at most from one end of a pseudo-terminal to the other."""


class End(Protocol):
    """Where bytes go in and come out, and where people turn the knobs of the board."""

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

    The line carries nothing; it only keeps the errors that `line error` orders.
    """

    def __init__(self, model: str, firmware: str) -> None:
        self._board = Board(model, firmware)
        self._line = Line([self._board])
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
            if self._line.to_spoil:
                self._port.feed_error(self._line.to_spoil.popleft())
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


class TerminalEnd:
    """trex-sim as a process of its own, behind a pseudo-terminal, at the pace of the wire."""

    def __init__(self, *arguments: str) -> None:
        if not hasattr(os, "openpty"):
            pytest.skip("this system has no pseudo-terminals")
        self.simulator = SimulatorProcess(*arguments)
        self._host = serial.Serial(self.simulator.url, 19200)
        self._sent = 0

    def now(self) -> float:
        return time.monotonic()

    def wait(self, seconds: float) -> None:
        time.sleep(seconds)

    def write(self, data: bytes) -> None:
        self._host.write(data)
        self._sent += len(data)

    def settle(self) -> None:
        end = time.monotonic() + PATIENCE
        while (heard := self.simulator.show()["counters"]["line"]["sent"]) < self._sent:
            assert time.monotonic() < end, f"{heard} of {self._sent} bytes arrived"

    def read(self, size: int, seconds: float) -> bytes:
        self._host.timeout = seconds
        return self._host.read(size)

    def come(self) -> bytes:
        return self._host.read(self._host.in_waiting)

    def late(self) -> bytes:
        # It catches up with the clock before the first answer, and has written what came of that
        # before the second.
        for _ in range(2):
            self.simulator.show()
        return self.read(1, _ON_ITS_WAY)

    def do(self, text: str) -> str:
        return f"ok {self.simulator.do(text)}"

    def run_at(self, baud: int) -> None:
        self._host.baudrate = baud
        self._host.reset_input_buffer()

    def on_the_wire(self, size: int) -> float:
        return size * 10 / self._host.baudrate

    def end(self) -> None:
        self._host.close()
        self.simulator.end()
