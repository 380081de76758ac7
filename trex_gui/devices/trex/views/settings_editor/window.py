"""Window that edits a settings file, with or without a board."""

from functools import partial
from pathlib import Path

from PySide6.QtCore import Qt, Signal, SignalInstance, Slot
from PySide6.QtGui import QAction, QCloseEvent, QKeySequence, QUndoStack
from PySide6.QtWidgets import QMainWindow, QPlainTextEdit, QTabWidget, QToolBar, QWidget

from trex_gui.core.errors import StudioError
from trex_gui.core.files import load, save
from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.linter import SettingsLinter
from trex_gui.devices.trex.model.settings.document import SettingsDocument
from trex_gui.devices.trex.settings.document import factory_settings
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.views.changes.files import GetSettings, show_comparison, show_conversion
from trex_gui.devices.trex.views.motor_controls import MotorBar
from trex_gui.devices.trex.views.pages.parameters.page import ParameterTable
from trex_gui.devices.trex.views.settings_editor.channels_page import DocumentChannels
from trex_gui.devices.trex.views.settings_editor.pdf import settings_pdf
from trex_gui.devices.trex.views.settings_editor.text_page import TextPage
from trex_gui.ui.devices.undo import undo_titles
from trex_gui.ui.files import in_background
from trex_gui.ui.frame.workspace import SEPARATOR, Entry, fill_menu_bar
from trex_gui.ui.theme.icons import application_icon
from trex_gui.ui.widgets import file_questions
from trex_gui.ui.widgets.builders import column, named
from trex_gui.ui.widgets.document_saver import DocumentSaver
from trex_gui.ui.widgets.file_questions import SaveAnswer
from trex_gui.ui.widgets.messages import Banner, MessageSpace
from trex_gui.ui.widgets.placement import fit_on_screen, restore_geometry, save_geometry
from trex_gui.ui.widgets.scroll_box import ScrollBox

_TOOL_BAR = ("new", "open", "save", SEPARATOR, "undo", "redo", SEPARATOR, "send")


class SettingsEditor(QMainWindow):
    send_requested = Signal()  # the user selected “Send to the board…”
    new_requested = Signal()
    open_requested = Signal()
    converted = Signal(object)  # `SettingsDocument` for another board
    saved = Signal(object)  # `Path` of the file
    closed = Signal()

    def __init__(self, document: SettingsDocument, device: Device) -> None:
        super().__init__()
        self.setObjectName("settingsEditor")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowIcon(application_icon())
        self.document = document
        document.setParent(self)
        self.saver = DocumentSaver(document, self)
        self._device = device
        self._linter = SettingsLinter(document.draft, self)

        self._banner = Banner(self)
        self.tabs = named(QTabWidget(self), "editorTabs", accessible=tr("Pages"))
        self.tabs.setDocumentMode(True)
        self.tabs.tabBar().setDrawBase(False)  # the tool bar already draws this line
        parameters = ParameterTable(document.draft, self._linter, self)
        self._text = TextPage(document, self)
        frame = QWidget(self)
        column(parameters, into=frame, margins=16)
        self.tabs.addTab(frame, tr("Parameters"))
        channels = DocumentChannels(document.draft, self._linter, self)
        self.tabs.addTab(ScrollBox(channels, self), tr("Channels"))
        self._text_index = self.tabs.addTab(self._text, tr("Text"))
        bar = MotorBar(device, "editorStopButton", self)
        bar.fill(bar.armed, 1)
        frame = QWidget(self)
        messages = MessageSpace(frame, self._banner)
        column((self.tabs, 1), messages, bar, into=frame, margins=0, spacing=0)
        self.setCentralWidget(frame)
        self._actions = self._build_menus()
        self._build_tool_bar()
        restore_geometry(self, "editor", 1000, 720)
        fit_on_screen(self)

        self.saver.saved.connect(self._on_saved)
        self.saver.failed.connect(self._on_not_saved)
        document.changed.connect(self._on_document_changed)
        text, undo = self._text.editor, document.draft.undo
        board = device.link_changed, device.state_changed
        for changed in (undo.indexChanged, text.undoAvailable, text.redoAvailable, *board):
            changed.connect(self._update_actions)
        self._text.checked.connect(self._on_checked)
        self._text.repaired.connect(self._on_repaired)
        document.draft.parameters.rejected.connect(self._banner.show_problem)
        document.draft.parameters.rounded.connect(self._banner.show_news)
        self._on_document_changed()
        if not document.readable:
            self.tabs.setCurrentIndex(self._text_index)

    def _build_menus(self) -> dict[str, QAction]:
        keys, send = QKeySequence.StandardKey, self.send_requested.emit
        menus = {
            tr("&File"): (
                Entry("new", tr("&New…"), self.new_requested.emit, keys.New, "new"),
                Entry("open", tr("&Open…"), self.open_requested.emit, keys.Open, "open"),
                SEPARATOR,
                Entry("save", tr("&Save"), self.save, keys.Save, "save"),
                Entry("saveAs", tr("Save &as…"), self._prompt_and_save, "Ctrl+Shift+S"),
                SEPARATOR,
                Entry("pdf", tr("Save as P&DF…"), self._prompt_and_save_pdf),
                SEPARATOR,
                Entry("close", tr("&Close"), self.close, keys.Close),
            ),
            tr("&Edit"): (
                Entry("undo", tr("&Undo"), lambda: self._edits().undo(), keys.Undo, "undo"),
                Entry("redo", tr("&Redo"), lambda: self._edits().redo(), keys.Redo, "redo"),
                SEPARATOR,
                Entry("convert", tr("&Convert for another board…"), self.convert),
            ),
            tr("&Compare"): (
                Entry("compareFile", tr("With another &file…"), self._prompt_and_compare),
                Entry("compareBoard", tr("With the &board"), self.compare_with_board),
                Entry("compareFactory", tr("With factory &defaults"), self._compare_with_factory),
            ),
            tr("&Device"): (
                Entry("send", tr("&Send to the board…"), send, "Ctrl+Return", "apply"),
            ),
        }
        return fill_menu_bar(self, menus.items(), "editor")

    def _build_tool_bar(self) -> None:
        bar = named(QToolBar(tr("Tool bar"), self), "editorToolBar")
        bar.setMovable(False)
        bar.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        for key in _TOOL_BAR:
            if key == SEPARATOR:
                bar.addSeparator()
                continue
            action = self._actions[key]
            action.setIconText(action.text().replace("&", "").rstrip("…"))
            bar.addAction(action)
        self.addToolBar(bar)

    def save(self) -> bool:
        """Start saving the file. Return whether saving has started."""
        path = self.document.path
        return self._prompt_and_save() if path is None else self.save_to(path, ask=True)

    def _prompt_and_save(self) -> bool:
        title, proposal = tr("&Save settings file…"), self._folder() / self.document.name
        path = file_questions.prompt_to_save(self, title, proposal)
        return path is not None and self.save_to(path)

    def save_to(self, path: Path, *, ask: bool = False) -> bool:
        problem = self.document.problem
        if problem and not file_questions.may_rewrite(self, problem):
            return False
        return self.saver.save(path, partial(self.document.content, fresh=bool(problem)), ask=ask)

    @Slot(object)
    def _on_saved(self, path: Path) -> None:
        text = tr("Saved in {0}.").format(path)
        if not self.document.readable:
            text += " " + tr("The file still has errors.")
        self._banner.show_news(text)
        self.saved.emit(path)

    @Slot(object)
    def _on_not_saved(self, error: StudioError) -> None:
        self._banner.show_problem(tr("Not saved. {0}").format(error))

    def _prompt_and_save_pdf(self) -> None:
        name = self._folder() / Path(self.document.name).with_suffix(".pdf").name
        filters = tr("PDF (*.pdf)")
        path = file_questions.prompt_to_save(self, tr("Save as P&DF…"), name, filters)
        if path is not None:
            self.save_pdf(path)

    def save_pdf(self, path: Path) -> None:
        document = self.document
        if document.settings is None:
            return
        remarks = [str(finding) for finding in document.findings]
        remarks += [finding.message for finding in self._linter.findings]
        in_background(
            self,
            partial(save, path, settings_pdf(document.settings, document.name, remarks)),
            lambda _: self._banner.show_news(tr("Saved in {0}.").format(path)),
            self._on_not_saved,
        )

    def _folder(self) -> Path:
        path = self.document.path
        return path.parent if path is not None else file_questions.last_folder()

    def _prompt_and_compare(self) -> None:
        path = file_questions.prompt_to_open(self, tr("Compare &with:"))
        if path is not None:
            self.compare_with_file(path)

    def compare_with_file(self, path: Path) -> None:
        in_background(
            self,
            lambda: read_settings(load(path), path.name)[0],
            lambda other: self._compare(lambda: other, path.name),
            lambda error: self._banner.show_problem(tr("Not compared. {0}").format(error)),
        )

    def compare_with_board(self) -> None:
        draft = self._device.draft
        self._compare(lambda: draft.shown, tr("Board, as shown"), draft.pending_changed)

    def _compare_with_factory(self) -> None:
        settings = self.document.settings
        if settings is not None:
            factory = factory_settings(settings.product, settings.firmware)
            self._compare(lambda: factory, tr("Factory defaults"))

    def _compare(
        self, get_other: GetSettings, name: str, changed: SignalInstance | None = None
    ) -> None:
        show = partial(show_comparison, self._device, self.document, get_other, name, self)
        show(on_copied=self._banner.show_news, other_changed=changed)

    def convert(self) -> None:
        show_conversion(self._device, self.document, self, self.converted.emit)

    def _edits(self) -> QUndoStack | QPlainTextEdit:
        return self.document.draft.undo if self.document.readable else self._text.editor

    @Slot()
    def _on_document_changed(self) -> None:
        document = self.document
        self.setWindowTitle(tr("{0}[*] – TReX settings file").format(document.name))
        self.setWindowModified(document.modified)
        for index in range(self._text_index):
            self.tabs.setTabEnabled(index, document.readable)
        self._update_actions()

    @Slot()
    def _update_actions(self) -> None:
        readable = self.document.readable
        connected = self._device.is_connected and self._device.state is not None
        undo, text = self.document.draft.undo, self._text.editor.document()
        enabled_actions = {
            **dict.fromkeys(("pdf", "convert", "compareFile", "compareFactory"), readable),
            **dict.fromkeys(("compareBoard", "send"), readable and connected),
            "undo": undo.canUndo() if readable else text.isUndoAvailable(),
            "redo": undo.canRedo() if readable else text.isRedoAvailable(),
        }
        for key, enabled in enabled_actions.items():
            self._actions[key].setEnabled(enabled)
        done = (undo.undoText(), undo.redoText()) if readable else ("", "")
        for key, title in zip(("undo", "redo"), undo_titles(*done), strict=True):
            self._actions[key].setText(title)

    @Slot()
    def _on_checked(self) -> None:
        if self.document.readable:
            self._banner.show_news(tr("The text no longer has errors; all pages are available."))
        else:
            self._banner.clear()

    @Slot(object)
    def _on_repaired(self, repairs: tuple[str, ...]) -> None:
        if not repairs:
            text = tr("Nothing could be repaired: correct the text in the lines named below.")
            self._banner.show_problem(text)
            return
        parts = [tr("Repaired: {0}.").format("; ".join(repairs))]
        if not self.document.readable:
            parts.append(tr("Correct the rest in the text."))
        self._banner.show_news(" ".join(parts))

    def answer(self) -> SaveAnswer:
        """Prompt the user to save or discard unsaved changes. Return the answer."""
        if self.document.modified:
            self.activateWindow()
        return self.saver.answer()

    def closeEvent(self, event: QCloseEvent) -> None:
        if self.saver.may_leave(self.answer(), self.save, self.close):
            self._on_closing()
            super().closeEvent(event)
        else:
            event.ignore()

    def close_at_once(self) -> None:
        self._on_closing()
        self.hide()
        self.deleteLater()

    def _on_closing(self) -> None:
        save_geometry(self, "editor")
        self.closed.emit()
