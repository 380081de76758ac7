"""Bytes as levels on a wire, and a receiver that samples them at its own bit rate.

A UART at another rate receives wrong bytes, framing errors, several bytes for one byte, or one
byte for several. UARTs at the same rate do not need this module.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from enum import Enum
from functools import partial
from math import inf, nextafter

from trex_gui.core.simulator.timeline import Timeline
from trex_gui.core.transport.settings import Parity, SerialFormat

_HIGH = 1
_DATA_BITS = 8
_SAMPLE_AT = 0.55
"""Sampling point within a bit. UARTs take the majority of three samples around the middle.
Slightly after the middle, no sample falls on a bit edge for any two rates of a TReX, so that
rounding does not decide the value."""

_RATE_TOLERANCE = 0.03
"""Largest relative difference of two UARTs' rates: half a bit in ten, for both together."""

_PARITIES = {Parity.EVEN: 0, Parity.ODD: 1}


class ReceiveError(Enum):
    FRAMING = "framing"
    PARITY = "parity"
    OVERRUN = "overrun"


@dataclass(frozen=True, slots=True)
class SampledByte:
    """A byte as received, with the times (s) of its start bit and its last sample."""

    begun: float
    at: float
    value: int
    error: ReceiveError | None = None


def is_other_rate(baud: float, other: float) -> bool:
    """Return whether two UARTs at these rates cannot understand each other."""
    return abs(baud / other - 1) > _RATE_TOLERANCE


def levels(byte: int, sender: SerialFormat) -> list[int]:
    """Return the bits of a byte in the order of transmission: start, data, parity, stop."""
    data = [byte >> index & 1 for index in range(_DATA_BITS)]
    parity = []
    if sender.parity in _PARITIES:
        parity = [sum(data) % 2 ^ _PARITIES[sender.parity]]
    return [0, *data, *parity, *[_HIGH] * sender.stop_bits]


class Receiver:
    """The receiving half of a UART: a falling edge begins a byte, then each bit is sampled once.

    As in real UARTs, only the first stop bit is checked. The wire is high between bytes.
    """

    def __init__(self, line: SerialFormat, baud: float, now: float = 0.0) -> None:
        self.known_until = now  # seconds up to which the level of the wire is known
        self.baud = baud  # bit rate
        self._bit = 1 / baud
        self._parity = line.parity
        self._bits_per_byte = 1 + _DATA_BITS + (line.parity in _PARITIES) + 1
        self._level = _HIGH
        self._begun: float | None = None
        self._bits: list[int] = []

    @property
    def due(self) -> float | None:
        """Moment at which the current byte is complete. `None` between bytes."""
        if self._begun is None:
            return None
        return self._begun + (self._bits_per_byte - 1 + _SAMPLE_AT) * self._bit

    def receive(
        self, begin: float, byte: int, sender: SerialFormat, baud: float
    ) -> Iterator[SampledByte]:
        """Sample a byte sent at `baud`. Yield the bytes that are complete at its end.

        `begin` is in seconds and not before the end of the previous byte.
        """
        yield from self.idle(begin)
        for index, level in enumerate(levels(byte, sender)):
            yield from self.sample(level, begin + (index + 1) / baud)

    def receive_isolated(
        self, byte: int, sender: SerialFormat, baud: float
    ) -> Iterator[SampledByte]:
        yield from self.receive(self.known_until, byte, sender, baud)
        yield from self.idle(self.known_until + self._bits_per_byte * self._bit)

    def idle(self, until: float) -> Iterator[SampledByte]:
        yield from self.sample(_HIGH, until)

    def sample(self, level: int, until: float) -> Iterator[SampledByte]:
        """Keep the wire at a level until a moment. Yield the bytes that are complete by then."""
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
            elif len(self._bits) == self._bits_per_byte:
                yield self._complete(at)
        self.known_until = until

    def _complete(self, at: float) -> SampledByte:
        begun = at if self._begun is None else self._begun
        bits, self._bits, self._begun = self._bits, [], None
        data = bits[1 : 1 + _DATA_BITS]
        value = sum(bit << index for index, bit in enumerate(data))
        error = None
        if not bits[-1]:
            error = ReceiveError.FRAMING
        elif self._parity in _PARITIES:
            expected = sum(data) % 2 ^ _PARITIES[self._parity]
            if bits[1 + _DATA_BITS] != expected:
                error = ReceiveError.PARITY
        return SampledByte(begun, at, value, error)


class RateConverter:
    """Receives bytes that arrive at another rate, in virtual time."""

    def __init__(
        self,
        timeline: Timeline,
        line: SerialFormat,
        baud: float,
        deliver: Callable[[int, ReceiveError | None, float], None],
    ) -> None:
        """Pass each complete byte to `deliver`, with its error and start time."""
        self.line = line
        self._timeline = timeline
        self._deliver = deliver
        self._receiver = Receiver(line, baud, timeline.now)

    def receive(self, byte: int, sender: SerialFormat, baud: float, *, paced: bool) -> None:
        """Sample a byte that a sender at `baud` starts now. If not `paced`, silence follows it."""
        receiver, timeline = self._receiver, self._timeline
        if not paced:
            for each in receiver.receive_isolated(byte, sender, baud):
                self._deliver(each.value, each.error, timeline.now)
            return
        for each in receiver.receive(timeline.now, byte, sender, baud):
            timeline.at(each.at, partial(self._deliver, each.value, each.error, each.begun))
        if (due := receiver.due) is not None:
            timeline.at(due, partial(self._end, due))

    def _end(self, due: float) -> None:
        for each in self._receiver.idle(nextafter(due, inf)):
            self._deliver(each.value, each.error, each.begun)
