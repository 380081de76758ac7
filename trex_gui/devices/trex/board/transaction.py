"""Steps of a write of settings: prepare, write, verify, finish."""

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
    """Write of settings. Call `save_snapshot` and `start`, write, then call `finish`.

    If the line or the program fails during the write, the record has no expected values for the
    written settings. The next connection shows the stored values.
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
        """`state` is the state before the write. `reason` is the heading of the snapshot."""
        self.state = state
        self.values = values
        self._memory = memory
        self._reason = reason
        self._adapter = "" if link is None else link.label
        # The memory is read here, because it may change while a thread saves the snapshot.
        self._stored, self._remarks = memory.with_hidden(settings_of(state))

    def save_snapshot(self, history: SettingsHistory) -> Snapshot:
        """Save all stored settings, with hidden calibrations.

        Raises:
            SettingsError: saving failed, so nothing may be written.
        """
        return history.save(
            self._stored, adapter=self._adapter, reason=self._reason, remarks=self._remarks
        )

    def start(self) -> None:
        """Clear the expected values. Call this before the first byte is sent."""
        parameters, calibrations = self.values
        self._memory.start_writing({key for key, _ in (*parameters, *calibrations)})

    def finish(self, results: Sequence[WriteResult], state: DeviceState, now: datetime) -> None:
        """Record the settings stored after the write. `now` is in UTC."""
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
