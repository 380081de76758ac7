"""Pseudo-terminal as the host's serial port (Linux, macOS)."""

import contextlib
import errno
import os
import sys
import termios
import tty
from collections.abc import Collection, Iterable
from pathlib import Path

from trex_gui.core.simulator.endpoint import CHUNK, Arrival, EndpointError, HostSettings
from trex_gui.core.transport.linux_ports import CFLAG, OSPEED, termios2

_RATES = {
    getattr(termios, name): int(name[1:])
    for name in dir(termios)
    if name[:1] == "B" and name[1:].isdigit()
}


class PtyEndpoint:
    """Pseudo-terminal, with an optional symbolic link to it.

    The slave end stays open, so that hosts can connect again. The host's baud rate and stop bits
    are known. Its parity is unknown, because pseudo-terminals do not keep the parity.
    """

    def __init__(self, link: Path | None, baud: int) -> None:
        self._link = link
        self._baud = baud
        self._master: int | None = None
        self._slave: int | None = None
        self._path = ""
        self.disconnections = 0
        self.plug()

    @property
    def url(self) -> str:
        return str(self._link) if self._link is not None else self._path

    def descriptors(self) -> list[int]:
        return [self._master] if self._master is not None else []

    def receive(self, ready: Collection[int]) -> Iterable[Arrival]:
        if self._master is None or self._slave is None or self._master not in ready:
            return
        try:
            data = os.read(self._master, CHUNK)
        except BlockingIOError:
            return
        yield _settings(self._slave), data

    def write(self, data: bytes) -> None:
        if self._master is not None:
            with contextlib.suppress(BlockingIOError):
                os.write(self._master, data)

    def unplug(self) -> None:
        for end in (self._slave, self._master):
            if end is not None:
                os.close(end)
        self._master = self._slave = None
        self.disconnections += 1
        if self._link is not None:
            with contextlib.suppress(OSError):
                if str(self._link.readlink()) == self._path:
                    self._link.unlink()

    def plug(self) -> None:
        if self._master is not None:
            return
        try:
            self._master, self._slave = os.openpty()
        except OSError as error:
            raise EndpointError(f"no pseudo-terminal is available: {error}") from error
        os.set_blocking(self._master, False)
        tty.setraw(self._slave)
        _set_speed(self._slave, self._baud)
        self._path = os.ttyname(self._slave)
        try:
            self._create_link()
        except OSError as error:
            self.unplug()
            raise EndpointError(f"cannot create the link {self._link}: {error.strerror}") from error

    def _create_link(self) -> None:
        if self._link is None:
            return
        if self._link.exists() and not self._link.is_symlink():
            raise FileExistsError(errno.EEXIST, "a file with this name already exists")
        new_link = self._link.with_name(f".{self._link.name}.{os.getpid()}")
        new_link.unlink(missing_ok=True)
        new_link.symlink_to(self._path)
        new_link.replace(self._link)  # atomic


def _set_speed(terminal: int, baud: int) -> None:
    """Set the baud rate for hosts such as `cat`, which do not set it. Ignores unusual rates."""
    codes = {rate: code for code, rate in _RATES.items()}
    if baud in codes:
        settings = termios.tcgetattr(terminal)
        settings[4] = settings[5] = codes[baud]
        termios.tcsetattr(terminal, termios.TCSANOW, settings)


def _settings(terminal: int) -> HostSettings | None:
    try:
        if sys.platform == "linux":
            with contextlib.suppress(OSError):  # some processors use another request number
                words = termios2(terminal)
                return _host_settings(words[OSPEED], words[CFLAG])
        attributes = termios.tcgetattr(terminal)
    except termios.error:
        return None
    return _host_settings(_RATES.get(attributes[5], 0), attributes[2])


def _host_settings(baud: int, flags: int) -> HostSettings | None:
    if baud <= 0:
        return None
    return HostSettings(baud, 2 if flags & termios.CSTOPB else 1)
