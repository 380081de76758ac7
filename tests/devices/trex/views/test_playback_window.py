"""Window that plays a recording."""

import csv
from pathlib import Path

import pytest
from PySide6.QtCore import QLocale, Qt
from PySide6.QtGui import QAccessible, QAction, QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QComboBox,
    QFileDialog,
    QListView,
    QProgressBar,
    QPushButton,
    QSlider,
    QToolButton,
    QWidget,
)
from pytestqt.qtbot import QtBot

from tests.devices.trex.recording.samples import (
    HEADER,
    drive_records,
    open_recording,
    write,
)
from tests.support.playing import loading
from tests.support.window import WidgetDriver
from trex_gui.core.recording.kinds import Marker
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.playback import Playback
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.recording import Record, SetpointRecord, SettingsSnapshot
from trex_gui.devices.trex.views.playback import PlaybackWindow
from trex_gui.ui.playback.transport import size_text, time_text
from trex_gui.ui.plotting.plot import TracePlot

T0 = HEADER.clock
NEXT_SETTINGS = "product: TReX\ndevice_number: 9\n"


def _records_of_a_minute() -> list[Record]:
    extra: list[Record] = [
        SetpointRecord(T0 + 20.0, 1, Drive.at(-55)),
        SettingsSnapshot(T0 + 30.0, NEXT_SETTINGS),
        Marker(T0 + 30.0, "apply", "Apply: Device Number"),
        Marker(T0 + 45.0, "fault", "Motor 1 fault"),
    ]
    driven = drive_records(60)
    samples = [record for record in driven if not isinstance(record, SetpointRecord | Marker)]
    return sorted([*samples, *extra], key=lambda record: record.time)


class RecordingWindow(WidgetDriver):
    """Playback window and its recording."""

    def __init__(self, window: PlaybackWindow, qtbot: QtBot) -> None:
        super().__init__(window, qtbot)
        self.window = window
        self.playback = window.playback

    @classmethod
    def open(cls, playback: Playback, qtbot: QtBot) -> "RecordingWindow":
        window = cls(PlaybackWindow(playback, Device()), qtbot)
        qtbot.addWidget(window.window)
        window.window.show()
        return window

    @property
    def plot(self) -> TracePlot:
        return self.find_only(TracePlot)

    def is_playing(self) -> bool:
        return self.playback.playing


@pytest.fixture(scope="module")
def minute(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Recording of a minute. No test changes it."""
    path = tmp_path_factory.mktemp("recording") / "minute.trexrec"
    write(path, _records_of_a_minute())
    return path


@pytest.fixture
def window(minute: Path, qtbot: QtBot) -> RecordingWindow:
    window = RecordingWindow.open(loading(Playback(open_recording(minute))), qtbot)
    window.wait(lambda: window.playback.is_loaded)
    return window


def test_values_follow_slider_keys_and_events(window: RecordingWindow) -> None:
    assert "TReX 1.2, recorded" in window.text("recordingHeading")
    assert "0:00:59" in window.text("recordingHeading")
    assert window.window.windowTitle().startswith("minute.trexrec")

    slider = window.find(QSlider, "timeSlider")
    slider.setValue(2500)
    assert window.playback.position == pytest.approx(T0 + 25)
    assert window.text("timeLabel").startswith("0:00:25.0 / ")
    assert window.text("motor1AtPosition").endswith(" A, setpoint −55")
    assert window.text("motor2AtPosition").endswith(", setpoint –")
    assert window.text("channel1AtPosition")[:7] in {"1499 µs", "1500 µs", "1501 µs"}
    assert window.text("channel5AtPosition").startswith("no signal")
    assert "serial commands reach the motors" in window.text("controlAtPosition")
    assert window.plot.cursor_time == window.playback.position

    for key, position in (
        (Qt.Key.Key_End, window.playback.end),
        (Qt.Key.Key_Home, T0),
        (Qt.Key.Key_Right, T0 + 1),
        (Qt.Key.Key_PageUp, T0 + 11),
    ):
        QTest.keyClick(slider, key)
        assert window.playback.position == pytest.approx(position), key

    events = window.find(QListView, "eventList")
    model = events.model()
    rows = [str(model.index(row, 0).data()) for row in range(model.rowCount())]
    assert [row.split("  ")[1] for row in rows] == ["Apply: Device Number", "Motor 1 fault"]
    events.setFocus()
    events.setCurrentIndex(model.index(1, 0))
    events.activated.emit(model.index(1, 0))
    assert window.playback.position == pytest.approx(T0 + 45)
    for seconds, settings in ((10, HEADER.settings), (40, NEXT_SETTINGS)):
        assert window.playback.state_at(T0 + seconds).settings == settings


def test_visible_span_is_exported_as_csv_mcap_and_pictures(
    window: RecordingWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    window.plot.show_span(T0 + 10, T0 + 20)
    with window.qtbot.waitSignal(window.playback.exported):
        window.window.export(tmp_path / "span.csv")
    with (tmp_path / "span.csv").open(encoding="utf-8", newline="") as file:
        times = [float(row["time_s"]) for row in csv.DictReader(file)][1:]
    assert 10 <= min(times) < 10.1
    assert 19.9 < max(times) <= 20
    with window.qtbot.waitSignal(window.playback.exported):
        window.window.export(tmp_path / "span.mcap")
    assert (tmp_path / "span.mcap").read_bytes().startswith(b"\x89MCAP")
    monkeypatch.setattr("trex_gui.ui.playback.window.has_mcap", lambda: False)
    window.window.export(tmp_path / "other.mcap")
    assert "pip install mcap" in window.text("bannerText")
    assert window.has("bannerCopy")
    assert not (tmp_path / "other.mcap").exists()
    window.window.export(window.playback.path)
    assert "cannot be overwritten" in window.text("bannerText")

    window.plot.show_span(T0, T0 + 59)  # with events
    button = window.find(QToolButton, "pictureButton")
    names = {action.objectName() for action in button.menu().actions() if action.text()}
    assert names == {"exportPngAction", "exportSvgAction", "exportLightAction"}
    proposed: list[str] = []

    def select(_parent: QWidget, _title: str, name: str, _kinds: str) -> tuple[str, str]:
        proposed.append(Path(name).name)
        return str(tmp_path / Path(name).name), ""

    monkeypatch.setattr(QFileDialog, "getSaveFileName", select)
    for kind in ("Png", "Svg"):
        window.find(QAction, f"export{kind}Action").trigger()
        window.wait_for_files()
        assert f"minute.{kind.lower()}" in window.text("bannerText")
    assert proposed == ["minute.png", "minute.svg"]
    assert not QImage(str(tmp_path / "minute.png")).isNull()
    assert ", recorded " in (tmp_path / "minute.svg").read_text(encoding="utf-8")


def test_loaded_window_is_complete_and_plays(window: RecordingWindow) -> None:
    assert not window.has("recordingProgress")
    assert not window.has("cancelRecordingButton")
    assert window.is_enabled("exportSpanButton")
    assert window.plot.source is window.playback.traces
    assert "curves show" not in window.text("recordingHeading")
    for kind in (QPushButton, QToolButton, QSlider, QComboBox, QListView):
        for widget in window.find_all(kind):
            if widget.isVisible():
                interface = QAccessible.queryAccessibleInterface(widget)
                assert interface.text(QAccessible.Text.Name), widget.objectName()

    speed, button = window.combo("speedCombo"), window.button("playButton")
    speed.setCurrentIndex(speed.count() - 1)
    assert window.playback.speed == 16
    window.click("playButton")
    assert window.is_playing()
    assert button.text() == "&Pause"
    window.wait(lambda: window.playback.position > T0 + 1)
    window.click("playButton")
    assert not window.is_playing()
    assert button.text() == "&Play"


def test_reading_shows_progress_and_can_be_cancelled(minute: Path, qtbot: QtBot) -> None:
    """In virtual time, the reading begins only when the test waits."""
    window = RecordingWindow.open(loading(Playback(open_recording(minute))), qtbot)
    assert not window.is_enabled("exportSpanButton")
    assert not window.is_enabled("pictureButton")
    assert window.find(QProgressBar, "recordingProgress").text().startswith("Reading, ")
    with qtbot.waitSignal(window.window.closed):
        window.click("cancelRecordingButton")
    assert not window.playback.is_loaded


def test_missing_part_of_a_recording_is_reported(
    minute: Path, tmp_path: Path, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("trex_gui.devices.trex.model.playback.MAX_ROWS", 4100)
    playback = Playback(open_recording(minute))
    playback.start_loading()
    window = RecordingWindow.open(playback, qtbot)
    window.wait(lambda: playback.is_loaded)
    last, total = QLocale().toString(4100), QLocale().toString(playback.row_counts[1])
    heading = f"The curves show the last {last} of {total} samples"
    assert heading in window.text("recordingHeading")
    window.window.close()

    cut = tmp_path / "cut.trexrec"
    write(cut, _records_of_a_minute(), finish=False)
    cut.write_bytes(cut.read_bytes()[:-100])
    damaged = RecordingWindow.open(loading(Playback(open_recording(cut))), qtbot)
    damaged.wait_for_text("bannerText", "not complete")
    assert "The recording was not closed properly" in damaged.text("bannerText")
    damaged.window.close()


def test_times_and_sizes_are_rounded_for_display() -> None:
    assert time_text(3725.25, tenths=True) == "1:02:05.2"
    assert time_text(59.99) == "0:00:59"
    assert time_text(90_061) == "25:01:01"
    assert size_text(4_300_000) == "4.3 MB"
    assert size_text(56_000) == "56 kB"
