"""Pose files from the panel, and the questions that are due."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QComboBox, QFileDialog, QLabel, QMessageBox, QWidget
from pytestqt.qtbot import QtBot

from tests.aracna.views.poses_stage import EIGHT, Stage
from trex_gui.views.settings_editor import questions


@pytest.fixture
def stage(qtbot: QtBot) -> Iterator[Stage]:
    stage = Stage(qtbot)
    yield stage
    stage.panel.close()
    stage.panel.deleteLater()


def action(stage: Stage, name: str) -> QAction:
    found = stage.panel.findChild(QAction, name)
    assert found is not None
    return found


def answering(monkeypatch: pytest.MonkeyPatch, answer: questions.Answer) -> list[str]:
    """Answer the question about edits that are not saved; return for which file it was asked."""
    asked: list[str] = []

    def before_closing(_window: QWidget, name: str) -> questions.Answer:
        asked.append(name)
        return answer

    monkeypatch.setattr(questions, "before_closing", before_closing)
    return asked


def test_a_file_is_saved_opened_and_its_folder_remembered(stage: Stage, tmp_path: Path) -> None:
    path = tmp_path / "mine.ppr"
    stage.library.add_pose(EIGHT, "mine")
    label = stage.panel.findChild(QLabel, "aracnaPoseFile")
    assert label is not None
    assert label.text() == "poses.ppr, changed"
    assert stage.panel.files.save_to(path)
    assert label.text() == "mine.ppr"
    action(stage, "aracnaNewFileAction").trigger()
    assert "mine" not in stage.pose_names()
    assert stage.panel.files.open_file(path)
    assert "mine" in stage.pose_names()
    assert "was opened" in stage.said[-1]
    assert stage.panel.files.folder() == tmp_path


def test_edits_that_are_not_saved_are_asked_about_before_another_file(
    stage: Stage, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "other.ppr"
    path.write_text("Aracna:8\nPose=only:1\n", encoding="utf-8")
    stage.library.add_pose(EIGHT, "mine")
    asked = answering(monkeypatch, questions.Answer.CANCEL)
    assert not stage.panel.files.open_file(path)
    assert asked == ["poses.ppr"]
    assert "mine" in stage.pose_names()
    answering(monkeypatch, questions.Answer.DISCARD)
    assert stage.panel.files.open_file(path)
    assert stage.pose_names() == ["only"]


def test_what_reading_a_file_found_is_said_with_its_lines(stage: Stage, tmp_path: Path) -> None:
    path = tmp_path / "odd.ppr"
    path.write_text("Aracna:2:1024:1024\nPose=a:1, x\n", encoding="utf-8")
    stage.panel.files.open_file(path)
    assert "line 2" in stage.said[-1]
    assert "'x'" in stage.said[-1]


def test_a_change_by_another_program_is_asked_about_before_it_is_lost(
    stage: Stage, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "mine.ppr"
    stage.panel.files.save_to(path)
    path.write_text("Aracna:8\n", encoding="utf-8")
    cancel = QMessageBox.StandardButton.Cancel
    monkeypatch.setattr(QMessageBox, "question", lambda *_: cancel)
    assert not stage.panel.files.save()
    assert path.read_text(encoding="utf-8") == "Aracna:8\n"


def test_a_file_that_cannot_be_opened_or_written_is_said(stage: Stage, tmp_path: Path) -> None:
    assert not stage.panel.files.open_file(tmp_path / "none.ppr")
    assert "no such file" in stage.said[-1]
    assert not stage.panel.files.save_to(tmp_path / "gone" / "a.ppr")
    assert stage.said[-1].startswith("Not saved.")


def test_of_a_file_full_of_mistakes_only_the_first_are_said(stage: Stage, tmp_path: Path) -> None:
    path = tmp_path / "novel.ppr"
    path.write_text("It was a dark night\n" * 1000, encoding="utf-8")
    stage.panel.files.open_file(path)
    assert "And 992 more." in stage.said[-1]
    assert len(stage.said[-1].splitlines()) == 10


def test_save_as_adds_the_suffix_and_asks_before_it_replaces_what_is_there(
    stage: Stage, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    chosen = str(tmp_path / "mine")
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (chosen, ""))
    assert stage.panel.files.ask_and_save()
    assert stage.library.path == tmp_path / "mine.ppr"
    stage.library.add_pose((1,) * 8, "more")
    cancel = QMessageBox.StandardButton.Cancel
    monkeypatch.setattr(QMessageBox, "question", lambda *_: cancel)
    assert not stage.panel.files.ask_and_save()
    assert "more" not in (tmp_path / "mine.ppr").read_text(encoding="utf-8")


def test_a_pose_that_no_step_can_name_is_offered_to_none_and_why_is_said(
    stage: Stage, tmp_path: Path
) -> None:
    path = tmp_path / "comma.ppr"
    path.write_text("Aracna:8\nPose=a, b:512\nPose=c:512\nSeq=s: c|500\n", encoding="utf-8")
    stage.panel.files.open_file(path)
    stage.choose("aracnaMotions", "s")
    stage.choose("aracnaPoses", "a, b")
    assert not stage.button("aracnaAddStep").isEnabled()
    assert "without comma and bar" in stage.button("aracnaAddStep").toolTip()
    view = stage.steps
    view.edit(view.model().index(0, 1))
    combo = view.findChild(QComboBox, "aracnaStepPose")
    assert combo is not None
    assert [combo.itemText(place) for place in range(combo.count())] == ["c"]
    stage.library.rename_pose("a, b", "a b")
    stage.choose("aracnaPoses", "a b")
    stage.click("aracnaAddStep")
    assert [step.pose_name for step in stage.library.sequences[0].steps] == ["c", "a b"]


def test_a_pose_with_blanks_around_its_name_is_the_one_that_steps_name(
    stage: Stage, tmp_path: Path
) -> None:
    path = tmp_path / "blanks.ppr"
    path.write_text("Aracna:8\nPose= sp :512\nSeq=s: \n", encoding="utf-8")
    stage.panel.files.open_file(path)
    stage.choose("aracnaMotions", "s")
    stage.choose("aracnaPoses", "sp")
    stage.click("aracnaAddStep")
    stage.panel.files.save()
    stage.panel.files.open_file(path)
    assert "not in the file" not in stage.said[-1]
    assert stage.library.pose(stage.library.sequences[0].steps[0].pose_name) is not None
