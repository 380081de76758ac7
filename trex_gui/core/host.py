"""Ports, threads and clock of the computer."""

import threading
import time
from collections.abc import Callable
from dataclasses import dataclass

import click

from trex_gui.core.session import Condition
from trex_gui.core.transport.serial_port import SerialTransport, Transport
from trex_gui.core.transport.settings import PortSettings


def _start_thread(function: Callable[[], None]) -> Callable[[], None]:
    thread = threading.Thread(target=function, daemon=True)
    thread.start()
    return thread.join


OpenTransport = Callable[[PortSettings], Transport]


@dataclass(frozen=True, slots=True)
class Host:
    """Ports, threads and clock. A `Host` in click's `obj` replaces the default.

    Attributes:
        start_thread: runs a function in a thread, and returns a function that waits for its end.
        clock: clock of the transports.
        logged: wraps `open_transport` to write the traffic to a file. `None` without such a file.
    """

    open_transport: OpenTransport = SerialTransport
    condition: Callable[[], Condition] = threading.Condition
    start_thread: Callable[[Callable[[], None]], Callable[[], None]] = _start_thread
    clock: Callable[[], float] = time.monotonic
    logged: Callable[[OpenTransport], OpenTransport] | None = None


def host() -> Host:
    context = click.get_current_context(silent=True)
    return (context and context.find_object(Host)) or Host()
