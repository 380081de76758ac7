"""Start and control of the guardian process by the program."""

import contextlib
import logging
import os
import subprocess
import sys
import threading
import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Protocol

if sys.platform != "win32":
    import fcntl

from trex_gui.core.guardian.log import log_file

log = logging.getLogger(__name__)

HEARTBEAT_INTERVAL = 0.1  # seconds between heartbeats while motors may be moving

_END_TIMEOUT_S = 2.0
_ABORT_TIMEOUT_S = 6.0  # timeout while the process stops the motors, which takes up to 5 s
# A process counts as suspended if it has left this many messages unread, the oldest for this long.
_SUSPENDED_UNREAD = 3
_SUSPENDED_S = 0.25
_PIPE_SIZE = 4096  # bytes; Windows has the smallest pipe, and a write to a full pipe blocks

_watching_since: list[str] = []


def watching_since() -> str:
    """Return the time of the first heartbeat in the format of the log. `9999` before it."""
    return _watching_since[0] if _watching_since else "9999"


@dataclass(frozen=True, slots=True)
class StopSequence:
    """Packets that stop the motors, and queries that confirm the stop."""

    packets: bytes  # packets that stop every motor
    queries: tuple[bytes, ...]  # requests for the status of each board
    reply_size: int  # bytes per reply
    error_mask: int  # error bits in the first byte of a reply
    has_echo: bool  # True if all sent bytes come back before the reply
    seconds: float  # maximum duration of the packets, one query and its reply
    note: str = ""  # lines about the board for the file that `maintain_file` writes


def joined_stops(stops: Sequence[StopSequence]) -> StopSequence:
    """Return one stop sequence for all boards on a line."""
    first, *others = stops
    if not others:
        return first
    packets = b"".join(stop.packets for stop in stops)
    queries = tuple(query for stop in stops for query in stop.queries)
    seconds = sum(stop.seconds for stop in stops)
    return replace(first, packets=packets, queries=queries, seconds=seconds)


@dataclass(frozen=True, slots=True)
class SharedPort:
    """Open port that the guardian process inherits."""

    kind: str  # `serial`, `socket` or `telnet`
    number: int  # file descriptor, or handle on Windows


class Guardian(Protocol):
    """Interface between a session and its guardian.

    Attributes:
        is_ready: True if the process is running, responds and has not acted.
        has_acted: True if the process has started to stop the motors. The process may still use the
            line.
    """

    @property
    def is_ready(self) -> bool: ...
    @property
    def has_acted(self) -> bool: ...

    def wait_until_ready(self, seconds: float) -> None: ...

    def watch(self, sequence: StopSequence | None) -> None:
        """Send a heartbeat. `sequence`: current stop, or `None` if no motor can be moving."""

    def stop(self, seconds: float) -> bool:
        """Request a stop. Return whether it was confirmed within `seconds`."""

    def end(self) -> bool:
        """End the guardian and free the line. Return whether it confirmed a stop."""


class GuardianProcess:
    """Starts the guardian process. After a failure, `is_ready` stays false."""

    def __init__(self, port: SharedPort | None, silence: float, file: Path | None = None) -> None:
        """Start a process that acts after `silence` seconds without a heartbeat.

        `port`: `None` if the port has no descriptor. In this case no process is started. `file`:
        path of a file that exists while motors may be moving.
        """
        self._sent: StopSequence | None = None
        self._is_confirmed = False
        self._started, self._ended = threading.Event(), threading.Event()
        self._marked = threading.Event()
        self._has_file = file is not None
        self._unread, self._unread_size, self._unread_since = 0, 0, 0.0
        self._writing = threading.Lock()
        self.has_acted = False
        self._process: subprocess.Popen[bytes] | None = None
        try:
            self._process = None if port is None else _start(port, silence, file)
        except (OSError, ValueError) as error:
            log.warning("the guardian process cannot be started: %s", error)
        if self._process is None:
            self._ended.set()
            return
        threading.Thread(target=self._listen, args=(self._process,), daemon=True).start()

    def _listen(self, process: "subprocess.Popen[bytes]") -> None:
        # This loop ends when the descriptors are closed, even if the process is still running.
        with contextlib.suppress(OSError, ValueError):
            for line in process.stdout or ():
                if line != b"read\n":
                    log.debug("guardian process %d: %r", process.pid, line)
                match line.strip():
                    case b"read":
                        self._unread = self._unread_size = 0
                    case b"ready":
                        self._started.set()
                    case b"marked":
                        self._marked.set()
                    case b"stopping":
                        self.has_acted = True
                    case b"confirmed":
                        self._is_confirmed = True
                    case b"unconfirmed" | b"closed":
                        self._ended.set()  # the port is closed; a disk may still block the process
        process.wait()
        # Locked, because a new file could get the descriptor of the closed pipe.
        with self._writing, contextlib.suppress(OSError), process:
            self._ended.set()

    @property
    def is_ready(self) -> bool:
        has_failed = self.has_acted or self._ended.is_set() or self._is_suspended
        return self._started.is_set() and not has_failed

    @property
    def _is_suspended(self) -> bool:
        if self._unread < _SUSPENDED_UNREAD or not self._started.is_set() or self.has_acted:
            return False
        is_late = time.monotonic() - self._unread_since > _SUSPENDED_S
        return is_late and self._unread >= _SUSPENDED_UNREAD  # `_listen` may have reset the count

    @property
    def has_ended(self) -> bool:
        return self._ended.is_set()

    def wait_until_ready(self, seconds: float) -> None:
        if not self._ended.is_set():
            self._started.wait(seconds)

    def watch(self, sequence: StopSequence | None) -> None:
        if sequence is None and self._sent is None:
            return
        is_first, is_repeated = self._sent is None, sequence == self._sent
        self._sent = sequence
        if not _watching_since:
            _watching_since.append(time.strftime("%Y-%m-%d %H:%M:%S"))
        if is_repeated and not self._started.is_set():
            return  # a slow start must not fill the pipe
        self._marked.clear()
        self._send("idle" if sequence is None else _message(sequence))
        if is_first and self._has_file and self.is_ready:  # a slow start must not delay a stop
            self._marked.wait(0.1)

    def stop(self, seconds: float) -> bool:
        self._send("stop")
        self._ended.wait(seconds)
        return self._is_confirmed

    def end(self) -> bool:
        is_suspended = self._is_suspended
        # Without this message, the process would assume that the program has died.
        is_notified = self._send("end")
        seconds = _ABORT_TIMEOUT_S if self.has_acted else 0.0 if is_suspended else _END_TIMEOUT_S
        has_ended = self._ended.wait(seconds) or self._is_confirmed
        if self._process is not None and not has_ended and is_notified:
            log.warning("the guardian process does not respond")
            self._process.kill()
            self._ended.wait(_END_TIMEOUT_S)
        return self._is_confirmed

    def _send(self, message: str) -> bool:
        """Send a message. Return whether it was sent. Never blocks.

        A process with a full pipe has hung and would later act on old messages. It is killed.
        """
        process, data = self._process, f"{message}\n".encode("ascii")
        with self._writing:
            if process is None or process.stdin is None or self._ended.is_set():
                return False
            if self._unread and self._unread_size + len(data) > _PIPE_SIZE:
                process.kill()
                return False
            # Counted before the write, because the process may read the message at once.
            self._unread_since = self._unread_since if self._unread else time.monotonic()
            self._unread += 1
            self._unread_size += len(data)
            try:
                os.write(process.stdin.fileno(), data)
            except (OSError, ValueError) as error:
                is_closed_here = not isinstance(error, BrokenPipeError)
                self.has_acted |= is_closed_here and self._sent is not None
                return False
            return True


def _message(stop: StopSequence) -> str:
    stop_text = (
        f"{stop.packets.hex()} {','.join(query.hex() for query in stop.queries)} "
        f"{stop.reply_size} {stop.error_mask} {stop.has_echo:d} {stop.seconds}"
    )
    note = f"{stop.note}stop: {stop_text}\n".encode(errors="surrogateescape")
    return f"watch {stop_text} {note.hex()}"


def _start(port: SharedPort, silence: float, file: Path | None) -> "subprocess.Popen[bytes]":
    number = port.number
    options: dict[str, Any]
    if sys.platform == "win32":
        flags = subprocess.CREATE_NO_WINDOW | subprocess.CREATE_NEW_PROCESS_GROUP
        startup = subprocess.STARTUPINFO(lpAttributeList={"handle_list": [number]})
        options = {"startupinfo": startup, "creationflags": flags}
        os.set_handle_inheritable(number, True)
    else:
        # The number must be at least 3, because 0 to 2 become standard streams. A process in a
        # new session receives no signals from the terminal.
        number = fcntl.fcntl(number, fcntl.F_DUPFD_CLOEXEC, 3)
        options = {"pass_fds": [number], "start_new_session": True}
    command = [sys.executable, "--guardian"]
    if not getattr(sys, "frozen", False):
        # With -I and -S, Python ignores the user's configuration.
        command[1:] = ["-I", "-S", str(Path(__file__).with_name("process.py"))]
        if sys.platform == "win32":
            # In a virtual environment, `executable` is a launcher that would continue to run.
            command[0] = getattr(sys, "_base_executable", "") or sys.executable
    try:
        return subprocess.Popen(  # noqa: S603 - our own program
            [*command, port.kind, str(number), str(silence), str(log_file()), str(file or "")],
            bufsize=0,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            # Without a console, the process may not be able to inherit standard error.
            stderr=subprocess.DEVNULL if sys.stderr is None else None,
            **options,
        )
    finally:
        if sys.platform == "win32":
            os.set_handle_inheritable(number, False)  # otherwise Qt's processes would inherit it
        else:
            os.close(number)
