"""Every TReX command in one place: the table by command byte, and the names to import.

Ref: TReX 1.0 command documentation; Pololu TReX User's Guide 5.b, 5.c.
"""

from collections.abc import Mapping

from trex_gui.devices.trex.protocol.command import Command, ReplyT_co
from trex_gui.devices.trex.protocol.driving import (
    STOP,
    Direction,
    Drive,
    DriveAuxiliary,
    DriveBoth,
    DriveMotor,
)
from trex_gui.devices.trex.protocol.queries import (
    GetCalibratedChannels,
    GetCalibration,
    GetCurrent,
    GetCurrents,
    GetMode,
    GetParameter,
    GetRawChannels,
    GetRemappedChannels,
    GetSerialControl,
    GetSignature,
    GetStatus,
    GetUartErrors,
    Null,
    Signature,
)
from trex_gui.devices.trex.protocol.writes import SetCalibration, SetParameter

__all__ = [
    "COMMANDS",
    "STOP",
    "Command",
    "Direction",
    "Drive",
    "DriveAuxiliary",
    "DriveBoth",
    "DriveMotor",
    "GetCalibratedChannels",
    "GetCalibration",
    "GetCurrent",
    "GetCurrents",
    "GetMode",
    "GetParameter",
    "GetRawChannels",
    "GetRemappedChannels",
    "GetSerialControl",
    "GetSignature",
    "GetStatus",
    "GetUartErrors",
    "Null",
    "ReplyT_co",
    "SetCalibration",
    "SetParameter",
    "Signature",
]

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

COMMANDS: Mapping[int, type[Command[object]]] = {
    opcode: cls for cls in _CLASSES for opcode in cls.opcodes
}
"""Every command byte that a TReX knows, and the class that reads its packet."""
