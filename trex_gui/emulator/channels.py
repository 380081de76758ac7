"""The five channel inputs: what is connected to them, and what the board makes of it.

Ref: Pololu TReX User's Guide 4.a-4.c; TReX 1.0 command documentation 0x86, 0x87.
"""

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum, auto

from trex_gui.protocol.calibration import FULL_SCALE, Calibration, remap
from trex_gui.protocol.flags import CHANNELS, InputSource

SHORTEST_PULSE = 500.0
LONGEST_PULSE = 2500.0
"""Pulses outside these widths, in µs, are errors (User's Guide 4.c)."""

SIGNAL_LOST_AFTER = 0.1
"""Seconds without a pulse until the value is 0xFFFF. The command documentation says 100 ms, the
User's Guide about 150 ms; the former is taken."""

SUPPLY = 5.0
"""What the analog inputs measure against, in volts."""

_RECEIVER_PERIOD = 20_000.0  # µs between pulses of a standard receiver (50 Hz)
_NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)"
_SIGNAL = re.compile(rf"({_NUMBER})\s*(us|µs|v|mv|)", re.IGNORECASE)


class SignalKind(Enum):
    """What is connected to a channel input."""

    REST = auto()
    PULSES = auto()
    VOLTAGE = auto()
    BAD_PULSES = auto()
    SILENCE = auto()


@dataclass(frozen=True, slots=True)
class Signal:
    """What arrives at one input; `value` is µs for pulses and volts for a voltage."""

    kind: SignalKind
    value: float = 0.0

    @classmethod
    def parse(cls, text: str, source: InputSource) -> "Signal":
        """Read `1500us`, `2.5V`, raw counts, `invalid`, `silent` or `rest`.

        Raises:
            ValueError: it is none of these, or no input can carry it.
        """
        word = text.strip().lower()
        words = {
            "invalid": SignalKind.BAD_PULSES,
            "silent": SignalKind.SILENCE,
            "rest": SignalKind.REST,
        }
        if word in words:
            return cls(words[word])
        found = _SIGNAL.fullmatch(word)
        if not found:
            raise ValueError(f"{text!r} is not counts, 1500us, 2.5V, invalid, silent or rest")
        number, unit = float(found[1]), found[2]
        if not unit:
            return cls.from_counts(number, source)
        if unit in {"us", "µs"}:
            return cls.pulses(number)
        return cls.voltage(number / 1000 if unit == "mv" else number)

    @classmethod
    def pulses(cls, microseconds: float) -> "Signal":
        """Servo pulses of a width, 50 a second; a bad width is allowed, the board minds it.

        Raises:
            ValueError: a pulse train cannot have this width.
        """
        if not 0 <= microseconds < _RECEIVER_PERIOD:
            raise ValueError(f"a pulse is 0 to {_RECEIVER_PERIOD:.0f} us wide")
        return cls(SignalKind.PULSES, microseconds)

    @classmethod
    def voltage(cls, volts: float) -> "Signal":
        """Apply a steady voltage.

        Raises:
            ValueError: outside 0-5 V.
        """
        if not 0 <= volts <= SUPPLY:
            raise ValueError(f"an input carries 0 to {SUPPLY:g} V")
        return cls(SignalKind.VOLTAGE, volts)

    @classmethod
    def from_counts(cls, counts: float, source: InputSource) -> "Signal":
        """Whatever makes the board measure these raw counts.

        Raises:
            ValueError: nothing does.
        """
        if source is InputSource.RC:
            return cls.pulses(source.physical(counts))
        return cls.voltage(source.physical(counts))

    def measured(self, source: InputSource) -> int | None:
        """Return the raw counts that the board measures; `None` when there is no good pulse."""
        if source is InputSource.RC:
            return self._pulse_counts()
        return source.counts(self._mean_voltage())

    def _pulse_counts(self) -> int | None:
        if self.kind is SignalKind.REST:
            return InputSource.RC.counts(1500)
        if self.kind is SignalKind.PULSES and SHORTEST_PULSE <= self.value <= LONGEST_PULSE:
            return InputSource.RC.counts(self.value)
        return None

    def _mean_voltage(self) -> float:
        """What the converter averages: a pulse train shows as its mean, an open input as 0 V.

        Both are inferred; no source says what the board reads then.
        """
        match self.kind:
            case SignalKind.VOLTAGE:
                return self.value
            case SignalKind.REST:
                return SUPPLY / 2
            case SignalKind.PULSES:
                return SUPPLY * self.value / _RECEIVER_PERIOD
            case _:
                return 0.0


class Channels:
    """The inputs as the board measures them. A new signal is measured at once.

    Attributes:
        source: how they are measured.
    """

    def __init__(self, source: InputSource) -> None:
        self.source = source
        self._signals = dict.fromkeys(CHANNELS, Signal(SignalKind.REST))
        self._raw: dict[int, int | None] = {}
        self._without_pulse = dict.fromkeys(CHANNELS, 0.0)
        self.measure_all(source)

    def measure_all(self, source: InputSource) -> None:
        """Start afresh, as at power-up."""
        self.source = source
        for channel in CHANNELS:
            self._raw[channel] = self._signals[channel].measured(source)
            self._without_pulse[channel] = 0.0 if self._raw[channel] is not None else math.inf

    def signal(self, channel: int) -> Signal:
        """Return what is connected to a channel (1-5)."""
        return self._signals[channel]

    def connect(self, channel: int, signal: Signal) -> None:
        """Put a signal on a channel (1-5)."""
        self._signals[channel] = signal
        if signal.kind is SignalKind.SILENCE and self.source is InputSource.RC:
            return  # the last value stays until the board misses the pulses
        raw = signal.measured(self.source)
        self._raw[channel] = raw
        if raw is not None:
            self._without_pulse[channel] = 0.0

    def advance(self, seconds: float) -> None:
        """Let time pass: inputs without a good pulse grow old."""
        if self.source is InputSource.ANALOG:
            return
        for channel, signal in self._signals.items():
            if signal.measured(InputSource.RC) is None:
                self._without_pulse[channel] += seconds
                if self._without_pulse[channel] > SIGNAL_LOST_AFTER:
                    self._raw[channel] = None

    def silent_for(self, channel: int) -> float:
        """Seconds since the last good pulse of a channel; infinite when there was none."""
        return self._without_pulse[channel]

    @property
    def raw(self) -> tuple[int | None, ...]:
        """The raw counts of channels 1-5; `None` where the board answers 0xFFFF."""
        return tuple(self._raw[channel] for channel in CHANNELS)


@dataclass(frozen=True, slots=True)
class ChannelSetup:
    """What decides the meaning of raw counts: calibrations and the masks 0x02-0x04."""

    calibrations: Sequence[Calibration]
    ignored: int = 0
    reversed_: int = 0
    parabolic: int = 0

    def remapped(self, raw: Sequence[int | None]) -> tuple[int, ...]:
        """Return each channel by itself, -127 to 127: before mixing and flip."""
        return tuple(
            remap(
                raw[index],
                self.calibrations[index],
                parabolic=_has(self.parabolic, index),
                reversed_=_has(self.reversed_, index),
                ignored=_has(self.ignored, index),
            )
            for index in range(len(CHANNELS))
        )

    def is_switched(self, channel: int, raw: int | None) -> bool:
        """Whether a switch channel (4 flip, 5 override) is active.

        That it is active below a threshold is sourced (User's Guide 4.a). Inferred: the
        threshold lies half way from neutral to minimum; no signal and an ignored channel are
        inactive; a reversed channel counts from the other end.
        """
        index = channel - 1
        if raw is None or _has(self.ignored, index):
            return False
        calibration = self.calibrations[index]
        if _has(self.reversed_, index):
            return raw > (calibration.maximum + calibration.neutral) / 2
        return raw < (calibration.minimum + calibration.neutral) / 2


def motor_values(remapped: Sequence[int], *, mix: bool, flip: bool, joint: bool) -> tuple[int, int]:
    """Return what channels 1 and 2 ask of motors 1 and 2 (-127 to 127).

    Mixing: channel 2 is forward, channel 1 turns (User's Guide 4.a). Inferred: the sums and
    their clipping. Flip: motors and directions change places (User's Guide 4.a). Joint mode
    has no mixing (TReX Jr manual page 6); inferred: flip turns its one motor round.
    """
    turn, forward = remapped[0], remapped[1]
    if joint:
        return (-turn if flip else turn), forward
    first, second = turn, forward
    if mix:
        first, second = _clip(forward + turn), _clip(forward - turn)
    return (-second, -first) if flip else (first, second)


def _has(mask: int, index: int) -> bool:
    return bool(mask >> index & 1)


def _clip(value: int) -> int:
    return max(-FULL_SCALE, min(FULL_SCALE, value))
