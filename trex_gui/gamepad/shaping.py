"""From where a stick stands to what is wished: dead zone and expo. Pure."""

import math

WIDEST_DEAD_ZONE = 0.5
REST = 0.05
"""What counts as at rest at least, of the way to an end, however small the dead zone is.

Inferred: sticks settle within a few hundredths of where they were.
"""


def shape(value: float, dead_zone: float, expo: float) -> float:
    """Return the wish (-1 to 1) of an axis at `value` (-1 to 1).

    Args:
        value: where the axis stands; beyond its ends it is at its end.
        dead_zone: 0 to `WIDEST_DEAD_ZONE` of the way to an end that count for nothing. Behind it
            the wish begins at 0, so that nothing jumps there.
        expo: 0 (in proportion) to 1 (the cube): how much finer the middle is than the ends.
    """
    reach = min(1.0, abs(value))
    if reach <= dead_zone:
        return 0.0
    reach = (reach - dead_zone) / (1.0 - dead_zone)
    return math.copysign((1.0 - expo) * reach + expo * reach**3, value)


def is_at_rest(value: float, dead_zone: float) -> bool:
    """Whether nobody touches this axis, as far as its place tells."""
    return abs(value) <= max(dead_zone, REST)
