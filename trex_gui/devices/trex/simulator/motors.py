"""The motor outputs, updated 100 times a second.

Ref: TReX 1.0 command documentation 0xC0-0xF1.
"""

import math
from dataclasses import dataclass
from enum import Enum

FULL_SPEED = 127


class MotorDirection(Enum):
    """Direction of an output."""

    BRAKE = "brake"
    REVERSE = "reverse"
    FORWARD = "forward"

    @classmethod
    def from_bits(cls, bits: int) -> "MotorDirection":
        """Read the two direction bits of a motor command; 00 and 11 brake."""
        return (cls.BRAKE, cls.REVERSE, cls.FORWARD, cls.BRAKE)[bits & 3]

    @property
    def opposite(self) -> "MotorDirection":
        """The reverse direction; braking stays braking."""
        if self is MotorDirection.BRAKE:
            return self
        return MotorDirection.REVERSE if self is MotorDirection.FORWARD else MotorDirection.FORWARD


@dataclass(frozen=True, slots=True)
class MotorSettings:
    """The parameters of one motor, in wire values: 0x0E-0x16."""

    acceleration: int = 0
    brake_duration: int = 0
    current_limit: int = 0
    limit_gain: int = 0

    @property
    def limit_counts(self) -> int | None:
        """The current limit in counts of 0x8D, twice the wire value; `None` when off."""
        return 2 * self.current_limit or None


class Motor:
    """One of the two reversible outputs.

    While it brakes, `speed` is the duty of braking: 127 full brake, 0 coast.
    """

    def __init__(self) -> None:
        self.direction = MotorDirection.BRAKE
        self.target_direction = MotorDirection.BRAKE
        self.target_speed = 0
        self._tenths = 0  # an update adds a tenth of the parameter
        self._driven = MotorDirection.BRAKE  # the direction in which it last ran
        self._braked = 0  # updates spent braking since then

    @property
    def speed(self) -> int:
        """The speed, or duty of braking, 0-127."""
        return self._tenths // 10

    def set(self, direction: MotorDirection, speed: int) -> None:
        """Set direction and speed at once, without ramp and brake duration."""
        self.accelerate(direction, speed)
        self._output(direction, speed * 10)
        self._braked = 0

    def accelerate(self, direction: MotorDirection, speed: int) -> None:
        """Set the target that updates lead to."""
        self.target_direction = direction
        self.target_speed = speed

    def update(self, settings: MotorSettings, current: int) -> bool:
        """Run one update of 10 ms; return whether the current is over the limit.

        `current` is in counts of 0x8D.
        """
        limit = settings.limit_counts
        over = limit is not None and current > limit
        if over and self._is_under_way():
            self._limit(settings.limit_gain, current - (limit or 0))
        else:
            self._follow_target(settings)
        return over

    def _is_under_way(self) -> bool:
        return self.direction is self.target_direction is not MotorDirection.BRAKE

    def _limit(self, gain: int, excess: int) -> None:
        """Lower the speed. Known is that it is proportional and immediate; the rest is inferred."""
        less = math.ceil(gain * excess / 16) if gain else FULL_SPEED
        tenths = min(self._tenths, self.target_speed * 10) - 10 * less
        self._tenths = max(0, tenths)

    def _follow_target(self, settings: MotorSettings) -> None:
        wanted = self.target_direction
        if wanted is MotorDirection.BRAKE:
            self._brake(self.target_speed)
            return
        if self.direction is not wanted:
            if self._must_brake_before(wanted, settings.brake_duration):
                self._brake(FULL_SPEED)
                return
            self._output(wanted, 0)
        self._output(wanted, _ramp(self._tenths, self.target_speed * 10, settings.acceleration))

    def _must_brake_before(self, wanted: MotorDirection, brake_duration: int) -> bool:
        """Whether a reversal needs more braking; the duration is in updates of 10 ms.

        Inferred: earlier braking counts, and a motor that continues in its direction needs none.
        """
        return self._driven is wanted.opposite and self._braked < brake_duration

    def _brake(self, duty: int) -> None:
        self._output(MotorDirection.BRAKE, duty * 10)
        self._braked += 1

    def _output(self, direction: MotorDirection, tenths: int) -> None:
        self.direction = direction
        self._tenths = tenths
        if direction is not MotorDirection.BRAKE:
            self._driven = direction
            self._braked = 0


class AuxiliaryMotor:
    """The third output: one direction, without brake (inferred) and current sensing."""

    def __init__(self) -> None:
        self.target_speed = 0
        self._tenths = 0

    @property
    def speed(self) -> int:
        """The speed, 0-127."""
        return self._tenths // 10

    def set(self, speed: int) -> None:
        self.target_speed = speed
        self._tenths = speed * 10

    def accelerate(self, speed: int) -> None:
        self.target_speed = speed

    def update(self, acceleration: int) -> None:
        """Do one update of 10 ms."""
        self._tenths = _ramp(self._tenths, self.target_speed * 10, acceleration)


def _ramp(tenths: int, target: int, acceleration: int) -> int:
    """Return the speed after one update, all in tenths of a count; 0 is no ramp."""
    if acceleration == 0 or tenths >= target:
        return target  # no deceleration
    return min(tenths + acceleration, target)
