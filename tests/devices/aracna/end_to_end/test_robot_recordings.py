"""Recordings of a robot, also opened without a robot."""

from pathlib import Path

import pytest
from PySide6.QtWidgets import QFileDialog

from tests.devices.aracna import recordings
from tests.support.pages.robot import RobotWindow
from tests.support.program import aracna
from tests.support.window import WidgetDriver
from trex_gui.devices.aracna.views.playback import JointValues, RobotPlaybackWindow


def opened(window: RobotWindow) -> list[RobotPlaybackWindow]:
    return aracna(window.program).workspace.recordings.windows


def test_session_is_recorded_and_opened_from_menu(
    connected_window: RobotWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    window, path = connected_window, tmp_path / "walk.trexrec"
    manager = aracna(window.program).workspace.recordings
    assert window.action("aracna_record").isEnabled()
    manager.record(path)
    assert window.has("aracna_recordIndicator")
    assert "Stop" in window.action("aracna_record").text()
    window.drag("aracnaSlider0", 400)
    window.move()
    present = window.robot.state.present
    window.trigger("aracna_record")
    window.wait_for_text("bannerText", "Recorded to")
    window.wait_for_text("bannerText", "Use Aracna, Open recording to view it.")
    assert path.stat().st_size > 10_000

    window.press_disconnect()
    assert not window.action("aracna_record").isEnabled()

    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(path), ""))
    window.trigger("aracna_open_recording")
    window.wait_for_files()
    [playback] = opened(window)
    window.wait(lambda: playback.playback.is_loaded)
    assert playback.playback.problems == []
    playback.playback.set_position(playback.playback.end)
    joints = WidgetDriver(playback, window.qtbot).find(JointValues, "aracnaRecordedJoints")
    assert joints.model().index(0, 1).data().startswith(f"{present[0]} = ")
    playback.close()
    assert opened(window) == []


def test_open_recording_can_stop_robot_and_closes_with_main_window(
    connected_window: RobotWindow, tmp_path: Path
) -> None:
    window, path = connected_window, tmp_path / "walk.trexrec"
    manager = aracna(window.program).workspace.recordings
    recordings.write(path, list(recordings.session(3)))
    before = path.read_bytes()
    manager.open_file(path)
    window.wait_for_files()
    [playback] = opened(window)
    window.wait(lambda: playback.playback.is_loaded)
    manager.record(path)
    assert "close its window before you overwrite it" in window.text("bannerText")
    assert path.read_bytes() == before

    halted: list[bool] = []
    window.robot.halted.connect(lambda: halted.append(True))
    WidgetDriver(playback, window.qtbot).click("aracnaPlaybackStopButton")
    assert halted == [True]
    window.window.close()
    assert opened(window) == []
