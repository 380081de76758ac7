"""Pose files from the panel, and the questions that are due."""

from pathlib import Path

import pytest
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QFileDialog, QMessageBox, QWidget

from tests.devices.aracna.views.poses_stage import EIGHT, StagedPageDriver
from tests.support.slow_disk import SlowDisk
from trex_gui.devices.aracna.model.library import ItemKind
from trex_gui.ui.widgets import file_questions


def answering(monkeypatch: pytest.MonkeyPatch, answer: file_questions.SaveAnswer) -> list[str]:
    """Answer the question about edits that are not saved; return the names of the files."""
    names: list[str] = []

    def before_closing(_window: QWidget, name: str) -> file_questions.SaveAnswer:
        names.append(name)
        return answer

    monkeypatch.setattr(file_questions, "before_closing", before_closing)
    return names


def test_file_is_saved_and_reopened_and_folder_remembered(
    driver: StagedPageDriver, tmp_path: Path
) -> None:
    path = tmp_path / "mine.ppr"
    driver.library.add_pose(EIGHT, "mine")
    assert driver.text("aracnaPoseFile") == "poses.ppr, changed"
    driver.page.files.save_to(path)
    driver.wait_for_files()
    assert driver.text("aracnaPoseFile") == "mine.ppr"
    driver.find(QAction, "aracnaNewFileAction").trigger()
    assert "mine" not in driver.pose_names()
    driver.page.files.open_file(path)
    driver.wait_for_files()
    assert "mine" in driver.pose_names()
    assert "was opened" in driver.messages[-1]
    assert driver.page.files.folder() == tmp_path


def test_open_asks_about_unsaved_edits(
    driver: StagedPageDriver, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "other.ppr"
    path.write_text("Aracna:8\nPose=only:1\n", encoding="utf-8")
    driver.library.add_pose(EIGHT, "mine")
    names = answering(monkeypatch, file_questions.SaveAnswer.CANCEL)
    driver.page.files.open_file(path)
    driver.wait_for_files()
    assert names == ["poses.ppr"]
    assert "mine" in driver.pose_names()
    answering(monkeypatch, file_questions.SaveAnswer.DISCARD)
    driver.page.files.open_file(path)
    driver.wait_for_files()
    assert driver.pose_names() == ["only"]


def test_save_asks_before_overwriting_external_change(
    driver: StagedPageDriver, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "mine.ppr"
    driver.page.files.save_to(path)
    driver.wait_for_files()
    path.write_text("Aracna:8\n", encoding="utf-8")
    cancel = QMessageBox.StandardButton.Cancel
    monkeypatch.setattr(QMessageBox, "question", lambda *_: cancel)
    driver.page.files.save()
    driver.wait_for_files()
    assert path.read_text(encoding="utf-8") == "Aracna:8\n"


def test_unreadable_or_unwritable_file_is_reported(
    driver: StagedPageDriver, tmp_path: Path
) -> None:
    driver.page.files.open_file(tmp_path / "none.ppr")
    driver.wait_for_files()
    assert "no such file" in driver.messages[-1]
    driver.page.files.save_to(tmp_path / "gone" / "a.ppr")
    driver.wait_for_files()
    assert driver.messages[-1].startswith("Not saved.")


def test_slow_disk_loses_no_edits(
    driver: StagedPageDriver, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path, other = tmp_path / "mine.ppr", tmp_path / "other.ppr"
    other.write_text("Aracna:8\nPose=only:1\n", encoding="utf-8")
    disk = SlowDisk(monkeypatch)
    driver.library.add_pose(EIGHT, "mine")
    driver.page.files.save_to(path)
    driver.library.add_pose(EIGHT, "later")
    driver.wait_for_files()
    assert driver.text("aracnaPoseFile") == "mine.ppr, changed"
    answering(monkeypatch, file_questions.SaveAnswer.SAVE)
    driver.page.files.open_file(other)
    assert "mine" in driver.pose_names()
    driver.wait_for_files()
    assert "Pose=later:" in path.read_text(encoding="utf-8")
    assert driver.pose_names() == ["only"]
    assert disk.stalls == []


def test_second_save_writes_the_file_it_was_meant_for(
    driver: StagedPageDriver, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "mine.ppr"
    questions: list[str] = []

    def question(
        _window: QWidget, _title: str, text: str, *_: object
    ) -> QMessageBox.StandardButton:
        questions.append(text)
        return QMessageBox.StandardButton.Yes

    monkeypatch.setattr(QMessageBox, "question", question)
    driver.library.add_pose(EIGHT, "mine")
    driver.page.files.save_to(path)
    driver.wait_for_files()
    SlowDisk(monkeypatch)
    driver.page.files.save()
    driver.library.add_pose(EIGHT, "later")
    driver.page.files.save()
    driver.find(QAction, "aracnaNewFileAction").trigger()
    driver.wait_for_files()
    assert [text.split(".ppr ")[1].split(".")[0] for text in questions] == ["is still being saved"]
    assert "Pose=later:" in path.read_text(encoding="utf-8")
    assert driver.library.path is None


def test_only_first_findings_of_invalid_file_are_reported(
    driver: StagedPageDriver, tmp_path: Path
) -> None:
    path = tmp_path / "novel.ppr"
    path.write_text("It was a dark night\n" * 1000, encoding="utf-8")
    driver.page.files.open_file(path)
    driver.wait_for_files()
    assert "And 992 more." in driver.messages[-1]
    assert len(driver.messages[-1].splitlines()) == 10


def test_save_as_adds_suffix_and_asks_before_overwriting(
    driver: StagedPageDriver, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    chosen = str(tmp_path / "mine")
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (chosen, ""))
    assert driver.page.files.ask_and_save()
    driver.wait_for_files()
    assert driver.library.path == tmp_path / "mine.ppr"
    driver.library.add_pose((1,) * 8, "more")
    cancel = QMessageBox.StandardButton.Cancel
    monkeypatch.setattr(QMessageBox, "question", lambda *_: cancel)
    assert not driver.page.files.ask_and_save()
    assert "more" not in (tmp_path / "mine.ppr").read_text(encoding="utf-8")


def test_pose_with_comma_in_name_is_not_offered_for_steps(
    driver: StagedPageDriver, tmp_path: Path
) -> None:
    path = tmp_path / "comma.ppr"
    path.write_text("Aracna:8\nPose=a, b:512\nPose=c:512\nSeq=s: c|500\n", encoding="utf-8")
    driver.page.files.open_file(path)
    driver.wait_for_files()
    driver.choose_row("aracnaMotions", "s")
    driver.choose_row("aracnaPoses", "a, b")
    assert not driver.button("aracnaAddStep").isEnabled()
    assert "remove comma and bar" in driver.button("aracnaAddStep").toolTip()
    view = driver.steps
    view.edit(view.model().index(0, 1))
    combo = driver.combo("aracnaStepPose")
    assert [combo.itemText(place) for place in range(combo.count())] == ["c"]
    driver.library.rename(ItemKind.POSE, "a, b", "a b")
    driver.choose_row("aracnaPoses", "a b")
    driver.click("aracnaAddStep")
    assert [step.pose_name for step in driver.library.project.sequences[0].steps] == ["c", "a b"]


def test_step_finds_pose_with_blanks_around_its_name(
    driver: StagedPageDriver, tmp_path: Path
) -> None:
    path = tmp_path / "blanks.ppr"
    path.write_text("Aracna:8\nPose= sp :512\nSeq=s: \n", encoding="utf-8")
    driver.page.files.open_file(path)
    driver.wait_for_files()
    driver.choose_row("aracnaMotions", "s")
    driver.choose_row("aracnaPoses", "sp")
    driver.click("aracnaAddStep")
    driver.page.files.save()
    driver.wait_for_files()
    driver.page.files.open_file(path)
    driver.wait_for_files()
    assert "not in the file" not in driver.messages[-1]
    assert (
        driver.library.project.pose(driver.library.project.sequences[0].steps[0].pose_name)
        is not None
    )
