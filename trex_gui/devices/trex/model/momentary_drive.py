"""Controls that drive motors while they are held."""

import math
from collections.abc import Iterable
from enum import Enum

from PySide6.QtCore import QObject, Slot

from trex_gui.devices.trex.model.motors import Motors
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.ui.runtime import new_timer, now

GROWTH = 127.0  # speed steps per second; full speed takes one second (inferred)
_UPDATE_MS = 20


class MomentaryDrive(QObject):
    """Drives the motors with forward and turn values, as holder `name`.

    Speeds increase by at most `GROWTH` per second, so a tapped key causes no jump. They decrease
    immediately.
    """

    def __init__(self, motors: Motors, name: str) -> None:
        super().__init__(motors)
        self._motors = motors
        self.name = name
        self.joint = False  # both drivers power one motor
        self._direction = 0.0, 0.0  # forward and turn, each -1 to 1
        self._speeds = 0.0, 0.0
        self._updated_at = -math.inf
        self._timer = new_timer(self, _UPDATE_MS, self._update_speeds)
        motors.holder_changed.connect(self._on_holder_changed)

    @property
    def held(self) -> bool:
        return self._motors.holder == self.name

    @property
    def can_turn(self) -> bool:
        return not (self.joint or self._motors.linked)

    def steer(self, forward: float, turn: float) -> bool:
        """Set forward and turn values, each -1 to 1. Return whether the motors were acquired."""
        if not self._motors.acquire(self.name):
            return False
        self._direction = forward, turn
        self._timer.start()
        self._update_speeds()
        return True

    @Slot()
    def _update_speeds(self) -> None:
        """Approach the requested speeds. A late timer causes no jump."""
        forward, turn = self._direction
        ceiling = self._motors.ceiling_in_force
        goal: tuple[float, float] = mix(forward, turn if self.can_turn else 0.0, ceiling)
        seconds = min(now() - self._updated_at, 2 * _UPDATE_MS / 1000)
        self._updated_at = now()
        self._speeds = next_speeds(self._speeds, goal, GROWTH * seconds)
        if self._speeds == goal:
            self._timer.stop()
        left, right = map(round, self._speeds)
        if self.can_turn:
            self._motors.set_speeds(left, right, self.name)
        else:
            self._motors.set_speed(1, left, self.name)

    @Slot()
    def _on_holder_changed(self) -> None:
        if not self.held:
            self._timer.stop()
            self._speeds = 0.0, 0.0

    def release(self) -> None:
        self._motors.release(self.name)

    def abort(self, reason: str) -> None:
        self._motors.abort(self.name, reason)


def next_speeds(
    speeds: tuple[float, float], goal: tuple[float, float], limit: float
) -> tuple[float, float]:
    """Return the next speeds on the way to the goal.

    Speeds increase by at most `limit` and in proportion to each other, so the robot stays on its
    curve. They decrease immediately. A speed drops to zero if its direction changes.
    """
    left, right = (
        math.copysign(min(abs(speed), abs(target)), target) if speed * target > 0 else 0.0
        for speed, target in zip(speeds, goal, strict=True)
    )
    growth = max(abs(goal[0] - left), abs(goal[1] - right))
    if growth <= limit:
        return goal
    fraction = limit / growth
    return left + fraction * (goal[0] - left), right + fraction * (goal[1] - right)


def mix(forward: float, turn: float, ceiling: int = FULL_SCALE) -> tuple[int, int]:
    """Return the speeds of motors 1 (left) and 2 (right).

    The board adds and subtracts its channels in the same way, and clips each result (inferred).
    Here, if a result exceeds full speed, both speeds are reduced in proportion. `forward` and
    `turn` are -1 to 1. `ceiling` (1 to 127) is the speed at full deflection.
    """
    left, right = forward + turn, forward - turn
    scale = ceiling / max(1.0, abs(left), abs(right))
    return round(left * scale), round(right * scale)


TURN_WHILE_DRIVING = 0.5  # turn value while driving forward or back; at 1.0, one side would stop


class Heading(Enum):
    """Forward and turn values of a key. Forward and right are positive."""

    FORWARD = 1, 0
    BACK = -1, 0
    LEFT = 0, -1
    RIGHT = 0, 1


def keys_setpoint(held: Iterable[Heading]) -> tuple[float, float]:
    """Return the forward and turn values of held keys. Opposite keys cancel each other."""
    headings = set(held)
    forward, turn = (sum(heading.value[axis] for heading in headings) for axis in (0, 1))
    return float(forward), turn * (TURN_WHILE_DRIVING if forward else 1.0)
