"""Receiver that samples the levels of a wire at its own bit rate.

A UART at another rate receives wrong bytes, framing errors, several bytes in place of one, or one
byte in place of several. UARTs at the same rate do not need this module.
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
"""Sampling point within a bit, as a fraction of the bit.

UARTs use the majority of three samples around the middle. Slightly after the middle, no sample
falls on a bit edge for any two rates of a TReX. On an edge, rounding would decide the value."""

_RATE_TOLERANCE = 0.03
"""Maximum relative difference between the rates of two UARTs.

An error of half a bit in the ten bits of a byte would allow 5 %. A UART that samples only a few
times per bit tolerates less (assumed)."""

_PARITIES = {Parity.EVEN: 0, Parity.ODD: 1}


class ReceiveError(Enum):
    FRAMING = "framing"
    PARITY = "parity"
    OVERRUN = "overrun"


@dataclass(frozen=True, slots=True)
class SampledByte:
    """Received byte, with the times (s) of its start bit and its last sample."""

    begun: float
    at: float
    value: int
    error: ReceiveError | None = None


def rates_differ(sender: float, receiver: float) -> bool:
    """Return whether two baud rates differ so much that the receiver gets wrong bytes."""
    return abs(sender / receiver - 1) > _RATE_TOLERANCE


def levels(byte: int, sender: SerialFormat) -> list[int]:
    """Return the start, data, parity and stop bits of a byte, in this order."""
    data = [byte >> index & 1 for index in range(_DATA_BITS)]
    parity = []
    if sender.parity in _PARITIES:
        parity = [sum(data) % 2 ^ _PARITIES[sender.parity]]
    return [0, *data, *parity, *[_HIGH] * sender.stop_bits]


class Receiver:
    """Receiver of a UART, which samples each bit once.

    A falling edge starts a byte. As in real UARTs, only the first stop bit is checked. Between
    bytes, the wire is high.
    """

    def __init__(self, line: SerialFormat, baud: float, now: float = 0.0) -> None:
        self.known_until = now  # time (s) up to which the level of the wire is known
        self.baud = baud
        self._bit = 1 / baud
        self._parity = line.parity
        self._bits_per_byte = 1 + _DATA_BITS + (line.parity in _PARITIES) + 1
        self._level = _HIGH
        self._begun: float | None = None
        self._bits: list[int] = []

    @property
    def due(self) -> float | None:
        """Time at which the current byte is complete (s). `None` between bytes."""
        if self._begun is None:
            return None
        return self._begun + (self._bits_per_byte - 1 + _SAMPLE_AT) * self._bit

    def receive(
        self, start: float, byte: int, sender: SerialFormat, baud: float
    ) -> Iterator[SampledByte]:
        """Sample a byte sent at `baud`. Yield each received byte once it is complete.

        `start`: time in s, not before the end of the previous byte.
        """
        yield from self.idle(start)
        for index, level in enumerate(levels(byte, sender)):
            yield from self.sample(level, start + (index + 1) / baud)

    def receive_isolated(
        self, byte: int, sender: SerialFormat, baud: float
    ) -> Iterator[SampledByte]:
        yield from self.receive(self.known_until, byte, sender, baud)
        yield from self.idle(self.known_until + self._bits_per_byte * self._bit)

    def idle(self, until: float) -> Iterator[SampledByte]:
        yield from self.sample(_HIGH, until)

    def sample(self, level: int, until: float) -> Iterator[SampledByte]:
        """Set the wire to a level until a time (s). Yield each byte that is complete by then."""
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
    def __init__(
        self,
        timeline: Timeline,
        line: SerialFormat,
        baud: float,
        deliver: Callable[[int, ReceiveError | None, float], None],
    ) -> None:
        """`deliver` is called with each received byte, its error and its start time (s)."""
        self.line = line
        self._timeline = timeline
        self._deliver = deliver
        self._receiver = Receiver(line, baud, timeline.now)

    def receive(self, byte: int, sender: SerialFormat, baud: float, *, paced: bool) -> None:
        """Sample a byte that starts now. Unless `paced`, silence follows the byte."""
        receiver, timeline = self._receiver, self._timeline
        if not paced:
            for sampled in receiver.receive_isolated(byte, sender, baud):
                self._deliver(sampled.value, sampled.error, timeline.now)
            return
        for sampled in receiver.receive(timeline.now, byte, sender, baud):
            deliver = partial(self._deliver, sampled.value, sampled.error, sampled.begun)
            timeline.at(sampled.at, deliver)
        if (due := receiver.due) is not None:
            timeline.at(due, partial(self._end, due))

    def _end(self, due: float) -> None:
        for sampled in self._receiver.idle(nextafter(due, inf)):
            self._deliver(sampled.value, sampled.error, sampled.begun)
