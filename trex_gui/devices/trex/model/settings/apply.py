"""Write edits to the board: save a snapshot, then write and verify every value."""

from collections.abc import Callable, Collection, Mapping, Sequence
from typing import cast

from PySide6.QtCore import QObject, Signal

from trex_gui.core.errors import sentence
from trex_gui.core.files import SettingsError
from trex_gui.core.session import Outcome
from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.client.writing import WriteResult
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.session.messages import Write, Written
from trex_gui.devices.trex.settings.document import settings_of
from trex_gui.devices.trex.settings.history import SettingsHistory

Ask = Callable[[Callable[[int], Write], Callable[[Outcome], None]], None]
"""Sends a request that it gives a number, and calls back with its outcome."""


class Apply(QObject):
    """Writes edits, one Apply at a time; failed writes stay edits.

    Signals:
        started: it is being written.
        written: the `Written`, before `finished`; its receiver updates the draft.
        finished: the `WriteResult` of everything that was tried; the draft has taken them in.
        failed: why nothing, or nothing more, was written, for the user.
    """

    started = Signal()
    written = Signal(object)
    finished = Signal(object)
    failed = Signal(str)

    def __init__(
        self,
        draft: SettingsDraft,
        history: SettingsHistory,
        ask: Ask,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._draft = draft
        self._history = history
        self._ask = ask
        self._running = False

    @property
    def running(self) -> bool:
        """Whether edits are being written."""
        return self._running

    def start(
        self,
        state: DeviceState,
        link: ConnectionSettings | None,
        only: Collection[str] | None = None,
    ) -> None:
        """Write the edits, or those of them with the keys that a settings file would give them.

        A snapshot of what the board stores is saved first; without one nothing is written.
        """
        parameters = tuple(
            (key, wire)
            for key, wire in self._draft.parameters.pending
            if only is None or key in only
        )
        calibrations = tuple(
            (key, wanted)
            for key, wanted in self._draft.calibrations.pending
            if only is None or key in only
        )
        count = len(parameters) + len(calibrations)
        if count:
            reason = self.tr("Apply of %n setting(s)", "", count)
            self._write(state, link, reason, parameters, calibrations)

    def store(
        self, state: DeviceState, link: ConnectionSettings | None, key: str, wire: int
    ) -> bool:
        """Write one parameter now; other edits stay pending. Return whether it was sent."""
        reason = self.tr("{0} set").format(state.specs[key].name)
        return self._write(state, link, reason, ((key, wire),), ())

    def reset(self, state: DeviceState, link: ConnectionSettings | None) -> bool:
        """Request a reset of every parameter to its default at the next start.

        The request cannot be read back, so its reply is the only confirmation. Return whether
        it was sent.
        """
        order = state.specs[ParameterKey.FACTORY_RESET]
        reason = self.tr("Reset to factory defaults")
        return self._write(state, link, reason, ((order.key, order.maximum),), ())

    def _write(
        self,
        state: DeviceState,
        link: ConnectionSettings | None,
        reason: str,
        parameters: tuple[tuple[str, int], ...],
        calibrations: tuple[tuple[CalibrationKey, Calibration], ...],
    ) -> bool:
        if self._running or not self._keep(state, link, reason):
            return False
        self._running = True
        self._ask(lambda number: Write(number, parameters, calibrations), self._on_written)
        if self._running:
            self.started.emit()
        return self._running

    def _keep(self, state: DeviceState, link: ConnectionSettings | None, reason: str) -> bool:
        """Save what the board stores before it is changed; return whether that worked."""
        adapter = "" if link is None else link.name or link.url
        try:
            self._history.take(settings_of(state), adapter=adapter, reason=reason)
        except SettingsError as error:
            text = self.tr("Nothing was written, since no snapshot could be saved first. {0}")
            self.failed.emit(text.format(sentence(error)))
            return False
        return True

    def forget(self) -> None:
        """Stop waiting for an outcome: the line is closed."""
        self._running = False

    def _on_written(self, outcome: Outcome) -> None:
        self._running = False
        if outcome.error is not None:
            self.failed.emit(self.tr("Nothing more was written. {0}").format(outcome.error))
            return
        written = cast("Written", outcome.value)
        self.written.emit(written)
        self._draft.parameters.note_results(written.results)
        self.finished.emit(written.results)


class PendingReset:
    """Whether a board will reset itself at its next start, as far as its values show."""

    def __init__(self) -> None:
        self._given_at: dict[str, int] | None = None

    @property
    def is_pending(self) -> bool:
        """Whether values written now will be lost at the next start."""
        return self._given_at is not None

    def note_written(self, results: Sequence[WriteResult], stored: Mapping[str, int]) -> None:
        """Look for the reset request among the results."""
        if any(
            result.key == ParameterKey.FACTORY_RESET and result.error is None for result in results
        ):
            self._given_at = dict(stored)

    def note_read(self, stored: Mapping[str, int], *, power_cycled: bool) -> None:
        """Clear the request if the stored values show that the board has restarted."""
        if power_cycled or self._given_at != dict(stored):
            self._given_at = None

    def forget(self) -> None:
        """Treat the reset as done."""
        self._given_at = None
