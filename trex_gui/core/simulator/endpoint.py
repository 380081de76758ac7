"""Where a host plugs in: what every kind of connection offers, and the plain TCP one."""

import contextlib
import socket
import sys
from collections.abc import Collection, Iterable
from dataclasses import dataclass
from typing import Protocol

from trex_gui.core.errors import StudioError

CHUNK = 256
"""Bytes taken at a time, so that a host that changes its baud rate is noticed soon."""


class EndpointError(StudioError):
    """The place where a host would plug in cannot be made; says which and why."""


@dataclass(frozen=True, slots=True)
class HostSettings:
    """What the host has set its port to; `parity` (none, even, odd) is `None` if invisible."""

    baud: int
    stop_bits: int
    parity: str | None = None


Arrival = tuple[HostSettings | None, bytes]
"""Bytes from the host, and how its port was set then, where that can be seen."""


class Endpoint(Protocol):
    """A connection that a host can open, and open again after it has left.

    Attributes:
        hosts_left: how many hosts have left, where that can be seen.
    """

    hosts_left: int

    @property
    def url(self) -> str:
        """What pyserial opens."""

    def waiting_for(self) -> list[int]:
        """Return the file descriptors that become readable when there is something to do."""

    def take(self, ready: Collection[int]) -> Iterable[Arrival]:
        """Do what there is to do at these descriptors."""

    def write(self, data: bytes) -> None:
        """Give bytes to the host; they are lost when there is none, or when it does not read."""

    def unplug(self) -> None:
        """Break the connection so that the host notices."""

    def plug(self) -> None:
        """Offer a connection again; an `EndpointError` when that fails."""

    def close(self) -> None:
        """End, and leave nothing behind."""


class TcpEndpoint:
    """Raw bytes over TCP; serves one host at a time, the next one when it has left."""

    scheme = "socket"

    def __init__(self, host: str, port: int) -> None:
        self._host = host
        self._port = port
        self._listener: socket.socket | None = None
        self._client: socket.socket | None = None
        self.hosts_left = 0
        self.plug()

    @property
    def url(self) -> str:
        """What pyserial opens."""
        host = f"[{self._host}]" if ":" in self._host else self._host
        return f"{self.scheme}://{host}:{self._port}"

    def waiting_for(self) -> list[int]:
        """Wait for the host, or for one to come."""
        end = self._client or self._listener
        return [end.fileno()] if end is not None else []

    def take(self, ready: Collection[int]) -> Iterable[Arrival]:
        """Let a host in, or take what it sends."""
        if self._client is None:
            if self._listener is not None and self._listener.fileno() in ready:
                self._accept(self._listener)
        elif self._client.fileno() in ready:
            data = self._receive(self._client)
            if data:
                return self.arrivals(data)
            self.drop_client()
        return ()

    def write(self, data: bytes) -> None:
        """Give bytes to the host, if there is one."""
        if self._client is None:
            return
        try:
            self._client.sendall(data)
        except BlockingIOError:
            return  # it does not read: lost, as in a UART
        except OSError:
            self.drop_client()

    def unplug(self) -> None:
        """Hang up and refuse new calls."""
        self.drop_client()
        if self._listener is not None:
            self._listener.close()
            self._listener = None

    def plug(self) -> None:
        """Listen again, on the same port."""
        if self._listener is not None:
            return
        try:
            family = socket.getaddrinfo(self._host, self._port, type=socket.SOCK_STREAM)[0][0]
            self._listener = socket.create_server((self._host, self._port), family=family)
        except (OSError, OverflowError) as error:
            message = f"cannot listen on {self._host}:{self._port}: {error}"
            raise EndpointError(message) from error
        self._listener.setblocking(False)
        self._port = self._listener.getsockname()[1]

    def close(self) -> None:
        """Hang up for good."""
        self.unplug()

    def welcome(self) -> None:
        """Greet a host that has just come."""

    def arrivals(self, data: bytes) -> Iterable[Arrival]:
        """Return what received bytes mean; here, just that."""
        return [(None, data)]

    def drop_client(self) -> None:
        """Hang up on the host, if there is one."""
        if self._client is not None:
            self._client.close()
            self._client = None
            self.hosts_left += 1

    def _accept(self, listener: socket.socket) -> None:
        with contextlib.suppress(OSError):  # it may have gone again
            self._client, _ = listener.accept()
            self._client.setblocking(False)
            self._client.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            self.welcome()

    @staticmethod
    def _receive(client: socket.socket) -> bytes | None:
        try:
            return client.recv(CHUNK)
        except OSError:
            return None


def default_endpoint_is_tcp() -> bool:
    """Whether this system has no pseudo-terminals."""
    return sys.platform == "win32"
