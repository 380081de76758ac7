import os
import time
from collections.abc import Callable, Iterator

import pytest

from trex_gui.core.transport.serial_port import SerialTransport
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import LineSettings

Open = Callable[..., SerialTransport]


@pytest.fixture
def terminal() -> Iterator[tuple[int, str]]:
    """Return the master end of a pseudo-terminal, and the path of the slave."""
    master, slave = os.openpty()
    yield master, os.ttyname(slave)
    for end in (master, slave):
        os.close(end)


@pytest.fixture
def opened() -> Iterator[Open]:
    """Open ports that are closed with the test."""
    transports: list[SerialTransport] = []

    def open_port(
        url: str, line: LineSettings | None = None, clock: Callable[[], float] = time.monotonic
    ) -> SerialTransport:
        settings = ConnectionSettings(url, line or LineSettings())
        transports.append(SerialTransport(settings, clock))
        return transports[-1]

    yield open_port
    for transport in transports:
        transport.close()
