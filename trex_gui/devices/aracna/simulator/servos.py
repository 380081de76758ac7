"""AX servos: position, goal, speed, and faults.

Ref: Robotis AX-12 and AX-18 documentation. Servos keep moving during a restart of the board.
"""

import math
from collections import Counter
from enum import Enum

from trex_gui.devices.aracna.protocol.joints import HIGHEST, MAX_EFFECTIVE_SPEED, UNITS_PER_SECOND

FAILED = -1  # value in the firmware's library for a servo that did not reply
_EPSILON = 1e-9  # seconds; absorbs the rounding of summed times


class Register(Enum):
    SPEED = "speed"
    MOVING = "moving"
    POSITION = "position"


class Servo:
    """AX servo. It stops while `alive` is False, then continues its motion (assumed)."""

    def __init__(self, position: float = 512) -> None:
        self.position = float(position)  # in units, with a fraction while it moves
        self.goal = round(position)  # last accepted goal, 0-1023
        self.speed = 0  # speed register, 0-1023; 0 is the highest speed
        self.torque = False  # off from power-up to the first goal
        self.powered = True
        self.alive = True
        self.blocked = False  # a blocked servo stays "moving"
        self.load = 0.0  # fraction by which the load reduces the speed, 0-1
        self.to_fail: Counter[Register] = Counter()  # register → number of upcoming reads that fail

    def write_goal(self, value: int) -> None:
        """Write a goal, unless it is above 1023."""
        if self.answers and 0 <= value <= HIGHEST:
            self.goal = value
            self.torque = True

    def write_speed(self, value: int) -> None:
        """Write a speed, unless it is above 1023."""
        if self.answers and 0 <= value <= HIGHEST:
            self.speed = value

    def read(self, register: Register) -> int:
        """Return the value of a register, or -1 if the servo does not reply."""
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
        """True until the goal is reached, even if the servo is blocked or dead.

        The compliance margin is 0, because the firmware never writes it. Ref: AX-12 control table.
        """
        return self.torque and self.goal != self.position

    @property
    def rate(self) -> float:
        """Speed in units per second, 0 if the servo cannot move."""
        if not self.answers or self.blocked:
            return 0.0
        speed = min(self.speed or MAX_EFFECTIVE_SPEED, MAX_EFFECTIVE_SPEED)
        return UNITS_PER_SECOND * speed * (1 - self.load)

    @property
    def remaining(self) -> float:
        """Seconds until the servo stops, infinite if it cannot move."""
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
        """Switch servo power. Without power, the servo loses everything but its position."""
        if self.powered and not on:
            self.speed = 0
            self.torque = False
            self.goal = min(max(round(self.position), 0), HIGHEST)
        self.powered = on
