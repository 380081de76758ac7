"""Settings to reach one board: port, line, and framing of packets."""

from collections.abc import Iterable
from dataclasses import dataclass, field, replace

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import tr
from trex_gui.core.transport.settings import SHARED, PortSettings, SerialFormat
from trex_gui.devices.trex.protocol.flags import seven_bits
from trex_gui.devices.trex.protocol.framing import DEFAULT_POLYNOMIAL, Framing, check_polynomial
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings


def numbers_in(text: str) -> frozenset[int]:
    """Return the device numbers in a list such as `0,1`. ValueError for any other text."""
    words = text.replace(",", " ").split()
    return frozenset(seven_bits(int(word), tr("device number")) for word in words)


@dataclass(frozen=True, slots=True)
class ConnectionSettings(PortSettings):
    """A port and the addressing of a board on it.

    `device_number` is 0-127 for the Pololu protocol, `None` for the compact protocol. `reserved`
    are the numbers of other devices on the line. If there are any, no packet is compact or goes to
    these devices, and nothing is sent at another baud rate. `group` are the numbers of the boards
    that are driven together, beginning with `device_number`; empty for a single board.
    """

    line: LineSettings = field(default_factory=LineSettings)
    device_number: int | None = None
    polynomial: int = DEFAULT_POLYNOMIAL
    reserved: frozenset[int] = frozenset()
    group: tuple[int, ...] = ()

    @classmethod
    def on(cls, port: PortSettings) -> "ConnectionSettings":
        """Return default board settings for a port. `ConnectionSettings` are returned unchanged."""
        if isinstance(port, ConnectionSettings):
            return port
        return cls(port.url, name=port.name, timeouts=port.timeouts)

    @property
    def packed(self) -> str:
        number = -1 if self.device_number is None else self.device_number
        line, shared = self.line, SHARED + self.reserved_text if self.reserved else ""
        reach = f"{line.baud} {line.detection.name} {line.stop_bits} {number}"
        return f"{reach} {self.polynomial:02X}{shared}"

    def unpacked(self, text: str) -> "ConnectionSettings":
        """Return settings from a `packed` text, or BadRequest. `reserved` stays if not in it."""
        try:
            reach, is_shared, reserved = text.partition(SHARED)
            baud, detection, stop_bits, number, polynomial = reach.split(" ")
            line = LineSettings(int(baud), Detection[detection], int(stop_bits))
            line.to_wire()  # raises if no board has these settings
            settings = replace(
                self,
                line=line,
                device_number=None if int(number) == -1 else int(number),
                polynomial=check_polynomial(int(polynomial, 16)),
                reserved=numbers_in(reserved) if is_shared else self.reserved,
            )
            _ = settings.framing
        except (KeyError, ValueError) as error:
            raise BadRequest(tr("{0!r} are no settings of a board").format(text)) from error
        return settings

    def at(self, line: SerialFormat) -> PortSettings:
        """Return the settings with another line, without addressing if no board can use it."""
        if isinstance(line, LineSettings):
            return replace(self, line=line)
        return PortSettings(self.url, line, name=self.name, timeouts=self.timeouts)

    def with_group(self, numbers: Iterable[int]) -> "ConnectionSettings":
        """Return settings to drive these boards together. BadRequest for wrong numbers."""
        group = tuple(seven_bits(one, tr("device number")) for one in numbers)
        if len(set(group)) < 2 or len(set(group)) < len(group) or self.reserved & set(group):
            raise BadRequest(tr("Boards that are driven together need numbers of their own."))
        return replace(self, device_number=group[0], group=group)

    def of_board(self, number: int) -> "ConnectionSettings":
        """Return settings for one board of the group. The other boards are reserved."""
        others = self.reserved | (frozenset(self.group) - {number})
        return replace(self, device_number=number, reserved=others)

    @property
    def reserved_text(self) -> str:
        return ",".join(map(str, sorted(self.reserved)))

    @property
    def framing(self) -> Framing:
        if self.reserved and self.device_number in {None, *self.reserved}:
            raise BadRequest(tr("The board needs a number that no other device has."))
        return Framing(self.device_number, self.polynomial if self.line.has_crc else None)
