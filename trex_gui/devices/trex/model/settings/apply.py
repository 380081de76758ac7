"""Write edits to the board: save a snapshot, then write and verify every value."""

from collections.abc import Callable, Collection
from functools import partial
from typing import cast

from PySide6.QtCore import QObject, Signal

from trex_gui.core.errors import StudioError
from trex_gui.core.session import Outcome
from trex_gui.core.translation import tr
from trex_gui.devices.trex.board.memory import BoardMemory
from trex_gui.devices.trex.board.transaction import WriteTransaction
from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.session.messages import Write, Written
from trex_gui.devices.trex.settings.board_records import utc_now
from trex_gui.devices.trex.settings.history import SettingsHistory, Snapshot
from trex_gui.ui.files import start_in_background
from trex_gui.ui.translations import error_sentence

SendRequest = Callable[[Callable[[int], Write], Callable[[Outcome], None]], None]
"""Sends a request that it gives a number, and calls back with its outcome."""


class Apply(QObject):
    """Writes edits, one Apply at a time; failed writes stay edits.

    Every write begins with a snapshot of the stored settings, which is saved in the background;
    without one nothing is written.
    """

    changed = Signal()  # `running` has become true, or `is_saving_snapshot` false
    written = Signal(object)  # the `Written`, before `finished`; its receiver updates the draft
    finished = Signal(object)  # the `WriteResult` of every value that was tried
    failed = Signal(str)  # why nothing, or nothing more, was written, for the user

    def __init__(
        self,
        draft: SettingsDraft,
        history: SettingsHistory,
        memory: BoardMemory,
        request: SendRequest,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self.running = False
        self._draft = draft
        self._history = history
        self._memory = memory
        self._request = request
        self._cancel_snapshot: Callable[[], None] | None = None

    @property
    def is_saving_snapshot(self) -> bool:
        """Whether it can still be cancelled: nothing was sent to the board yet."""
        return self._cancel_snapshot is not None

    def start(
        self,
        state: DeviceState,
        link: ConnectionSettings | None,
        only: Collection[str] | None = None,
    ) -> None:
        """Write the edits, or those with the keys `only`."""
        parameters = tuple(
            edit for edit in self._draft.parameters.pending if only is None or edit[0] in only
        )
        calibrations = tuple(
            edit for edit in self._draft.calibrations.pending if only is None or edit[0] in only
        )
        if count := len(parameters) + len(calibrations):
            reason = tr("Apply of %n setting(s)", "", count)
            self.write(state, link, reason, parameters, calibrations)

    def write(
        self,
        state: DeviceState,
        link: ConnectionSettings | None,
        reason: str,
        parameters: tuple[tuple[str, int], ...],
        calibrations: tuple[tuple[CalibrationKey, Calibration], ...] = (),
    ) -> None:
        """Write these values; other edits stay pending, but a factory reset discards them.

        It cannot be read back, so its reply is the only confirmation.
        """
        if self.running:
            return
        self.running = True
        values = parameters, calibrations
        transaction = WriteTransaction(self._memory, state, link, values, reason=reason)
        self._cancel_snapshot = start_in_background(
            self,
            lambda _progress: transaction.take_snapshot(self._history),
            partial(self._on_saved, transaction),
            self._on_not_saved,
        )
        self.changed.emit()

    def cancel(self) -> bool:
        """Write nothing, if nothing was sent yet; return whether that is so."""
        if self._cancel_snapshot is None:
            return False
        self.end()
        return True

    def end(self) -> None:
        """Expect nothing more: the line was closed."""
        self.running = False
        if self._cancel_snapshot is not None:
            self._cancel_snapshot()
            self._cancel_snapshot = None

    def _on_saved(self, transaction: WriteTransaction, _snapshot: Snapshot) -> None:
        self._cancel_snapshot = None

        def make(number: int) -> Write:
            transaction.begin()
            return Write(number, *transaction.values, before=transaction.state)

        self._request(make, partial(self._on_written, transaction))
        if self.running:
            self.changed.emit()

    def _on_not_saved(self, error: StudioError) -> None:
        self.end()
        text = tr("Nothing was written because no snapshot could be saved first. {0}")
        self.failed.emit(text.format(error_sentence(error)))

    def _on_written(self, transaction: WriteTransaction, outcome: Outcome) -> None:
        self.running = False
        if outcome.error is not None:
            text = tr("Nothing more was written. {0}")
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
        self._draft.parameters.note_results(written.results)
        self.finished.emit(written.results)
