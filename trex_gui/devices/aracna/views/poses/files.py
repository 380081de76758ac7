"""New, open, save and save as for pose files, with the questions that are due."""

from pathlib import Path

from PySide6.QtCore import QObject, QSettings, QStandardPaths, Slot
from PySide6.QtWidgets import QFileDialog, QWidget

from trex_gui.core.files.errors import SettingsError, Severity
from trex_gui.devices.aracna.model.library import Library
from trex_gui.devices.aracna.poses.ppr import SUFFIX
from trex_gui.devices.aracna.views.typed import take_typed
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.widgets import file_questions

_FOLDER = "aracna/folder"

_MOST_FINDINGS = 8
"""Lines of a file that are told of; a message has to fit into the window."""


class PoseFiles(QObject):
    """Asks for a file, opens or writes it, and says what became of it."""

    def __init__(self, library: Library, notifier: Notifier, window: QWidget) -> None:
        super().__init__(window)
        self._library = library
        self._notifier = notifier
        self._window = window
        self._store = QSettings(self)

    @Slot()
    def new(self) -> None:
        """Begin a file with the authors' poses."""
        if self.may_close():
            self._library.new()

    @Slot()
    def ask_and_open(self) -> None:
        """Let a person choose a file."""
        chosen, _ = QFileDialog.getOpenFileName(
            self._window, self.tr("Open pose file"), str(self.folder()), self._filter()
        )
        if chosen:
            self.open_file(Path(chosen))

    def open_file(self, path: Path) -> bool:
        """Open a file in place of the one that is there; whether it is."""
        if not self.may_close():
            return False
        try:
            findings = self._library.open(path)
        except SettingsError as error:
            self._notifier.error.emit(self.tr("Not opened. {0}.").format(str(error).rstrip(". ")))
            return False
        self._remember(path)
        words = [self.tr("{0} was opened.").format(path.name)]
        words += [f"{str(finding).rstrip('. ')}." for finding in findings[:_MOST_FINDINGS]]
        if (more := len(findings) - _MOST_FINDINGS) > 0:
            words.append(self.tr("And {0} more.").format(more))
        bad = any(finding.severity is Severity.ERROR for finding in findings)
        (self._notifier.error if bad else self._notifier.info).emit("\n".join(words))
        return True

    @Slot()
    def save(self) -> bool:
        """Write the file where it lies, after the question that is due; whether it was."""
        take_typed()
        path = self._library.path
        if path is None:
            return self.ask_and_save()
        if self._library.changed_on_disk() and not file_questions.may_overwrite(
            self._window, path.name
        ):
            return False
        return self.save_to(path)

    @Slot()
    def ask_and_save(self) -> bool:
        """Let a person choose where to write the file; whether it was."""
        take_typed()
        proposal = self._library.path or self.folder() / self._library.name
        chosen, _ = QFileDialog.getSaveFileName(
            self._window, self.tr("Save pose file"), str(proposal), self._filter()
        )
        if not chosen:
            return False
        path = Path(chosen)
        if not path.suffix:
            path = path.with_name(path.name + SUFFIX)
            why = self.tr("is there already.")
            if path.exists() and not file_questions.may_replace(self._window, path.name, why):
                return False
        return self.save_to(path)

    def save_to(self, path: Path) -> bool:
        """Write the file to a place; whether it was."""
        try:
            self._library.save(path)
        except SettingsError as error:
            self._notifier.error.emit(self.tr("Not saved. {0}.").format(str(error).rstrip(". ")))
            return False
        self._remember(path)
        self._notifier.info.emit(self.tr("Saved in {0}.").format(path))
        return True

    def may_close(self) -> bool:
        """Ask before edits are lost; save them if a person wants that."""
        take_typed()
        if not self._library.modified:
            return True
        match file_questions.before_closing(self._window, self._library.name):
            case file_questions.SaveAnswer.SAVE:
                return self.save()
            case file_questions.SaveAnswer.DISCARD:
                return True
        return False

    def folder(self) -> Path:
        """Return where the last file was opened or saved."""
        documents = QStandardPaths.StandardLocation.DocumentsLocation
        return Path(str(self._store.value(_FOLDER, QStandardPaths.writableLocation(documents))))

    def _remember(self, path: Path) -> None:
        self._store.setValue(_FOLDER, str(path.parent))

    def _filter(self) -> str:
        return self.tr("Pose files (*{0});;All files (*)").format(SUFFIX)
