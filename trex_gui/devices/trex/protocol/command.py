"""The base of every command: a frozen value that knows its packet and reads its reply.

So the type of a reply follows from the command. Opcodes are those of the compact protocol
(0x81-0xFF); framing.py turns them into bytes on the wire.
"""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import ClassVar, Generic, Self, TypeVar

from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.protocol.flags import CHANNELS

ReplyT_co = TypeVar("ReplyT_co", covariant=True)


def seven_bits(value: int, what: str) -> int:
    """Return `value` when it can be a data byte (0-127).

    Raises:
        BadRequest: it cannot; names `what`.
    """
    if not 0 <= value <= 0x7F:
        raise BadRequest(f"{what} is 0 to 127, not {value}")
    return value


class Command(ABC, Generic[ReplyT_co]):
    """One command; subclasses are frozen dataclasses.

    Attributes:
        opcodes: every command byte that this class covers.
        data_size: data bytes behind the command byte; the CRC byte is not counted.
        fixed_reply: bytes of the reply where every reply has the same size.
        moves: whether it may set a motor moving or stop one.
    """

    __slots__ = ()

    opcodes: ClassVar[Sequence[int]]
    data_size: ClassVar[int] = 0
    fixed_reply: ClassVar[int] = 0
    moves: ClassVar[bool] = False

    @property
    def opcode(self) -> int:
        """The command byte (0x81-0xFF)."""
        return self.opcodes[0]

    def data(self) -> bytes:
        """The data bytes.

        Raises:
            BadRequest: a value does not fit; names it and its limits.
        """
        return b""

    @classmethod
    @abstractmethod
    def from_packet(cls, opcode: int, data: bytes) -> Self:
        """Read a command back from its packet.

        Raises:
            BadRequest: the data bytes cannot be this command's.
        """

    def reply_size(self, head: bytes = b"") -> int:
        """Return how long the reply is, in bytes, judging by its `head`; 0 is no reply."""
        del head
        return self.fixed_reply

    @abstractmethod
    def parse(self, reply: bytes) -> ReplyT_co:
        """Read a reply of `reply_size` bytes.

        Raises:
            BadReply: no TReX answers this.
        """

    @property
    def seconds_to_answer(self) -> float:
        """How long the board works before it answers, without the time on the wire."""
        return 0.0

    @property
    def has_crc(self) -> bool:
        """Whether its packet carries a CRC byte when CRC is enabled."""
        return True


class PlainCommand(Command[ReplyT_co]):
    """A command without data bytes and with one opcode."""

    __slots__ = ()

    @classmethod
    def from_packet(cls, opcode: int, data: bytes) -> Self:
        del opcode, data
        return cls()


def motor_index(motor: int) -> int:
    """Return 0 or 1 for motor 1 or 2.

    Raises:
        BadRequest: there is no such motor.
    """
    if motor not in {1, 2}:
        raise BadRequest(f"motors are numbered 1 and 2, not {motor}")
    return motor - 1


def channel_index(channel: int) -> int:
    """Return 0 to 4 for channel 1 to 5.

    Raises:
        BadRequest: there is no such channel.
    """
    if channel not in CHANNELS:
        raise BadRequest(f"channels are numbered 1 to 5, not {channel}")
    return channel - 1
