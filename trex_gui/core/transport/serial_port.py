"""Serial port that converts every failure to an error for the user.

A small interface hides pyserial's local and remote ports, so that tests can replace them with a
simulated wire in virtual time.
"""

import contextlib
import errno
import logging
import os
import re
import select
import shlex
import socket
import sys
import time
from collections.abc import Callable, Collection
from pathlib import Path
from typing import Any, Protocol, cast

import serial
from serial import rfc2217
from serial.tools import list_ports

if sys.platform != "win32":
    import termios

from trex_gui.core.errors import BadReply, BadRequest, PortFault, PortShared, PortUnavailable
from trex_gui.core.guardian.guardian import Guardian, GuardianProcess, SharedPort
from trex_gui.core.texts import hex_text
from trex_gui.core.translation import tr
from trex_gui.core.transport.driven import DrivenBoard, driven_at
from trex_gui.core.transport.linux_ports import (
    holder_of,
    is_left_to_guardian,
    is_locked_elsewhere,
    rates_of,
)
from trex_gui.core.transport.settings import PortSettings, SerialFormat

log = logging.getLogger(__name__)

# In addition to OSError, pyserial raises these errors for a bad address, a closed port, an
# unsupported function or an invalid pattern (hwgrep://).
PORT_ERRORS: tuple[type[Exception], ...] = (
    OSError,
    ValueError,
    TypeError,
    AttributeError,
    NotImplementedError,
    re.error,
)
if sys.platform != "win32":
    PORT_ERRORS += (termios.error,)

_SLICE = 0.02  # timeout of a blocking read in seconds
_DISCARD_TIMEOUT = 0.05  # seconds before `discard` fails on a line that never becomes quiet

_MANY_READS = 10
"""Number of reads before `discard` fails.

After a suspension of the program, one or two reads return everything."""

_WRITE_TIMEOUT = 1.0  # seconds after which a port that accepts no byte counts as gone
_LOCAL_LATENCY = 0.06
"""Latency in seconds: two latency timers of a common adapter (16 ms each), and system delays."""

_REMOTE_LATENCY = 0.5  # latency of a network in seconds
_BUSY = frozenset({errno.EBUSY, errno.EAGAIN})

_CLOSING_S = 1.5
"""Seconds to wait for a port that another line of this program is closing.

Before closing, that line may attempt to stop the motors. These attempts take at most this long."""


def latency_of(url: str) -> float:
    """Return the maximum delay of a byte in seconds, not including its time on the wire."""
    return _REMOTE_LATENCY if "://" in url else _LOCAL_LATENCY


class Transport(Protocol):
    """Open line. Its methods raise PortUnavailable if the line is gone.

    Attributes:
        latency: maximum delay of a byte in seconds, not including its time on the wire.
        is_configurable: True if `reconfigure` has an effect.
    """

    @property
    def latency(self) -> float: ...
    @property
    def is_configurable(self) -> bool: ...

    def rates(self, wanted: Collection[int]) -> frozenset[int] | None:
        """Return the wanted baud rates that the port supports. `None` if unknown.

        Sends nothing and never raises. Call it before anything is sent on the port.
        """

    def reconfigure(self, line: SerialFormat) -> None:
        """Change the line settings. No byte may be on the wire. Raises BadRequest."""

    def clock(self) -> float:
        """Return the monotonic time in seconds."""

    def write(self, data: bytes) -> None: ...

    def read(self, size: int, seconds: float) -> bytes:
        """Return up to `size` bytes after at most `seconds`."""

    def discard(self) -> bytes:
        """Discard received bytes and return them. Raises BadReply if bytes keep arriving."""

    def wait(self, seconds: float) -> None: ...

    def start_guardian(self, silence: float) -> Guardian:
        """Start a guardian for this line. See `GuardianProcess`. Never raises."""

    def close(self) -> None:
        """Close the port. Never raises."""


class _LentSocket:
    """Socket of a remote port, as used by pyserial's thread.

    While a guardian stops the motors, pyserial must not read the replies to the guardian.
    """

    def __init__(self, below: socket.socket, is_lent: Callable[[], bool]) -> None:
        self._below = below
        self._is_lent = is_lent

    def recv(self, size: int) -> bytes:
        """Return received bytes. Without any, raise TimeoutError, so that pyserial retries."""
        try:
            ready, _, _ = select.select([self._below], [], [], _SLICE)
        except ValueError as error:  # the socket was closed
            raise ConnectionAbortedError from error
        if self._is_lent():
            time.sleep(_SLICE)
        elif ready:
            return self._below.recv(size)
        raise TimeoutError

    def __getattr__(self, name: str) -> Any:
        return getattr(self._below, name)


class _Rfc2217Port(rfc2217.Serial):
    guardian: GuardianProcess | None = None
    fault: serial.SerialException | None = None  # error that has ended pyserial's thread
    _socket: Any

    def _is_lent(self) -> bool:
        guardian = self.guardian
        return guardian is not None and guardian.has_acted and not guardian.has_ended

    def _telnet_read_loop(self) -> None:
        self._socket = _LentSocket(self._socket, self._is_lent)
        try:
            super()._telnet_read_loop()  # type: ignore[misc] # not in the stubs
        except Exception as error:  # noqa: BLE001 - raised for unexpected bytes
            log.info("%s: %r", self.port, error)
            self.fault = serial.SerialException(tr("the server does not use RFC 2217"))


class SerialTransport:
    def __init__(self, settings: PortSettings, clock: Callable[[], float] = time.monotonic) -> None:
        self._url, self._name = settings.url, settings.label
        self.clock = clock
        self._guardian: GuardianProcess | None = None
        self.latency = latency_of(settings.url)
        # For a plain network port, the other end sets the rate.
        self.is_configurable = not settings.url.startswith("socket://")
        file, board = driven_at(settings.url)  # before opening, to resume a suspended guardian
        self._file = file if self._name == self._url else None  # the demo has no file
        try:
            self._port = _open(settings, clock)
            log.debug("opened %s", settings.text())
            if board is not None:
                self._stop(board)
                self.reconfigure(settings.line)
        except PortUnavailable as error:
            with contextlib.suppress(AttributeError):  # the port was not opened
                self.close()
            if board is not None:  # the message must start with the danger
                error.args = (f"{board.text()} {error}",)
            raise

    def _stop(self, board: DrivenBoard) -> None:
        """Stop the motors of a board left running. A guardian confirms the stop."""
        with contextlib.suppress(BadRequest):
            self.reconfigure(board.settings.line)
        self.write(board.stop.packets)
        guardian = self.start_guardian(60.0)
        guardian.watch(board.stop)
        guardian.stop(2.5)  # waits up to 2.5 s for a silent board
        log.warning("%s", board.text(stopped=guardian.end()))

    def rates(self, wanted: Collection[int]) -> frozenset[int] | None:
        return None if "://" in self._url else rates_of(self._port, wanted)

    def reconfigure(self, line: SerialFormat) -> None:
        try:
            for name, value in _options(self._url, line).items():
                if getattr(self._port, name) != value:
                    log.debug("%s: %s is now %s", self._url, name, value)
                    setattr(self._port, name, value)
        except PORT_ERRORS as error:
            if isinstance(error, ValueError) or _errno(error) in {None, errno.EINVAL}:
                raise BadRequest(tr("the port cannot be set to {0}").format(line.text())) from error
            raise self._lost_line(error) from error

    def write(self, data: bytes) -> None:
        try:
            if self._port.write_timeout == 0:
                self._write_all(data)
            else:
                self._port.write(data)
        except PORT_ERRORS as error:
            raise self._lost_line(error) from error

    def _write_all(self, data: bytes) -> None:
        """Write all bytes. pyserial's own timeout would also expire if this thread is late."""
        while data:
            _, ready, _ = select.select([], [self._port.fileno()], [], _WRITE_TIMEOUT)
            if not ready:
                raise serial.SerialTimeoutException(tr("the port accepts no data"))
            data = data[self._port.write(data) :]

    def read(self, size: int, seconds: float) -> bytes:
        received = bytearray()
        deadline = self.clock() + seconds
        try:
            while len(received) < size:
                received += self._port.read(size - len(received))
                if self.clock() >= deadline:
                    # Bytes that arrived in time count, even if this thread is late.
                    available = min(self._port.in_waiting, size - len(received))
                    received += self._port.read(available) if available > 0 else b""
                    break
        except PORT_ERRORS as error:
            raise self._read_error(error) from error
        return bytes(received)

    def discard(self) -> bytes:
        stale = bytearray()
        reads = 0
        deadline = self.clock() + _DISCARD_TIMEOUT
        try:
            while available := self._port.in_waiting:
                stale += self._port.read(available)
                reads += 1
                if reads > _MANY_READS and self.clock() > deadline:
                    raise BadReply(
                        tr("The device sends data without being queried ({0} …).").format(
                            hex_text(stale[:12])
                        )
                    )
        except PORT_ERRORS as error:
            raise self._read_error(error) from error
        return bytes(stale)

    def wait(self, seconds: float) -> None:
        if seconds > 0:
            time.sleep(seconds)

    def start_guardian(self, silence: float) -> Guardian:
        self._guardian = GuardianProcess(_shared(self._port), silence, self._file)
        if isinstance(self._port, _Rfc2217Port):
            self._port.guardian = self._guardian
        return self._guardian

    def close(self) -> None:
        # pyserial does not close the socket of a remote port that the other end has closed.
        remote = getattr(self._port, "_socket", None)
        if remote is not None and self._guardian is not None and not self._guardian.has_ended:
            # Detached, because pyserial would also end the guardian's connection.
            remote = socket.socket(fileno=remote.detach())
        with contextlib.suppress(*PORT_ERRORS):
            self._port.close()
        if remote is not None:
            with contextlib.suppress(*PORT_ERRORS):
                remote.close()
        log.debug("closed %s", self._url)

    def _read_error(self, error: Exception) -> PortUnavailable:
        """Return the error for a failed read. The port is lost, or another program reads it.

        In both cases the port reports available bytes, but a read returns none.
        """
        is_empty = isinstance(error, serial.SerialException) and _errno(error) is None
        if is_empty and sys.platform != "win32":
            with contextlib.suppress(*PORT_ERRORS):
                termios.tcgetattr(self._port.fileno())  # fails on a lost terminal
                return PortShared(tr(PortFault.SHARED.value).format(self._name))
        return self._lost_line(error)

    def _lost_line(self, error: Exception) -> PortUnavailable:
        log.info("the line %s is gone: %s", self._url, error)
        if isinstance(self._port, _Rfc2217Port) and (fault := self._port.fault):
            return PortUnavailable(tr(PortFault.UNREACHABLE.value).format(self._name, fault))
        return PortUnavailable(tr(PortFault.GONE.value).format(self._name), is_missing=True)


def _options(url: str, line: SerialFormat) -> dict[str, Any]:
    """Return pyserial's settings for a line. Pseudo-terminals reject any parity."""
    is_pseudo = Path(os.path.realpath(url)).is_relative_to("/dev/pts")
    parity = serial.PARITY_NONE if is_pseudo else line.parity.value
    return {"baudrate": line.baud, "parity": parity, "stopbits": line.stop_bits}


def _is_file(url: str) -> bool:
    """Return whether a port is a POSIX device with a file descriptor."""
    return "://" not in url and sys.platform != "win32"


def _shared(port: serial.Serial) -> SharedPort | None:
    """Return a port for a child process. `None` for a port without a descriptor (`loop://`)."""
    with contextlib.suppress(*PORT_ERRORS):
        if (remote := getattr(port, "_socket", None)) is not None:
            kind = "telnet" if isinstance(port, _Rfc2217Port) else "socket"
            return SharedPort(kind, remote.fileno())
        if sys.platform == "win32":
            return SharedPort("serial", int(port._port_handle))  # noqa: SLF001 - no public name
        return SharedPort("serial", port.fileno())
    return None


def _open(settings: PortSettings, clock: Callable[[], float]) -> serial.Serial:
    try:
        options = _options(settings.url, settings.line)
        port = _unopened(settings.url, timeout=_SLICE, **options)
        if _is_file(settings.url):
            port.exclusive = True
        _open_when_free(port, settings.url, clock)
    except PORT_ERRORS as error:
        raise open_error(settings.url, settings.line, error) from error
    # FTDI adapters delay bytes by up to 16 ms. The Linux driver can disable this delay.
    with contextlib.suppress(AttributeError, ValueError, OSError, NotImplementedError):
        port.set_low_latency_mode(True)
    return port


def _unopened(url: str, **options: Any) -> serial.Serial:
    if url.lower().startswith("rfc2217://"):  # pyserial supports no write timeout here
        remote = _Rfc2217Port(None, **options)
        remote.port = url
        return cast("serial.Serial", remote)
    port = serial.serial_for_url(url, do_not_open=True, **options)
    # 0, because `_write_all` has its own timeout.
    port.write_timeout = 0 if url.startswith("socket://") or _is_file(url) else _WRITE_TIMEOUT
    return port


def _open_when_free(port: serial.Serial, url: str, clock: Callable[[], float]) -> None:
    """Open a port. Wait while this program or the guardian of a dead program is closing it.

    Another line of this program, or that guardian, may still be confirming its last stop. Does not
    wait for other programs.
    """
    deadline = clock() + _CLOSING_S
    while True:
        try:
            port.open()
        except PORT_ERRORS as error:
            is_late = clock() >= deadline
            if is_late or _errno(error) not in _BUSY or is_locked_elsewhere(url):
                if fault := getattr(port, "fault", None):
                    raise fault from error
                raise
            time.sleep(_SLICE)
        else:
            return


def open_error(url: str, line: SerialFormat, error: Exception) -> PortUnavailable:
    number = _errno(error)
    is_forbidden = number in {errno.EACCES, errno.EPERM} and "://" not in url
    if is_forbidden and sys.platform != "win32":
        command, remedy = _permission_remedy(url)
        return PortUnavailable(tr(PortFault.FORBIDDEN.value).format(url, remedy), command=command)
    if "://" not in url and (number == errno.ENOENT or "FileNotFoundError" in str(error)):
        present = ", ".join(port.device for port in list_ports.comports())
        text = tr(PortFault.MISSING.value).format(url, present or tr("none"))
        return PortUnavailable(text, is_missing=True)
    return PortUnavailable(_open_error_text(url, line, error, number))


def _open_error_text(url: str, line: SerialFormat, error: Exception, number: int | None) -> str:
    if "://" in url:
        return tr(PortFault.UNREACHABLE.value).format(url, _plain(error))
    if number in {errno.EACCES, errno.EPERM}:
        return tr(PortFault.LOCKED.value).format(url)
    if number in _BUSY and is_left_to_guardian(url):
        return tr(PortFault.GUARDED.value).format(url)
    if number in _BUSY:
        return tr(PortFault.IN_USE.value).format(url, holder_of(url) or tr("another program"))
    if isinstance(error, ValueError) or number == errno.EINVAL:
        return tr(PortFault.NOT_SETTABLE.value).format(url, line.text(), _plain(error))
    return tr(PortFault.NOT_OPEN.value).format(url, _plain(error))


def _errno(error: Exception) -> int | None:
    """Return the system's error number, even if pyserial has wrapped the error."""
    cause: BaseException | None = error
    while cause is not None:
        number = getattr(cause, "errno", None)
        if isinstance(number, int):
            return number
        if cause.args and isinstance(cause.args[0], int):
            return cause.args[0]
        cause = cause.__cause__ or cause.__context__
    return None


def _plain(error: Exception) -> str:
    number = _errno(error)
    if number is not None and number > 0:
        with contextlib.suppress(ValueError):
            return os.strerror(number).lower()
    text = str(error).strip().rstrip(".")
    if "does not accept parameter change" in text:  # followed by a dump of pyserial's objects
        return tr("the server rejects the line settings")
    return text or type(error).__name__


def _permission_remedy(url: str) -> tuple[str, str]:
    """Return a command that grants access to a port, and a sentence for the user."""
    try:
        import grp  # noqa: PLC0415 - only on POSIX

        group = grp.getgrgid(Path(url).stat().st_gid).gr_name
    except (ImportError, KeyError, OSError):
        group = "dialout"
    until_unplugged = shlex.join(("sudo", "chmod", "a+rw", url))
    if group == "root":
        text = tr(
            "The port belongs to root. This command grants access until the port is unplugged: {0}"
        )
        return until_unplugged, text.format(until_unplugged)
    command = f"sudo usermod -aG {group} $USER"
    text = tr(
        "Join the group of the port with this command, then log out and log in again: "
        "{0} (or grant access until the port is unplugged: {1})."
    )
    return command, text.format(command, until_unplugged)
