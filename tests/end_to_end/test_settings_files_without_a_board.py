"""A person works on settings files with nothing connected."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QAction, QDragEnterEvent, QDropEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QApplication,
    QDialog,
    QDialogButtonBox,
    QLabel,
    QListWidget,
    QMessageBox,
    QPushButton,
    QWidget,
)
from pytestqt.qtbot import QtBot
from shiboken6 import isValid

from tests.support.bad_files import BAD_FILES, BadFile
from trex_gui.views.settings_editor.window import SettingsEditor
from trex_gui.window import Program

TEXT = "product: TReX\n# my rover\nserial_timeout: 5  # 0.5 s\n"


@pytest.fixture
def alone(program: Program) -> Iterator[Program]:
    yield program
    program.desk.files.close_all()


@pytest.fixture
def rover(tmp_path: Path) -> Path:
    path = tmp_path / "rover.txt"
    path.write_text(TEXT, encoding="utf-8")
    return path


def only_editor(program: Program) -> SettingsEditor:
    (editor,) = program.desk.files.editors
    return editor


def banner(window: QWidget) -> str:
    label = window.findChild(QLabel, "bannerText")
    assert label is not None
    return label.text()


def action(window: QWidget, name: str) -> QAction:
    found = window.findChild(QAction, f"{name}Action")
    assert found is not None
    return found


def answer(monkeypatch: pytest.MonkeyPatch, button: QMessageBox.StandardButton) -> list[str]:
    """Press this button in every question; return what is asked."""
    asked: list[str] = []

    def question(_window: QWidget, _title: str, text: str, *_: object) -> object:
        asked.append(text)
        return button

    monkeypatch.setattr(QMessageBox, "question", question)
    return asked


def test_a_file_opens_in_a_window_of_its_own(alone: Program, rover: Path) -> None:
    assert action(alone.window, "open").isEnabled()
    alone.desk.files.open_file(rover)
    editor = only_editor(alone)
    assert editor.isVisible()
    assert editor.document.text == TEXT
    assert not action(editor, "editorSend").isEnabled()


def test_a_file_is_edited_saved_and_reads_back(alone: Program, rover: Path) -> None:
    alone.desk.files.open_file(rover)
    editor = only_editor(alone)
    editor.document.draft.parameters.edit("serial_timeout", 15)
    action(editor, "editorSave").trigger()
    assert rover.read_text(encoding="utf-8") == TEXT.replace("5  # 0.5 s", "15  # 1.5 s")
    assert not editor.document.modified


def test_a_file_that_is_open_already_comes_to_the_front(
    alone: Program, rover: Path, tmp_path: Path
) -> None:
    alone.desk.files.open_file(rover)
    alone.desk.files.open_file(rover)
    assert len(alone.desk.files.editors) == 1
    other = tmp_path / "other.txt"
    other.write_text(TEXT, encoding="utf-8")
    alone.desk.files.open_file(other)
    assert len(alone.desk.files.editors) == 2


@pytest.mark.parametrize("bad", BAD_FILES, ids=lambda bad: bad.name)
def test_a_bad_file_opens_as_text_or_is_refused_in_a_sentence(
    alone: Program, tmp_path: Path, bad: BadFile
) -> None:
    path = tmp_path / "bad.txt"
    path.write_bytes(bad.data)
    alone.desk.files.open_file(path)
    if bad.is_text:
        found = only_editor(alone).document.findings
        assert any(bad.words in each.message and each.line == bad.line for each in found)
    else:
        assert not alone.desk.files.editors
        assert "bad.txt was not opened" in banner(alone.window)
        assert bad.words in banner(alone.window)
    assert path.read_bytes() == bad.data


@pytest.mark.parametrize(
    ("beginning", "key", "wire"),
    [
        ("Factory values of a TReX Jr, firmware 1.1", "motor_mode", 0),
        ("Sample: A tank: two tracks, driven by radio with one stick", "parabolic_channels", 3),
    ],
)
def test_a_new_file_begins_with_what_is_chosen(
    alone: Program, tmp_path: Path, beginning: str, key: str, wire: int
) -> None:
    action(alone.window, "new").trigger()
    dialog = alone.window.findChild(QDialog, "newSettingsDialog")
    assert dialog is not None
    beginnings = dialog.findChild(QListWidget, "beginningsList")
    assert beginnings is not None
    (item,) = beginnings.findItems(beginning, Qt.MatchFlag.MatchExactly)
    beginnings.setCurrentItem(item)
    box = dialog.findChild(QDialogButtonBox)
    assert box is not None
    ok: QPushButton = box.button(QDialogButtonBox.StandardButton.Ok)
    QTest.mouseClick(ok, Qt.MouseButton.LeftButton)
    editor = only_editor(alone)
    assert editor.document.draft.parameters.value_of(key) == wire
    assert not editor.isWindowModified()
    assert editor.save_to(tmp_path / "mine.txt")
    assert editor.windowTitle().startswith("mine.txt")


def test_closing_the_program_asks_about_unsaved_files(
    alone: Program, rover: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    alone.desk.files.open_file(rover)
    editor = only_editor(alone)
    editor.document.draft.parameters.edit("serial_timeout", 15)
    asked = answer(monkeypatch, QMessageBox.StandardButton.Cancel)
    assert not alone.window.close()
    assert "rover.txt has changes that are not saved" in asked[0]
    assert editor.isVisible()
    answer(monkeypatch, QMessageBox.StandardButton.Discard)
    assert alone.window.close()
    assert not alone.desk.files.editors
    assert rover.read_text(encoding="utf-8") == TEXT


def test_a_window_that_was_closed_is_forgotten(alone: Program, rover: Path, qtbot: QtBot) -> None:
    alone.desk.files.open_file(rover)
    editor = only_editor(alone)
    action(editor, "editorClose").trigger()
    qtbot.waitUntil(lambda: not isValid(editor))
    assert not alone.desk.files.editors


def test_a_text_file_that_is_dropped_opens(alone: Program, rover: Path, qtbot: QtBot) -> None:
    for name, opened in (("rover.png", 0), ("rover.txt", 1)):
        data = QMimeData()
        data.setUrls([QUrl.fromLocalFile(str(rover.with_name(name)))])
        how = (Qt.DropAction.CopyAction, data, Qt.MouseButton.LeftButton)
        key = Qt.KeyboardModifier.NoModifier
        QApplication.sendEvent(alone.window, QDragEnterEvent(QPoint(5, 5), *how, key))
        QApplication.sendEvent(alone.window, QDropEvent(QPointF(5, 5), *how, key))
        label = alone.window.findChild(QLabel, "bannerText")
        assert label is not None
        if opened:
            qtbot.waitUntil(lambda: len(alone.desk.files.editors) == 1, timeout=15_000)
        else:
            qtbot.waitUntil(lambda label=label: bool(label.text()), timeout=15_000)  # type: ignore[misc]
            assert label.text().startswith("rover.png was not opened")
            assert alone.desk.files.editors == []
        alone.desk.files.close_all()


def test_keys_of_the_main_window_do_nothing_to_a_board_from_an_editor(
    alone: Program, rover: Path
) -> None:
    """Ctrl+P applies settings there and prints here; Esc stops the motors everywhere."""
    for name, context in (
        ("apply", Qt.ShortcutContext.WindowShortcut),
        ("undo", Qt.ShortcutContext.WindowShortcut),
        ("stop", Qt.ShortcutContext.ApplicationShortcut),
    ):
        assert action(alone.window, name).shortcutContext() is context
