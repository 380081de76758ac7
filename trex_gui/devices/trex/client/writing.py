"""Writes of several values, in an order that lets a scan find the board."""

import contextlib
import logging
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from enum import Enum, auto

from trex_gui.core.errors import BadReply, BadRequest, NoReply, PortUnavailable, StudioError
from trex_gui.core.translation import tr
from trex_gui.devices.trex.client.client import Requester
from trex_gui.devices.trex.client.reading import (
    ATTEMPTS,
    DeviceState,
    Progress,
    may_be_same_board,
    other_board,
    query,
    read_everything,
    read_reliably,
)
from trex_gui.devices.trex.client.write_once import write_calibration, write_parameter
from trex_gui.devices.trex.protocol.calibration import (
    CALIBRATION_KEYS,
    DEFAULT_CALIBRATION,
    Calibration,
    CalibrationKey,
)
from trex_gui.devices.trex.protocol.commands import (
    Command,
    GetCalibration,
    GetMode,
    GetParameter,
    GetSignature,
    ReplyT_co,
    SetCalibration,
    SetParameter,
)
from trex_gui.devices.trex.protocol.errors import (
    ErrorCode,
    OtherBoard,
    Rejected,
    ResultCode,
    Skipped,
    TrexBadReplyError,
    TrexError,
    TrexNoReplyError,
)
from trex_gui.devices.trex.protocol.flags import channel_mask, channels_in
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.protocol.parameters import ParameterKey, ParameterSet

log = logging.getLogger(__name__)

_FAILURES = (BadRequest, Rejected, BadReply, NoReply, PortUnavailable)

_NOT_VERIFIED = {
    ErrorCode.PARAMETER_MISMATCH,
    ErrorCode.CALIBRATION_MISMATCH,
    ErrorCode.READINGS_DIFFER,
}

_LINE, _POLYNOMIAL = ParameterKey.UART_SETTINGS, ParameterKey.CRC7_POLYNOMIAL


@dataclass(frozen=True, slots=True)
class WriteResult:
    """Value read back after a write, or the error."""

    key: str  # key of a parameter, or a `CalibrationKey`
    stored: int | Calibration | None = None
    error: StudioError | None = None

    @property
    def channel(self) -> int | None:
        return CALIBRATION_KEYS[self.key].channel if self.key in CALIBRATION_KEYS else None


def write_all(
    request: Requester,
    specs: ParameterSet,
    parameters: Sequence[tuple[str, int]],
    calibrations: Sequence[tuple[CalibrationKey, Calibration]] = (),
    progress: Progress = lambda _done, _total, _next: None,
    *,
    before: DeviceState | None = None,
    has_crc: bool = False,
    cancelled: Callable[[], bool] = lambda: False,
    on_stored: Callable[[WriteResult], None] = lambda _result: None,
) -> tuple[WriteResult, ...]:
    """Store calibrations, then parameters. Return the result of each write.

    Calibrations come first, while their input source is active. Next come parameters that take
    effect at once, then parameters that need a power cycle. The serial settings come last.

    Inferred: if power fails during a write, the written value becomes the factory default. The
    board must still start with settings that a scan tries: the old, the new or the default
    settings. So the polynomial is changed while the stored line settings have no CRC: first if CRC
    is switched on, last if CRC is switched off. If CRC stays on while both the polynomial and the
    line settings change, the default line settings are stored in between. If only the polynomial
    changes, a power cut during its 4 ms write leaves the default polynomial, which a scan also
    tries.

    If the line is gone, or the board does not respond or is not in serial mode, no further writes
    are attempted, since they would also fail. `cancelled` also ends writing, but never between the
    serial settings. `on_stored` is called after each write whose value was read back.

    Without a CRC, one corrupted bit can turn a write into a write of another setting. So if a write
    was repeated or failed, every other setting is compared with `before` and restored, even if
    later writes were not attempted. If the board is gone or in another mode, a repeated write
    counts as failed.

    Nothing is written to a board whose settings differ from `before`. The identity of the board is
    checked again before a write that is repeated or follows a failed reading, and at the end. Two
    boards with equal model, firmware and stored values cannot be distinguished.

    Raises:
        OtherBoard: the board differs from `before`. Nothing more is written.
    """
    total = len(parameters) + len(calibrations)
    work = _Work(request, specs, total, progress, has_crc, cancelled, on_stored, before)
    work.compare_settings()
    for calibration_key, calibration in calibrations:
        work.store(calibration_key, calibration)
    ordered = sorted(parameters, key=lambda item: _write_order(specs, item[0]))
    for key, wire in ordered:
        if key not in {_LINE, _POLYNOMIAL}:
            work.store(key, wire)
    work.store_serial([item for item in ordered if item[0] in {_LINE, _POLYNOMIAL}])
    if work.has_sent and not isinstance(work.fatal_error, PortUnavailable):
        with contextlib.suppress(NoReply, BadReply, PortUnavailable):
            work.require_same_board()
    if before is not None and work.doubtful and not has_crc:
        work.undo_stray_writes(before)
    progress(total, total, "done")
    return tuple(work.results)


def after_writing(state: DeviceState, results: Sequence[WriteResult]) -> DeviceState:
    parameters, calibrations = dict(state.parameters), dict(state.calibrations)
    learned = set(channels_in(state.calibrated))
    for result in results:
        channel = result.channel
        if isinstance(result.stored, Calibration) and channel is not None:
            calibrations[channel] = result.stored
            is_learned = result.stored != DEFAULT_CALIBRATION[state.source]
            learned = (learned - {channel}) | ({channel} if is_learned else set())
        elif isinstance(result.stored, int) and result.key in parameters:
            parameters[result.key] = result.stored
    return replace(
        state, parameters=parameters, calibrations=calibrations, calibrated=channel_mask(learned)
    )


class _Route(Enum):
    POLYNOMIAL_FIRST = auto()
    LINE_FIRST = auto()
    VIA_DEFAULT = auto()


@dataclass(slots=True)
class _Work:
    request: Requester
    specs: ParameterSet
    total: int
    progress: Progress
    has_crc: bool
    cancelled: Callable[[], bool]
    on_stored: Callable[[WriteResult], None]
    before: DeviceState | None  # expected state of the board; `None` to skip the check
    results: list[WriteResult] = field(default_factory=list)
    fatal_error: StudioError | None = None  # error that ends writing
    doubtful: list[int] = field(default_factory=list)  # indexes of repeated or failed writes
    repeated: int = 0  # repeats and failures; each may have changed another setting
    unknown: set[str] = field(default_factory=set)  # keys of failed writes
    has_sent: bool = False  # True if any write was sent
    _sent: int = 0  # packets of the current write
    _has_failed: bool = False  # True if a transaction failed since the last check of the board
    _number: int | None = None  # device number that the board stores; `None` if unknown

    def compare_settings(self) -> None:
        """Raise `OtherBoard` if the stored values differ from `before`.

        Other errors set `fatal_error`. Values that differ in the first pass may be corrupted, so a
        second pass follows.
        """
        if self.before is None:
            return

        def request(command: Command[ReplyT_co]) -> ReplyT_co:
            if self.cancelled():
                raise Skipped(ErrorCode.WRITE_CANCELLED)
            return self.request(command)

        self.progress(0, self.total, tr("stored settings"))
        self._number = self.before.parameters.get(ParameterKey.DEVICE_NUMBER)
        try:
            for has_crc in (True, self.has_crc):
                state = read_everything(request, has_crc=has_crc)
                if may_be_same_board(state, self.before):
                    # The board may have been replaced while it was read.
                    signature = other_board(request, self.before.signature, self._number)
                    if signature is None:
                        return
                    raise OtherBoard(ErrorCode.OTHER_BOARD, str(signature))
        except (*_FAILURES, Skipped) as error:
            self.fatal_error = error
            return
        if state.signature != self.before.signature:
            raise OtherBoard(ErrorCode.OTHER_BOARD, str(state.signature))
        raise OtherBoard(ErrorCode.OTHER_VALUES)

    def require_same_board(self) -> None:
        """Raise `OtherBoard` if the replying board differs from `before`.

        Raises:
            NoReply, BadReply, PortUnavailable: the board cannot be read.
        """
        if self.before is not None:
            signature = other_board(self.request, self.before.signature, self._number)
            if signature is not None:
                raise OtherBoard(ErrorCode.OTHER_BOARD_AFTER_WRITING, str(signature))
        self._has_failed = False

    def _request(self, command: Command[ReplyT_co]) -> ReplyT_co:
        if isinstance(command, (SetParameter, SetCalibration)):
            if self._has_failed or self._sent:
                self.require_same_board()
            self._sent += 1
            self.has_sent = True
        try:
            return self.request(command)
        except (NoReply, BadReply):
            self._has_failed = True
            raise

    def _write(self, key: str, value: int | Calibration) -> int | Calibration:
        if isinstance(value, int):
            if key == ParameterKey.DEVICE_NUMBER:
                self._number = None
            stored = write_parameter(self._request, self.specs[key], value, has_crc=self.has_crc)
            if key == ParameterKey.DEVICE_NUMBER:
                self._number = stored
            return stored
        calibration_key = CALIBRATION_KEYS[key]
        return write_calibration(self._request, calibration_key, value, has_crc=self.has_crc)

    def undo_stray_writes(self, before: DeviceState) -> None:
        """Restore other settings that corrupted writes have changed.

        If this fails, the last repeated or failed write counts as failed. Nothing is restored if
        more settings differ than corruption can explain, because another board may be connected.
        """
        doubtful = self.doubtful
        error = self.fatal_error
        if error is None or (not isinstance(error, PortUnavailable) and self._replies(before)):
            error = self._restore_all_but_unknown(before)
        else:
            # A failed write retains its own error, which is seldom due to a stray write.
            doubtful = [index for index in doubtful if self.results[index].error is None]
        if error is not None and doubtful:
            key = self.results[doubtful[-1]].key
            stray = TrexBadReplyError(ErrorCode.STRAY_WRITE, self._name(key), error)
            self.results[doubtful[-1]] = WriteResult(key, error=stray)

    def _replies(self, before: DeviceState) -> bool:
        """True if a board with the signature and mode of `before` replies."""
        try:
            signature = query(self.request, GetSignature())
            return (signature, query(self.request, GetMode())) == (before.signature, before.mode)
        except _FAILURES:
            return False

    def _restore_all_but_unknown(self, before: DeviceState) -> StudioError | None:
        after = after_writing(before, [result for result in self.results if result.error is None])
        expected: dict[str, int | Calibration] = {**after.parameters}
        for channel, calibration in after.calibrations.items():
            expected[CalibrationKey.of(after.source, channel)] = calibration
        known = {key: value for key, value in expected.items() if key not in self.unknown}
        try:
            keys = self._differing(known)
        except _FAILURES as failure:
            return failure
        if len(keys) > self.repeated:
            return TrexBadReplyError(ErrorCode.TOO_MANY_DIFFER, len(keys))
        error: StudioError | None = None
        for _ in range(ATTEMPTS if keys else 0):
            error, keys = self._restore({key: expected[key] for key in keys})
            if error is None or _is_fatal(error):
                break
        return error

    def _differing(self, expected: Mapping[str, int | Calibration]) -> list[str]:
        """Return the keys of values that differ from `expected` or cannot be read.

        Raises:
            NoReply, BadReply, PortUnavailable: the board no longer replies.
        """
        keys = []
        for key, value in expected.items():
            try:
                differs = self._read(key) != value
            except _FAILURES:
                query(self.request, GetMode())
                differs = True
            if differs:
                keys.append(key)
        return keys

    def _restore(
        self, expected: Mapping[str, int | Calibration]
    ) -> tuple[StudioError | None, list[str]]:
        """Return the last error, and the keys of values that could not be restored."""
        last_error: StudioError | None = None
        keys: list[str] = []
        for key, value in expected.items():
            try:
                if self._read(key) != value:
                    log.warning("%s was changed by a corrupted packet and is restored", key)
                    self._write(key, value)
            except _FAILURES as error:
                last_error = error
                keys.append(key)
                if _is_fatal(error):
                    break
        return last_error, keys

    def _read(self, key: str) -> int | Calibration:
        if isinstance(key, CalibrationKey):
            return read_reliably(self._request, GetCalibration(key.channel), has_crc=self.has_crc)
        return self._read_parameter(key)

    def _read_parameter(self, key: str) -> int:
        command = GetParameter(self.specs[key].number)
        return read_reliably(self._request, command, has_crc=self.has_crc)

    def _name(self, key: str) -> str:
        if key in CALIBRATION_KEYS:
            return tr("calibration of channel {0}").format(CALIBRATION_KEYS[key].channel)
        return self.specs[key].name

    def store_serial(self, serial: list[tuple[str, int]]) -> None:
        self._check_cancelled()
        route = _Route.POLYNOMIAL_FIRST
        if self.fatal_error is None and len(dict(serial)) == 2:
            try:
                route = self._route(dict(serial))
                if route is _Route.VIA_DEFAULT:
                    self.unknown.add(_LINE)
                    self._write(_LINE, self.specs[_LINE].default)
            except _FAILURES as error:
                self.fatal_error = error
        if route is _Route.LINE_FIRST:
            serial.reverse()
        for key, wire in serial:
            self.store(key, wire, may_cancel=False)
        if route is _Route.VIA_DEFAULT:
            self._record_uncertain_line()

    def _route(self, new: Mapping[str, int]) -> _Route:
        stored = {key: self._read_parameter(key) for key in new}
        is_valid = not any(self.specs[key].problem(wire) for key, wire in new.items())
        stores_crc = _stores_crc(stored[_LINE])
        if not (is_valid and stores_crc and stored[_POLYNOMIAL] != new[_POLYNOMIAL]):
            return _Route.POLYNOMIAL_FIRST
        if not _stores_crc(new[_LINE]):
            return _Route.LINE_FIRST
        is_same = stored[_LINE] == new[_LINE]
        return _Route.POLYNOMIAL_FIRST if is_same else _Route.VIA_DEFAULT

    def _record_uncertain_line(self) -> None:
        """Replace the error of the line settings, since their default may now be stored."""
        spec = self.specs[_LINE]
        for index, result in enumerate(self.results):
            if result.key == _LINE and result.error is not None:
                fields = result.error, spec.name, spec.text(spec.default)
                is_gone = isinstance(result.error, NoReply)
                kind = TrexNoReplyError if is_gone else TrexBadReplyError
                error: StudioError = kind(ErrorCode.LINE_SETTINGS_UNCERTAIN, *fields)
                if isinstance(result.error, PortUnavailable):
                    error = PortUnavailable(str(error))
                self.results[index] = WriteResult(_LINE, error=error)

    def _check_cancelled(self) -> None:
        if self.fatal_error is None and self.cancelled():
            self.fatal_error = Skipped(ErrorCode.WRITE_CANCELLED)

    def store(self, key: str, value: int | Calibration, *, may_cancel: bool = True) -> None:
        if may_cancel:
            self._check_cancelled()
        result = WriteResult(key, error=self.fatal_error)
        if self.fatal_error is None:
            try:
                self.progress(len(self.results), self.total, self._name(key))
                self._sent = 0
                result = WriteResult(key, self._write(key, value))
            except _FAILURES as error:
                result = WriteResult(key, error=error)
                self.fatal_error = error if _is_fatal(error) else None
                self.unknown.add(key)
                if isinstance(error, TrexError) and error.code in _NOT_VERIFIED:
                    with contextlib.suppress(*_FAILURES):
                        self.on_stored(WriteResult(key, self._read(key)))
            else:
                self.on_stored(result)
            if self._sent > 1 or (self._sent and result.error is not None):
                self.doubtful.append(len(self.results))
                self.repeated += max(1, self._sent - 1)
        self.results.append(result)


def _stores_crc(wire: int) -> bool:
    """Return True if packets have a CRC at these line settings. False for invalid settings."""
    try:
        return LineSettings.from_wire(wire).detection is Detection.CRC7
    except BadRequest:
        return False


def _write_order(specs: ParameterSet, key: str) -> tuple[bool, bool, int]:
    try:
        spec = specs[key]
    except BadRequest:
        return False, False, 0
    return spec.needs_power_cycle, spec.group == "serial", spec.number


def _is_fatal(error: StudioError) -> bool:
    """True if every later write would fail for the same reason."""
    if isinstance(error, Rejected):
        return error.result is ResultCode.NOT_SERIAL_MODE
    return isinstance(error, NoReply | PortUnavailable)
