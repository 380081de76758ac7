"""Steps of every write of settings: prepare, write, verify, finish."""

from collections.abc import Sequence
from datetime import datetime

from trex_gui.devices.trex.board.memory import BoardMemory
from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.client.writing import WriteResult
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.settings.document import open_values, settings_of
from trex_gui.devices.trex.settings.history import SettingsHistory, Snapshot

Values = tuple[tuple[tuple[str, int], ...], tuple[tuple[CalibrationKey, Calibration], ...]]
"""Parameters (key, wire value) and calibrations to write."""


class WriteTransaction:
    """One write of settings. Callers save the snapshot, start, write and verify, then finish.

    If a write never finishes, because the line or the program is gone, the record of the board
    expects nothing of the written values. The next connection shows what the board stores.
    """

    def __init__(
        self,
        memory: BoardMemory,
        state: DeviceState,
        link: ConnectionSettings | None,
        values: Values,
        *,
        reason: str,
    ) -> None:
        """Prepare to write to a board that stores `state`.

        `reason` names the operation for the user, at the head of the snapshot.
        """
        self.state = state
        self.values = values
        self._memory = memory
        self._reason = reason
        self._adapter = "" if link is None else link.label
        # Read now: a thread may save the snapshot while the memory changes.
        self._stored, self._remarks = memory.with_hidden(settings_of(state))

    def save_snapshot(self, history: SettingsHistory) -> Snapshot:
        """Save all settings that the board stores, and the calibrations that it hides.

        Raises:
            SettingsError: saving failed; nothing must be written.
        """
        return history.save(
            self._stored, adapter=self._adapter, reason=self._reason, remarks=self._remarks
        )

    def start(self) -> None:
        """Expect nothing of the values to write. Call this before the first byte."""
        parameters, calibrations = self.values
        self._memory.start_writing({key for key, _ in (*parameters, *calibrations)})

    def finish(self, results: Sequence[WriteResult], state: DeviceState, now: datetime) -> None:
        """Record the verified values, and the settings that the board stores. `now` is in UTC."""
        uncertain = {result.key for result in results if result.error is not None}
        self._memory.record_written(settings_of(state), state.source, uncertain, now)
        if any(result.key == ParameterKey.FACTORY_RESET for result in results):
            self._memory.record_reset()
        verified = {
            result.key: result.stored
            for result in results
            if result.error is None and isinstance(result.stored, int)
        }
        self._memory.record_accepted(state.signature, open_values(state.specs, verified))
