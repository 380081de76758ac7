"""TReX commands and their replies.

Opcodes are bytes of the compact protocol (0x81-0xFF). `framing` encodes complete packets.

Ref: TReX 1.0 command documentation; Pololu TReX User's Guide 5.b, 5.c.
"""

import re
import struct
from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import ClassVar, Generic, Self, TypeVar

from trex_gui.core.errors import BadReply, BadRequest
from trex_gui.core.texts import hex_text
from trex_gui.core.translation import tr
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE, INVALID_RAW, Calibration
from trex_gui.devices.trex.protocol.device_table import Model, device_table
from trex_gui.devices.trex.protocol.driving import Direction, Drive
from trex_gui.devices.trex.protocol.errors import ResultCode
from trex_gui.devices.trex.protocol.flags import (
    ALL_CHANNELS,
    CHANNELS,
    Mode,
    Status,
    UartError,
    channels_in,
    seven_bits,
)

ReplyT_co = TypeVar("ReplyT_co", covariant=True)


class Command(ABC, Generic[ReplyT_co]):
    """Command to a board. Subclasses are frozen dataclasses."""

    __slots__ = ()

    opcodes: ClassVar[Sequence[int]]  # all command bytes of this class
    data_size: ClassVar[int] = 0  # data bytes after the command byte, without the CRC byte
    fixed_reply_size: ClassVar[int] = 0  # size of the reply in bytes, if it is always the same
    moves: ClassVar[bool] = False  # True if the command may start or stop a motor
    max_reply_delay: ClassVar[float] = 0.0  # seconds, without the transmission time
    has_crc: ClassVar[bool] = True  # True if the packet has a CRC byte while CRC is enabled

    @property
    def opcode(self) -> int:
        return self.opcodes[0]

    def data(self) -> bytes:
        """Return the data bytes. Raise BadRequest if a value is outside its limits."""
        return b""

    @classmethod
    def from_packet(cls, _opcode: int, _data: bytes, /) -> Self:
        """Decode a command. Raise BadRequest if the data is invalid."""
        return cls()

    def reply_size(self, _start: bytes = b"", /) -> int:
        """Return the size in bytes of a reply that starts with `_start`. 0 means no reply."""
        return self.fixed_reply_size

    @abstractmethod
    def parse(self, reply: bytes) -> ReplyT_co:
        """Parse a reply of `reply_size` bytes. Raise BadReply if no TReX sends such a reply."""


def _motor_index(motor: int) -> int:
    if motor not in {1, 2}:
        raise BadRequest(tr("the motor number must be 1 or 2, not {0}").format(motor))
    return motor - 1


@dataclass(frozen=True, slots=True)
class _ChannelCommand(Command[ReplyT_co]):
    """Command whose opcode selects a channel, 1-5."""

    channel: int

    @property
    def opcode(self) -> int:
        if self.channel not in CHANNELS:
            raise BadRequest(tr("the channel number must be 1 to 5, not {0}").format(self.channel))
        return self.opcodes[self.channel - 1]


# --- Queries, 0x81 to 0x9F, in every mode -----------------------------------------------


@dataclass(frozen=True, slots=True)
class Signature:
    model: Model
    firmware: str

    def __str__(self) -> str:
        return f"{self.model.name} {self.firmware}"


@dataclass(frozen=True, slots=True)
class GetSignature(Command[Signature]):
    """0x81: model and firmware. The reply has 7 bytes (TReX) or 9 bytes (TReX Jr)."""

    opcodes = (0x81,)

    def reply_size(self, start: bytes = b"", /) -> int:
        models = device_table().models
        sizes = (model.signature_size for model in models if start.startswith(model.signature))
        return max(sizes, default=min(model.signature_size for model in models))

    def parse(self, reply: bytes) -> Signature:
        for model in device_table().models:
            version = reply.removeprefix(model.signature)
            if len(reply) == model.signature_size and re.fullmatch(rb"[0-9]\.[0-9]+", version):
                return Signature(model, version.decode("ascii"))
        raise BadReply(tr("{0} is not the signature of a TReX").format(hex_text(reply)))


@dataclass(frozen=True, slots=True)
class GetMode(Command[Mode]):
    """0x82: mode that the mode jumper selected at power-up."""

    opcodes = (0x82,)
    fixed_reply_size = 1

    def parse(self, reply: bytes) -> Mode:
        try:
            return Mode(reply.decode("latin-1"))
        except ValueError:
            text = tr("{0:#04x} is not a TReX mode (R, A, r or a)")
            raise BadReply(text.format(reply[0])) from None


@dataclass(frozen=True, slots=True)
class GetSerialControl(Command[bool]):
    """0x83: True if serial commands control the motors."""

    opcodes = (0x83,)
    fixed_reply_size = 1

    def parse(self, reply: bytes) -> bool:
        if reply[0] > 1:
            raise BadReply(tr("the control flag must be 0 or 1, not {0}").format(reply[0]))
        return bool(reply[0])


@dataclass(frozen=True, slots=True)
class GetStatus(Command[Status]):
    """0x84: status bits. Reading clears them."""

    opcodes = (0x84,)
    fixed_reply_size = 1

    def parse(self, reply: bytes) -> Status:
        if reply[0] == self.opcode:  # an echo must not confirm a stop
            raise BadReply(tr("the request came back instead of a status"))
        return Status(reply[0])


@dataclass(frozen=True, slots=True)
class GetUartErrors(Command[UartError]):
    """0x85: UART error bits. Reading clears them."""

    opcodes = (0x85,)
    fixed_reply_size = 1

    def parse(self, reply: bytes) -> UartError:
        return UartError(reply[0])


@dataclass(frozen=True, slots=True)
class _ChannelQuery(Command[ReplyT_co]):
    """Query with a channel mask. Bit n selects channel n+1."""

    data_size = 1
    bytes_per_channel: ClassVar[int] = 1  # reply bytes for each channel

    mask: int = ALL_CHANNELS

    def data(self) -> bytes:
        if not 0 <= self.mask <= ALL_CHANNELS:
            text = tr("a channel mask must be 0 to {0}, not {1}")
            raise BadRequest(text.format(ALL_CHANNELS, self.mask))
        return bytes([self.mask])

    @classmethod
    def from_packet(cls, _opcode: int, data: bytes, /) -> Self:
        command = cls(data[0])
        command.data()
        return command

    @property
    def channels(self) -> tuple[int, ...]:
        return channels_in(self.mask)

    def reply_size(self, _start: bytes = b"", /) -> int:
        return self.bytes_per_channel * len(self.channels)


@dataclass(frozen=True, slots=True)
class GetRawChannels(_ChannelQuery[Mapping[int, int | None]]):
    """0x86: channel → raw count, or `None` without a valid pulse."""

    opcodes = (0x86,)
    bytes_per_channel = 2

    def parse(self, reply: bytes) -> Mapping[int, int | None]:
        counts = struct.unpack(f"<{len(self.channels)}H", reply)
        return {
            channel: None if raw == INVALID_RAW else raw
            for channel, raw in zip(self.channels, counts, strict=True)
        }


@dataclass(frozen=True, slots=True)
class GetRemappedChannels(_ChannelQuery[Mapping[int, int]]):
    """0x87: channel → remapped input, -127 to 127."""

    opcodes = (0x87,)

    def parse(self, reply: bytes) -> Mapping[int, int]:
        # Bit 7 is the direction. The documentation says that the magnitude of channel 3 is in the
        # "lower six bits", and that the other channels have seven bits. Inferred: channel 3 also
        # has seven bits, because a magnitude of 0 to 127 needs them.
        return {
            channel: -(byte & FULL_SCALE) if byte & 0x80 else byte
            for channel, byte in zip(self.channels, reply, strict=True)
        }


@dataclass(frozen=True, slots=True)
class GetCurrent(Command[int]):
    """0x8D, 0x8E: current of one motor in counts."""

    opcodes = (0x8D, 0x8E)
    fixed_reply_size = 1

    motor: int

    @property
    def opcode(self) -> int:
        return self.opcodes[_motor_index(self.motor)]

    @classmethod
    def from_packet(cls, opcode: int, _data: bytes, /) -> Self:
        return cls(cls.opcodes.index(opcode) + 1)

    def parse(self, reply: bytes) -> int:
        return reply[0]


@dataclass(frozen=True, slots=True)
class GetCurrents(Command[tuple[int, int]]):
    """0x8F: currents of both motors in counts."""

    opcodes = (0x8F,)
    fixed_reply_size = 2

    def parse(self, reply: bytes) -> tuple[int, int]:
        return reply[0], reply[1]


@dataclass(frozen=True, slots=True)
class GetCalibration(_ChannelCommand[Calibration]):
    """0x90-0x94: calibration of one channel, for the active input source."""

    opcodes = range(0x90, 0x95)
    fixed_reply_size = 8

    @classmethod
    def from_packet(cls, opcode: int, _data: bytes, /) -> Self:
        return cls(opcode - cls.opcodes[0] + 1)

    def parse(self, reply: bytes) -> Calibration:
        return Calibration(*struct.unpack("<4H", reply))


@dataclass(frozen=True, slots=True)
class GetCalibratedChannels(Command[int]):
    """0x95: mask of channels whose calibration was changed ("learned")."""

    opcodes = (0x95,)
    fixed_reply_size = 1

    def parse(self, reply: bytes) -> int:
        if reply[0] > ALL_CHANNELS:
            raise BadReply(tr("{0:#04x} names channels that a TReX does not have").format(reply[0]))
        return reply[0]


@dataclass(frozen=True, slots=True)
class GetParameter(Command[int]):
    """0x9F: value of one configuration parameter, 0-127."""

    opcodes = (0x9F,)
    data_size = 1
    fixed_reply_size = 1

    number: int

    def data(self) -> bytes:
        return bytes([seven_bits(self.number, tr("parameter number"))])

    @classmethod
    def from_packet(cls, _opcode: int, data: bytes, /) -> Self:
        return cls(data[0])

    def parse(self, reply: bytes) -> int:
        if reply[0] > FULL_SCALE:
            raise BadReply(tr("a parameter number must be 0 to 127, not {0}").format(reply[0]))
        return reply[0]


# --- Writes to EEPROM, 0xA0 to 0xAF, in serial mode only --------------------------------

FORMAT_BYTES = b"\x55\x2a"  # end of every write; protects the EEPROM from line noise


def _result(reply: bytes) -> ResultCode:
    """Parse the reply to a write. The board sends it after storing the value."""
    try:
        return ResultCode(reply[0])
    except ValueError:
        raise BadReply(tr("{0} is not a TReX result code (0 to 3)").format(reply[0])) from None


def _without_format_bytes(data: bytes) -> bytes:
    if data[-2:] != FORMAT_BYTES:
        raise BadRequest(tr("a write must end in 55 2A, not {0}").format(hex_text(data[-2:])))
    return data[:-2]


@dataclass(frozen=True, slots=True)
class SetCalibration(_ChannelCommand[ResultCode]):
    """0xA0-0xA4: store one channel's calibration for the active input source."""

    opcodes = range(0xA0, 0xA5)
    data_size = 10
    fixed_reply_size = 1
    max_reply_delay = 0.1  # usually 32 ms; the documentation specifies less than 100 ms

    calibration: Calibration

    def data(self) -> bytes:
        return self.calibration.encode() + FORMAT_BYTES

    @classmethod
    def from_packet(cls, opcode: int, data: bytes, /) -> Self:
        calibration = Calibration.from_data(_without_format_bytes(data))
        return cls(opcode - cls.opcodes[0] + 1, calibration)

    def parse(self, reply: bytes) -> ResultCode:
        return _result(reply)


@dataclass(frozen=True, slots=True)
class SetParameter(Command[ResultCode]):
    """0xAF: store one configuration parameter."""

    opcodes = (0xAF,)
    data_size = 4
    fixed_reply_size = 1
    max_reply_delay = 0.05  # usually 4 ms; the documentation specifies less than 50 ms

    number: int
    value: int

    def data(self) -> bytes:
        number = seven_bits(self.number, tr("parameter number"))
        return bytes([number, seven_bits(self.value, tr("parameter value"))]) + FORMAT_BYTES

    @classmethod
    def from_packet(cls, _opcode: int, data: bytes, /) -> Self:
        return cls(*_without_format_bytes(data))

    def parse(self, reply: bytes) -> ResultCode:
        return _result(reply)


# --- Commands without a reply -----------------------------------------------------------


class _MotorCommand(Command[None]):
    """Motor command, 0xC0 to 0xF1. Only later queries can confirm it."""

    __slots__ = ()

    moves = True

    def parse(self, reply: bytes) -> None:
        del reply


@dataclass(frozen=True, slots=True)
class DriveMotor(_MotorCommand):
    """0xC0-0xCF: set or accelerate motor 1 or 2."""

    opcodes = range(0xC0, 0xD0)
    data_size = 1

    motor: int
    drive: Drive
    accelerate: bool = False

    @property
    def opcode(self) -> int:
        motor = _motor_index(self.motor)
        return 0xC0 | motor << 3 | self.accelerate << 2 | self.drive.direction

    def data(self) -> bytes:
        return bytes([seven_bits(self.drive.speed, "speed")])

    @classmethod
    def from_packet(cls, opcode: int, data: bytes, /) -> Self:
        drive = Drive(Direction(opcode & 0b11), data[0])
        return cls((opcode >> 3 & 1) + 1, drive, bool(opcode & 0b100))


@dataclass(frozen=True, slots=True)
class DriveBoth(_MotorCommand):
    """0xD0-0xEF: set or accelerate both motors in one packet.

    For acceleration, the formula in the documentation yields 0xD0, but the heading there uses 0xE0.
    Working programs also use 0xE0.
    """

    opcodes = range(0xD0, 0xF0)
    data_size = 2

    motor1: Drive
    motor2: Drive
    accelerate: bool = False

    @property
    def opcode(self) -> int:
        base = 0xE0 if self.accelerate else 0xD0
        return base | self.motor2.direction << 2 | self.motor1.direction

    def data(self) -> bytes:
        return bytes(seven_bits(drive.speed, "speed") for drive in (self.motor1, self.motor2))

    @classmethod
    def from_packet(cls, opcode: int, data: bytes, /) -> Self:
        motor2 = Drive(Direction(opcode >> 2 & 0b11), data[1])
        return cls(Drive(Direction(opcode & 0b11), data[0]), motor2, opcode >= 0xE0)


@dataclass(frozen=True, slots=True)
class DriveAuxiliary(_MotorCommand):
    """0xF0, 0xF1: set or accelerate the auxiliary motor to a speed of 0-127."""

    opcodes = (0xF0, 0xF1)
    data_size = 1

    speed: int
    accelerate: bool = False

    @property
    def opcode(self) -> int:
        return self.opcodes[self.accelerate]

    def data(self) -> bytes:
        return bytes([seven_bits(self.speed, tr("speed of the auxiliary motor"))])

    @classmethod
    def from_packet(cls, opcode: int, data: bytes, /) -> Self:
        return cls(data[0], opcode == cls.opcodes[1])


STOP: tuple[Command[None], ...] = (DriveBoth(Drive.brake(), Drive.brake()), DriveAuxiliary(0))
"""Full brake on both motors, auxiliary motor off.

Both commands set the motors directly. Neither acceleration nor a reversal delays them.
"""


@dataclass(frozen=True, slots=True)
class Null(Command[None]):
    """0xFF: no operation. Only an echo confirms that the packet was sent."""

    opcodes = (0xFF,)
    has_crc = False  # inferred

    def parse(self, reply: bytes) -> None:
        del reply


_CLASSES: tuple[type[Command[object]], ...] = (
    GetSignature,
    GetMode,
    GetSerialControl,
    GetStatus,
    GetUartErrors,
    GetRawChannels,
    GetRemappedChannels,
    GetCurrent,
    GetCurrents,
    GetCalibration,
    GetCalibratedChannels,
    GetParameter,
    SetCalibration,
    SetParameter,
    DriveMotor,
    DriveBoth,
    DriveAuxiliary,
    Null,
)
COMMANDS: Mapping[int, type[Command[object]]] = {  # opcode → class
    opcode: cls for cls in _CLASSES for opcode in cls.opcodes
}
