"""Simulated transmitter with ideal, worn or noisy sticks."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from random import Random

from tests.support.simulator import SimulatedDevice
from trex_gui.devices.trex.calibration.neutral import ChannelSample
from trex_gui.devices.trex.protocol.flags import InputSource

RATE = 50.0
"""Pulses of a receiver, and new values of the board, per second."""

LOST_AFTER = 5
"""Consecutive missing pulses until the board reports no signal (100 ms)."""


@dataclass(frozen=True)
class Stick:
    """Stick and the signal of its channel. Values in µs, or in V if `source` is analog.

    Attributes:
        rest, low, high: values of the released stick and of its ends.
        noise: standard deviation of each value.
        drift: change of the rest value per second.
        lost: share of missing pulses.
        spikes: share of pulses with a wrong value.
        forward_is_down: whether the value falls while the stick is pushed forward.
        twitches: size of a short movement of the released stick.
        connected: whether there is a signal.
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
        """Return the value at a position: -1 back or left, 0 released, 1 forward."""
        signed = -position if self.forward_is_down else position
        end = self.high if signed > 0 else self.low
        return self.rest + abs(signed) * (end - self.rest) + self.drift * seconds

    def truth(self) -> tuple[float, float, float]:
        """Return the exact minimum, neutral and maximum in counts."""
        per_unit = self.source.counts_per_unit
        return self.low * per_unit, self.rest * per_unit, self.high * per_unit

    def samples(
        self,
        moves: Iterable[tuple[float, float]],
        random: Random,
        start: float = 0.0,
        rate: float = RATE,
    ) -> list[ChannelSample]:
        """Return the samples of the board during `moves`: (seconds, target position).

        `rate`: samples per second, which may be fewer than the pulses per second.
        """
        samples: list[ChannelSample] = []
        position, missing, last = 0.0, 0, None
        pulses = 0
        for seconds, target in moves:
            steps = max(1, round(seconds * RATE))
            first = position
            for step in range(1, steps + 1):
                position = first + (target - first) * step / steps
                moment = pulses / RATE
                last, missing = self._pulse(position, moment, random, last, missing)
                if moment >= len(samples) / rate:
                    samples.append(ChannelSample(start + moment, last))
                pulses += 1
        return samples

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
        """Return the control line that sets an input of the simulated board to the value."""
        if not self.connected:
            return f"channel {channel} silent"
        unit = "us" if self.source is InputSource.RC else "V"
        text = f"channel {channel} {self.value(position):.3f}{unit}"
        if self.noise:
            text += f" noise {self.noise:g}{unit}"
        return f"{text} lost {self.lost:g}" if self.lost else text


HOLD = ((0.2, 1.0), (0.3, 1.0), (0.3, -1.0), (0.3, -1.0), (0.2, 0.0), (0.2, 0.0))
"""Moves of a stick: push it to its end, hold, pull it to the other end, hold, release."""


class Transmitter:
    """Transmitter that controls the inputs of a simulated board."""

    def __init__(self, simulator: SimulatedDevice, sticks: dict[int, Stick]) -> None:
        self._simulator = simulator
        self.sticks = sticks
        self.release()

    def put(self, channel: int, position: float) -> None:
        """Hold a stick at a position."""
        self._simulator.do(self.sticks[channel].line(channel, position))

    def is_at_rest(self, raw: Callable[[int], int | None]) -> bool:
        """Return whether the board reads each stick at rest, or no signal where none is sent."""
        return all(self._is_idle(channel, raw(channel)) for channel in self.sticks)

    def _is_idle(self, channel: int, count: int | None) -> bool:
        stick = self.sticks[channel]
        if count is None:
            return not stick.connected or stick.lost > 0.5
        noise = 5 * stick.noise * stick.source.counts_per_unit
        return stick.connected and abs(count - stick.truth()[1]) <= 2 + noise

    def release(self, channels: Sequence[int] | None = None) -> None:
        """Release some sticks, by default all."""
        for channel in channels or tuple(self.sticks):
            self.put(channel, 0.0)
