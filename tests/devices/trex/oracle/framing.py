"""Packets and errors in a stream of bytes."""

from enum import IntFlag
from typing import NamedTuple

EXPANDED = 0x80
NULL = 0xFF


class UartError(IntFlag):
    """Bits of the UART error byte that a stream of well-formed characters can set."""

    NONE = 0
    CRC = 0x20
    FORMAT = 0x40
    TIMEOUT = 0x80


class Packet(NamedTuple):
    command: int
    data: bytes


class ByteEffect(NamedTuple):
    """Effect of a byte. A byte can end a packet with an error and be another packet."""

    packet: Packet | None = None
    error: UartError = UartError.NONE


NOTHING = ByteEffect()


def remainder(message: bytes, polynomial: int) -> int:
    """Divide the message and seven zero bits by the polynomial, as in a calculation by hand."""
    number = int.from_bytes(message) << 7
    while number.bit_length() > 7:
        number ^= polynomial << (number.bit_length() - 8)
    return number


def data_bytes(command: int) -> int | None:
    """Return the number of data bytes after a command byte. None for an unknown command."""
    if 0x81 <= command <= 0x85 or 0x8D <= command <= 0x95 or command == NULL:
        return 0
    if command in {0x86, 0x87, 0x9F} or 0xC0 <= command <= 0xCF or command in {0xF0, 0xF1}:
        return 1
    if 0xD0 <= command <= 0xEF:
        return 2
    if command == 0xAF:
        return 4
    if 0xA0 <= command <= 0xA4:
        return 10
    return None


COMMANDS = [command for command in range(0x81, 0x100) if data_bytes(command) is not None]
UNKNOWN_COMMANDS = [command for command in range(0x81, 0x100) if data_bytes(command) is None]


def sealed(packet: bytes, polynomial: int | None) -> bytes:
    """Return the packet, followed by its CRC if there is a polynomial."""
    return packet if polynomial is None else packet + bytes([remainder(packet, polynomial)])


class Framer:
    """Divides a stream into packets. `polynomial` is None while packets have no CRC."""

    def __init__(self, device_number: int, polynomial: int | None) -> None:
        self.device_number = device_number
        self.polynomial = polynomial
        self._received = b""  # bytes of the current packet
        self._skipping = False  # true in a packet for another device

    def feed(self, byte: int) -> ByteEffect:
        if byte < 0x80:
            if self._received:
                self._received += bytes([byte])
                return self._parse()
            # Inferred: data outside a packet is a format error.
            return NOTHING if self._skipping else ByteEffect(None, UartError.FORMAT)
        interrupted = UartError.FORMAT if self._received else UartError.NONE
        self._skipping = False
        # Inferred: the byte that interrupts a packet begins the next one.
        self._received = bytes([byte])
        packet, error = self._parse()
        return ByteEffect(packet, interrupted | error)

    def _parse(self) -> ByteEffect:
        """Parse the bytes of the current packet."""
        body = self._received
        if body[0] == EXPANDED:
            if len(body) == 1:
                return NOTHING
            if body[1] != self.device_number:
                self._received, self._skipping = b"", True
                return NOTHING
            if len(body) == 2:
                return NOTHING
            body = bytes([body[2] | 0x80]) + body[3:]
        command = body[0]
        count = data_bytes(command)
        if count is None:
            return self._drop(UartError.FORMAT)
        # Inferred: the null command has no CRC.
        checked = self.polynomial is not None and command != NULL
        if len(body) < 1 + count + checked:
            return NOTHING
        if self.polynomial is not None and checked:
            # Inferred: the CRC covers every byte, including 0x80 and the device number.
            if remainder(self._received[:-1], self.polynomial) != self._received[-1]:
                return self._drop(UartError.CRC)
            body = body[:-1]
        self._received = b""
        return ByteEffect(Packet(command, body[1:]))

    def _drop(self, error: UartError) -> ByteEffect:
        self._received = b""
        return ByteEffect(None, error)
