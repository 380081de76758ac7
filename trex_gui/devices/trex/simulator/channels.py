"""The five channel inputs: signals and their measurement by the board.

Ref: Pololu TReX User's Guide 4.b, 4.c; TReX 1.0 command documentation 0x86.
"""

import math
import re
from dataclasses import dataclass, replace
from enum import Enum
from random import Random

from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource

SHORTEST_PULSE = 500.0  # µs; shorter pulses are errors (User's Guide 4.c)
LONGEST_PULSE = 2500.0  # µs; longer pulses are errors
SUPPLY = 5.0  # reference voltage of the analog inputs
_RECEIVER_PERIOD = 20_000.0  # µs between pulses of a standard receiver (50 Hz)
_NUMBER = r"[-+]?(?:\d+(?:\.\d*)?|\.\d+)"
_SIGNAL = re.compile(
    rf"({_NUMBER})\s*(us|µs|v|mv|)"
    rf"(?:\s*noise\s*({_NUMBER})\s*(us|µs|v|mv|))?(?:\s*lost\s*({_NUMBER}))?",
    re.IGNORECASE,
)


class SignalKind(Enum):
    """Kind of a signal. The value is the word in a control line, or the unit."""

    REST = "rest"  # pulses or voltage of a stick at rest
    PULSES = "us"
    VOLTAGE = "V"
    BAD_PULSES = "invalid"
    SILENCE = "silent"


_WITHOUT_VALUE = {
    kind.value: kind for kind in (SignalKind.BAD_PULSES, SignalKind.SILENCE, SignalKind.REST)
}


@dataclass(frozen=True, slots=True)
class Signal:
    kind: SignalKind
    value: float = 0.0  # pulse width in µs, or voltage in V
    noise: float = 0.0  # standard deviation of each pulse or conversion
    lost: float = 0.0  # fraction of missing pulses, 0-1

    @classmethod
    def parse(cls, text: str, source: InputSource) -> "Signal":
        """Parse `1500us`, `2.5V`, raw counts, `invalid`, `silent` or `rest`.

        `noise 2us` and `lost 0.1` may follow a value. Raise ValueError for any other text.
        """
        word = text.strip().lower()
        if word in _WITHOUT_VALUE:
            return cls(_WITHOUT_VALUE[word])
        match = _SIGNAL.fullmatch(word)
        if not match:
            raise ValueError(
                f"a signal must be counts, 1500us, 2.5V, invalid, silent or rest, not {text!r} "
                "(noise 2us and lost 0.1 may follow a value)"
            )
        signal = cls._of(float(match[1]), match[2], source)
        spread = float(match[3] or 0)
        lost = float(match[5] or 0)
        if not spread and not lost:
            return signal
        noise = cls._of(spread, match[4] or match[2], source)
        if noise.kind is not signal.kind:
            raise ValueError("the value and the noise have different units")
        if not 0 <= lost <= 1:
            raise ValueError(f"the fraction of lost pulses must be 0 to 1, not {lost:g}")
        return replace(signal, noise=noise.value, lost=lost)

    @classmethod
    def _of(cls, number: float, unit: str, source: InputSource) -> "Signal":
        if not unit:  # counts
            unit, number = source.unit, source.physical(number)
        if unit in {"us", "µs"}:
            return cls.pulses(number)
        return cls.voltage(number / 1000 if unit == "mv" else number)

    @classmethod
    def pulses(cls, microseconds: float) -> "Signal":
        """Return a signal of 50 servo pulses a second. The board may reject their width."""
        if not 0 <= microseconds < _RECEIVER_PERIOD:
            raise ValueError(f"a pulse must be 0 to {_RECEIVER_PERIOD:.0f} us wide")
        return cls(SignalKind.PULSES, microseconds)

    @classmethod
    def voltage(cls, volts: float) -> "Signal":
        """Return a steady voltage. Raise ValueError if it is not 0-5 V."""
        if not 0 <= volts <= SUPPLY:
            raise ValueError(f"the voltage of an input must be 0 to {SUPPLY:g} V")
        return cls(SignalKind.VOLTAGE, volts)

    @property
    def text(self) -> str:
        unit = self.kind.value
        if unit in _WITHOUT_VALUE:
            return unit
        text = f"{self.value:g}{unit}"
        if self.noise:
            text += f" noise {self.noise:g}{unit}"
        return f"{text} lost {self.lost:g}" if self.lost else text

    def has_pulse(self, random: Random) -> bool:
        if self.kind is SignalKind.SILENCE or self.kind is SignalKind.VOLTAGE:
            return False
        return not self.lost or random.random() >= self.lost

    def pulse(self, random: Random) -> int | None:
        """Measure a pulse. Return raw counts, or `None` for an invalid width."""
        if self.kind is SignalKind.REST:
            return InputSource.RC.counts(1500)
        width = random.gauss(self.value, self.noise) if self.noise else self.value
        if self.kind is SignalKind.PULSES and SHORTEST_PULSE <= width <= LONGEST_PULSE:
            return InputSource.RC.counts(width)
        return None

    def conversion(self, random: Random) -> int:
        """Convert the voltage to raw counts.

        Inferred: the converter measures the mean voltage of pulses, and 0 V at an open input.
        """
        volts = 0.0
        if self.kind is SignalKind.VOLTAGE:
            volts = random.gauss(self.value, self.noise) if self.noise else self.value
        elif self.kind is SignalKind.REST:
            volts = SUPPLY / 2
        elif self.kind is SignalKind.PULSES:
            volts = SUPPLY * self.value / _RECEIVER_PERIOD
        return InputSource.ANALOG.counts(max(0.0, min(SUPPLY, volts)))


# Seconds without a pulse until the board replies 0xFFFF. The command documentation says 100 ms. The
# User's Guide says about 150 ms.
SIGNAL_LOST_AFTER = 0.1

TICK = 0.0025  # length of a simulation step, in seconds
_PERIOD_TICKS = 8  # ticks between two measurements of an RC or analog input: 50 Hz

# An analog value is the mean of 16 conversions. Inferred: these are spread over the period.
_SAMPLES_PER_TICK = 2


class Channels:
    """Five inputs. The board measures them in turn, each 50 times a second."""

    def __init__(self, source: InputSource, seed: int = 0) -> None:
        self._random = Random(seed)  # noqa: S311 - noise, not secrets
        self.reset_signals()
        self.start(source)

    def reset_signals(self) -> None:
        self.signals = dict.fromkeys(CHANNELS, Signal(SignalKind.REST))

    def start(self, source: InputSource) -> None:
        self.source = source
        unknown = 0 if source is InputSource.ANALOG else None
        self._raw: dict[int, int | None] = dict.fromkeys(CHANNELS, unknown)
        # Channel → tick of the last pulse, and of the last valid pulse
        self._pulse_ticks = dict.fromkeys(CHANNELS, -math.inf)
        self._valid_ticks = dict.fromkeys(CHANNELS, -math.inf)
        self._converted = dict.fromkeys(CHANNELS, 0)
        self._ticks = 0

    @property
    def has_settled(self) -> bool:
        return self._ticks * TICK >= SIGNAL_LOST_AFTER

    def silence(self, channel: int) -> float:
        return (self._ticks - self._valid_ticks[channel]) * TICK

    def tick(self) -> None:
        self._ticks += 1
        if self.source is InputSource.ANALOG:
            self._convert()
        elif (channel := self._ticks % _PERIOD_TICKS) in self.signals:
            signal = self.signals[channel]
            if signal.has_pulse(self._random):
                self._pulse_ticks[channel] = self._ticks
                self._raw[channel] = signal.pulse(self._random)
                if self._raw[channel] is not None:
                    self._valid_ticks[channel] = self._ticks

    def _convert(self) -> None:
        is_due = self._ticks % _PERIOD_TICKS == 0
        for channel, signal in self.signals.items():
            for _ in range(_SAMPLES_PER_TICK):
                self._converted[channel] += signal.conversion(self._random)
            if is_due:
                samples = _SAMPLES_PER_TICK * _PERIOD_TICKS
                self._raw[channel] = (self._converted[channel] + samples // 2) // samples
                self._converted[channel] = 0

    @property
    def raw(self) -> tuple[int | None, ...]:
        """Raw counts of channels 1-5. A count is `None` if the board replies 0xFFFF."""
        if self.source is InputSource.ANALOG:
            return tuple(self._raw.values())
        oldest = self._ticks - SIGNAL_LOST_AFTER / TICK
        return tuple(
            raw if self._pulse_ticks[channel] > oldest else None
            for channel, raw in self._raw.items()
        )
