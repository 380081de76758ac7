"""Opening and saving settings files, from the window and in windows of their own."""

from dataclasses import replace
from datetime import datetime
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, QSettings, Signal, Slot
from PySide6.QtWidgets import QDialog, QFileDialog, QWidget

from trex_gui.core.errors import BadRequest
from trex_gui.core.files import Finding, SettingsError, load, save
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.settings.document import SettingsDocument, text_of
from trex_gui.devices.trex.settings.code_export import Language, export_code, file_name
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.edit_in_place import amend
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.settings.writer import write_settings
from trex_gui.devices.trex.views.settings_editor.load_dialog import LoadDialog, ReadFile
from trex_gui.devices.trex.views.settings_editor.new_dialog import NewDialog
from trex_gui.devices.trex.views.settings_editor.printed import PrintedSettings
from trex_gui.devices.trex.views.settings_editor.window import SettingsEditor
from trex_gui.ui.widgets import file_questions


class SettingsFiles(QObject):
    """Asks for a file, shows what is in it, and says what became of it.

    Signals:
        staged: the settings of a file became edits of the board's.

    Attributes:
        editors: the windows that are open, each with one file.
    """

    staged = Signal()

    def __init__(self, device: Device, window: QWidget) -> None:
        super().__init__(window)
        self._device = device
        self._notifier = device.notifier
        self._window = window
        self._store = QSettings(self)
        self._loading: LoadDialog | None = None
        self.editors: list[SettingsEditor] = []

    # --- Asking -------------------------------------------------------------------------

    def ask_and_open(self) -> None:
        """Let the user choose a file to look at."""
        chosen, _ = QFileDialog.getOpenFileName(
            self._window,
            self.tr("Open settings file"),
            str(file_questions.last_folder(self._store)),
            file_questions.file_filter(),
        )
        if chosen:
            self.open_file(Path(chosen))

    def ask_and_save(self) -> bool:
        """Let the user choose where to save the settings shown; return whether they are."""
        state = self._device.state
        key = state.signature.model.key if state is not None else "trex"
        name = file_questions.last_folder(self._store) / f"{key}_settings.txt"
        chosen, _ = QFileDialog.getSaveFileName(
            self._window, self.tr("Save settings file"), str(name), file_questions.file_filter()
        )
        return bool(chosen) and self.save_file(Path(chosen))

    def ask_and_export(self) -> None:
        """Let the user choose where to save the settings shown as a program, and its language."""
        settings = self._device.draft.shown
        if settings is None:
            return
        filters = {f"{language.title} (*{language.suffix})": language for language in Language}
        proposal = file_name(settings, next(iter(filters.values())))
        name = file_questions.last_folder(self._store) / proposal
        chosen, kind = QFileDialog.getSaveFileName(
            self._window, self.tr("Export as code"), str(name), ";;".join(filters)
        )
        if chosen:
            path = Path(chosen)
            written = {language.suffix: language for language in Language}
            self.export_file(path, written.get(path.suffix.lower(), filters[kind]))

    def ask_and_begin(self) -> None:
        """Let the user choose what a new file begins with, and open a window for it."""
        dialog = NewDialog(self._device, self._window)
        dialog.made.connect(self.open_editor)
        dialog.show()

    # --- Opening ------------------------------------------------------------------------

    def open_file(self, path: Path, *, remember: bool = True) -> None:
        """Show what a file would change of the board; with no board, the file itself.

        With `remember`, its folder is where the next file is looked for.
        """
        if self._device.state is None:
            self.edit_file(path, remember=remember)
            return
        settings: Settings | None = None
        findings: tuple[Finding, ...] = ()
        try:
            data = load(path)
            text, _ = text_of(data, path.name)
        except SettingsError as error:
            self._refuse(path, error)
            return
        try:
            settings, findings = read_settings(data, path.name)
        except SettingsError as error:
            findings = error.findings
        if remember:
            file_questions.remember_folder(self._store, path)
        dialog = self._offer(ReadFile(path.name, text, settings, findings))
        dialog.edit_wanted.connect(partial(self.edit_file, path, remember=remember))

    def edit_file(self, path: Path, *, remember: bool = True) -> SettingsEditor | None:
        """Open a file in a window of its own, or the window that has it already."""
        for editor in self.editors:
            if editor.document.path == path:
                _raise(editor)
                return editor
        try:
            document = SettingsDocument.open(path)
        except SettingsError as error:
            self._refuse(path, error)
            return None
        if remember:
            file_questions.remember_folder(self._store, path)
        return self.open_editor(document)

    @Slot(object)
    def open_editor(self, document: SettingsDocument) -> SettingsEditor:
        """Open a window for a file."""
        editor = SettingsEditor(document, self._device)
        self.editors.append(editor)
        editor.send_requested.connect(partial(self._send, editor))
        editor.new_requested.connect(self.ask_and_begin)
        editor.open_requested.connect(self._on_open_requested)
        editor.saved.connect(partial(file_questions.remember_folder, self._store))
        editor.closed.connect(partial(self._forget, editor))
        _raise(editor)
        return editor

    @Slot()
    def _on_open_requested(self) -> None:
        """Open another file beside the one that is edited."""
        chosen, _ = QFileDialog.getOpenFileName(
            self._window,
            self.tr("Open settings file"),
            str(file_questions.last_folder(self._store)),
            file_questions.file_filter(),
        )
        if chosen:
            self.edit_file(Path(chosen))

    def _forget(self, editor: SettingsEditor) -> None:
        if editor in self.editors:
            self.editors.remove(editor)

    def _send(self, editor: SettingsEditor) -> None:
        """Offer the board what an editor shows."""
        document = editor.document
        if document.settings is not None and self._device.state is not None:
            dialog = self._offer(
                ReadFile(document.name, document.text, document.settings, document.findings)
            )
            dialog.offer_editing(False)

    def _offer(self, file: ReadFile) -> LoadDialog:
        if self._loading is not None:
            self._loading.close()
        dialog = LoadDialog(self._device, file, self._window)
        dialog.staged.connect(self._on_staged)
        dialog.ended.connect(self._notifier.error)
        dialog.finished.connect(self._on_offer_finished)
        self._loading = dialog
        dialog.show()
        dialog.activateWindow()
        return dialog

    @Slot()
    def _on_offer_finished(self) -> None:
        if self.sender() is self._loading:
            self._loading = None

    @Slot(str)
    def _on_staged(self, words: str) -> None:
        self._notifier.info.emit(words)
        self._window.activateWindow()
        self.staged.emit()

    def _refuse(self, path: Path, error: SettingsError) -> None:
        reasons = "; ".join(str(finding) for finding in error.findings)
        self._notifier.error.emit(self.tr("{0} was not opened: {1}.").format(path.name, reasons))

    # --- Closing ------------------------------------------------------------------------

    def may_close(self) -> bool:
        """Ask in each window that has unsaved changes; whether all may close."""
        return all(editor.may_close() for editor in list(self.editors))

    def close_all(self) -> None:
        """Close every window without another question."""
        for editor in list(self.editors):
            editor.close_at_once()

    # --- Saving and printing what the board shows ---------------------------------------

    def export_file(self, path: Path, language: Language) -> None:
        """Write a program that applies the settings shown and drives the motors."""
        settings, link = self._device.draft.shown, self._device.settings
        if settings is None or link is None:
            return
        try:
            save(path, export_code(settings, link, language))
        except (SettingsError, BadRequest) as error:
            self._notifier.error.emit(self.tr("{0} was not written: {1}").format(path.name, error))
            return
        file_questions.remember_folder(self._store, path)
        text = self.tr("{0} applies and checks the settings shown; read its first lines.")
        self._notifier.info.emit(text.format(path))

    def save_file(self, path: Path) -> bool:
        """Write the settings shown, edits included; return whether they are saved.

        Of a file that is there only the values are written.

        The user's comments stay, and so does what the board does not show now: the
        calibrations of the other input source.
        """
        settings = self._device.draft.shown
        if settings is None:
            return False
        try:
            text, kept = self._text_for(path, settings)
            if text is None:
                return False
            save(path, text)
        except (SettingsError, BadRequest) as error:
            self._notifier.error.emit(self.tr("{0} was not saved: {1}").format(path.name, error))
            return False
        file_questions.remember_folder(self._store, path)
        words = self.tr("The settings shown were saved in {0}.").format(path)
        self._notifier.info.emit(f"{words} {kept}".rstrip())
        return True

    def _text_for(self, path: Path, settings: Settings) -> tuple[str | None, str]:
        """Return what to write, and a note about what was kept; `None`: the user cancelled.

        Raises:
            SettingsError, BadRequest: it cannot be written.
        """
        now = datetime.now().astimezone().strftime("%Y-%m-%d %H:%M")
        fresh = write_settings(settings, title_lines=[f"Saved by TReX Studio, {now}."])
        if not path.exists():
            return fresh, ""
        try:
            before, _ = text_of(load(path), path.name)
            old, _ = read_settings(before, path.name)
        except SettingsError:
            why = self.tr("is not a readable settings file.")
            return (fresh if file_questions.may_replace(self._window, path.name, why) else None), ""
        if old.product.key != settings.product.key:
            why = self.tr("holds settings of a {0}.").format(old.product.name)
            return (fresh if file_questions.may_replace(self._window, path.name, why) else None), ""
        shown = {key.source for key in settings.calibrations}
        hidden = {key: c for key, c in old.calibrations.items() if key.source not in shown}
        whole = replace(settings, calibrations={**settings.calibrations, **hidden})
        try:
            text = amend(before, whole, path.name)
        except SettingsError as error:
            trouble = error.findings[0].message
            return (fresh if file_questions.may_write_fresh(self._window, trouble) else None), ""
        names = " and ".join(sorted({key.source.value for key in hidden}))
        kept = self.tr("Its {0} calibrations, which the board does not show now, were kept.")
        return text, kept.format(names) if hidden else ""

    def preview(self) -> QDialog | None:
        """Show the pages that would be printed of the settings shown."""
        settings, state = self._device.draft.shown, self._device.state
        if settings is None or state is None:
            return None
        name = self.tr("{0}, settings shown").format(state.signature)
        try:
            dialog = PrintedSettings(settings, name).preview(self._window)
        except SettingsError as error:
            self._notifier.error.emit(str(error))
            return None
        dialog.show()
        return dialog


def _raise(editor: SettingsEditor) -> None:
    editor.show()
    editor.activateWindow()
