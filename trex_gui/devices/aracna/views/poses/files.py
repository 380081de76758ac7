"""Opening and saving pose files."""

from collections.abc import Callable
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, Signal, Slot
from PySide6.QtWidgets import QWidget

from trex_gui.core.errors import StudioError
from trex_gui.core.files import Severity
from trex_gui.core.translation import tr
from trex_gui.devices.aracna.model.library import Library
from trex_gui.devices.aracna.poses.ppr import SUFFIX, PoseFile, read_file
from trex_gui.devices.aracna.poses.project import Project
from trex_gui.ui.files import in_background
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.widgets import file_questions
from trex_gui.ui.widgets.behaviour import commit_typed
from trex_gui.ui.widgets.document_saver import DocumentSaver

_FOLDER = "aracna/folder"

_MAX_FINDINGS = 8  # maximum in a message, which must fit into the window


class PoseFiles(QObject):
    """Opens and saves the file of a library. Prompts the user before edits are lost."""

    opened = Signal()
    used = Signal(object)  # `Path` of an opened or saved file

    def __init__(self, library: Library, notifier: Notifier, window: QWidget) -> None:
        super().__init__(window)
        self._library = library
        self._notifier = notifier
        self._window = window
        self._saver = DocumentSaver(library, window)
        self._saver.saved.connect(self._on_saved)
        self._saver.failed.connect(partial(self._report_error, tr("Not saved. {0}.")))

    @Slot()
    def new(self) -> None:
        if self.may_close(self.new):
            self._library.new()

    @Slot()
    def prompt_and_open(self) -> None:
        title, kinds = tr("&Open pose file…"), self._filter()
        if path := file_questions.prompt_to_open(self._window, title, kinds, _FOLDER):
            self.open_file(path)

    def open_file(self, path: Path) -> None:
        if self.may_close(partial(self.open_file, path)):
            in_background(
                self,
                partial(read_file, path),
                partial(self._on_read, path, self._library.project),
                partial(self._report_error, tr("Not opened. {0}.")),
            )

    def _on_read(self, path: Path, before: Project, file: PoseFile) -> None:
        if self._library.project != before:  # edited while the file was read
            retry = partial(self._on_read, path, self._library.project, file)
            if not self.may_close(retry):
                return
        self._library.set_file(path, file)
        self._record_used(path)
        findings = file.findings
        lines = [tr("{0} was opened.").format(path.name)]
        lines += [f"{str(finding).rstrip('. ')}." for finding in findings[:_MAX_FINDINGS]]
        if (more := len(findings) - _MAX_FINDINGS) > 0:
            lines.append(tr("And {0} more.").format(more))
        has_errors = any(finding.severity is Severity.ERROR for finding in findings)
        (self._notifier.error if has_errors else self._notifier.info).emit("\n".join(lines))
        self.opened.emit()

    @Slot()
    def save(self) -> bool:
        """Start saving the file. Return False if the user cancelled."""
        commit_typed()
        path = self._library.path
        if path is None:
            return self.prompt_and_save()
        return self._saver.save(path, self._library.content, ask=True)

    @Slot()
    def prompt_and_save(self) -> bool:
        commit_typed()
        title = tr("&Save pose file")
        folder = file_questions.last_folder(_FOLDER)
        proposal = self._library.path or folder / self._library.name
        path = file_questions.prompt_to_save(self._window, title, proposal, self._filter(), SUFFIX)
        return path is not None and self.save_to(path)

    def save_to(self, path: Path) -> bool:
        return self._saver.save(path, self._library.content)

    @Slot(object)
    def _on_saved(self, path: Path) -> None:
        self._record_used(path)
        self._notifier.info.emit(tr("Saved in {0}.").format(path))

    def may_close(self, leave: Callable[[], object]) -> bool:
        """Prompt before edits are lost. `leave` is called once the edits are saved."""
        commit_typed()
        return self._saver.may_leave(self._saver.answer(), self.save, leave)

    def _report_error(self, text: str, error: StudioError) -> None:
        self._notifier.error.emit(text.format(str(error).rstrip(". ")))

    def _record_used(self, path: Path) -> None:
        file_questions.remember_folder(path, _FOLDER)
        self.used.emit(path)

    def _filter(self) -> str:
        return tr("Pose files (*{0});;All files (*)").format(SUFFIX)
