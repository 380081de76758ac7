"""Storing one value: write it, read it back, and compare.

Plain functions over a `Requester`, so the command line, the session and tests share them. Each
raises `PortUnavailable` if the line is gone.
"""

from collections.abc import Callable
from typing import TypeVar

from trex_gui.core.errors import BadReply, NoReply
from trex_gui.core.translation import tr
from trex_gui.devices.trex.client.client import Requester
from trex_gui.devices.trex.client.reading import ATTEMPTS, agreed, query
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

    A lost reply is no failure: only the value read back counts. The factory reset cannot be read
    back; its result code has to suffice.

    `has_crc`: whether a CRC protects the line, in every function here; see `agreed`.

    Raises:
        BadRequest: the value is outside limits that are not inferred; nothing was sent.
        Rejected: the board rejected it.
        BadReply: the value read back differs.
        NoReply: the board does not respond.
    """
    command = SetParameter(spec.number, spec.check(wire, forced=True))
    if not spec.readable:
        code = agreed(request, command, has_crc=has_crc)
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
    request: Requester, key: CalibrationKey, wanted: Calibration, *, has_crc: bool = False
) -> Calibration:
    """Store a calibration for the active input source. Return what was read back.

    A board that lost power for a moment may have another active source now. Then nothing more is
    written, because each source has its own calibrations.

    Raises:
        BadRequest: minimum, neutral and maximum are not in order; nothing was sent.
        BadReply: the active source, or the value read back, differs.
        Rejected, NoReply: as for `write_parameter`.
    """
    what = tr("Calibration of channel {0}").format(key.channel)
    command = SetCalibration(key.channel, wanted)
    command.data()  # invalid values raise here, before anything is sent

    def require_source() -> None:
        mode = agreed(request, GetMode(), has_crc=has_crc)
        if not mode.is_serial:
            raise Rejected(what, ResultCode.NOT_SERIAL_MODE)
        if mode.source is not key.source:
            names = key.source.word, mode.source.word
            raise TrexBadReplyError(ErrorCode.OTHER_SOURCE, what, *names)

    stored = _write_and_verify(
        request,
        what,
        command,
        GetCalibration(key.channel),
        wanted,
        has_crc=has_crc,
        before=require_source,
    )
    if stored != wanted:
        raise TrexBadReplyError(ErrorCode.CALIBRATION_MISMATCH, what, stored)
    return stored


def _write_and_verify(
    request: Requester,
    what: str,
    command: SetParameter | SetCalibration,
    read_back: Command[ValueT],
    wanted: ValueT,
    *,
    has_crc: bool,
    before: Callable[[], None] = lambda: None,
) -> ValueT:
    """Write until the value is read back. Return the last reading.

    `before` is called before each write.

    Raises:
        Rejected: the board rejects the value. Without a CRC, two rejections in a row are needed,
            because the first packet or its reply may have been corrupted.
    """

    def write() -> None:
        """Write until the board accepts the value. If it never does, the read-back decides."""
        rejected: ResultCode | None = None
        for _ in range(ATTEMPTS):
            before()
            try:
                code = request(command)
            except (NoReply, BadReply):
                # The packet or its reply was corrupted: writing the same value again is harmless.
                continue
            if code is ResultCode.OK:
                return
            if has_crc or code is rejected:
                raise Rejected(what, code)
            rejected = code
            query(request, GetMode())  # see `agreed`

    stored = wanted
    for _ in range(ATTEMPTS):
        write()
        stored = agreed(request, read_back, has_crc=has_crc)
        if stored == wanted:
            break
    return stored
