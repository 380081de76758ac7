"""Signals of a channel input: servo pulses, a voltage, nothing.

Ref: Pololu TReX User's Guide 4.b, 4.c.
"""

import re
from dataclasses import dataclass, replace
from enum import Enum, auto
from random import Random

from trex_gui.devices.trex.protocol.flags import InputSource

SHORTEST_PULSE = 500.0
LONGEST_PULSE = 2500.0
"""Pulses outside these widths, in µs, are errors (User's Guide 4.c)."""

SUPPLY = 5.0
"""Reference voltage of the analog inputs."""

_RECEIVER_PERIOD = 20_000.0  # µs between pulses of a standard receiver (50 Hz)
_NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)"
_SIGNAL = re.compile(
    rf"({_NUMBER})\s*(us|µs|v|mv|)"
    rf"(?:\s*noise\s*({_NUMBER})\s*(us|µs|v|mv|))?(?:\s*lost\s*({_NUMBER}))?",
    re.IGNORECASE,
)


class SignalKind(Enum):
    """Kind of a signal."""

    REST = auto()
    PULSES = auto()
    VOLTAGE = auto()
    BAD_PULSES = auto()
    SILENCE = auto()


_WORDS = {
    "invalid": SignalKind.BAD_PULSES,
    "silent": SignalKind.SILENCE,
    "rest": SignalKind.REST,
}


@dataclass(frozen=True, slots=True)
class Signal:
    """Signal at one input.

    Attributes:
        value: in µs for pulses and volts for a voltage.
        noise: standard deviation of each pulse or conversion, in the unit of `value`.
        lost: share of missing pulses, 0-1.
    """

    kind: SignalKind
    value: float = 0.0
    noise: float = 0.0
    lost: float = 0.0

    @classmethod
    def parse(cls, text: str, source: InputSource) -> "Signal":
        """Read `1500us`, `2.5V`, raw counts, `invalid`, `silent` or `rest`.

        `noise 2us` and `lost 0.1` may follow a value.

        Raises:
            ValueError: it is none of these, or no input can carry it.
        """
        word = text.strip().lower()
        if word in _WORDS:
            return cls(_WORDS[word])
        found = _SIGNAL.fullmatch(word)
        if not found:
            raise ValueError(
                f"{text!r} is not counts, 1500us, 2.5V, invalid, silent or rest "
                "(a value may be followed by noise 2us, lost 0.1)"
            )
        signal = cls._of(float(found[1]), found[2], source)
        spread = float(found[3] or 0)
        lost = float(found[5] or 0)
        if not spread and not lost:
            return signal
        noise = cls._of(spread, found[4] or found[2], source)
        if noise.kind is not signal.kind:
            raise ValueError("value and noise have different units")
        if not 0 <= lost <= 1:
            raise ValueError(f"a share of lost pulses is 0 to 1, not {lost:g}")
        return replace(signal, noise=noise.value, lost=lost)

    @classmethod
    def _of(cls, number: float, unit: str, source: InputSource) -> "Signal":
        if not unit:
            return cls.from_counts(number, source)
        if unit in {"us", "µs"}:
            return cls.pulses(number)
        return cls.voltage(number / 1000 if unit == "mv" else number)

    @classmethod
    def pulses(cls, microseconds: float) -> "Signal":
        """Return servo pulses, 50 a second; the width may be invalid for the board.

        Raises:
            ValueError: a pulse train cannot have this width.
        """
        if not 0 <= microseconds < _RECEIVER_PERIOD:
            raise ValueError(f"a pulse is 0 to {_RECEIVER_PERIOD:.0f} us wide")
        return cls(SignalKind.PULSES, microseconds)

    @classmethod
    def voltage(cls, volts: float) -> "Signal":
        """Return a steady voltage.

        Raises:
            ValueError: outside 0-5 V.
        """
        if not 0 <= volts <= SUPPLY:
            raise ValueError(f"an input carries 0 to {SUPPLY:g} V")
        return cls(SignalKind.VOLTAGE, volts)

    @classmethod
    def from_counts(cls, counts: float, source: InputSource) -> "Signal":
        """Return the signal that the board measures as these raw counts.

        Raises:
            ValueError: there is none.
        """
        if source is InputSource.RC:
            return cls.pulses(source.physical(counts))
        return cls.voltage(source.physical(counts))

    @property
    def text(self) -> str:
        """Text that `parse` reads as this signal."""
        for word, kind in _WORDS.items():
            if self.kind is kind:
                return word
        unit = "us" if self.kind is SignalKind.PULSES else "V"
        text = f"{self.value:g}{unit}"
        if self.noise:
            text += f" noise {self.noise:g}{unit}"
        return f"{text} lost {self.lost:g}" if self.lost else text

    def has_pulse(self, random: Random) -> bool:
        """Whether a pulse arrives when one is due, valid or not."""
        if self.kind in {SignalKind.SILENCE, SignalKind.VOLTAGE}:
            return False
        return not self.lost or random.random() >= self.lost

    def pulse(self, random: Random) -> int | None:
        """Measure a pulse in raw counts; `None` for an invalid width."""
        if self.kind is SignalKind.REST:
            return InputSource.RC.counts(1500)
        width = random.gauss(self.value, self.noise) if self.noise else self.value
        if self.kind is SignalKind.PULSES and SHORTEST_PULSE <= width <= LONGEST_PULSE:
            return InputSource.RC.counts(width)
        return None

    def conversion(self, random: Random) -> int:
        """Convert the voltage once, to raw counts.

        Inferred: a pulse train is read as its mean, an open input as 0 V.
        """
        volts = 0.0
        if self.kind is SignalKind.VOLTAGE:
            volts = random.gauss(self.value, self.noise) if self.noise else self.value
        elif self.kind is SignalKind.REST:
            volts = SUPPLY / 2
        elif self.kind is SignalKind.PULSES:
            volts = SUPPLY * self.value / _RECEIVER_PERIOD
        return InputSource.ANALOG.counts(max(0.0, min(SUPPLY, volts)))
