"""The five channel inputs as the board measures them.

Ref: Pololu TReX User's Guide 4.c; TReX 1.0 command documentation 0x86.
"""

import math
from random import Random

from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource
from trex_gui.devices.trex.simulator.signals import Signal, SignalKind

SIGNAL_LOST_AFTER = 0.1
"""Seconds without a pulse until the value is 0xFFFF. The command documentation says 100 ms, the
User's Guide about 150 ms; the former is taken."""

_PERIOD_TICKS = 8
"""Ticks of 2.5 ms in which every input is measured once: 50 Hz, RC and analog."""

_SAMPLES_A_TICK = 2
"""An analog value is the mean of 16 conversions. Inferred: spread over the period."""


class Channels:
    """The inputs as the board measures them, each 50 times a second.

    A receiver sends the pulses of the channels one after the other.
    """

    def __init__(self, source: InputSource, seed: int = 0) -> None:
        self._random = Random(seed)  # noqa: S311 - noise, not secrets
        self.disconnect()
        self.begin(source)

    def disconnect(self) -> None:
        """Return every input to its rest signal."""
        self._signals = dict.fromkeys(CHANNELS, Signal(SignalKind.REST))

    def begin(self, source: InputSource) -> None:
        """Discard all measurements, as at power-up."""
        self.source = source
        unknown = 0 if source is InputSource.ANALOG else None
        self._raw: dict[int, int | None] = dict.fromkeys(CHANNELS, unknown)
        self._silence = dict.fromkeys(CHANNELS, math.inf)
        self._no_pulse = dict.fromkeys(CHANNELS, math.inf)
        self._converted = dict.fromkeys(CHANNELS, 0)
        self._ticks = 0
        self._age = 0.0

    @property
    def has_settled(self) -> bool:
        """Whether each channel has had time to show a signal."""
        return self._age > SIGNAL_LOST_AFTER

    def signal(self, channel: int) -> Signal:
        return self._signals[channel]

    def connect(self, channel: int, signal: Signal) -> None:
        """Connect a signal to a channel (1-5); the next measurement uses it."""
        self._signals[channel] = signal

    def advance(self, seconds: float) -> None:
        self._ticks += 1
        self._age += seconds
        if self.source is InputSource.ANALOG:
            self._convert()
        else:
            self._catch_pulses(seconds)

    def _convert(self) -> None:
        is_due = self._ticks % _PERIOD_TICKS == 0
        for channel, signal in self._signals.items():
            for _ in range(_SAMPLES_A_TICK):
                self._converted[channel] += signal.conversion(self._random)
            if is_due:
                samples = _SAMPLES_A_TICK * _PERIOD_TICKS
                self._raw[channel] = (self._converted[channel] + samples // 2) // samples
                self._converted[channel] = 0

    def _catch_pulses(self, seconds: float) -> None:
        for channel, signal in self._signals.items():
            self._silence[channel] += seconds
            self._no_pulse[channel] += seconds
            if self._ticks % _PERIOD_TICKS == channel and signal.has_pulse(self._random):
                self._no_pulse[channel] = 0.0
                self._raw[channel] = signal.pulse(self._random)
                if self._raw[channel] is not None:
                    self._silence[channel] = 0.0
            elif self._no_pulse[channel] > SIGNAL_LOST_AFTER:
                self._raw[channel] = None

    def silent_for(self, channel: int) -> float:
        """Seconds since the last good pulse of a channel; infinite when there was none."""
        return self._silence[channel]

    @property
    def raw(self) -> tuple[int | None, ...]:
        """The raw counts of channels 1-5; `None` where the board answers 0xFFFF."""
        return tuple(self._raw[channel] for channel in CHANNELS)
