"""Poses page with a library: poses, sequences and files."""

from collections.abc import Iterator, Sequence
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractItemView,
    QCheckBox,
    QFileDialog,
    QLineEdit,
    QMessageBox,
    QSpinBox,
    QWidget,
)
from pytestqt.qtbot import QtBot

from tests.support.pages.settings import answer_questions
from tests.support.slow_disk import SlowDisk
from tests.support.window import LEFT, WidgetDriver
from trex_gui.devices.aracna.model.library import ItemKind, Library
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.poses.project import SequenceStep
from trex_gui.devices.aracna.session.messages import Play, Step, StepStarted, Stuck
from trex_gui.devices.aracna.views.poses.name_list import NameList
from trex_gui.devices.aracna.views.poses.page import PosesPage
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.widgets import file_questions
from trex_gui.ui.widgets.labels import ElidedLabel

EIGHT = (100, 200, 101, 201, 102, 202, 103, 203)


class ScriptedRobot(Robot):
    """Robot that records requests. Tests set its state.

    Attributes:
        plays, goals, scales: recorded requests, in order.
    """

    def __init__(self) -> None:
        super().__init__()
        self.plays: list[Play] = []
        self.goals: list[tuple[int, ...]] = []
        self.scales: list[float] = []

    def play(self, play: Play) -> bool:
        self.plays.append(play)
        return True

    def move(self, goals: Sequence[int]) -> bool:
        self.goals.append(tuple(goals))
        return True

    def set_time_scale(self, factor: float) -> None:
        self.scales.append(factor)


class PosesPageDriver(WidgetDriver):
    """Driver of the page, with a library and a scripted robot.

    Attributes:
        messages: information and errors for the user, in order.
    """

    def __init__(self, qtbot: QtBot) -> None:
        self.library = Library()
        self.robot = ScriptedRobot()
        self.page = PosesPage(self.robot, self.library)
        self.robot.setParent(self.page)
        super().__init__(self.page, qtbot)
        self.messages: list[str] = []
        self.robot.notifier.info.connect(self.messages.append)
        self.robot.notifier.error.connect(self.messages.append)
        self.page.resize(800, 600)
        self.page.show()
        qtbot.waitExposed(self.page)

    def spin(self, name: str) -> QSpinBox:
        return self.find(QSpinBox, name)

    def check(self, name: str, on: bool) -> None:
        self.find(QCheckBox, name).setChecked(on)

    def names(self, name: str) -> NameList:
        return self.find(NameList, name)

    @property
    def steps(self) -> QAbstractItemView:
        return self.find(QAbstractItemView, "aracnaSteps")

    @property
    def file(self) -> str:
        """File name in the heading of the page."""
        return self.find_all(ElidedLabel)[-1].text()

    @property
    def summary(self) -> str:
        return self.text("aracnaPlaySummary")

    def select_row(self, list_name: str, text: str) -> None:
        view = self.names(list_name)
        (item,) = view.findItems(text, Qt.MatchFlag.MatchExactly)
        view.scrollToItem(item)
        QTest.mouseClick(view.viewport(), LEFT, pos=view.visualItemRect(item).center())
        assert view.currentItem() == item

    def type_name(self, list_name: str, name: str) -> None:
        """Type into the open editor of a list."""
        row = WidgetDriver(self.names(list_name), self.qtbot)
        editor = row.find_only(QLineEdit)
        editor.setText(name)
        QTest.keyClick(editor, Qt.Key.Key_Return)
        self.wait(lambda: not row.find_all(QLineEdit))  # Qt closes the editor later

    def open_file(self, path: Path) -> None:
        self.page.files.open_file(path)
        self.wait_for_files()

    def save_to(self, path: Path) -> None:
        self.page.files.save_to(path)
        self.wait_for_files()

    def pose_names(self) -> list[str]:
        return [pose.name for pose in self.library.project.poses]

    def connect(self) -> None:
        self.robot.link = ConnectionState.CONNECTED
        self.robot.changed.emit()

    def show_present(self, *present: int | None) -> None:
        self.robot.state.present = present
        self.robot.changed.emit()

    def show_playing(self, play: Play | None, step: StepStarted | None = None) -> None:
        self.robot.state.play, self.robot.state.step = play, step
        self.robot.changed.emit()


@pytest.fixture
def driver(qtbot: QtBot) -> Iterator[PosesPageDriver]:
    driver = PosesPageDriver(qtbot)
    yield driver
    driver.page.close()
    driver.page.deleteLater()


# --- Poses ----------------------------------------------------------------------------------


def test_positions_are_captured_and_named_once_they_are_known(driver: PosesPageDriver) -> None:
    before = driver.pose_names()
    assert not driver.button("aracnaCapture").isEnabled()
    driver.show_present(None, *EIGHT[1:])
    assert not driver.button("aracnaCapture").isEnabled()
    assert "until its first move" in driver.button("aracnaCapture").toolTip()
    driver.page.capture()
    assert driver.pose_names() == before
    assert "until its first move" in driver.messages[-1]
    driver.show_present(*EIGHT)
    driver.click("aracnaCapture")
    driver.type_name("aracnaPoses", "mine")
    driver.page.capture()
    driver.type_name("aracnaPoses", "here")
    assert driver.pose_names() == [*before, "mine", "here"]
    assert driver.library.project.poses[-1].positions == EIGHT


def test_pose_is_set_to_position_of_robot(driver: PosesPageDriver) -> None:
    driver.select_row("aracnaPoses", "stand")
    assert not driver.button("aracnaSetPosition").isEnabled()
    driver.show_present(*EIGHT)
    driver.click("aracnaSetPosition")
    pose = driver.library.project.pose("stand")
    assert pose is not None
    assert pose.positions == EIGHT


def test_keys_rename_and_delete_pose(driver: PosesPageDriver) -> None:
    driver.select_row("aracnaPoses", "flat")
    view = driver.names("aracnaPoses")
    QTest.keyClick(view, Qt.Key.Key_F2)
    driver.type_name("aracnaPoses", "stand")
    assert driver.pose_names()[0] == "flat"
    assert "stand is taken" in driver.messages[-1]
    assert view.currentIndex().data() == "flat"
    QTest.keyClick(view, Qt.Key.Key_F2)
    driver.type_name("aracnaPoses", "low")
    assert driver.pose_names()[0] == "low"

    QTest.keyClick(view, Qt.Key.Key_Delete)
    assert "low" not in driver.pose_names()
    assert view.currentIndex().data() == "half-stand"
    driver.select_row("aracnaPoses", "self-test b")
    QTest.keyClick(view, Qt.Key.Key_Delete)
    assert view.currentIndex().data() == "self-test a"


def test_pose_is_moved_with_alt_arrow_keys(driver: PosesPageDriver) -> None:
    driver.select_row("aracnaPoses", "flat")
    view = driver.names("aracnaPoses")
    for _ in range(2):
        QTest.keyClick(view, Qt.Key.Key_Down, Qt.KeyboardModifier.AltModifier)
    assert driver.pose_names()[:3] == ["half-stand", "stand", "flat"]
    assert view.currentIndex().data() == "flat"
    QTest.keyClick(view, Qt.Key.Key_Up, Qt.KeyboardModifier.AltModifier)
    assert driver.pose_names()[:3] == ["half-stand", "flat", "stand"]


def test_go_to_requests_positions_when_robot_is_connected(driver: PosesPageDriver) -> None:
    driver.select_row("aracnaPoses", "stand")
    assert not driver.button("aracnaGoTo").isEnabled()
    driver.connect()
    driver.click("aracnaGoTo")
    assert driver.robot.goals == [(512, 550) * 4]


def test_position_field_edits_pose_and_shows_clamped_value(driver: PosesPageDriver) -> None:
    driver.library.set_positions("stand", (512, 680) * 4)
    driver.select_row("aracnaPoses", "stand")
    field = driver.spin("aracnaPosition3")
    assert field.value() == 680
    assert "sent as 550" in field.toolTip()
    field.setValue(400)
    pose = driver.library.project.pose("stand")
    assert pose is not None
    assert pose.positions == (512, 680, 512, 400, 512, 680, 512, 680)
    assert "sent as" not in field.toolTip()


# --- Sequences ------------------------------------------------------------------------------


def test_add_step_appends_selected_pose_to_new_sequence(driver: PosesPageDriver) -> None:
    driver.click("aracnaNewSequence")
    driver.type_name("aracnaMotions", "bob")
    driver.select_row("aracnaPoses", "stand")
    driver.click("aracnaAddStep")
    driver.select_row("aracnaPoses", "half-stand")
    driver.click("aracnaAddStep")
    sequence = driver.library.project.sequence("bob")
    assert sequence is not None
    assert sequence.steps == (SequenceStep("stand", 500), SequenceStep("half-stand", 500))
    driver.click("aracnaStepUp")
    assert driver.library.project.sequences[0].steps[0].pose_name == "half-stand"
    driver.click("aracnaRemoveStep")
    assert [step.pose_name for step in driver.library.project.sequences[0].steps] == ["stand"]


def test_step_pose_and_time_are_edited_in_table(driver: PosesPageDriver, qtbot: QtBot) -> None:
    driver.library.add_sequence("bob", [SequenceStep("gone", 500)])
    driver.select_row("aracnaMotions", "bob")
    view = driver.steps
    view.setCurrentIndex(view.model().index(0, 1))
    view.edit(view.currentIndex())
    combo = driver.combo("aracnaStepPose")
    assert combo.currentText() == "gone"
    combo.setCurrentText("stand")
    combo.activated.emit(combo.currentIndex())
    assert driver.library.project.sequences[0].steps == (SequenceStep("stand", 500),)
    view.setCurrentIndex(view.model().index(0, 2))
    view.edit(view.currentIndex())
    spin = driver.spin("aracnaStepTime")
    spin.setValue(5000)
    QTest.keyClick(spin, Qt.Key.Key_Return)
    changed = (SequenceStep("stand", 5000),)
    qtbot.waitUntil(lambda: driver.library.project.sequences[0].steps == changed)


def test_play_requests_clamped_steps_with_selected_options(driver: PosesPageDriver) -> None:
    driver.library.set_positions("flat", (770, 40) * 4)
    driver.library.add_sequence("up", [SequenceStep("flat", 3000), SequenceStep("stand", 2000)])
    driver.connect()
    driver.show_present(*(300,) * 8)
    driver.select_row("aracnaMotions", "up")
    driver.spin("aracnaRounds").setValue(3)
    driver.spin("aracnaSpeedScale").setValue(50)
    driver.check("aracnaBlendOut", True)
    driver.click("aracnaPlay")
    flat, stand = (600, 40) * 4, (512, 550) * 4
    assert driver.robot.plays == [
        Play(
            0,
            (Step(flat, 3.0, "flat"), Step(stand, 2.0, "stand")),
            rounds=3,
            blend_in=(Step(flat, 3.0, "flat"),),
            blend_out=(Step(stand, 3.0, "stand"),),
            time_scale=2.0,
        )
    ]
    assert driver.summary.startswith("2 steps, 10.0 s per round, 30.0 s in total.")
    assert "clamped" in driver.summary


def test_loop_without_blending_plays_only_steps_endlessly(driver: PosesPageDriver) -> None:
    driver.connect()
    driver.select_row("aracnaMotions", "push-ups (built in)")
    driver.spin("aracnaRounds").setValue(0)
    assert driver.spin("aracnaRounds").text() == "repeating"
    driver.check("aracnaBlendIn", False)
    driver.click("aracnaPlay")
    assert driver.robot.plays[0].rounds == 0
    assert driver.robot.plays[0].blend_in == driver.robot.plays[0].blend_out == ()


def test_late_motors_are_named_at_their_step(driver: PosesPageDriver) -> None:
    driver.library.add_sequence("hasty", [SequenceStep("flat", 3000), SequenceStep("stand", 100)])
    driver.select_row("aracnaMotions", "hasty")
    assert "too slow" in driver.summary
    remark = driver.steps.model().index(1, 3).data()
    assert remark.startswith("needs 0.26 s (motor 1, 3, 5, 7")
    driver.spin("aracnaSpeedScale").setValue(30)
    assert "too slow" not in driver.summary


def test_sequence_is_playable_only_with_all_poses_defined(driver: PosesPageDriver) -> None:
    driver.connect()
    driver.library.add_sequence("gait", [SequenceStep("p1", 500)])
    driver.select_row("aracnaMotions", "gait")
    assert not driver.button("aracnaPlay").isEnabled()
    assert "p1" in driver.summary
    assert driver.steps.model().index(0, 3).data() == "not defined"
    driver.library.add_pose(EIGHT, "p1")
    assert driver.button("aracnaPlay").isEnabled()


def test_during_playback_step_is_marked_and_only_speed_can_change(driver: PosesPageDriver) -> None:
    driver.select_row("aracnaMotions", "push-ups (built in)")
    driver.page.play()
    assert driver.robot.plays == [], "no robot is connected"
    driver.connect()
    driver.page.play()
    driver.show_playing(driver.robot.plays[0], StepStarted(0.0, "steps", 1, 0, 0.0))
    driver.page.play()
    assert len(driver.robot.plays) == 1
    assert not driver.button("aracnaPlay").isEnabled()
    assert not driver.button("aracnaGoTo").isEnabled()
    assert driver.steps.model().index(1, 0).data() == "▶ 2"
    driver.spin("aracnaSpeedScale").setValue(200)
    assert driver.robot.scales == [0.5]
    assert "is playing" in driver.button("aracnaGoTo").toolTip()
    driver.show_playing(None)
    assert driver.steps.model().index(1, 0).data() == "2"
    assert driver.button("aracnaPlay").isEnabled()


def test_disabled_buttons_show_reason_in_tooltip(driver: PosesPageDriver) -> None:
    driver.select_row("aracnaPoses", "stand")
    driver.robot.state.stuck = Stuck(0.0, 3)
    driver.connect()
    for name in ("aracnaPlay", "aracnaGoTo"):
        assert not driver.button(name).isEnabled()
        assert driver.button(name).toolTip().startswith("The robot is waiting for motor 3")


def test_duplicated_gait_becomes_editable_sequence(driver: PosesPageDriver) -> None:
    driver.select_row("aracnaMotions", "star 6 (built in)")
    assert not driver.button("aracnaDeleteSequence").isEnabled()
    assert not driver.names("aracnaMotions").currentIndex().flags() & Qt.ItemFlag.ItemIsEditable
    assert not driver.steps.model().index(0, 2).flags() & Qt.ItemFlag.ItemIsEditable
    driver.click("aracnaDuplicateSequence")
    assert [sequence.name for sequence in driver.library.project.sequences] == ["star 6"]
    assert driver.button("aracnaAddStep").isEnabled()


def test_page_survives_deletion_of_library(driver: PosesPageDriver, qtbot: QtBot) -> None:
    driver.library.add_pose(EIGHT)
    with qtbot.waitSignal(driver.library.destroyed):
        driver.library.deleteLater()
    assert driver.page.isVisible()


def test_play_uses_typed_values_before_enter(driver: PosesPageDriver, qtbot: QtBot) -> None:
    driver.library.add_sequence("bob", [SequenceStep("stand", 500)])
    driver.select_row("aracnaMotions", "bob")
    driver.connect()
    driver.show_present(*(512,) * 8)
    driver.check("aracnaBlendIn", False)
    driver.page.activateWindow()
    view = driver.steps
    view.setCurrentIndex(view.model().index(0, 2))
    view.edit(view.currentIndex())
    time = driver.spin("aracnaStepTime")
    qtbot.waitUntil(time.hasFocus, timeout=15_000)
    time.selectAll()
    QTest.keyClicks(time, "1200")
    driver.page.play()
    assert driver.robot.plays[-1].steps[0].seconds == 1.2

    rounds = driver.spin("aracnaRounds")
    rounds.setFocus()
    qtbot.waitUntil(rounds.hasFocus, timeout=15_000)
    rounds.selectAll()
    QTest.keyClicks(rounds, "7")
    driver.page.play()
    assert driver.robot.plays[-1].rounds == 7


# --- Files ----------------------------------------------------------------------------------


def answer_prompt(monkeypatch: pytest.MonkeyPatch, answer: file_questions.SaveAnswer) -> list[str]:
    """Answer each prompt about unsaved edits. Return the list of file names in the prompts."""
    names: list[str] = []

    def prompt_about_changes(_window: QWidget, name: str) -> file_questions.SaveAnswer:
        names.append(name)
        return answer

    monkeypatch.setattr(file_questions, "prompt_about_changes", prompt_about_changes)
    return names


def test_file_is_saved_and_reopened_and_folder_remembered(
    driver: PosesPageDriver, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path, entered = tmp_path / "mine.ppr", str(tmp_path / "mine")
    driver.library.add_pose(EIGHT, "mine")
    assert driver.file == "poses.ppr, changed"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (entered, ""))
    assert driver.page.files.prompt_and_save()
    driver.wait_for_files()
    assert driver.file == str(path)
    driver.page.files.new()
    assert "mine" not in driver.pose_names()
    driver.open_file(path)
    assert "mine" in driver.pose_names()
    assert "was opened" in driver.messages[-1]
    assert file_questions.last_folder("aracna/folder") == tmp_path


def test_open_asks_about_unsaved_edits(
    driver: PosesPageDriver, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "other.ppr"
    path.write_text("Aracna:8\nPose=only:1\n", encoding="utf-8")
    driver.library.add_pose(EIGHT, "mine")
    names = answer_prompt(monkeypatch, file_questions.SaveAnswer.CANCEL)
    driver.open_file(path)
    assert names == ["poses.ppr"]
    assert "mine" in driver.pose_names()
    answer_prompt(monkeypatch, file_questions.SaveAnswer.DISCARD)
    driver.open_file(path)
    assert driver.pose_names() == ["only"]


def test_save_asks_before_overwriting_external_change(
    driver: PosesPageDriver, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "mine.ppr"
    driver.save_to(path)
    path.write_text("Aracna:8\n", encoding="utf-8")
    answer_questions(monkeypatch, QMessageBox.StandardButton.Cancel)
    driver.page.files.save()
    driver.wait_for_files()
    assert path.read_text(encoding="utf-8") == "Aracna:8\n"


def test_unreadable_or_unwritable_file_is_reported(driver: PosesPageDriver, tmp_path: Path) -> None:
    driver.open_file(tmp_path / "none.ppr")
    assert "no such file" in driver.messages[-1]
    driver.save_to(tmp_path / "gone" / "a.ppr")
    assert driver.messages[-1].startswith("Not saved.")


def test_slow_disk_loses_no_edits(
    driver: PosesPageDriver, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path, other = tmp_path / "mine.ppr", tmp_path / "other.ppr"
    other.write_text("Aracna:8\nPose=only:1\n", encoding="utf-8")
    disk = SlowDisk(monkeypatch)
    driver.library.add_pose(EIGHT, "mine")
    driver.page.files.save_to(path)
    driver.library.add_pose(EIGHT, "later")
    driver.wait_for_files()
    assert driver.file == f"{path}, changed"
    answer_prompt(monkeypatch, file_questions.SaveAnswer.SAVE)
    driver.page.files.open_file(other)
    assert "mine" in driver.pose_names()
    driver.wait_for_files()
    assert "Pose=later:" in path.read_text(encoding="utf-8")
    assert driver.pose_names() == ["only"]
    assert disk.stalls == []


def test_second_save_writes_its_own_file(
    driver: PosesPageDriver, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "mine.ppr"
    questions = answer_questions(monkeypatch, QMessageBox.StandardButton.Yes)
    driver.library.add_pose(EIGHT, "mine")
    driver.save_to(path)
    SlowDisk(monkeypatch)
    driver.page.files.save()
    driver.library.add_pose(EIGHT, "later")
    driver.page.files.save()
    driver.page.files.new()
    driver.wait_for_files()
    assert [text.split(".ppr ")[1].split(".")[0] for text in questions] == ["is still being saved"]
    assert "Pose=later:" in path.read_text(encoding="utf-8")
    assert driver.library.path is None


def test_only_first_findings_of_invalid_file_are_reported(
    driver: PosesPageDriver, tmp_path: Path
) -> None:
    path = tmp_path / "novel.ppr"
    path.write_text("It was a dark night\n" * 1000, encoding="utf-8")
    driver.open_file(path)
    assert "And 992 more." in driver.messages[-1]
    assert len(driver.messages[-1].splitlines()) == 10


@pytest.mark.parametrize(
    ("name", "renamed"), [("a, b", "a b"), ("sp", "")], ids=["comma", "blanks around it"]
)
def test_new_step_uses_a_valid_pose_name(
    driver: PosesPageDriver, tmp_path: Path, name: str, renamed: str
) -> None:
    path = tmp_path / "names.ppr"
    lines = f"Aracna:8\nPose= {name} :512\nPose=c:512\nSeq=s: c|500\n"
    path.write_text(lines, encoding="utf-8")
    driver.open_file(path)
    driver.select_row("aracnaMotions", "s")
    driver.select_row("aracnaPoses", name)
    if renamed:
        assert not driver.button("aracnaAddStep").isEnabled()
        assert "remove commas and vertical bars" in driver.button("aracnaAddStep").toolTip()
        view = driver.steps
        view.edit(view.model().index(0, 1))
        combo = driver.combo("aracnaStepPose")
        assert [combo.itemText(index) for index in range(combo.count())] == ["c"]
        driver.library.rename(ItemKind.POSE, name, renamed)
        driver.select_row("aracnaPoses", renamed)
    driver.click("aracnaAddStep")
    driver.page.files.save()
    driver.wait_for_files()
    driver.open_file(path)
    assert "not in the file" not in driver.messages[-1]
    project = driver.library.project
    assert all(project.pose(step.pose_name) for step in project.sequences[0].steps)
    assert len(project.sequences[0].steps) == 2
