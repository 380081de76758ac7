"""Recording what a board reports and what is asked of it, while it happens."""

from collections.abc import Callable
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, Slot

from trex_gui.devices.trex.client.reading import DeviceState
from trex_gui.devices.trex.driving.requests import SetpointRequest, setpoints_in
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.recording.files import writer_for
from trex_gui.devices.trex.recording.recording import Record
from trex_gui.devices.trex.recording.records_from import header_of, marker, settings_seen, wish_of
from trex_gui.devices.trex.session.messages import Batch
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.devices.event_log import Event
from trex_gui.ui.runtime import now
from trex_gui.ui.workers.record_thread import RecordThread


class Recorder(RecordThread[Record]):
    """Writes the session of a device into one file at a time.

    A recording ends with the connection, and where the board comes back as another one or with
    other inputs: its header would be wrong. While the board is only silent it goes on.
    """

    def __init__(
        self,
        device: Device,
        parent: QObject | None = None,
        *,
        clock: Callable[[], float] = now,
    ) -> None:
        """Record nothing yet; `clock` is the session's, which is the computer's monotonic one."""
        super().__init__(parent, clock=clock)
        self._device = device
        self._board: tuple[object, ...] = ()
        self._settings = ""

        device.sampled.connect(self._on_sampled)
        device.events.happened.connect(self._on_happened)
        device.motors.requested.connect(self._on_requested)
        device.state_changed.connect(self._on_state_changed)
        device.link_changed.connect(self._on_link_changed)

    @property
    def is_there(self) -> bool:
        """Whether a board is connected and was read."""
        return self._device.link is ConnectionState.CONNECTED and self._device.state is not None

    def start(self, path: Path) -> bool:
        """Record into a file from now on; return whether that is possible now.

        The format follows from the suffix: `.csv`, or `.trexrec` for anything else. A file of
        that name is replaced.
        """
        state = self._device.state
        if state is None or not self.can_record:
            return False
        settings, now = self._device.settings, self.clock()
        number = settings.device_number if settings is not None else None
        header = header_of(state, now, number)
        self._board, self._settings = _identity(state), header.settings
        self.begin(path, now, partial(writer_for, path, header=header))
        return True

    # --- What is recorded ---------------------------------------------------------------

    @Slot(object)
    def _on_sampled(self, batch: Batch) -> None:
        self.put(*batch.samples)

    @Slot(object)
    def _on_happened(self, event: Event) -> None:
        self.put(marker(event.time, event.kind.value, event.text))

    @Slot(object)
    def _on_requested(self, request: SetpointRequest) -> None:
        now = self.clock()
        self.put(*(wish_of(wish, now) for wish in setpoints_in(request)))

    @Slot()
    def _on_state_changed(self) -> None:
        state = self._device.state
        if state is None or not self.recording:
            return
        if _identity(state) != self._board:
            self.end_because(
                self.tr("The recording {0} has ended: the board is another one, or its mode.")
            )
            return
        seen = settings_seen(state, self.clock())
        if seen.text != self._settings:
            self._settings = seen.text
            self.put(seen)

    @Slot()
    def _on_link_changed(self) -> None:
        if self.recording and self._device.link is ConnectionState.DISCONNECTED:
            self.end_because(self.tr("The recording {0} has ended with the connection."))
        self.changed.emit()


def _identity(state: DeviceState) -> tuple[object, ...]:
    """What a recording's header says of a board and what stays so."""
    return state.signature, state.source
