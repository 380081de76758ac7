"""Opening and saving settings files, from the window and in windows of their own."""

import contextlib
from collections.abc import Callable, Iterator
from dataclasses import replace
from datetime import datetime
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, Qt, Signal, Slot
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QInputDialog,
    QListView,
    QWidget,
)

from trex_gui.core.code import Language
from trex_gui.core.errors import BadRequest, StudioError
from trex_gui.core.files import SettingsError, load, reason_of, save
from trex_gui.core.resource_files import resource
from trex_gui.core.translation import tr, tr_noop
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.settings.document import SettingsDocument, text_of
from trex_gui.devices.trex.protocol.device_table import Model, device_table
from trex_gui.devices.trex.settings.code_export import export_code, file_name
from trex_gui.devices.trex.settings.document import Settings, factory_settings
from trex_gui.devices.trex.settings.edit_in_place import amend
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.settings.writer import write_settings
from trex_gui.devices.trex.views.load_dialog import LoadDialog
from trex_gui.devices.trex.views.settings_editor.printed import PrintedSettings
from trex_gui.devices.trex.views.settings_editor.window import SettingsEditor
from trex_gui.ui.files import in_background
from trex_gui.ui.widgets import file_questions
from trex_gui.ui.widgets.builders import named, tab_order
from trex_gui.ui.widgets.file_questions import SaveAnswer
from trex_gui.ui.widgets.placement import keep_on_screen, resize_with_font

SAMPLES = {
    "autonomous_robot": tr_noop(
        "A robot without a driver: a computer on board drives it, and no one can catch it"
    ),
    "rover_with_serial_override": tr_noop(
        "A rover driven by radio; a switch hands it over to a computer"
    ),
    "tank_with_mix": tr_noop("A tank: two tracks, driven by radio with one stick"),
}
"""The first comment of each sample, which says what it is for, by the name of its file."""


class SettingsFiles(QObject):
    """File dialogs, editors and messages for settings files."""

    staged = Signal()  # settings of a file are edits now
    used = Signal(object)  # the `Path` of a settings file that was opened or saved

    def __init__(self, device: Device, window: QWidget) -> None:
        super().__init__(window)
        self._device = device
        self._notifier = device.notifier
        self._window = window
        self._loading: LoadDialog | None = None
        self.editors: list[SettingsEditor] = []  # the open windows, each with one file
        self._saving: set[Path] = set()
        self._discarded: dict[SettingsEditor, str] = {}  # texts that need not be saved

    def ask_and_open(self) -> None:
        """Let the user choose a file and show what it would change of the board."""
        self._ask_and(self.open_file)

    def ask_for_document(self, use: Callable[[SettingsDocument], object]) -> None:
        """Let the user choose a file; `use` gets it, also one with errors."""
        self._ask_and(lambda path: self._open(path, use))

    def _ask_and(self, use: Callable[[Path], object]) -> None:
        title = tr("Open settings file")
        path = file_questions.ask_to_open(self._window, title)
        if path is not None:
            use(path)

    def ask_and_save(self, then: Callable[[], object] = lambda: None) -> None:
        """Let the user choose where to save the settings shown; call `then` once they are."""
        state = self._device.state
        key = state.signature.model.key if state is not None else "trex"
        proposal = file_questions.last_folder() / f"{key}_settings.txt"
        title = tr("Save settings file")
        path = file_questions.ask_to_save(self._window, title, proposal)
        if path is not None:
            self.save_file(path, then)

    def ask_and_export(self) -> None:
        """Let the user choose where to save the settings shown as a program, and its language."""
        settings = self._device.draft.shown
        if settings is None:
            return
        filters = {f"{language.title} (*{language.suffix})": language for language in Language}
        proposal = file_name(settings, next(iter(filters.values())))
        name = file_questions.last_folder() / proposal
        chosen, kind = QFileDialog.getSaveFileName(
            self._window, tr("Export as code"), str(name), ";;".join(filters)
        )
        if chosen:
            path = Path(chosen)
            typed = {language.suffix: language for language in Language}
            self.export_file(path, typed.get(path.suffix.lower(), filters[kind]))

    def ask_and_begin(self) -> None:
        """Let the user choose what a new file begins with, and open a window for it."""
        makers = dict(self._beginnings())
        dialog = QInputDialog(self._window)
        dialog.setObjectName("newSettingsDialog")
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.setWindowTitle(tr("New settings file"))
        dialog.setLabelText(tr("&Start the new file with:"))
        dialog.setOption(QInputDialog.InputDialogOption.UseListViewForComboBoxItems)
        dialog.setComboBoxItems(list(makers))
        (view,) = dialog.findChildren(QListView, options=Qt.FindChildOption.FindDirectChildrenOnly)
        named(view, "beginningsList", accessible=tr("Beginnings"))
        view.setCurrentIndex(view.model().index(0, 0))
        view.activated.connect(dialog.accept)
        dialog.textValueSelected.connect(lambda text: self.open_editor(makers[text]()))
        (buttons,) = dialog.findChildren(QDialogButtonBox)
        tab_order(view, buttons)
        resize_with_font(dialog, 620, 440)
        keep_on_screen(dialog)
        dialog.show()

    def _beginnings(self) -> Iterator[tuple[str, Callable[[], SettingsDocument]]]:
        """Yield what a new file can begin with, by title."""
        shown = self._device.draft.shown
        if shown is not None and self._device.state is not None:
            text, title = tr("The board as shown: {0}, firmware {1}"), "As shown."
            name = f"{shown.product.key}_settings.txt"
            make = partial(SettingsDocument.of_settings, shown, name, title)
            yield text.format(shown.product.name, shown.firmware), make
        text = tr("Factory defaults of a {0}, firmware {1}")
        for model in device_table().models:
            for firmware in reversed(model.firmware):
                make = partial(_from_factory, model, firmware)
                yield text.format(model.name, firmware), make
        for path in sorted(resource("samples").glob("*.txt")):
            if path.stem in SAMPLES:
                make = partial(SettingsDocument, path.read_text(encoding="utf-8"), path.name)
                yield tr("Sample: {0}").format(tr(SAMPLES[path.stem])), make

    # --- Opening ------------------------------------------------------------------------

    def open_file(self, path: Path) -> None:
        """Show what a file would change of the board; with no board, the file itself."""
        if self._device.state is None:
            self.edit_file(path)
        else:
            self._open(path, self._offer_or_edit)

    def _offer_or_edit(self, document: SettingsDocument) -> None:
        if self._device.state is None:  # meanwhile
            self.open_editor(document)
        elif document.path is not None:
            dialog = self._offer(document)
            dialog.edit_wanted.connect(partial(self.edit_file, document.path))

    def edit_file(self, path: Path) -> None:
        """Open a file in a window of its own, or the window that has it already."""
        if not self._raise_editor_of(path):
            self._open(path, self._edit)

    def _edit(self, document: SettingsDocument) -> None:
        if document.path is None or not self._raise_editor_of(document.path):
            self.open_editor(document)

    def _raise_editor_of(self, path: Path) -> bool:
        """Raise the window that has a file; return whether there is one."""
        for editor in self.editors:
            if editor.document.path == path:
                _raise(editor)
                return True
        return False

    def _open(self, path: Path, then: Callable[[SettingsDocument], object]) -> None:
        in_background(
            self,
            partial(load, path),
            partial(self._on_read, path, then),
            partial(self._on_not_opened, path),
        )

    def _on_read(self, path: Path, then: Callable[[SettingsDocument], object], data: bytes) -> None:
        if not self._window.isVisible():  # closed meanwhile
            return
        try:
            document = SettingsDocument.of_file(path, data)
        except SettingsError as error:
            self._on_not_opened(path, error)
            return
        self._note_used(path)
        then(document)

    @Slot(object)
    def _note_used(self, path: Path) -> None:
        file_questions.remember_folder(path)
        self.used.emit(path)

    def _on_not_opened(self, path: Path, error: StudioError) -> None:
        text = tr("{0} was not opened: {1}.")
        self._notifier.error.emit(text.format(path.name, reason_of(error)))

    @Slot(object)
    def open_editor(self, document: SettingsDocument) -> None:
        editor = SettingsEditor(document, self._device)
        self.editors.append(editor)
        editor.send_requested.connect(partial(self._send, editor))
        editor.new_requested.connect(self.ask_and_begin)
        editor.open_requested.connect(partial(self._ask_and, self.edit_file))
        editor.converted.connect(self.open_editor)
        editor.saved.connect(self._note_used)
        editor.closed.connect(partial(self._on_editor_closed, editor))
        _raise(editor)

    def _on_editor_closed(self, editor: SettingsEditor) -> None:
        if editor in self.editors:
            self.editors.remove(editor)

    def _send(self, editor: SettingsEditor) -> None:
        """Offer to load the settings of an editor into the board."""
        if editor.document.settings is not None and self._device.state is not None:
            self._offer(editor.document).offer_editing(False)

    def offer_settings(self, settings: Settings, applied: str) -> None:
        """Offer settings that were applied to the board at this time."""
        title = tr("Settings applied {0}").format(applied)
        document = SettingsDocument.of_settings(settings, title, "Settings applied.")
        self._offer(document, tr("Applied")).offer_editing(False)

    def _offer(self, document: SettingsDocument, heading: str = "") -> LoadDialog:
        """Show what settings would change; `heading` names them in place of `File`."""
        if self._loading is not None:
            self._loading.close()
        dialog = LoadDialog(self._device, document, self._window, heading=heading)
        dialog.staged.connect(self._on_staged)
        dialog.ended.connect(self._notifier.error)
        dialog.finished.connect(partial(self._on_offer_finished, dialog))
        self._loading = dialog
        dialog.show()
        dialog.activateWindow()
        return dialog

    def _on_offer_finished(self, dialog: LoadDialog, _result: int) -> None:
        if dialog is self._loading:
            self._loading = None

    @Slot(str)
    def _on_staged(self, text: str) -> None:
        self._notifier.info.emit(text)
        self._window.activateWindow()
        self.staged.emit()

    def may_close(self, leave: Callable[[], object]) -> bool:
        """Return whether nothing would be lost; else ask in each window with unsaved changes.

        Once those are saved that the user wants to save, `leave` is called.
        """
        if self._saving and not file_questions.may_leave_unfinished(
            self._window, ", ".join(path.name for path in self._saving)
        ):
            return False
        agreed, self._discarded = self._discarded, {}
        to_save: list[SettingsEditor] = []
        for editor in list(self.editors):
            if editor in agreed and agreed[editor] == editor.document.text:
                continue
            match editor.answer():
                case SaveAnswer.SAVE:
                    to_save.append(editor)
                case SaveAnswer.DISCARD:
                    agreed[editor] = editor.document.text
                case SaveAnswer.CANCEL:
                    return False
        if to_save:
            self._save_and_leave(to_save, agreed, leave)
        return not to_save

    def _save_and_leave(
        self,
        editors: list[SettingsEditor],
        discarded: dict[SettingsEditor, str],
        leave: Callable[[], object],
    ) -> None:
        """Save one after the other; what was discarded is asked about again if it changes."""
        if editors:
            following = partial(self._save_and_leave, editors[1:], discarded, leave)
            editors[0].saver.save_and_leave(editors[0].save, following)
        else:
            self._discarded = discarded
            leave()

    def close_all(self) -> None:
        for editor in list(self.editors):
            editor.close_at_once()

    # --- Saving and printing what the board shows ---------------------------------------

    def export_file(self, path: Path, language: Language) -> None:
        """Write a program that applies the settings shown and drives the motors."""
        settings, link = self._device.draft.shown, self._device.settings
        if settings is None or link is None:
            return
        try:
            code = export_code(settings, link, language)
        except BadRequest as error:
            self._on_not_exported(path, error)
            return
        in_background(
            self,
            partial(save, path, code),
            lambda _: self._on_exported(path),
            partial(self._on_not_exported, path),
        )

    def _on_not_exported(self, path: Path, error: StudioError) -> None:
        self._notifier.error.emit(tr("{0} was not written: {1}").format(path.name, error))

    def _on_exported(self, path: Path) -> None:
        file_questions.remember_folder(path)
        text = tr("{0} applies and checks the settings shown; read its first lines.")
        self._notifier.info.emit(text.format(path))

    def save_file(self, path: Path, then: Callable[[], object] = lambda: None) -> None:
        """Save the settings shown, edits included; call `then` once they are saved.

        In an existing file only the values change. The user's comments stay, and so do the
        calibrations of the other input source, which the board does not show.
        """
        settings = self._device.draft.shown
        if settings is None:
            return
        if path in self._saving:
            text = tr("{0} was not saved again: it is still being saved.")
            self._notifier.error.emit(text.format(path.name))
            return
        self._saving.add(path)
        in_background(
            self,
            partial(_content_of, path),
            partial(self._save_over, path, settings, then),
            partial(self._on_not_saved, path),
        )

    def _save_over(
        self,
        path: Path,
        settings: Settings,
        then: Callable[[], object],
        before: bytes | SettingsError | None,
    ) -> None:
        """Save into a file that holds this, or cannot be read; `None`: there is no file."""
        try:
            text, kept = self._text_for(path, settings, before)
        except StudioError as error:
            self._on_not_saved(path, error)
            return
        if text is None:
            self._saving.discard(path)
            return
        in_background(
            self,
            partial(save, path, text),
            lambda _: self._on_saved(path, kept, then),
            partial(self._on_not_saved, path),
        )

    def _on_not_saved(self, path: Path, error: StudioError) -> None:
        self._saving.discard(path)
        self._notifier.error.emit(tr("{0} was not saved: {1}").format(path.name, error))

    def _on_saved(self, path: Path, kept: str, then: Callable[[], object]) -> None:
        self._saving.discard(path)
        self._note_used(path)
        saved = tr("The settings shown were saved in {0}.").format(path)
        self._notifier.info.emit(f"{saved} {kept}".rstrip())
        then()

    def _text_for(
        self, path: Path, settings: Settings, content: bytes | SettingsError | None
    ) -> tuple[str | None, str]:
        """Return what to write, and a note about what was kept; `None`: the user cancelled.

        Raises:
            SettingsError, BadRequest: it cannot be written.
        """
        now = datetime.now().astimezone().strftime("%Y-%m-%d %H:%M")
        fresh = write_settings(settings, title_lines=[f"Saved by TReX Studio, {now}."])
        if content is None:
            return fresh, ""
        reason = tr("is not a readable settings file.")
        before, old = "", None
        if isinstance(content, bytes):
            with contextlib.suppress(SettingsError):
                before, _ = text_of(content, path.name)
                old, _ = read_settings(before, path.name)
        if old is not None and old.product.key != settings.product.key:
            reason, old = tr("holds settings of a {0}.").format(old.product.name), None
        if old is None:
            may_replace = file_questions.may_replace(self._window, path.name, reason)
            return (fresh if may_replace else None), ""
        shown = {key.source for key in settings.calibrations}
        hidden = {key: c for key, c in old.calibrations.items() if key.source not in shown}
        whole = replace(settings, calibrations={**settings.calibrations, **hidden})
        try:
            text = amend(before, whole, path.name)
        except SettingsError as error:
            trouble = error.findings[0].message
            return (fresh if file_questions.may_write_fresh(self._window, trouble) else None), ""
        names = ", ".join(sorted({key.source.word for key in hidden}))
        kept = tr("Calibrations that the board does not show now were kept: {0}.")
        return text, kept.format(names) if hidden else ""

    def preview(self) -> QDialog | None:
        settings, state = self._device.draft.shown, self._device.state
        if settings is None or state is None:
            return None
        name = tr("{0}, settings shown").format(state.signature)
        return PrintedSettings(settings, name).preview(self._window, self._notifier.error.emit)


def _raise(editor: SettingsEditor) -> None:
    editor.show()
    editor.activateWindow()


def _content_of(path: Path) -> bytes | SettingsError | None:
    """Return what a file holds, or why it cannot be read; `None` if it is missing."""
    try:
        return load(path) if path.exists() else None
    except SettingsError as error:
        return error


def _from_factory(model: Model, firmware: str) -> SettingsDocument:
    settings = factory_settings(model, firmware)
    name = f"{model.key}_settings.txt"
    return SettingsDocument.of_settings(settings, name, "Factory defaults.")
