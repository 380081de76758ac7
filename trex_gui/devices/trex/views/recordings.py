"""Manual recordings, and automatic recordings around faults and stops."""

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QWidget

from trex_gui.core.recording.automatic import create_automatic_folder
from trex_gui.core.recording.store import Recording
from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.recorder import EventRecorder, Recorder
from trex_gui.devices.trex.recording import FORMAT, Header, Record
from trex_gui.ui.files import in_background
from trex_gui.ui.frame.workspace import Entries, Entry
from trex_gui.ui.playback.manager import RecordingManager, RecordingTexts
from trex_gui.ui.preferences import Preferences

if TYPE_CHECKING:
    from trex_gui.devices.trex.views.playback import PlaybackWindow

_WITH_RUN = "recording/with_run"


class Recordings(RecordingManager["PlaybackWindow"]):
    def __init__(self, device: Device, window: QWidget) -> None:
        texts = RecordingTexts(
            stem="trex",
            unavailable=tr("Nothing can be recorded: no board is connected."),
            open_command=tr("File, Open recording"),
        )
        recorder = Recorder(device)
        super().__init__(recorder, FORMAT, texts, device.notifier, window, store="recording")
        self._device = device
        self.events = EventRecorder(device, recorder, self)
        self.starts_with_run = Preferences().flag(_WITH_RUN, default=False)
        self.events.ended.connect(self._on_event_saved)
        self.events.failed.connect(self._on_event_failed)
        device.motors.arming_changed.connect(self._on_arming_changed)

    def create_window(self, recording: Recording[Header, Record]) -> "PlaybackWindow":
        # Imported only when needed: the plotting library takes as long to load as all of Qt.
        from trex_gui.devices.trex.model.playback import Playback  # noqa: PLC0415
        from trex_gui.devices.trex.views.playback import PlaybackWindow  # noqa: PLC0415

        return PlaybackWindow(Playback(recording), self._device)

    def entries(self) -> Entries:
        select, with_run = self.select_and_open, tr("Start recording &when the motors are armed")
        keep_events = tr("&Keep 30 s around each fault and stop")
        return (
            Entry("record", tr("&Record…"), self.toggle, "Ctrl+Shift+R", "record"),
            Entry("open_recording", tr("Open recor&ding…"), select, "Ctrl+Shift+O", "plot"),
            Entry("open_kept", tr("Open fa&ult or stop…"), self._select_and_open_kept),
            Entry("record_with_run", with_run, self._toggle_starts_with_run, checkable=True),
            Entry("keep_events", keep_events, self._toggle_keeps_events, checkable=True),
        )

    def _toggle_starts_with_run(self) -> None:
        self.starts_with_run = not self.starts_with_run
        Preferences().set(_WITH_RUN, self.starts_with_run)
        self.changed.emit()

    def _toggle_keeps_events(self) -> None:
        self.events.set_on(not self.events.is_on)
        self.changed.emit()

    def _select_and_open_kept(self) -> None:
        in_background(
            self,
            create_automatic_folder,
            partial(self.select_and_open, title_of(tr("Open fa&ult or stop…"))),
            lambda error: self._notifier.error.emit(str(error)),
        )

    @Slot()
    def _on_arming_changed(self) -> None:
        if self.starts_with_run and self._device.motors.armed and self.recorder.can_record:
            self.record(self.proposal())

    @Slot(object)
    def _on_event_saved(self, path: Path) -> None:
        text = tr("The seconds around “{0}” were saved as {1} (File, Open fault or stop).")
        self._notifier.logged.emit(text.format(self.events.cause, path.name), False)

    @Slot(str)
    def _on_event_failed(self, reason: str) -> None:
        text = tr("The seconds around “{0}” could not be saved. {1}")
        self._notifier.logged.emit(text.format(self.events.cause, reason), True)

    def close_all(self) -> None:
        self.events.shut_down()
        super().close_all()

    def shut_down(self) -> bool:
        return all([self.events.shut_down(), super().shut_down()])
