"""Requests to the motor output, its reports, and the packets of setpoints."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

from trex_gui.devices.trex.protocol.commands import Command, DriveAuxiliary, DriveBoth, DriveMotor
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.errors import ErrorCode

HEARTBEAT_INTERVAL = 0.1  # seconds between two heartbeats while motors are armed


@dataclass(frozen=True, slots=True)
class SetMotor:
    """Setpoint of motor 1 or 2."""

    motor: int
    drive: Drive
    accelerate: bool = False


@dataclass(frozen=True, slots=True)
class SetMotors:
    """Setpoints of both motors, sent in one packet: neither begins before the other."""

    drives: tuple[SetMotor, SetMotor]


@dataclass(frozen=True, slots=True)
class SetAuxiliary:
    """Setpoint of the auxiliary motor, 0-127."""

    speed: int
    accelerate: bool = False

    motor: ClassVar = 3  # number of the channel that drives it


@dataclass(frozen=True, slots=True)
class Stop:
    """Stop every motor before anything else is sent. Its `Outcome` is its confirmation.

    Setpoints are dropped until an `Arm`, and other motor commands are rejected.
    """

    id: int


@dataclass(frozen=True, slots=True)
class Arm:
    """Arm the motors until a `Stop`. Has no outcome.

    While they are armed, polling keeps the board's serial timeout from expiring. Without a
    `Heartbeat` or a setpoint for `Timeouts.heartbeat` seconds the motors are stopped and
    `MotorsStopped` is reported.
    """

    # `Connected.selection` of the intended board; the request has no effect on any other board
    selection: int = 0


@dataclass(frozen=True, slots=True)
class Heartbeat:
    """The window that armed the motors still responds. Due every `HEARTBEAT_INTERVAL` seconds."""

    sent: float | None = None  # time on the line's clock; `None`: time of receipt


@dataclass(frozen=True, slots=True)
class StopSent:
    """A stop was sent, requested or automatic. Its confirmation follows."""


@dataclass(frozen=True, slots=True)
class CommandsRepeated:
    """The line has damaged bytes: the last motor commands are sent again until it is quiet."""


@dataclass(frozen=True, slots=True)
class MotorsStopped:
    """The motors were stopped automatically, or an unconfirmed stop was confirmed at last."""

    reason: ErrorCode | None  # why they were stopped; `None` for a late confirmation
    confirmed: bool  # whether the board's status confirmed the stop
    board: int | None = None  # number of the board that caused it, if several are driven


Setpoint = SetMotor | SetAuxiliary
SetpointRequest = SetMotor | SetMotors | SetAuxiliary
MotorRequest = SetpointRequest | Stop | Arm | Heartbeat
MotorReport = MotorsStopped | StopSent | CommandsRepeated


def setpoints_in(request: SetpointRequest) -> Sequence[Setpoint]:
    return request.drives if isinstance(request, SetMotors) else (request,)


def is_idle(setpoint: Setpoint) -> bool:
    """True if a setpoint brings its motor to rest."""
    if isinstance(setpoint, SetAuxiliary):
        return not setpoint.speed
    return setpoint.drive.is_brake or not setpoint.drive.signed


def packets(setpoints: Sequence[Setpoint]) -> list[Command[None]]:
    """Return the fewest commands that carry these setpoints, at most one for each motor."""
    motors = [setpoint for setpoint in setpoints if isinstance(setpoint, SetMotor)]
    commands: list[Command[None]] = []
    if len(motors) == 2 and motors[0].accelerate == motors[1].accelerate:
        first, second = sorted(motors, key=lambda setpoint: setpoint.motor)
        commands.append(DriveBoth(first.drive, second.drive, first.accelerate))
    else:
        commands += [DriveMotor(one.motor, one.drive, one.accelerate) for one in motors]
    commands += [
        DriveAuxiliary(one.speed, one.accelerate)
        for one in setpoints
        if isinstance(one, SetAuxiliary)
    ]
    return commands
