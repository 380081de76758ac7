"""Connecting to the last board by itself: at the start, and when its adapter is plugged in."""

from collections.abc import Callable, Collection
from functools import partial

from PySide6.QtCore import QObject, Slot

from trex_gui.core.transport.linux_ports import holder_of
from trex_gui.ui.devices.device_manager import DeviceManager
from trex_gui.ui.devices.ports import Port, Ports
from trex_gui.ui.files import in_background
from trex_gui.ui.preferences import Preferences

_KEY = "connection/automatic"


def connects_automatically() -> bool:
    return Preferences().flag(_KEY, default=False)


def set_automatic(enabled: bool) -> None:
    Preferences().set(_KEY, enabled)


class AutoConnect(QObject):
    """Connects once each time that the port used last appears, if the user wants that.

    Only that port is opened, with the adapter that it had, and not while another program has it.
    Nothing happens while a device is connected: a line that was lost is the session's. After
    *Disconnect* the port has to be plugged in again.
    """

    def __init__(
        self,
        ports: Ports,
        manager: DeviceManager,
        connect_to: Callable[[Port], object],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._ports = ports
        self._manager = manager
        self._connect_to = connect_to
        self._present: Collection[tuple[str, str]] = ()

    def start(self) -> None:
        """Count what is plugged in now as plugged in just now."""
        self._ports.changed.connect(self._on_ports_changed)
        self._on_ports_changed()

    @Slot()
    def _on_ports_changed(self) -> None:
        before, self._present = self._present, set(map(_plugged, self._ports.entries))
        last = self._ports.last_used
        if last is not None and _plugged(last) not in before and connects_automatically():
            in_background(
                self, partial(holder_of, last.url), partial(self._connect, last), lambda _: None
            )

    def _connect(self, port: Port, holder: str | None) -> None:
        if holder is None and self._manager.is_idle and port == self._ports.last_used:
            self._connect_to(port)


def _plugged(port: Port) -> tuple[str, str]:
    """What changes when another adapter gets the same address, or a typed address its adapter."""
    return port.url, port.adapter
