"""Message bus with a simulated logind that grants sleep delays."""

import itertools
import os
import select
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager

from PySide6.QtCore import ClassInfo, QObject, Slot
from PySide6.QtDBus import QDBusConnection, QDBusMessage, QDBusUnixFileDescriptor

PATH = "/org/freedesktop/login1"
MANAGER = "org.freedesktop.login1.Manager"

_names = itertools.count(1)


@contextmanager
def message_bus() -> Iterator[tuple[str, QDBusConnection]]:
    """Run a bus. Yield its address and a connection to it."""
    with subprocess.Popen(
        ["dbus-daemon", "--session", "--print-address", "--nofork", "--nopidfile"],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
    ) as daemon:
        assert daemon.stdout is not None
        try:
            address = daemon.stdout.readline().strip()
            with connection_to(address) as connection:
                yield address, connection
        finally:
            daemon.terminate()


@contextmanager
def connection_to(address: str) -> Iterator[QDBusConnection]:
    """Open another connection to a bus."""
    name = f"bus{next(_names)}"
    try:
        yield QDBusConnection.connectToBus(address, name)
    finally:
        QDBusConnection.disconnectFromBus(name)


# PySide's stub does not declare ClassInfo as a decorator.
@ClassInfo({"D-Bus Interface": MANAGER})  # type: ignore[call-arg]
class Logind(QObject):  # type: ignore[operator]
    """Grants sleep delays and records their release.

    Attributes:
        requested: what, who, why and mode of each request.
    """

    def __init__(self, connection: QDBusConnection) -> None:
        super().__init__()
        self.requested: list[tuple[str, str, str, str]] = []
        self._ends: list[int] = []
        self._connection = connection
        assert connection.registerService("org.freedesktop.login1")
        assert connection.registerObject(PATH, self, QDBusConnection.RegisterOption.ExportAllSlots)

    @Slot(str, str, str, str, result=QDBusUnixFileDescriptor)
    def Inhibit(self, what: str, who: str, why: str, mode: str) -> QDBusUnixFileDescriptor:  # noqa: N802 - name of the D-Bus method
        self.requested.append((what, who, why, mode))
        own_end, other_end = os.pipe()
        self._ends.append(own_end)
        descriptor = QDBusUnixFileDescriptor(other_end)
        os.close(other_end)
        return descriptor

    @property
    def held(self) -> int:
        """Number of delays that are not released."""
        return len(self._ends) - len(select.select(self._ends, [], [], 0)[0])

    def announce_sleep(self, *, begins: bool) -> None:
        """Broadcast that the computer is about to sleep, or has woken up."""
        message = QDBusMessage.createSignal(PATH, MANAGER, "PrepareForSleep")
        message.setArguments([begins])
        assert self._connection.send(message)

    def close(self) -> None:
        """Unregister the object and close the pipes."""
        self._connection.unregisterObject(PATH)
        for end in self._ends:
            os.close(end)
