"""A person records the robot, opens the recording from the menu or drops it, without the robot."""

import sys
from pathlib import Path

import pytest
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QThread, QUrl
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QFileDialog, QLabel, QPushButton
from pytestqt.qtbot import QtBot
from shiboken6 import isValid

from tests.aracna import recordings
from tests.aracna.end_to_end.person import DEMO_TREX, Person
from tests.recording import samples
from trex_gui.aracna.views.recording.window import RobotPlaybackWindow
from trex_gui.model.connection import Link
from trex_gui.window import Program

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")


@pytest.fixture
def person(program: Program, qtbot: QtBot) -> Person:
    return Person(program, qtbot)


@pytest.fixture
def at_the_desk(person: Person, qtbot: QtBot) -> Person:
    """A person who sees the robot's pages without a robot."""
    person.connect_to_demo()
    person.click("connectButton")
    person.wait(lambda: person.robot.link is Link.NONE)
    return person


def windows(person: Person) -> list[RobotPlaybackWindow]:
    return person.program.aracna.recordings.windows


def drop(person: Person, path: Path) -> None:
    """Drag a file onto the window and let go."""
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(path))])
    copy = Qt.DropAction.CopyAction
    left, none = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    enter = QDragEnterEvent(QPoint(9, 9), copy, data, left, none)
    QApplication.sendEvent(person.program.window, enter)
    assert enter.isAccepted()
    QApplication.sendEvent(person.program.window, QDropEvent(QPointF(9, 9), copy, data, left, none))


def close(person: Person) -> None:
    for window in tuple(windows(person)):
        window.close()
    assert windows(person) == []


def test_what_was_recorded_is_opened_from_the_menu_and_says_what_it_did(
    person: Person, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "walk.csv"
    person.connect_to_demo()
    person.program.aracna.recordings.record(path)
    person.drag("aracnaSlider0", 400)
    person.move_and_wait()
    present = person.robot.present
    person.action("aracna_record").trigger()
    person.wait(lambda: "Aracna, Open recording shows it." in person.text("bannerText"))
    person.click("connectButton")
    person.wait(lambda: person.robot.link is Link.NONE)
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(path), ""))
    assert person.action("aracna_open_recording").isEnabled()
    person.action("aracna_open_recording").trigger()
    [window] = windows(person)
    person.wait(lambda: window.playback.is_loaded)
    assert window.playback.problems == []
    window.playback.set_position(window.playback.end)
    label = window.findChild(QLabel, "aracnaRecordedPresent0")
    assert label is not None
    assert label.text().startswith(f"{present[0]} = ")
    person.action("aracna_open_recording").trigger()
    assert windows(person) == [window]
    close(person)


def test_a_recording_that_is_dropped_on_the_robots_pages_opens(
    at_the_desk: Person, tmp_path: Path
) -> None:
    path = tmp_path / "walk.csv"
    recordings.write(path, list(recordings.session(3)))
    drop(at_the_desk, path)
    [window] = windows(at_the_desk)
    at_the_desk.wait(lambda: window.playback.is_loaded)
    assert at_the_desk.program.desk.recordings.windows == []
    close(at_the_desk)


@pytest.mark.parametrize("suffix", [".csv", ".trexrec"])
def test_the_recording_of_a_board_is_told_from_the_robots_and_where_it_opens(
    at_the_desk: Person, tmp_path: Path, suffix: str
) -> None:
    path = tmp_path / f"board{suffix}"
    if suffix == ".csv":
        samples.write_an_hour_of_csv(path, 1)
    else:
        samples.write(path, list(samples.an_hour(1)))
    drop(at_the_desk, path)
    assert windows(at_the_desk) == []
    said = at_the_desk.text("bannerText")
    assert "a recording of another device: TReX 1.2. It opens where" in said
    assert "choose its port or its demo in the list of ports" in said


def test_the_recording_of_a_robot_is_told_from_a_boards_and_where_it_opens(
    person: Person, tmp_path: Path
) -> None:
    path = tmp_path / "walk.csv"
    recordings.write(path, list(recordings.session(3)))
    drop(person, path)
    assert person.program.desk.recordings.windows == []
    assert windows(person) == []
    said = person.text("bannerText")
    assert "a recording of another device: Aracna. It opens where" in said
    assert "choose its port or its demo in the list of ports" in said


def test_the_boards_recordings_open_again_when_its_pages_are_shown(
    at_the_desk: Person, tmp_path: Path
) -> None:
    path = tmp_path / "board.trexrec"
    samples.write(path, list(samples.an_hour(1)))
    at_the_desk.choose_port(DEMO_TREX)
    at_the_desk.wait(lambda: at_the_desk.program.switchboard.current.kind.key == "trex")
    drop(at_the_desk, path)
    [window] = at_the_desk.program.desk.recordings.windows
    at_the_desk.wait(lambda: window.playback.is_loaded)
    window.close()


def test_a_recording_that_is_open_is_not_recorded_over(person: Person, tmp_path: Path) -> None:
    path = tmp_path / "walk.csv"
    recordings.write(path, list(recordings.session(3)))
    before = path.read_bytes()
    person.connect_to_demo()
    person.program.aracna.recordings.open_file(path)
    [window] = windows(person)
    person.wait(lambda: window.playback.is_loaded)
    person.program.aracna.recordings.record(path)
    assert "close its window before recording over it" in person.text("bannerText")
    assert path.read_bytes() == before
    close(person)


def test_the_stop_button_of_the_window_stops_the_robot(person: Person, tmp_path: Path) -> None:
    path = tmp_path / "walk.csv"
    recordings.write(path, list(recordings.session(3)))
    person.connect_to_demo()
    person.program.aracna.recordings.open_file(path)
    [window] = windows(person)
    button = window.findChild(QPushButton, "aracnaPlaybackStopButton")
    assert button is not None
    person.wait(button.isVisible)
    assert button.isEnabled()
    halted: list[bool] = []
    person.robot.halted.connect(lambda: halted.append(True))
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)
    assert halted == [True]
    close(person)


@pytest.mark.realtime
def test_a_program_that_ends_while_a_recording_is_read_ends_its_thread(
    person: Person, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    recordings.hang(monkeypatch)
    path = tmp_path / "long.csv"
    recordings.write(path, list(recordings.session(60)))
    person.program.aracna.recordings.open_file(path)
    [window] = windows(person)
    (thread,) = window.playback.findChildren(QThread)
    person.wait(lambda: window.playback.progress > 0)
    assert thread.isRunning()
    person.wait(person.program.shut_down)
    assert not isValid(thread) or thread.isFinished()


def test_closing_the_window_closes_the_recordings(at_the_desk: Person, tmp_path: Path) -> None:
    path = tmp_path / "walk.csv"
    recordings.write(path, list(recordings.session(3)))
    at_the_desk.program.aracna.recordings.open_file(path)
    assert len(windows(at_the_desk)) == 1
    at_the_desk.program.window.close()
    assert windows(at_the_desk) == []
