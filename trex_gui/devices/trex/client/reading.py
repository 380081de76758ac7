"""Functions that read the settings of a board.

Every function raises `PortUnavailable` if the line is gone.
"""

import contextlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from itertools import count
from typing import Any, TypeVar

from trex_gui.core.errors import BadReply, NoReply
from trex_gui.core.texts import hex_text
from trex_gui.core.translation import tr
from trex_gui.devices.trex.client.client import Requester, TrexClient
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.commands import (
    Command,
    GetCalibratedChannels,
    GetCalibration,
    GetMode,
    GetParameter,
    GetSerialControl,
    GetSignature,
    ReplyT_co,
    Signature,
)
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import (
    ErrorCode,
    TrexBadReplyError,
    TrexError,
    TrexRequestError,
    readings_differ,
)
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource, Mode
from trex_gui.devices.trex.protocol.parameters import (
    ParameterKey,
    ParameterSet,
    parameter_number,
    parameters_of,
)

KeyT = TypeVar("KeyT", str, int)

Progress = Callable[[int, int, str], None]  # called with steps done, total steps, next step

ATTEMPTS = 3  # attempts at a transaction on a line that corrupts bytes

CONNECTING_ATTEMPTS = 7
"""Attempts at the first request, since a newly opened line may lose some replies.

On a silent local line, the four additional attempts take half a second.
"""

_DISAGREEMENTS = 3  # consecutive differing readings after which a value counts as unknown


@dataclass(frozen=True, slots=True)
class DeviceState:
    """Mode and settings of a board, as last read."""

    signature: Signature
    mode: Mode
    serial_controls: bool
    parameters: Mapping[str, int]  # key → stored wire value (0-127)
    calibrations: Mapping[int, Calibration]  # channel → calibration for the active input source
    calibrated: int  # mask of channels whose calibration differs from the default
    unread: Mapping[str, str] = field(default_factory=dict)  # key of a missing value → error

    @property
    def specs(self) -> ParameterSet:
        return parameters_of(self.signature.model.key, self.signature.firmware)

    @property
    def serial_timeout(self) -> float:
        """Seconds without a byte after which the board stops its motors. 0 for never."""
        wire = self.parameters.get(ParameterKey.SERIAL_TIMEOUT, 0)
        return wire * self.specs[ParameterKey.SERIAL_TIMEOUT].scale

    @property
    def stops_on_error(self) -> bool:
        return bool(self.parameters.get(ParameterKey.UART_ERROR_SHUTDOWN))

    @property
    def source(self) -> InputSource:
        return self.mode.source

    def active_parameters(self, connection: ConnectionSettings | None) -> dict[str, int]:
        """Return the active wire values of parameters that need a power cycle, as far as known."""
        active: dict[str, int] = {}
        if connection is not None:
            active[ParameterKey.UART_SETTINGS] = connection.line.to_wire()
            if connection.framing.polynomial is not None:
                active[ParameterKey.CRC7_POLYNOMIAL] = connection.polynomial & 0x7F
        if self.mode.is_serial:
            active[ParameterKey.CHANNEL_INPUT_SOURCE] = int(self.source is InputSource.ANALOG)
        return active


def may_be_same_board(first: DeviceState, second: DeviceState) -> bool:
    """True if two states may belong to one board: equal model, firmware and stored values.

    Only values in both states are compared. The mode may differ, since a jumper may have been
    moved.
    """
    if first.signature != second.signature or _differ(first.parameters, second.parameters):
        return False
    if first.source is not second.source:
        return True
    return not _differ(first.calibrations, second.calibrations)


def other_board(
    request: Requester, signature: Signature, number: int | None = None
) -> Signature | None:
    """Return the signature of the replying board, or `None` if the expected board replies.

    The expected board has this signature and, if given, this device number. The board is queried
    twice, because a corrupted reply can look like another model or number.

    Raises:
        NoReply, BadReply: as for `query`.
    """
    query_number = GetParameter(parameter_number(ParameterKey.DEVICE_NUMBER))
    for _ in range(2):
        reply = query(request, GetSignature())
        if reply == signature and (number is None or query(request, query_number) == number):
            return None
    return reply


def board_at(client: TrexClient, number: int, *, attempts: int = 1) -> Signature | None:
    """Return the signature of the board with a device number. `None` without a reply.

    The board must also report this number, because a reply to another master does not count.
    Reserved numbers are not queried. A missing reply does not count as a fault of the line.

    Raises:
        BadReply: more than one board replies, or the line corrupts bytes.
    """
    if number in client.settings.reserved:
        return None
    client.drain()
    settings = replace(client.settings, device_number=number)
    other = TrexClient(client.transport, settings, echo=client.echo)
    try:
        signature = query(other.request, GetSignature(), attempts=attempts)
        stored = GetParameter(parameter_number(ParameterKey.DEVICE_NUMBER))
        has_number = read_reliably(other.request, stored, has_crc=client.has_crc) == number
    except NoReply as error:
        if isinstance(error, TrexError) and error.code is ErrorCode.INCOMPLETE_REPLY:
            raise TrexBadReplyError(error.code, *error.fields) from error
        return None
    return signature if has_number else None


def several_reply(client: TrexClient, stored_number: int) -> bool:
    """True if more than one board replies to commands without a number.

    Equal replies from boards of the same model look like a single reply. Replies with different
    device numbers overlap and are read as `stored_number`, to which usually no board replies.
    """
    if client.settings.device_number is not None:
        return False
    with contextlib.suppress(BadReply):
        return board_at(client, stored_number, attempts=ATTEMPTS) is None
    return False


def require_free_number(
    client: TrexClient, number: int, before: Callable[[], object] = lambda: None
) -> None:
    """Check that no board uses this device number. `before` is called before each query.

    Raises:
        BadRequest: the number is reserved or in use, or every reply is unreadable. Replies are
            unreadable if more than one board has this number.
    """
    unreadable = 0
    for _ in range(ATTEMPTS):
        before()
        try:
            is_taken = number in client.settings.reserved or board_at(client, number) is not None
        except BadReply:
            unreadable += 1
            is_taken = unreadable == ATTEMPTS
        if is_taken:
            raise TrexRequestError(ErrorCode.NUMBER_TAKEN, number)


def _differ(first: Mapping[KeyT, object], second: Mapping[KeyT, object]) -> bool:
    return any(first[key] != second[key] for key in first.keys() & second.keys())


def query(
    request: Requester, command: Command[ReplyT_co], *, attempts: int = ATTEMPTS
) -> ReplyT_co:
    """Run a transaction that changes nothing, and retry it after an error.

    Raises:
        NoReply, BadReply: every attempt failed.
    """
    for _ in range(attempts - 1):
        try:
            return request(command)
        except (NoReply, BadReply):
            continue
    return request(command)


def read_reliably(
    request: Requester,
    command: Command[ReplyT_co],
    *,
    has_crc: bool = False,
    earlier: ReplyT_co | None = None,
) -> ReplyT_co:
    """Read a stored value until two consecutive readings are equal. With a CRC, read it once.

    One corrupted byte can damage two replies. It can turn the request into a request with a longer
    reply. The remaining bytes of this reply are then mistaken for the next reply. Therefore, a
    different query separates two readings. `earlier`: first reading; `None` to read it.

    Raises:
        BadReply: three consecutive readings each differ from the previous reading.
        NoReply: as for `query`.
    """
    readings = [query(request, command) if earlier is None else earlier]
    if has_crc:
        return readings[0]
    for turn in range(_DISAGREEMENTS):
        if turn or earlier is None:
            query(request, GetMode())
        readings.append(query(request, command))
        if readings[-1] == readings[-2]:
            return readings[-1]
    packet = bytes([command.opcode]) + command.data()
    raise TrexBadReplyError(ErrorCode.READINGS_DIFFER, hex_text(packet))


def read_signature(request: Requester, *, has_crc: bool = False) -> Signature:
    """Return the signature of the replying board. Raises the errors of `read_reliably`."""
    signature = query(request, GetSignature(), attempts=CONNECTING_ATTEMPTS)
    return read_reliably(request, GetSignature(), has_crc=has_crc, earlier=signature)


def read_everything(
    request: Requester,
    progress: Progress = lambda _done, _total, _next: None,
    *,
    has_crc: bool = False,
) -> DeviceState:
    """Read signature, mode, parameters and the calibrations of the active input source.

    Without a CRC, everything is read in two passes, since interference often lasts longer than one
    transaction. If a reply is missing, everything is read once more.

    Raises:
        NoReply: the board does not reply.
        BadReply: the device is not a TReX, or its replies differ.
    """
    readings: dict[Command[Any], Any] = {}

    def read(command: Command[ReplyT_co]) -> ReplyT_co:
        attempts = ATTEMPTS if readings else CONNECTING_ATTEMPTS
        readings[command] = reply = query(request, command, attempts=attempts)
        return reply

    def read_again(command: Command[ReplyT_co]) -> ReplyT_co:
        earlier: ReplyT_co | None = readings.get(command)
        return read_reliably(request, command, earlier=earlier)

    def read_passes() -> DeviceState:
        progress(0, 1, "signature")
        if has_crc:
            return _read_pass(read, progress, 0, 1)
        _read_pass(read, progress, 0, 2)
        return _read_pass(read_again, progress, 1, 2)

    try:
        return read_passes()
    except NoReply:
        if not readings:
            raise
        readings.clear()
        return read_passes()


def _read_pass(read: Requester, progress: Progress, number: int, passes: int) -> DeviceState:
    signature = read(GetSignature())
    specs = parameters_of(signature.model.key, signature.firmware).readable
    steps = 4 + len(specs) + len(CHANNELS)
    done = count(number * steps + 1)

    def read_next(name: str, command: Command[ReplyT_co]) -> ReplyT_co:
        progress(next(done), passes * steps, name)
        return read(command)

    mode = read_next("mode", GetMode())
    serial_controls = read_next("control", GetSerialControl())
    parameters: dict[str, int] = {}
    unread: dict[str, str] = {}
    for spec in specs:
        try:
            parameters[spec.key] = read_next(spec.name, GetParameter(spec.number))
        except (NoReply, BadReply) as error:
            if readings_differ(error):
                raise
            # This query raises if the board is gone. Otherwise only this parameter is rejected.
            read(GetMode())
            unread[spec.key] = str(error)
    calibrations = {
        channel: read_next(
            tr("calibration of channel {0}").format(channel), GetCalibration(channel)
        )
        for channel in CHANNELS
    }
    calibrated = read_next(tr("learned channels"), GetCalibratedChannels())
    progress(next(done), passes * steps, tr("done"))
    return DeviceState(
        signature, mode, serial_controls, parameters, calibrations, calibrated, unread
    )
