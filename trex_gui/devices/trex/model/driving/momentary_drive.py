"""A control that drives both motors while it is held: pad or keys."""

from PySide6.QtCore import QObject

from trex_gui.devices.trex.model.driving.mixing import mix
from trex_gui.devices.trex.model.driving.motors import Motors


class MomentaryDrive(QObject):
    """Turns forward and turn into wishes under one name, and ends them when it is let go.

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
        """Stop and disarm: nobody can see any more what is held."""
        self._motors.abort(self._name, reason)
