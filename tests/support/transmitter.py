"""A transmitter: what its sticks put out, well made or worn, steady or not."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from random import Random

from tests.support.simulator import SimulatedDevice
from trex_gui.devices.trex.calibration.neutral import ChannelSample
from trex_gui.devices.trex.protocol.flags import InputSource

RATE = 50.0
"""Times a second that a receiver gives a pulse, and the board a new value."""

LOST_AFTER = 5
"""Pulses in a row that may be missing before the board says that there is no signal (100 ms)."""


@dataclass(frozen=True)
class Stick:
    """What one channel gives; values in µs, or in V with `source` analog.

    Attributes:
        rest, low, high: where it rests and how far it goes.
        noise: standard deviation of each value.
        drift: how fast its rest wanders, a second.
        lost: share of the pulses that do not come.
        spikes: share of the pulses that are far off.
        forward_is_down: it is built the other way round.
        twitches: how far it moves, now and then, though nobody should touch it.
        connected: whether it gives anything at all.
    """

    rest: float = 1500.0
    low: float = 1000.0
    high: float = 2000.0
    noise: float = 0.0
    drift: float = 0.0
    lost: float = 0.0
    spikes: float = 0.0
    forward_is_down: bool = False
    twitches: float = 0.0
    connected: bool = True
    source: InputSource = InputSource.RC

    def value(self, position: float, seconds: float = 0.0) -> float:
        """What it gives at a position: -1 all the way back or left, 0 let go, 1 forward."""
        where = -position if self.forward_is_down else position
        end = self.high if where > 0 else self.low
        return self.rest + abs(where) * (end - self.rest) + self.drift * seconds

    def truth(self) -> tuple[float, float, float]:
        """Minimum, neutral and maximum in counts, as a perfect observer would see them."""
        per_unit = self.source.counts_per_unit
        return self.low * per_unit, self.rest * per_unit, self.high * per_unit

    def samples(
        self,
        moves: Iterable[tuple[float, float]],
        random: Random,
        start: float = 0.0,
        rate: float = RATE,
    ) -> list[ChannelSample]:
        """What the board reports while it goes from position to position: (seconds, to where).

        A slow line asks less often than the board renews its inputs: `rate` times a second.
        """
        taken: list[ChannelSample] = []
        position, missing, last = 0.0, 0, None
        pulses = 0
        for seconds, target in moves:
            steps = max(1, round(seconds * RATE))
            begin = position
            for step in range(1, steps + 1):
                position = begin + (target - begin) * step / steps
                moment = pulses / RATE
                last, missing = self._pulse(position, moment, random, last, missing)
                if moment >= len(taken) / rate:
                    taken.append(ChannelSample(start + moment, last))
                pulses += 1
        return taken

    def _pulse(
        self, position: float, seconds: float, random: Random, last: int | None, missing: int
    ) -> tuple[int | None, int]:
        if not self.connected:
            return None, missing + 1
        if random.random() < self.lost:
            return (last if missing < LOST_AFTER - 1 else None), missing + 1
        value = random.gauss(self.value(position, seconds), self.noise)
        if self.twitches and 0.6 < seconds < 0.9:
            value += self.twitches
        if random.random() < self.spikes:
            value += random.choice((-1, 1)) * (self.high - self.low) / 2
        count = self.source.counts(value)
        return max(0, min(self.source.highest_count, count)), 0

    def line(self, channel: int, position: float) -> str:
        """The control line that puts its value on an input of the simulated board."""
        if not self.connected:
            return f"channel {channel} silent"
        unit = "us" if self.source is InputSource.RC else "V"
        text = f"channel {channel} {self.value(position):.3f}{unit}"
        if self.noise:
            text += f" noise {self.noise:g}{unit}"
        return f"{text} lost {self.lost:g}" if self.lost else text


HOLD = ((0.2, 1.0), (0.3, 1.0), (0.3, -1.0), (0.3, -1.0), (0.2, 0.0), (0.2, 0.0))
"""A stick pushed all the way, held, pulled all the way back, held, let go."""


class Transmitter:
    """A transmitter with its sticks, in front of a simulated board."""

    def __init__(self, simulator: SimulatedDevice, sticks: dict[int, Stick]) -> None:
        self._simulator = simulator
        self.sticks = sticks
        self.let_go()

    def put(self, channel: int, position: float) -> None:
        """Hold one stick somewhere."""
        self._simulator.do(self.sticks[channel].line(channel, position))

    def is_at_rest(self, raw: Callable[[int], int | None]) -> bool:
        """Whether every channel shows what its stick at rest gives, or nothing if that is so."""
        return all(self._is_idle(channel, raw(channel)) for channel in self.sticks)

    def _is_idle(self, channel: int, count: int | None) -> bool:
        stick = self.sticks[channel]
        if count is None:
            return not stick.connected or stick.lost > 0.5
        noise = 5 * stick.noise * stick.source.counts_per_unit
        return stick.connected and abs(count - stick.truth()[1]) <= 2 + noise

    def let_go(self, channels: Sequence[int] | None = None) -> None:
        """Take the hands off."""
        for channel in channels or tuple(self.sticks):
            self.put(channel, 0.0)
