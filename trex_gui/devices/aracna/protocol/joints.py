"""Places of the eight joints on the robot, joint limits, and units of the servos.

Ref: CreativeMachinesLab/aracna `RobotPi/RobotPi.py` (even motors are inner joints),
`RobotPi/PiConstants.py` (limits tuned on the robot), `RobotPi/SineModel.py` (places of the legs,
given for the nine-motor ancestor QuadraTot and assumed for Aracna); Robotis AX-12 and AX-18
documentation (units).
"""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import tr, tr_noop

MOTORS = 8
HIGHEST = 1023  # highest position and highest speed setting
CENTER = 512  # middle of a servo's travel, 150 degrees
DEGREES_PER_UNIT = 300 / 1023
UNITS_PER_SECOND = 2.28  # position units per second for each unit of speed (0.1114 rpm)
DEGREES_PER_SECOND = 0.669  # degrees per second for each unit of speed
MAX_EFFECTIVE_SPEED = 870
"""Highest effective speed setting: 97 rpm for an AX-18A at 12 V without load.

The published CAD model of the robot has AX-18A servos. An AX-12A reaches 59 rpm, a setting of about
530."""

LEGS = tr_noop("Front left"), tr_noop("Front right"), tr_noop("Back right"), tr_noop("Back left")
"""Names of the legs, each with two motors (inner and outer joint), in motor order.

Assumed: motors 0-3 are at the front, 4-7 at the back, 2-5 on the right, and 6, 7, 0 and 1 on
the left.
"""


@dataclass(frozen=True, slots=True)
class Limits:
    """Lowest and highest position of a joint, 0-1023. Raises BadRequest if invalid."""

    low: int = 0
    high: int = HIGHEST

    def __post_init__(self) -> None:
        if not 0 <= self.low <= self.high <= HIGHEST:
            raise BadRequest(
                tr("limits must be 0 to {0}, the lower one first, not {1} to {2}").format(
                    HIGHEST, self.low, self.high
                )
            )

    def clamp(self, position: float) -> int:
        return min(max(round(position), self.low), self.high)

    def allows(self, position: int) -> bool:
        return self.low <= position <= self.high


FACTORY_LIMITS = (Limits(50, 600), Limits(0, 550))
"""Limits of the inner and outer joints.

They protect the body and the screws, but the legs can still collide with each other.
"""


def factory_limits(motors: int = MOTORS) -> tuple[Limits, ...]:
    return tuple(FACTORY_LIMITS[motor % 2] for motor in range(motors))


def clamp(goals: Iterable[float], limits: Sequence[Limits]) -> tuple[int, ...]:
    """Return the nearest allowed goals. Without limits, a motor's goal is only rounded."""
    count = len(limits)
    return tuple(
        limits[motor].clamp(goal) if motor < count else round(goal)
        for motor, goal in enumerate(goals)
    )


def degrees(position: float) -> float:
    return position * DEGREES_PER_UNIT


def position(angle: float) -> int:
    """Convert degrees to a position, which may be outside 0-1023."""
    return round(angle / DEGREES_PER_UNIT)


def degrees_per_second(speed: int) -> float | None:
    return speed * DEGREES_PER_SECOND if speed else None


def travel_seconds(distance: int, speed: int, max_speed: int = MAX_EFFECTIVE_SPEED) -> float:
    """Return the seconds that a servo without load needs for a distance in units."""
    return abs(distance) / (UNITS_PER_SECOND * min(speed or max_speed, max_speed))


def speed_for(distance: int, seconds: float) -> int:
    """Return the lowest speed (1-1023) that suffices, or 1023 if every speed is too low."""
    if seconds <= 0:
        return HIGHEST if distance else 1
    needed = math.ceil(abs(distance) / (UNITS_PER_SECOND * seconds) - 1e-9)
    return min(max(needed, 1), HIGHEST)
