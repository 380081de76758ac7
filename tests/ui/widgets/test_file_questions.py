"""Questions before a file is written."""

from pathlib import Path

import pytest
from PySide6.QtWidgets import QFileDialog, QMessageBox, QWidget
from pytestqt.qtbot import QtBot

from trex_gui.ui.widgets.file_questions import prompt_to_save


@pytest.fixture
def window(qtbot: QtBot) -> QWidget:
    widget = QWidget()
    qtbot.addWidget(widget)
    return widget


@pytest.mark.parametrize(
    ("entered", "required", "saved"),
    [
        ("a", False, "a.txt"),
        ("a.TXT", True, "a.TXT"),
        ("a.log", False, "a.log"),
        ("a.log", True, "a.log.txt"),
    ],
)
def test_entered_name_is_completed_with_the_suffix(
    window: QWidget,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    entered: str,
    required: bool,
    saved: str,
) -> None:
    selected = str(tmp_path / entered)
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (selected, ""))
    path = prompt_to_save(window, "Save", tmp_path, suffix=".txt", required=required)
    assert path == tmp_path / saved


@pytest.mark.parametrize("replace", [True, False])
def test_file_of_completed_name_is_replaced_only_on_consent(
    window: QWidget, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, replace: bool
) -> None:
    existing = tmp_path / "a.txt"
    existing.touch()
    button = QMessageBox.StandardButton
    monkeypatch.setattr(
        QMessageBox, "question", lambda *_: button.Yes if replace else button.Cancel
    )
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(tmp_path / "a"), ""))
    path = prompt_to_save(window, "Save", tmp_path, suffix=".txt")
    assert path == (existing if replace else None)
