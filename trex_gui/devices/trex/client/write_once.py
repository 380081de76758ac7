"""Writes of one value, verified by reading the value back.

Every function raises `PortUnavailable` if the line is gone. `has_crc` is True if a CRC protects the
line. See `read_reliably`.
"""

from collections.abc import Callable
from typing import TypeVar

from trex_gui.core.errors import BadReply, NoReply
from trex_gui.core.translation import tr
from trex_gui.devices.trex.client.client import Requester
from trex_gui.devices.trex.client.reading import ATTEMPTS, query, read_reliably
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.commands import (
    Command,
    GetCalibration,
    GetMode,
    GetParameter,
    SetCalibration,
    SetParameter,
)
from trex_gui.devices.trex.protocol.errors import ErrorCode, Rejected, ResultCode, TrexBadReplyError
from trex_gui.devices.trex.protocol.parameters import ParameterSpec

ValueT = TypeVar("ValueT", int, Calibration)


def write_parameter(
    request: Requester, spec: ParameterSpec, wire: int, *, has_crc: bool = False
) -> int:
    """Store one parameter and return the value that was read back.

    A lost reply is not a failure, since only the value read back counts. The factory reset cannot
    be read back, so its result code counts.

    Raises:
        BadRequest: the value is outside the documented limits. Nothing was sent.
        Rejected: the board rejected the value.
        BadReply: the value read back differs.
        NoReply: the board does not respond.
    """
    command = SetParameter(spec.number, spec.check(wire, forced=True))
    if not spec.readable:
        code = read_reliably(request, command, has_crc=has_crc)
        if code is not ResultCode.OK:
            raise Rejected(spec.name, code)
        return wire
    read_back = GetParameter(spec.number)
    stored = _write_and_verify(request, spec.name, command, read_back, wire, has_crc=has_crc)
    if stored != wire:
        texts = spec.text(wire), spec.text(stored)
        raise TrexBadReplyError(ErrorCode.PARAMETER_MISMATCH, spec.name, *texts)
    return stored


def write_calibration(
    request: Requester, key: CalibrationKey, value: Calibration, *, has_crc: bool = False
) -> Calibration:
    """Store a calibration for the active input source. Return the value read back.

    Each source has its own calibrations, and a short power loss may change the active source.
    Nothing is written if another source is active.

    Raises:
        BadRequest: minimum, neutral and maximum are not in order. Nothing was sent.
        BadReply: the active source or the value read back differs.
        Rejected, NoReply: as for `write_parameter`.
    """
    name = tr("Calibration of channel {0}").format(key.channel)
    command = SetCalibration(key.channel, value)
    command.data()  # raises if the values are invalid, before anything is sent

    def require_source() -> None:
        mode = read_reliably(request, GetMode(), has_crc=has_crc)
        if not mode.is_serial:
            raise Rejected(name, ResultCode.NOT_SERIAL_MODE)
        if mode.source is not key.source:
            sources = key.source.word, mode.source.word
            raise TrexBadReplyError(ErrorCode.OTHER_SOURCE, name, *sources)

    stored = _write_and_verify(
        request,
        name,
        command,
        GetCalibration(key.channel),
        value,
        has_crc=has_crc,
        before=require_source,
    )
    if stored != value:
        raise TrexBadReplyError(ErrorCode.CALIBRATION_MISMATCH, name, stored)
    return stored


def _write_and_verify(
    request: Requester,
    name: str,
    command: SetParameter | SetCalibration,
    read_back: Command[ValueT],
    value: ValueT,
    *,
    has_crc: bool,
    before: Callable[[], None] = lambda: None,
) -> ValueT:
    """Write until the value is read back. Return the last reading.

    `before` is called before each write. Without a CRC, a rejection counts only if the next reply
    repeats it, because the packet or its reply may have been corrupted.
    """

    def write() -> None:
        rejected: ResultCode | None = None
        for _ in range(ATTEMPTS):
            before()
            try:
                code = request(command)
            except (NoReply, BadReply):
                continue  # writing the same value again is harmless
            if code is ResultCode.OK:
                return
            if has_crc or code is rejected:
                raise Rejected(name, code)
            rejected = code
            query(request, GetMode())  # see `read_reliably`

    stored = value
    for _ in range(ATTEMPTS):
        write()
        stored = read_reliably(request, read_back, has_crc=has_crc)
        if stored == value:
            break
    return stored
