"""Positions and speeds of the AX servos in their units, in degrees and in seconds.

Ref: Robotis AX-12 and AX-18 documentation.
"""

import math

MOTORS = 8
HIGHEST = 1023  # the highest position and the highest speed setting
CENTRE = 512  # the middle of a servo's travel, 150 degrees
DEGREES_PER_UNIT = 300 / 1023
UNITS_PER_SECOND = 2.28  # position units per second for each unit of speed (0.1114 rpm)
DEGREES_PER_SECOND = 0.669  # degrees per second for each unit of speed
CEILING = 870
"""The speed above which a setting has no further effect: 97 rpm, no load, AX-18A at 12 V.

The published CAD of the robot uses AX-18A. An AX-12A ends at 59 rpm, a setting of about 530.
"""


def degrees(position: float) -> float:
    """Convert a position (0-1023) to degrees (0-300)."""
    return position * DEGREES_PER_UNIT


def position(angle: float) -> int:
    """Convert degrees to the nearest position, not limited to 0-1023."""
    return round(angle / DEGREES_PER_UNIT)


def degrees_per_second(speed: int) -> float | None:
    """Convert a speed setting; `None` for 0, which means unlimited."""
    return speed * DEGREES_PER_SECOND if speed else None


def travel_seconds(distance: int, speed: int, ceiling: int = CEILING) -> float:
    """Return the time for a distance in position units without load; speed 0 is unlimited."""
    return abs(distance) / (UNITS_PER_SECOND * min(speed or ceiling, ceiling))


def speed_for(distance: int, seconds: float) -> int:
    """Return the lowest speed (1-1023) that covers a distance in time, else the highest."""
    if seconds <= 0:
        return HIGHEST if distance else 1
    needed = math.ceil(abs(distance) / (UNITS_PER_SECOND * seconds) - 1e-9)
    return min(max(needed, 1), HIGHEST)
