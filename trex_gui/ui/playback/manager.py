"""Recording controls, and windows of open recordings."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from datetime import datetime
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from PySide6.QtCore import QObject, Signal, Slot
from PySide6.QtWidgets import QFileDialog, QSizePolicy, QWidget

from trex_gui.core.errors import StudioError
from trex_gui.core.recording.automatic import automatic_folder
from trex_gui.core.recording.kinds import RecordingFormat
from trex_gui.core.recording.store import SUFFIX, Recording, copy_recording
from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.ui.files import in_background, save_in_background
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.playback.transport import size_text, time_text
from trex_gui.ui.runtime import new_timer
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.file_drop import FileDrop
from trex_gui.ui.widgets.file_questions import last_folder, prompt_to_save, remember_folder
from trex_gui.ui.widgets.labels import ElidedLabel
from trex_gui.ui.workers.record_thread import RecordThread

if TYPE_CHECKING:  # the plotting library takes as long to load as all of Qt
    from trex_gui.ui.playback.window import RecordingWindow

_UPDATE_INTERVAL_MS = 250

WindowT = TypeVar("WindowT", bound="RecordingWindow")


class RecordIndicator(QWidget):
    def __init__(
        self, recorder: RecordThread[Any], parent: QWidget | None = None, *, prefix: str = ""
    ) -> None:
        super().__init__(parent)
        ui.named(self, f"{prefix}recordIndicator", accessible=tr("Recording"))
        self._recorder = recorder

        self._text = ui.label(self, f"{prefix}recordText", bold=True)
        self._file = ui.named(ElidedLabel("", self), f"{prefix}recordFile")
        self._file.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        title = title_of(tr("Stop &recording"))
        tip = tr("End the recording; motors and connection are not affected")
        stop = ui.button(
            self, f"{prefix}stopRecordingButton", title, tip=tip, on_click=recorder.stop
        )
        self._timer = new_timer(self, _UPDATE_INTERVAL_MS, self._update_text)
        ui.row(self._text, (self._file, 1), stop, into=self, margins=0)

        recorder.changed.connect(self._on_changed)
        self._on_changed()

    @Slot()
    def _on_changed(self) -> None:
        recording = self._recorder.recording
        if recording and not self._timer.isActive():
            self._timer.start()
        elif not recording:
            self._timer.stop()
        self._update_text()
        self.setVisible(recording)

    @Slot()
    def _update_text(self) -> None:
        recorder = self._recorder
        duration, size = time_text(recorder.seconds), size_text(recorder.size)
        text = tr("Recording  {0}  {1}").format(duration, size)
        if recorder.lost:
            text += "  " + tr("%n sample(s) lost: the disk is too slow", "", recorder.lost)
        self._text.setText(text)
        name = recorder.path.name if recorder.path is not None else ""
        self._file.show_text(name)
        self._file.setToolTip(ui.plain(str(recorder.path or "")))
        self.setAccessibleDescription(f"{text}, {name}")


@dataclass(frozen=True, slots=True)
class RecordingTexts:
    stem: str  # prefix of new file names
    unavailable: str  # reason why the device cannot be recorded
    open_command: str  # menu command to open a recording


class RecordingManager(QObject, Generic[WindowT]):
    """Starts recordings, and owns the windows of open recordings."""

    changed = Signal()  # `recorder.recording` or `recorder.can_record` has changed
    used = Signal(object)  # the `Path` of a recording that was opened or completed

    def __init__(
        self,
        recorder: RecordThread[Any],
        fmt: RecordingFormat[Any],
        texts: RecordingTexts,
        notifier: Notifier,
        window: QWidget,
        *,
        store: str,
        prefix: str = "",
    ) -> None:
        """`store`: prefix of preferences. `prefix`: prefix of object names."""
        super().__init__(window)
        self._format = fmt
        self._texts = texts
        self._notifier = notifier
        self._window = window
        self._folder_key = f"{store}/folder"
        self._last_state: tuple[bool, bool] | None = None
        self.recorder = recorder
        recorder.setParent(self)
        self.indicator = RecordIndicator(recorder, window, prefix=prefix)
        self.windows: list[WindowT] = []
        self._opening: set[Path] = set()
        self._has_ended = False

        recorder.changed.connect(self._on_changed)
        recorder.ended.connect(self._on_ended)
        recorder.ended_early.connect(notifier.info)
        recorder.failed.connect(notifier.error)

    def accept_drops(self, frame: QWidget, workspace: QWidget) -> None:
        def accepts(paths: Sequence[Path]) -> bool:
            is_recording = len(paths) == 1 and paths[0].suffix.lower() == SUFFIX
            return is_recording and workspace.isVisible()

        FileDrop(frame, accepts).dropped.connect(lambda paths: self.open_file(paths[0]))

    def create_window(self, recording: Recording[Any, Any]) -> WindowT:
        """Create a window that will load the recording later."""
        raise NotImplementedError

    def toggle(self) -> None:
        if self.recorder.recording:
            self.recorder.stop()
            return
        path = self._prompt_to_save(tr("&Record…"), self.proposal())
        if path is not None:
            self.record(path)

    def proposal(self) -> Path:
        stamp = datetime.now().astimezone().strftime("%Y-%m-%d_%H-%M-%S")
        return last_folder(self._folder_key) / f"{self._texts.stem}_{stamp}{SUFFIX}"

    def _prompt_to_save(self, title: str, proposal: Path) -> Path | None:
        return prompt_to_save(self._window, title, proposal, self._filter(), SUFFIX, required=True)

    def record(self, path: Path) -> None:
        if any(window.player.path == path for window in self.windows):
            text = tr("{0} is open; close its window before you overwrite it.")
            self._notifier.error.emit(text.format(path.name))
        elif self.recorder.start(path):
            remember_folder(path, self._folder_key)
        else:
            self._notifier.error.emit(self._texts.unavailable)

    def select_and_open(self, title: str = "", folder: Path | None = None) -> None:
        """Let the user select a recording, and open it. The default `folder` is the last folder."""
        path, _ = QFileDialog.getOpenFileName(
            self._window,
            title or title_of(tr("Ope&n recording…")),
            str(folder or last_folder(self._folder_key)),
            self._filter(),
        )
        if path:
            self.open_file(Path(path))

    @Slot(object)
    def open_file(self, path: Path) -> None:
        """Open a recording in a window, or activate its open window."""
        for window in self.windows:
            if window.player.path == path:
                window.show()
                window.activateWindow()
                return
        if path not in self._opening:
            self._opening.add(path)
            work: Callable[[], Recording[Any, Any]] = partial(Recording, path, self._format)
            in_background(self, work, self._on_opened, partial(self._on_not_opened, path))

    def _on_opened(self, recording: Recording[Any, Any]) -> None:
        self._opening.discard(recording.path)
        if self._has_ended:
            recording.close()
            return
        window = self.create_window(recording)
        self._notifier.forward_log(window.notifier)
        if recording.path.parent == automatic_folder():
            window.copy_button.clicked.connect(lambda: self._save_copy(window))
            window.copy_button.show()
        else:
            remember_folder(recording.path, self._folder_key)
        self.used.emit(recording.path)
        self.windows.append(window)
        window.closed.connect(partial(self._remove, window))
        window.show()
        # Load after the window has been drawn, since the loading thread slows this thread down.
        new_timer(window, 0, window.player.start_loading, single_shot=True).start()

    def _save_copy(self, window: WindowT) -> None:
        source = window.player.path
        path = self._prompt_to_save(
            tr("Save a cop&y…"), last_folder(self._folder_key) / source.name
        )
        if path is None or path == source:
            return
        remember_folder(path, self._folder_key)
        saved = tr("A copy was saved to {0}.").format(path)
        save_in_background(window, partial(copy_recording, source, path), window.notifier, saved)

    def _on_not_opened(self, path: Path, error: StudioError) -> None:
        self._opening.discard(path)
        self._notifier.error.emit(str(error))

    def close_all(self) -> None:
        self._has_ended = True
        self.recorder.shut_down()
        for window in tuple(self.windows):
            window.close()

    def shut_down(self) -> bool:
        """End recording, loading and exporting. Return whether all threads have ended."""
        return all([self.recorder.shut_down(), *(window.player.close() for window in self.windows)])

    def _remove(self, window: WindowT) -> None:
        if window in self.windows:
            self.windows.remove(window)

    def _filter(self) -> str:
        return tr("Recordings (*{0})").format(SUFFIX)

    @Slot(object)
    def _on_ended(self, path: Path) -> None:
        self.changed.emit()
        self.used.emit(path)
        size = size_text(self.recorder.size)
        text = tr("Recorded to {0} ({1}). Use {2} to view it.")
        self._notifier.info.emit(text.format(path, size, self._texts.open_command))

    @Slot()
    def _on_changed(self) -> None:
        # Ignore changes of size, which do not affect menus.
        state = (self.recorder.recording, self.recorder.can_record)
        if state != self._last_state:
            self._last_state = state
            self.changed.emit()
