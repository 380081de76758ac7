"""The toy robot on the desk: its power, servos and cable, for those without hardware."""

from enum import Enum

from PySide6.QtCore import QObject

from trex_gui.devices.aracna.model.demo_snapshot import RobotSnapshot, read_snapshot
from trex_gui.ui.devices.demo_device import DemoDevice, switch
from trex_gui.ui.devices.simulator_process import Simulator

PASSING = 6
"""Bytes of an answer that pass before it is cut: `.c`, a position, its comma."""


class Loss(Enum):
    """What may get lost on the wire, once; the value is the rest of the control line."""

    ANSWER_BYTE = "drop 1"
    COMMAND_BYTE = "drop 1 sent"
    ANSWER_END = f"cut {PASSING}"


class DemoRobot(DemoDevice[RobotSnapshot]):
    """A simulated Aracna, and the hands of whoever has none."""

    def __init__(self, simulator: Simulator, parent: QObject | None = None) -> None:
        super().__init__(simulator, read_snapshot, parent)

    def restart(self) -> None:
        """Pull the board's reset line; its servos do not notice."""
        self._order("reset")

    def set_servo_power(self, on: bool) -> None:
        """Switch the power of the servos alone: without it nothing moves nor holds."""
        self._order(f"servo power {switch(on)}")

    def set_dead(self, motor: int, dead: bool) -> None:
        """Let a servo neither hear nor answer, or be as before."""
        self._order(f"servo {motor} {'dead' if dead else 'alive'}")

    def set_blocked(self, motor: int, blocked: bool) -> None:
        """Hold a servo where it is, or let it go."""
        self._order(f"servo {motor} {'block' if blocked else 'free'}")

    def set_load(self, motor: int, part: float) -> None:
        """Let a servo lose this part of its speed, 0 (nothing) to 1 (it stands)."""
        self._steer(f"load {motor}", f"servo {motor} load {part:.2f}")

    def lose(self, loss: Loss) -> None:
        """Let something get lost, once, of what is said next."""
        self._order(f"line {loss.value}")

    def mend(self) -> None:
        """Make servos and wire whole again, and switch everything on.

        A cable that is out stays out; where servos are and what they hold stays as well.
        """
        self._forget_wishes()
        for motor in range(len(self._snapshot.servos) if self._snapshot is not None else 0):
            self.set_dead(motor, dead=False)
            self.set_blocked(motor, blocked=False)
            self.set_load(motor, 0)
        self.set_mute(False)
        self.set_noise(0)
        for line in ("line drop 0", "line drop 0 sent", "line cut off", "power on"):
            self._order(line)
