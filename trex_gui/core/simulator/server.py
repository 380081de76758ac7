"""Server that runs a simulated line in real time.

Virtual time follows the clock. Deadlines come from the events of the line, so that one late wake-up
does not delay later events.
"""

import contextlib
import os
import select
import signal
import socket
import stat
import sys
import threading
import time
from collections import deque
from types import FrameType

from trex_gui.core.signals import handled_signals
from trex_gui.core.simulator.control_lines import GOODBYE
from trex_gui.core.simulator.endpoint import Endpoint, EndpointError, HostSettings
from trex_gui.core.simulator.plugin import Simulation
from trex_gui.core.transport.settings import SerialFormat

_IDLE = 0.1  # seconds between updates of an idle line
_SUSPENDED = 2.0  # seconds; a longer gap is skipped, because the process has been suspended
_MAX_AHEAD = 0.02
"""Maximum length of the line's queue in seconds.

The server buffers further bytes. It discards these bytes when the host disconnects or reconfigures
its port."""

_MAX_UNSENT = 65_536  # buffered bytes from the host; further bytes are lost
_CHUNK = 16  # bytes queued on the line at a time
_BATCH = 0.001
"""Interval in seconds between wake-ups during a stream from the host.

One wake-up per byte would use a whole core at 115200 baud."""


class Server:
    def __init__(self, simulation: Simulation, endpoint: Endpoint) -> None:
        self._line = simulation.line
        self._control = simulation.control
        self._endpoint = endpoint
        self._origin = time.monotonic()
        self._ended = False
        self._unsent = bytearray()
        self._disconnections = 0
        self._reported: set[str] = set()
        self._control_lines: deque[str | None] = deque()
        self._wake_reader, self._wake_writer = socket.socketpair()
        self._wake_reader.setblocking(False)
        self._wake_writer.setblocking(False)

    def run(self) -> None:
        """Serve until `quit`, a signal, or the end of a pipe on standard input."""
        previous = self._catch_signals()
        try:
            self._print(f"ready {self._endpoint.url}")
            self._read_control_lines()
            while not self._ended:
                self._run_once()
        finally:
            for number, handler in previous.items():
                signal.signal(number, handler)
            self._endpoint.unplug()
            self._wake_writer.close()
            self._wake_reader.close()

    def _run_once(self) -> None:
        self._catch_up()
        sources = [self._wake_reader.fileno(), *self._endpoint.descriptors()]
        ready, _, _ = select.select(sources, [], [], self._timeout())
        self._catch_up()
        self._check_disconnection()  # before any byte from the next host is received
        for settings, data in self._endpoint.receive(ready):
            self._receive(settings, data)
        self._check_disconnection()
        while self._unsent and self._line.backlog < _MAX_AHEAD:
            self._line.send(bytes(self._unsent[:_CHUNK]))
            del self._unsent[:_CHUNK]
        for reason in self._line.save_errors:
            if reason not in self._reported:
                self._reported.add(reason)
                sys.stderr.write(f"{reason}; the board continues without saving\n")
        if self._wake_reader.fileno() in ready:
            with contextlib.suppress(BlockingIOError):
                while self._wake_reader.recv(4096):
                    pass
            self._execute()

    def _receive(self, settings: HostSettings | None, data: bytes) -> None:
        """Queue bytes from the host. Discard queued bytes if the settings have changed."""
        host = None
        if settings is not None:
            parity = settings.parity or self._line.host_format.parity
            host = SerialFormat(settings.baud, parity, settings.stop_bits)
        if host != self._line.host:
            self._drop_unsent()
            self._line.host = host
        self._unsent += data[: _MAX_UNSENT - len(self._unsent)]

    def _check_disconnection(self) -> None:
        if self._endpoint.disconnections != self._disconnections:
            self._disconnections = self._endpoint.disconnections
            self._drop_unsent()

    def _drop_unsent(self) -> None:
        self._unsent.clear()
        self._line.drop_unsent()

    def _timeout(self) -> float:
        event = self._line.next_event
        if event is None:
            return 0.0 if self._unsent else _IDLE
        wait = self._origin + event - time.monotonic()
        if self._line.backlog > _BATCH:
            wait = max(wait, _BATCH)
        return min(_IDLE, max(0.0, wait))

    def _catch_up(self) -> None:
        now = time.monotonic() - self._origin
        if now - self._line.now > _SUSPENDED:
            self._origin += now - self._line.now
            now = self._line.now
        self._line.advance_to(now)
        if data := self._line.receive():
            self._endpoint.write(data)

    def _execute(self) -> None:
        while self._control_lines and not self._ended:
            text = self._control_lines.popleft()
            if text is None:
                self._ended = True
            elif text.strip():
                self._reply(text)

    def _reply(self, text: str) -> None:
        faults = self._line.faults
        was_plugged = faults.plugged
        reply = self._control(text)
        if was_plugged and not faults.plugged:
            self._endpoint.unplug()
        elif faults.plugged and not was_plugged:
            try:
                self._endpoint.plug()
                reply = f"{reply} {self._endpoint.url}"
            except EndpointError as error:
                self._line.unplug()
                reply = f"error {error}"
        self._ended = reply == GOODBYE
        self._print(reply)

    def _print(self, text: str) -> None:
        try:
            sys.stdout.write(text + "\n")
            sys.stdout.flush()
        except (OSError, ValueError):
            self._ended = True  # standard output is closed

    def _read_control_lines(self) -> None:
        """Read standard input in a thread, because `select` cannot wait for it on some systems."""
        try:
            kind = os.fstat(0).st_mode
        except OSError:
            return  # the process has no standard input
        ends_with_input = stat.S_ISFIFO(kind) or stat.S_ISSOCK(kind)
        if not ends_with_input and stat.S_ISCHR(kind) and not os.isatty(0):
            return  # /dev/null or similar
        threading.Thread(
            target=self._read_input, args=(ends_with_input,), daemon=True, name="control lines"
        ).start()

    def _read_input(self, ends_with_input: bool) -> None:
        rest = b""
        while True:
            try:
                data = os.read(0, 4096)
            except OSError:
                data = b""
            if not data:
                break
            *lines, rest = (rest + data).split(b"\n")
            self._control_lines.extend(line.decode("utf-8", "replace") for line in lines)
            self._wake_up()
        if rest:
            self._control_lines.append(rest.decode("utf-8", "replace"))
        if ends_with_input:
            self._control_lines.append(None)
        self._wake_up()

    def _wake_up(self) -> None:
        """Wake the loop from another thread or a signal handler."""
        with contextlib.suppress(OSError):  # a full pipe wakes the loop anyway
            self._wake_writer.send(b"!")

    def _catch_signals(self) -> dict[int, "signal._HANDLER"]:
        ending = handled_signals(("SIGINT", "SIGTERM", "SIGHUP"))
        previous: dict[int, signal._HANDLER] = {
            number: signal.signal(number, self._end) for number in ending
        }
        for number in handled_signals(("SIGTTIN",)):
            # Otherwise reading from a terminal in the background would suspend the process.
            previous[number] = signal.signal(number, signal.SIG_IGN)
        return previous

    def _end(self, _number: int, _frame: FrameType | None) -> None:
        self._ended = True
        self._wake_up()
