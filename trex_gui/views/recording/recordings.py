"""Beginning and ending recordings, and opening those that were made."""

from datetime import datetime
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QSettings, Signal, Slot
from PySide6.QtWidgets import QFileDialog, QWidget

from trex_gui.model.device import Device
from trex_gui.model.playback import Playback
from trex_gui.model.recorder import Recorder
from trex_gui.model.settings_document import SettingsDocument
from trex_gui.recording.errors import RecordingError
from trex_gui.views.recording.indicator import RecordIndicator
from trex_gui.views.recording.words import size_text

if TYPE_CHECKING:
    from trex_gui.views.recording.window import PlaybackWindow

_FOLDER = "recording/folder"
_SUFFIX = "recording/suffix"
SUFFIXES = frozenset({".trexrec", ".csv"})


class Recordings(QObject):
    """Asks where to record and what to open, and owns the windows of open recordings.

    Signals:
        told: what was done, for people.
        refused: why something cannot be recorded or opened, for people.
        settings_wanted: a `SettingsDocument` to open in the settings editor.
        changed: whether something is recorded.

    Attributes:
        recorder: what records.
        indicator: the row that says so.
        windows: the recordings that are open.
    """

    told = Signal(str)
    refused = Signal(str)
    settings_wanted = Signal(object)
    changed = Signal()

    def __init__(self, device: Device, window: QWidget) -> None:
        super().__init__(window)
        self._device = device
        self._window = window
        self._store = QSettings(self)
        self.recorder = Recorder(device, self)
        self.indicator = RecordIndicator(self.recorder, window)
        self.windows: list[PlaybackWindow] = []

        self.recorder.changed.connect(self.changed)
        self.recorder.ended.connect(self._on_ended)
        self.recorder.told.connect(self.told)
        self.recorder.failed.connect(self.refused)

    def toggle(self) -> None:
        """End the recording that runs, or ask where to begin one."""
        if self.recorder.recording:
            self.recorder.stop()
        else:
            self.ask_and_record()

    def ask_and_record(self) -> None:
        """Let a person choose the file, and with its kind the format; then record into it."""
        kinds = {
            self.tr("Compact recording (*.trexrec)"): ".trexrec",
            self.tr("CSV for spreadsheets (*.csv)"): ".csv",
        }
        last = str(self._store.value(_SUFFIX, ".trexrec"))
        kind = next((text for text, suffix in kinds.items() if suffix == last), next(iter(kinds)))
        stamp = datetime.now().astimezone().strftime("%Y-%m-%d_%H-%M-%S")
        proposal = self._folder() / f"trex_{stamp}{kinds[kind]}"
        chosen, kind = QFileDialog.getSaveFileName(
            self._window, self.tr("Record"), str(proposal), ";;".join(kinds), kind
        )
        if chosen:
            path = Path(chosen)
            if path.suffix.lower() not in SUFFIXES:
                path = path.with_name(path.name + kinds.get(kind, ".trexrec"))
            self.record(path)

    def record(self, path: Path) -> None:
        """Record into a file."""
        if any(window.playback.path == path for window in self.windows):
            text = self.tr("{0} is open; close its window before recording over it.")
            self.refused.emit(text.format(path.name))
        elif self.recorder.start(path):
            self._remember(path)
        else:
            self.refused.emit(self.tr("Nothing can be recorded: no board is connected."))

    def ask_and_open(self) -> None:
        """Let a person choose a recording to look at."""
        chosen, _ = QFileDialog.getOpenFileName(
            self._window,
            self.tr("Open recording"),
            str(self._folder()),
            self.tr("Recordings (*.trexrec *.csv);;All files (*)"),
        )
        if chosen:
            self.open_file(Path(chosen))

    @Slot(object)
    def open_file(self, path: Path) -> None:
        """Open a recording in a window of its own, or show the window that has it already."""
        for window in self.windows:
            if window.playback.path == path:
                window.show()
                window.activateWindow()
                return
        try:
            playback = Playback.open(path)
        except RecordingError as error:
            self.refused.emit(str(error))
            return
        self._remember(path)
        # The plotting library takes as long to load as all of Qt: not before it is needed.
        from trex_gui.views.recording.window import PlaybackWindow  # noqa: PLC0415

        window = PlaybackWindow(playback, self._device)
        self.windows.append(window)
        window.settings_wanted.connect(self._on_settings_wanted)
        window.closed.connect(partial(self._forget, window))
        window.show()

    def close_all(self) -> None:
        """End what is recorded and close every window."""
        self.recorder.shut_down()
        for window in tuple(self.windows):
            window.close()

    def shut_down(self) -> bool:
        """End what is recorded, read and exported, for the end of the program.

        Return whether every thread has ended; Qt aborts on destroying one that runs.
        """
        ends = [self.recorder.shut_down()]
        ends += [window.playback.close() for window in self.windows]
        return all(ends)

    def _forget(self, window: "PlaybackWindow") -> None:
        if window in self.windows:
            self.windows.remove(window)

    def _folder(self) -> Path:
        return Path(str(self._store.value(_FOLDER, str(Path.home()))))

    def _remember(self, path: Path) -> None:
        self._store.setValue(_FOLDER, str(path.parent))
        self._store.setValue(_SUFFIX, path.suffix.lower())

    @Slot(object)
    def _on_ended(self, path: Path) -> None:
        self.changed.emit()
        size = size_text(self.recorder.size)
        text = self.tr("Recorded in {0} ({1}). File, Open recording shows it.")
        self.told.emit(text.format(path, size))

    @Slot(str, str)
    def _on_settings_wanted(self, text: str, name: str) -> None:
        self.settings_wanted.emit(SettingsDocument(text, name))
