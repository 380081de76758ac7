"""Commands of the motors, computed from raw channel values.

The regions are those of the user guide. The arithmetic within a region is inferred (reference,
section 3): all values are integers, and the only division comes last and rounds down.
"""

from typing import NamedTuple

INVALID = 0xFFFF
FULL = 127


class Calibration(NamedTuple):
    """Calibration of a channel. Its values are in the order of the protocol."""

    minimum: int
    neutral: int
    maximum: int
    deadband: int

    @property
    def allowed(self) -> bool:
        return self.minimum <= self.neutral <= self.maximum and self.minimum < self.maximum


RC_DEFAULT = Calibration(2500, 3750, 5000, 75)
ANALOG_DEFAULT = Calibration(0, 512, 1023, 20)


def remapped(
    raw: int,
    calibration: Calibration,
    *,
    ignored: bool = False,
    reverse: bool = False,
    parabolic: bool = False,
) -> int:
    """Return the value of a channel, -127 to 127."""
    if ignored or raw == INVALID:
        return 0
    minimum, neutral, maximum, deadband = calibration
    distance = abs(raw - neutral)
    if distance <= deadband:
        return 0
    sign = 1 if (raw > neutral) is not reverse else -1
    if raw >= maximum or raw <= minimum:
        return sign * FULL
    # The value is outside the deadband and within the ends, so this division is valid.
    span = maximum - neutral if raw > neutral else neutral - minimum
    part, whole = distance - deadband, span - deadband
    if parabolic:
        part, whole = part * part, whole * whole
    return sign * (FULL * part // whole)


def coded(value: int) -> int:
    """Return a byte: bit 7 is the direction, bits 6:0 the magnitude. Zero is forward (inferred)."""
    return -value | 0x80 if value < 0 else value


def switched_on(
    raw: int, calibration: Calibration, *, ignored: bool = False, reverse: bool = False
) -> bool:
    """Return whether a switch (channel 4 or 5) is past the middle between neutral and its end."""
    if ignored or raw == INVALID:
        return False
    if reverse:
        return 2 * raw > calibration.maximum + calibration.neutral
    return 2 * raw < calibration.minimum + calibration.neutral


def motors(first: int, second: int, *, mix: bool, joint: bool, flip: bool) -> tuple[int, int]:
    """Return the commands of motors 1 and 2 for the values of channels 1 and 2."""
    if joint:
        return (-first if flip else first), second
    if mix:
        first, second = _clipped(second + first), _clipped(second - first)
    return (-second, -first) if flip else (first, second)


def _clipped(value: int) -> int:
    return max(-FULL, min(FULL, value))
