"""How to reach one board: which port, how bytes travel on it, how packets are wrapped."""

from dataclasses import dataclass, field, replace

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import tr
from trex_gui.core.transport.settings import PortSettings, SerialFormat
from trex_gui.devices.trex.protocol.framing import (
    DEFAULT_POLYNOMIAL,
    Framing,
    check_polynomial,
)
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings, baud_rates


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

    @property
    def packed(self) -> str:
        number = -1 if self.device_number is None else self.device_number
        line = self.line
        return f"{line.baud} {line.detection.name} {line.stop_bits} {number} {self.polynomial:02X}"

    def unpacked(self, text: str) -> "ConnectionSettings":
        """Return these settings with what `packed` has returned; BadRequest for another text."""
        try:
            baud, detection, stop_bits, number, polynomial = text.split(" ")
            line = LineSettings(int(baud), Detection[detection], int(stop_bits))
            is_possible = line.baud in baud_rates() and line.stop_bits in {1, 2}
            settings = replace(
                self,
                line=line,
                device_number=None if int(number) == -1 else int(number),
                polynomial=check_polynomial(int(polynomial, 16)),
            )
            _ = settings.framing
        except (KeyError, ValueError) as error:
            raise BadRequest(tr("{0!r} are no settings of a board").format(text)) from error
        if not is_possible:
            raise BadRequest(tr("{0!r} are no settings of a board").format(text))
        return settings

    def at(self, line: SerialFormat) -> PortSettings:
        """Return these settings with another line; without addressing if no board can have it."""
        if isinstance(line, LineSettings):
            return replace(self, line=line)
        return PortSettings(self.url, line, name=self.name, timeouts=self.timeouts)

    @property
    def framing(self) -> Framing:
        return Framing(self.device_number, self.polynomial if self.line.has_crc else None)
