"""Channel calibrations and the remapping of raw inputs.

Ref: Pololu TReX User's Guide 4.b (regions); TReX 1.0 command documentation 0x87, 0x90-0x94,
0xA0-0xA4. The arithmetic between the region limits is inferred, because no source specifies it.
"""

import re
from collections.abc import Callable, Mapping
from dataclasses import astuple, dataclass
from enum import StrEnum

from trex_gui.core.decimals import quantity
from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import tr
from trex_gui.devices.trex.protocol.flags import InputSource

INVALID_RAW = 0xFFFF  # reply to 0x86 for a channel without a valid pulse
CALIBRATION_FIELDS = ("minimum", "neutral", "maximum", "deadband")
FULL_SCALE = 127
NEARLY_NEUTRAL = 8  # maximum stick output at which safe-start ends; inferred from "near neutral"
HIGHEST_CODED = 0x3FFF  # 14 bits


class CalibrationKey(StrEnum):
    """Key of a calibration in settings files."""

    RC_CHANNEL_1 = "rc_channel_1"
    RC_CHANNEL_2 = "rc_channel_2"
    RC_CHANNEL_3 = "rc_channel_3"
    RC_CHANNEL_4 = "rc_channel_4"
    RC_CHANNEL_5 = "rc_channel_5"
    ANALOG_CHANNEL_1 = "analog_channel_1"
    ANALOG_CHANNEL_2 = "analog_channel_2"
    ANALOG_CHANNEL_3 = "analog_channel_3"
    ANALOG_CHANNEL_4 = "analog_channel_4"
    ANALOG_CHANNEL_5 = "analog_channel_5"

    @classmethod
    def of(cls, source: InputSource, channel: int) -> "CalibrationKey":
        return cls(f"{source.value.lower()}_channel_{channel}")

    @property
    def source(self) -> InputSource:
        return InputSource.RC if self.startswith("rc") else InputSource.ANALOG

    @property
    def channel(self) -> int:
        return int(self[-1])

    @property
    def label(self) -> str:
        return tr("{0} channel {1}").format(self.source.word, self.channel)


CALIBRATION_KEYS: Mapping[str, CalibrationKey] = {str(key): key for key in CalibrationKey}


@dataclass(frozen=True, slots=True)
class Calibration:
    """Calibration of a channel for one input source, in raw counts.

    A count is 0.4 us (RC) or 4.89 mV (analog). The board accepts a calibration only if
    minimum <= neutral <= maximum and minimum < maximum.
    """

    minimum: int
    neutral: int
    maximum: int
    deadband: int

    def problem(self, text: Callable[[int], str] = str) -> str | None:
        """Return the reason the board would reject the values, or `None`.

        `text` formats a count for the reason.
        """
        for name in self.__slots__:
            if not 0 <= (value := getattr(self, name)) <= HIGHEST_CODED:
                return tr("{0} is {1}; a calibration value must be 0 to {2}").format(
                    name, value, HIGHEST_CODED
                )
        if self.minimum > self.neutral:
            low, middle = text(self.minimum), text(self.neutral)
            return tr("minimum {0} is above neutral {1}").format(low, middle)
        if self.neutral > self.maximum:
            middle, high = text(self.neutral), text(self.maximum)
            return tr("neutral {0} is above maximum {1}").format(middle, high)
        if self.minimum == self.maximum:
            low = text(self.minimum)
            return tr("minimum and maximum are both {0}; they must differ").format(low)
        return None

    def encode(self) -> bytes:
        """Return the eight data bytes of 0xA0-0xA4. Raise BadRequest if a value is invalid."""
        if problem := self.problem():
            raise BadRequest(tr("calibration: {0}").format(problem))
        return b"".join(map(encode_14_bits, astuple(self)))

    @classmethod
    def from_data(cls, data: bytes) -> "Calibration":
        """Decode the eight data bytes of 0xA0-0xA4 without validating them."""
        return cls(*(data[i] & 0x7F | (data[i + 1] & 0x7F) << 7 for i in range(0, 8, 2)))


def read_count(text: str) -> tuple[int, InputSource | None]:
    """Parse a count such as `3750`, `1500us` or `2.5 V`.

    Return the count, and the input source that the unit implies. The source is `None` if the text
    has no unit. Counts are integers. Voltages have no thousands separators.

    Raises:
        AmbiguousNumber: a separator may be either a decimal or a thousands separator.
        BadRequest: the text is not a count.
    """
    number = re.sub(r"(counts?|#)$", "", text.strip().casefold()).strip()
    if number.isdecimal() and len(number) < 10:
        return int(number), None
    if re.search(r"[^\d.,]$", number):  # a decimal needs a unit: 1.5 may mean ms
        if (seconds := quantity(number, "s")) is not None:
            return InputSource.RC.counts(seconds * 1e6), InputSource.RC
        if (volts := quantity(number, "V", thousands=False)) is not None:
            return InputSource.ANALOG.counts(volts), InputSource.ANALOG
    raise BadRequest(
        tr(
            "expected a number of counts (3750) or a value with a unit (1500us, 2.5V), not {0}"
        ).format(text)
    )


def encode_14_bits(value: int) -> bytes:
    """Encode 0-16383 as two data bytes: the low seven bits, then the high seven bits.

    Inferred: the documentation says "low byte, high byte", but no data byte may exceed 127.
    Only this encoding keeps to this limit, and other Pololu controllers use it.
    """
    return bytes([value & 0x7F, value >> 7])


DEFAULT_CALIBRATION = {
    # Inferred: the guide calls 1, 1.5 and 2 ms typical; the deadband of 30 us is a guess.
    InputSource.RC: Calibration(2500, 3750, 5000, 75),
    # Inferred: these limits are the full range of the converter; the deadband is a guess.
    InputSource.ANALOG: Calibration(0, 512, 1023, 20),
}


def remap(
    raw: int | None,
    calibration: Calibration,
    *,
    parabolic: bool = False,
    reversed_: bool = False,
    ignored: bool = False,
) -> int:
    """Return the output, -127 to 127, before mixing and flip.

    The output is 0 for an ignored channel, and for a channel without a valid signal (`None` or
    0xFFFF, inferred). It is also 0 within `deadband` counts of neutral. At minimum and maximum, and
    outside this range, it is -127 or 127. Otherwise, it grows linearly with the distance from the
    deadband, or with the square of this distance if `parabolic`, and is rounded towards 0.
    """
    if raw is None or raw == INVALID_RAW or ignored:
        return 0
    offset = raw - calibration.neutral
    distance = abs(offset)
    if distance <= calibration.deadband:
        return 0
    if raw >= calibration.maximum or raw <= calibration.minimum:
        magnitude = FULL_SCALE
    else:
        limit = calibration.maximum if offset > 0 else calibration.minimum
        travel = abs(limit - calibration.neutral) - calibration.deadband
        position = distance - calibration.deadband
        if parabolic:
            magnitude = FULL_SCALE * position * position // (travel * travel)
        else:
            magnitude = FULL_SCALE * position // travel
    return -magnitude if (offset < 0) != reversed_ else magnitude
