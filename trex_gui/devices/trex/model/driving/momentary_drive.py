"""Driving both motors with a control that is held: forward and turn, mixing, held keys."""

from enum import Enum, auto

from PySide6.QtCore import QObject

from trex_gui.devices.trex.model.motors import Motors
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE


class MomentaryDrive(QObject):
    """Turns forward and turn into setpoints under one name, and ends them on release.

    Attributes:
        joint: both drivers work as one motor, so there is nothing to turn with.
    """

    def __init__(self, motors: Motors, name: str, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._motors = motors
        self._name = name
        self.joint = False

    @property
    def name(self) -> str:
        """What the motors know this control by."""
        return self._name

    @property
    def held(self) -> bool:
        """Whether the motors are this control's now."""
        return self._motors.holder == self._name

    @property
    def can_turn(self) -> bool:
        """Whether the motors may differ: not where they are linked or one."""
        return not (self.joint or self._motors.linked)

    def steer(self, forward: float, turn: float) -> bool:
        """Wish for -1 to 1 of the speed ceiling each way; return whether the motors are ours."""
        if not self._motors.acquire(self._name):
            return False
        ceiling = self._motors.ceiling_in_force
        left, right = mix(forward, turn if self.can_turn else 0.0, ceiling)
        if self.can_turn:
            self._motors.set_speeds(left, right, self._name)
        else:
            self._motors.set_speed(1, left, self._name)
        return True

    def let_go(self) -> None:
        """Brake what this control has driven; the motors stay armed."""
        self._motors.release(self._name)

    def lose(self, reason: str) -> None:
        """Stop and disarm: it is unknown whether the control is still held."""
        self._motors.abort(self._name, reason)


def mix(forward: float, turn: float, ceiling: int = FULL_SCALE) -> tuple[int, int]:
    """Return the speeds of motors 1 and 2 for -1 to 1 each way.

    Motor 1 is the left one: turning right (positive) adds to it. That is the board's own mixing
    of channels (forward plus turn, forward minus turn; inferred there, reference section 3), so a
    robot turns the same way by pad and by stick. Where a sum is beyond full speed both are made
    smaller in proportion: the robot keeps the requested curve, instead of losing it as
    by clipping. `ceiling` (1 to 127) is the speed of full deflection.
    """
    left, right = forward + turn, forward - turn
    scale = ceiling / max(1.0, abs(left), abs(right))
    return round(left * scale), round(right * scale)


TURN_WHILE_GOING = 0.5
"""How much turn is set while a key for forward or back is held, too.

With a full turn one side would stop; half of one leaves a curve that can be steered.
"""


class Heading(Enum):
    """What a key is for."""

    FORWARD = auto()
    BACK = auto()
    LEFT = auto()
    RIGHT = auto()


class HeldKeys:
    """The keys that are down; two for the same heading count once, opposite ones cancel."""

    def __init__(self) -> None:
        self._down: dict[int, Heading] = {}

    def press(self, key: int, heading: Heading) -> None:
        """Take a key that went down; `key` identifies it, whatever its name."""
        self._down[key] = heading

    def release(self, key: int) -> bool:
        """Take a key that went up; return whether it was one of those held."""
        return self._down.pop(key, None) is not None

    def clear(self) -> None:
        """Let go of all."""
        self._down.clear()

    def __bool__(self) -> bool:
        return bool(self._down)

    @property
    def setpoint(self) -> tuple[float, float]:
        """Forward and turn, -1 to 1 each; forward and right are positive."""
        forward = self._along(Heading.FORWARD, Heading.BACK)
        turn = self._along(Heading.RIGHT, Heading.LEFT)
        return forward, turn * TURN_WHILE_GOING if forward else turn

    def _along(self, there: Heading, back: Heading) -> float:
        held = set(self._down.values())
        return float((there in held) - (back in held))
