"""How to reach one board: which port, how bytes travel on it, how packets are wrapped."""

from dataclasses import dataclass, field, replace

from trex_gui.core.transport.settings import PortSettings, SerialFormat
from trex_gui.devices.trex.protocol.framing import DEFAULT_POLYNOMIAL, Framing
from trex_gui.devices.trex.protocol.line_settings import LineSettings


@dataclass(frozen=True, slots=True)
class ConnectionSettings(PortSettings):
    """A port and the addressing of a board on it.

    `device_number` is 0-127 for the Pololu protocol, `None` for the compact one.
    """

    line: LineSettings = field(default_factory=LineSettings)
    device_number: int | None = None
    polynomial: int = DEFAULT_POLYNOMIAL

    @classmethod
    def on(cls, port: PortSettings) -> "ConnectionSettings":
        """Return the default settings of a board on a port; keeps those of a board."""
        if isinstance(port, ConnectionSettings):
            return port
        return cls(port.url, name=port.name, timeouts=port.timeouts)

    def at(self, line: SerialFormat) -> PortSettings:
        """Return these settings with another line; without addressing if no board can have it."""
        if isinstance(line, LineSettings):
            return replace(self, line=line)
        return PortSettings(self.url, line, name=self.name, timeouts=self.timeouts)

    @property
    def framing(self) -> Framing:
        return Framing(self.device_number, self.polynomial if self.line.has_crc else None)
