"""Setpoints of the motors."""

from dataclasses import dataclass
from enum import IntEnum

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import tr
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.protocol.flags import seven_bits


class Direction(IntEnum):
    """The two direction bits of a motor command.

    The documentation calls both 00 and 11 "brake low". The speed byte is then the braking duty,
    from 0 (coast) to 127 (full brake).
    """

    BRAKE = 0b00
    REVERSE = 0b01
    FORWARD = 0b10
    BRAKE_ALTERNATIVE = 0b11


@dataclass(frozen=True, slots=True)
class Drive:
    direction: Direction
    speed: int  # speed or braking duty, 0-127

    @classmethod
    def at(cls, speed: int) -> "Drive":
        """Return the setpoint for a speed, -127 to 127. Speed 0 counts as forward.

        Raises:
            BadRequest: the speed is outside its limits.
        """
        if not -FULL_SCALE <= speed <= FULL_SCALE:
            raise BadRequest(tr("a motor's speed must be -127 to 127, not {0}").format(speed))
        return cls(Direction.REVERSE if speed < 0 else Direction.FORWARD, abs(speed))

    @classmethod
    def brake(cls, duty: int = FULL_SCALE) -> "Drive":
        """Return a braking setpoint. `duty` is 0 (coast) to 127 (full brake)."""
        return cls(Direction.BRAKE, seven_bits(duty, tr("brake duty")))

    @property
    def signed(self) -> int:
        """Speed, negative in reverse and 0 while braking."""
        if self.is_brake:
            return 0
        return -self.speed if self.direction is Direction.REVERSE else self.speed

    @property
    def is_brake(self) -> bool:
        return self.direction in {Direction.BRAKE, Direction.BRAKE_ALTERNATIVE}
