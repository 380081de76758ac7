"""The program's end of the guardian process."""

import contextlib
import logging
import os
import subprocess
import sys
import threading
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

if sys.platform != "win32":
    import fcntl

from trex_gui.core.guardian.log import log_file

log = logging.getLogger(__name__)

HEARTBEAT_INTERVAL = 0.1
"""Longest time in seconds between two heartbeats while motors may be moving."""

_ENDING_S = 0.5  # seconds that the process may take to end

_MOST_UNREAD = 20
"""Messages that the process may leave unread: two seconds of heartbeats."""


@dataclass(frozen=True, slots=True)
class StopSequence:
    """How the motors are stopped right now.

    Attributes:
        packets: what stops every motor.
        query: asks for the status.
        reply_size: bytes of its reply.
        error_mask: bits of its first byte that report errors on the line.
        has_echo: whether everything sent comes back before the reply.
        seconds: how long one round takes at most.
    """

    packets: bytes
    query: bytes
    reply_size: int
    error_mask: int
    has_echo: bool
    seconds: float


@dataclass(frozen=True, slots=True)
class SharedPort:
    """An open port for a child process.

    Attributes:
        kind: `serial`, `socket` or `telnet`.
        number: its file descriptor; on Windows a handle.
    """

    kind: str
    number: int


class Guardian(Protocol):
    """A guardian from the view of a session.

    Attributes:
        is_ready: it is running and has not acted.
        has_acted: it has begun to stop the motors, and may still use the line.
    """

    @property
    def is_ready(self) -> bool: ...
    @property
    def has_acted(self) -> bool: ...

    def wait_until_ready(self, seconds: float) -> None: ...

    def watch(self, sequence: StopSequence | None) -> None:
        """Send a heartbeat with the present stop; with `None`, say that no motor may move."""

    def stop(self, seconds: float) -> bool:
        """Let it stop the motors; return whether that was confirmed within `seconds`."""

    def end(self) -> bool:
        """End it, and return whether it has confirmed a stop; from then on the line is free."""


class GuardianProcess:
    """Starts the process; where that is impossible `is_ready` stays false."""

    def __init__(self, port: SharedPort | None, silence: float) -> None:
        """Make it act after so many seconds of `silence`; `None` is a port without descriptor."""
        self._sent: StopSequence | None = None
        self._is_confirmed = False
        self._started, self._ended = threading.Event(), threading.Event()
        self._unread = 0
        self._writing = threading.Lock()
        self.has_acted = False
        self._process: subprocess.Popen[bytes] | None = None
        try:
            self._process = None if port is None else _start(port, silence)
        except (OSError, ValueError) as error:
            log.warning("the guardian process cannot be started: %s", error)
        if self._process is None:
            self._ended.set()
            return
        threading.Thread(target=self._listen, args=(self._process,), daemon=True).start()

    def _listen(self, process: "subprocess.Popen[bytes]") -> None:
        for line in process.stdout or ():
            if line != b"read\n":
                log.debug("guardian process %d: %r", process.pid, line)
            match line.strip():
                case b"read":
                    self._unread = 0
                case b"ready":
                    self._started.set()
                case b"stopping":
                    self.has_acted = True
                case b"confirmed":
                    self._is_confirmed = True
        with self._writing:  # not into a descriptor of the same number
            self._ended.set()
            if process.stdin is not None:
                process.stdin.close()
        with process:  # closes the other pipe and waits for its end
            pass

    @property
    def is_ready(self) -> bool:
        return self._started.is_set() and not self.has_acted and not self._ended.is_set()

    @property
    def has_ended(self) -> bool:
        return self._ended.is_set()

    def wait_until_ready(self, seconds: float) -> None:
        if not self._ended.is_set():
            self._started.wait(seconds)

    def watch(self, sequence: StopSequence | None) -> None:
        if sequence is None and self._sent is None:
            return
        self._sent = sequence
        self._send("idle" if sequence is None else _message(sequence))

    def stop(self, seconds: float) -> bool:
        self._send("stop")
        self._ended.wait(seconds)
        return self._is_confirmed

    def end(self) -> bool:
        self._send("end")
        if self._process is not None and not self._ended.wait(_ENDING_S):
            self._process.kill()
            self._ended.wait(_ENDING_S)
        return self._is_confirmed

    def _send(self, message: str) -> None:
        """Send a message, or end a process that does not read its messages."""
        process = self._process
        if process is None or process.stdin is None:
            return
        with self._writing, contextlib.suppress(OSError, ValueError):  # it may have ended
            if not self._ended.is_set() and self._unread < _MOST_UNREAD:
                self._unread += 1
                os.write(process.stdin.fileno(), f"{message}\n".encode("ascii"))
                return
        if not self._ended.is_set():
            log.warning("the guardian process does not respond")
            process.kill()


def _message(stop: StopSequence) -> str:
    return (
        f"watch {stop.packets.hex()} {stop.query.hex()} {stop.reply_size} {stop.error_mask} "
        f"{stop.has_echo:d} {stop.seconds}"
    )


def _start(port: SharedPort, silence: float) -> "subprocess.Popen[bytes]":
    if getattr(sys, "frozen", False):
        command = [sys.executable, "--guardian"]
    else:
        # -I, -S: nothing of the user's Python set-up is imported.
        command = [sys.executable, "-I", "-S", str(Path(__file__).with_name("process.py"))]
    pipe = subprocess.PIPE
    # A window without a console may have a standard error that cannot be inherited.
    errors = subprocess.DEVNULL if sys.stderr is None else None
    if sys.platform == "win32":
        command += [port.kind, str(port.number), str(silence), str(log_file())]
        if not getattr(sys, "frozen", False):
            # In a virtual environment `executable` is a launcher, which would stay beside it.
            command[0] = getattr(sys, "_base_executable", "") or sys.executable
        startup = subprocess.STARTUPINFO(lpAttributeList={"handle_list": [port.number]})
        flags = subprocess.CREATE_NO_WINDOW | subprocess.CREATE_NEW_PROCESS_GROUP
        os.set_handle_inheritable(port.number, True)
        try:
            return subprocess.Popen(  # noqa: S603 - our own program
                command,
                bufsize=0,
                stdin=pipe,
                stdout=pipe,
                stderr=errors,
                startupinfo=startup,
                creationflags=flags,
            )
        finally:
            os.set_handle_inheritable(port.number, False)  # Qt's processes inherit every handle
    # Not one of the first three, which would become a pipe: a program may be started without them.
    number = fcntl.fcntl(port.number, fcntl.F_DUPFD_CLOEXEC, 3)
    try:
        # In a session of its own the signals of a terminal do not reach it.
        return subprocess.Popen(  # noqa: S603 - our own program
            [*command, port.kind, str(number), str(silence), str(log_file())],
            bufsize=0,
            stdin=pipe,
            stdout=pipe,
            stderr=errors,
            pass_fds=[number],
            start_new_session=True,
        )
    finally:
        os.close(number)
