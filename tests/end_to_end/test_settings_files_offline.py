"""Settings files are opened and saved in windows of their own, with nothing connected."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDialogButtonBox, QListView, QMessageBox
from shiboken6 import isValid

from tests.support.pages.settings import SettingsFiles, answer_questions
from tests.support.window import LEFT, WindowDriver

TEXT = "product: TReX\n# my rover\nserial_timeout: 5  # 0.5 s\n"
BEGINNINGS = (
    ("Factory defaults of a TReX Jr, firmware 1.1", "motor_mode", 0),
    ("Sample: A tank: two tracks, driven by radio with one stick", "parabolic_channels", 3),
)


@pytest.fixture
def files(window: WindowDriver) -> Iterator[SettingsFiles]:
    files = SettingsFiles(window)
    yield files
    files.files.close_all()


@pytest.fixture
def rover(tmp_path: Path) -> Path:
    path = tmp_path / "rover.txt"
    path.write_text(TEXT, encoding="utf-8")
    return path


def test_file_is_opened_edited_saved_and_closed(
    window: WindowDriver, files: SettingsFiles, rover: Path, tmp_path: Path
) -> None:
    assert window.action("open").isEnabled()
    files.files.open_file(rover)
    window.wait_for_files()
    editor = files.editor()
    assert editor.root.isVisible()
    assert editor.document.text == TEXT
    assert not editor.action("Send").isEnabled()
    files.files.open_file(rover)
    window.wait_for_files()
    assert len(files.files.editors) == 1, "it is open already"

    editor.edit("serial_timeout", 15)
    editor.action("Save").trigger()
    window.wait_for_files()
    assert rover.read_text(encoding="utf-8") == TEXT.replace("5  # 0.5 s", "15  # 1.5 s")
    assert not editor.document.modified

    other = tmp_path / "other.txt"
    other.write_text(TEXT, encoding="utf-8")
    files.files.open_file(other)
    window.wait_for_files()
    assert len(files.files.editors) == 2
    editor.action("Close").trigger()
    window.wait(lambda: not isValid(editor.root))
    assert [each.document.name for each in files.files.editors] == ["other.txt"]


def test_new_file_starts_with_chosen_settings(
    window: WindowDriver, files: SettingsFiles, tmp_path: Path
) -> None:
    for beginning, key, value in BEGINNINGS:
        window.trigger("new")
        dialog = window.dialog("newSettingsDialog")
        beginnings = dialog.find(QListView, "beginningsList")
        model, whole = beginnings.model(), Qt.MatchFlag.MatchExactly
        (index,) = model.match(model.index(0, 0), Qt.ItemDataRole.DisplayRole, beginning, -1, whole)
        beginnings.setCurrentIndex(index)
        box = dialog.find_only(QDialogButtonBox)
        QTest.mouseClick(box.button(QDialogButtonBox.StandardButton.Ok), LEFT)
        editor = files.editor()
        assert editor.document.draft.parameters.values.value_of(key) == value, beginning
        assert not editor.root.isWindowModified()
        editor.editor.save_to(tmp_path / "mine.txt")
        window.wait_for_files()
        assert editor.root.windowTitle().startswith("mine.txt")
        files.files.close_all()
        window.wait(lambda: not window.has("newSettingsDialog"))


def test_closing_the_program_asks_about_unsaved_files(
    window: WindowDriver, files: SettingsFiles, rover: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    files.files.open_file(rover)
    window.wait_for_files()
    editor = files.editor()
    editor.edit("serial_timeout", 15)
    questions = answer_questions(monkeypatch, QMessageBox.StandardButton.Cancel)
    assert not window.window.close()
    assert "rover.txt has changes that are not saved" in questions[0]
    assert editor.root.isVisible()
    answer_questions(monkeypatch, QMessageBox.StandardButton.Discard)
    assert window.window.close()
    assert not files.files.editors
    assert rover.read_text(encoding="utf-8") == TEXT


def test_apply_and_undo_shortcuts_work_only_in_main_window(window: WindowDriver) -> None:
    """Undo there does not undo here; Esc stops the motors everywhere."""
    for key, context in (
        ("apply", Qt.ShortcutContext.WindowShortcut),
        ("undo", Qt.ShortcutContext.WindowShortcut),
        ("stop", Qt.ShortcutContext.ApplicationShortcut),
    ):
        assert window.action(key).shortcutContext() is context, key
