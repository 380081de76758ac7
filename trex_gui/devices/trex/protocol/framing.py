"""From a command to bytes on the wire: compact or expanded packets, with or without CRC-7.

Ref: Pololu TReX User's Guide 5.b (sub-protocols), 5.e (CRC).
"""

from dataclasses import dataclass

from trex_gui.devices.trex.protocol.command import Command, seven_bits
from trex_gui.devices.trex.protocol.crc7 import check_polynomial, crc7

EXPANDED_START = 0x80
DEFAULT_DEVICE_NUMBER = 7


@dataclass(frozen=True, slots=True)
class Framing:
    """How packets are wrapped.

    Attributes:
        device_number: 0-127 for expanded ("Pololu") packets to one board of several; `None`
            for compact packets, which every board on the line obeys.
        polynomial: 0x80-0xFF when each packet and each reply ends in a CRC-7; else `None`.

    Raises:
        BadRequest: a number is outside its range.
    """

    device_number: int | None = None
    polynomial: int | None = None

    def __post_init__(self) -> None:
        if self.device_number is not None:
            seven_bits(self.device_number, "device number")
        if self.polynomial is not None:
            check_polynomial(self.polynomial)

    def encode(self, command: Command[object]) -> bytes:
        """Return the packet of a command.

        Raises:
            BadRequest: a value of the command does not fit.
        """
        if self.device_number is None:
            packet = bytes([command.opcode]) + command.data()
        else:
            head = bytes([EXPANDED_START, self.device_number, command.opcode & 0x7F])
            packet = head + command.data()
        # Inferred: the CRC covers the whole packet, 0x80 and device number included.
        if self.polynomial is not None and command.has_crc:
            packet += bytes([crc7(packet, self.polynomial)])
        return packet

    @property
    def crc_size(self) -> int:
        """Bytes that the CRC adds to each packet and each reply: 0 or 1."""
        return 0 if self.polynomial is None else 1
