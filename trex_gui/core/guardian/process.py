"""Guardian process: stops the motors when the program is silent.

The process shares the program's open port. It uses only the standard library, so that it starts in
milliseconds, stays small and does not fail with the program.

It reads one message per line from its standard input:

    watch STOP QUERY,… REPLY_SIZE ERROR_MASK HAS_ECHO SECONDS NOTE   heartbeat: motors may move
    idle   no motor can be moving
    stop   stop the motors now
    end    the program needs the line again, or has closed it

Bytes are hexadecimal. `StopSequence` in `guardian.py` explains the fields. The process sends
`ready` when it starts, `read` for each message, and `marked` once `maintain_file` has written its
file. When it stops the motors, it sends `stopping`, then `confirmed` or `unconfirmed`, and logs
the result.
"""

import os
import queue
import select
import signal
import socket
import sys
import threading
import time
from collections.abc import Callable, Generator, Sequence
from contextlib import suppress
from io import FileIO

if sys.platform != "win32":
    import fcntl
    import termios

_GIVE_UP_S = 5.0  # maximum duration of a stop in seconds
_GRACE_S = 0.02  # extra wait in seconds for a heartbeat in transit
_LATE_S = 0.05  # if a wait ends this much later than due (s), this process was suspended
_LATE_GRACE_S = 0.1  # extra wait in seconds for messages after a suspension
_CLEAN_ROUNDS = 2  # consecutive rounds of error-free replies that confirm a stop
_QUIET_S = 0.03
"""Silence in seconds that ends a reply.

It is longer than three bytes at 1200 baud, and longer than the delay of common adapters. After a
shorter silence, the first byte of an echoed request could count as a reply."""

_MAX_READ = 4096  # bytes per read


class FilePort:
    """Serial port of a POSIX system. Raises OSError if the line is gone."""

    def __init__(self, descriptor: int) -> None:
        self._descriptor = descriptor
        os.set_blocking(descriptor, False)  # after `select`, another process may read the bytes
        self.save_settings()

    def save_settings(self) -> None:
        self._settings = self._read_settings()

    def restore_settings(self) -> None:
        """Undo the changes that a search for a silent board has made."""
        if self._settings is not None and self._settings != self._read_settings():
            with suppress(termios.error):
                termios.tcsetattr(self._descriptor, termios.TCSANOW, self._settings)

    def _read_settings(self) -> "list[int | list[bytes | int]] | None":
        with suppress(termios.error):
            return termios.tcgetattr(self._descriptor)
        return None

    def write(self, data: bytes) -> None:
        while data:
            _, ready, _ = select.select([], [self._descriptor], [], _GIVE_UP_S)
            if not ready:
                raise TimeoutError("the port accepts no data")
            with suppress(BlockingIOError):
                data = data[os.write(self._descriptor, data) :]

    def receive(self, seconds: float) -> bytes:
        """Return the received bytes. Wait up to `seconds` for the first byte."""
        ready, _, _ = select.select([self._descriptor], [], [], max(0.0, seconds))
        data = b""
        with suppress(BlockingIOError):
            data = os.read(self._descriptor, _MAX_READ) if ready else b""
        if ready and not data:  # another reader was faster, or the line is gone
            time.sleep(_GRACE_S)
        return data

    def close(self) -> None:
        os.close(self._descriptor)


class SocketPort:
    def __init__(self, number: int) -> None:
        self._socket = socket.socket(fileno=number)

    def write(self, data: bytes) -> None:
        self._socket.settimeout(_GIVE_UP_S)
        self._socket.sendall(data)

    def receive(self, seconds: float) -> bytes:
        self._socket.settimeout(max(0.0, seconds))
        try:
            data = self._socket.recv(_MAX_READ)
        except (BlockingIOError, TimeoutError):
            return b""
        if not data:
            raise OSError("the line is gone")
        return data

    def save_settings(self) -> None:
        """Do nothing, because the other end has the settings."""

    restore_settings = save_settings

    def close(self) -> None:
        self._socket.close()


class TelnetPort(SocketPort):
    """RFC 2217 port. In Telnet, 255 starts a command (RFC 854)."""

    _IAC, _SE, _SB, _WILL, _DONT = 255, 240, 250, 251, 254

    def __init__(self, number: int) -> None:
        super().__init__(number)
        self._data = self._decoder()
        next(self._data)

    def write(self, data: bytes) -> None:
        super().write(data.replace(b"\xff", b"\xff\xff"))

    def receive(self, seconds: float) -> bytes:
        return b"".join(map(self._data.send, super().receive(seconds)))

    def _decoder(self) -> Generator[bytes, int, None]:
        """Receive one byte from each `send`. Yield the data that this byte completes."""
        data = b""
        while True:
            byte = yield data
            data = b""
            if byte != self._IAC:
                data = bytes([byte])
                continue
            command = yield b""
            if command == self._IAC:
                data = b"\xff"
            elif command == self._SB:
                last = 0
                while (byte := (yield b"")) != self._SE or last != self._IAC:
                    last = 0 if last == byte == self._IAC else byte
            elif self._WILL <= command <= self._DONT:
                yield b""


if sys.platform == "win32":
    import _winapi
    import ctypes

    class WindowsPort:
        """Serial port of Windows, opened for overlapped I/O.

        The port's own timeouts are unreliable, because pyserial removes them when the program
        closes the port. A transfer that takes too long is therefore cancelled.
        """

        _STATE_SIZE = 28  # bytes of a DCB; the first word is the size

        def __init__(self, handle: int) -> None:
            self._handle = handle
            self.save_settings()

        def save_settings(self) -> None:
            self._settings = self._read_settings()

        def restore_settings(self) -> None:
            if self._settings is not None and self._settings != self._read_settings():
                handle = ctypes.c_void_p(self._handle)
                ctypes.windll.kernel32.SetCommState(handle, self._settings)

        def _read_settings(self) -> bytes | None:
            size = self._STATE_SIZE.to_bytes(4, "little")
            state = ctypes.create_string_buffer(size, self._STATE_SIZE)
            handle = ctypes.c_void_p(self._handle)
            return state.raw if ctypes.windll.kernel32.GetCommState(handle, state) else None

        def write(self, data: bytes) -> None:
            end = time.monotonic() + _GIVE_UP_S
            while data:
                overlapped, _ = _winapi.WriteFile(self._handle, data, overlapped=True)
                data = data[self._finish(overlapped, end - time.monotonic()) :]
                if data and time.monotonic() >= end:
                    raise TimeoutError("the port accepts no data")

        def receive(self, seconds: float) -> bytes:
            end = time.monotonic() + seconds
            while True:
                overlapped, _ = _winapi.ReadFile(self._handle, 1, overlapped=True)
                count = self._finish(overlapped, end - time.monotonic())
                if count or time.monotonic() >= end:
                    return bytes(overlapped.getbuffer() or b"")
                time.sleep(0.001)  # the port's timeouts may end a read at once

        @staticmethod
        def _finish(overlapped: "_winapi.Overlapped", seconds: float) -> int:
            """Wait for a transfer. Cancel it after a timeout. Return its size in bytes."""
            _winapi.WaitForSingleObject(overlapped.event, max(0, int(seconds * 1000)))
            overlapped.cancel()  # no effect on a complete transfer
            count, _ = overlapped.GetOverlappedResult(True)
            return count

        def close(self) -> None:
            _winapi.CloseHandle(self._handle)

    SystemPort = WindowsPort
else:
    SystemPort = FilePort
Port = SystemPort | SocketPort


def open_port(kind: str, number: int) -> Port:
    if kind == "telnet":
        return TelnetPort(number)
    return SocketPort(number) if kind == "socket" else SystemPort(number)


class StopMessage:
    """Fields of a `watch` message. `StopSequence` explains them."""

    def __init__(self, fields: list[str]) -> None:
        packets, queries, size, mask, echo, seconds, note = fields
        self.packets = bytes.fromhex(packets)
        self.queries = tuple(map(bytes.fromhex, queries.split(",")))
        self.reply_size, self.error_mask = int(size), int(mask)
        self.has_echo = echo == "1"
        self.seconds = float(seconds)
        self.note = bytes.fromhex(note)


_DISK_TIMEOUT_S = 60.0
FINISHED = b"finished\n"  # content of a file that `maintain_file` is about to remove


def maintain_file(
    path: str, notes: "queue.Queue[bytes | None]", written: Callable[[], object]
) -> None:
    """Write each note to a locked file. `None` ends the loop.

    An empty note removes the file. The loop runs in its own thread, so that a slow disk never
    delays a stop. An unchanged note is written again only after a failure. `written` is
    called once the file contains a new note.
    """
    file: FileIO | None = None
    last = b""
    while (note := notes.get()) is not None:
        with suppress(OSError):
            if note and file is None:
                os.makedirs(os.path.dirname(path), exist_ok=True)  # noqa: PTH103, PTH120
                flags = os.O_RDWR | os.O_CREAT | getattr(os, "O_NONBLOCK", 0)
                opened = FileIO(os.open(path, flags, 0o644), "r+")
                if sys.platform != "win32":
                    fcntl.flock(opened, fcntl.LOCK_EX)
                file, since = opened, time.strftime("since: %Y-%m-%d %H:%M:%S\n")
            if file is not None and note != last:
                tail = f"{'' if b'since: ' in note else since}guardian: {os.getpid()}\n".encode()
                file.seek(0)
                file.truncate(file.write(note + tail if note else FINISHED))
                last = note
                if note:
                    written()
                    os.fsync(file.fileno())
                else:
                    file.close()
                    file = None
                    os.unlink(path)  # noqa: PTH108


class Watchdog:
    """Stops the motors after `silence` seconds without a message."""

    def __init__(
        self, port: Port, silence: float, files: Sequence[str], messages: FileIO, replies: FileIO
    ) -> None:
        """`files`: paths of the log file and of the file that `maintain_file` writes."""
        self._port = port
        self._silence = silence
        self._log_file, path = files
        self._replies = replies
        self._notes: queue.Queue[bytes | None] = queue.Queue()
        arguments = (path, self._notes, lambda: self._reply("marked"))
        self._writer = threading.Thread(target=maintain_file, args=arguments, daemon=True)
        self._writer.start()
        self._is_cancelled = False
        self._messages: queue.Queue[str] = queue.Queue()
        threading.Thread(target=self._listen, args=(messages,), daemon=True).start()

    def _listen(self, messages: FileIO) -> None:
        for line in messages:
            self._messages.put(line.decode("ascii").strip())
        self._messages.put("")

    def run(self) -> None:
        self._reply("ready")
        if (due := self._supervise()) is not None:
            self._act(*due)
        else:
            with suppress(OSError):
                self._port.close()
            self._reply("closed")
        self._notes.put(None)
        # The file must not outlive the process after a stop. The disk may be slow, or hang.
        self._writer.join(_DISK_TIMEOUT_S)

    def _act(self, stop: StopMessage, reason: str) -> None:
        self._reply("stopping")
        try:
            confirmed = self._stop(stop)
        except OSError as error:
            confirmed, result = False, f"The line failed ({error}): the stop is not confirmed."
        else:
            result = "The stop was sent and is confirmed."
            if not confirmed:
                result = "The stop was sent, but the board did not confirm it."
            if self._is_cancelled:
                result = "A stop was sent; the program responds again and repeats it."
        outcome = "confirmed" if confirmed else "unconfirmed"
        with suppress(OSError):
            self._port.close()  # before logging, which may block
        self._reply(outcome)
        if self._is_cancelled:
            outcome = "repeated"
        if confirmed:
            self._notes.put(b"")
        self._log(outcome, f"{reason} while motors could move. {result}")

    def _supervise(self) -> tuple[StopMessage, str] | None:
        """Wait until a stop is due. Return the stop and its reason, or `None` if none is needed."""
        stop: StopMessage | None = None
        while True:
            message = self._next(None if stop is None else self._silence)
            if message:
                self._reply("read")
            match message.split() if message is not None else None:
                case None if stop is not None:
                    return stop, "The program did not respond"
                case ["watch", *fields]:
                    if stop is None:
                        self._port.save_settings()
                    stop = StopMessage(fields)
                    self._notes.put(stop.note)
                case ["idle"]:
                    stop = None
                    self._notes.put(b"")
                case ["stop"] if stop is not None:
                    return stop, "The program requested a stop"
                case [] if stop is not None:
                    return stop, "The program ended"
                case _:
                    return None

    def _next(self, seconds: float | None) -> str | None:
        """Return the next message. `None` after a timeout. Empty at the end of the input."""
        started = time.monotonic()
        with suppress(queue.Empty):
            return self._messages.get(timeout=seconds)
        is_late = time.monotonic() - started > (seconds or 0) + _LATE_S
        with suppress(queue.Empty):
            return self._messages.get(timeout=_LATE_GRACE_S if is_late else _GRACE_S)
        return None

    def _stop(self, stop: StopMessage) -> bool:
        """Send the stop repeatedly. Return whether every board has confirmed it."""
        self._port.restore_settings()
        self._port.write(stop.packets)
        end = time.monotonic() + _GIVE_UP_S
        self._read_until_quiet(stop.seconds)  # a board does not listen while it replies
        first, *others = stop.queries
        clean = 0
        while clean < _CLEAN_ROUNDS and time.monotonic() < end and not self._is_cancelled:
            answers = [self._is_clean(stop, sent) for sent in (stop.packets + first, *others)]
            clean = clean + 1 if all(answers) else 0
            with suppress(queue.Empty):
                self._is_cancelled = self._messages.get_nowait() == "end"
        return clean == _CLEAN_ROUNDS

    def _is_clean(self, stop: StopMessage, sent: bytes) -> bool:
        """Send a query. Return whether its reply reports no error."""
        self._port.write(sent)
        echo = len(sent) if stop.has_echo else 0
        reply = self._read(echo + stop.reply_size, stop.seconds)
        return len(reply) == echo + stop.reply_size and not reply[echo] & stop.error_mask

    def _read(self, size: int, seconds: float) -> bytes:
        """Return `size` bytes, or fewer after a timeout, or more from a busy line."""
        received = b""
        end = time.monotonic() + seconds
        while len(received) < size and (remaining := end - time.monotonic()) > 0:
            received += self._port.receive(remaining)
        return received + self._read_until_quiet(seconds)

    def _read_until_quiet(self, seconds: float) -> bytes:
        received = b""
        end = time.monotonic() + seconds
        while (data := self._port.receive(_QUIET_S)) and time.monotonic() < end:
            received += data
        return received + data

    def _reply(self, word: str) -> None:
        with suppress(OSError, ValueError):  # the program may be gone
            self._replies.write(f"{word}\n".encode("ascii"))

    def _log(self, outcome: str, text: str) -> None:
        line = f"{time.strftime('%Y-%m-%d %H:%M:%S')} {outcome}: {text}\n"
        with suppress(OSError):
            os.makedirs(os.path.dirname(self._log_file), exist_ok=True)  # noqa: PTH103, PTH120
            flags = os.O_WRONLY | os.O_APPEND | os.O_CREAT | getattr(os, "O_NONBLOCK", 0)
            with FileIO(os.open(self._log_file, flags, 0o644), "a") as file:
                file.write(line.encode())
        with suppress(OSError, ValueError):
            if sys.stderr is not None:
                sys.stderr.write(f"TReX Studio guardian: {text}\n")
                sys.stderr.flush()


def main(arguments: list[str]) -> int:
    """Run the guardian of a port. It ignores the signals that end the program.

    The arguments are the kind of the port, its descriptor or handle, the silence in s, and the
    `files` of `Watchdog`.
    """
    for name in ("SIGINT", "SIGTERM", "SIGHUP", "SIGBREAK"):
        if (number := getattr(signal, name, None)) is not None:
            signal.signal(number, signal.SIG_IGN)
    kind, number, silence, *files = arguments
    port = open_port(kind, int(number))
    # Unbuffered, because a thread blocked in a buffered read would prevent the exit.
    Watchdog(port, float(silence), files, FileIO(0), FileIO(1, "w")).run()
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
