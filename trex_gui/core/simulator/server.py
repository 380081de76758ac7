"""Real time: a line in virtual time is kept up with the clock, the host and the control lines.

Deadlines come from the line's own events, so that a wait that took too long is not added to
the next one.
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
from collections.abc import Callable, Iterable, Sequence
from types import FrameType
from typing import Protocol

from trex_gui.core.simulator.endpoint import Endpoint, EndpointError, HostSettings
from trex_gui.core.transport.settings import Parity, SerialFormat
from trex_gui.devices.trex.simulator.demo import Demo

_IDLE = 0.1  # seconds; motors and timeouts go on though nothing is on the wire
_DEMO_IDLE = 0.02
_SUSPENDED = 2.0
"""A gap of so many seconds is time in which the process did not run; it is not made up for."""

_FULL_ENOUGH = 0.02
"""Seconds of bytes that are given to the wire ahead; the rest waits here, where it can be dropped
when the host leaves or sets its port anew."""

_MOST_WAITING = 65_536
"""Bytes of a host that may wait; what a slow line cannot carry is lost then."""

_SLICE = 16
"""Bytes that are given to the wire at a time."""

_IN_LUMPS = 0.001
"""Seconds for which the bytes of a host that streams are dealt with together. Waking for each
of them alone takes a whole core at 115200 baud."""

GOODBYE = "ok bye"
"""The answer to `quit`; whoever runs the line ends after it."""


class Wire(Protocol):
    """A line in virtual time, with whatever is at its other end."""

    host: SerialFormat | None
    """What the host has set its port to; `None` assumes that it fits."""

    @property
    def now(self) -> float:
        """Seconds since the line was made."""
        ...

    @property
    def plugged(self) -> bool:
        """Whether the cable is in."""
        ...

    @property
    def backlog(self) -> float:
        """Seconds that the bytes which the host has queued still need to get onto the wire."""
        ...

    @property
    def next_event(self) -> float | None:
        """When something happens next; `None` while nothing is to."""
        ...

    @property
    def own_settings(self) -> SerialFormat:
        """What a host that fits has set its port to."""
        ...

    @property
    def unsaved(self) -> Iterable[str]:
        """Why something that should be in a file is not; a sentence each."""
        ...

    def send(self, data: bytes) -> None:
        """Queue bytes that the host sends now."""
        ...

    def receive(self) -> bytes:
        """Take what has reached the host so far."""
        ...

    def drop_unsent(self) -> None:
        """Forget what the host has queued."""
        ...

    def advance_to(self, moment: float) -> None:
        """Let time pass."""
        ...

    def unplug(self) -> None:
        """Pull the cable."""
        ...


class Server:
    """Runs one line for one endpoint until it is told to end.

    `control` obeys a control line and returns the answer, without a line end.
    """

    def __init__(
        self,
        line: Wire,
        endpoint: Endpoint,
        control: Callable[[str], str],
        demos: Sequence[Demo] = (),
    ) -> None:
        self._line = line
        self._control = control
        self._endpoint = endpoint
        self._demos = demos
        self._origin = time.monotonic()
        self._ended = False
        self._waiting = bytearray()
        self._hosts_left = 0
        self._told: set[str] = set()
        self._control_lines: deque[str | None] = deque()
        self._waker, self._wake = socket.socketpair()
        self._waker.setblocking(False)
        self._wake.setblocking(False)

    def run(self) -> None:
        """Serve; returns after `quit`, a signal, or the end of a pipe on standard input.

        Raises:
            TrexError: the EEPROM file or the endpoint failed.
        """
        previous = self._catch_signals()
        try:
            self._say(f"ready {self._endpoint.url}")
            self._read_control_lines()
            while not self._ended:
                self._turn()
        finally:
            for number, handler in previous.items():
                signal.signal(number, handler)
            self._endpoint.close()
            self._wake.close()
            self._waker.close()

    def _turn(self) -> None:
        """Do what is due, then wait for what comes next."""
        self._catch_up()
        if answer := self._line.receive():
            self._endpoint.write(answer)
        sources = [self._waker.fileno(), *self._endpoint.waiting_for()]
        ready, _, _ = select.select(sources, [], [], self._patience())
        self._catch_up()
        self._note_departure()  # before anything of the next host is taken
        for settings, data in self._endpoint.take(ready):
            self._receive(settings, data)
        self._note_departure()
        self._send_ahead()
        self._tell_of_unsaved()
        if self._waker.fileno() in ready:
            self._drain()
            self._obey()

    def _receive(self, seen: HostSettings | None, data: bytes) -> None:
        """Take bytes of the host; what it sent before it set its port anew is gone."""
        settings = self._host_settings(seen)
        if settings != self._line.host:
            self._drop_waiting()
            self._line.host = settings
        self._waiting += data[: _MOST_WAITING - len(self._waiting)]

    def _send_ahead(self) -> None:
        """Give the wire what it can carry in the next moments."""
        while self._waiting and self._line.backlog < _FULL_ENOUGH:
            self._line.send(bytes(self._waiting[:_SLICE]))
            del self._waiting[:_SLICE]

    def _tell_of_unsaved(self) -> None:
        """Say once for each reason that a board's memory is not in its file."""
        for reason in self._line.unsaved:
            if reason not in self._told:
                self._told.add(reason)
                sys.stderr.write(f"{reason}; the board goes on without it\n")

    def _note_departure(self) -> None:
        if self._endpoint.hosts_left != self._hosts_left:
            self._hosts_left = self._endpoint.hosts_left
            self._drop_waiting()

    def _drop_waiting(self) -> None:
        self._waiting.clear()
        self._line.drop_unsent()

    def _patience(self) -> float:
        """Return the seconds until something is due."""
        idle = _DEMO_IDLE if self._demos else _IDLE
        event = self._line.next_event
        if event is None:
            return 0.0 if self._waiting else idle
        wait = self._origin + event - time.monotonic()
        if self._line.backlog > _IN_LUMPS:
            wait = max(wait, _IN_LUMPS)
        return min(idle, max(0.0, wait))

    def _catch_up(self) -> None:
        now = time.monotonic() - self._origin
        if now - self._line.now > _SUSPENDED:
            self._origin += now - self._line.now
            now = self._line.now
        self._line.advance_to(now)
        for demo in self._demos:
            demo.update()

    def _host_settings(self, seen: HostSettings | None) -> SerialFormat | None:
        """Complete what was seen of the host's port; what cannot be seen fits the board."""
        if seen is None:
            return None
        own = self._line.own_settings
        parity = own.parity if seen.parity is None else Parity[seen.parity.upper()]
        return SerialFormat(seen.baud, parity, seen.stop_bits)

    # Control lines

    def _obey(self) -> None:
        while self._control_lines and not self._ended:
            text = self._control_lines.popleft()
            if text is None:
                self._ended = True
            elif text.strip():
                self._answer(text)

    def _answer(self, text: str) -> None:
        was_plugged = self._line.plugged
        answer = self._control(text)
        if was_plugged and not self._line.plugged:
            self._endpoint.unplug()
        elif self._line.plugged and not was_plugged:
            answer = self._plug(answer)
        self._ended = answer == GOODBYE
        self._say(answer)

    def _plug(self, answer: str) -> str:
        try:
            self._endpoint.plug()
        except EndpointError as error:
            self._line.unplug()
            return f"error {error}"
        return f"{answer} {self._endpoint.url}"

    def _say(self, text: str) -> None:
        try:
            sys.stdout.write(text + "\n")
            sys.stdout.flush()
        except (OSError, ValueError):
            self._ended = True  # nobody listens any more

    def _read_control_lines(self) -> None:
        """Read standard input in a thread: not every system can wait for it with `select`."""
        try:
            kind = os.fstat(0).st_mode
        except OSError:
            return  # started without
        ends_with_input = stat.S_ISFIFO(kind) or stat.S_ISSOCK(kind)
        if not ends_with_input and _is_nothing(kind):
            return
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
            self._call()
        if rest:
            self._control_lines.append(rest.decode("utf-8", "replace"))
        if ends_with_input:
            self._control_lines.append(None)
        self._call()

    # Waking up

    def _call(self) -> None:
        """Make the loop look round; from a thread or a signal handler."""
        with contextlib.suppress(OSError):  # full, so it is called already; or at its end
            self._wake.send(b"!")

    def _drain(self) -> None:
        with contextlib.suppress(BlockingIOError):
            while self._waker.recv(4096):
                pass

    def _catch_signals(self) -> dict[int, "signal._HANDLER"]:
        """Let signals end the loop; return what handled them before."""
        names = ("SIGINT", "SIGTERM", "SIGHUP")
        numbers = [getattr(signal, name) for name in names if hasattr(signal, name)]
        previous = {
            number: signal.signal(number, self._end)
            for number in numbers
            if signal.getsignal(number) is not signal.SIG_IGN  # as behind nohup
        }
        if hasattr(signal, "SIGTTIN"):
            # In the background of a terminal reading it is refused rather than stops all.
            previous[signal.SIGTTIN] = signal.signal(signal.SIGTTIN, signal.SIG_IGN)
        return previous

    def _end(self, _number: int, _frame: FrameType | None) -> None:
        self._ended = True
        self._call()


def _is_nothing(kind: int) -> bool:
    """Whether standard input is a device that is no terminal, such as /dev/null."""
    return stat.S_ISCHR(kind) and not os.isatty(0)
