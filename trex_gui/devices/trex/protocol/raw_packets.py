"""Packets typed by the user."""

import re
from dataclasses import dataclass

from trex_gui.core.errors import BadRequest
from trex_gui.core.texts import hex_text
from trex_gui.core.translation import tr
from trex_gui.devices.trex.protocol.commands import (
    COMMANDS,
    SetCalibration,
    SetParameter,
    Signature,
)
from trex_gui.devices.trex.protocol.descriptions import describe
from trex_gui.devices.trex.protocol.framing import EXPANDED_START, Malformed, Packet, PacketParser

_BYTE_LIMIT = 256  # maximum size of one request; the longest packet has 14 bytes

_MOTOR_OPCODES = frozenset(opcode for opcode, cls in COMMANDS.items() if cls.moves)


@dataclass(frozen=True, slots=True)
class RawPacket:
    packet: Packet | Malformed

    @property
    def hexadecimal(self) -> str:
        return hex_text(self.packet.raw)

    @property
    def moves(self) -> bool:
        """True if the packet may contain a motor command or the start of one."""
        return may_move(self.packet.raw)

    @property
    def writes(self) -> bool:
        return isinstance(self.packet, Packet) and isinstance(
            self.packet.command, SetParameter | SetCalibration
        )

    @property
    def is_query(self) -> bool:
        return isinstance(self.packet, Packet) and not (self.moves or self.writes)

    @property
    def writes_everywhere(self) -> bool:
        """True if the packet writes to every board on the line."""
        return self.writes and self.device_number is None

    def is_within_stop(self, device_number: int | None) -> bool:
        """True if a stop to this number reaches every board that receives the packet.

        `None` is a stop to all boards.
        """
        return device_number is None or device_number == self.device_number

    @property
    def device_number(self) -> int | None:
        """Device number in an expanded packet, else `None`."""
        return self.packet.device_number if isinstance(self.packet, Packet) else None

    def description(self, board: Signature | None = None) -> str:
        """Describe the packet. See `describe` for `board`."""
        packet = self.packet
        if isinstance(packet, Malformed):
            return tr("not a TReX packet: {0}").format(packet.reason)
        words = describe(packet.command, board)
        if packet.device_number is None:
            return words
        return tr("device {0}: {1}").format(packet.device_number, words)


def parse_hexadecimal(text: str) -> bytes:
    """Parse bytes such as `86 1F`, `861f` or `0x86, 0x1F`.

    Raises:
        BadRequest: the text is empty, invalid or too long.
    """
    try:
        data = bytes.fromhex(re.sub(r"0[xX]|[,;:]", " ", text))
    except ValueError:
        raise BadRequest(
            tr("“{0}” is not a sequence of hexadecimal bytes such as 86 1F.").format(text)
        ) from None
    if not data:
        raise BadRequest(tr("Enter bytes in hexadecimal, such as 86 1F."))
    if len(data) > _BYTE_LIMIT:
        message = tr("{0} bytes are too many: at most {1} can be sent at once.")
        raise BadRequest(message.format(len(data), _BYTE_LIMIT))
    return data


def packets_of(data: bytes, polynomial: int | None) -> tuple[RawPacket, ...]:
    """Split bytes into packets. `polynomial` is `None` on a line without CRC."""
    parser = PacketParser(polynomial)
    return tuple(map(RawPacket, (*parser.feed(data), *parser.flush())))


def may_move(data: bytes) -> bool:
    """True if the bytes may contain a motor command.

    An expanded packet without its command byte also counts, because the byte may still follow.
    """
    if not _MOTOR_OPCODES.isdisjoint(data):
        return True
    for index, byte in enumerate(data):
        if byte == EXPANDED_START:
            rest = data[index + 1 : index + 3]
            if len(rest) < 2 or rest[1] | 0x80 in _MOTOR_OPCODES:
                return True
    return False
