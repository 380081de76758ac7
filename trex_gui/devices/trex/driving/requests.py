"""Requests and reports of the motor output, and packets for setpoints."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

from trex_gui.devices.trex.protocol.commands import Command, DriveAuxiliary, DriveBoth, DriveMotor
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.errors import ErrorCode
from trex_gui.devices.trex.protocol.framing import Framing

HEARTBEAT_INTERVAL = 0.1  # seconds between heartbeats while motors are armed


@dataclass(frozen=True, slots=True)
class SetMotor:
    motor: int  # 1 or 2
    drive: Drive
    accelerate: bool = False


@dataclass(frozen=True, slots=True)
class SetMotors:
    """Setpoints of both motors in one packet, so that both start together."""

    drives: tuple[SetMotor, SetMotor]


@dataclass(frozen=True, slots=True)
class SetAuxiliary:
    speed: int  # 0-127
    accelerate: bool = False

    motor: ClassVar = 3  # number of the auxiliary motor


@dataclass(frozen=True, slots=True)
class Stop:
    """Request to stop all motors before anything else is sent. Its `Outcome` confirms the stop.

    Setpoints are dropped until the next `Arm`.
    """

    id: int


@dataclass(frozen=True, slots=True)
class Arm:
    """Request to arm the motors until the next `Stop`. It has no outcome.

    Without a `Heartbeat` or a setpoint for `Timeouts.heartbeat` seconds, the motors are stopped
    and `MotorsStopped` is reported.
    """

    selection: int = 0  # `Connected.selection` of the board; other boards ignore the request


@dataclass(frozen=True, slots=True)
class Heartbeat:
    """Sign that the window or program responds. Due every `HEARTBEAT_INTERVAL` seconds."""

    sent: float | None = None  # time on the line's clock; `None` for the time of receipt


@dataclass(frozen=True, slots=True)
class StopSent:
    """A requested or automatic stop was sent. The board has not confirmed it yet."""


@dataclass(frozen=True, slots=True)
class CommandsRepeated:
    """The line has damaged bytes, so setpoints are repeated until it is quiet."""


@dataclass(frozen=True, slots=True)
class MotorsStopped:
    """The motors were stopped automatically, or a stop was confirmed late."""

    reason: ErrorCode | None  # reason for the stop; `None` for a late confirmation
    confirmed: bool  # True if a status of the board confirmed the stop
    board: int | None = None  # number of the board that caused the stop of a group


Setpoint = SetMotor | SetAuxiliary
SetpointRequest = SetMotor | SetMotors | SetAuxiliary
MotorRequest = SetpointRequest | Stop | Arm | Heartbeat
MotorReport = MotorsStopped | StopSent | CommandsRepeated


def setpoints_in(request: SetpointRequest) -> Sequence[Setpoint]:
    return request.drives if isinstance(request, SetMotors) else (request,)


def is_valid(request: SetpointRequest) -> bool:
    """True if packets can encode the setpoints, which must be for different motors."""
    setpoints = setpoints_in(request)
    try:
        for command in packets(setpoints):
            Framing().encode(command)
    except (ValueError, OverflowError):  # `BadRequest` is a `ValueError`
        return False
    return len({setpoint.motor for setpoint in setpoints}) == len(setpoints)


def is_idle(setpoint: Setpoint) -> bool:
    if isinstance(setpoint, SetAuxiliary):
        return not setpoint.speed
    return setpoint.drive.is_brake or not setpoint.drive.signed


def packets(setpoints: Sequence[Setpoint]) -> list[Command[None]]:
    """Return as few commands as possible for these setpoints."""
    motors = [setpoint for setpoint in setpoints if isinstance(setpoint, SetMotor)]
    commands: list[Command[None]] = []
    if len(motors) == 2 and motors[0].accelerate == motors[1].accelerate:
        first, second = sorted(motors, key=lambda setpoint: setpoint.motor)
        commands.append(DriveBoth(first.drive, second.drive, first.accelerate))
    else:
        commands += [DriveMotor(motor.motor, motor.drive, motor.accelerate) for motor in motors]
    commands += [
        DriveAuxiliary(setpoint.speed, setpoint.accelerate)
        for setpoint in setpoints
        if isinstance(setpoint, SetAuxiliary)
    ]
    return commands
