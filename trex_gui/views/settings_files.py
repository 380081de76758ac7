"""Opening and saving settings files from the window."""

from datetime import datetime
from pathlib import Path

from PySide6.QtCore import QObject, QSettings, QStandardPaths, Signal
from PySide6.QtWidgets import QFileDialog, QWidget

from trex_gui.export.code import export_code, file_name
from trex_gui.export.language import Language
from trex_gui.model.device import Device
from trex_gui.model.exchange import what_changes
from trex_gui.protocol.errors import BadRequest
from trex_gui.settings.errors import SettingsError
from trex_gui.settings.files import load, save
from trex_gui.settings.reader import read_settings
from trex_gui.settings.writer import write_settings

_FOLDER = "settings/folder"
_FILTER = "Text files (*.txt);;All files (*)"


class SettingsFiles(QObject):
    """Asks for a file, and says what became of it.

    Signals:
        told: what was done, for people.
        refused: why a file was not opened or saved, for people.
    """

    told = Signal(str)
    refused = Signal(str)

    def __init__(self, device: Device, window: QWidget) -> None:
        super().__init__(window)
        self._device = device
        self._window = window
        self._store = QSettings(self)

    def ask_and_open(self) -> None:
        """Let a person choose a file to load as edits."""
        chosen, _ = QFileDialog.getOpenFileName(
            self._window, self.tr("Open settings file"), str(self._folder()), _FILTER
        )
        if chosen:
            self.open_file(Path(chosen))

    def ask_and_open_snapshot(self) -> None:
        """Let a person choose what a board stored before an Apply, to load as edits."""
        folder = self._device.history.folder
        if not self._device.history.snapshots():
            self.told.emit(self.tr("There are no snapshots yet; each Apply saves one first."))
            return
        chosen, _ = QFileDialog.getOpenFileName(
            self._window, self.tr("Open snapshot"), str(folder), _FILTER
        )
        if chosen:
            self.open_file(Path(chosen), remember=False)

    def ask_and_save(self) -> None:
        """Let a person choose where to save the settings shown."""
        state = self._device.state
        key = state.signature.model.key if state is not None else "trex"
        name = self._folder() / f"{key}_settings.txt"
        chosen, _ = QFileDialog.getSaveFileName(
            self._window, self.tr("Save settings file"), str(name), _FILTER
        )
        if chosen:
            self.save_file(Path(chosen))

    def ask_and_export(self) -> None:
        """Let a person choose where to save the settings shown as a program, and its language."""
        settings = self._device.draft.shown
        if settings is None:
            return
        filters = {f"{language.title} (*{language.suffix})": language for language in Language}
        name = self._folder() / file_name(settings, next(iter(filters.values())))
        chosen, kind = QFileDialog.getSaveFileName(
            self._window, self.tr("Export as code"), str(name), ";;".join(filters)
        )
        if chosen:
            path = Path(chosen)
            written = {language.suffix: language for language in Language}
            self.export_file(path, written.get(path.suffix.lower(), filters[kind]))

    def export_file(self, path: Path, language: Language) -> None:
        """Write a program that applies the settings shown and drives the motors."""
        settings, link = self._device.draft.shown, self._device.settings
        if settings is None or link is None:
            return
        try:
            save(path, export_code(settings, link, language))
        except (SettingsError, BadRequest) as error:
            self.refused.emit(self.tr("{0} was not written: {1}").format(path.name, error))
            return
        self._store.setValue(_FOLDER, str(path.parent))
        text = self.tr("{0} applies and checks the settings shown; read its first lines.")
        self.told.emit(text.format(path))

    def open_file(self, path: Path, *, remember: bool = True) -> None:
        """Make the values of a file edits that wait for Apply; all of it or nothing.

        With `remember`, its folder is where the next file is looked for.
        """
        if self._device.state is None:
            return
        draft = self._device.draft
        try:
            settings, warnings = read_settings(load(path), path.name)
            changes = what_changes(draft, settings)
            draft.stage(changes.rows, self.tr("Open settings file"))
        except (SettingsError, BadRequest) as error:
            self.refused.emit(self.tr("{0} was not opened: {1}").format(path.name, error))
            return
        if remember:
            self._store.setValue(_FOLDER, str(path.parent))
        notes = " ".join(str(finding) for finding in warnings)
        text = f"{path.name}: {changes.summary()}. {' '.join(changes.left_out)} {notes}"
        self.told.emit(" ".join(text.split()))

    def save_file(self, path: Path) -> None:
        """Write the settings shown, edits included."""
        settings = self._device.draft.shown
        if settings is None:
            return
        now = datetime.now().astimezone().strftime("%Y-%m-%d %H:%M")
        text = write_settings(settings, title_lines=[f"Saved by TReX Studio, {now}."])
        try:
            save(path, text)
        except SettingsError as error:
            self.refused.emit(self.tr("{0} was not saved: {1}").format(path.name, error))
            return
        self._store.setValue(_FOLDER, str(path.parent))
        self.told.emit(self.tr("The settings shown were saved in {0}.").format(path))

    def _folder(self) -> Path:
        documents = QStandardPaths.StandardLocation.DocumentsLocation
        return Path(str(self._store.value(_FOLDER, QStandardPaths.writableLocation(documents))))
