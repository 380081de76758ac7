"""Curves from raw counts to outputs, and detection of mixed channels."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import Self

from trex_gui.devices.trex.protocol.calibration import FULL_SCALE, Calibration, remap
from trex_gui.devices.trex.protocol.flags import channels_in
from trex_gui.devices.trex.protocol.parameters import ParameterKey

_SWITCHES = (4, 5)  # channels that act as switches: flip and override

_MAX_DIFFERENCE = 10  # maximum difference between two successive readings while a stick moves


@dataclass(frozen=True, slots=True)
class ChannelCurve:
    """Calibration of a channel, and its bits in the masks."""

    calibration: Calibration
    reversed_: bool = False
    parabolic: bool = False
    ignored: bool = False

    @classmethod
    def stored(
        cls, channel: int, calibration: Calibration, value_of: Callable[[ParameterKey], int | None]
    ) -> Self:
        """Return the curve of a channel (1-5). `value_of` returns the stored masks."""

        def has(key: ParameterKey) -> bool:
            return channel in channels_in(value_of(key) or 0)

        return cls(
            calibration,
            reversed_=has(ParameterKey.REVERSED_CHANNELS),
            parabolic=has(ParameterKey.PARABOLIC_CHANNELS),
            ignored=has(ParameterKey.IGNORED_CHANNELS),
        )

    def output(self, raw: int | None) -> int:
        """Return the output, -127 to 127, before mixing and flip."""
        return remap(
            raw,
            self.calibration,
            parabolic=self.parabolic,
            reversed_=self.reversed_,
            ignored=self.ignored,
        )

    def corners(self, low: int, high: int) -> tuple[tuple[int, ...], tuple[int, ...]]:
        """Return the raw counts and their outputs on both sides of each change of the output."""
        return _corners(self, low, high)

    def threshold(self, channel: int) -> float | None:
        """Return the raw count at which a switch (channel 4 or 5) changes its state.

        Returns `None` for other channels and for an ignored channel.

        Ref: User's Guide 4.a: a switch is active below a threshold. Inferred: the threshold is
        halfway between neutral and minimum, or neutral and maximum if the channel is reversed.
        """
        if channel not in _SWITCHES or self.ignored:
            return None
        end = self.calibration.maximum if self.reversed_ else self.calibration.minimum
        return (end + self.calibration.neutral) / 2

    def is_switched(self, channel: int, raw: int | None) -> bool:
        threshold = self.threshold(channel)
        if threshold is None or raw is None:
            return False
        return raw > threshold if self.reversed_ else raw < threshold


@lru_cache(maxsize=32)
def _corners(curve: ChannelCurve, low: int, high: int) -> tuple[tuple[int, ...], tuple[int, ...]]:
    outputs = [curve.output(raw) for raw in range(low, high + 1)]
    last = len(outputs) - 1
    indices = [
        index
        for index, output in enumerate(outputs)
        if index in {0, last} or outputs[index - 1] != output or outputs[index + 1] != output
    ]
    return tuple(low + index for index in indices), tuple(outputs[index] for index in indices)


def is_mixed(outputs: tuple[int, int], reported: tuple[int, int]) -> bool | None:
    """Return whether channels 1 and 2 are mixed. `None` if unknown, such as at neutral.

    No command reads the mix jumper, so the outputs of the curves are compared with the values that
    the board reports. The result is also `None` if these values fit neither case.

    Ref: a user's measurement (Pololu forum, viewtopic 9053): the jumper also alters the
    remapped values in serial mode. Inferred: the sums that form the mixed values.
    """
    turn, forward = outputs
    mixed = _clipped(forward + turn), _clipped(forward - turn)
    if _distance(outputs, mixed) <= 3 * _MAX_DIFFERENCE:
        return None
    if _distance(outputs, reported) <= _MAX_DIFFERENCE:
        return False
    return True if _distance(mixed, reported) <= _MAX_DIFFERENCE else None


def _clipped(value: int) -> int:
    return max(-FULL_SCALE, min(FULL_SCALE, value))


def _distance(first: tuple[int, int], second: tuple[int, int]) -> int:
    return max(abs(first[0] - second[0]), abs(first[1] - second[1]))
