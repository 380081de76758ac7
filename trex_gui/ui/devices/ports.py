"""List of serial ports, typed addresses and simulated devices."""

import os
from collections.abc import Sequence
from dataclasses import astuple, dataclass, field, replace
from enum import Enum, auto
from pathlib import Path

from PySide6.QtCore import QObject, Signal, Slot
from serial.tools import list_ports

from trex_gui.core.plugin import DevicePlugin
from trex_gui.core.translation import tr
from trex_gui.core.transport.adapters import Adapter
from trex_gui.ui.preferences import Preferences
from trex_gui.ui.runtime import new_timer

_INTERVAL_MS = 1500
_MAX_TYPED = 8
_MAX_KNOWN = 20  # maximum number of saved ports and adapters
_TYPED = "ports/typed"
_KNOWN = "ports/known"


class PortKind(Enum):
    SERIAL = auto()
    TYPED = auto()
    DEMO = auto()


@dataclass(frozen=True, slots=True)
class Port:
    """Entry of the port list."""

    kind: PortKind
    url: str  # for pyserial; empty for a simulated device
    label: str
    device: str  # key of the kind of device at the port
    adapter: Adapter | None = None
    settings: str = field(default="", compare=False)  # packed settings of the device found there

    def is_same(self, other: "Port") -> bool:
        """Return whether both entries refer to one port. Their names or devices may differ."""
        if self.adapter is not None and other.adapter is not None:
            return self.adapter.is_same(other.adapter)
        if PortKind.DEMO in {self.kind, other.kind}:
            return (self.kind, self.device) == (other.kind, other.device)
        return (self.url, self.adapter) == (other.url, other.adapter)


class Ports(QObject):
    """List of ports that refreshes itself.

    Order: serial ports of this computer, typed addresses, boards served over the network, and a
    simulated device of each kind. The user types the addresses of pseudo-terminals and network
    ports, because operating systems do not list them. By default, a port is assigned to the first
    kind of device. A kind that was found or selected is saved with the adapter and the settings.
    """

    changed = Signal()  # `entries` has changed

    def __init__(self, plugins: Sequence[DevicePlugin]) -> None:
        super().__init__()
        self.plugins = tuple(plugins)
        self._store = Preferences()
        self._typed = tuple(self._store.text(_TYPED).splitlines()[-_MAX_TYPED:])
        lines = map(_read, self._store.text(_KNOWN).split("\n")[-_MAX_KNOWN:])
        kinds = {plugin.key for plugin in self.plugins}
        # Ports that were used or selected, newest last.
        self._known = [port for port in lines if port is not None and port.device in kinds]
        self._served: dict[str, str] = {}  # URL → label of a board on the network
        self.entries: tuple[Port, ...] = ()
        self._timer = new_timer(self, _INTERVAL_MS, self.refresh)
        self.refresh()
        self._timer.start()

    def demo_of(self, device: str) -> Port:
        return next(
            port for port in self.entries if port.kind is PortKind.DEMO and port.device == device
        )

    @property
    def preferred(self) -> Port | None:
        """Last used port. Otherwise the only USB adapter, or else the only serial port."""
        serial = [port for port in self.entries if port.kind is PortKind.SERIAL]
        adapters = [port for port in serial if port.adapter is not None]
        only = next((ports[0] for ports in (adapters, serial) if len(ports) == 1), None)
        return self.last_used or only

    @property
    def last_used(self) -> Port | None:
        """Port at which a device was last found. `None` if it is not listed."""
        newest = next((known for known in reversed(self._known) if known.settings), None)
        return self.current_entry(newest) if newest is not None else None

    def current_entry(self, port: Port) -> Port | None:
        """Return the current entry of a port, or `None` if the port is missing.

        The port may have another name now. If several adapters share a serial number, return the
        entry of the adapter in the same USB socket as before.
        """
        entries = [entry for entry in self.entries if entry.is_same(port)]
        if len(entries) > 1:
            entries = [entry for entry in entries if entry.adapter == port.adapter]
        return entries[0] if len(entries) == 1 else None

    @Slot()
    def refresh(self) -> None:
        entries = [
            self._entry(
                PortKind.SERIAL,
                port.device,
                _label(port.device, port.description),
                Adapter.of(port),
            )
            for port in sorted(sorted(list_ports.comports()), key=lambda port: not port.vid)
        ]
        for url, label in (*((url, url) for url in self._typed), *self._served.items()):
            if all(port.url != url for port in entries):
                entries.append(self._entry(PortKind.TYPED, url, label))
        for plugin in self.plugins:
            label = tr("Demo {0} (no hardware)").format(plugin.name)
            entries.append(Port(PortKind.DEMO, "", label, plugin.key))
        before, self.entries = self.entries, tuple(entries)
        if self.entries != before:
            self.changed.emit()

    def add_typed(self, url: str) -> Port:
        """Save a typed address, and return its entry.

        For a symbolic link to a listed port, return that port and save nothing.
        """
        url = url.strip()
        linked = self.find(os.path.realpath(url)) if Path(url).is_symlink() else None
        if linked is not None and linked.kind is PortKind.SERIAL:
            return linked
        if url not in self._typed and all(port.url != url for port in self.entries):
            self._typed = (*self._typed, url)[-_MAX_TYPED:]
            self._store.set(_TYPED, "\n".join(self._typed))
            self.refresh()
        return self.find(url) or self._entry(PortKind.TYPED, url, url)

    def set_served(self, labels: dict[str, str]) -> None:
        """Set the boards that other computers serve. `labels`: URL → label."""
        self._served = labels
        self.refresh()

    def assign(self, port: Port, device: str, settings: str = "") -> Port:
        """Assign a port to a kind of device, and save the assignment. Return the port's new entry.

        `settings`: packed settings of the found device. Empty if the user only selected the kind.
        """
        known = replace(port, device=device, settings=settings)
        is_new = bool(settings) or device != port.device
        if port.kind is PortKind.DEMO or not is_new or self._lines[-1:] == [_line(known)]:
            return self.current_entry(port) or port
        others = [other for other in self._known if not other.is_same(port)]
        self._known = [*others, known][-_MAX_KNOWN:]
        self._store.set(_KNOWN, "\n".join(self._lines))
        self.refresh()
        entry = self.current_entry(port)
        return entry or self._entry(port.kind, port.url, port.url, port.adapter)

    @property
    def _lines(self) -> list[str]:
        return list(map(_line, self._known))

    def _entry(self, kind: PortKind, url: str, label: str, adapter: Adapter | None = None) -> Port:
        port = Port(kind, url, label, self.plugins[0].key, adapter)
        known = next((known for known in self._known if known.is_same(port)), None)
        if known is None:
            return port
        if known.device != port.device:
            name = next(plugin.name for plugin in self.plugins if plugin.key == known.device)
            label = tr("{0}: {1}").format(name, label)
        return replace(port, device=known.device, label=label, settings=known.settings)

    def find(self, url: str) -> Port | None:
        return next((port for port in self.entries if port.url == url and url), None)


def _label(device: str, description: str) -> str:
    if not description or description in {"n/a", device}:
        return device
    return f"{device}  ({description})"


def _line(port: Port) -> str:
    """Return a port as a line for `_read`."""
    adapter = () if port.adapter is None else astuple(port.adapter)
    words = (port.device, port.settings, port.url, *adapter)
    return "\t".join(" ".join(word.split()) for word in words)


def _read(line: str) -> Port | None:
    """Parse a saved line. Return `None` if the line is invalid."""
    match line.split("\t"):
        case [device, settings, url]:
            return Port(PortKind.TYPED, url, url, device, None, settings)
        case [device, settings, url, product, number, location]:
            adapter = Adapter(product, number, location)
            return Port(PortKind.SERIAL, url, url, device, adapter, settings)
    return None
