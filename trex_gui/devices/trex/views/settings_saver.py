"""Commands that save or export the settings of a board."""

import contextlib
from collections.abc import Callable
from dataclasses import replace
from datetime import datetime
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QFileDialog, QWidget

from trex_gui.core.code import Language
from trex_gui.core.errors import StudioError
from trex_gui.core.files import SettingsError, load, save
from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.settings.document import text_of
from trex_gui.devices.trex.settings.code_export import export_code, file_name
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.edit_in_place import amend
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.devices.trex.settings.writer import write_settings
from trex_gui.ui.files import in_background
from trex_gui.ui.widgets import file_questions


class SettingsSaver(QObject):
    """Commands that save or export the displayed settings, including edits, in the background."""

    saved = Signal(object)  # `Path` of a settings file

    def __init__(self, device: Device, window: QWidget) -> None:
        super().__init__(window)
        self._device = device
        self._notifier = device.notifier
        self._window = window
        self.saving: set[Path] = set()  # files that are being written

    def prompt_and_save(self, on_done: Callable[[], object] = lambda: None) -> None:
        """Prompt for a file and save the settings, then call `on_done`."""
        state = self._device.state
        key = state.signature.model.key if state is not None else "trex"
        proposal = file_questions.last_folder() / f"{key}_settings.txt"
        path = file_questions.prompt_to_save(self._window, tr("&Save settings file…"), proposal)
        if path is not None:
            self.save_file(path, on_done)

    def prompt_and_export(self) -> None:
        settings = self._device.draft.shown
        if settings is None:
            return
        filters = {f"{language.title} (*{language.suffix})": language for language in Language}
        default = next(iter(Language))
        proposal = file_questions.last_folder() / file_name(settings, default)
        selected, kind = QFileDialog.getSaveFileName(
            self._window, title_of(tr("&Export as code…")), str(proposal), ";;".join(filters)
        )
        if selected:
            path = Path(selected)
            languages = {language.suffix: language for language in Language}
            language = languages.get(path.suffix.lower(), filters.get(kind, default))
            self.export_file(path, language)

    def export_file(self, path: Path, language: Language) -> None:
        """Export the source code of a program that applies the settings and drives the motors."""
        settings, link = self._device.draft.shown, self._device.settings
        if settings is None or link is None:
            return

        def on_failed(error: StudioError) -> None:
            self._notifier.error.emit(tr("{0} was not written: {1}").format(path.name, error))

        def on_saved(_: object) -> None:
            file_questions.remember_folder(path)
            text = tr(
                "The program {0} applies and verifies the displayed settings. Its first "
                "lines explain how to use the program."
            )
            self._notifier.info.emit(text.format(path))

        def work() -> None:
            save(path, export_code(settings, link, language))

        in_background(self, work, on_saved, on_failed)

    def save_file(self, path: Path, on_done: Callable[[], object] = lambda: None) -> None:
        """Save the settings, then call `on_done`.

        In an existing file, only the values change. The comments remain, and so do the
        calibrations of the other input source.
        """
        settings = self._device.draft.shown
        if settings is None:
            return
        if path in self.saving:
            text = tr("{0} was not saved again: it is still being saved.")
            self._notifier.error.emit(text.format(path.name))
            return
        self.saving.add(path)
        save_over = partial(self._save_over, path, settings, on_done)
        failed = partial(self._on_not_saved, path)
        in_background(self, partial(_content_of, path), save_over, failed)

    def _save_over(
        self,
        path: Path,
        settings: Settings,
        on_done: Callable[[], object],
        before: bytes | SettingsError | None,
    ) -> None:
        """Write over `before`: the file's content, its read error, or `None` without a file."""
        try:
            text, note = self._text_for(path, settings, before)
        except StudioError as error:
            self._on_not_saved(path, error)
            return
        if text is None:
            self.saving.discard(path)
            return

        def on_saved(_: object) -> None:
            self.saving.discard(path)
            self.saved.emit(path)
            news = tr("The settings shown were saved in {0}.").format(path)
            self._notifier.info.emit(f"{news} {note}".rstrip())
            on_done()

        in_background(self, partial(save, path, text), on_saved, partial(self._on_not_saved, path))

    def _on_not_saved(self, path: Path, error: StudioError) -> None:
        self.saving.discard(path)
        self._notifier.error.emit(tr("{0} was not saved: {1}").format(path.name, error))

    def _text_for(
        self, path: Path, settings: Settings, content: bytes | SettingsError | None
    ) -> tuple[str | None, str]:
        """Return the text to write, and a note on hidden calibrations.

        The text is `None` if the user has cancelled.

        Raises:
            SettingsError, BadRequest: the settings cannot be written.
        """
        now = datetime.now().astimezone().strftime("%Y-%m-%d %H:%M")
        new_text = write_settings(settings, title_lines=[f"Saved by TReX Studio, {now}."])
        if content is None:
            return new_text, ""
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
            return (new_text if may_replace else None), ""
        shown = {key.source for key in settings.calibrations}
        hidden = {key: value for key, value in old.calibrations.items() if key.source not in shown}
        merged = replace(settings, calibrations={**settings.calibrations, **hidden})
        try:
            text = amend(before, merged, path.name)
        except SettingsError as error:
            problem = error.findings[0].message
            return (new_text if file_questions.may_rewrite(self._window, problem) else None), ""
        names = ", ".join(sorted({key.source.word for key in hidden}))
        note = tr("Calibrations that the board does not currently report remain in the file: {0}.")
        return text, note.format(names) if hidden else ""


def _content_of(path: Path) -> bytes | SettingsError | None:
    """Return the content of a file, its read error, or `None` if there is no file."""
    try:
        return load(path) if path.exists() else None
    except SettingsError as error:
        return error
