"""The window that shows a recording."""

from pathlib import Path

import pytest
from PySide6.QtCore import QLocale, Qt, QThread
from PySide6.QtGui import QAccessible, QAction, QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QComboBox,
    QFileDialog,
    QLabel,
    QListView,
    QProgressBar,
    QPushButton,
    QSlider,
    QToolButton,
    QWidget,
)
from pytestqt.qtbot import QtBot
from shiboken6 import isValid

from tests.recording.samples import HEADER, an_hour, read, write, write_an_hour_of_csv
from trex_gui.model.device import Device
from trex_gui.model.playback import Playback
from trex_gui.protocol.commands import Drive
from trex_gui.recording.files import open_recording
from trex_gui.recording.recording import Marker, Record, SettingsSeen, Wish
from trex_gui.views.recording.window import PlaybackWindow
from trex_gui.views.recording.words import size_text, time_text
from trex_gui.views.traces.plot import TracePlot

T0 = HEADER.clock
LATER = "product: TReX\ndevice_number: 9\n"


def _minute() -> list[Record]:
    extra: list[Record] = [
        Wish(T0 + 20.0, 1, Drive.at(-55)),
        SettingsSeen(T0 + 30.0, LATER),
        Marker(T0 + 30.0, "apply", "Apply: Device Number"),
        Marker(T0 + 45.0, "fault", "Motor 1 fault"),
    ]
    plain = [r for r in an_hour(60) if not isinstance(r, Wish | Marker)]
    return sorted([*plain, *extra], key=lambda record: record.time)


@pytest.fixture
def window(tmp_path: Path, qtbot: QtBot) -> PlaybackWindow:
    write(tmp_path / "minute.trexrec", _minute())
    window = PlaybackWindow(Playback.open(tmp_path / "minute.trexrec"), Device())
    qtbot.addWidget(window)
    window.show()
    qtbot.waitUntil(lambda: window.playback.is_loaded)
    return window


def find(window: QWidget, kind: type[QWidget], name: str) -> QWidget:
    widget = window.findChild(kind, name)
    assert widget is not None, name
    return widget


def text(window: PlaybackWindow, name: str) -> str:
    label = find(window, QLabel, name)
    assert isinstance(label, QLabel)
    return label.text()


def is_playing(window: PlaybackWindow) -> bool:
    return window.playback.playing


def test_it_says_of_which_board_when_and_how_long(window: PlaybackWindow) -> None:
    assert "TReX 1.2, recorded" in text(window, "recordingHeading")
    assert "0:00:59" in text(window, "recordingHeading")
    assert window.windowTitle().startswith("minute.trexrec")


def test_the_slider_goes_to_a_time_and_the_values_are_those_of_it(
    window: PlaybackWindow,
) -> None:
    slider = find(window, QSlider, "timeSlider")
    assert isinstance(slider, QSlider)
    slider.setValue(2500)
    assert window.playback.position == pytest.approx(T0 + 25)
    assert text(window, "timeLabel").startswith("0:00:25.0 / ")
    assert text(window, "motor1WishAtPosition") == "−55"
    assert text(window, "motor2WishAtPosition") == "–"
    assert text(window, "channel1PhysicalAtPosition") in {"1499 µs", "1500 µs", "1501 µs"}
    assert text(window, "channel5RawAtPosition") == "no signal"
    assert text(window, "motor1CurrentAtPosition").endswith(" A")
    assert "serial commands reach the motors" in text(window, "controlAtPosition")
    plot = window.findChild(TracePlot)
    assert plot is not None
    assert plot.cursor_time == window.playback.position


def test_the_slider_obeys_the_keyboard(window: PlaybackWindow, qtbot: QtBot) -> None:
    slider = find(window, QSlider, "timeSlider")
    QTest.keyClick(slider, Qt.Key.Key_Right)
    assert window.playback.position == pytest.approx(T0 + 1)
    QTest.keyClick(slider, Qt.Key.Key_PageUp)
    assert window.playback.position == pytest.approx(T0 + 11)
    QTest.keyClick(slider, Qt.Key.Key_End)
    assert window.playback.position == window.playback.end
    QTest.keyClick(slider, Qt.Key.Key_Home)
    assert window.playback.position == T0


def test_it_plays_and_pauses_as_fast_as_chosen(window: PlaybackWindow, qtbot: QtBot) -> None:
    button, speed = find(window, QPushButton, "playButton"), find(window, QComboBox, "speedCombo")
    assert isinstance(button, QPushButton)
    assert isinstance(speed, QComboBox)
    speed.setCurrentIndex(speed.count() - 1)
    assert window.playback.speed == 16
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)
    assert is_playing(window)
    assert button.text() == "&Pause"
    qtbot.waitUntil(lambda: window.playback.position > T0 + 1)
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)
    assert not is_playing(window)
    assert button.text() == "&Play"


def test_an_event_that_is_chosen_is_gone_to(window: PlaybackWindow, qtbot: QtBot) -> None:
    events = find(window, QListView, "eventList")
    assert isinstance(events, QListView)
    model = events.model()
    rows = [str(model.index(row, 0).data()) for row in range(model.rowCount())]
    assert [row.split("  ")[1] for row in rows] == ["Apply: Device Number", "Motor 1 fault"]
    events.setFocus()
    events.setCurrentIndex(model.index(1, 0))
    events.activated.emit(model.index(1, 0))
    assert window.playback.position == pytest.approx(T0 + 45)


def test_the_settings_that_were_in_force_can_be_opened(
    window: PlaybackWindow, qtbot: QtBot
) -> None:
    button = find(window, QPushButton, "settingsInForceButton")
    for place, settings in ((10, HEADER.settings), (40, LATER)):
        window.playback.set_position(T0 + place)
        with qtbot.waitSignal(window.settings_wanted) as wanted:
            QTest.mouseClick(button, Qt.MouseButton.LeftButton)
        assert wanted.args == [settings, f"minute at 0:00:{place}"]


def test_what_the_plot_shows_is_exported(
    window: PlaybackWindow, qtbot: QtBot, tmp_path: Path
) -> None:
    plot = window.findChild(TracePlot)
    assert plot is not None
    plot.show_span(T0 + 10, T0 + 20)
    with qtbot.waitSignal(window.playback.exported, timeout=20_000):
        window.export(tmp_path / "span.csv")
    file = open_recording(tmp_path / "span.csv")
    times = [record.time for record in read(file)]
    assert T0 + 10 <= min(times) < T0 + 10.1
    assert T0 + 19.9 < max(times) <= T0 + 20
    file.close()
    window.export(window.playback.path)
    assert "cannot be written over" in text(window, "bannerText")


def test_what_the_plot_shows_is_saved_as_a_picture(
    window: PlaybackWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    button = find(window, QToolButton, "pictureButton")
    assert isinstance(button, QToolButton)
    names = {action.objectName() for action in button.menu().actions() if action.text()}
    assert names == {"exportPngAction", "exportSvgAction", "exportLightAction"}
    proposed: list[str] = []

    def choose(_parent: QWidget, _title: str, name: str, _kinds: str) -> tuple[str, str]:
        proposed.append(Path(name).name)
        return str(tmp_path / Path(name).name), ""

    monkeypatch.setattr(QFileDialog, "getSaveFileName", choose)
    for kind in ("Png", "Svg"):
        action = window.findChild(QAction, f"export{kind}Action")
        assert action is not None
        action.trigger()
        assert f"minute.{kind.lower()}" in text(window, "bannerText")
    assert proposed == ["minute.png", "minute.svg"]
    assert not QImage(str(tmp_path / "minute.png")).isNull()
    assert "<svg" in (tmp_path / "minute.svg").read_text(encoding="utf-8")


def half_read(path: Path, qtbot: QtBot) -> tuple[PlaybackWindow, QProgressBar]:
    """Open a recording; return its window, and its bar, when some of it was read and not all.

    A computer that stands still for a moment has read it all then; so it is tried again.
    """
    for _ in range(4):
        window = PlaybackWindow(Playback.open(path), Device())
        window.show()
        bar = find(window, QProgressBar, "recordingProgress")
        assert isinstance(bar, QProgressBar)
        assert not find(window, QPushButton, "exportSpanButton").isEnabled()
        assert not find(window, QToolButton, "pictureButton").isEnabled()
        qtbot.waitUntil(lambda: bar.value() > 0 or window.playback.is_loaded)  # noqa: B023
        if not window.playback.is_loaded:
            return window, bar
        window.close()
    raise AssertionError(path)


@pytest.mark.realtime
def test_while_it_is_read_it_says_how_far_and_can_be_cancelled(
    tmp_path: Path, qtbot: QtBot
) -> None:
    path = tmp_path / "long.csv"
    write_an_hour_of_csv(path, 10)
    window, bar = half_read(path, qtbot)
    assert bar.isVisible()
    assert bar.text().startswith("Reading, ")
    assert not window.playback.is_loaded
    (thread,) = window.playback.findChildren(QThread)
    with qtbot.waitSignal(window.closed):
        QTest.mouseClick(
            find(window, QPushButton, "cancelRecordingButton"), Qt.MouseButton.LeftButton
        )
    qtbot.waitUntil(lambda: not isValid(thread) or thread.isFinished(), timeout=20_000)
    assert not window.playback.is_loaded


def test_when_it_is_read_nothing_of_the_reading_is_left(window: PlaybackWindow) -> None:
    assert not find(window, QProgressBar, "recordingProgress").isVisible()
    assert not find(window, QPushButton, "cancelRecordingButton").isVisible()
    assert find(window, QPushButton, "exportSpanButton").isEnabled()
    plot = window.findChild(TracePlot)
    assert plot is not None
    assert plot.source is window.playback.traces
    assert "curves show" not in text(window, "recordingHeading")


def test_a_recording_too_long_to_be_drawn_whole_says_so(tmp_path: Path, qtbot: QtBot) -> None:
    path = tmp_path / "long.trexrec"
    write(path, _minute())
    playback = Playback(open_recording(path, head_only=True), path, most_rows=4100)
    playback.start_reading()
    window = PlaybackWindow(playback, Device())
    qtbot.addWidget(window)
    qtbot.waitUntil(lambda: window.playback.is_loaded)
    last, there = QLocale().toString(4100), QLocale().toString(window.playback.drawn[1])
    assert f"The curves show its last {last} of {there} samples" in text(window, "recordingHeading")
    window.close()


def test_a_damaged_recording_says_what_is_missing(tmp_path: Path, qtbot: QtBot) -> None:
    path = tmp_path / "cut.trexrec"
    write(path, _minute(), finish=False)
    path.write_bytes(path.read_bytes()[:-100])
    window = PlaybackWindow(Playback.open(path), Device())
    qtbot.addWidget(window)
    qtbot.waitUntil(lambda: window.playback.is_loaded)
    qtbot.waitUntil(lambda: "not whole" in text(window, "bannerText"))
    assert "It was not ended" in text(window, "bannerText")
    window.close()


def test_every_control_has_an_accessible_name(window: PlaybackWindow) -> None:
    for kind in (QPushButton, QToolButton, QSlider, QComboBox, QListView):
        for widget in window.findChildren(kind):
            if widget.isVisible():
                interface = QAccessible.queryAccessibleInterface(widget)
                assert interface.text(QAccessible.Text.Name), widget.objectName()


def test_times_and_sizes_are_written_as_people_read_them() -> None:
    assert time_text(3725.25, tenths=True) == "1:02:05.2"
    assert time_text(59.99) == "0:00:59"
    assert size_text(4_300_000) == "4.3 MB"
    assert size_text(56_000) == "56 kB"
