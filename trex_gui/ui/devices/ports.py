"""Serial ports, typed addresses and simulated devices to connect to."""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum, auto

from PySide6.QtCore import QObject, Signal, Slot
from serial.tools import list_ports

from trex_gui.core.plugin import DevicePlugin
from trex_gui.ui.preferences import Preferences
from trex_gui.ui.runtime import new_timer

_INTERVAL_MS = 1500
_MOST_TYPED = 8
_MANY = 20  # ports remembered to lead to another kind than the first
_REMEMBERED = "ports/typed"
_LAST = "ports/last"
_LAST_ADAPTER = "ports/last_adapter"
_LEADS_TO = "ports/kinds"


class PortKind(Enum):
    SERIAL = auto()
    TYPED = auto()
    DEMO = auto()


@dataclass(frozen=True, slots=True)
class Port:
    """One entry of the list; `url` is what pyserial opens, empty for a simulated device.

    `device` is the key of the kind of device that it leads to. `adapter` tells adapters apart: its
    maker, product and number as far as the system knows them.
    """

    kind: PortKind
    url: str
    label: str
    device: str
    adapter: str = ""


class Ports(QObject):
    """A list that refreshes itself.

    Serial ports of this computer come first, then typed addresses (pseudo-terminals and network
    ports are in no list), then a simulated device of each kind. A port leads to the first kind
    unless another one was found there, or chosen.
    """

    changed = Signal()  # `entries`

    def __init__(self, plugins: Sequence[DevicePlugin], parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.plugins = tuple(plugins)
        self._store = Preferences()
        self._typed = tuple(self._store.text(_REMEMBERED).splitlines()[-_MOST_TYPED:])
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
        """The port to offer first: the one used last, the only USB adapter or the only port."""
        serial = [port for port in self.entries if port.kind is PortKind.SERIAL]
        adapters = [port for port in serial if port.adapter]
        last = self.find(self._store.text(_LAST))
        only = next((ports[0] for ports in (adapters, serial) if len(ports) == 1), None)
        return last or only

    @property
    def last_used(self) -> Port | None:
        """The port that was used last, while it is there with the same adapter."""
        port = self.find(self._store.text(_LAST))
        is_same = port is not None and port.adapter == self._store.text(_LAST_ADAPTER)
        return port if is_same else None

    @Slot()
    def refresh(self) -> None:
        entries = [
            self._entry(
                PortKind.SERIAL,
                port.device,
                _label(port.device, port.description),
                " ".join(str(part) for part in (port.vid, port.pid, port.serial_number) if part),
            )
            for port in sorted(sorted(list_ports.comports()), key=lambda port: not port.vid)
        ]
        present = {port.url for port in entries}
        entries += [
            self._entry(PortKind.TYPED, url, url) for url in self._typed if url not in present
        ]
        for plugin in self.plugins:
            label = self.tr("Demo {0} (no hardware)").format(plugin.name)
            entries.append(Port(PortKind.DEMO, "", label, plugin.key))
        if tuple(entries) != self.entries:
            self.entries = tuple(entries)
            self.changed.emit()

    def add_typed(self, url: str) -> Port:
        """Remember an address that the user typed; return its entry."""
        url = url.strip()
        if url not in self._typed and all(port.url != url for port in self.entries):
            self._typed = (*self._typed, url)[-_MOST_TYPED:]
            self._store.set(_REMEMBERED, "\n".join(self._typed))
            self.refresh()
        return self.find(url) or self._entry(PortKind.TYPED, url, url)

    def lead_to(self, port: Port, device: str) -> Port:
        """Remember which kind of device a port leads to; return its entry."""
        if port.kind is PortKind.DEMO or device == port.device:
            return port
        known = {url: key for url, key in self._known_kinds().items() if url != port.url}
        if device != self.plugins[0].key:
            known[port.url] = device
        lines = [f"{key} {url}" for url, key in known.items()]
        self._store.set(_LEADS_TO, "\n".join(lines[-_MANY:]))
        self.refresh()
        return self.find(port.url) or self._entry(port.kind, port.url, port.url)

    def _known_kinds(self) -> dict[str, str]:
        lines = self._store.text(_LEADS_TO).splitlines()
        words = [line.split(" ", 1) for line in lines if " " in line]
        keys = {plugin.key for plugin in self.plugins}
        return {url: key for key, url in words if key in keys}

    def _entry(self, kind: PortKind, url: str, label: str, adapter: str = "") -> Port:
        device = self._known_kinds().get(url, self.plugins[0].key)
        if device != self.plugins[0].key:
            name = next(plugin.name for plugin in self.plugins if plugin.key == device)
            label = self.tr("{0}: {1}").format(name, label)
        return Port(kind, url, label, device, adapter)

    def find(self, url: str) -> Port | None:
        return next((port for port in self.entries if port.url == url and url), None)

    def note_used(self, port: Port) -> None:
        """Remember the port of a connection that worked; a simulated device is none."""
        if port.url:
            self._store.set(_LAST, port.url)
            self._store.set(_LAST_ADAPTER, port.adapter)


def _label(device: str, description: str) -> str:
    if not description or description in {"n/a", device}:
        return device
    return f"{device}  ({description})"
