"""Where the joints and feet of the drawn robot lie: a sketch, no kinematics.

Nothing published says how a servo's angle turns a leg of this robot. So every angle is drawn flat,
made smaller so that legs do not cover each other, and mirrored so that equal numbers look alike.
"""

import math
from dataclasses import dataclass

from trex_gui.devices.aracna.protocol.joints import JOINTS, Side
from trex_gui.devices.aracna.protocol.units import degrees

_OUTWARD = {
    Side.RIGHT_FRONT: 45.0,
    Side.LEFT_FRONT: 135.0,
    Side.LEFT_BACK: 225.0,
    Side.RIGHT_BACK: 315.0,
}
"""Degrees anticlockwise from the right, the front up."""

_MIRROR = {Side.RIGHT_FRONT: 1, Side.LEFT_FRONT: -1, Side.LEFT_BACK: 1, Side.RIGHT_BACK: -1}

_CENTRE = 150.0
_SHARE = 0.35
"""How much of a servo's angle is drawn."""

BODY = 0.24
"""Half the edge of the body; the picture goes from -1 to 1 both ways."""

_HIP = 0.26
_UPPER = 0.33
_LOWER = 0.34

Point = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Leg:
    """Places in the picture, x to the right and y down, -1 to 1: inner joint, outer joint, foot."""

    side: Side
    inner: Point
    outer: Point
    foot: Point


def legs(positions: tuple[float, ...]) -> tuple[Leg, ...]:
    """Return the legs whose two motors both have a position (units), in the order of motors."""
    return tuple(
        _leg(JOINTS[motor].side, positions[motor], positions[motor + 1])
        for motor in range(0, min(len(positions), len(JOINTS)) - 1, 2)
    )


def _leg(side: Side, inner: float, outer: float) -> Leg:
    outward, mirror = _OUTWARD[side], _MIRROR[side]
    hip = _along((0.0, 0.0), outward, _HIP * math.sqrt(2))
    first = outward + mirror * _SHARE * (degrees(inner) - _CENTRE)
    knee = _along(hip, first, _UPPER)
    second = first + mirror * _SHARE * (degrees(outer) - _CENTRE)
    return Leg(side, hip, knee, _along(knee, second, _LOWER))


def _along(start: Point, angle: float, length: float) -> Point:
    turn = math.radians(angle)
    return start[0] + length * math.cos(turn), start[1] - length * math.sin(turn)
