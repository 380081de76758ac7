"""Recording a board and opening its recordings."""

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication, Signal
from PySide6.QtWidgets import QWidget

from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.playback import Playback
from trex_gui.devices.trex.model.recorder import Recorder
from trex_gui.ui.playback.manager import RecordingManager, RecordingTexts

if TYPE_CHECKING:
    from trex_gui.devices.trex.views.playback import PlaybackWindow


class Recordings(RecordingManager["PlaybackWindow"]):
    """Records a board and owns the windows of its recordings.

    Signals:
        settings_wanted: a `SettingsDocument` to open in the settings editor.
    """

    settings_wanted = Signal(object)

    def __init__(self, device: Device, window: QWidget) -> None:
        texts = RecordingTexts(
            stem="trex",
            unavailable=_tr("Nothing can be recorded: no board is connected."),
            open_command=_tr("File, Open recording"),
        )
        super().__init__(Recorder(device), texts, device.notifier, window, store="recording")
        self._device = device

    def open_window(self, path: Path) -> "PlaybackWindow":
        playback = Playback.open(path)
        # The plotting library takes as long to load as all of Qt: not before it is needed.
        from trex_gui.devices.trex.views.playback import PlaybackWindow  # noqa: PLC0415

        window = PlaybackWindow(playback, self._device)
        window.settings_wanted.connect(self.settings_wanted)
        return window


def _tr(text: str) -> str:
    return QCoreApplication.translate("Recordings", text)
