"""Files that are damaged, long, empty or of other robots, in the window of a recording."""

import contextlib
import sqlite3
from pathlib import Path

import pytest
from PySide6.QtWidgets import QCheckBox, QLabel, QListView
from pytestqt.qtbot import QtBot

from tests.devices.aracna.recordings import HEADER, MOTORS, T0, write
from tests.devices.aracna.views.recording_stage import (
    SAMPLE_SESSION,
    RecordingWindowDriver,
    show_recording,
)
from trex_gui.devices.aracna.recording import RobotHeader
from trex_gui.devices.aracna.session.messages import Moved


def test_damaged_recording_reports_problem_and_shows_rest(tmp_path: Path, qtbot: QtBot) -> None:
    path = tmp_path / "damaged.trexrec"
    write(path, SAMPLE_SESSION)
    with contextlib.closing(sqlite3.connect(path)) as database:
        database.execute("UPDATE goals SET motor_0_goal_units = 'oo'")
        database.execute("DELETE FROM header WHERE key = 'ended_utc_s'")
        database.commit()
    window = RecordingWindowDriver(path, qtbot)
    window.show()
    window.wait_until_loaded()
    text = window.text("bannerText")
    assert "This recording is not complete." in text
    assert "It was not ended" in text
    assert "Record 3 cannot be read: motor_0_goal_units is not INTEGER." in text
    window.playback.set_position(window.playback.end)
    assert window.text("aracnaRecordedPresent0") == "201 = 58.9°"
    window.close()


def test_curve_hidden_while_loading_stays_hidden(tmp_path: Path, qtbot: QtBot) -> None:
    path = tmp_path / "walk.trexrec"
    write(path, SAMPLE_SESSION)
    window = RecordingWindowDriver(path, qtbot)
    window.find(QCheckBox, "aracnaCurveBox2").setChecked(False)
    window.wait_until_loaded()
    plot = window.plot
    window.wait(lambda: plot.source is window.playback.traces)
    assert "motor_2" not in plot.shown
    assert len(plot.shown) == MOTORS - 1
    window.close()


@pytest.mark.parametrize("motors", [2, 18])
def test_recording_with_other_motor_count_is_shown(
    tmp_path: Path, qtbot: QtBot, motors: int
) -> None:
    header = RobotHeader(HEADER.started, T0, version=0, motors=motors)
    goals = (300,) * motors
    moved = Moved(T0 + 1, goals, goals, 1.0)
    window = show_recording(tmp_path / "a.trexrec", qtbot, [moved], header)
    window.playback.set_position(T0 + 1)
    assert window.text(f"aracnaRecordedPresent{motors - 1}") == "300 = 88.0°"
    names = [label.objectName() for label in window.find_all(QLabel)]
    assert f"aracnaRecordedPresent{motors}" not in names
    assert window.window.height() < 1000
    window.close()


def test_empty_recording_shows_that_it_has_no_events(tmp_path: Path, qtbot: QtBot) -> None:
    window = show_recording(tmp_path / "a.trexrec", qtbot, [])
    events = window.find(QListView, "eventList")
    window.wait(lambda: "no events" in events.accessibleDescription())
    assert not window.is_enabled("playButton")
    window.close()
