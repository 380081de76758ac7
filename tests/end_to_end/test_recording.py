"""Recording of sessions, and opening of recordings without a board."""

from functools import partial
from pathlib import Path

import pytest
from PySide6.QtCore import Qt, QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QFileDialog

from tests.devices.trex.recording.samples import read_file
from tests.support.program import trex
from tests.support.window import WidgetDriver, WindowDriver
from trex_gui.ui.playback.manager import RecordIndicator
from trex_gui.ui.widgets.file_questions import remember_folder


def indicator(window: WindowDriver) -> RecordIndicator:
    return window.find(RecordIndicator, "recordIndicator")


def test_session_is_recorded_and_opened_without_a_board(
    connected_window: WindowDriver, tmp_path: Path
) -> None:
    path = tmp_path / "session.trexrec"
    window, recordings = connected_window, trex(connected_window.program).workspace.recordings
    assert not indicator(window).isVisible()
    recordings.record(path)
    window.wait(lambda: "Recording  0:00:" in window.text("recordText"))
    window.wait(lambda: " kB" in window.text("recordText"))
    for page in range(window.window.pages.count()):
        window.window.pages.setCurrentIndex(page)
        assert indicator(window).isVisible()
        assert "Recording" in indicator(window).accessibleName()
    assert window.action("record").text() == "Stop &recording"
    count = window.device.telemetry.samples
    window.wait(lambda: window.device.telemetry.samples > count + 300)
    with window.qtbot.waitSignal(recordings.recorder.ended, timeout=20_000):
        window.click("stopRecordingButton")
    assert not indicator(window).isVisible()
    assert window.action("record").text() == "&Record…"
    assert "Recorded to" in window.text("bannerText")
    window.disconnect()
    assert not window.action("record").isEnabled()
    assert window.action("open_recording").isEnabled()
    recordings.open_file(path)
    window.wait_for_files()
    (opened,) = recordings.windows
    player = WidgetDriver(opened, window.qtbot)
    player.wait(lambda: opened.playback.is_loaded)
    assert opened.playback.problems == []
    assert opened.playback.end > opened.playback.start
    opened.playback.set_position(opened.playback.end)
    assert "µs" in player.text("channel1AtPosition")
    recordings.open_file(path)
    assert recordings.windows == [opened]
    opened.close()
    assert recordings.windows == []


def test_esc_in_file_dialog_stops_motors(connected_window: WindowDriver) -> None:
    window = connected_window
    stops: list[str] = []
    window.device.motors.stop_requested.connect(lambda: stops.append("stop"))
    window.motors.arm()

    def press_esc(attempts: int = 1000) -> None:
        dialog = QApplication.activeModalWidget()
        if attempts and not (isinstance(dialog, QFileDialog) and dialog.isActiveWindow()):
            QTimer.singleShot(10, partial(press_esc, attempts - 1))
            return
        assert dialog is not None
        QTest.keyClick(dialog.windowHandle(), Qt.Key.Key_Escape)
        dialog.close()  # if Esc did not close it, the test would wait forever

    QTimer.singleShot(100, press_esc)
    trex(window.program).workspace.recordings.toggle()
    assert stops == ["stop"]


def test_arming_starts_recording_and_stop_saves_it(
    connected_window: WindowDriver, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    window, motors = connected_window, connected_window.motors
    workspace = trex(window.program).workspace
    recordings, recorder = workspace.recordings, workspace.recordings.recorder
    remember_folder(tmp_path / "any.trexrec", "recording/folder")
    window.trigger("record_with_run")
    window.trigger("run")
    window.wait(lambda: recorder.recording)
    window.trigger("record")  # ends the recording while the motors are armed
    window.wait(lambda: recorder.can_record)
    assert motors.armed
    window.trigger("record_with_run")

    motors.set_speed(1, 40)
    with window.qtbot.waitSignal(recordings.events.ended, timeout=20_000):
        window.press_escape()
        window.wait(lambda: recordings.events.recording)
        window.wait(lambda: not motors.locked_for)
        window.trigger("run")
        assert not recorder.recording, "the option is off"
    (log,) = [entry.text for entry in workspace.log.entries if "were saved" in entry.text]
    assert log.startswith("The seconds around “Stop” were saved")
    assert "were saved" not in window.text("bannerText"), "it would cover a warning"

    def select(*arguments: object) -> tuple[str, str]:
        (saved,) = Path(str(arguments[2])).iterdir()
        return str(saved), ""

    monkeypatch.setattr(QFileDialog, "getOpenFileName", select)
    window.trigger("open_kept")
    window.wait_for_files()
    (opened,) = recordings.windows
    player = WidgetDriver(opened, window.qtbot)
    player.wait(lambda: opened.playback.is_loaded)
    assert opened.playback.problems == []
    copied = tmp_path / "mine.trexrec"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(copied), ""))
    player.click("copyRecordingButton")
    window.wait_for_files()
    assert "mine.trexrec" in player.text("bannerText")
    assert read_file(copied)[2] == []
    opened.close()
    window.trigger("keep_events")
    assert not recordings.events.is_on
