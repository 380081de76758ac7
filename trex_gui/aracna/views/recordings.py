"""Recording the robot's session into a CSV file: asking where, and saying what became of it."""

from datetime import datetime
from pathlib import Path

from PySide6.QtCore import QObject, QSettings, Signal, Slot
from PySide6.QtWidgets import QFileDialog, QWidget

from trex_gui.aracna.model.recorder import AracnaRecorder
from trex_gui.aracna.model.robot import Robot
from trex_gui.views.recording.indicator import RecordIndicator
from trex_gui.views.recording.words import size_text

_FOLDER = "aracna/recordings"


class AracnaRecordings(QObject):
    """One recorder, and the row that shows that it records.

    Signals:
        told: what was recorded, for people.
        refused: why nothing is, for people.
        changed: whether something is recorded, or can be.
    """

    told = Signal(str)
    refused = Signal(str)
    changed = Signal()

    def __init__(self, robot: Robot, window: QWidget) -> None:
        super().__init__(window)
        self._window = window
        self._store = QSettings(self)
        self._was = (False, False)
        self.recorder = AracnaRecorder(robot, self)
        self.indicator = RecordIndicator(self.recorder, window, prefix="aracna_")

        self.recorder.told.connect(self.told)
        self.recorder.failed.connect(self.refused)
        self.recorder.ended.connect(self._on_ended)
        self.recorder.changed.connect(self._on_changed)

    def toggle(self) -> None:
        """End the recording that runs, or ask where to begin one."""
        if self.recorder.recording:
            self.recorder.stop()
            return
        stamp = datetime.now().astimezone().strftime("%Y-%m-%d_%H-%M-%S")
        folder = Path(str(self._store.value(_FOLDER, str(Path.home()))))
        chosen, _ = QFileDialog.getSaveFileName(
            self._window,
            self.tr("Record"),
            str(folder / f"aracna_{stamp}.csv"),
            self.tr("CSV for spreadsheets (*.csv)"),
        )
        if chosen:
            path = Path(chosen)
            self.record(path if path.suffix else path.with_suffix(".csv"))

    def record(self, path: Path) -> None:
        """Record into a file."""
        if self.recorder.start(path):
            self._store.setValue(_FOLDER, str(path.parent))
        else:
            self.refused.emit(self.tr("Nothing can be recorded: no robot is connected."))

    @Slot(object)
    def _on_ended(self, path: Path) -> None:
        size = size_text(self.recorder.size)
        self.told.emit(self.tr("Recorded in {0} ({1}).").format(path, size))

    @Slot()
    def _on_changed(self) -> None:
        """Tell of what menus depend on; the recorder tells of every kilobyte."""
        now = (self.recorder.recording, self.recorder.can_record)
        if now != self._was:
            self._was = now
            self.changed.emit()
