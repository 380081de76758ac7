"""Settings of a connection: port, line and framing."""

from collections.abc import Iterable
from dataclasses import dataclass, field, replace

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import tr
from trex_gui.core.transport.settings import SHARED, PortSettings, SerialFormat
from trex_gui.devices.trex.protocol.flags import seven_bits
from trex_gui.devices.trex.protocol.framing import DEFAULT_POLYNOMIAL, Framing, check_polynomial
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings

FACTORY_NUMBER = 7


def numbers_in(text: str) -> frozenset[int]:
    """Parse device numbers such as `0,1`. Raise ValueError for any other text."""
    words = text.replace(",", " ").split()
    return frozenset(seven_bits(int(word), tr("device number")) for word in words)


@dataclass(frozen=True, slots=True)
class ConnectionSettings(PortSettings):
    """Port, line and address of a board.

    If `reserved` contains numbers, compact packets, packets to these numbers and other baud rates
    are forbidden.
    """

    line: LineSettings = field(default_factory=LineSettings)
    device_number: int | None = None  # 0-127; `None` for the compact protocol
    polynomial: int = DEFAULT_POLYNOMIAL
    reserved: frozenset[int] = frozenset()  # numbers of other devices on the line
    group: tuple[int, ...] = ()  # numbers of boards driven together, `device_number` first

    @classmethod
    def on(cls, port: PortSettings) -> "ConnectionSettings":
        """Add the default board settings to a port without board settings."""
        if isinstance(port, ConnectionSettings):
            return port
        return cls(port.url, name=port.name, timeouts=port.timeouts)

    @property
    def packed(self) -> str:
        line, number = self.line, -1 if self.device_number is None else self.device_number
        text = f"{line.baud} {line.detection.name} {line.stop_bits} {number} {self.polynomial:02X}"
        return text + (SHARED + self.reserved_text if self.reserved else "")

    def unpacked(self, text: str) -> "ConnectionSettings":
        """Parse a `packed` text. Raise BadRequest if it is invalid.

        If the text has no reserved numbers, `reserved` is unchanged.
        """
        try:
            unshared, separator, reserved = text.partition(SHARED)
            baud, detection, stop_bits, number, polynomial = unshared.split(" ")
            line = LineSettings(int(baud), Detection[detection], int(stop_bits))
            line.to_wire()  # raises if no board has these settings
            settings = replace(
                self,
                line=line,
                device_number=None if int(number) == -1 else int(number),
                polynomial=check_polynomial(int(polynomial, 16)),
                reserved=numbers_in(reserved) if separator else self.reserved,
            )
            _ = settings.framing  # raises if the device number is missing or reserved
        except (KeyError, ValueError) as error:
            raise BadRequest(tr("{0!r} are not valid board settings").format(text)) from error
        return settings

    def at(self, line: SerialFormat) -> PortSettings:
        """Return the settings with another serial format.

        The result is a plain `PortSettings` unless `line` is a `LineSettings`.
        """
        if isinstance(line, LineSettings):
            return replace(self, line=line)
        return PortSettings(self.url, line, name=self.name, timeouts=self.timeouts)

    def with_group(self, numbers: Iterable[int]) -> "ConnectionSettings":
        """Return the settings for driving these boards together.

        Raises:
            BadRequest: there are fewer than two numbers, or a number is repeated, reserved or not
                0-127.
        """
        group = tuple(seven_bits(number, tr("device number")) for number in numbers)
        if len(set(group)) < 2 or len(set(group)) < len(group) or self.reserved & set(group):
            raise BadRequest(tr("Boards that are driven together need different device numbers."))
        return replace(self, device_number=group[0], group=group)

    def of_board(self, number: int) -> "ConnectionSettings":
        """Return the settings for one board of the group. The other numbers are reserved."""
        others = self.reserved | (frozenset(self.group) - {number})
        return replace(self, device_number=number, reserved=others)

    @property
    def reserved_text(self) -> str:
        return ",".join(map(str, sorted(self.reserved)))

    @property
    def framing(self) -> Framing:
        if self.reserved and self.device_number in {None, *self.reserved}:
            raise BadRequest(
                tr("The board needs a device number that no other device on the line has.")
            )
        return Framing(self.device_number, self.polynomial if self.line.has_crc else None)
