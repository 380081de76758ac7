"""The ports that a board may be on, and the simulated one."""

from dataclasses import dataclass
from enum import Enum, auto

from PySide6.QtCore import QObject, QSettings, QTimer, Signal, Slot
from serial.tools import list_ports

_INTERVAL_MS = 1500
_REMEMBERED = "ports/typed"
_LAST = "ports/last"


class PortKind(Enum):
    """Where a port comes from."""

    SERIAL = auto()
    TYPED = auto()
    DEMO = auto()


@dataclass(frozen=True, slots=True)
class Port:
    """One entry of the list; `url` is what pyserial opens, empty for the simulated board."""

    kind: PortKind
    url: str
    label: str


class Ports(QObject):
    """A list that refreshes itself.

    Serial ports of this computer come first, then addresses that were typed in (pseudo
    terminals and network ports are in no list), then the simulated board.

    Signals:
        changed: the entries are others.
    """

    changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._settings = QSettings(self)
        self._typed = self._read_typed()
        self._entries: tuple[Port, ...] = ()
        self._timer = QTimer(self)
        self._timer.setInterval(_INTERVAL_MS)
        self._timer.timeout.connect(self.refresh)
        self.refresh()
        self._timer.start()

    @property
    def entries(self) -> tuple[Port, ...]:
        """Every port that can be connected to."""
        return self._entries

    @property
    def demo(self) -> Port:
        """The simulated board."""
        return self._entries[-1]

    @property
    def preferred(self) -> Port | None:
        """The port to offer first: the one used last, or the only serial one."""
        last = self._settings.value(_LAST, "")
        for port in self._entries:
            if port.url == last and port.url:
                return port
        serial = [port for port in self._entries if port.kind is PortKind.SERIAL]
        return serial[0] if len(serial) == 1 else None

    @Slot()
    def refresh(self) -> None:
        """Look again which ports there are."""
        entries = [
            Port(PortKind.SERIAL, port.device, _label(port.device, port.description))
            for port in sorted(list_ports.comports())
        ]
        present = {port.url for port in entries}
        entries += [Port(PortKind.TYPED, url, url) for url in self._typed if url not in present]
        entries.append(Port(PortKind.DEMO, "", self.tr("Demo TReX (no hardware)")))
        if tuple(entries) != self._entries:
            self._entries = tuple(entries)
            self.changed.emit()

    def add_typed(self, url: str) -> Port:
        """Remember an address that a person typed, and return its entry."""
        url = url.strip()
        if url not in self._typed and all(port.url != url for port in self._entries):
            self._typed = (*self._typed, url)[-8:]
            self._settings.setValue(_REMEMBERED, "\n".join(self._typed))
            self.refresh()
        return self.find(url) or Port(PortKind.TYPED, url, url)

    def find(self, url: str) -> Port | None:
        """Return the entry with this address, if there is one."""
        return next((port for port in self._entries if port.url == url and url), None)

    def note_used(self, port: Port) -> None:
        """Remember the port of a connection that worked."""
        self._settings.setValue(_LAST, port.url)

    def _read_typed(self) -> tuple[str, ...]:
        text = str(self._settings.value(_REMEMBERED, ""))
        return tuple(line for line in text.splitlines() if line)


def _label(device: str, description: str) -> str:
    if not description or description in {"n/a", device}:
        return device
    return f"{device}  ({description})"
