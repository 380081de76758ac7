"""Verified writes to the board. A snapshot is saved first."""

from collections.abc import Callable, Collection, Mapping
from functools import partial
from typing import cast

from PySide6.QtCore import QObject, Signal

from trex_gui.core.errors import StudioError
from trex_gui.core.session import Outcome
from trex_gui.core.translation import tr
from trex_gui.devices.trex.board.mirror import BoardMirror
from trex_gui.devices.trex.board.transaction import WriteTransaction
from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.driving.timeout_stop import with_shutdown
from trex_gui.devices.trex.model.connection import Connection
from trex_gui.devices.trex.model.drive_controller import DriveController
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.parameters import ParameterKey, ParameterSpec
from trex_gui.devices.trex.session.messages import Write, Written
from trex_gui.devices.trex.session.reconnecting import LINK_KEYS, reconnect_candidates
from trex_gui.devices.trex.settings.board_records import utc_now
from trex_gui.devices.trex.settings.document import factory_settings
from trex_gui.devices.trex.settings.history import SettingsHistory, Snapshot
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.files import start_in_background
from trex_gui.ui.translations import error_sentence

_TIMEOUT = ParameterKey.SERIAL_TIMEOUT


class SettingsWriter(QObject):
    """Writes settings, one write at a time. Failed values remain edits.

    Before every write, a snapshot of the stored settings is saved in the background. Without a
    snapshot, nothing is written. `finished` or `failed` reports the result of each write.
    """

    changed = Signal()  # `running` has become true, or `is_saving_snapshot` has become false
    written = Signal(object)  # a `Written`, emitted before `finished`
    finished = Signal(object)  # a `WriteResult` for each value
    failed = Signal(str)  # reason for the user

    def __init__(
        self,
        draft: SettingsDraft,
        board: BoardMirror,
        connection: Connection,
        driving: DriveController,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self.history = SettingsHistory()  # stored settings before each write
        self.running = False
        self._draft = draft
        self._board = board
        self._connection = connection
        self._driving = driving
        self._cancel_snapshot: Callable[[], None] | None = None

    # --- State --------------------------------------------------------------------------

    @property
    def is_saving_snapshot(self) -> bool:
        """True before anything is sent, while `cancel` is still possible."""
        return self._cancel_snapshot is not None

    @property
    def is_rejected(self) -> bool:
        """True if the board rejects writes because it is not in serial mode."""
        state = self._board.state
        return self._is_connected and state is not None and not state.mode.is_serial

    @property
    def can_apply(self) -> bool:
        is_ready = self._is_connected and not self.running
        return is_ready and not self.is_rejected and not self._driving.reaches_several

    @property
    def blocker(self) -> str:
        if not self.is_rejected:
            return ""
        return tr(
            "The board accepts changes in serial mode only: switch the board off, remove the "
            "mode jumper, and switch the board on. Your edits are kept."
        )

    @property
    def _is_connected(self) -> bool:
        return self._connection.link is ConnectionState.CONNECTED

    # --- Writes -------------------------------------------------------------------------

    def apply(self, only: Collection[str] | None = None) -> None:
        """Write every edit, or only edits with these keys.

        The session first receives the new line settings, because the board may lose power during
        the write.
        """
        if self._draft.reset_pending or self._state_to_change() is None:
            return
        parameters, calibrations = self._draft.parameters, self._draft.calibrations
        self._expect_after(parameters.values.all_shown)
        changed = tuple(
            edit for edit in parameters.values.pending if only is None or edit[0] in only
        )
        curves = tuple(edit for edit in calibrations.pending if only is None or edit[0] in only)
        if count := len(changed) + len(curves):
            self.write(tr("Apply of %n setting(s)", "", count), changed, curves)

    def set_serial_timeout(self, seconds: float) -> None:
        """Write the serial timeout in seconds. 0 disables it.

        A timeout also switches on UART-Error Shutdown, which the timeout may need.

        Raises:
            BadRequest: the timeout is outside the range of the board.
        """
        self._set(_TIMEOUT, lambda spec: with_shutdown(spec.check(round(seconds / spec.scale))))

    def set_device_number(self, number: int) -> None:
        key = ParameterKey.DEVICE_NUMBER
        self._set(key, lambda spec: {key: spec.check(number)})

    def _set(self, key: str, wires_of: Callable[[ParameterSpec], Mapping[str, int]]) -> None:
        state = self._board.state
        if state is None or not self._connection.is_open:
            self.failed.emit(tr("No board is connected."))
            return
        spec, stored = state.specs[key], state.parameters
        wires = wires_of(spec)
        if key in LINK_KEYS:
            self._expect_after({**stored, **wires})
        changed = {name: wire for name, wire in wires.items() if stored.get(name) != wire}
        self.write(tr("{0} set").format(spec.name), tuple((changed or wires).items()))

    def reset_to_factory(self) -> None:
        """Request a reset of every parameter at the next start.

        Pending edits are discarded once the board accepts the request. The reply is the only
        confirmation, because the reset cannot be read back.
        """
        if self.running or (state := self._state_to_change()) is None:
            return
        self._expect_after(
            factory_settings(state.signature.model, state.signature.firmware).parameters
        )
        spec = state.specs[ParameterKey.FACTORY_RESET]
        self.write(self._draft.name_of(spec.key), ((spec.key, spec.maximum),))

    def write(
        self,
        reason: str,
        parameters: tuple[tuple[str, int], ...],
        calibrations: tuple[tuple[CalibrationKey, Calibration], ...] = (),
    ) -> None:
        """Write these values. `reason` is the title of the snapshot."""
        if self.running or (state := self._state_to_change()) is None:
            return
        self.running = True
        transaction = WriteTransaction(
            self._board.memory,
            state,
            self._connection.settings,
            (parameters, calibrations),
            reason=reason,
        )
        self._cancel_snapshot = start_in_background(
            self,
            lambda _progress: transaction.save_snapshot(self.history),
            partial(self._on_saved, transaction),
            self._on_not_saved,
        )
        self.changed.emit()

    def _state_to_change(self) -> DeviceState | None:
        if self._driving.reaches_several and self._connection.is_open:
            text = tr(
                "Nothing was written: without a device number, the write would reach every "
                "board on this line. Select a board first."
            )
            self.failed.emit(text)
            return None
        return self._board.state if self._connection.is_open else None

    def _expect_after(self, stored: Mapping[str, int]) -> None:
        state, settings = self._board.state, self._connection.settings
        if state is not None and settings is not None:
            now_stored, firmware = state.parameters, state.signature.firmware
            self._connection.expect(reconnect_candidates(settings, now_stored, stored, firmware))

    def cancel(self) -> bool:
        """Cancel a write that has not been sent yet. Return whether it was cancelled."""
        if self._cancel_snapshot is None:
            return False
        self.end()
        self.changed.emit()
        return True

    def give_up(self, reason: str) -> None:
        if self.cancel():
            self.failed.emit(reason)

    def end(self) -> None:
        self.running = False
        if self._cancel_snapshot is not None:
            self._cancel_snapshot()
            self._cancel_snapshot = None

    def _on_saved(self, transaction: WriteTransaction, _snapshot: Snapshot) -> None:
        self._cancel_snapshot = None

        def new_request(number: int) -> Write:
            transaction.start()
            return Write(number, *transaction.values, before=transaction.state)

        if not self._connection.request(new_request, partial(self._on_written, transaction)):
            self.failed.emit(tr("No board is connected."))
        if self.running:
            self.changed.emit()

    def _on_not_saved(self, error: StudioError) -> None:
        self.end()
        text = tr("Nothing was written because no snapshot could be saved first. {0}")
        self.failed.emit(text.format(error_sentence(error)))

    def _on_written(self, transaction: WriteTransaction, outcome: Outcome) -> None:
        self.running = False
        if outcome.error is not None:
            text = tr("Nothing else was written. {0}")
            self.failed.emit(text.format(error_sentence(outcome.error)))
            return
        written = cast("Written", outcome.value)
        self.written.emit(written)
        transaction.finish(written.results, written.state, utc_now())
        if any(
            result.key == ParameterKey.FACTORY_RESET and result.error is None
            for result in written.results
        ):
            self._draft.discard_edits()
            self._draft.reset_pending = True
        self._draft.parameters.record_results(written.results)
        self.finished.emit(written.results)
