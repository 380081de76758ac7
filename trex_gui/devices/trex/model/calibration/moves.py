"""Changes to a calibration in one step: drag a handle, or make it symmetric."""

from dataclasses import dataclass, replace
from enum import Enum

from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE, HIGHEST_CODED, Calibration
from trex_gui.devices.trex.protocol.flags import InputSource


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
class CalibrationMove:
    """What became of a calibration, and why a handle went no further; empty: it did."""

    calibration: Calibration
    why: str = ""


def moved(calibration: Calibration, handle: Handle, count: int) -> CalibrationMove:
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
) -> CalibrationMove:
    kept = max(limits[0], min(limits[1], count))
    return CalibrationMove(
        replace(calibration, **{handle.value: kept}), "" if kept == count else why
    )


def _deadband_moved(calibration: Calibration, handle: Handle, count: int) -> CalibrationMove:
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
    return CalibrationMove(replace(calibration, deadband=max(0, min(widest, reach))), why)


def within_input(
    calibration: Calibration, handle: Handle, count: int, source: InputSource
) -> tuple[int, str]:
    """Limit a count to the range of the input; also return why it was limited.

    A handle that lies further out already may stay there.
    """
    now = handle.count(calibration)
    lowest, highest = min(source.lowest_count, now), max(source.highest_count, now)
    kept = max(lowest, min(highest, count))
    if kept == count:
        return count, ""
    what = "A pulse" if source is InputSource.RC else "A voltage"
    limit = source.lowest_count if kept == lowest else source.highest_count
    end = "shorter" if kept == lowest else "longer"
    if source is InputSource.ANALOG:
        end = "lower" if kept == lowest else "higher"
    return kept, f"{what} cannot be {end} than {source.text(limit)}."


def symmetric(calibration: Calibration, source: InputSource, *, larger: bool) -> Calibration:
    """Make the travel to both ends equal: to the larger or the smaller of the two.

    An end stays within what the input can be, so the larger travel may be cut on both sides.

    Raises:
        BadRequest: `why_not_symmetric` says why.
    """
    if why := why_not_symmetric(calibration, source, larger=larger):
        raise BadRequest(why)
    travel = _equal_travel(calibration, source, larger=larger)
    return replace(
        calibration,
        minimum=calibration.neutral - travel,
        maximum=calibration.neutral + travel,
    )


def why_not_symmetric(calibration: Calibration, source: InputSource, *, larger: bool) -> str:
    """Say why equal travel would spoil a calibration; empty when it would not.

    Each step of the output needs a count of its own, else a touch gives full output.
    """
    travel = _equal_travel(calibration, source, larger=larger)
    if travel > calibration.deadband + FULL_SCALE:
        return ""
    return (
        f"That would leave {source.text(travel)} to each side of neutral, of which the deadband "
        f"takes {source.text(calibration.deadband)}: too little for every output up to full."
    )


def _equal_travel(calibration: Calibration, source: InputSource, *, larger: bool) -> int:
    ends = calibration.neutral - calibration.minimum, calibration.maximum - calibration.neutral
    travel = max(ends) if larger else min(ends)
    lowest = min(source.lowest_count, calibration.minimum)
    highest = max(source.highest_count, calibration.maximum)
    return min(travel, calibration.neutral - lowest, highest - calibration.neutral)
