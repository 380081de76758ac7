"""Board with its connection and its models."""

from pathlib import Path

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.errors import StudioError
from trex_gui.core.events import Event, EventKind
from trex_gui.core.session import Closed, Outcome
from trex_gui.core.timing import Timeouts
from trex_gui.core.translation import tr
from trex_gui.devices.trex.board import WriteResult
from trex_gui.devices.trex.board.mirror import (
    BoardMirror,
    BoardRead,
    DriveLost,
    MotorsShutDown,
    QualityChanged,
)
from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.client.telemetry import Sample
from trex_gui.devices.trex.driving.timeout_stop import turning_text
from trex_gui.devices.trex.driving.wheels import Wheel
from trex_gui.devices.trex.model.connection import Connection, MemberConnection, remedies_for
from trex_gui.devices.trex.model.drive_controller import DriveController, name_of_board
from trex_gui.devices.trex.model.motors import Motors
from trex_gui.devices.trex.model.settings.board_files import RecordFiles
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.model.settings.edit_backup import EditBackup
from trex_gui.devices.trex.model.settings.writer import SettingsWriter
from trex_gui.devices.trex.model.telemetry import MixJumper, Telemetry
from trex_gui.devices.trex.protocol.commands import Signature
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.parameters import MotorParameter, ParameterKey
from trex_gui.devices.trex.session.messages import (
    Batch,
    Connected,
    LeaseChanged,
    NetworkDelay,
    NotResponding,
    ReadReason,
    Reload,
    Report,
    SetpointsChanged,
    Written,
)
from trex_gui.devices.trex.settings.board_records import utc_now
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.log import EventLog
from trex_gui.ui.notifier import Notifier, Remedies, Remedy
from trex_gui.ui.runtime import now
from trex_gui.ui.translations import error_text

_TIMEOUT = ParameterKey.SERIAL_TIMEOUT
_MAX_NAMED = 3  # maximum number of written settings that an event names


class Device(QObject):
    link_changed = Signal()  # `link`, `status`, `settings`, `may_move`, or the state of `writer`
    quality_changed = Signal()  # line quality was measured (every 2 s)
    state_changed = Signal()  # `state` was read or cleared
    request_failed = Signal(str)  # reason for the user; also sent to the notifier
    errors_changed = Signal()  # errors were reported, cleared or reset
    lease_changed = Signal()  # driver or queue of a served board
    applied = Signal(object)  # a `WriteResult` for each value
    sampled = Signal(object)  # a `Batch`, after the models are updated
    stop_pressed_offline = Signal()  # stop was pressed while offline, and a motor may be turning

    def __init__(
        self,
        notifier: Notifier | None = None,
        parent: QObject | None = None,
        *,
        main: "Device | None" = None,
        number: int = 0,
    ) -> None:
        """`main` and `number` are for another board of a group."""
        super().__init__(parent)
        self.notifier = notifier or Notifier(self)
        self.motors = Motors(self)
        self.main = main or self  # device whose `motors` the user drives
        self.other_devices: list[Device] = []  # other boards of the group
        self.wheels: dict[int, Wheel] = {}  # motor → wheel, in a group
        self.draft = SettingsDraft(self)  # stored settings and edits
        self.parameters = self.draft.parameters
        self.calibrations = self.draft.calibrations
        self.edit_backup = EditBackup(self.draft, self)
        self.records = RecordFiles(self.draft, self)
        self.board = BoardMirror(self.records.memory, self.errors_changed.emit)
        self.telemetry = Telemetry(self.drive_of, self.board.newest, self)
        self.mix_jumper = MixJumper(self.draft, self.telemetry, self)
        self.connection: Connection = (
            Connection(self) if main is None else MemberConnection(main.connection, number, self)
        )
        self.driving = DriveController(
            self.motors, self.board, self.connection, self.notifier, self
        )
        self.writer = SettingsWriter(self.draft, self.board, self.connection, self.driving, self)
        self.events = EventLog(self)  # since the line was opened
        self._replaced: list[Path] = []  # renamed files of other boards since the last read

        self.connection.changed.connect(self.link_changed)
        self.connection.device_read.connect(self._handle)
        self.connection.commands_repeated.connect(self._handle)
        self.connection.ready.connect(self._on_ready)
        self.connection.not_responding.connect(self._on_not_responding)
        self.connection.line_closed.connect(self._on_closed)
        self.connection.sampled.connect(self._on_sampled)
        self.connection.served.connect(self._on_served)
        self.motors.arming_changed.connect(self._recommend_crc)
        self.motors.stop_requested.connect(self._on_stop_requested)
        self.connection.failed.connect(self._on_connection_failed)
        self.connection.interfered.connect(self.notifier.report)
        self.driving.changed.connect(self.link_changed)
        for backup in (self.edit_backup, self.records):
            backup.failed.connect(self.notifier.error)
        self.records.doubted.connect(self.notifier.info)
        for files in (self.edit_backup.files, self.records.files):
            files.replaced.connect(self._on_replaced)
        self.writer.written.connect(self._on_written)
        self.writer.changed.connect(self.link_changed)
        self.writer.finished.connect(self._on_applied)
        self.writer.failed.connect(self.link_changed)
        self.writer.failed.connect(self._on_request_failed)

    # --- State --------------------------------------------------------------------------

    @property
    def state(self) -> DeviceState | None:
        return self.board.state

    @property
    def signature(self) -> Signature | None:
        return None if self.state is None else self.state.signature

    @property
    def link(self) -> ConnectionState:
        return self.connection.link

    @property
    def is_connected(self) -> bool:
        return self.link is ConnectionState.CONNECTED

    @property
    def is_writable(self) -> bool:
        return self.is_connected and not self.writer.running

    @property
    def status(self) -> str:
        return self.connection.status

    @property
    def board_name(self) -> str:
        """Model, firmware and device number. Empty without a board."""
        if self.state is None or not self.is_connected:
            return ""
        number = self.parameters.values.stored.get(ParameterKey.DEVICE_NUMBER)
        return name_of_board(self.state.signature, number)

    def named(self, text: str) -> str:
        """Return the text, preceded by the board number in a group."""
        settings = self.connection.settings
        if settings is None or not self.wheels:
            return text
        return tr("Board {0}: {1}").format(settings.device_number, text)

    @property
    def settings(self) -> ConnectionSettings | None:
        return self.connection.settings

    @property
    def timeouts(self) -> Timeouts:
        settings = self.connection.settings
        return Timeouts() if settings is None else settings.timeouts

    @property
    def may_move(self) -> bool:
        return self.main.driving.may_move

    def drive_of(self, motor: int) -> Drive | None:
        """Return the setpoint of motor 1 or 2. `None` without a setpoint."""
        if not self.wheels:
            return self.main.motors.drive(motor)
        wheel = self.wheels.get(motor)
        return None if wheel is None else wheel.motor_drive(self.main.motors.drive(wheel.side))

    def current_limit(self, motor: int) -> float | None:
        """Return the stored limit in A. `None` if off or unknown."""
        key = MotorParameter.CURRENT_LIMIT.of(motor)
        wire = self.parameters.values.stored.get(key)
        return wire * self.parameters.values.specs[key].scale if wire else None

    @property
    def loss_text(self) -> str:
        return f"{turning_text(self.driving.driven)} {self.board.silence_remedy}"

    def warn(self, cause: str, remedies: Remedies = ()) -> None:
        """Show `loss_text` and the cause of the loss until a stop is confirmed."""
        text = self.named(f"{self.loss_text} {cause}")
        self.notifier.warn(text, remedies, lambda: self.stop_may_matter)

    @property
    def serial_timeout_s(self) -> float | None:
        """Serial timeout in seconds. 0: off; `None`: unknown."""
        if self.state is None or _TIMEOUT not in self.state.parameters or not self.is_connected:
            return None
        return self.state.serial_timeout

    # --- User actions -------------------------------------------------------------------

    def connect_to(self, settings: ConnectionSettings) -> None:
        """Close an open line, then open this line and read the board."""
        may_move = self.may_move or bool(self.driving.lost_board)
        self.connection.open(settings, may_move=may_move)

    def set_visible(self, visible: bool) -> None:
        """Record whether a window is visible. Without a watcher, the board is polled slowly."""
        self.connection.watch("window", visible)
        self.telemetry.set_visible(visible)

    def disconnect_line(self) -> None:
        """Stop driven motors and close the line, without waiting."""
        self.connection.close()

    def press_stop(self) -> None:
        if self.link is not ConnectionState.DISCONNECTED:
            self.motors.press_stop()
        elif self.stop_may_matter:
            self.stop_pressed_offline.emit()

    @property
    def stop_may_matter(self) -> bool:
        """True if a motor may be turning because of this program."""
        return self.may_move or bool(self.main.driving.lost_board)

    def shut_down(self) -> bool:
        return self.connection.shut_down()

    def reload(self) -> None:
        if not self.connection.request(Reload, self._on_reloaded):
            self._on_request_failed(tr("No board is connected."))

    def record_power_cycled(self) -> None:
        if self.state is not None:
            self.board.record_power_cycled()
            self.draft.set_state(self.state, self.settings, power_cycled=True)
            self.state_changed.emit()
            self.link_changed.emit()

    # --- Requests and their outcomes ----------------------------------------------------

    def _on_reloaded(self, outcome: Outcome) -> None:
        if outcome.error is not None:
            text = tr("The settings could not be read again. {0}")
            self._on_request_failed(text.format(error_text(outcome.error)))

    @Slot(object)
    def _on_applied(self, results: tuple[WriteResult, ...]) -> None:
        self.link_changed.emit()
        done = [self.draft.name_of(result.key) for result in results if result.error is None]
        failed = len(results) - len(done)
        text = ", ".join(done[:_MAX_NAMED])
        if len(done) > _MAX_NAMED:
            text = tr("{0} and {1} more").format(text, len(done) - _MAX_NAMED)
        if failed:
            text = tr("{0} ({1} failed)").format(text, failed).strip()
        self.events.add(EventKind.APPLY, tr("Apply: {0}").format(text), is_problem=failed > 0)
        self.applied.emit(results)

    @Slot()
    def _on_stop_requested(self) -> None:
        reason = self.motors.stop_reason
        self.events.add(EventKind.STOP, tr("Stop: {0}").format(reason) if reason else tr("Stop"))

    @Slot(object)
    def _on_connection_failed(self, error: StudioError) -> None:
        text = error_text(error)
        self.request_failed.emit(text)
        if self.may_move:
            self.warn(text, remedies_for(error))
        else:
            self.notifier.report(text, remedies_for(error))

    @Slot(str)
    def _on_request_failed(self, reason: str) -> None:
        self.request_failed.emit(reason)
        self.notifier.error.emit(reason)

    # --- Reports from the line ----------------------------------------------------------

    @Slot(object)
    def _handle(self, report: Report) -> None:
        self.board.adapter = self.motors.adapter
        for event in self.board.handle(report, now(), utc_now()):
            match event:
                case Sample():
                    self.telemetry.add(event)
                case Event():
                    self.events.put(event)
                case BoardRead():
                    self._on_read(event)
                case MotorsShutDown(reason=reason):
                    if self.main.motors.text:
                        self.main.motors.stop(self.named(reason))
                case DriveLost(reason=reason):
                    if self.wheels and self.main.motors.armed:
                        self.main.motors.stop(self.named(reason))
                case QualityChanged():
                    self.quality_changed.emit()

    def _on_read(self, read: BoardRead) -> None:
        self._replaced.clear()
        state, occasion = read.report.state, read.report.occasion
        if occasion is ReadReason.SELECTED:
            self._on_selected(read.report)
            return
        pending, before = self.draft.pending, self.draft.stored
        if read.is_changed:
            self.writer.give_up(
                tr("Nothing was written: the settings read from the board have changed.")
            )
        if read.is_new:
            self.calibrations.clear_last_known()
        is_same_kind = self.parameters.model_key == state.signature.model.key
        if pending and before is not None and not is_same_kind:
            text = tr(
                "%n unapplied edit(s) of the previous {0} saved. They are offered when that "
                "board is connected again.",
                "",
                pending,
            )
            self.notifier.delayed_info.emit(text.format(f"{before.product.name} {before.firmware}"))
        if pending and is_same_kind and read.is_other:
            text = tr(
                "%n earlier change(s) still pending. Review them to write to this board.",
                "",
                pending,
            )
            self.notifier.delayed_info.emit(text)
        opened = occasion is ReadReason.OPENED
        if opened:
            self.events.clear()
        unit = state.signature.model.current_unit
        if opened or unit != self.telemetry.ampere:  # another model may be on the line now
            self.telemetry.start(unit)
        self.edit_backup.close_board()
        self.draft.set_state(
            state, read.report.settings, power_cycled=occasion.power_cycled, opened=opened
        )
        self._handle_files(read.report, opened=opened)

    def _handle_files(self, report: Connected, *, opened: bool) -> None:
        """Read the saved files of the board. `opened` is true if this may be another board."""
        state, is_simulated = report.state, bool(report.settings.name)
        self.edit_backup.set_board(opened=opened, is_simulated=is_simulated)
        self.records.set_kind(state.signature, opened=opened, is_simulated=is_simulated)

    def _on_selected(self, report: Connected) -> None:
        self.writer.give_up(tr("Nothing was written: another board was selected."))
        if pending := self.draft.pending:
            text = tr(
                "%n edit(s) of the previous board saved. They return when that board is "
                "selected again.",
                "",
                pending,
            )
            self.notifier.delayed_info.emit(text)
        self.telemetry.start(report.state.signature.model.current_unit)
        self.edit_backup.close_board(is_deselected=True)
        self.draft.select_state(report.state, report.settings)
        self._handle_files(report, opened=True)

    @Slot(object)
    def _on_replaced(self, path: Path) -> None:
        """Report all files so far, because each message replaces the previous message."""
        self._replaced.append(path)
        text = tr(
            "Edits, notes or settings of another board with this device number were already "
            "saved. They were moved to {0}."
        )
        self.notifier.info.emit(text.format(", ".join(map(str, self._replaced))))

    @Slot(object)
    def _on_not_responding(self, report: NotResponding) -> None:
        self._handle(report)
        self.telemetry.report_cleared()
        self.writer.give_up(tr("Nothing was written: the board does not respond."))
        if self.may_move and report.is_network:
            self.warn(tr("The network is not responding; the robot's server stops the motors."))
        elif self.may_move:
            self.warn(tr("The board does not respond; the stop is being repeated."))

    @Slot(object)
    def _on_written(self, written: Written) -> None:
        self._replaced.clear()
        self.board.record_written(written)
        self.connection.settings = written.settings
        self.draft.record_stored(written.state)
        uncertain = written.uncertain
        if self.draft.reset_pending:
            uncertain |= written.state.parameters.keys()
        self.driving.record_stored(written.state, uncertain)
        self.state_changed.emit()

    @Slot()
    def _on_ready(self) -> None:
        self.driving.update_available()
        self.state_changed.emit()

    @Slot(object)
    def _on_sampled(self, batch: Batch) -> None:
        self._handle(batch)
        self.telemetry.finish()
        self.driving.update_available()
        self.sampled.emit(batch)

    @Slot(object)
    def _on_served(self, report: LeaseChanged | SetpointsChanged | NetworkDelay) -> None:
        self._handle(report)
        if isinstance(report, LeaseChanged):
            self.lease_changed.emit()
        if not isinstance(report, SetpointsChanged):  # views show setpoints with the next samples
            self.link_changed.emit()

    @Slot()
    def _recommend_crc(self) -> None:
        settings = self.settings
        is_noisy = self.board.quality.is_noisy
        if self.motors.armed and is_noisy and settings and not settings.line.has_crc:
            text = tr("Noise on the line can make a motor turn the wrong way for a moment.")
            self.notifier.report(text, (Remedy.SET_UP_CRC,))

    @Slot(object)
    def _on_closed(self, last: Closed | None) -> None:
        self._handle(last or Closed(None, may_move=False))
        self.writer.end()
        self.telemetry.report_cleared()
        self.state_changed.emit()
