"""Positions and speeds of the AX servos, in their units, in degrees and in seconds.

Ref: Robotis AX-12 and AX-18 documentation.
"""

import math

MOTORS = 8
HIGHEST = 1023
"""The highest position, and the highest speed setting."""

DEGREES_PER_UNIT = 300 / 1023
"""A position of 0 is 0 degrees, 1023 is 300 degrees; 512 is the centre."""

UNITS_PER_SECOND = 2.28
"""Position units a second for each unit of speed: 0.1114 rpm."""

DEGREES_PER_SECOND = 0.669
"""Degrees a second for each unit of speed."""

CEILING = 870
"""The speed above which a setting has no further effect: 97 rpm, no load, AX-18A at 12 V.

The published CAD of the robot uses AX-18A. An AX-12A ends at 59 rpm, a setting of about 530.
"""


def degrees(position: float) -> float:
    """Return a position (0-1023) in degrees (0-300)."""
    return position * DEGREES_PER_UNIT


def position(angle: float) -> int:
    """Return an angle in degrees as the nearest position, not limited to 0-1023."""
    return round(angle / DEGREES_PER_UNIT)


def degrees_per_second(speed: int) -> float | None:
    """Return a speed setting in degrees a second; `None` for 0, which is as fast as it can."""
    return speed * DEGREES_PER_SECOND if speed else None


def travel_seconds(distance: int, speed: int, ceiling: int = CEILING) -> float:
    """Return how long a servo needs for a distance in position units, without load.

    A speed of 0 is as fast as it can, as is any above the ceiling.
    """
    return abs(distance) / (UNITS_PER_SECOND * min(speed or ceiling, ceiling))


def speed_for(distance: int, seconds: float) -> int:
    """Return the lowest speed (1-1023) at which a distance takes no longer than so many seconds.

    Where none is fast enough it is the highest; where there is no distance, the lowest.
    """
    if seconds <= 0:
        return HIGHEST if distance else 1
    wanted = math.ceil(abs(distance) / (UNITS_PER_SECOND * seconds) - 1e-9)
    return min(max(wanted, 1), HIGHEST)
