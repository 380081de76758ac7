"""What the motors shall do, between a hand that moves fast and a line that is slow."""

from dataclasses import dataclass, field

from trex_gui.link.client import Requester
from trex_gui.link.messages import SetAuxiliary, SetDrive
from trex_gui.protocol.commands import (
    STOP,
    Command,
    DriveAuxiliary,
    DriveBoth,
    DriveMotor,
)


@dataclass(slots=True)
class DriveSlots:
    """One slot a motor: the newest wish waits, an older one is forgotten."""

    _motors: dict[int, SetDrive] = field(default_factory=dict)
    _auxiliary: SetAuxiliary | None = None

    def put(self, wish: SetDrive | SetAuxiliary) -> None:
        """Take a wish in place of the one that waits for the same motor."""
        if isinstance(wish, SetAuxiliary):
            self._auxiliary = wish
        else:
            self._motors[wish.motor] = wish

    def clear(self) -> None:
        """Forget every wish."""
        self._motors.clear()
        self._auxiliary = None

    def __bool__(self) -> bool:
        return bool(self._motors) or self._auxiliary is not None

    def take(self) -> list[Command[None]]:
        """Return the fewest packets that say it all, and forget the wishes."""
        motors = list(self._motors.values())
        auxiliary = self._auxiliary
        self.clear()
        commands: list[Command[None]] = []
        if len(motors) == 2 and motors[0].accelerate == motors[1].accelerate:
            first, second = sorted(motors, key=lambda wish: wish.motor)
            commands.append(DriveBoth(first.drive, second.drive, first.accelerate))
        else:
            commands += [DriveMotor(wish.motor, wish.drive, wish.accelerate) for wish in motors]
        if auxiliary is not None:
            commands.append(DriveAuxiliary(auxiliary.speed, auxiliary.accelerate))
        return commands


def stop_motors(request: Requester) -> None:
    """Brake both motors fully and switch the auxiliary motor off.

    Raises:
        PortUnavailable: the line is gone.
    """
    for command in STOP:
        request(command)
