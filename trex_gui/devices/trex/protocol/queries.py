"""Queries, 0x81 to 0x9F, which work in every mode; and the null command 0xFF.

Ref: TReX 1.0 command documentation, "Data-Query Commands".
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import ClassVar, Self

from trex_gui.core.errors import BadReply, BadRequest
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE, INVALID_RAW, Calibration
from trex_gui.devices.trex.protocol.command import (
    Command,
    PlainCommand,
    ReplyT_co,
    channel_index,
    motor_index,
    seven_bits,
)
from trex_gui.devices.trex.protocol.device_table import Model, device_table
from trex_gui.devices.trex.protocol.flags import ALL_CHANNELS, Mode, Status, UartError, channels_in


@dataclass(frozen=True, slots=True)
class Signature:
    """Which board answers, and with which firmware."""

    model: Model
    firmware: str

    def __str__(self) -> str:
        return f"{self.model.name} {self.firmware}"


@dataclass(frozen=True, slots=True)
class GetSignature(PlainCommand[Signature]):
    """0x81: model and firmware; 7 bytes from a TReX, 9 from a TReX Jr."""

    opcodes: ClassVar[Sequence[int]] = (0x81,)

    def reply_size(self, head: bytes = b"") -> int:
        """7 until two bytes behind `TReX` tell the model."""
        shortest, longest = (
            min(model.signature_size for model in device_table().models),
            max(model.signature_size for model in device_table().models),
        )
        for model in device_table().models:
            if model.signature_size == longest and head.startswith(model.signature):
                return longest
        return shortest

    def parse(self, reply: bytes) -> Signature:
        for model in sorted(device_table().models, key=lambda m: -len(m.signature)):
            if len(reply) == model.signature_size and reply.startswith(model.signature):
                version = reply[len(model.signature) :].decode("latin-1")
                major, dot, minor = version[:1], version[1:2], version[2:]
                if dot == "." and f"{major}{minor}".isascii() and f"{major}{minor}".isdigit():
                    return Signature(model, version)
        message = f"{reply!r} is not the signature of a TReX"
        raise BadReply(message)


@dataclass(frozen=True, slots=True)
class GetMode(PlainCommand[Mode]):
    """0x82: the mode that the mode jumper set at power-up."""

    opcodes: ClassVar[Sequence[int]] = (0x82,)
    fixed_reply: ClassVar[int] = 1

    def parse(self, reply: bytes) -> Mode:
        try:
            return Mode(reply.decode("latin-1"))
        except ValueError:
            message = f"{reply[0]:#04x} is no mode of a TReX (R, A, r or a)"
            raise BadReply(message) from None


@dataclass(frozen=True, slots=True)
class GetSerialControl(PlainCommand[bool]):
    """0x83: whether serial commands reach the motors (serial mode, or override by channel 5)."""

    opcodes: ClassVar[Sequence[int]] = (0x83,)
    fixed_reply: ClassVar[int] = 1

    def parse(self, reply: bytes) -> bool:
        if reply[0] > 1:
            message = f"0 or 1 says who controls the motors, not {reply[0]}"
            raise BadReply(message)
        return bool(reply[0])


@dataclass(frozen=True, slots=True)
class GetStatus(PlainCommand[Status]):
    """0x84: the status bits. Reading clears them."""

    opcodes: ClassVar[Sequence[int]] = (0x84,)
    fixed_reply: ClassVar[int] = 1

    def parse(self, reply: bytes) -> Status:
        return Status(reply[0])


@dataclass(frozen=True, slots=True)
class GetUartErrors(PlainCommand[UartError]):
    """0x85: the UART error bits. Reading clears them."""

    opcodes: ClassVar[Sequence[int]] = (0x85,)
    fixed_reply: ClassVar[int] = 1

    def parse(self, reply: bytes) -> UartError:
        return UartError(reply[0])


@dataclass(frozen=True, slots=True)
class _ChannelQuery(Command[ReplyT_co]):
    """A command whose data byte names channels; bit n is channel n+1."""

    data_size: ClassVar[int] = 1

    mask: int = ALL_CHANNELS

    def data(self) -> bytes:
        if not 0 <= self.mask <= ALL_CHANNELS:
            raise BadRequest(f"a channel mask is 0 to {ALL_CHANNELS}, not {self.mask}")
        return bytes([self.mask])

    @classmethod
    def from_packet(cls, opcode: int, data: bytes) -> Self:
        del opcode
        command = cls(data[0])
        command.data()
        return command

    @property
    def channels(self) -> tuple[int, ...]:
        """The requested channels, lowest first: the order of the reply."""
        return channels_in(self.mask)


@dataclass(frozen=True, slots=True)
class GetRawChannels(_ChannelQuery[Mapping[int, int | None]]):
    """0x86: raw input of each requested channel, in counts of 0.4 us or 4.89 mV.

    The reply maps channel to count; `None` is a channel without a valid pulse.
    """

    opcodes: ClassVar[Sequence[int]] = (0x86,)

    def reply_size(self, head: bytes = b"") -> int:
        del head
        return 2 * len(self.channels)

    def parse(self, reply: bytes) -> Mapping[int, int | None]:
        values: dict[int, int | None] = {}
        for index, channel in enumerate(self.channels):
            raw = int.from_bytes(reply[2 * index : 2 * index + 2], "little")
            values[channel] = None if raw == INVALID_RAW else raw
        return values


@dataclass(frozen=True, slots=True)
class GetRemappedChannels(_ChannelQuery[Mapping[int, int]]):
    """0x87: remapped input of each requested channel, -127 to 127."""

    opcodes: ClassVar[Sequence[int]] = (0x87,)

    def reply_size(self, head: bytes = b"") -> int:
        del head
        return len(self.channels)

    def parse(self, reply: bytes) -> Mapping[int, int]:
        # Bit 7 is the direction. The documentation says "lower six bits" of channel 3 and
        # seven elsewhere; seven is right for a magnitude of 0 to 127.
        return {
            channel: -(byte & FULL_SCALE) if byte & 0x80 else byte
            for channel, byte in zip(self.channels, reply, strict=True)
        }


@dataclass(frozen=True, slots=True)
class GetCurrent(Command[int]):
    """0x8D, 0x8E: current of one motor in counts; `Model.current_unit` is ampere a count."""

    opcodes: ClassVar[Sequence[int]] = (0x8D, 0x8E)
    fixed_reply: ClassVar[int] = 1

    motor: int

    @property
    def opcode(self) -> int:
        return self.opcodes[motor_index(self.motor)]

    @classmethod
    def from_packet(cls, opcode: int, data: bytes) -> Self:
        del data
        return cls(cls.opcodes.index(opcode) + 1)

    def parse(self, reply: bytes) -> int:
        return reply[0]


@dataclass(frozen=True, slots=True)
class GetCurrents(PlainCommand[tuple[int, int]]):
    """0x8F: currents of both motors in counts; `Model.current_unit` is ampere a count."""

    opcodes: ClassVar[Sequence[int]] = (0x8F,)
    fixed_reply: ClassVar[int] = 2

    def parse(self, reply: bytes) -> tuple[int, int]:
        return reply[0], reply[1]


@dataclass(frozen=True, slots=True)
class GetCalibration(Command[Calibration]):
    """0x90-0x94: calibration of one channel, for the input source in force."""

    opcodes: ClassVar[Sequence[int]] = range(0x90, 0x95)
    fixed_reply: ClassVar[int] = 8

    channel: int

    @property
    def opcode(self) -> int:
        return self.opcodes[channel_index(self.channel)]

    @classmethod
    def from_packet(cls, opcode: int, data: bytes) -> Self:
        del data
        return cls(opcode - cls.opcodes[0] + 1)

    def parse(self, reply: bytes) -> Calibration:
        return Calibration.from_reply(reply)


@dataclass(frozen=True, slots=True)
class GetCalibratedChannels(PlainCommand[int]):
    """0x95: mask of the channels whose calibration differs from the default ("learned")."""

    opcodes: ClassVar[Sequence[int]] = (0x95,)
    fixed_reply: ClassVar[int] = 1

    def parse(self, reply: bytes) -> int:
        if reply[0] > ALL_CHANNELS:
            message = f"{reply[0]:#04x} names channels that a TReX does not have"
            raise BadReply(message)
        return reply[0]


@dataclass(frozen=True, slots=True)
class GetParameter(Command[int]):
    """0x9F: read one configuration parameter, 0-127."""

    opcodes: ClassVar[Sequence[int]] = (0x9F,)
    data_size: ClassVar[int] = 1
    fixed_reply: ClassVar[int] = 1

    number: int

    def data(self) -> bytes:
        return bytes([seven_bits(self.number, "parameter number")])

    @classmethod
    def from_packet(cls, opcode: int, data: bytes) -> Self:
        del opcode
        return cls(data[0])

    def parse(self, reply: bytes) -> int:
        if reply[0] > FULL_SCALE:
            message = f"a parameter is 0 to 127, not {reply[0]}"
            raise BadReply(message)
        return reply[0]


@dataclass(frozen=True, slots=True)
class Null(PlainCommand[None]):
    """0xFF: does nothing and answers nothing; only an echo shows that it passed.

    Inferred: it carries no CRC byte even when CRC is enabled.
    """

    opcodes: ClassVar[Sequence[int]] = (0xFF,)

    def parse(self, reply: bytes) -> None:
        del reply

    @property
    def has_crc(self) -> bool:
        return False
