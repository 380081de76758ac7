"""Settings of a serial port: which port, and how bytes travel on it."""

from dataclasses import dataclass, field, replace
from enum import Enum

from trex_gui.core.timing import Timeouts


class Parity(Enum):
    """Parity bit behind the data bits; the value is pyserial's letter for it."""

    NONE = "N"
    EVEN = "E"
    ODD = "O"


@dataclass(frozen=True, slots=True)
class SerialFormat:
    """Baud rate in bit/s, parity and stop bits (1 or 2); eight data bits."""

    baud: int = 9600
    parity: Parity = Parity.NONE
    stop_bits: int = 1

    @property
    def bits_per_byte(self) -> int:
        """Bits that one byte takes on the wire: start, eight data, parity, stop."""
        return 9 + (self.parity is not Parity.NONE) + self.stop_bits

    def seconds(self, size: int, baud: int | None = None) -> float:
        return size * self.bits_per_byte / (baud or self.baud)

    @property
    def short(self) -> str:
        """The format as terminal programs write it: `57600 8E1`."""
        return f"{self.baud} 8{self.parity.value}{self.stop_bits}"

    @property
    def check_text(self) -> str:
        """How errors are detected: `no parity`, `even parity`."""
        return f"{'no' if self.parity is Parity.NONE else self.parity.name.lower()} parity"

    def text(self) -> str:
        stop = "1 stop bit" if self.stop_bits == 1 else "2 stop bits"
        return f"{self.baud} baud, {self.check_text}, {stop}"


@dataclass(frozen=True, slots=True)
class PortSettings:
    """Everything needed to open a port.

    `url` is whatever pyserial opens: `/dev/ttyUSB0`, `COM3`, `socket://host:port`,
    `rfc2217://host:port`; `name` is what the user calls it, if not the URL.
    """

    url: str
    line: SerialFormat = field(default_factory=SerialFormat)
    name: str = field(default="", kw_only=True)
    timeouts: Timeouts = field(default_factory=Timeouts, kw_only=True)

    def at(self, line: SerialFormat) -> "PortSettings":
        return replace(self, line=line)

    @property
    def label(self) -> str:
        return self.name or self.url

    @property
    def short(self) -> str:
        return self.line.short

    def text(self) -> str:
        return f"{self.label} at {self.line.text()}"
