"""What a channel makes of each raw count: the curve from input to output."""

from dataclasses import dataclass
from functools import lru_cache

from trex_gui.devices.trex.protocol.calibration import Calibration, remap

_SWITCHES = (4, 5)


@dataclass(frozen=True, slots=True)
class ChannelCurve:
    """A calibration with the channel's bits of the masks; the arithmetic is the protocol's."""

    calibration: Calibration
    reversed_: bool = False
    parabolic: bool = False
    ignored: bool = False

    def output(self, raw: int | None) -> int:
        """Return what a raw count becomes, -127 to 127: before mixing and flip."""
        return remap(
            raw,
            self.calibration,
            parabolic=self.parabolic,
            reversed_=self.reversed_,
            ignored=self.ignored,
        )

    def outputs(self, low: int, high: int) -> tuple[int, ...]:
        """Return the output of every raw count from `low` to `high`, both included."""
        return _outputs(self, low, high)

    def corners(self, low: int, high: int) -> tuple[tuple[int, ...], tuple[int, ...]]:
        """Return the counts beside which the output changes, and the outputs there.

        The line through these points is the line through all of them.
        """
        return _corners(self, low, high)

    def threshold(self, channel: int) -> float | None:
        """Return the count at which a switch (4 flip, 5 override) switches.

        `None` for the other channels, and for one that is ignored: it never switches. That a
        switch is active below a threshold is sourced (User's Guide 4.a); where it lies, and
        that a reversed channel counts from the other end, is inferred.
        """
        if channel not in _SWITCHES or self.ignored:
            return None
        end = self.calibration.maximum if self.reversed_ else self.calibration.minimum
        return (end + self.calibration.neutral) / 2

    def is_switched(self, channel: int, raw: int | None) -> bool:
        """Whether a switch is active at this count."""
        threshold = self.threshold(channel)
        if threshold is None or raw is None:
            return False
        return raw > threshold if self.reversed_ else raw < threshold


@lru_cache(maxsize=32)
def _outputs(curve: ChannelCurve, low: int, high: int) -> tuple[int, ...]:
    return tuple(curve.output(raw) for raw in range(low, high + 1))


@lru_cache(maxsize=32)
def _corners(curve: ChannelCurve, low: int, high: int) -> tuple[tuple[int, ...], tuple[int, ...]]:
    outputs = _outputs(curve, low, high)
    last = len(outputs) - 1
    kept = [
        index
        for index, output in enumerate(outputs)
        if index in {0, last} or outputs[index - 1] != output or outputs[index + 1] != output
    ]
    return tuple(low + index for index in kept), tuple(outputs[index] for index in kept)
