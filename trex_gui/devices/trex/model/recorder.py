"""Recording what a board reports and the setpoints sent to it."""

from pathlib import Path

from PySide6.QtCore import QObject, Slot

from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.driving.requests import SetpointRequest, setpoints_in
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.recording import (
    FORMAT,
    Header,
    Record,
    setpoint_record,
    settings_snapshot,
)
from trex_gui.devices.trex.session.messages import Batch
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.runtime import now
from trex_gui.ui.workers.record_thread import RecordThread


class Recorder(RecordThread[Record]):
    """Records the session of a device into one file at a time.

    A recording ends with the connection, and when the board returns as another one or with
    another input source, since its header would be wrong. It continues while the board does not
    respond.
    """

    def __init__(self, device: Device, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._device = device
        self._board: tuple[object, ...] = ()
        self._settings = ""

        device.sampled.connect(self._on_sampled)
        device.events.happened.connect(self.put_event)
        device.motors.requested.connect(self._on_requested)
        device.state_changed.connect(self._on_state_changed)
        device.link_changed.connect(self._on_link_changed)
        self.changed.connect(lambda: device.connection.watch("recording", self.recording))

    @property
    def is_available(self) -> bool:
        return self._device.is_connected and self._device.state is not None

    def start(self, path: Path) -> bool:
        state = self._device.state
        if state is None or not self.can_record:
            return False
        settings = self._device.settings
        number = settings.device_number if settings is not None else None
        header = Header.of(state, now(), number)
        self._board, self._settings = _identity(state), header.settings
        self.begin(path, FORMAT, header)
        return True

    @Slot(object)
    def _on_sampled(self, batch: Batch) -> None:
        self.put(*batch.samples)

    @Slot(object)
    def _on_requested(self, request: SetpointRequest) -> None:
        time = now()
        self.put(*(setpoint_record(setpoint, time) for setpoint in setpoints_in(request)))

    @Slot()
    def _on_state_changed(self) -> None:
        state = self._device.state
        if state is None or not self.recording:
            return
        if _identity(state) != self._board:
            self.end_because(
                self.tr("Recording {0} ended: the board or its input source has changed.")
            )
            return
        snapshot = settings_snapshot(state, now())
        if snapshot.text != self._settings:
            self._settings = snapshot.text
            self.put(snapshot)

    @Slot()
    def _on_link_changed(self) -> None:
        if self.recording and self._device.link is ConnectionState.DISCONNECTED:
            self.end_because(self.tr("Recording {0} ended with the connection."))
        self.changed.emit()


def _identity(state: DeviceState) -> tuple[object, ...]:
    return state.signature, state.source
