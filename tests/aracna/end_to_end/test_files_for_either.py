"""Files that are dropped on the window or named at the start: each goes where it belongs."""

import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import QApplication, QMessageBox
from pytestqt.qtbot import QtBot

from tests.aracna.end_to_end.person import DEMO_TREX, Person
from trex_gui.model.connection import Link
from trex_gui.model.device import Link as BoardLink
from trex_gui.window import Program

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")

POSES = "Test:8:1024:1024:1024:1024:1024:1024:1024:1024\nPose=low:100,100,100,100,100,100,100,100\n"
SETTINGS = "product: TReX\nserial_timeout: 5\n"


class Dropping(Person):
    """A person who drops files on the window."""

    def drop(self, *paths: Path) -> bool:
        """Drag files over the window and let them go; return whether it takes them."""
        window = self.program.window
        data = QMimeData()
        data.setUrls([QUrl.fromLocalFile(str(path)) for path in paths])
        how = (Qt.DropAction.CopyAction, data, Qt.MouseButton.LeftButton)
        key = Qt.KeyboardModifier.NoModifier
        enter = QDragEnterEvent(QPoint(9, 9), *how, key)
        QApplication.sendEvent(window, enter)
        if enter.isAccepted():
            QApplication.sendEvent(window, QDropEvent(QPointF(9, 9), *how, key))
        return enter.isAccepted()

    def shows_robot(self) -> bool:
        return self.program.aracna.isVisible()

    @property
    def poses(self) -> list[str]:
        return [pose.name for pose in self.program.library.poses]

    def connect_to_trex(self) -> None:
        self.choose_port(DEMO_TREX)
        self.wait(lambda: self.program.device.link is BoardLink.UP)

    def wait_for_message(self, part: str) -> None:
        self.wait(lambda: part in self.text("bannerText"))


@pytest.fixture
def person(program: Program, qtbot: QtBot) -> Dropping:
    return Dropping(program, qtbot)


@pytest.fixture
def make(tmp_path: Path) -> Callable[[str, str], Path]:
    def make(name: str, text: str) -> Path:
        path = tmp_path / name
        path.write_text(text, encoding="utf-8")
        return path

    return make


Make = Callable[[str, str], Path]


def test_poses_dropped_while_nothing_is_connected_show_the_robots_desk(
    person: Dropping, make: Make
) -> None:
    assert not person.shows_robot()
    assert person.drop(make("walk.ppr", POSES))
    person.wait(lambda: person.poses == ["low"])
    assert person.shows_robot()
    assert person.program.aracna.pages.currentIndex() == 1
    assert person.text("bannerText") == "walk.ppr was opened."


def test_poses_dropped_on_the_robots_desk_open_there(person: Dropping, make: Make) -> None:
    person.connect_to_demo()
    assert person.drop(make("walk.PPR", POSES))
    person.wait(lambda: person.poses == ["low"])
    assert person.robot.link is Link.UP


def test_poses_dropped_while_a_board_is_connected_are_named_and_nothing_is_interrupted(
    person: Dropping, make: Make
) -> None:
    before = person.poses
    person.connect_to_trex()
    assert person.drop(make("walk.ppr", POSES))
    person.wait_for_message("walk.ppr is a pose file of an Aracna.")
    assert "connected to TReX: disconnect, then drop the file again" in person.text("bannerText")
    assert person.program.device.link is BoardLink.UP
    assert not person.shows_robot()
    assert person.poses == before


def test_settings_dropped_while_a_robot_is_connected_are_named_and_nothing_is_interrupted(
    person: Dropping, make: Make
) -> None:
    person.connect_to_demo()
    assert person.drop(make("rover.txt", SETTINGS))
    person.wait_for_message("rover.txt is a settings file of a TReX.")
    assert person.robot.link is Link.UP
    assert person.shows_robot()
    assert person.program.desk.files.editors == []


def test_settings_dropped_on_the_robots_idle_desk_show_the_boards(
    person: Dropping, make: Make
) -> None:
    person.drop(make("walk.ppr", POSES))
    person.wait(person.shows_robot)
    assert person.drop(make("rover.yaml", SETTINGS))
    person.wait(lambda: len(person.program.desk.files.editors) == 1)
    assert not person.shows_robot()
    person.program.desk.files.close_all()


def test_poses_that_were_not_saved_are_asked_for_before_others_are_opened(
    person: Dropping, make: Make, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[str] = []

    def cancel(*words: object) -> QMessageBox.StandardButton:
        asked.append(str(words[2]))
        return QMessageBox.StandardButton.Cancel

    monkeypatch.setattr(QMessageBox, "question", cancel)
    person.program.library.add_pose([200] * 8, "mine")
    person.drop(make("walk.ppr", POSES))
    person.wait(lambda: bool(asked))
    assert "changes that are not saved" in asked[0]
    assert "mine" in person.poses
    person.program.library.undo.undo()


@pytest.mark.parametrize("name", ["photo.png", "noname"])
def test_a_file_that_nothing_opens_is_answered_with_what_opens(
    person: Dropping, make: Make, name: str
) -> None:
    assert person.drop(make(name, "what"))
    person.wait_for_message(f"{name} was not opened: nothing here opens such files.")
    text = person.text("bannerText")
    assert "a settings file of a TReX (.txt, .yaml, .yml)" in text
    assert "a pose file of an Aracna (.ppr)" in text


def test_several_files_at_once_are_answered_with_a_sentence(person: Dropping, make: Make) -> None:
    assert person.drop(make("a.ppr", POSES), make("b.ppr", POSES))
    person.wait_for_message("2 files were dropped, and none was opened: drop one at a time.")


def test_a_pose_file_named_at_the_start_opens_on_its_desk(person: Dropping, make: Make) -> None:
    person.program.open_named(make("walk.ppr", POSES), connecting=False)
    assert person.poses == ["low"]
    assert person.shows_robot()


def test_a_pose_file_named_with_the_demo_of_the_robot_opens_as_well(
    person: Dropping, make: Make
) -> None:
    person.program.connect_to_demo("aracna")
    person.program.open_named(make("walk.ppr", POSES), connecting=True)
    person.wait(lambda: person.robot.link is Link.UP)
    assert person.poses == ["low"]


def test_a_pose_file_named_with_a_board_is_told_once_that_is_connected(
    person: Dropping, make: Make
) -> None:
    person.program.connect_to_demo("trex")
    person.program.open_named(make("walk.ppr", POSES), connecting=True)
    person.wait(lambda: person.program.device.link is BoardLink.UP)
    person.wait_for_message("walk.ppr is a pose file of an Aracna.")


def test_settings_named_with_the_robot_open_in_a_window_of_their_own(
    person: Dropping, make: Make
) -> None:
    person.program.connect_to_demo("aracna")
    person.program.open_named(make("rover.txt", SETTINGS), connecting=True)
    assert len(person.program.desk.files.editors) == 1
    person.wait(lambda: person.robot.link is Link.UP)
    person.program.desk.files.close_all()
