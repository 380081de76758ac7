"""Packets on the wire: from a command to bytes, and from bytes to packets and replies.

Ref: Pololu TReX User's Guide 5.b (sub-protocols), 5.e (CRC).
"""

from dataclasses import dataclass, field
from functools import cache
from typing import Generic

from trex_gui.core.errors import BadReply, BadRequest
from trex_gui.core.texts import hex_text
from trex_gui.core.translation import tr
from trex_gui.devices.trex.protocol.commands import COMMANDS, Command, ReplyT_co
from trex_gui.devices.trex.protocol.flags import seven_bits

DEFAULT_POLYNOMIAL = 0x89


@cache
def _table(polynomial: int) -> bytes:
    table = bytearray()
    for value in range(256):
        remainder = value
        for _ in range(8):
            if remainder & 0x80:
                remainder ^= polynomial
            remainder = remainder << 1 & 0xFF
        table.append(remainder)
    return bytes(table)


def check_polynomial(polynomial: int) -> int:
    """Return `polynomial` if its top bit is 1 (0x80-0xFF), else raise BadRequest."""
    if not 0x80 <= polynomial <= 0xFF:
        raise BadRequest(tr("a CRC-7 polynomial is 0x80 to 0xFF, not {0:#x}").format(polynomial))
    return polynomial


def crc7(data: bytes, polynomial: int = DEFAULT_POLYNOMIAL) -> int:
    """Return the CRC-7 of `data`, 0-127: top bit first, start 0, seven zero bits appended."""
    table = _table(check_polynomial(polynomial))
    remainder = 0
    for byte in data:
        remainder = table[remainder ^ byte]
    return remainder >> 1


EXPANDED_START = 0x80


@dataclass(frozen=True, slots=True)
class Framing:
    """Wrapping of packets. BadRequest if a number is outside its range."""

    # 0-127 for expanded ("Pololu") packets, which address one board on the line; `None` for
    # compact packets, which every board on the line obeys
    device_number: int | None = None
    polynomial: int | None = None  # 0x80-0xFF if packets and replies end in a CRC-7; else `None`

    def __post_init__(self) -> None:
        if self.device_number is not None:
            seven_bits(self.device_number, tr("device number"))
        if self.polynomial is not None:
            check_polynomial(self.polynomial)

    def encode(self, command: Command[object]) -> bytes:
        """Return the packet of a command. BadRequest if a value does not fit."""
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


@dataclass(frozen=True, slots=True)
class Packet:
    """A complete packet from a host. `device_number` is `None` in a compact packet."""

    raw: bytes
    command: Command[object]
    device_number: int | None


@dataclass(frozen=True, slots=True)
class Malformed:
    """Bytes that are no packet or no reply, and why."""

    raw: bytes
    reason: str


@dataclass(frozen=True, slots=True)
class NeedData:
    """An incomplete reply. At least `size` bytes are missing."""

    size: int


@dataclass(frozen=True, slots=True)
class Reply(Generic[ReplyT_co]):
    """A complete reply: its bytes with echo and CRC, and the parsed value."""

    raw: bytes
    value: ReplyT_co


class PacketParser:
    """Splits the bytes from a host into packets. `polynomial` is `None` without CRC.

    A command byte in the middle of a packet ends that packet as malformed and starts a new packet
    (inferred: the documentation calls it an error and does not say where the board resumes).
    """

    def __init__(self, polynomial: int | None = None) -> None:
        self._polynomial = None if polynomial is None else check_polynomial(polynomial)
        self._held = bytearray()

    def feed(self, data: bytes) -> list[Packet | Malformed]:
        """Add received bytes. Return the packets and errors that they complete."""
        events: list[Packet | Malformed] = []
        for byte in data:
            if byte >= 0x80 and self._held:
                events.append(self._give_up(tr("a command byte inside a packet")))
            self._held.append(byte)
            event = self._judge()
            if event is not None:
                events.append(event)
        return events

    def flush(self) -> list[Packet | Malformed]:
        return [self._give_up(tr("the packet is not complete"))] if self._held else []

    def _give_up(self, reason: str) -> Malformed:
        raw = bytes(self._held)
        self._held.clear()
        return Malformed(raw, reason)

    def _judge(self) -> Packet | Malformed | None:
        """Check the held bytes. `None` while they may still become a packet."""
        held = self._held
        if held[0] < 0x80:
            return self._give_up(tr("a data byte outside a packet"))
        device_number: int | None = None
        head = 1
        opcode = held[0]
        if held[0] == EXPANDED_START:
            if len(held) < 3:
                return None
            device_number = held[1]
            head = 3
            opcode = held[2] | 0x80
        cls = COMMANDS.get(opcode)
        if cls is None:
            # The number of data bytes is unknown: each is reported as outside a packet.
            return self._give_up(tr("{0:#04x} is not a TReX command").format(opcode))
        has_crc = self._polynomial is not None and opcode != 0xFF
        size = head + cls.data_size + has_crc
        if len(held) < size:
            return None
        raw = bytes(held)
        body = raw[: head + cls.data_size]
        if self._polynomial is not None and has_crc:
            expected = crc7(body, self._polynomial)
            if raw[-1] != expected:
                return self._give_up(
                    tr("the CRC is {0:02X}, not {1:02X}").format(raw[-1], expected)
                )
        try:
            command = cls.from_packet(opcode, body[head:])
        except BadRequest as error:
            return self._give_up(str(error))
        self._held.clear()
        return Packet(raw, command, device_number)


@dataclass(slots=True)
class ReplyParser(Generic[ReplyT_co]):
    """Collects the reply to one command.

    With `echo`, the bytes of the packet itself arrive before the reply, as on RS-232.
    """

    command: Command[ReplyT_co]
    framing: Framing = field(default_factory=Framing)
    echo: bool = False
    _held: bytearray = field(default_factory=bytearray, init=False)

    def feed(self, data: bytes = b"") -> Reply[ReplyT_co] | NeedData | Malformed:
        """Add received bytes. Return the reply, the number of missing bytes, or the error.

        Bytes after the end of a reply make it malformed, because no command explains them.
        """
        self._held += data
        raw = bytes(self._held)
        sent = self.framing.encode(self.command) if self.echo else b""
        if raw[: len(sent)] != sent[: len(raw)]:
            return Malformed(raw, tr("the echo should be {0}").format(hex_text(sent)))
        answer = raw[len(sent) :]
        crc = self.framing.crc_size
        size = self.command.reply_size(answer)
        total = len(sent) + size + (crc if size else 0)
        if len(raw) < total:
            return NeedData(total - len(raw))
        if len(raw) > total:
            surplus = len(raw) - total
            bytes_ = tr("1 byte") if surplus == 1 else tr("{0} bytes").format(surplus)
            return Malformed(raw, tr("{0} more than the reply has").format(bytes_))
        payload = answer[:size]
        if size and self.framing.polynomial is not None:
            expected = crc7(payload, self.framing.polynomial)
            if answer[-1] != expected:
                return Malformed(
                    raw, tr("the CRC is {0:02X}, not {1:02X}").format(answer[-1], expected)
                )
        try:
            return Reply(raw, self.command.parse(payload))
        except BadReply as error:
            return Malformed(raw, str(error))
