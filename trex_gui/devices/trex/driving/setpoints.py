"""What the motors shall do, between a hand that moves fast and a line that is slow."""

from collections.abc import Sequence
from dataclasses import dataclass, field

from trex_gui.devices.trex.protocol.commands import Command, DriveAuxiliary, DriveBoth, DriveMotor
from trex_gui.devices.trex.session.messages import MotorRequest, SetAuxiliary, SetMotor, SetMotors


@dataclass(slots=True)
class SetpointSlots:
    """One slot a motor: the newest wish waits, an older one is forgotten."""

    _motors: dict[int, SetMotor] = field(default_factory=dict)
    _auxiliary: SetAuxiliary | None = None

    def put(self, request: MotorRequest) -> None:
        """Take each wish in place of the one that waits for the same motor."""
        for wish in setpoints_in(request):
            if isinstance(wish, SetAuxiliary):
                self._auxiliary = wish
            else:
                self._motors[wish.motor] = wish

    def put_all(self, wishes: Sequence[SetMotor | SetAuxiliary]) -> None:
        """Take several wishes, each as by `put`."""
        for wish in wishes:
            self.put(wish)

    def clear(self) -> None:
        """Forget every wish."""
        self._motors.clear()
        self._auxiliary = None

    def __bool__(self) -> bool:
        return bool(self._motors) or self._auxiliary is not None

    def take(self) -> list[SetMotor | SetAuxiliary]:
        """Return the wishes, motors first, and forget them."""
        wishes: list[SetMotor | SetAuxiliary] = [self._motors[m] for m in sorted(self._motors)]
        if self._auxiliary is not None:
            wishes.append(self._auxiliary)
        self.clear()
        return wishes

    def put_back(self, wishes: Sequence[SetMotor | SetAuxiliary]) -> None:
        """Let wishes wait again whose packets were damaged, unless newer ones have come."""
        for wish in wishes:
            if isinstance(wish, SetAuxiliary):
                self._auxiliary = self._auxiliary or wish
            else:
                self._motors.setdefault(wish.motor, wish)


def setpoints_in(request: MotorRequest) -> Sequence[SetMotor | SetAuxiliary]:
    """Return what is asked of each motor, one wish a motor."""
    return request.drives if isinstance(request, SetMotors) else (request,)


def packets(wishes: Sequence[SetMotor | SetAuxiliary]) -> list[Command[None]]:
    """Return the fewest commands that say all of these wishes, at most one for each motor."""
    motors = [wish for wish in wishes if isinstance(wish, SetMotor)]
    commands: list[Command[None]] = []
    if len(motors) == 2 and motors[0].accelerate == motors[1].accelerate:
        first, second = sorted(motors, key=lambda wish: wish.motor)
        commands.append(DriveBoth(first.drive, second.drive, first.accelerate))
    else:
        commands += [DriveMotor(wish.motor, wish.drive, wish.accelerate) for wish in motors]
    commands += [
        DriveAuxiliary(wish.speed, wish.accelerate)
        for wish in wishes
        if isinstance(wish, SetAuxiliary)
    ]
    return commands
