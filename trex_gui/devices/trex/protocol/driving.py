"""Commands 0xC0 to 0xF1: motor commands. None of them has a reply.

Ref: TReX 1.0 command documentation, "Motor Commands".
"""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar, Self

from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.protocol.command import Command, motor_index, seven_bits


class Direction(IntEnum):
    """The two direction bits of a motor command.

    The documentation calls both 00 and 11 "brake low"; with them the speed byte is the duty
    of braking, 127 a full brake and 0 coasting.
    """

    BRAKE = 0b00
    REVERSE = 0b01
    FORWARD = 0b10
    BRAKE_TOO = 0b11


@dataclass(frozen=True, slots=True)
class Drive:
    """Setpoint of one motor: a direction and a speed or braking duty of 0-127."""

    direction: Direction
    speed: int

    @classmethod
    def at(cls, speed: int) -> "Drive":
        """Return the drive for a signed speed of -127 to 127; 0 is forward at speed 0.

        Raises:
            BadRequest: the speed is outside that.
        """
        if not -FULL_SCALE <= speed <= FULL_SCALE:
            raise BadRequest(f"a motor's speed is -127 to 127, not {speed}")
        return cls(Direction.REVERSE if speed < 0 else Direction.FORWARD, abs(speed))

    @classmethod
    def brake(cls, duty: int = FULL_SCALE) -> "Drive":
        """Return braking with a duty of 0 (coast) to 127 (full brake)."""
        return cls(Direction.BRAKE, seven_bits(duty, "brake duty"))

    @property
    def signed(self) -> int:
        """The speed with its sign; braking is 0."""
        match self.direction:
            case Direction.FORWARD:
                return self.speed
            case Direction.REVERSE:
                return -self.speed
            case _:
                return 0

    @property
    def is_brake(self) -> bool:
        """Whether the motor is braked (or coasts) rather than driven."""
        return self.direction in {Direction.BRAKE, Direction.BRAKE_TOO}


class _MotorCommand(Command[None]):
    """A command without a reply: only what the board reports afterwards confirms it."""

    __slots__ = ()

    moves: ClassVar[bool] = True

    def parse(self, reply: bytes) -> None:
        del reply


@dataclass(frozen=True, slots=True)
class DriveMotor(_MotorCommand):
    """0xC0-0xCF: set, or accelerate, motor 1 or 2."""

    opcodes: ClassVar[Sequence[int]] = range(0xC0, 0xD0)
    data_size: ClassVar[int] = 1

    motor: int
    drive: Drive
    accelerate: bool = False

    @property
    def opcode(self) -> int:
        motor = motor_index(self.motor)
        return 0xC0 | motor << 3 | self.accelerate << 2 | self.drive.direction

    def data(self) -> bytes:
        return bytes([seven_bits(self.drive.speed, "speed")])

    @classmethod
    def from_packet(cls, opcode: int, data: bytes) -> Self:
        drive = Drive(Direction(opcode & 0b11), data[0])
        return cls((opcode >> 3 & 1) + 1, drive, bool(opcode & 0b100))


@dataclass(frozen=True, slots=True)
class DriveBoth(_MotorCommand):
    """0xD0-0xEF: set, or accelerate, both motors in one packet.

    The documentation's formula for accelerating says 0xD0; its heading, and programs that
    work, say 0xE0.
    """

    opcodes: ClassVar[Sequence[int]] = range(0xD0, 0xF0)
    data_size: ClassVar[int] = 2

    motor1: Drive
    motor2: Drive
    accelerate: bool = False

    @property
    def opcode(self) -> int:
        base = 0xE0 if self.accelerate else 0xD0
        return base | self.motor2.direction << 2 | self.motor1.direction

    def data(self) -> bytes:
        speeds = (self.motor1.speed, self.motor2.speed)
        return bytes(seven_bits(speed, "speed") for speed in speeds)

    @classmethod
    def from_packet(cls, opcode: int, data: bytes) -> Self:
        motor1 = Drive(Direction(opcode & 0b11), data[0])
        motor2 = Drive(Direction(opcode >> 2 & 0b11), data[1])
        return cls(motor1, motor2, opcode >= 0xE0)


@dataclass(frozen=True, slots=True)
class DriveAuxiliary(_MotorCommand):
    """0xF0, 0xF1: set, or accelerate, the one-way auxiliary motor to 0-127."""

    opcodes: ClassVar[Sequence[int]] = (0xF0, 0xF1)
    data_size: ClassVar[int] = 1

    speed: int
    accelerate: bool = False

    @property
    def opcode(self) -> int:
        return self.opcodes[self.accelerate]

    def data(self) -> bytes:
        return bytes([seven_bits(self.speed, "speed of the auxiliary motor")])

    @classmethod
    def from_packet(cls, opcode: int, data: bytes) -> Self:
        return cls(data[0], opcode == cls.opcodes[1])


STOP: tuple[Command[None], ...] = (
    DriveBoth(Drive.brake(), Drive.brake()),
    DriveAuxiliary(0),
)
"""The packets that stop everything: full brake on both motors, auxiliary motor off.

Set commands, so neither acceleration nor a reversal delays them.
"""
