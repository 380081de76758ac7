"""Address and byte format of a serial port."""

from dataclasses import dataclass, field, replace
from enum import Enum

from trex_gui.core.timing import Timeouts
from trex_gui.core.translation import tr, tr_noop


class Parity(Enum):
    """Parity bit after the data bits. The value is pyserial's letter."""

    NONE = "N"
    EVEN = "E"
    ODD = "O"


_PARITIES = {
    Parity.NONE: "",
    Parity.EVEN: tr_noop("even parity"),
    Parity.ODD: tr_noop("odd parity"),
}


@dataclass(frozen=True, slots=True)
class SerialFormat:
    """Baud rate in bit/s, parity and stop bits (1 or 2). Eight data bits."""

    baud: int = 9600
    parity: Parity = Parity.NONE
    stop_bits: int = 1

    @property
    def bits_per_byte(self) -> int:
        """Bits per byte on the wire: start, eight data, parity, stop."""
        return 9 + (self.parity is not Parity.NONE) + self.stop_bits

    def seconds(self, size: int) -> float:
        return size * self.bits_per_byte / self.baud

    @property
    def short(self) -> str:
        """Baud rate and non-default settings, such as `57600 baud, even parity`."""
        stop_bits = tr("2 stop bits") if self.stop_bits == 2 else ""
        return ", ".join(
            filter(None, (tr("{0} baud").format(self.baud), self.detection_text, stop_bits))
        )

    @property
    def detection_text(self) -> str:
        """Error detection, such as `even parity`. Empty without parity."""
        return tr(_PARITIES[self.parity])

    def text(self) -> str:
        detection = self.detection_text or tr("no error detection")
        stop_bits = tr("1 stop bit") if self.stop_bits == 1 else tr("2 stop bits")
        return tr("{0} baud, {1}, {2}").format(self.baud, detection, stop_bits)


SHARED = " shared:"  # part of packed settings if devices of other kinds share the line


@dataclass(frozen=True, slots=True)
class PortSettings:
    """Port and its line settings.

    `url` is an address for pyserial: `/dev/ttyUSB0`, `COM3`, `socket://host:port`,
    `rfc2217://host:port`. `name` replaces the URL in texts for the user.
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

    @property
    def packed(self) -> str:
        """Settings of a found device as text, for later connections. Never empty."""
        return self.line.short

    def text(self) -> str:
        return tr("{0} at {1}").format(self.label, self.line.text())
