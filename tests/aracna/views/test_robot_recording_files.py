"""Files that are damaged, long, empty or of other robots, in the window of a recording."""

from pathlib import Path

import pytest
from PySide6.QtCore import QThread
from PySide6.QtWidgets import QCheckBox, QLabel, QListView, QProgressBar, QPushButton
from pytestqt.qtbot import QtBot
from shiboken6 import isValid

from tests.aracna.recordings import HEADER, MOTORS, T0, hang, session, write
from tests.aracna.views.recording_stage import PATIENCE, STORY, click, find, opened, text
from trex_gui.aracna.link.messages import Moved
from trex_gui.aracna.model.playback import RobotPlayback
from trex_gui.aracna.model.robot import Robot
from trex_gui.aracna.recording import Header
from trex_gui.aracna.views.recording.window import RobotPlaybackWindow
from trex_gui.views.traces.plot import TracePlot


def test_a_damaged_recording_says_which_line_and_shows_the_rest(
    tmp_path: Path, qtbot: QtBot
) -> None:
    path = tmp_path / "cut.csv"
    write(path, STORY)
    path.write_bytes(path.read_bytes()[:-10].replace(b",goals,200,", b",goals,2oo,"))
    window = RobotPlaybackWindow(RobotPlayback.open(path), Robot())
    qtbot.addWidget(window)
    window.show()
    qtbot.waitUntil(lambda: window.playback.is_loaded, timeout=PATIENCE)
    said = text(window, "bannerText")
    assert "This recording is not whole." in said
    assert "Line 5 cannot be understood: '2oo' is no number of the robot." in said
    assert "Line 9, the last one, is cut off." in said
    window.playback.set_position(window.playback.end)
    assert text(window, "aracnaRecordedPresent0") == "201 = 58.9°"
    window.close()


def test_while_it_is_read_it_says_how_far_and_can_be_cancelled(
    tmp_path: Path, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    hang(monkeypatch)
    path = tmp_path / "long.csv"
    write(path, list(session(60)))
    window = RobotPlaybackWindow(RobotPlayback.open(path), Robot())
    window.show()
    bar = find(window, QProgressBar, "recordingProgress")
    qtbot.waitUntil(lambda: bar.value() > 0, timeout=PATIENCE)
    assert bar.isVisible()
    assert bar.text().startswith("Reading, ")
    assert not window.playback.is_loaded
    (thread,) = window.playback.findChildren(QThread)
    with qtbot.waitSignal(window.closed, timeout=PATIENCE):
        click(window, qtbot, "cancelRecordingButton")
    qtbot.waitUntil(lambda: not isValid(thread) or thread.isFinished(), timeout=PATIENCE)
    assert not window.playback.is_loaded


def test_a_curve_that_was_taken_away_while_it_is_read_stays_away(
    tmp_path: Path, qtbot: QtBot
) -> None:
    path = tmp_path / "walk.csv"
    write(path, STORY)
    window = RobotPlaybackWindow(RobotPlayback.open(path), Robot())
    qtbot.addWidget(window)
    find(window, QCheckBox, "aracnaCurveBox2").setChecked(False)
    qtbot.waitUntil(lambda: window.playback.is_loaded, timeout=PATIENCE)
    plot = window.findChild(TracePlot)
    assert plot is not None
    qtbot.waitUntil(lambda: plot.source is window.playback.traces, timeout=PATIENCE)
    assert "motor_2" not in plot.shown
    assert len(plot.shown) == MOTORS - 1
    window.close()


@pytest.mark.parametrize("motors", [2, 18])
def test_a_robot_with_other_motors_is_shown_as_well(
    tmp_path: Path, qtbot: QtBot, motors: int
) -> None:
    header = Header(HEADER.started, T0, version=0, motors=motors)
    goals = (300,) * motors
    moved = Moved(T0 + 1, goals, goals, 1.0)
    window = opened(tmp_path / "a.csv", qtbot, [moved], header)
    window.playback.set_position(T0 + 1)
    assert text(window, f"aracnaRecordedPresent{motors - 1}") == "300 = 88.0°"
    assert window.findChild(QLabel, f"aracnaRecordedPresent{motors}") is None
    assert window.height() < 1000
    window.close()


def test_a_recording_in_which_nothing_happened_says_so(tmp_path: Path, qtbot: QtBot) -> None:
    window = opened(tmp_path / "a.csv", qtbot, [])
    events = find(window, QListView, "eventList")
    qtbot.waitUntil(lambda: "Nothing happened" in events.accessibleDescription(), timeout=PATIENCE)
    assert not find(window, QPushButton, "playButton").isEnabled()
    window.close()
