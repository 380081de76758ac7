"""File dialogs, and questions before a file is overwritten or changes are lost."""

from enum import Enum, auto
from pathlib import Path

from PySide6.QtCore import QStandardPaths
from PySide6.QtWidgets import QFileDialog, QMessageBox, QWidget

from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.ui.preferences import Preferences
from trex_gui.ui.widgets.builders import plain

_FOLDER = "settings/folder"


class SaveAnswer(Enum):
    SAVE = auto()
    DISCARD = auto()
    CANCEL = auto()


def prompt_about_changes(window: QWidget, name: str) -> SaveAnswer:
    button = QMessageBox.StandardButton
    answer = QMessageBox.question(
        window,
        tr("Unsaved changes"),
        plain(tr("{0} has changes that are not saved. Save them?").format(name)),
        button.Save | button.Discard | button.Cancel,
        button.Save,
    )
    return {button.Save: SaveAnswer.SAVE, button.Discard: SaveAnswer.DISCARD}.get(
        answer, SaveAnswer.CANCEL
    )


def may_overwrite(window: QWidget, name: str) -> bool:
    return _confirm(
        window,
        tr("Changed on disk"),
        tr(
            "{0} was changed by another program since it was opened here. Overwrite those changes?"
        ).format(name),
    )


def may_leave_unfinished(window: QWidget, name: str) -> bool:
    text = tr("{0} is still being saved. Close without waiting? Changes may be lost.")
    return _confirm(window, tr("Still saving"), text.format(name))


def may_rewrite(window: QWidget, reason: str) -> bool:
    return _confirm(
        window,
        tr("Rewrite the file"),
        tr(
            "The changes cannot be merged into the text of the file: {0}.\n\nRewrite the file from "
            "the settings? Its comments will be lost."
        ).format(reason),
    )


def may_replace(window: QWidget, name: str, why: str) -> bool:
    """Ask before replacing a file. `why`: rest of the sentence that begins with `name`."""
    return _confirm(window, tr("Replace the file"), tr("{0} {1} Replace it?").format(name, why))


def _confirm(window: QWidget, title: str, text: str) -> bool:
    button = QMessageBox.StandardButton
    answer = QMessageBox.question(
        window, title, plain(text), button.Yes | button.Cancel, button.Cancel
    )
    return answer == button.Yes


def file_filter() -> str:
    return tr("Text files (*.txt);;All files (*)")


def last_folder(key: str = _FOLDER) -> Path:
    """Return the folder in which file dialogs with this `key` open."""
    documents = QStandardPaths.StandardLocation.DocumentsLocation
    return Preferences().path(key, QStandardPaths.writableLocation(documents))


def remember_folder(path: Path, key: str = _FOLDER) -> None:
    Preferences().set(key, str(path.parent))


def prompt_to_open(
    window: QWidget, title: str, filters: str = "", key: str = _FOLDER
) -> Path | None:
    """Open a file dialog in the last folder. `title` may be a menu text."""
    folder, kinds = str(last_folder(key)), filters or file_filter()
    chosen, _ = QFileDialog.getOpenFileName(window, title_of(title), folder, kinds)
    return Path(chosen) if chosen else None


def prompt_to_save(
    window: QWidget,
    title: str,
    proposal: Path,
    filters: str | None = None,
    suffix: str = "",
    *,
    required: bool = False,
) -> Path | None:
    """Open a file dialog for saving. Return the selected file.

    `title` may be a menu text. `suffix` is added to a name without a suffix. If `required`,
    `suffix` is also added to a name with another suffix.
    """
    title, kinds = title_of(title), filters or file_filter()
    chosen, _ = QFileDialog.getSaveFileName(window, title, str(proposal), kinds)
    if not chosen:
        return None
    path = Path(chosen)
    is_complete = path.suffix.lower() == suffix if required else bool(path.suffix)
    if suffix and not is_complete:
        path = path.with_name(path.name + suffix)
        if path.exists() and not may_replace(window, path.name, tr("already exists.")):
            return None
    return path
