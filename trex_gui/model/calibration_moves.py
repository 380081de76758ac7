"""What a person may do to a calibration in one move: drag a part of it, or set it to rights."""

from dataclasses import dataclass, replace
from enum import Enum

from trex_gui.protocol.calibration import HIGHEST_CODED, Calibration
from trex_gui.protocol.flags import InputSource


class Handle(Enum):
    """The parts of a calibration that can be moved along the input axis."""

    MINIMUM = "minimum"
    NEUTRAL = "neutral"
    MAXIMUM = "maximum"
    DEADBAND_LOW = "lower end of the deadband"
    DEADBAND_HIGH = "upper end of the deadband"

    @property
    def is_deadband(self) -> bool:
        """Whether it is an end of the deadband; its two ends move together."""
        return self in {Handle.DEADBAND_LOW, Handle.DEADBAND_HIGH}

    def count(self, calibration: Calibration) -> int:
        """Return the raw count at which it lies; that of a deadband may be negative."""
        match self:
            case Handle.MINIMUM:
                return calibration.minimum
            case Handle.NEUTRAL:
                return calibration.neutral
            case Handle.MAXIMUM:
                return calibration.maximum
            case Handle.DEADBAND_LOW:
                return calibration.neutral - calibration.deadband
            case Handle.DEADBAND_HIGH:
                return calibration.neutral + calibration.deadband


@dataclass(frozen=True, slots=True)
class Move:
    """What became of a calibration, and why a handle went no further; empty: it did."""

    calibration: Calibration
    why: str = ""


def moved(calibration: Calibration, handle: Handle, count: int) -> Move:
    """Move a handle to a raw count, or as far as the board takes it."""
    c = calibration
    match handle:
        case Handle.MINIMUM:
            highest = min(c.neutral, c.maximum - 1)
            why = (
                "Minimum cannot pass neutral."
                if highest == c.neutral
                else "Minimum and maximum must differ."
            )
            return _limited(c, handle, count, (0, highest), why)
        case Handle.NEUTRAL:
            if count < c.minimum:
                return _limited(c, handle, count, (c.minimum, c.maximum), _NEUTRAL_LOW)
            return _limited(c, handle, count, (c.minimum, c.maximum), _NEUTRAL_HIGH)
        case Handle.MAXIMUM:
            lowest = max(c.neutral, c.minimum + 1)
            why = (
                "Maximum cannot pass neutral."
                if lowest == c.neutral
                else "Minimum and maximum must differ."
            )
            return _limited(c, handle, count, (lowest, HIGHEST_CODED), why)
        case _:
            return _deadband_moved(c, handle, count)


_NEUTRAL_LOW = "Neutral cannot pass minimum."
_NEUTRAL_HIGH = "Neutral cannot pass maximum."


def _limited(
    calibration: Calibration, handle: Handle, count: int, limits: tuple[int, int], why: str
) -> Move:
    kept = max(limits[0], min(limits[1], count))
    return Move(replace(calibration, **{handle.value: kept}), "" if kept == count else why)


def _deadband_moved(calibration: Calibration, handle: Handle, count: int) -> Move:
    reach = count - calibration.neutral
    if handle is Handle.DEADBAND_LOW:
        reach = -reach
    ends = calibration.neutral - calibration.minimum, calibration.maximum - calibration.neutral
    widest = max(*ends, 0)
    why = ""
    if reach < 0:
        why = "The deadband ends at neutral."
    elif reach > widest:
        why = "The deadband cannot be wider than the travel."
    return Move(replace(calibration, deadband=max(0, min(widest, reach))), why)


def symmetric(calibration: Calibration, source: InputSource, *, larger: bool) -> Calibration:
    """Make the travel to both ends equal: to the larger or the smaller of the two.

    An end stays within what the input can be, so the larger travel may be cut on both sides.
    """
    ends = calibration.neutral - calibration.minimum, calibration.maximum - calibration.neutral
    travel = max(ends) if larger else min(ends)
    highest = max(source.highest_count, calibration.maximum)
    travel = max(1, min(travel, calibration.neutral, highest - calibration.neutral))
    return replace(
        calibration,
        minimum=max(0, calibration.neutral - travel),
        maximum=calibration.neutral + travel,
    )
