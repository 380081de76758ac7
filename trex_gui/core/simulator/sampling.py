"""Bytes as levels on a wire, and a receiver that samples them at a rate of its own.

This is what two UARTs at different rates make of each other: other bytes, framing errors,
several bytes for one or one for several. Between UARTs that are set alike nobody needs it.
"""

from collections.abc import Iterator
from dataclasses import dataclass

from trex_gui.core.transport.settings import Parity, SerialFormat
from trex_gui.devices.trex.protocol.flags import UartError

_HIGH = 1
_DATA_BITS = 8
_SAMPLE_AT = 0.55
"""Where in a bit it is read. UARTs take the majority of three samples around the middle; a
little behind it, no sample falls on the edge of a bit between any two of the board's rates, so
what is heard does not hang on the rounding of times."""

_PARITIES = {Parity.EVEN: 0, Parity.ODD: 1}


@dataclass(frozen=True, slots=True)
class SampledByte:
    """What a receiver makes of the levels.

    Attributes:
        begun, at: when it saw the start bit and when it had the last bit, in seconds.
        value: the byte.
        error: what it noticed to be wrong with it.
    """

    begun: float
    at: float
    value: int
    error: UartError | None = None


def levels(byte: int, settings: SerialFormat) -> list[int]:
    """Return the bits of a byte in their order on the wire: start, data, parity, stop."""
    data = [byte >> index & 1 for index in range(_DATA_BITS)]
    parity = []
    if settings.parity in _PARITIES:
        parity = [sum(data) % 2 ^ _PARITIES[settings.parity]]
    return [0, *data, *parity, *[_HIGH] * settings.stop_bits]


class Receiver:
    """The receiving half of a UART: a falling edge begins a byte, then each bit is read once.

    As in real ones, the first stop bit is looked at and a second is not waited for. Between
    the bytes that it is told about the wire rests high.

    Attributes:
        baud: its rate.
        known_until: until when, in seconds, it has been told.
    """

    def __init__(self, settings: SerialFormat, baud: int, now: float = 0.0) -> None:
        self.known_until = now
        self.baud = baud
        self._bit = 1 / baud
        self._parity = settings.parity
        self._bits_wanted = 1 + _DATA_BITS + (self._parity in _PARITIES) + 1
        self._level = _HIGH
        self._begun: float | None = None
        self._bits: list[int] = []

    @property
    def due(self) -> float | None:
        """When the byte that has begun will be complete; `None` when none has."""
        if self._begun is None:
            return None
        return self._begun + (self._bits_wanted - 1 + _SAMPLE_AT) * self._bit

    def hear(
        self, begin: float, byte: int, settings: SerialFormat, baud: int
    ) -> Iterator[SampledByte]:
        """Take a byte that a sender with these settings begins now; yield what is complete.

        `begin` is in seconds and not before the end of the byte before it.
        """
        yield from self.rest(begin)
        bits = levels(byte, settings)
        for index, level in enumerate(bits):
            yield from self.take(level, begin + (index + 1) / baud)

    def hear_alone(self, byte: int, settings: SerialFormat, baud: int) -> Iterator[SampledByte]:
        """Take a byte after which the wire rests; yield all that is made of it."""
        yield from self.hear(self.known_until, byte, settings, baud)
        yield from self.rest(self.known_until + self._bits_wanted * self._bit)

    def rest(self, until: float) -> Iterator[SampledByte]:
        """Let the wire rest high until a moment; yield what is complete by then."""
        yield from self.take(_HIGH, until)

    def take(self, level: int, until: float) -> Iterator[SampledByte]:
        """Let the wire keep a level until a moment; yield what is complete by then."""
        if until <= self.known_until:
            return
        falls = level < self._level
        self._level = level
        if falls and self._begun is None:
            self._begun = self.known_until
        while self._begun is not None:
            at = self._begun + (len(self._bits) + _SAMPLE_AT) * self._bit
            if at >= until:
                break
            self._bits.append(level)
            if self._bits[0]:  # too short for a start bit
                self._begun, self._bits = None, []
            elif len(self._bits) == self._bits_wanted:
                yield self._complete(at)
        self.known_until = until

    def _complete(self, at: float) -> SampledByte:
        begun = at if self._begun is None else self._begun
        bits, self._bits, self._begun = self._bits, [], None
        data = bits[1 : 1 + _DATA_BITS]
        value = sum(bit << index for index, bit in enumerate(data))
        error = None
        if not bits[-1]:
            error = UartError.FRAMING
        elif self._parity in _PARITIES:
            wanted = sum(data) % 2 ^ _PARITIES[self._parity]
            if bits[1 + _DATA_BITS] != wanted:
                error = UartError.PARITY
        return SampledByte(begun, at, value, error)
