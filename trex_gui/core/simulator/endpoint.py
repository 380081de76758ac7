"""Interface of the endpoints to which a host connects, and the endpoint for raw TCP."""

import contextlib
import socket
from collections.abc import Collection, Iterable
from dataclasses import dataclass
from typing import Protocol

from trex_gui.core.errors import StudioError
from trex_gui.core.transport.settings import Parity

CHUNK = 256  # bytes per read; small, so that a change of the baud rate is detected soon


class EndpointError(StudioError):
    """Failure to open an endpoint."""


@dataclass(frozen=True, slots=True)
class HostSettings:
    """Settings of the host's port. `parity`: `None` if unknown."""

    baud: int
    stop_bits: int
    parity: Parity | None = None


Arrival = tuple[HostSettings | None, bytes]
"""Settings of the host's port (`None` if unknown), and bytes received from the host."""


class Endpoint(Protocol):
    """Connection that a host can open repeatedly.

    Attributes:
        disconnections: number of times that a host has disconnected.
        url: address for pyserial.
    """

    disconnections: int

    @property
    def url(self) -> str: ...

    def descriptors(self) -> list[int]:
        """Return the file descriptors for `select`."""

    def receive(self, ready: Collection[int]) -> Iterable[Arrival]:
        """Read from the `ready` descriptors. Return the received bytes."""

    def write(self, data: bytes) -> None:
        """Send bytes to the host. They are lost if the host does not read them."""

    def unplug(self) -> None:
        """Break the connection in a way that the host notices."""

    def plug(self) -> None:
        """Restore the connection. Raises EndpointError."""


class TcpEndpoint:
    scheme = "socket"

    def __init__(self, host: str, port: int) -> None:
        self._host = host
        self._port = port
        self._listener: socket.socket | None = None
        self._client: socket.socket | None = None
        self.disconnections = 0
        self.plug()

    @property
    def url(self) -> str:
        host = f"[{self._host}]" if ":" in self._host else self._host
        return f"{self.scheme}://{host}:{self._port}"

    def descriptors(self) -> list[int]:
        current = self._client or self._listener
        return [current.fileno()] if current is not None else []

    def receive(self, ready: Collection[int]) -> Iterable[Arrival]:
        if self._client is None:
            if self._listener is not None and self._listener.fileno() in ready:
                self._accept(self._listener)
        elif self._client.fileno() in ready:
            with contextlib.suppress(OSError):
                if data := self._client.recv(CHUNK):
                    return self.arrivals(data)
            self.drop_client()
        return ()

    def write(self, data: bytes) -> None:
        if self._client is None:
            return
        try:
            self._client.sendall(data)
        except BlockingIOError:
            return  # the host does not read, and the bytes are lost, as in a UART
        except OSError:
            self.drop_client()

    def unplug(self) -> None:
        self.drop_client()
        if self._listener is not None:
            self._listener.close()
            self._listener = None

    def plug(self) -> None:
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

    def on_connected(self) -> None:
        """Prepare for a host that has just connected."""

    def arrivals(self, data: bytes) -> Iterable[Arrival]:
        return [(None, data)]

    def drop_client(self) -> None:
        if self._client is not None:
            self._client.close()
            self._client = None
            self.disconnections += 1

    def _accept(self, listener: socket.socket) -> None:
        with contextlib.suppress(OSError):  # the client may have disconnected
            self._client, _ = listener.accept()
            self._client.setblocking(False)
            self._client.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            self.on_connected()
