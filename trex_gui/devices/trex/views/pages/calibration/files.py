"""Calibrations from and to settings files, and what became of it in words."""

from datetime import datetime
from pathlib import Path

from PySide6.QtCore import QObject, QSettings, Slot
from PySide6.QtWidgets import QFileDialog, QWidget

from trex_gui.core.errors import BadRequest
from trex_gui.core.files.errors import SettingsError
from trex_gui.devices.trex.model.calibration.files import put_calibrations, take_calibrations
from trex_gui.devices.trex.model.device import Device
from trex_gui.ui.widgets import file_questions


class CalibrationFiles(QObject):
    """Asks for a file and takes or writes the calibrations of it."""

    def __init__(self, device: Device, window: QWidget) -> None:
        super().__init__(window)
        self._device = device
        self._notifier = device.notifier
        self._window = window
        self._store = QSettings(self)

    @Slot()
    def ask_and_load(self) -> None:
        """Let a person choose a file to take calibrations from."""
        chosen, _ = QFileDialog.getOpenFileName(
            self._window,
            self.tr("Load calibrations"),
            str(file_questions.last_folder(self._store)),
            file_questions.file_filter(),
        )
        if chosen:
            self.load_file(Path(chosen))

    @Slot()
    def ask_and_save(self) -> None:
        """Let a person choose a file to write calibrations to."""
        name = file_questions.last_folder(self._store) / "calibrations.txt"
        chosen, _ = QFileDialog.getSaveFileName(
            self._window,
            self.tr("Save calibrations"),
            str(name),
            file_questions.file_filter(),
            options=QFileDialog.Option.DontConfirmOverwrite,  # only the calibrations change
        )
        if chosen:
            self.save_file(Path(chosen))

    def load_file(self, path: Path) -> None:
        """Make the calibrations of a file edits."""
        try:
            count, left_out = take_calibrations(
                self._device.draft, path, self.tr("Calibrations of {0}").format(path.name)
            )
        except (SettingsError, BadRequest) as error:
            self._notifier.error.emit(
                self.tr("{0} was not taken: {1}.").format(path.name, _plain(error))
            )
            return
        file_questions.remember_folder(self._store, path)
        words = [self.tr("{0} has the same calibrations.").format(path.name)]
        if count:
            one = self.tr("{0} calibration of {1} is an edit now.")
            several = self.tr("{0} calibrations of {1} are edits now.")
            words = [(one if count == 1 else several).format(count, path.name)]
        self._notifier.info.emit(" ".join([*words, *left_out]))

    def save_file(self, path: Path) -> None:
        """Write the calibrations shown."""
        shown = self._device.draft.shown
        if shown is None:
            return
        now = datetime.now().astimezone().strftime("%Y-%m-%d %H:%M")
        title = f"Calibrations, saved by TReX Studio, {now}."
        try:
            put_calibrations(shown, path, title)
        except (SettingsError, BadRequest, UnicodeDecodeError) as error:
            self._notifier.error.emit(
                self.tr("{0} was not saved: {1}.").format(path.name, _plain(error))
            )
            return
        file_questions.remember_folder(self._store, path)
        self._notifier.info.emit(self.tr("The calibrations shown were saved in {0}.").format(path))


def _plain(error: Exception) -> str:
    return str(error).rstrip(". ")
