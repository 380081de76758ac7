"""The eight joints, their places on the robot, and their limits.

Ref: CreativeMachinesLab/aracna `RobotPi/RobotPi.py` (even motors are inner joints),
`RobotPi/PiConstants.py` (limits tuned on the robot), `RobotPi/SineModel.py` (which leg is where,
given only for the nine-motor ancestor QuadraTot: assumed for Aracna).
"""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum

from trex_gui.core.errors import BadRequest
from trex_gui.devices.aracna.protocol.units import HIGHEST, MOTORS


class JointKind(Enum):
    INNER = "inner"
    OUTER = "outer"


class Side(Enum):
    """Which leg, seen from above with the front up."""

    LEFT_FRONT = "front left"
    RIGHT_FRONT = "front right"
    RIGHT_BACK = "back right"
    LEFT_BACK = "back left"


@dataclass(frozen=True, slots=True)
class Joint:
    """One joint and its motor (0-7); `side` is assumed, `kind` is documented."""

    motor: int
    kind: JointKind
    side: Side


_SIDES = (Side.LEFT_FRONT, Side.RIGHT_FRONT, Side.RIGHT_BACK, Side.LEFT_BACK)
"""Motors 0-3 are in front and 4-7 at the back, 2-5 right and 6, 7, 0, 1 left."""

JOINTS = tuple(
    Joint(motor, JointKind.OUTER if motor % 2 else JointKind.INNER, _SIDES[motor // 2])
    for motor in range(MOTORS)
)


@dataclass(frozen=True, slots=True)
class Limits:
    """Lowest and highest position of a joint, 0-1023; BadRequest if they are not in order."""

    low: int = 0
    high: int = HIGHEST

    def __post_init__(self) -> None:
        if not 0 <= self.low <= self.high <= HIGHEST:
            raise BadRequest(f"limits are 0 to {HIGHEST} in order, not {self.low} to {self.high}")

    def crop(self, position: float) -> int:
        return min(max(round(position), self.low), self.high)

    def allow(self, position: int) -> bool:
        return self.low <= position <= self.high


FACTORY_LIMITS = {JointKind.INNER: Limits(50, 600), JointKind.OUTER: Limits(0, 550)}
"""They keep a joint from hitting body and screws; legs can still collide."""


def factory_limits(motors: int = MOTORS) -> tuple[Limits, ...]:
    """Return the limits tuned on the robot, one for each motor."""
    return tuple(
        FACTORY_LIMITS[JointKind.OUTER if motor % 2 else JointKind.INNER] for motor in range(motors)
    )


def crop(goals: Sequence[float], limits: Sequence[Limits]) -> tuple[int, ...]:
    """Return the nearest allowed goals; a motor without limits keeps its goal."""
    known = len(limits)
    return tuple(
        limits[motor].crop(goal) if motor < known else round(goal)
        for motor, goal in enumerate(goals)
    )
