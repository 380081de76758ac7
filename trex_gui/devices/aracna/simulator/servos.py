"""AX servos: position, goal, speed, and faults.

Ref: Robotis AX-12 and AX-18 documentation. A restart of the board does not affect them.
"""

import math
from collections import Counter
from enum import Enum

from trex_gui.devices.aracna.protocol.joints import CEILING, HIGHEST, UNITS_PER_SECOND

FAILED = -1  # value that the board's library returns for a servo without reply
_EPSILON = 1e-9  # seconds; tolerance for the rounding of summed times


class Register(Enum):
    SPEED = "speed"
    MOVING = "moving"
    POSITION = "position"


class Servo:
    """One servo.

    Attributes:
        alive: whether the servo responds. A dead servo stops, and continues its motion when it is
            alive again (assumed).
    """

    def __init__(self, position: float = 512) -> None:
        self.position = float(position)  # in units; a fraction while it moves
        self.goal = round(position)  # last accepted goal, 0-1023
        self.speed = 0  # speed register, 0-1023; 0 is the highest speed
        self.torque = False  # whether the servo holds; off from power-up to the first goal
        self.powered = True
        self.alive = True
        self.blocked = False  # blocked from outside: stays "moving" until free
        self.load = 0.0  # share by which the load reduces the speed, 0-1
        self.to_fail: Counter[Register] = Counter()  # number of reads of a register that fail next

    def write_goal(self, value: int) -> None:
        """Write a goal. A value above 1023 is rejected."""
        if self.answers and 0 <= value <= HIGHEST:
            self.goal = value
            self.torque = True

    def write_speed(self, value: int) -> None:
        """Write a speed. A value above 1023 is rejected."""
        if self.answers and 0 <= value <= HIGHEST:
            self.speed = value

    def read(self, register: Register) -> int:
        """Return the value of a register, or -1 for no reply."""
        if not self.answers:
            return FAILED
        if self.to_fail[register] > 0:
            self.to_fail[register] -= 1
            return FAILED
        if register is Register.SPEED:
            return self.speed
        if register is Register.MOVING:
            return int(self.moving)
        return round(self.position)

    @property
    def answers(self) -> bool:
        return self.powered and self.alive

    @property
    def moving(self) -> bool:
        """Return whether the goal is not reached, even if the servo is blocked or dead.

        The compliance margin is 0. Ref: AX-12 control table; the firmware never writes it.
        """
        return self.torque and self.goal != self.position

    @property
    def rate(self) -> float:
        """Units per second in motion. 0 while the servo cannot move."""
        if not self.answers or self.blocked:
            return 0.0
        speed = min(self.speed or CEILING, CEILING)
        return UNITS_PER_SECOND * speed * (1 - self.load)

    @property
    def remaining(self) -> float:
        """Seconds until the servo stops. Infinite while it cannot move."""
        if not self.moving:
            return 0.0
        return abs(self.goal - self.position) / self.rate if self.rate else math.inf

    def advance(self, seconds: float) -> None:
        if not self.moving:
            return
        if seconds >= self.remaining - _EPSILON:
            self.position = float(self.goal)
        else:
            self.position += math.copysign(self.rate * seconds, self.goal - self.position)

    def set_power(self, *, on: bool) -> None:
        """Switch servo power. Without it, all but the position is lost."""
        if self.powered and not on:
            self.speed = 0
            self.torque = False
            self.goal = min(max(round(self.position), 0), HIGHEST)
        self.powered = on
