"""How to reach one board: which port, how bytes travel on it, how packets are wrapped."""

from dataclasses import dataclass, field

from trex_gui.core.timing import Timeouts
from trex_gui.devices.trex.protocol.crc7 import DEFAULT_POLYNOMIAL
from trex_gui.devices.trex.protocol.framing import Framing
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings


@dataclass(frozen=True, slots=True)
class LinkSettings:
    """Everything that has to be known before the first byte.

    Attributes:
        url: whatever pyserial opens: `/dev/ttyUSB0`, `COM3`, `socket://host:port`,
            `rfc2217://host:port`.
        line: baud rate, error detection and stop bits; the default is the factory's.
        device_number: 0-127 for the Pololu protocol, `None` for the compact one.
        polynomial: used when `line.detection` is CRC-7.
        name: what a person calls the port; the URL where it is empty.
        timeouts: how long to wait for it.
    """

    url: str
    line: LineSettings = field(default_factory=LineSettings)
    device_number: int | None = None
    polynomial: int = DEFAULT_POLYNOMIAL
    timeouts: Timeouts = field(default_factory=Timeouts)
    name: str = ""

    @property
    def framing(self) -> Framing:
        """How packets are wrapped under these settings."""
        crc = self.line.detection is Detection.CRC7
        return Framing(self.device_number, self.polynomial if crc else None)

    @property
    def short(self) -> str:
        """How the line is set, as terminal programs write it: `57600 8E1`, `57600 8N1 CRC`."""
        parity = {Detection.EVEN: "E", Detection.ODD: "O"}.get(self.line.detection, "N")
        crc = " CRC" if self.line.detection is Detection.CRC7 else ""
        return f"{self.line.baud} 8{parity}{self.line.stop_bits}{crc}"

    def text(self) -> str:
        """Short text for people: port and line."""
        return f"{self.name or self.url} at {self.line.text()}"
