"""A window for one settings file; it works with and without a board."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QByteArray, QSettings, Qt, Signal, SignalInstance, Slot
from PySide6.QtGui import QCloseEvent
from PySide6.QtWidgets import QDialog, QFileDialog, QMainWindow, QTabWidget, QVBoxLayout, QWidget

from trex_gui.core.files import SettingsError, load
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.linter import SettingsLinter
from trex_gui.devices.trex.model.settings.document import SettingsDocument
from trex_gui.devices.trex.settings.document import Settings, factory_settings
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.settings.rules import LintFinding
from trex_gui.devices.trex.views.action_bar import StopButton
from trex_gui.devices.trex.views.pages.parameters.table import ParameterTable
from trex_gui.devices.trex.views.settings_editor.calibration_page import CalibrationEditor
from trex_gui.devices.trex.views.settings_editor.compare_dialog import CompareDialog
from trex_gui.devices.trex.views.settings_editor.editor_actions import build_editor_menus
from trex_gui.devices.trex.views.settings_editor.findings_panel import FindingsPanel
from trex_gui.devices.trex.views.settings_editor.printed import PrintedSettings
from trex_gui.devices.trex.views.settings_editor.text_page import TextPage
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.theme.icons import application_icon
from trex_gui.ui.widgets import file_questions
from trex_gui.ui.widgets.builders import column
from trex_gui.ui.widgets.messages import Banner


class SettingsEditor(QMainWindow):
    """Pages around one document; gone with its window.

    Signals:
        send_requested: the board is to be offered what is shown here.
        new_requested: the user wants a new file.
        open_requested: the user wants to open another file.
        saved: where the file was written, a `Path`.
        closed: the window is closed.
    """

    send_requested = Signal()
    new_requested = Signal()
    open_requested = Signal()
    saved = Signal(object)
    closed = Signal()

    def __init__(
        self, document: SettingsDocument, device: Device, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self.setObjectName("settingsEditor")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowIcon(application_icon())
        self._document = document
        document.setParent(self)
        self._device = device
        self._linter = SettingsLinter(document.draft, self)
        self._store = QSettings(self)

        self._banner = Banner(self)
        self._parameters = ParameterTable(document.draft, self._linter, self)
        self._calibrations = CalibrationEditor(document.draft, self)
        self._findings = FindingsPanel(self)
        self._text = TextPage(document, self)
        self._tabs = QTabWidget(self)
        self._tabs.setObjectName("editorTabs")
        self._tabs.setAccessibleName(self.tr("Pages"))
        self._tabs.setDocumentMode(True)
        findings_page = _with_margins(self._findings)
        for title, page in (
            (self.tr("Parameters"), _with_margins(self._parameters)),
            (self.tr("Calibrations"), self._calibrations),
            (self.tr("Findings"), findings_page),
            (self.tr("Text"), self._text),
        ):
            self._tabs.addTab(page, title)
        self._findings_index = self._tabs.indexOf(findings_page)
        self._text_index = self._tabs.indexOf(self._text)

        frame = QWidget(self)
        column(
            self._banner,
            (self._tabs, 1),
            (StopButton(device, "editorStopButton", self), 0, Qt.AlignmentFlag.AlignLeft),
            into=frame,
        )
        self.setCentralWidget(frame)
        self._actions = build_editor_menus(self, self._slots())
        geometry = self._store.value("editor/geometry")
        if not isinstance(geometry, QByteArray) or not self.restoreGeometry(geometry):
            self.resize(1000, 720)

        document.changed.connect(self._on_document_changed)
        self._linter.changed.connect(self._on_document_changed)
        document.draft.undo.indexChanged.connect(self._on_actions_changed)
        self._text.editor.undoAvailable.connect(self._on_actions_changed)
        self._text.editor.redoAvailable.connect(self._on_actions_changed)
        self._text.checked.connect(self._on_checked)
        self._parameters.rejected.connect(self._banner.show_problem)
        self._findings.line_chosen.connect(self._on_line_chosen)
        self._findings.accepted.connect(self._on_accepted)
        device.link_changed.connect(self._on_actions_changed)
        device.state_changed.connect(self._on_actions_changed)
        self._on_document_changed()
        if not document.readable:
            self._tabs.setCurrentIndex(self._text_index)

    @property
    def document(self) -> SettingsDocument:
        """The file that is shown."""
        return self._document

    @property
    def tabs(self) -> QTabWidget:
        """The pages."""
        return self._tabs

    def _slots(self) -> dict[str, Callable[[], object]]:
        return {
            "new": self.new_requested.emit,
            "open": self.open_requested.emit,
            "save": self.save,
            "saveAs": self.ask_and_save,
            "print": self.preview,
            "pdf": self.ask_and_save_pdf,
            "close": self.close,
            "undo": self._undo,
            "redo": self._redo,
            "compareFile": self.ask_and_compare,
            "compareBoard": self.compare_with_board,
            "compareFactory": self.compare_with_factory,
            "send": self.send_requested.emit,
        }

    # --- Saving -------------------------------------------------------------------------

    def save(self) -> bool:
        """Write the file where it lies, after the questions that are due; whether it was."""
        path = self._document.path
        if path is None:
            return self.ask_and_save()
        if self._document.changed_on_disk() and not file_questions.may_overwrite(self, path.name):
            return False
        return self.save_to(path)

    def ask_and_save(self) -> bool:
        """Let the user choose where to write the file; whether it was."""
        folder = self._document.path.parent if self._document.path else self._folder()
        chosen, _ = QFileDialog.getSaveFileName(
            self,
            self.tr("Save settings file"),
            str(folder / self._document.name),
            file_questions.file_filter(),
        )
        return bool(chosen) and self.save_to(Path(chosen))

    def save_to(self, path: Path) -> bool:
        """Write the file to a place; whether it was."""
        fresh = False
        if trouble := self._document.trouble:
            if not file_questions.may_write_fresh(self, trouble):
                return False
            fresh = True
        try:
            self._document.save(path, fresh=fresh)
        except SettingsError as error:
            self._banner.show_problem(self.tr("Not saved. {0}").format(error))
            return False
        words = self.tr("Saved in {0}.").format(path)
        if not self._document.readable:
            words += " " + self.tr("It still has errors.")
        self._banner.show_news(words)
        self.saved.emit(path)
        return True

    # --- Printing -----------------------------------------------------------------------

    def _printed(self) -> PrintedSettings | None:
        settings = self._document.settings
        if settings is None:
            return None
        remarks = [str(found) for found in self._document.findings]
        remarks += [found.message for found in self._linter.findings]
        return PrintedSettings(settings, self._document.name, remarks)

    def preview(self) -> QDialog | None:
        """Show the pages as they would be printed."""
        printed = self._printed()
        if printed is None:
            return None
        try:
            dialog = printed.preview(self)
        except SettingsError as error:
            self._banner.show_problem(str(error))
            return None
        dialog.show()
        return dialog

    def ask_and_save_pdf(self) -> None:
        """Let the user choose where to save the pages."""
        folder = self._document.path.parent if self._document.path else self._folder()
        name = folder / Path(self._document.name).with_suffix(".pdf").name
        chosen, _ = QFileDialog.getSaveFileName(
            self, self.tr("Save as PDF"), str(name), self.tr("PDF (*.pdf)")
        )
        if chosen:
            self.save_pdf(Path(chosen))

    def save_pdf(self, path: Path) -> None:
        """Save the pages."""
        printed = self._printed()
        if printed is None:
            return
        try:
            printed.save_pdf(path)
        except SettingsError as error:
            self._banner.show_problem(self.tr("Not saved. {0}").format(error))
            return
        self._banner.show_news(self.tr("The pages were saved in {0}.").format(path))

    # --- Comparing ----------------------------------------------------------------------

    def ask_and_compare(self) -> None:
        """Let the user choose another file to compare with."""
        chosen, _ = QFileDialog.getOpenFileName(
            self, self.tr("Compare with"), str(self._folder()), file_questions.file_filter()
        )
        if chosen:
            self.compare_with_file(Path(chosen))

    def compare_with_file(self, path: Path) -> None:
        """Show this file beside another one."""
        try:
            other, _ = read_settings(load(path), path.name)
        except SettingsError as error:
            self._banner.show_problem(self.tr("Not compared. {0}").format(error))
            return
        self._compare(lambda: other, path.name)

    def compare_with_board(self) -> None:
        """Show this file beside what the board shows."""
        changed = self._device.draft.pending_changed
        self._compare(lambda: self._device.draft.shown, self.tr("Board, as shown"), changed)

    def compare_with_factory(self) -> None:
        """Show this file beside what its kind of board comes with."""
        settings = self._document.settings
        if settings is not None:
            factory = factory_settings(settings.product, settings.firmware)
            self._compare(lambda: factory, self.tr("Factory values"))

    def _compare(
        self,
        other: Callable[[], Settings | None],
        name: str,
        renewed_by: SignalInstance | None = None,
    ) -> None:
        dialog = CompareDialog(self._document, other, name, renewed_by=renewed_by, parent=self)
        dialog.taken.connect(self._banner.show_news)
        dialog.show()

    # --- Undo ---------------------------------------------------------------------------

    def _undo(self) -> None:
        if self._document.readable:
            self._document.draft.undo.undo()
        else:
            self._text.editor.undo()

    def _redo(self) -> None:
        if self._document.readable:
            self._document.draft.undo.redo()
        else:
            self._text.editor.redo()

    # --- What has changed ---------------------------------------------------------------

    @Slot()
    def _on_document_changed(self) -> None:
        document = self._document
        self.setWindowTitle(self.tr("{0}[*] – TReX settings file").format(document.name))
        self.setWindowModified(document.modified)
        findings = self._linter.findings if document.readable else ()
        self._findings.show_findings(document.findings, findings, text=document.text)
        count = self._findings.count
        title = self.tr("Findings ({0})").format(count) if count else self.tr("Findings")
        self._tabs.setTabText(self._findings_index, title)
        for index in range(self._findings_index):
            self._tabs.setTabEnabled(index, document.readable)
        self._on_actions_changed()

    @Slot()
    def _on_actions_changed(self) -> None:
        """Let every action say whether it can be done now."""
        readable = self._document.readable
        up = self._device.link is ConnectionState.CONNECTED and self._device.state is not None
        undo, text = self._document.draft.undo, self._text.editor.document()
        for key, possible in {
            "print": readable,
            "pdf": readable,
            "compareFile": readable,
            "compareBoard": readable and up,
            "compareFactory": readable,
            "send": readable and up,
            "undo": undo.canUndo() if readable else text.isUndoAvailable(),
            "redo": undo.canRedo() if readable else text.isRedoAvailable(),
        }.items():
            self._actions[key].setEnabled(possible)
        done, undone = (undo.undoText(), undo.redoText()) if readable else ("", "")
        self._actions["undo"].setText(self.tr("&Undo {0}").format(done).strip())
        self._actions["redo"].setText(self.tr("&Redo {0}").format(undone).strip())

    @Slot()
    def _on_checked(self) -> None:
        if self._document.readable:
            self._banner.show_news(self.tr("The text has no errors any more; every page is open."))
        else:
            self._banner.clear()

    @Slot(int)
    def _on_line_chosen(self, line: int) -> None:
        self._tabs.setCurrentIndex(self._text_index)
        self._text.show_line(line)

    @Slot(object)
    def _on_accepted(self, finding: LintFinding) -> None:
        self._linter.accept(finding)

    # --- The end ------------------------------------------------------------------------

    def may_close(self) -> bool:
        """Ask before edits are lost; save them if the user wants that."""
        if not self._document.modified:
            return True
        self.activateWindow()
        match file_questions.before_closing(self, self._document.name):
            case file_questions.SaveAnswer.SAVE:
                return self.save()
            case file_questions.SaveAnswer.DISCARD:
                return True
        return False

    def closeEvent(self, event: QCloseEvent) -> None:
        if not self.may_close():
            event.ignore()
            return
        self._leave()
        super().closeEvent(event)

    def close_at_once(self) -> None:
        """Close without a question; what is not saved is lost."""
        self._leave()
        self.hide()
        self.deleteLater()

    def _leave(self) -> None:
        self._store.setValue("editor/geometry", self.saveGeometry())
        self.closed.emit()

    def _folder(self) -> Path:
        return file_questions.last_folder(self._store)


def _with_margins(page: QWidget) -> QWidget:
    """Give a page that has no margins of its own the usual ones."""
    frame = QWidget()
    QVBoxLayout(frame).addWidget(page)
    return frame
