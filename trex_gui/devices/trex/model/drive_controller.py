"""Delivery of setpoints and stops to the board."""

import time
from collections.abc import Callable, Collection, Sequence
from dataclasses import replace
from functools import partial

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.errors import NoReply, StudioError, describe
from trex_gui.core.guardian.log import StopResult, logged_stops
from trex_gui.core.session import Closed, Outcome
from trex_gui.core.translation import tr
from trex_gui.core.transport.serial_port import latency_of
from trex_gui.devices.trex.board.mirror import BoardMirror
from trex_gui.devices.trex.client.reading import DeviceState, may_be_same_board
from trex_gui.devices.trex.driving.requests import (
    HEARTBEAT_INTERVAL,
    Arm,
    Heartbeat,
    MotorsStopped,
    SetpointRequest,
    Stop,
    is_idle,
    setpoints_in,
)
from trex_gui.devices.trex.driving.timeout_stop import turning_text
from trex_gui.devices.trex.model.connection import Connection
from trex_gui.devices.trex.model.motors import Motors
from trex_gui.devices.trex.protocol.calibration import CalibrationKey
from trex_gui.devices.trex.protocol.commands import Signature
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.descriptions import STOP_WITHOUT_EFFECT
from trex_gui.devices.trex.protocol.errors import ErrorCode, TrexError
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.protocol.raw_packets import RawPacket
from trex_gui.devices.trex.session.messages import Connected, ReadReason, SendPacket, ToBoard
from trex_gui.devices.trex.settings.document import settings_of
from trex_gui.devices.trex.settings.edit_files import BoardIdentity
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.files import in_background
from trex_gui.ui.notifier import Notifier, never
from trex_gui.ui.runtime import new_timer, now

Routed = Sequence[tuple[int | None, SetpointRequest]]  # board number in a group, and setpoint

AfterStop = Callable[[StudioError | None], None]  # called with `None` for a confirmed stop

_REFUSALS = {ErrorCode.OTHER_DRIVES, ErrorCode.MAY_NOT_DRIVE}  # a server refused to arm


class DriveController(QObject):
    """Sends setpoints and stops of the motors to the board.

    After the line was opened or fell silent, a different board may respond. The confirmations of
    this board do not count until it has been read.
    """

    changed = Signal()  # `reaches_several`, or `may_move` after a stop or a failed selection

    def __init__(
        self,
        motors: Motors,
        board: BoardMirror,
        connection: Connection,
        notifier: Notifier,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self.may_move = False  # motors were driven, and no stop has been confirmed since
        # Motors (3: the auxiliary) that were driven since the last confirmed stop
        self.driven: set[int] = set()
        self._notifier = notifier
        self._motors = motors
        self._mirror = board
        self._connection = connection
        self._lost_settings: ConnectionSettings | None = None  # line on which motors may be turning
        self._lost_place = ""  # `place` of that line
        self._board: Connected | None = None  # newest report of the board
        # Set by a group. `undrivable_board` returns `None` if all boards can be driven.
        self.routed: Callable[[SetpointRequest], Routed] = lambda request: ((None, request),)
        self.undrivable_board: Callable[[], int | None] = lambda: None
        self.named: Callable[[str], str] = str  # adds the board number in a group
        self.reaches_several = False  # commands without a number reach several boards
        self._was_read = False  # a board was read since the line was opened
        self._is_identified = False  # `_board` was read since the last silence
        self._lost: list[Connected] = []  # boards that were driven before another board replied
        self._is_loss_reported = True
        self._after_stop: list[AfterStop] = []  # callbacks for the next stop
        self._unanswered: list[AfterStop] = []  # callbacks for stops without an outcome
        self._heartbeat = new_timer(self, round(HEARTBEAT_INTERVAL * 1000), self._on_heartbeat_due)
        self._unreported = 0  # heartbeats since the last report of the session
        self._armed_at = ""  # local time in the format of the guardian's log
        self._unsent_timer = new_timer(self, 0, self._on_stop_not_sent, single_shot=True)

        motors.arming_changed.connect(self._on_arming_changed)
        motors.requested.connect(self._on_drive_requested)
        motors.stop_requested.connect(self._on_stop_requested)
        connection.reported.connect(self._on_reported)
        connection.started.connect(self._on_line_opened)
        connection.not_responding.connect(self._on_unidentified)
        connection.device_read.connect(self._on_read)
        connection.leaving.connect(lambda: motors.set_available(False))
        connection.line_closed.connect(self._on_closed)
        connection.ready.connect(self._report_lost)
        connection.motors_stopped.connect(self._on_motors_stopped)
        connection.stop_sent.connect(self._unsent_timer.stop)
        connection.line_closed.connect(self._unsent_timer.stop)

    def update_available(self) -> None:
        """Allow arming only while commands reach the motors.

        While the channels are in control, the board stores a command until channel 5 hands over
        control. A motor would then start unexpectedly.
        """
        reaches_one = self._is_connected and not self.reaches_several
        undrivable = self.undrivable_board()
        allowed = reaches_one and bool(self._mirror.serial_controls) and undrivable is None
        if allowed != self._motors.is_available:
            if self._motors.armed and self._is_connected and not allowed:
                text = tr("Serial commands no longer reach the motors.")
                if undrivable is not None:
                    self._motors.stop(tr("Board {0}: {1}").format(undrivable, text))
                else:
                    self._motors.stop(self.named(text))
            self._motors.set_available(allowed)

    def set_reaching_several(self, reaches_several: bool) -> None:
        if reaches_several != self.reaches_several:
            self.reaches_several = reaches_several
            self.update_available()
            self.changed.emit()

    def stop(self, then: AfterStop, reason: str = "") -> None:
        """Stop everything and disarm.

        `then` is called once, with an error if the stop is not confirmed.
        """
        self._after_stop.append(then)
        self._motors.stop(reason)

    def send_packet(self, packet: RawPacket, then: Callable[[Outcome], None]) -> bool:
        """Send bytes typed by the user. Return whether there is a session."""
        is_sent = self._connection.request(lambda number: SendPacket(number, packet), then)
        self.may_move = self.may_move or (is_sent and packet.moves)
        return is_sent

    @property
    def place(self) -> str:
        """Adapter of the board, or else its port."""
        settings = self._connection.settings
        return self._motors.adapter or ("" if settings is None else settings.url)

    @property
    def _is_connected(self) -> bool:
        return self._connection.link is ConnectionState.CONNECTED

    @Slot(object)
    def _on_drive_requested(self, request: SetpointRequest) -> None:
        routed = (
            part if number is None else ToBoard(number, part)
            for number, part in self.routed(request)
        )
        if all(map(self._connection.submit, routed)):
            self.may_move = True
            self.driven.update(
                setpoint.motor for setpoint in setpoints_in(request) if not is_idle(setpoint)
            )

    @Slot()
    def _on_arming_changed(self) -> None:
        if not self._motors.armed:
            self._heartbeat.stop()
        elif not self._heartbeat.isActive():
            self._connection.submit(Arm(self._connection.selection))
            self._heartbeat.start()
            self._armed_at = time.strftime("%Y-%m-%d %H:%M:%S")
            if not self._lost:  # the motors are driven again, so earlier stops no longer matter
                self._notifier.danger_lasts = never
            self._notifier.cleared.emit()

    @Slot(object)
    def _on_reported(self, _report: object) -> None:
        self._unreported = 0

    @Slot()
    def _on_heartbeat_due(self) -> None:
        """Send a heartbeat. Disarm if the session reports nothing."""
        self._connection.submit(Heartbeat(now()))
        self._unreported += 1
        seconds, settings = self._unreported * HEARTBEAT_INTERVAL, self._connection.settings
        # The limit allows for two late replies in a row. The guardian acts earlier.
        if settings and seconds >= settings.timeouts.guardian + 5 * latency_of(settings.url):
            self._motors.stop(tr("The connection is not responding."))
            self._unsent_timer.stop()
            self._on_stop_not_sent()

    @Slot()
    def _on_stop_requested(self) -> None:
        waiting, self._after_stop = self._after_stop, []
        self._unanswered += waiting

        def report(outcome: Outcome) -> None:
            self._unsent_timer.stop()
            self._on_stopped(outcome)
            self._call_back(waiting, outcome.error)

        if not self._connection.request(Stop, report):
            self._call_back(waiting, NoReply(tr("No board is connected.")))
        elif (
            self.may_move
            and self._connection.settings is not None
            and not self._unsent_timer.isActive()  # pressing Stop again must not delay the report
        ):
            self._unsent_timer.setInterval(
                round(1000 * self._connection.settings.timeouts.guardian)
            )
            self._unsent_timer.start()

    def _call_back(self, waiting: Sequence[AfterStop], error: StudioError | None) -> None:
        for then in waiting:
            if then in self._unanswered:
                self._unanswered.remove(then)
                then(error)

    @Slot()
    def _on_stop_not_sent(self) -> None:
        """Warn about a hung session. Without heartbeats, the guardian stops the motors."""
        text = tr("The connection is not responding, so the stop could not be sent.")
        parts = [turning_text(self.driven), tr("Cut the power."), text]
        if self._connection.is_guarded:
            parts.append(tr("The guardian process is sending the stop now."))
        self._notifier.warn(" ".join(parts), lasts=lambda: self.may_move)
        in_background(self, partial(logged_stops, 0), self._report_guardian, lambda _error: None)

    def _report_guardian(self, found: tuple[int, list[tuple[str, StopResult]]]) -> None:
        _, stops = found
        if any(
            stopped_at >= self._armed_at and result is StopResult.CONFIRMED
            for stopped_at, result in stops[-1:]
        ):
            self._notifier.danger_lasts = never
            self._notifier.info.emit(
                tr("The guardian process stopped the motors, and the board confirmed it.")
            )

    def _on_stopped(self, outcome: Outcome) -> None:
        if outcome.error is None:
            self._on_confirmed()
            if self._is_connected and not self._mirror.serial_controls:
                self._notifier.error.emit(tr(STOP_WITHOUT_EFFECT))
        elif self._connection.link is not ConnectionState.DISCONNECTING:
            self._notifier.error.emit(str(outcome.error))

    @Slot(object)
    def _on_motors_stopped(self, report: MotorsStopped) -> None:
        if report.reason is not None:
            reason = describe(report.reason, (report.board,), translate=tr)
            if report.reason is not ErrorCode.LEFT_GROUP:  # LEFT_GROUP names the board
                reason = self.named(reason)
            if report.reason in _REFUSALS:
                text = "{0}"
            elif report.confirmed:
                text = tr("{0} The motors were stopped. Arm the motors again to continue.")
            else:
                text = tr("{0} A stop was sent but is not confirmed yet.")
            self._notifier.error.emit(text.format(reason))
            self._motors.stop(reason)
        if report.confirmed and not self.is_group:
            self._on_confirmed()
        elif report.confirmed and report.reason is None:
            self.repeat_stop()

    @property
    def is_group(self) -> bool:
        """True for a group, whose boards confirm stops separately."""
        settings = self._connection.settings
        return settings is not None and bool(settings.group)

    def repeat_stop(self) -> None:
        """Stop every board of a group again if a stop is unconfirmed."""
        if self.may_move and not self._motors.armed:
            self._connection.request(Stop, self._on_stopped)

    def _on_confirmed(self) -> None:
        # A setpoint that was sent after the stop may have moved a motor again.
        self.may_move = self._motors.armed or (self.may_move and not self._is_identified)
        if not self.may_move:
            self.driven.clear()
        self.changed.emit()
        self._report_lost()

    # --- Boards -------------------------------------------------------------------------

    @property
    def lost_board(self) -> str:
        """Warning about a driven board that another board has replaced, or an empty string."""
        if not self._lost:
            return ""
        text = tr(
            "The stop may not have reached the {0} that was driven at {1}: another board "
            "responded. If a motor of that board is still turning, cut its power."
        )
        lost = self._lost[0]
        return text.format(_name_of(lost), lost.settings.label)

    def record_unconfirmed(self) -> None:
        self.may_move = True
        self.changed.emit()

    def record_stored(self, state: DeviceState, uncertain: Collection[str]) -> None:
        """Record stored values after a write. Values with `uncertain` keys are unknown."""
        if self._board is not None:
            parameters = {k: w for k, w in state.parameters.items() if k not in uncertain}
            calibrations = {
                channel: calibration
                for channel, calibration in state.calibrations.items()
                if CalibrationKey.of(state.source, channel) not in uncertain
            }
            known = replace(state, parameters=parameters, calibrations=calibrations)
            self._board = replace(self._board, state=known)
            if ParameterKey.DEVICE_NUMBER in parameters:
                self._motors.set_board(str(_identity_of(self._board)), is_renamed=True)

    def _identify(self, report: Connected) -> bool:
        """Record the board. Return whether a lost board is back."""
        before, self._board = self._board, report
        self._was_read = self._is_identified = True
        if report.occasion is ReadReason.SELECTED:  # selection requires a confirmed stop
            self.may_move = False
        if self.may_move and before is not None and not _may_be_same(before, report):
            self._lost.append(before)
            self._lost_settings = None
            self._is_loss_reported = False
        still_lost = [lost for lost in self._lost if not _may_be_same(lost, report)]
        is_back = len(still_lost) < len(self._lost)
        self._lost = still_lost
        return is_back

    @Slot()
    def _on_line_opened(self) -> None:
        self._was_read = self._is_identified = False

    @Slot()
    def _on_unidentified(self) -> None:
        self._is_identified = False
        self._motors.set_available(False)

    @Slot(object)
    def _on_read(self, report: Connected) -> None:
        is_back = self._identify(report)
        is_reloaded = report.occasion is ReadReason.RELOADED
        self._motors.set_board(str(_identity_of(report)), is_renamed=is_reloaded)
        if not is_reloaded:
            if report.may_move or self._motors.armed:  # while armed, setpoints may be queued
                reason = ""
                if report.occasion is ReadReason.SETTING_CHANGED:
                    reason = tr("A setting of the board changed, so the motors were stopped.")
                elif report.occasion.power_cycled:
                    reason = tr("The board was restarted, so the motors were stopped.")
                self._motors.stop(reason)
            self.may_move = report.may_move or (self.may_move and self.is_group)
            self._motors.set_available(False)
            if self.is_group:
                self.repeat_stop()
        if is_back:
            self.may_move = True
            self._motors.stop(tr("The board that was lost while it was driven is back."))

    @Slot(object)
    def _on_closed(self, last: Closed | None) -> None:
        if last is not None:
            if self._was_read:
                self.may_move = last.may_move or (self.may_move and not self._is_identified)
            if self.may_move and self._lost_settings is None:
                self._lost_settings, self._lost_place = self._connection.settings, self.place
        self._motors.set_available(False)
        unanswered, error = [*self._unanswered], None if last is None else last.error
        self._call_back(unanswered, error or TrexError(ErrorCode.CLOSED))

    @Slot()
    def _report_lost(self) -> None:
        if self._is_connected and not self._is_loss_reported and self._board is not None:
            self._is_loss_reported = True
            text = tr("Another board responds now: {0}, at {1}.")
            if self._lost and self._lost[-1].state.signature == self._board.state.signature:
                text = tr(
                    "This may be another board: the settings of {0}, at {1}, differ from "
                    "those of the board that was driven."
                )
            text = text.format(_name_of(self._board), self._board.settings.label)
            self._notifier.warn(f"{text} {self.lost_board}", lasts=lambda: bool(self._lost))
        lost, settings = self._lost_settings, self._connection.settings
        if lost is None or self.may_move or not self._is_connected:
            return
        self._lost_settings = None
        if settings is not None and self.place != self._lost_place:
            text = tr(
                "The connection to {0} was lost before a stop was confirmed. The board now "
                "at this port has confirmed a stop. If this is another board, cut the power "
                "of the first board."
            )
            self._notifier.error.emit(text.format(lost.label))


def _may_be_same(first: Connected, second: Connected) -> bool:
    """Return whether both reports may be from one board. Only simulated boards have a name."""
    has_same_name = first.settings.name == second.settings.name
    return has_same_name and may_be_same_board(first.state, second.state)


def _identity_of(board: Connected) -> BoardIdentity:
    return BoardIdentity.of(settings_of(board.state), is_simulated=bool(board.settings.name))


def _name_of(board: Connected) -> str:
    return name_of_board(board.state.signature, board.settings.device_number)


def name_of_board(signature: Signature, number: int | None) -> str:
    return str(signature) if number is None else tr("{0}, device {1}").format(signature, number)
