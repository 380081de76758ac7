"""State of a board, from the reports of its session. No Qt, threads or I/O."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from datetime import datetime
from functools import reduce
from operator import or_

from trex_gui.core.events import Event, EventKind
from trex_gui.core.session import Closed, Outcome
from trex_gui.core.translation import Number, tr
from trex_gui.devices.trex.board.errors import ErrorCounts, StatusEvents, connected_event
from trex_gui.devices.trex.board.memory import BoardMemory
from trex_gui.devices.trex.board.quality import ConnectionQuality, SpikeFilter
from trex_gui.devices.trex.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.client.client import Counters
from trex_gui.devices.trex.client.reading import DeviceState, may_be_same_board
from trex_gui.devices.trex.client.telemetry import (
    Control,
    Currents,
    LatchedStatus,
    Newest,
    Raw,
    Remapped,
    Sample,
)
from trex_gui.devices.trex.driving.blockers import DriveBlocker, Reason
from trex_gui.devices.trex.driving.board_reasons import (
    NOISE_COUNTS,
    BoardInputs,
    safe_start_reasons,
)
from trex_gui.devices.trex.driving.requests import CommandsRepeated
from trex_gui.devices.trex.driving.timeout_stop import TimeoutStop, remedy_for_silence, timeout_stop
from trex_gui.devices.trex.protocol.calibration import NEARLY_NEUTRAL
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.descriptions import describe_control
from trex_gui.devices.trex.protocol.flags import (
    MOTOR_FAULTS,
    OVER_LIMITS,
    Status,
    UartError,
    bit_names,
    channels_in,
)
from trex_gui.devices.trex.protocol.parameters import MotorParameter, ParameterKey
from trex_gui.devices.trex.session.messages import (
    Batch,
    Connected,
    LeaseChanged,
    NetworkDelay,
    NotResponding,
    ReadReason,
    Report,
    SetpointsChanged,
    Written,
)
from trex_gui.devices.trex.settings.document import settings_of
from trex_gui.devices.trex.settings.edit_files import BoardIdentity


@dataclass(frozen=True, slots=True)
class BoardRead:
    """All settings of a board were read."""

    report: Connected
    is_changed: bool  # True if the settings differ from the last reading
    is_other: bool  # True if this may be another board
    is_new: bool  # True if the board or line is new: error counts were reset


@dataclass(frozen=True, slots=True)
class MotorsShutDown:
    """The board has stopped its motors on its own.

    The next motor command would restart the motors, so only the user may send it.
    """

    reason: str  # a sentence


@dataclass(frozen=True, slots=True)
class DriveLost:
    """The board no longer follows motor commands: a motor has a fault, or channels are in control.

    One such reply is enough. If the reply was corrupted, the motors only stop needlessly.
    """

    reason: str  # a sentence


@dataclass(frozen=True, slots=True)
class QualityChanged:
    """The measured quality of the line has changed."""


BoardEvent = BoardRead | MotorsShutDown | DriveLost | QualityChanged | Sample | Event


@dataclass(frozen=True, slots=True)
class SetUp:
    """Completed steps of the set-up, according to the stored settings."""

    sticks: bool  # True if the channels of both motors are learned
    limits: bool  # True if both motors have a current limit
    timeout: bool  # True if the serial timeout is on


class SafeStart:
    """Estimate of safe-start, for which the board has no flag.

    Safe-start begins at power-up and when a required channel loses its signal. It ends when all
    driving channels are near neutral at once. Ref: TReX Jr User's Guide 4.e. Inferred: the limit of
    "near neutral", and the end of safe-start as soon as a motor draws current.
    """

    def __init__(self) -> None:
        self._is_over = False

    def may_hold(self, state: DeviceState, newest: Newest, *, joint: bool) -> bool:
        is_commanded = bool(_commands(state, newest, joint=joint))
        return is_commanded and Currents in newest.samples and not self._is_over and not joint

    def update(
        self, state: DeviceState, newest: Newest, inputs: BoardInputs | None, *, joint: bool
    ) -> None:
        values, currents = _commands(state, newest, joint=joint), newest.get(Currents)
        is_driven = currents is not None and max(currents.counts) > NOISE_COUNTS
        if not values or (inputs is not None and inputs.lacks_signal):
            self._is_over = False
        elif all(abs(value) <= NEARLY_NEUTRAL for value in values) or is_driven:
            self._is_over = True


def _commands(state: DeviceState, newest: Newest, *, joint: bool) -> tuple[int, ...]:
    """Return the commands of the driving channels. Empty in serial mode or if unknown."""
    sample = newest.get(Remapped)
    if state.mode.is_serial or sample is None:
        return ()
    first, second, third, *_ = sample.values
    return (first, third) if joint else (first, second, third)


class BoardMirror:
    """State of a board. `handle` updates it."""

    def __init__(
        self, memory: BoardMemory, errors_changed: Callable[[], None] = lambda: None
    ) -> None:
        self.memory = memory
        self.errors = ErrorCounts(errors_changed)
        self.quality = ConnectionQuality()
        self.newest = Newest()
        self.counters = Counters()  # counters of the line since it was opened
        self.settings: ConnectionSettings | None = None
        self.adapter = ""  # key of the USB adapter, set before a board is read
        self.is_responding = False
        self.is_joint = False  # active motor mode, which may differ from the stored mode
        self.echo = False  # True if sent bytes come back, as on the board's RS-232 side
        self.connected_at: float | None = None  # time when the line was opened; see `handle`
        self.connected_utc: datetime | None = None  # time when the line was opened
        self.restarts = 0  # number of detected restarts since the line was opened
        self.returns = 0  # number of recoveries from silence since the line was opened
        self.lease: LeaseChanged | None = None  # lease of a served board
        self.other_speeds = SetpointsChanged().speeds  # setpoints of another driver
        self.is_network_silent = False  # True if the server of the board does not respond
        self.network_delay: float | None = None  # round-trip time to the server, in seconds
        self.last: DeviceState | None = None  # last reading; remains after the line is closed
        self._safe_start = SafeStart()
        self._events = StatusEvents()
        self._currents = SpikeFilter()
        self._joint: dict[str, bool] = {}  # `is_joint` of unselected boards
        self._was_read = False  # True if a board was read since the line was opened

    # --- State --------------------------------------------------------------------------

    @property
    def state(self) -> DeviceState | None:
        """Stored settings of the board, or `None` without a connection."""
        return self.last if self._was_read else None

    @property
    def serial_controls(self) -> bool | None:
        """True if serial commands control the motors. `None` if unknown."""
        sample = self.newest.get(Control)
        return None if sample is None else sample.by_serial

    @property
    def control_text(self) -> str:
        if self.state is None or self.serial_controls is None:
            return ""
        return describe_control(self.state.mode, self.serial_controls, joint=self.is_joint)

    @property
    def silence(self) -> DriveBlocker:
        return DriveBlocker.NETWORK_SILENT if self.is_network_silent else DriveBlocker.SILENT

    @property
    def other_driver(self) -> str:
        return "" if self.lease is None or self.lease.is_mine else self.lease.driver

    @property
    def so_ground(self) -> bool | None:
        """False if there is no SO–G jumper. `None` if unknown.

        Inferred: with the jumper, no reply would leave SO. RS-232 uses separate pins.
        """
        return False if self.is_responding and not self.echo else None

    @property
    def set_up(self) -> SetUp | None:
        if self.state is None:
            return None
        stored = self.state.parameters.get
        limits = [stored(MotorParameter.CURRENT_LIMIT.of(motor)) for motor in (1, 2)]
        return SetUp(
            sticks={1, 2} <= set(channels_in(self.state.calibrated)),
            limits=all(limits),
            timeout=bool(stored(ParameterKey.SERIAL_TIMEOUT)),
        )

    @property
    def timeout_stop(self) -> TimeoutStop:
        """Expected effect of the serial timeout, even after the board was lost."""
        record = self.memory.record
        trial = None if record is None else record.trial
        return timeout_stop({} if self.last is None else self.last.parameters, trial)

    @property
    def silence_remedy(self) -> str:
        text = ""
        if self.last is not None and (wire := self.last.parameters.get(_TIMEOUT)):
            text = self.last.specs[_TIMEOUT].text(wire)
        return remedy_for_silence(self.timeout_stop, text)

    def inputs(self, now: float) -> BoardInputs | None:
        """Return the board's inputs to the drive status, or `None` if unknown."""
        if self.state is None or self.serial_controls is None:
            return None
        state, joint, safe_start = self.state, self.is_joint, tuple[Reason, ...]()
        stored = state.parameters.get
        if (raw := self.newest.get(Raw)) is not None:
            curves = {
                channel: ChannelCurve.stored(channel, calibration, stored)
                for channel, calibration in state.calibrations.items()
            }
            required = stored(ParameterKey.REQUIRED_CHANNELS) or 0
            safe_start = safe_start_reasons(
                curves, raw.counts, required, source=state.source, joint=joint
            )
        recent = [entry for motor in (1, 2) for entry in self.errors.recent(motor, now)]
        status = {entry.bit: entry.is_doubtful for entry in recent if isinstance(entry.bit, Status)}
        uart = (entry.bit for entry in recent if isinstance(entry.bit, UartError))
        faults = tuple(motor for motor, bit in MOTOR_FAULTS.items() if bit in status)
        return BoardInputs(
            mode=state.mode,
            by_serial=self.serial_controls,
            joint=joint,
            safe_start=safe_start,
            is_held=self._safe_start.may_hold(state, self.newest, joint=joint),
            faults=faults,
            doubtful=tuple(motor for motor in faults if status[MOTOR_FAULTS[motor]]),
            over_limit=tuple(motor for motor, bit in OVER_LIMITS.items() if bit in status),
            uart=reduce(or_, uart, UartError(0)),
            error_shutdown=state.stops_on_error,
            timeout=state.specs[_TIMEOUT].text(stored(_TIMEOUT) or 0),
        )

    # --- Reports ------------------------------------------------------------------------

    def handle(self, report: Report, now: float, utc: datetime) -> Iterator[BoardEvent]:
        """Handle a report and yield its events. Consume the iterator completely.

        `now` is in seconds of a monotonic clock.
        """
        match report:
            case Batch():
                yield from self._handle_batch(report, now, utc)
            case Connected():
                yield from self._handle_board(report, now, utc)
            case Outcome(value=Written() as written):
                self.record_written(written)
            case NotResponding(counters=counters, is_network=is_network):
                self.counters = counters
                self.is_responding, self.is_network_silent = False, is_network
                yield from self._clear()
                text = tr("The board stopped responding.")
                if is_network:
                    text = tr("The server of the robot does not respond.")
                yield Event(now, EventKind.LINK, text, is_problem=True)
            case CommandsRepeated():
                text = tr(
                    "Bytes were corrupted: motor commands are repeated until the line is quiet"
                )
                yield Event(now, EventKind.LINK, text)
            case LeaseChanged():
                yield from self._handle_lease(report, now)
            case SetpointsChanged(speeds=speeds):
                self.other_speeds = speeds
            case NetworkDelay(seconds=seconds):
                self.network_delay = seconds
            case Closed(may_move=may_move):
                yield from self.close(now, may_move=may_move)

    def _handle_lease(self, lease: LeaseChanged, now: float) -> Iterator[BoardEvent]:
        before, self.lease = self.lease, lease
        if (before.driver, before.is_mine) != (lease.driver, lease.is_mine) if before else True:
            driver = tr("this program") if lease.is_mine else lease.driver
            text = tr("Driver: {0}").format(driver or "–")
            yield Event(now, EventKind.LINK, text)

    def close(self, now: float, *, may_move: bool) -> Iterator[BoardEvent]:
        """Handle the end of the connection. `may_move` is True if no stop was confirmed."""
        was_read, self._was_read = self._was_read, False
        self.is_responding, self.connected_at, self.connected_utc = False, None, None
        self.lease = self.network_delay = None
        self.other_speeds = SetpointsChanged().speeds
        self.memory.close_board()
        yield from self._clear()
        if was_read:
            text = tr("Disconnected")
            if may_move:
                text = tr("Motors may still be turning: disconnected before a stop was confirmed")
            yield Event(now, EventKind.LINK, text, is_problem=may_move)

    def record_written(self, written: Written) -> None:
        self.last = written.state
        self.settings = written.settings

    def record_power_cycled(self) -> None:
        if self.last is not None:
            self.is_joint = _is_joint(self.last)

    def _handle_board(self, report: Connected, now: float, utc: datetime) -> Iterator[BoardEvent]:
        state, occasion = report.state, report.occasion
        is_changed = state != self.state
        before, self.last = self.last, state
        url = "" if self.settings is None else self.settings.url
        self.settings, self.echo = report.settings, report.echo
        self.is_responding = self._was_read = True
        opened = occasion is ReadReason.OPENED
        may_be_same = before is not None and may_be_same_board(before, state)
        is_other = opened or (occasion.power_cycled and before is not None and not may_be_same)
        is_known = before is not None and before.parameters == state.parameters
        is_new = is_other and not (is_known and url == report.settings.url)
        if occasion is ReadReason.SELECTED and before is not None:
            previous, selected = f"{url} {_identity(before)}", f"{url} {_identity(state)}"
            self.errors.select(previous, selected)
            self._joint[previous] = self.is_joint
            self.is_joint = self._joint.pop(selected, _is_joint(state))
        elif occasion.power_cycled or (opened and not may_be_same):
            self.is_joint = _is_joint(state)
        if occasion is not ReadReason.RELOADED:
            self._safe_start = SafeStart()
        if is_new:
            self.errors.reset()
        if opened:
            self.connected_at, self.connected_utc = now, utc
            self.restarts = self.returns = 0
            self.counters = Counters()
            self._joint.clear()
            self._events = StatusEvents()
        if occasion not in {ReadReason.RELOADED, ReadReason.SELECTED} and self.quality.reset():
            yield QualityChanged()
        self.returns += occasion is ReadReason.RETURNED
        self.restarts += occasion is ReadReason.RESTARTED
        if opened or occasion is ReadReason.SELECTED:
            self.newest.samples.clear()
            self._currents = SpikeFilter()
        self.newest.update(Control(now, state.serial_controls))
        yield BoardRead(report, is_changed, is_other, is_new)
        if (event := connected_event(report, now)) is not None:
            yield event
        self.memory.set_board(
            settings_of(state),
            state.source,
            utc,
            opened=opened or occasion is ReadReason.SELECTED,
            is_simulated=bool(report.settings.name),
            adapter=self.adapter,
        )

    def _handle_batch(self, batch: Batch, now: float, utc: datetime) -> Iterator[BoardEvent]:
        """Yield events and samples. `MotorsShutDown` precedes the samples of its batch."""
        self.counters = batch.counters
        has_failed = self.quality.has_failed_lately(now, batch.counters)
        has_crc = self.settings is not None and self.settings.line.has_crc
        is_doubtful = has_failed and not has_crc
        for sample in batch.samples:
            if isinstance(sample, LatchedStatus):
                yield from self._events.of(sample, self.errors.entries)
                self.errors.count(sample, now, utc, is_doubtful=is_doubtful)
                if reason := self._stop_reason(sample):
                    yield MotorsShutDown(reason)
        yield from self._update_quality(batch)
        for sample in batch.samples:
            filtered: Sequence[Sample] = (sample,)
            if isinstance(sample, Currents):
                filtered = self._currents.passed(sample, is_doubtful=is_doubtful)
            for passed in filtered:
                self.newest.update(passed)
                yield passed
            if isinstance(sample, LatchedStatus) and not sample.is_earlier:
                faults = [bit for bit in MOTOR_FAULTS.values() if sample.status & bit]
                names = ", ".join(tr(name) for bit in faults for name in bit_names(bit))
                if names:
                    yield DriveLost(tr("The board reports: {0}.").format(names))
            if isinstance(sample, Control) and not sample.by_serial:
                yield DriveLost(self.control_text)
        if self.state is not None and not self.state.mode.is_serial:
            self._safe_start.update(self.state, self.newest, self.inputs(now), joint=self.is_joint)

    def _stop_reason(self, latched: LatchedStatus) -> str:
        """Return the reason why the board stopped its motors, or "" if it did not.

        A timeout always counts as a stop. Other serial errors require UART-Error Shutdown (0x08).
        """
        if latched.uart & UartError.TIMEOUT:
            return tr(
                "The board received nothing within its Serial Timeout, so the motors were stopped."
            )
        if latched.uart and self.state is not None and self.state.stops_on_error:
            names = ", ".join(map(tr, bit_names(latched.uart)))
            text = tr(
                "The board stopped its motors because of an error on the line ({0}): UART-Error "
                "Shutdown is set."
            )
            return text.format(names)
        return ""

    def _update_quality(self, batch: Batch) -> Iterator[BoardEvent]:
        was_noisy, time = self.quality.is_noisy, batch.samples[-1].time
        if not self.is_responding or not self.quality.update(time, batch.counters):
            return
        if self.quality.is_noisy and not was_noisy:
            text = tr("The line is noisy: {0:.1f} % of the replies were lost or corrupted").format(
                Number(100 * self.quality.lost)
            )
            yield Event(time, EventKind.LINK, text, is_problem=True)
        elif was_noisy and not self.quality.is_noisy:
            yield Event(time, EventKind.LINK, tr("The line is good again"))
        yield QualityChanged()

    def _clear(self) -> Iterator[BoardEvent]:
        self.newest.samples.clear()
        self._safe_start, self._currents = SafeStart(), SpikeFilter()
        if self.quality.reset():
            yield QualityChanged()


_TIMEOUT = ParameterKey.SERIAL_TIMEOUT


def _is_joint(state: DeviceState) -> bool:
    return state.parameters.get(ParameterKey.MOTOR_MODE) == 1


def _identity(state: DeviceState) -> BoardIdentity:
    return BoardIdentity.of(settings_of(state))
