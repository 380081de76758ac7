"""The board as the window sees it: the connection to it, and the models that mirror it."""

from collections.abc import Callable, Collection, Mapping

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.errors import StudioError
from trex_gui.core.session import Closed, Outcome
from trex_gui.core.timing import Timeouts
from trex_gui.devices.trex.client.explanations import who_controls
from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.client.telemetry import LatchedStatus
from trex_gui.devices.trex.client.writing import WriteResult
from trex_gui.devices.trex.discovery.reconnect_candidates import reconnect_candidates
from trex_gui.devices.trex.model.board_state import in_force
from trex_gui.devices.trex.model.connection import Connection
from trex_gui.devices.trex.model.drive_controller import (
    SHUTDOWN,
    AfterStop,
    DriveController,
    why_the_board_stopped,
)
from trex_gui.devices.trex.model.errors import ErrorLog
from trex_gui.devices.trex.model.event_watch import EventWatch
from trex_gui.devices.trex.model.motors import Motors
from trex_gui.devices.trex.model.parameters.text import ParameterColumn
from trex_gui.devices.trex.model.settings.apply import Apply, PendingReset
from trex_gui.devices.trex.model.settings.draft import EditBackup, SettingsDraft
from trex_gui.devices.trex.model.telemetry import Telemetry
from trex_gui.devices.trex.protocol.calibration import CALIBRATION_KEYS
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import suggests_scan
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.session.messages import (
    Batch,
    Connected,
    ReadReason,
    Reload,
    SetReconnectCandidates,
    Write,
    Written,
)
from trex_gui.devices.trex.settings.document import factory_settings
from trex_gui.devices.trex.settings.history import SettingsHistory
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.event_log import EventLog
from trex_gui.ui.notifier import Notifier

_TIMEOUT = ParameterKey.SERIAL_TIMEOUT

__all__ = ["AfterStop", "Device"]


class Device(QObject):
    """One board, or none.

    Signals:
        link_changed: `link`, `status` or `settings`.
        state_changed: `state` was read anew, or forgotten.
        progressed: steps done, steps in all, what comes next.
        request_failed: why a connection ended or a request failed; the notifier reports it, too.
        applied: the `WriteResult` of everything that Apply tried.
        sampled: a `Batch`; the models of the device have taken it in.
        pending_changed: how many edits of parameters and calibrations wait for Apply.

    Attributes:
        draft: what the board stores and the edits of it; `parameters`, `calibrations` and `undo`
            are its parts.
        connection: the line to the board, its traffic and counters.
        history: what boards stored before each Apply.
        events: what happened since the line was opened, on the clock of `telemetry`.
    """

    link_changed = Signal()
    state_changed = Signal()
    progressed = Signal(int, int, str)
    request_failed = Signal(str)
    applied = Signal(object)
    sampled = Signal(object)
    pending_changed = Signal(int)

    def __init__(self, notifier: Notifier | None = None, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.notifier = notifier or Notifier(self)
        self.motors = Motors(self)
        self.telemetry = Telemetry(self.motors, self)
        self.errors = ErrorLog(self)
        self.draft = SettingsDraft(self)
        self.undo = self.draft.undo
        self.parameters = self.draft.parameters
        self.calibrations = self.draft.calibrations
        self.history = SettingsHistory()
        self._apply = Apply(self.draft, self.history, self._ask, self)
        self.connection = Connection(self)
        self._driving = DriveController(self.motors, self.connection, self.notifier, self)
        self.events = EventLog(self)
        self._event_watch = EventWatch(self.events, self.motors, self.connection, self)
        self._kept = EditBackup(self.history, self.notifier, self)
        self._reset_order = PendingReset()
        self._state: DeviceState | None = None

        self.connection.changed.connect(self.link_changed)
        self.connection.device_read.connect(self._on_answered)
        self.connection.ready.connect(self._on_settled)
        self.connection.not_responding.connect(self._on_silenced)
        self.connection.line_closed.connect(self._on_left)
        # In this order: the models have taken a batch before the device reports it.
        self.connection.sampled.connect(self._on_sampled)
        self.connection.sampled.connect(self.telemetry.take)
        self.connection.sampled.connect(self._follow_control)
        self.connection.sampled.connect(self.sampled)
        self.connection.progressed.connect(self.progressed)
        self.connection.failed.connect(self._on_connection_failed)
        self._driving.confirmed.connect(self.link_changed)
        self.draft.pending_changed.connect(self.pending_changed)
        self.draft.replacing.connect(self._kept.keep)
        self._apply.written.connect(self._on_written)
        self._apply.started.connect(self.link_changed)
        self._apply.finished.connect(self._on_applied)
        self._apply.failed.connect(self._on_apply_failed)

    # --- What is known ------------------------------------------------------------------

    @property
    def link(self) -> ConnectionState:
        return self.connection.link

    @property
    def status(self) -> str:
        """State of the connection as a sentence."""
        return self.connection.status

    @property
    def settings(self) -> ConnectionSettings | None:
        """How the line is, or was last, opened."""
        return self.connection.settings

    @property
    def timeouts(self) -> Timeouts:
        """How long to wait on this line."""
        settings = self.connection.settings
        return Timeouts() if settings is None else settings.timeouts

    @property
    def state(self) -> DeviceState | None:
        """What the board said of itself; `None` while none answers."""
        return self._state

    def name_of(self, key: str) -> str:
        """Return the name of a parameter or of a calibrated channel."""
        if key in CALIBRATION_KEYS:
            return CALIBRATION_KEYS[key].label
        index = self.parameters.index_of(key, ParameterColumn.NAME)
        return str(index.data()) if index.isValid() else key

    @property
    def is_joint(self) -> bool:
        """Whether both drivers work as one motor now, whatever is stored for the next start."""
        return self.parameters.active_of(ParameterKey.MOTOR_MODE) == 1

    @property
    def control_text(self) -> str:
        """Who controls the motors, as a sentence; empty while no board answers."""
        if self._state is None or self.link is not ConnectionState.CONNECTED:
            return ""
        seen = self.telemetry.serial_controls
        by_serial = self._state.serial_controls if seen is None else seen
        return who_controls(self._state.mode, by_serial, joint=self.is_joint)

    @property
    def reset_ordered(self) -> bool:
        """Whether the board will reset its parameters at its next start.

        What is written before that is wiped then.
        """
        return self._reset_order.is_pending

    @property
    def may_move(self) -> bool:
        """Whether motors were driven and no stop was confirmed since, connected or not."""
        return self._driving.may_move

    @property
    def serial_timeout_s(self) -> float | None:
        """Seconds of silence after which the board stops its motors by itself, 0 for never.

        `None` while no board answers, or where it was not read.
        """
        wire = None if self._state is None else self._state.parameters.get(_TIMEOUT)
        if self._state is None or wire is None or self.link is not ConnectionState.CONNECTED:
            return None
        return wire * self._state.specs[_TIMEOUT].scale

    @property
    def applying(self) -> bool:
        """Whether edits are being written."""
        return self._apply.running

    # --- User actions -------------------------------------------------------------------

    def connect_to(self, settings: ConnectionSettings) -> None:
        """Open a line and read everything; ends in `ConnectionState.CONNECTED` or in `failed`.

        A line that is open is closed first.
        """
        self.connection.open(settings, may_move=self.may_move)

    def disconnect_line(self) -> None:
        """Stop the motors if they were driven, and close the line; does not wait for it."""
        self.connection.close()

    def shut_down(self) -> bool:
        """Close the line and wait for it, at most a second; return whether it ended in time.

        For the end of the program only; see `SessionThread.shut_down`.
        """
        return self.connection.shut_down()

    def stop_motors(self, then: AfterStop, reason: str = "") -> None:
        """Stop everything and disarm; `then` is called once with the confirmation or its error.

        If the connection ends before that, `then` is not called; `link_changed` is emitted.
        """
        self._driving.stop(then, reason)

    def stop_now(self, *, ending: bool = False) -> None:
        """Stop every motor, from any thread; see `Connection.stop_now`."""
        self._driving.stop_now(ending=ending)

    def set_serial_timeout(self, seconds: float) -> None:
        """Write how long the board waits for a byte before it stops its motors, 0 for ever.

        Only that is written, at once, after a snapshot, and read back; `applied` reports the
        result.

        Raises:
            BadRequest: the board cannot wait so long.
        """
        if self._state is None or not self.connection.is_open:
            self._on_request_failed(self.tr("No board is connected."))
            return
        spec = self._state.specs[_TIMEOUT]
        self._apply.store(
            self._state, self.settings, _TIMEOUT, spec.check(round(seconds / spec.scale))
        )

    def reload(self) -> None:
        """Read everything from the board again."""
        self._ask(Reload, self._on_reloaded)

    def apply(self, only: Collection[str] | None = None) -> None:
        """Write every edit, or those with these keys, and read it back; see `Apply.start`.

        `applied` reports the result. Before the first byte the session gets the settings at which
        the board may be afterwards, since its power may fail right behind the write.
        """
        if self._state is not None and self.connection.is_open and not self.reset_ordered:
            self._expect_after(self.parameters.all_shown)
            self._apply.start(self._state, self.settings, only)

    def reset_to_factory(self) -> None:
        """Let the board put every parameter back at its next start; a snapshot is saved first.

        Pending edits are discarded: the values they change will be gone. `applied` reports the
        result.
        """
        if self._state is None or not self.connection.is_open or self.applying:
            return
        defaults = factory_settings(self._state.signature.model, self._state.signature.firmware)
        self._expect_after(defaults.parameters)
        if self._apply.reset(self._state, self.settings):
            self.draft.discard_edits()

    def note_power_cycled(self) -> None:
        """Note that the user reports a power cycle of the board."""
        self._reset_order.forget()
        if self._state is not None:
            self.draft.take_state(self._state, power_cycled=True)
            self.parameters.note_active(in_force(self._state, self.settings))
            self.state_changed.emit()
            self.link_changed.emit()

    def _expect_after(self, stored: Mapping[str, int]) -> None:
        """Look for the board where it will be with these values, too, should it fall silent."""
        if self._state is None or self.settings is None:
            return
        firmware = self._state.signature.firmware
        self.expect(reconnect_candidates(self.settings, self._state.parameters, stored, firmware))

    def expect(self, settings: tuple[ConnectionSettings, ...]) -> None:
        """Set where to look for the board if it stops responding."""
        self.connection.submit(SetReconnectCandidates(settings))

    @property
    def pending(self) -> int:
        """How many edits of parameters and calibrations wait for Apply."""
        return self.draft.pending

    def discard_edits(self) -> None:
        """Go back to what the board stores; one step to undo."""
        self.draft.discard_edits()

    # --- Requests and their outcomes ----------------------------------------------------

    def _ask(self, make: Callable[[int], Reload | Write], then: Callable[[Outcome], None]) -> None:
        if not self.connection.ask(make, then):
            self._on_request_failed(self.tr("No board is connected."))

    def _on_reloaded(self, outcome: Outcome) -> None:
        if outcome.error is not None:
            self._on_request_failed(self.tr("Reading again failed. {0}").format(outcome.error))

    @Slot(object)
    def _on_applied(self, results: tuple[WriteResult, ...]) -> None:
        if self._state is not None:
            self._reset_order.note_written(results, self._state.parameters)
        self.link_changed.emit()
        names = tuple(self.name_of(result.key) for result in results)
        self._event_watch.note_applied(results, names)
        self.applied.emit(results)

    @Slot(str)
    def _on_apply_failed(self, reason: str) -> None:
        self.link_changed.emit()
        self._on_request_failed(reason)

    @Slot(object)
    def _on_connection_failed(self, error: StudioError) -> None:
        text = str(error)
        self.request_failed.emit(text)
        if suggests_scan(error):
            text = self.tr("{0} Find a board (Ctrl+Shift+F) tries every setting.").format(text)
        self.notifier.error.emit(text)

    @Slot(str)
    def _on_request_failed(self, reason: str) -> None:
        self.request_failed.emit(reason)
        self.notifier.error.emit(reason)

    # --- Reports from the line ----------------------------------------------------------

    @Slot(object)
    def _on_answered(self, report: Connected) -> None:
        state, occasion = report.state, report.occasion
        self._state = state
        if occasion is ReadReason.OPENED:
            if self.pending and self.parameters.model_key == state.signature.model.key:
                text = self.tr(
                    "{0} earlier changes are still pending. Click Apply to write them to this "
                    "board."
                )
                self.notifier.delayed_info.emit(text.format(self.pending))
            self.telemetry.begin(state.signature.model.current_unit)
        self.telemetry.serial_controls = state.serial_controls
        self._reset_order.note_read(state.parameters, power_cycled=occasion.power_cycled)
        self.draft.take_state(state, power_cycled=occasion.power_cycled)
        self.parameters.note_active(in_force(state, report.settings))

    @Slot(object)
    def _on_written(self, written: Written) -> None:
        self._state = written.state
        self.connection.follow(written.settings)
        self.draft.note_stored(written.state)
        self.state_changed.emit()

    @Slot()
    def _on_settled(self) -> None:
        self._follow_control()
        self.state_changed.emit()

    @Slot(object)
    def _on_sampled(self, batch: Batch) -> None:
        for sample in batch.samples:
            if isinstance(sample, LatchedStatus):
                self.errors.take(sample)
                self._follow_board_stop(sample)

    def _follow_board_stop(self, news: LatchedStatus) -> None:
        """Drop the setpoints of motors that the board has stopped by itself."""
        errors_stop = bool(self._state and self._state.parameters.get(SHUTDOWN))
        why = why_the_board_stopped(news, errors_stop=errors_stop)
        if why and self.motors.text:
            self.motors.stop(why)

    @Slot()
    def _follow_control(self) -> None:
        self._driving.follow(by_serial=bool(self.telemetry.serial_controls))

    @Slot()
    def _on_silenced(self) -> None:
        self.telemetry.forget()
        self.parameters.set_editable(False)

    @Slot(object)
    def _on_left(self, _last: Closed | None) -> None:
        """Know nothing of any board any more."""
        self._state = None
        self._apply.forget()
        self.telemetry.forget()
        self.parameters.set_editable(False)
        self.state_changed.emit()
