"""Handles of a calibration curve, and the limits on moving them."""

from dataclasses import replace
from enum import Enum

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.channel_text import input_range_text
from trex_gui.devices.trex.protocol.calibration import HIGHEST_CODED, Calibration
from trex_gui.devices.trex.protocol.flags import InputSource


class Handle(Enum):
    MINIMUM = "minimum"
    NEUTRAL = "neutral"
    MAXIMUM = "maximum"
    DEADBAND_LOW = "lower end of the deadband"
    DEADBAND_HIGH = "upper end of the deadband"

    @property
    def is_deadband(self) -> bool:
        return self in {Handle.DEADBAND_LOW, Handle.DEADBAND_HIGH}

    def count(self, calibration: Calibration) -> int:
        """Return the raw count of this handle. A wide deadband can reach below 0."""
        if self.is_deadband:
            width = calibration.deadband
            return calibration.neutral + (width if self is Handle.DEADBAND_HIGH else -width)
        return int(getattr(calibration, self.value))


def move_handle(calibration: Calibration, handle: Handle, count: int) -> tuple[Calibration, str]:
    """Return a calibration whose handle is as close to `count` as its limits allow.

    Also return a sentence about the limit that stopped the handle, or an empty string.
    """
    minimum, neutral, maximum = calibration.minimum, calibration.neutral, calibration.maximum
    value, field = count, handle.value
    match handle:
        case Handle.MINIMUM:
            limits = 0, min(neutral, maximum - 1)
            reason = tr("Minimum cannot pass neutral.")
            if neutral >= maximum:
                reason = tr("Minimum and maximum must differ.")
        case Handle.NEUTRAL:
            limits = minimum, maximum
            if count < minimum:
                reason = tr("Neutral cannot pass minimum.")
            else:
                reason = tr("Neutral cannot pass maximum.")
        case Handle.MAXIMUM:
            limits = max(neutral, minimum + 1), HIGHEST_CODED
            reason = tr("Maximum cannot pass neutral.")
            if neutral <= minimum:
                reason = tr("Minimum and maximum must differ.")
        case Handle.DEADBAND_LOW | Handle.DEADBAND_HIGH:
            field = "deadband"
            value = count - neutral if handle is Handle.DEADBAND_HIGH else neutral - count
            limits = 0, max(neutral - minimum, maximum - neutral, 0)
            reason = tr("The deadband cannot be wider than the travel.")
            if value < 0:
                reason = tr("The ends of the deadband cannot pass neutral.")
    limited = max(limits[0], min(limits[1], value))
    return replace(calibration, **{field: limited}), "" if limited == value else reason


def limit_to_input(
    calibration: Calibration, handle: Handle, count: int, source: InputSource
) -> tuple[int, str]:
    """Limit a count to the input range.

    A handle that is already outside the range may stay there. Also return a sentence about the
    range if the count was limited, or else an empty string.
    """
    position = handle.count(calibration)
    lowest, highest = min(source.lowest_count, position), max(source.highest_count, position)
    if lowest <= count <= highest:
        return count, ""
    return (lowest if count < lowest else highest), input_range_text(source)
