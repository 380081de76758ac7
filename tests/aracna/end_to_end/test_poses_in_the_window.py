"""Poses are captured, gaits are played and the session is recorded, with a robot connected."""

import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QItemSelectionModel, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLineEdit, QListView, QPushButton, QTabWidget, QWidget
from pytestqt.qtbot import QtBot

from tests.aracna.end_to_end.person import Person
from trex_gui.aracna.link.messages import Moving
from trex_gui.model.connection import Link
from trex_gui.runtime import now
from trex_gui.system.stopper import Stopper
from trex_gui.watching import Watching
from trex_gui.window import Program

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")


@pytest.fixture
def person(program: Program, qtbot: QtBot) -> Iterator[Person]:
    person = Person(program, qtbot)
    person.connect_to_demo()
    yield person
    program.library.new()  # else the window asks whether to save when it closes


def open_poses(person: Person) -> None:
    person.action("aracna_page1").trigger()
    assert person.find(QTabWidget, "aracnaTabs").currentIndex() == 1


def choose(person: Person, list_name: str, text: str) -> None:
    """Click on a row of a list."""
    view = person.find(QListView, list_name)
    model = view.model()
    rows = [model.index(row, 0) for row in range(model.rowCount())]
    index = next(each for each in rows if str(each.data()).startswith(text))
    view.scrollTo(index)
    view.selectionModel().setCurrentIndex(index, QItemSelectionModel.SelectionFlag.ClearAndSelect)


def test_a_pose_is_captured_named_and_gone_to(person: Person, tmp_path: Path) -> None:
    open_poses(person)
    assert not person.find(QPushButton, "aracnaCapture").isEnabled(), "nobody knows where it is"
    person.action("aracna_page0").trigger()
    person.drag("aracnaSlider0", 300)
    person.move_and_wait()
    there = person.robot.present

    person.action("aracna_capture").trigger()
    view = person.find(QListView, "aracnaPoses")
    editor = view.findChild(QLineEdit)
    assert editor is not None
    editor.selectAll()
    QTest.keyClicks(editor, "wave")
    QTest.keyClick(editor, Qt.Key.Key_Return)
    person.wait(lambda: person.program.library.pose("wave") is not None)
    pose = person.program.library.pose("wave")
    assert pose is not None
    assert pose.positions == there

    person.action("aracna_page0").trigger()
    person.click("aracnaCentreButton")
    person.move_and_wait()
    assert person.robot.present != there
    open_poses(person)
    choose(person, "aracnaPoses", "wave")
    person.click("aracnaGoTo")
    person.wait(lambda: person.robot.known.moved is not None and person.robot.known.goals == there)
    person.program.library.save(tmp_path / "mine.ppr")
    assert "Pose=wave:" in (tmp_path / "mine.ppr").read_text(encoding="utf-8")


def test_a_pose_beyond_the_limits_goes_as_far_as_they_let_it(person: Person) -> None:
    person.move_and_wait()
    open_poses(person)
    choose(person, "aracnaPoses", "stand")
    person.click("aracnaGoTo")
    person.wait(lambda: person.robot.known.goals == (512, 550) * 4)
    assert "instead of 680" in person.text("bannerText")


def test_a_gait_plays_and_stops(person: Person) -> None:
    person.move_and_wait()
    open_poses(person)
    choose(person, "aracnaMotions", "push-ups")
    person.click("aracnaLoop")
    person.action("aracna_play").trigger()
    person.wait(lambda: person.robot.playing is not None)
    person.wait(lambda: person.robot.playing is not None and person.robot.playing.step == 1)
    assert "Playing" in person.text("aracnaMotionLabel")
    assert not person.find(QPushButton, "aracnaPlay").isEnabled()
    sent: list[object] = []
    person.robot.reported.connect(sent.append)
    QTest.keyClick(person.program.window, Qt.Key.Key_Escape)
    stopped = now()  # what was sent before may be told later
    person.wait(lambda: person.robot.playing is None and person.robot.known.moving is None)
    motions = [report for report in sent if isinstance(report, Moving)]
    assert len([motion for motion in motions if motion.time > stopped]) <= 1
    assert person.find(QPushButton, "aracnaPlay").isEnabled()


def test_what_the_robot_does_is_recorded(person: Person, tmp_path: Path) -> None:
    path = tmp_path / "walk.csv"
    assert person.action("aracna_record").isEnabled()
    person.program.aracna.recordings.record(path)
    assert person.find(QWidget, "aracna_recordIndicator").isVisible()
    assert "Stop" in person.action("aracna_record").text()
    person.move_and_wait()
    person.action("aracna_record").trigger()
    person.wait(lambda: "Recorded in" in person.text("bannerText"))
    assert len(path.read_text(encoding="utf-8").splitlines()) > 3


def test_nothing_is_recorded_without_a_robot(person: Person, tmp_path: Path) -> None:
    person.click("connectButton")
    person.wait(lambda: person.robot.link is Link.NONE)
    assert not person.action("aracna_record").isEnabled()
    person.program.aracna.recordings.record(tmp_path / "walk.csv")
    assert "no robot is connected" in person.text("bannerText")
    assert not (tmp_path / "walk.csv").exists()


def test_a_locked_screen_ends_what_is_played(person: Person, qapp: QApplication) -> None:
    person.move_and_wait()
    watching = Watching(person.program, qapp)
    open_poses(person)
    choose(person, "aracnaMotions", "push-ups")
    person.click("aracnaLoop")
    person.click("aracnaPlay")
    person.wait(lambda: person.robot.playing is not None and person.robot.playing.step == 1)
    stopper = watching.findChild(Stopper)
    assert stopper is not None
    stopper.stop("The screen was locked")
    person.wait(lambda: person.robot.playing is None)
    person.wait(lambda: "The screen was locked." in person.text("bannerText"))
    watching.close()
    watching.deleteLater()
