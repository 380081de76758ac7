"""Commands 0xA0 to 0xAF: what the board stores in EEPROM, in serial mode only.

Ref: TReX 1.0 command documentation, "Set-Parameter Commands".
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar, Self

from trex_gui.core.errors import BadReply, BadRequest
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.command import Command, channel_index, seven_bits
from trex_gui.devices.trex.protocol.errors import ResultCode

FORMAT_BYTES = b"\x55\x2a"
"""What ends every write, so that noise does not become one."""


class _Write(Command[ResultCode]):
    """A write to EEPROM; the reply comes when the board has stored the value."""

    __slots__ = ()

    fixed_reply: ClassVar[int] = 1

    def parse(self, reply: bytes) -> ResultCode:
        try:
            return ResultCode(reply[0])
        except ValueError:
            message = f"{reply[0]} is no result code of a TReX (0 to 3)"
            raise BadReply(message) from None


def _without_format_bytes(data: bytes) -> bytes:
    if data[-2:] != FORMAT_BYTES:
        raise BadRequest(f"a write ends in 55 2A, not {data[-2:].hex(' ').upper()}")
    return data[:-2]


@dataclass(frozen=True, slots=True)
class SetCalibration(_Write):
    """0xA0-0xA4: store one channel's calibration for the input source in force.

    Needs serial mode.
    """

    opcodes: ClassVar[Sequence[int]] = range(0xA0, 0xA5)
    data_size: ClassVar[int] = 10

    channel: int
    calibration: Calibration

    @property
    def opcode(self) -> int:
        return self.opcodes[channel_index(self.channel)]

    def data(self) -> bytes:
        return self.calibration.encode() + FORMAT_BYTES

    @classmethod
    def from_packet(cls, opcode: int, data: bytes) -> Self:
        calibration = Calibration.from_data(_without_format_bytes(data))
        return cls(opcode - cls.opcodes[0] + 1, calibration)

    @property
    def seconds_to_answer(self) -> float:
        """About 32 ms; the documentation calls 100 ms too late."""
        return 0.1


@dataclass(frozen=True, slots=True)
class SetParameter(_Write):
    """0xAF: store one configuration parameter. Needs serial mode."""

    opcodes: ClassVar[Sequence[int]] = (0xAF,)
    data_size: ClassVar[int] = 4

    number: int
    value: int

    def data(self) -> bytes:
        number = seven_bits(self.number, "parameter number")
        value = seven_bits(self.value, "parameter value")
        return bytes([number, value]) + FORMAT_BYTES

    @classmethod
    def from_packet(cls, opcode: int, data: bytes) -> Self:
        del opcode
        number, value = _without_format_bytes(data)
        return cls(number, value)

    @property
    def seconds_to_answer(self) -> float:
        """About 4 ms; the documentation calls 50 ms too late."""
        return 0.05
