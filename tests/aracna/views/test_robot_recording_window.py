"""The window that shows the recording of a robot, driven with mouse and keys."""

from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QAccessible
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractScrollArea,
    QCheckBox,
    QComboBox,
    QLabel,
    QListView,
    QPushButton,
    QScrollArea,
    QSlider,
    QStyle,
    QStyleOptionSlider,
    QToolButton,
)
from pytestqt.qtbot import QtBot

from tests.aracna.recordings import MOTORS, T0
from tests.aracna.views.recording_stage import PATIENCE, STORY, click, find, opened, text
from tests.support.accessible_names import assert_named
from trex_gui.aracna.views.page.drawing import RobotDrawing
from trex_gui.aracna.views.recording.window import RobotPlaybackWindow
from trex_gui.recording.recording import Marker
from trex_gui.views.traces.plot import TracePlot


@pytest.fixture
def window(tmp_path: Path, qtbot: QtBot) -> RobotPlaybackWindow:
    return opened(tmp_path / "walk.csv", qtbot, STORY)


def is_playing(window: RobotPlaybackWindow) -> bool:
    return window.playback.playing


def handle(slider: QSlider, value: int) -> QPoint:
    option = QStyleOptionSlider()
    slider.initStyleOption(option)
    option.sliderPosition = option.sliderValue = value
    kind, part = QStyle.ComplexControl.CC_Slider, QStyle.SubControl.SC_SliderHandle
    return slider.style().subControlRect(kind, option, part, slider).center()


def test_it_says_of_which_robot_when_and_how_long(window: RobotPlaybackWindow) -> None:
    heading = text(window, "recordingHeading")
    assert heading.startswith("Aracna, firmware 1, 8 motors, recorded ")
    assert heading.endswith("0:01:00 long")
    assert window.windowTitle().startswith("walk.csv")


def test_the_slider_is_dragged_to_a_time_and_everything_is_that_of_it(
    window: RobotPlaybackWindow, qtbot: QtBot
) -> None:
    slider = find(window, QSlider, "timeSlider")
    qtbot.waitUntil(slider.isVisible, timeout=PATIENCE)
    qtbot.waitUntil(lambda: slider.width() > 200, timeout=PATIENCE)
    start, end = handle(slider, 0), handle(slider, slider.maximum() * 2 // 3)
    QTest.mousePress(slider, Qt.MouseButton.LeftButton, pos=start)
    for step in range(1, 11):
        QTest.mouseMove(slider, start + (end - start) * step / 10)
    QTest.mouseRelease(slider, Qt.MouseButton.LeftButton, pos=end)
    assert window.playback.position - T0 == pytest.approx(40, abs=2)
    assert text(window, "timeLabel").endswith(" / 0:01:00.0")
    assert text(window, "aracnaRecordedPresent0") == "201 = 58.9°"
    assert text(window, "aracnaRecordedGoal0") == "200 = 58.7°"
    assert text(window, "aracnaRecordedDifference0") == "+1"
    assert text(window, "aracnaRecordedDifference1") == "−1"
    assert text(window, "aracnaRecordedPresent7") == "–"
    assert text(window, "aracnaRecordedDifference7") == "no answer (−1)"
    assert text(window, "aracnaRecordedSpeed0") == "100 = 67 °/s"
    assert text(window, "aracnaRecordedSpeed1") == "as fast as it can"
    assert text(window, "aracnaRecordedSpeed7") == "no answer (−1)"
    assert text(window, "aracnaRecordedDoing") == "At rest."
    plot = window.findChild(TracePlot)
    assert plot is not None
    assert plot.cursor_time == window.playback.position


def test_what_moves_is_said_and_which_motor_is_waited_for(window: RobotPlaybackWindow) -> None:
    assert text(window, "aracnaRecordedDoing") == "Where the motors were was not known yet."
    assert text(window, "aracnaRecordedPresent0") == "–"
    window.playback.set_position(T0 + 11.5)
    assert text(window, "aracnaRecordedDoing") == (
        "Moving for 1.5 s of about 2.0 s; motor 3 is waited for."
    )
    assert text(window, "aracnaRecordedDifference3") == "waited for"
    assert text(window, "aracnaRecordedPresent2") == "200 = 58.7°"
    assert text(window, "aracnaRecordedPresent3") == "–"


def test_the_slider_obeys_the_keyboard(window: RobotPlaybackWindow) -> None:
    slider = find(window, QSlider, "timeSlider")
    QTest.keyClick(slider, Qt.Key.Key_Right)
    assert window.playback.position == pytest.approx(T0 + 1)
    QTest.keyClick(slider, Qt.Key.Key_PageUp)
    assert window.playback.position == pytest.approx(T0 + 11)
    QTest.keyClick(slider, Qt.Key.Key_End)
    assert window.playback.position == window.playback.end
    QTest.keyClick(slider, Qt.Key.Key_Home)
    assert window.playback.position == T0


def test_it_plays_and_pauses_as_fast_as_chosen(window: RobotPlaybackWindow, qtbot: QtBot) -> None:
    speed = find(window, QComboBox, "speedCombo")
    speed.setCurrentIndex(speed.count() - 1)
    assert window.playback.speed == 16
    click(window, qtbot, "playButton")
    assert is_playing(window)
    qtbot.waitUntil(lambda: window.playback.position > T0 + 1, timeout=PATIENCE)
    click(window, qtbot, "playButton")
    assert not is_playing(window)


def test_an_event_that_is_clicked_is_gone_to(window: RobotPlaybackWindow, qtbot: QtBot) -> None:
    events = find(window, QListView, "eventList")
    model = events.model()
    rows = [str(model.index(row, 0).data()) for row in range(model.rowCount())]
    assert [row.split("  ")[1] for row in rows] == [
        each.text for each in STORY if isinstance(each, Marker)
    ]
    qtbot.waitUntil(events.isVisible, timeout=PATIENCE)
    events.scrollTo(model.index(1, 0))
    place = events.visualRect(model.index(1, 0)).center()
    QTest.mouseClick(events.viewport(), Qt.MouseButton.LeftButton, pos=place)
    assert window.playback.position == pytest.approx(T0 + 40)


def test_a_click_in_the_plot_goes_there(window: RobotPlaybackWindow, qtbot: QtBot) -> None:
    plot = window.findChild(TracePlot)
    assert plot is not None
    canvas = plot._canvas
    qtbot.waitUntil(lambda: canvas.frame.width() > 100, timeout=PATIENCE)
    frame = canvas.frame
    place = QPointF(canvas.x_of(T0 + 30 - plot.span.end), frame.center().y()).toPoint()
    QTest.mouseClick(canvas.viewport, Qt.MouseButton.LeftButton, pos=place)
    assert window.playback.position == pytest.approx(T0 + 30, abs=0.5)


def test_curves_are_taken_away_and_brought_back(window: RobotPlaybackWindow, qtbot: QtBot) -> None:
    plot = window.findChild(TracePlot)
    assert plot is not None
    assert len(plot.shown) == MOTORS
    box = find(window, QCheckBox, "aracnaCurveBox3")
    qtbot.waitUntil(box.isVisible, timeout=PATIENCE)
    place = QPoint(8, box.height() // 2)
    QTest.mouseClick(box, Qt.MouseButton.LeftButton, pos=place)
    assert "motor_3" not in plot.shown
    QTest.keyClick(box, Qt.Key.Key_Space)
    assert "motor_3" in plot.shown


def test_the_drawing_stands_as_the_robot_stood_then_and_leads_to_the_rows(
    window: RobotPlaybackWindow, qtbot: QtBot
) -> None:
    drawing = window.findChild(RobotDrawing)
    assert drawing is not None
    qtbot.waitUntil(drawing.isVisible, timeout=PATIENCE)
    window.playback.set_position(T0 + 9)
    before = drawing.joint_place(1)
    window.playback.set_position(T0 + 20)
    assert drawing.joint_place(1) != before
    QTest.mouseClick(drawing, Qt.MouseButton.LeftButton, pos=drawing.joint_place(1).toPoint())
    box = find(window, QCheckBox, "aracnaCurveBox1")
    assert window.focusWidget() is box
    QTest.mouseMove(drawing, drawing.joint_place(2).toPoint())
    qtbot.waitUntil(
        lambda: find(window, QCheckBox, "aracnaCurveBox2").font().bold(), timeout=PATIENCE
    )
    assert not box.font().bold()


def test_everything_in_it_has_a_name(window: RobotPlaybackWindow) -> None:
    window.playback.set_position(T0 + 20)
    assert_named(window)
    for kind in (QPushButton, QToolButton, QSlider, QComboBox, QCheckBox, QListView, TracePlot):
        for widget in window.findChildren(kind):
            if widget.isVisible() and not isinstance(widget.parent(), QScrollArea):
                interface = QAccessible.queryAccessibleInterface(widget)
                assert interface.text(QAccessible.Text.Name), widget.objectName()
                assert widget.objectName() or isinstance(widget.parent(), QAbstractScrollArea)
    assert find(window, QLabel, "aracnaRecordedPresent0").accessibleName() == (
        "Motor 0 inner, front left leg, present position: 201 = 58.9°"
    )
    plot = window.findChild(TracePlot)
    assert plot is not None
    assert "positions" in plot.accessibleName()


def test_the_stop_button_is_that_of_the_robot(window: RobotPlaybackWindow) -> None:
    assert not find(window, QPushButton, "aracnaPlaybackStopButton").isEnabled()
