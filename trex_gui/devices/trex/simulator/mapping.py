"""Meaning of measured channels: remapping, switches, motor values.

Ref: Pololu TReX User's Guide 4.a, 4.b; TReX 1.0 command documentation 0x87.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from trex_gui.devices.trex.protocol.calibration import FULL_SCALE, Calibration, remap
from trex_gui.devices.trex.protocol.flags import CHANNELS


@dataclass(frozen=True, slots=True)
class ChannelSetup:
    """Calibrations and the masks 0x02-0x04."""

    calibrations: Sequence[Calibration]
    ignored: int = 0
    reversed_: int = 0
    parabolic: int = 0

    def remapped(self, raw: Sequence[int | None]) -> tuple[int, ...]:
        """Return the channels before mixing and flip, -127 to 127."""
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
    """Return the values of motors 1 and 2 (-127 to 127) from channels 1 and 2.

    Mixing: channel 2 is forward, channel 1 turns (User's Guide 4.a). Inferred: the sums and
    their clipping. Flip: motors and directions are swapped (User's Guide 4.a). Joint mode
    has no mixing (TReX Jr manual page 6); inferred: flip reverses its one motor.
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
