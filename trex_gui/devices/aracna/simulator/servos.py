"""Eight AX servos on their own bus: where they are, where they go, and how fast.

Ref: Robotis AX-12 and AX-18 documentation. They know nothing of the board: its restart leaves
them as they are. What is assumed says so.
"""

import math
from collections import Counter
from enum import Enum

from trex_gui.devices.aracna.protocol.units import CEILING, HIGHEST, UNITS_PER_SECOND

FAILED = -1
"""What the board's library gives for a servo that did not answer."""

MARGIN = 2
"""Units off its goal at which a servo is content, unless it is told otherwise. Assumed: the
document says "some"."""

_EPSILON = 1e-9  # seconds; swallows the rounding of summed times


class Register(Enum):
    """What the firmware reads from a servo."""

    SPEED = "speed"
    MOVING = "moving"
    POSITION = "position"


class Servo:
    """One servo.

    Attributes:
        position: where it is, in units; a fraction while it moves.
        goal: the last goal it accepted, 0-1023.
        speed: its speed register, 0-1023; 0 is as fast as it can.
        torque: whether it holds; off from power-up to the first goal.
        powered: whether it has servo power.
        alive: whether it hears and answers. One that is dead stands still, and goes on with
            what it had when it is alive again (assumed).
        blocked: whether something holds it: then it stays "moving" until it is free.
        load: the part of its speed that it loses, 0 (nothing) to 1 (it stands).
        margin: units off its goal at which it is content.
        ceiling: the speed above which a setting has no further effect.
        lag: seconds between a goal and the moving flag; real ones may have some, these have none
            unless a test wants it.
        to_fail: how many of the next readings of a register fail.
    """

    def __init__(self, position: float = 512, margin: int = MARGIN, ceiling: int = CEILING) -> None:
        self.position = float(position)
        self.goal = round(position)
        self.speed = 0
        self.torque = False
        self.powered = True
        self.alive = True
        self.blocked = False
        self.load = 0.0
        self.margin = margin
        self.ceiling = ceiling
        self.lag = 0.0
        self.to_fail: Counter[Register] = Counter()
        self._since_goal = math.inf

    # What the board sees

    def write_goal(self, value: int) -> None:
        """Take a goal; one above 1023 is refused and changes nothing."""
        if self.answers and 0 <= value <= HIGHEST:
            self.goal = value
            self.torque = True
            self._since_goal = 0.0

    def write_speed(self, value: int) -> None:
        """Take a speed; one above 1023 is refused and changes nothing."""
        if self.answers and 0 <= value <= HIGHEST:
            self.speed = value

    def read(self, register: Register) -> int:
        """Return what a register holds, or -1 for no answer."""
        if not self.answers:
            return FAILED
        if self.to_fail[register] > 0:
            self.to_fail[register] -= 1
            return FAILED
        if register is Register.SPEED:
            return self.speed
        if register is Register.MOVING:
            return int(self.moving and self._since_goal >= self.lag)
        return round(self.position)

    @property
    def answers(self) -> bool:
        """Whether it takes part in what happens on the bus."""
        return self.powered and self.alive

    # What it is and does

    @property
    def moving(self) -> bool:
        """Whether it is on its way; one that is blocked or dead in mid-motion still is."""
        return self.torque and abs(self.goal - self.position) > self.margin

    @property
    def rate(self) -> float:
        """Units a second at which it moves when it moves; 0 while it cannot."""
        if not self.answers or self.blocked:
            return 0.0
        speed = min(self.speed or self.ceiling, self.ceiling)
        return UNITS_PER_SECOND * speed * (1 - self.load)

    @property
    def remaining(self) -> float:
        """Seconds until it is content; infinite while it cannot move."""
        if not self.moving:
            return 0.0
        distance = abs(self.goal - self.position) - self.margin
        return distance / self.rate if self.rate else math.inf

    def advance(self, seconds: float) -> None:
        """Let time pass."""
        self._since_goal += seconds
        if not self.moving:
            return
        if seconds >= self.remaining - _EPSILON:
            side = math.copysign(self.margin, self.position - self.goal)
            self.position = self.goal + side
        else:
            self.position += math.copysign(self.rate * seconds, self.goal - self.position)

    def set_power(self, *, on: bool) -> None:
        """Switch servo power: without it everything but the position is lost."""
        if self.powered and not on:
            self.speed = 0
            self.torque = False
            self.goal = min(max(round(self.position), 0), HIGHEST)
        self.powered = on
