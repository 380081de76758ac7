"""Encoder for packets, and parsers for packets and replies.

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
    """Return `polynomial`, or raise BadRequest if it is not 0x80-0xFF."""
    if not 0x80 <= polynomial <= 0xFF:
        text = tr("a CRC-7 polynomial must be 0x80 to 0xFF, not {0:#x}")
        raise BadRequest(text.format(polynomial))
    return polynomial


def crc7(data: bytes, polynomial: int = DEFAULT_POLYNOMIAL) -> int:
    """Return the CRC-7 of `data`, 0-127.

    The highest bit is processed first. The initial value is 0, and seven zero bits are appended.
    """
    table = _table(check_polynomial(polynomial))
    remainder = 0
    for byte in data:
        remainder = table[remainder ^ byte]
    return remainder >> 1


EXPANDED_START = 0x80


@dataclass(frozen=True, slots=True)
class Framing:
    """Packet format. The constructor raises BadRequest if a number is outside its range."""

    # 0-127: expanded ("Pololu") packets to one board. `None`: compact packets to every board.
    device_number: int | None = None
    polynomial: int | None = None  # 0x80-0xFF; `None` without CRC

    def __post_init__(self) -> None:
        if self.device_number is not None:
            seven_bits(self.device_number, tr("device number"))
        if self.polynomial is not None:
            check_polynomial(self.polynomial)

    def encode(self, command: Command[object]) -> bytes:
        """Return the packet. Raise BadRequest if a value is outside its range."""
        if self.device_number is None:
            packet = bytes([command.opcode]) + command.data()
        else:
            header = bytes([EXPANDED_START, self.device_number, command.opcode & 0x7F])
            packet = header + command.data()
        # Inferred: the CRC covers the whole packet, including 0x80 and the device number.
        if self.polynomial is not None and command.has_crc:
            packet += bytes([crc7(packet, self.polynomial)])
        return packet

    @property
    def crc_size(self) -> int:
        return 0 if self.polynomial is None else 1


@dataclass(frozen=True, slots=True)
class Packet:
    """Complete packet from a host."""

    raw: bytes
    command: Command[object]
    device_number: int | None  # `None` in a compact packet


@dataclass(frozen=True, slots=True)
class Malformed:
    """Bytes that are neither a valid packet nor a valid reply."""

    raw: bytes
    reason: str


@dataclass(frozen=True, slots=True)
class NeedData:
    size: int  # minimum number of missing bytes


@dataclass(frozen=True, slots=True)
class Reply(Generic[ReplyT_co]):
    raw: bytes  # received bytes, including echo and CRC
    value: ReplyT_co


class PacketParser:
    """Parser for packets from a host. `polynomial` is `None` without CRC.

    A command byte inside a packet makes that packet malformed and starts a new packet. Inferred:
    the documentation calls such a byte an error, but does not say where the board resumes.
    """

    def __init__(self, polynomial: int | None = None) -> None:
        self._polynomial = None if polynomial is None else check_polynomial(polynomial)
        self._buffer = bytearray()

    def feed(self, data: bytes) -> list[Packet | Malformed]:
        events: list[Packet | Malformed] = []
        for byte in data:
            if byte >= 0x80 and self._buffer:
                events.append(self._reject(tr("a command byte inside a packet")))
            self._buffer.append(byte)
            event = self._parse()
            if event is not None:
                events.append(event)
        return events

    def flush(self) -> list[Packet | Malformed]:
        return [self._reject(tr("the packet is not complete"))] if self._buffer else []

    def _reject(self, reason: str) -> Malformed:
        raw = bytes(self._buffer)
        self._buffer.clear()
        return Malformed(raw, reason)

    def _parse(self) -> Packet | Malformed | None:
        buffer = self._buffer
        if buffer[0] < 0x80:
            return self._reject(tr("a data byte outside a packet"))
        device_number: int | None = None
        header_size = 1
        opcode = buffer[0]
        if opcode == EXPANDED_START:
            if len(buffer) < 3:
                return None
            device_number = buffer[1]
            header_size = 3
            opcode = buffer[2] | 0x80
        cls = COMMANDS.get(opcode)
        if cls is None:
            # The packet size is unknown, so every data byte that follows is reported as malformed.
            return self._reject(tr("{0:#04x} is not a TReX command").format(opcode))
        has_crc = self._polynomial is not None and cls.has_crc
        if len(buffer) < header_size + cls.data_size + has_crc:
            return None
        raw = bytes(buffer)
        body = raw[: header_size + cls.data_size]
        if self._polynomial is not None and has_crc:
            expected = crc7(body, self._polynomial)
            if raw[-1] != expected:
                return self._reject(tr("the CRC is {0:02X}, not {1:02X}").format(raw[-1], expected))
        try:
            command = cls.from_packet(opcode, body[header_size:])
        except BadRequest as error:
            return self._reject(str(error))
        self._buffer.clear()
        return Packet(raw, command, device_number)


@dataclass(slots=True)
class ReplyParser(Generic[ReplyT_co]):
    command: Command[ReplyT_co]
    framing: Framing = field(default_factory=Framing)
    echo: bool = False  # True if an echo precedes the reply, as on RS-232
    _buffer: bytearray = field(default_factory=bytearray, init=False)

    def feed(self, data: bytes = b"") -> Reply[ReplyT_co] | NeedData | Malformed:
        """Return the reply, the number of missing bytes, or the error.

        Bytes after the end of a reply make it malformed.
        """
        self._buffer += data
        raw = bytes(self._buffer)
        sent = self.framing.encode(self.command) if self.echo else b""
        if raw[: len(sent)] != sent[: len(raw)]:
            return Malformed(raw, tr("the echo should be {0}").format(hex_text(sent)))
        reply = raw[len(sent) :]
        crc = self.framing.crc_size
        size = self.command.reply_size(reply)
        missing = len(sent) + size + (crc if size else 0) - len(raw)
        if missing > 0:
            return NeedData(missing)
        if missing < 0:
            surplus = tr("1 byte") if missing == -1 else tr("{0} bytes").format(-missing)
            return Malformed(raw, tr("{0} more than the reply has").format(surplus))
        payload = reply[:size]
        if size and self.framing.polynomial is not None:
            expected = crc7(payload, self.framing.polynomial)
            if reply[-1] != expected:
                text = tr("the CRC is {0:02X}, not {1:02X}")
                return Malformed(raw, text.format(reply[-1], expected))
        try:
            return Reply(raw, self.command.parse(payload))
        except BadReply as error:
            return Malformed(raw, str(error))
