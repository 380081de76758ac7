"""Library for programs that read, set up and drive boards. See `Trex`.

A session in its own thread owns the line. It polls the boards and confirms stops. Its guardian
process stops the motors if the program is killed.
"""

import logging
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from operator import index
from pathlib import Path
from typing import Literal, Self, TypedDict, Unpack

from trex_gui.core.errors import BadRequest, NoReply, PortUnavailable
from trex_gui.core.events import Event
from trex_gui.core.files import load, save
from trex_gui.core.timing import Timeouts
from trex_gui.devices.trex.board.drive_status import (
    AUXILIARY,
    MotorSetpoint,
    drive_statuses,
    motor_setpoint,
)
from trex_gui.devices.trex.board.errors import ErrorEntry
from trex_gui.devices.trex.board.quality import ConnectionQuality
from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.client.telemetry import Control, Currents, Raw, Remapped
from trex_gui.devices.trex.driving.blockers import DriveBlocker, Reason
from trex_gui.devices.trex.driving.requests import SetAuxiliary, SetMotor, SetMotors
from trex_gui.devices.trex.open_board import NOT_OPEN, OpenBoard, OpenSession
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.descriptions import MODE_TEXT
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.errors import ErrorCode, TrexRequestError
from trex_gui.devices.trex.protocol.flags import CHANNELS
from trex_gui.devices.trex.protocol.framing import DEFAULT_POLYNOMIAL
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.recording import MeasurementTable, Row
from trex_gui.devices.trex.session.messages import (
    AskLease,
    HandOver,
    ReturnLease,
    TakeLease,
    Write,
    Written,
)
from trex_gui.devices.trex.settings.board_records import utc_now
from trex_gui.devices.trex.settings.comparison import (
    ComparisonRow,
    compare_with_board,
    values_to_write,
)
from trex_gui.devices.trex.settings.document import settings_of
from trex_gui.devices.trex.settings.history import SettingsHistory, Snapshot
from trex_gui.devices.trex.settings.notes import LONGEST_NOTE, clean_note
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.settings.writer import write_settings

log = logging.getLogger(__name__)

_STATUS_TIMEOUT = 5.0  # maximum seconds for a sample of each kind; at 1200 baud, this takes 2 s
_LEASE_TIMEOUT = 3.0  # maximum seconds until the server replies
_WRITE_TIMEOUT = 60.0  # seconds; enough to write all settings, even at 1200 baud


@dataclass(frozen=True, slots=True)
class ChannelStatus:
    """Measurements of an input channel."""

    raw: int | None  # in counts; `None` without a signal
    value: float | None  # in µs or V; `None` without a signal
    remapped: int  # after remapping by the board, -127 to 127


@dataclass(frozen=True, slots=True)
class BoardStatus:
    """Measurements, mode and errors of a board."""

    product: str
    firmware: str
    mode: str  # description of the mode, as a sentence
    serial_controls: bool  # True if motor commands reach the motors
    currents: tuple[float, float]  # motors 1 and 2, in amperes
    channels: Mapping[int, ChannelStatus]  # channel number (1 to 5) → status
    errors: tuple[str, ...]  # names of the error bits since the last status


def snapshots() -> tuple[Snapshot, ...]:
    """Return the snapshots saved on this computer, newest first.

    `Trex.apply_settings` restores a snapshot from its `path`.
    """
    return SettingsHistory().snapshots()


class Trex:
    """A TReX or TReX Jr on a serial line. Use it in a `with` statement.

    The end of the block stops the motors and closes the port, even after an error. While motors
    run, use `wait` instead of `time.sleep`. After half a second without a call, the motors are
    stopped, because a program that hangs cannot stop them. Use all methods from one thread.

    Methods raise `NoReply` or `BadReply` for a missing or invalid reply, `PortUnavailable` if the
    line is gone, `BadRequest` for an invalid value, and `MotorsStoppedError` if the motors stopped
    without a call to `stop`. Each error is a `StudioError` with a text for users.
    """

    def __init__(
        self,
        url: str,
        *,
        baud: int = 19200,
        detection: Literal["none", "even", "odd", "crc7"] = "none",
        stop_bits: int = 1,
        device_number: int | None = None,
        polynomial: int = DEFAULT_POLYNOMIAL,
        reserved: Iterable[int] = (),
        timeout: float = 0.0,
    ) -> None:
        """Describe the line.

        Args:
            url: `/dev/ttyUSB0`, `COM3`, `socket://host:port`, `rfc2217://host:port`,
                or `trex://user@host/name` for a board that another computer serves.
            baud: rate in bit/s.
            detection: parity, or CRC-7 with this `polynomial`.
            stop_bits: 1 or 2.
            device_number: 0 to 127 to address one board; `None` for the compact protocol.
            polynomial: CRC-7 polynomial, 0x80 to 0xFF.
            reserved: numbers of other devices on the line. Requires a `device_number`.
            timeout: seconds added to the deadline of each reply.
        """
        if detection.upper() not in Detection.__members__:
            raise BadRequest(f"detection must be none, even, odd or crc7, not {detection}")
        line = LineSettings(baud, Detection[detection.upper()], stop_bits)
        line.to_wire()
        reserved_numbers, timeouts = frozenset(reserved), Timeouts(extra=timeout)
        self.settings = ConnectionSettings(
            url, line, device_number, polynomial, reserved_numbers, timeouts=timeouts
        )
        _ = self.settings.framing
        self._opened: OpenBoard | None = None

    def __enter__(self) -> Self:
        """Open the port and read the board. No motor moves."""
        if self._opened is not None and self._opened.session.closed is None:
            raise PortUnavailable("The line is already open.")
        session = OpenSession(self.settings)
        (self._opened,) = session.boards.values()
        session.open()
        return self

    def __exit__(self, _kind: object, error: BaseException | None, _traceback: object) -> None:
        """Stop the motors and close the port. Raise NoReply if the stop is not confirmed."""
        if self._opened is not None:
            self._opened.session.end(error)

    def use(self, board: OpenBoard) -> None:
        """Use an open board of a `TrexLine`."""
        self._opened = board

    @property
    def _board(self) -> OpenBoard:
        if self._opened is None:
            raise PortUnavailable(NOT_OPEN)
        self._opened.session.require_open()
        return self._opened

    # --- Reading ------------------------------------------------------------------------

    @property
    def state(self) -> DeviceState:
        """Values that the board stores. The session updates them."""
        return self._board.state

    @property
    def is_responding(self) -> bool:
        """True while the board responds. `wait` and other calls update this."""
        return self._opened is not None and self._opened.mirror.is_responding

    def status(self) -> BoardStatus:
        """Return new measurements, and the errors since the last call."""
        board = self._board
        samples, start = board.mirror.newest.samples, board.session.clock()
        needed = {Raw, Remapped, Currents, Control}
        board.session.wait_for(
            lambda: needed <= {kind for kind, s in samples.items() if s.time >= start},
            _STATUS_TIMEOUT,
        )
        newest = board.mirror.newest
        state, unit = board.state, board.state.signature.model.current_unit
        currents = newest[Currents].counts
        errors, board.errors = tuple(board.errors), {}
        return BoardStatus(
            product=state.signature.model.name,
            firmware=state.signature.firmware,
            mode=MODE_TEXT[state.mode],
            serial_controls=newest[Control].by_serial,
            currents=(currents[0] * unit, currents[1] * unit),
            channels={
                channel: ChannelStatus(
                    counts, None if counts is None else state.source.physical(counts), value
                )
                for channel, counts, value in zip(
                    CHANNELS, newest[Raw].counts, newest[Remapped].values, strict=True
                )
            },
            errors=errors,
        )

    def errors(self) -> tuple[ErrorEntry, ...]:
        """Return every error bit with its remedy and its count since the port was opened."""
        return self._board.mirror.errors.entries

    def motor_status(self) -> tuple[str, ...]:
        """Return sentences that explain the state of the motors, worst first."""
        statuses = drive_statuses(self._board.drive_inputs())
        return tuple(f"{status.text} {status.remedy}".strip() for status in statuses)

    def setpoint(self, motor: int) -> MotorSetpoint:
        """Return the setpoint of motor 1, 2 or 3 (auxiliary), and its source."""
        board = self._board
        sent = board.driven.get(motor, 0)
        return motor_setpoint(motor, board.drive_inputs(), board.mirror.newest, sent)

    def events(self) -> tuple[Event, ...]:
        """Return the events since the last call. The window shows the same events in its log."""
        events = tuple(self._board.events)
        self._board.events.clear()
        return events

    @property
    def line_quality(self) -> ConnectionQuality:
        """Quality of the line. `is_noisy` is `None` until the first measurement is complete."""
        return self._board.mirror.quality

    def measurements(self, seconds: float) -> Iterator[Row]:
        """Yield a row for each new pair of motor currents.

        The rows are the same as in `trexcmd stream`. Their keys contain units: `time_s`,
        `motor_1_current_A`, `channel_1_us`, …

        Raises:
            NoReply: the board does not reply, or stops replying.
        """
        table = MeasurementTable(self.state.mode, self.state.signature.model.current_unit)
        board = self._board
        start = board.session.clock()
        while board.session.clock() - start < seconds:
            for sample in board.pump(start + seconds):
                if sample.time >= start and table.add(sample):
                    yield table.finish(sample.time - start)
        if not board.mirror.is_responding:
            raise NoReply(Reason(DriveBlocker.SILENT).text())

    # --- Settings -----------------------------------------------------------------------

    @property
    def parameters(self) -> Mapping[str, int]:
        """Parameters that were read: key → wire value."""
        return self.state.parameters

    def parameter(self, key: str) -> int:
        """Return the wire value of a parameter, such as `serial_timeout`."""
        spec = self.state.specs[key]
        if spec.key not in self.state.parameters:
            raise BadRequest(f"{spec.name} was not read: {self.state.unread.get(spec.key, '')}")
        return self.state.parameters[spec.key]

    def parameter_text(self, key: str) -> str:
        """Return a parameter with its unit, such as `0.5 s`."""
        return self.state.specs[key].text(self.parameter(key))

    def set_parameters(self, *, force: bool = False, **values: int | str) -> tuple[str, ...]:
        """Store and verify parameters. Return the changed keys.

        Each value is a wire value, or a text with its unit, such as `"0.5 s"`. `force` also sends
        a wire value that only an inferred limit forbids. Before the change, a snapshot of the
        stored values is saved in the history that the window shows.

        Raises:
            Rejected: the board does not accept a value. Other values may have been stored.
        """
        wires = {}
        for key, value in values.items():
            spec = self.state.specs[key]
            wire = spec.wire(value) if isinstance(value, str) else value
            wires[spec.key] = spec.check(wire, forced=force)
        changed = {k: wire for k, wire in wires.items() if self.state.parameters.get(k) != wire}
        self._write(parameters=tuple(changed.items()))
        return tuple(changed)

    def calibration(self, channel: int) -> Calibration:
        """Return a channel's calibration for the active input source, in counts."""
        if channel not in self.state.calibrations:
            raise BadRequest(f"No calibration of channel {channel} was read.")
        return self.state.calibrations[channel]

    def set_calibration(self, channel: int, calibration: Calibration) -> None:
        """Store a channel's calibration for the active input source. See `set_parameters`."""
        if problem := calibration.problem():
            raise BadRequest(f"channel {channel}: {problem}")
        if self.state.calibrations.get(channel) != calibration:
            key = CalibrationKey.of(self.state.source, channel)
            self._write(calibrations=((key, calibration),))

    def save_settings(self, file: str | Path) -> None:
        """Save the stored values and their notes as a settings file.

        Raises:
            StudioError: the file cannot be written.
        """
        settings = replace(settings_of(self.state), notes=self._notes())
        save(Path(file), write_settings(settings, title_lines=["Read from the board by a program"]))

    def compare_settings(self, file: str | Path) -> tuple[ComparisonRow, ...]:
        """Return the differences between the board and a settings file.

        In each row, `before` is the board's value. Calibrations of the inactive input source are
        omitted, because the board hides them.

        Raises:
            StudioError: the file cannot be used, or is for another model.
        """
        wanted, _ = read_settings(load(Path(file)), str(file))
        try:
            result = compare_with_board(settings_of(self.state), self.state.source, wanted)
        except BadRequest as error:
            raise BadRequest(f"{file}: {error}") from None
        return tuple(row for row in result.rows if row.changed)

    def lost_settings(self) -> tuple[ComparisonRow, ...]:
        """Return the differences from the settings last applied on this computer.

        A board that has the factory device number, but no applied settings, counts as the previous
        board on this adapter. Check `device_number` before you apply the result.
        """
        self._board.keeper.load()
        return self._board.keeper.memory.differing.rows

    def apply_settings(
        self, wanted: str | Path | Iterable[ComparisonRow], *, force: bool = False
    ) -> tuple[str, ...]:
        """Store the values of a settings file, or the `after` values of rows.

        Return the changed keys. Values that the board already stores are not written. Raise the
        errors of `set_parameters` and `compare_settings`.
        """
        rows = self.compare_settings(wanted) if isinstance(wanted, str | Path) else wanted
        settings = settings_of(self.state)
        stored: dict[str, object] = {**settings.parameters}
        stored |= {str(key): value for key, value in settings.calibrations.items()}
        rows = tuple(row for row in rows if stored.get(row.key) != row.after)
        parameters, calibrations = values_to_write(rows)
        for key, wire in parameters:
            self.state.specs[key].check(wire, forced=force)
        self._write(parameters, calibrations)
        return tuple(row.key for row in rows)

    def restore_defaults(self) -> None:
        """Reset every parameter at the next power cycle. See `set_parameters`.

        Calibrations do not change (inferred).

        Raises:
            BadRequest: another board on the line has the default device number.
        """
        spec = self.state.specs[ParameterKey.FACTORY_RESET]
        self._write(((spec.key, spec.maximum),))

    def set_note(self, key: str, text: str) -> None:
        """Save a note about a setting on this computer. Empty text removes the note.

        `key` is the key of a parameter, or of a calibration such as `rc_channel_2`.
        """
        notes = {**self._notes(), key: clean_note(text)[:LONGEST_NOTE].rstrip()}
        self._board.keeper.memory.set_notes({key: note for key, note in notes.items() if note})

    def _notes(self) -> Mapping[str, str]:
        self._board.keeper.load()
        record = self._board.keeper.memory.record
        return {} if record is None else record.settings.notes

    def _write(
        self,
        parameters: tuple[tuple[str, int], ...] = (),
        calibrations: tuple[tuple[CalibrationKey, Calibration], ...] = (),
    ) -> None:
        if not parameters and not calibrations:
            return
        reason = f"library: {', '.join(key for key, _ in (*parameters, *calibrations))}"
        self._board.pump(self._board.session.clock())  # raises if the board has stopped responding
        board, state = self._board, self.state
        transaction = board.keeper.prepare(state, self.settings, reason, parameters, calibrations)
        written = board.session.result(
            lambda number: board.addressed(Write(number, parameters, calibrations, before=state)),
            _WRITE_TIMEOUT,
        )
        assert isinstance(written, Written)  # noqa: S101 - for the type checker
        transaction.finish(written.results, written.state, utc_now())
        for result in written.results:
            if result.error is not None:
                raise result.error

    # --- Lease --------------------------------------------------------------------------

    @property
    def driver(self) -> str:
        """User who drives a network board. Empty for a free or a local board."""
        lease = self._board.session.lease
        return "" if lease is None else lease.driver

    def request_lease(self, seconds: float = 0.0, *, take: bool = False) -> None:
        """Request the lease of a network board from the user who drives it.

        The motors stop before the handover, for which the call waits `seconds`. An owner may `take`
        the lease. A free lease needs no call, because `drive` and every write of settings request
        it.

        Raises:
            TrexRequestError: this user may not drive, or the board was not handed over.
        """
        board = self._board
        lease = board.session.lease
        if lease is None:
            return
        if not (lease.may_take if take else lease.may_drive):
            raise TrexRequestError(ErrorCode.MAY_NOT_TAKE if take else ErrorCode.MAY_NOT_DRIVE)
        board.session.put(TakeLease() if take else AskLease())
        end = board.session.clock() + _LEASE_TIMEOUT + seconds
        while not board.session.has_lease:
            if board.session.clock() >= end:
                raise TrexRequestError(ErrorCode.OTHER_DRIVES)
            board.pump(end)

    def release_lease(self, user: str = "") -> None:
        """Stop the motors, and release a network board.

        `user` is the waiting user who receives the lease.

        Raises:
            BadRequest: `user` has not requested the lease.
        """
        self.stop()
        board = self._board
        lease = board.session.lease
        if lease is None or not lease.is_mine:
            return
        if user and user not in lease.waiting:
            raise BadRequest(f"{user} has not requested the lease.")
        board.session.put(HandOver(user) if user else ReturnLease())
        board.session.wait_for(lambda: not board.session.has_lease, _LEASE_TIMEOUT)

    # --- Motors -------------------------------------------------------------------------

    def drive(
        self,
        motor_1: int | None = None,
        motor_2: int | None = None,
        *,
        auxiliary: int | None = None,
        accelerate: bool = False,
    ) -> None:
        """Set motor speeds, -127 to 127. `None` leaves a motor unchanged.

        The speed of the auxiliary motor is 0 to 127. The motors run until `stop`, the end of the
        block, or half a second without a call. `accelerate` uses the board's acceleration.

        Raises:
            BadRequest: a speed is out of range, or serial commands do not reach the motors.
            NoReply: the board does not respond.
        """
        speeds = {1: motor_1, 2: motor_2}
        motors = [
            SetMotor(motor, Drive.at(index(speed)), accelerate)
            for motor, speed in speeds.items()
            if speed is not None
        ]
        if auxiliary is not None and not 0 <= index(auxiliary) <= 127:
            raise BadRequest(f"the auxiliary motor's speed must be 0 to 127, not {auxiliary}")
        board = self._board
        board.pump(board.session.clock())  # newer reports may forbid driving
        board.session.require_drivable()
        board.session.arm()
        board.driven |= {setpoint.motor: setpoint.drive.signed for setpoint in motors}
        if len(motors) == 2:
            board.session.put(board.addressed(SetMotors((motors[0], motors[1]))))
        elif motors:
            board.session.put(board.addressed(motors[0]))
        if auxiliary is not None:
            board.driven[AUXILIARY] = auxiliary
            board.session.put(board.addressed(SetAuxiliary(auxiliary, accelerate)))

    def stop(self) -> None:
        """Brake both motors, switch the auxiliary motor off, and wait for the confirmation.

        Raises:
            NoReply: the board does not confirm the stop.
        """
        self._board.session.stop()

    def wait(self, seconds: float) -> None:
        """Wait without stopping the motors."""
        board = self._board
        end = board.session.clock() + seconds
        while board.session.clock() < end:
            board.pump(end)


class LineOptions(TypedDict, total=False):
    """Arguments of `Trex` that all boards on a line share."""

    baud: int
    detection: Literal["none", "even", "odd", "crc7"]
    stop_bits: int
    polynomial: int
    reserved: Iterable[int]
    timeout: float


class TrexLine:
    """Boards on one line that are driven together. Use it in a `with` statement.

    Arming and stopping apply to all boards. If one board stops replying, restarts, stops by itself
    or returns to channel control, all boards stop, and the error names that board. `line[9]` is the
    `Trex` of board 9. Its `stop`, `wait` and lease apply to all boards.
    """

    def __init__(self, url: str, *, boards: Iterable[int], **options: Unpack[LineOptions]) -> None:
        """Describe the line. `boards` are device numbers, 0 to 127.

        See `Trex` for the other arguments.
        """
        numbers = tuple(boards)
        self._boards = {number: Trex(url, device_number=number, **options) for number in numbers}
        first = next(iter(self._boards.values()), Trex(url))
        self._settings = first.settings.with_group(numbers)
        self._session: OpenSession | None = None

    def __enter__(self) -> Self:
        """Open the port and read every board. No motor moves."""
        if self._session is not None and self._session.closed is None:
            raise PortUnavailable("The line is already open.")
        session = self._session = OpenSession(self._settings)
        for number, board in session.boards.items():
            if number is not None:
                self._boards[number].use(board)
        session.open()
        return self

    def __exit__(self, _kind: object, error: BaseException | None, _traceback: object) -> None:
        """Stop every motor and close the port. Raise NoReply if a stop is not confirmed."""
        if self._session is not None:
            self._session.end(error)

    def __getitem__(self, number: int) -> Trex:
        return self._boards[number]

    def __iter__(self) -> Iterator[Trex]:
        return iter(self._boards.values())

    def status(self) -> dict[int, BoardStatus]:
        """Return new measurements of each board: device number → status."""
        return {number: board.status() for number, board in self._boards.items()}

    def drive(
        self,
        motor_1: int | None = None,
        motor_2: int | None = None,
        *,
        auxiliary: int | None = None,
        accelerate: bool = False,
    ) -> None:
        """Set the same speeds on every board, or on no board. See `Trex.drive`."""
        for board in self:
            board.drive(motor_1, motor_2, auxiliary=auxiliary, accelerate=accelerate)

    def errors(self) -> dict[int, tuple[ErrorEntry, ...]]:
        """Return every error bit of each board. See `Trex.errors`."""
        return {number: board.errors() for number, board in self._boards.items()}

    def events(self) -> dict[int, tuple[Event, ...]]:
        """Return the events of each board since the last call."""
        return {number: board.events() for number, board in self._boards.items()}

    def motor_status(self) -> dict[int, tuple[str, ...]]:
        """Return sentences about the motors of each board. See `Trex.motor_status`."""
        return {number: board.motor_status() for number, board in self._boards.items()}

    def stop(self) -> None:
        """Stop every board. Raise NoReply if a board does not confirm the stop."""
        next(iter(self)).stop()

    def wait(self, seconds: float) -> None:
        """Wait without stopping the motors."""
        next(iter(self)).wait(seconds)
