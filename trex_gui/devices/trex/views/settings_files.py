"""Commands for settings files."""

from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Qt, Signal, Slot
from PySide6.QtWidgets import QDialogButtonBox, QInputDialog, QListView, QWidget

from trex_gui.core.errors import StudioError
from trex_gui.core.files import SettingsError, load, reason_of
from trex_gui.core.resource_files import resource
from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr, tr_noop
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.settings.document import SettingsDocument
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.settings.document import Settings, factory_settings
from trex_gui.devices.trex.views.changes.dialog import ChangesDialog
from trex_gui.devices.trex.views.changes.files import load_dialog
from trex_gui.devices.trex.views.settings_saver import SettingsSaver
from trex_gui.ui.files import in_background
from trex_gui.ui.widgets import file_questions
from trex_gui.ui.widgets.builders import named, tab_order
from trex_gui.ui.widgets.file_questions import SaveAnswer
from trex_gui.ui.widgets.placement import fit_on_screen, resize_with_font

if TYPE_CHECKING:
    from trex_gui.devices.trex.views.settings_editor.window import SettingsEditor

SAMPLES = {  # file name without suffix → purpose, as stated in the first comment of the file
    "autonomous_robot": tr_noop(
        "An autonomous robot: an on-board computer drives it, and no one is near enough to catch it"
    ),
    "rover_with_serial_override": tr_noop(
        "A rover driven by radio; a switch hands control to a computer"
    ),
    "tank_with_mix": tr_noop("A tank: two tracks, driven by radio with one stick"),
}


class SettingsFiles(QObject):
    staged = Signal()  # the settings of a file became edits
    used = Signal(object)  # `Path` of an opened or saved settings file

    def __init__(self, device: Device, window: QWidget) -> None:
        super().__init__(window)
        self._device = device
        self._notifier = device.notifier
        self._window = window
        self._load_dialog: ChangesDialog | None = None
        self.editors: list[SettingsEditor] = []  # one window per open file
        self.saver = SettingsSaver(device, window)
        self.saver.saved.connect(self._record_used)
        self._discarded: dict[SettingsEditor, str] = {}  # texts that the user agreed to discard

    def prompt_and_open(self) -> None:
        self._prompt_and(self.open_file)

    def prompt_for_document(self, on_opened: Callable[[SettingsDocument], object]) -> None:
        """Prompt for a file and pass its document to `on_opened`, even if the file has errors."""
        self._prompt_and(lambda path: self._open(path, on_opened))

    def _prompt_and(self, action: Callable[[Path], object]) -> None:
        path = file_questions.prompt_to_open(self._window, tr("&Open settings file…"))
        if path is not None:
            action(path)

    def prompt_and_create(self) -> None:
        factories = dict(self._initial_contents())
        dialog = QInputDialog(self._window)
        dialog.setObjectName("newSettingsDialog")
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.setWindowTitle(title_of(tr("&New settings file…")))
        dialog.setLabelText(tr("&Start the new file with:"))
        dialog.setOption(QInputDialog.InputDialogOption.UseListViewForComboBoxItems)
        dialog.setComboBoxItems(list(factories))
        (view,) = dialog.findChildren(QListView, options=Qt.FindChildOption.FindDirectChildrenOnly)
        named(view, "beginningsList", accessible=tr("Initial contents"))
        view.setCurrentIndex(view.model().index(0, 0))
        view.activated.connect(dialog.accept)
        dialog.textValueSelected.connect(lambda text: self.open_editor(factories[text]()))
        (buttons,) = dialog.findChildren(QDialogButtonBox)
        tab_order(view, buttons)
        resize_with_font(dialog, 620, 440)
        fit_on_screen(dialog)
        dialog.show()

    def _initial_contents(self) -> Iterator[tuple[str, Callable[[], SettingsDocument]]]:
        """Yield titles and factories of the initial contents of a new file."""
        shown = self._device.draft.shown
        if shown is not None and self._device.state is not None:
            text = tr("The board as shown: {0}, firmware {1}")
            yield (
                text.format(shown.product.name, shown.firmware),
                partial(_document, shown, "As shown."),
            )
        text = tr("Factory defaults of a {0}, firmware {1}")
        for model in device_table().models:
            for firmware in reversed(model.firmware):
                defaults = factory_settings(model, firmware)
                create = partial(_document, defaults, "Factory defaults.")
                yield text.format(model.name, firmware), create
        for path in sorted(resource("samples").glob("*.txt")):
            if path.stem in SAMPLES:
                create = partial(SettingsDocument, path.read_text(encoding="utf-8"), path.name)
                yield tr("Sample: {0}").format(tr(SAMPLES[path.stem])), create

    def open_file(self, path: Path) -> None:
        """Show the changes that a file would make. Without a board, open the file in an editor."""
        if self._device.state is None:
            self.edit_file(path)
        else:
            self._open(path, self._offer_or_edit)

    def _offer_or_edit(self, document: SettingsDocument) -> None:
        if self._device.state is None:  # the board was disconnected
            self.open_editor(document)
        elif document.path is not None:
            self._offer(document, edit=partial(self.edit_file, document.path))

    def edit_file(self, path: Path) -> None:
        if not self._raise_editor_of(path):
            self._open(path, self._edit)

    def _edit(self, document: SettingsDocument) -> None:
        if document.path is None or not self._raise_editor_of(document.path):
            self.open_editor(document)

    def _raise_editor_of(self, path: Path) -> bool:
        """Raise the editor of a file. Return false if the file has no editor."""
        for editor in self.editors:
            if editor.document.path == path:
                _raise(editor)
                return True
        return False

    def _open(self, path: Path, on_opened: Callable[[SettingsDocument], object]) -> None:
        def on_failed(error: StudioError) -> None:
            text = tr("{0} was not opened: {1}.")
            self._notifier.error.emit(text.format(path.name, reason_of(error)))

        def on_read(data: bytes) -> None:
            if not self._window.isVisible():  # the window was closed
                return
            try:
                document = SettingsDocument.of_file(path, data)
            except SettingsError as error:
                on_failed(error)
                return
            self._record_used(path)
            on_opened(document)

        in_background(self, partial(load, path), on_read, on_failed)

    @Slot(object)
    def _record_used(self, path: Path) -> None:
        file_questions.remember_folder(path)
        self.used.emit(path)

    @Slot(object)
    def open_editor(self, document: SettingsDocument) -> None:
        from trex_gui.devices.trex.views.settings_editor.window import SettingsEditor  # noqa: PLC0415

        editor = SettingsEditor(document, self._device)
        self.editors.append(editor)
        editor.send_requested.connect(partial(self._send, editor))
        editor.new_requested.connect(self.prompt_and_create)
        editor.open_requested.connect(partial(self._prompt_and, self.edit_file))
        editor.converted.connect(self.open_editor)
        editor.saved.connect(self._record_used)
        editor.closed.connect(partial(self._on_editor_closed, editor))
        _raise(editor)

    def _on_editor_closed(self, editor: "SettingsEditor") -> None:
        if editor in self.editors:
            self.editors.remove(editor)

    def _send(self, editor: "SettingsEditor") -> None:
        if editor.document.settings is not None and self._device.state is not None:
            self._offer(editor.document)

    def offer_settings(self, settings: Settings, applied: str) -> None:
        title = tr("Settings applied {0}").format(applied)
        document = SettingsDocument.of_settings(settings, title, "Settings applied.")
        self._offer(document, tr("Applied"))

    def _offer(
        self, document: SettingsDocument, side: str = "", edit: Callable[[], object] | None = None
    ) -> None:
        """Show the changes that a document would make. `side` replaces the heading *File*."""
        if self._load_dialog is not None:
            self._load_dialog.close()
        self._load_dialog = dialog = load_dialog(
            self._device,
            document,
            self._window,
            on_staged=self._on_staged,
            on_ended=self._notifier.error.emit,
            side=side,
            edit=edit,
        )
        dialog.finished.connect(partial(self._on_offer_finished, dialog))
        dialog.reset_and_show()

    def _on_offer_finished(self, dialog: ChangesDialog, _result: int) -> None:
        if dialog is self._load_dialog:
            self._load_dialog = None

    @Slot(str)
    def _on_staged(self, text: str) -> None:
        self._notifier.info.emit(text)
        self._window.activateWindow()
        self.staged.emit()

    def may_close(self, leave: Callable[[], object]) -> bool:
        """Return whether the windows may close now. Prompt first if there are unsaved changes.

        `leave` is called after the changes have been saved.
        """
        unfinished = ", ".join(path.name for path in self.saver.saving)
        if unfinished and not file_questions.may_leave_unfinished(self._window, unfinished):
            return False
        discarded, self._discarded = self._discarded, {}
        to_save: list[SettingsEditor] = []
        for editor in list(self.editors):
            if discarded.get(editor) == editor.document.text:
                continue
            match editor.answer():
                case SaveAnswer.SAVE:
                    to_save.append(editor)
                case SaveAnswer.DISCARD:
                    discarded[editor] = editor.document.text
                case SaveAnswer.CANCEL:
                    return False
        if to_save:
            self._save_and_leave(to_save, discarded, leave)
        return not to_save

    def _save_and_leave(
        self,
        editors: "list[SettingsEditor]",
        discarded: "dict[SettingsEditor, str]",
        leave: Callable[[], object],
    ) -> None:
        """Save the files of the editors in turn, then call `leave`."""
        if editors:
            save_next = partial(self._save_and_leave, editors[1:], discarded, leave)
            editors[0].saver.save_and_leave(editors[0].save, save_next)
        else:
            self._discarded = discarded
            leave()

    def close_all(self) -> None:
        for editor in list(self.editors):
            editor.close_at_once()


def _raise(editor: "SettingsEditor") -> None:
    editor.show()
    editor.activateWindow()


def _document(settings: Settings, title: str) -> SettingsDocument:
    name = f"{settings.product.key}_settings.txt"
    return SettingsDocument.of_settings(settings, name, title)
