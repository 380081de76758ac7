"""Recording, and the windows of recordings that are open, whatever the device."""

from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Generic, TypeVar

from PySide6.QtCore import QObject, QSettings, Signal, Slot
from PySide6.QtWidgets import QFileDialog, QWidget

from trex_gui.core.recording.errors import RecordingError
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.playback.formats import size_text
from trex_gui.ui.playback.indicator import RecordIndicator
from trex_gui.ui.workers.record_thread import RecordThread

if TYPE_CHECKING:  # the plotting library takes as long to load as all of Qt
    from trex_gui.ui.playback.window import RecordingWindow

RecorderT = TypeVar("RecorderT", bound=RecordThread[Any])
WindowT = TypeVar("WindowT", bound="RecordingWindow")


@dataclass(frozen=True, slots=True)
class RecordingWords:
    """What is said of the recordings of a device, and how their files are named.

    Attributes:
        stem: how the names of new files begin.
        kinds: the suffixes that can be written, by what a person calls them.
        nothing: why nothing can be recorded now.
        shown_by: the entry of the menus that opens a recording.
    """

    stem: str
    kinds: Mapping[str, str]
    nothing: str
    shown_by: str


class RecordingManager(QObject, Generic[RecorderT, WindowT]):
    """Asks where to record and what to open, and owns the windows of open recordings.

    One for each device derives from it and makes the windows.

    Signals:
        changed: whether something is recorded, or can be.

    Attributes:
        recorder: what records.
        indicator: the row that says so.
        windows: the recordings that are open.
    """

    changed = Signal()

    def __init__(
        self,
        recorder: RecorderT,
        words: RecordingWords,
        notifier: Notifier,
        window: QWidget,
        *,
        store: str,
        prefix: str = "",
    ) -> None:
        """Keep what is recorded.

        Folder and kind of the last file are remembered under `store`; `prefix` goes before the
        names that the parts of the row are found by.
        """
        super().__init__(window)
        self._words = words
        self._notifier = notifier
        self._window = window
        self._store = QSettings(self)
        self._folder_key, self._suffix_key = f"{store}/folder", f"{store}/suffix"
        self._was: tuple[bool, bool] | None = None
        self.recorder = recorder
        recorder.setParent(self)
        self.indicator = RecordIndicator(recorder, window, prefix=prefix)
        self.windows: list[WindowT] = []

        recorder.changed.connect(self._on_changed)
        recorder.ended.connect(self._on_ended)
        recorder.ended_early.connect(self._notifier.info)
        recorder.failed.connect(self._notifier.error)

    def open_window(self, path: Path) -> WindowT:
        """Return a new window that reads and shows a recording.

        Raises:
            RecordingError: there is none that can be read.
        """
        raise NotImplementedError

    # --- Recording ----------------------------------------------------------------------

    def toggle(self) -> None:
        """End the recording that runs, or ask where to begin one."""
        if self.recorder.recording:
            self.recorder.stop()
        else:
            self.ask_and_record()

    def ask_and_record(self) -> None:
        """Let a person choose the file, and with its kind the format; then record into it."""
        kinds = self._words.kinds
        first = next(iter(kinds))
        last = str(self._store.value(self._suffix_key, kinds[first]))
        kind = next((text for text, suffix in kinds.items() if suffix == last), first)
        stamp = datetime.now().astimezone().strftime("%Y-%m-%d_%H-%M-%S")
        proposal = self._folder() / f"{self._words.stem}_{stamp}{kinds[kind]}"
        chosen, kind = QFileDialog.getSaveFileName(
            self._window, self.tr("Record"), str(proposal), ";;".join(kinds), kind
        )
        if chosen:
            path = Path(chosen)
            if path.suffix.lower() not in kinds.values():
                path = path.with_name(path.name + kinds.get(kind, kinds[first]))
            self.record(path)

    def record(self, path: Path) -> None:
        """Record into a file."""
        if any(window.player.path == path for window in self.windows):
            text = self.tr("{0} is open; close its window before recording over it.")
            self._notifier.error.emit(text.format(path.name))
        elif self.recorder.start(path):
            self._remember(path)
        else:
            self._notifier.error.emit(self._words.nothing)

    # --- Open recordings ----------------------------------------------------------------

    def ask_and_open(self) -> None:
        """Let a person choose a recording to look at."""
        suffixes = " ".join(f"*{suffix}" for suffix in self._words.kinds.values())
        chosen, _ = QFileDialog.getOpenFileName(
            self._window,
            self.tr("Open recording"),
            str(self._folder()),
            self.tr("Recordings ({0});;All files (*)").format(suffixes),
        )
        if chosen:
            self.open_file(Path(chosen))

    @Slot(object)
    def open_file(self, path: Path) -> None:
        """Open a recording in a window of its own, or show the window that has it already."""
        for window in self.windows:
            if window.player.path == path:
                window.show()
                window.activateWindow()
                return
        try:
            window = self.open_window(path)
        except RecordingError as error:
            self._notifier.error.emit(str(error))
            return
        self._remember(path)
        self.windows.append(window)
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
        ends += [window.player.close() for window in self.windows]
        return all(ends)

    def _forget(self, window: WindowT) -> None:
        if window in self.windows:
            self.windows.remove(window)

    def _folder(self) -> Path:
        return Path(str(self._store.value(self._folder_key, str(Path.home()))))

    def _remember(self, path: Path) -> None:
        self._store.setValue(self._folder_key, str(path.parent))
        self._store.setValue(self._suffix_key, path.suffix.lower())

    # --- What the recorder tells --------------------------------------------------------

    @Slot(object)
    def _on_ended(self, path: Path) -> None:
        self.changed.emit()
        size = size_text(self.recorder.size)
        self._notifier.info.emit(
            self.tr("Recorded in {0} ({1}). {2} shows it.").format(path, size, self._words.shown_by)
        )

    @Slot()
    def _on_changed(self) -> None:
        """Tell of what menus depend on; the recorder tells of every kilobyte."""
        now = (self.recorder.recording, self.recorder.can_record)
        if now != self._was:
            self._was = now
            self.changed.emit()
