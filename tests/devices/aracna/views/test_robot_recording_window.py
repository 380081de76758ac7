"""The window that shows the recording of a robot, driven with mouse and keys."""

from pathlib import Path

import pytest
from PySide6.QtCore import QPointF, Qt
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
    QToolButton,
)
from pytestqt.qtbot import QtBot

from tests.devices.aracna.recordings import MOTORS, T0
from tests.devices.aracna.views.recording_stage import (
    SAMPLE_SESSION,
    RecordingWindowDriver,
    show_recording,
)
from tests.support.keyboard import check_keyboard
from trex_gui.devices.aracna.views.robot.drawing import RobotDrawing
from trex_gui.ui.plotting.plot import TracePlot


@pytest.fixture
def window(tmp_path: Path, qtbot: QtBot) -> RecordingWindowDriver:
    return show_recording(tmp_path / "walk.trexrec", qtbot, SAMPLE_SESSION)


def test_heading_shows_robot_date_and_duration(window: RecordingWindowDriver) -> None:
    heading = window.text("recordingHeading")
    assert heading.startswith("Aracna, firmware 1, 8 motors, recorded ")
    assert heading.endswith("0:01:00 long")
    assert window.window.windowTitle().startswith("walk.trexrec")


def test_dragged_time_slider_shows_state_at_that_time(window: RecordingWindowDriver) -> None:
    slider = window.find(QSlider, "timeSlider")
    window.wait(slider.isVisible)
    window.wait(lambda: slider.width() > 200)
    window.drag("timeSlider", slider.maximum() * 2 // 3)
    assert window.playback.position - T0 == pytest.approx(40, abs=2)
    assert window.text("timeLabel").endswith(" / 0:01:00.0")
    assert window.text("aracnaRecordedPresent0") == "201 = 58.9°"
    assert window.text("aracnaRecordedGoal0") == "200 = 58.7°"
    assert window.text("aracnaRecordedDifference0") == "+1"
    assert window.text("aracnaRecordedDifference1") == "−1"
    assert window.text("aracnaRecordedPresent7") == "–"
    assert window.text("aracnaRecordedDifference7") == "no reply (−1)"
    assert window.text("aracnaRecordedSpeed0") == "100 = 67 °/s"
    assert window.text("aracnaRecordedSpeed1") == "unlimited"
    assert window.text("aracnaRecordedSpeed7") == "no reply (−1)"
    assert window.text("aracnaRecordedDoing") == "At rest."
    assert window.plot.cursor_time == window.playback.position


def test_motion_and_awaited_motor_are_shown(window: RecordingWindowDriver) -> None:
    assert window.text("aracnaRecordedDoing") == "Positions are not known yet."
    assert window.text("aracnaRecordedPresent0") == "–"
    window.playback.set_position(T0 + 11.5)
    assert window.text("aracnaRecordedDoing") == (
        "Moving for 1.5 s of about 2.0 s; motor 3 is waited for."
    )
    assert window.text("aracnaRecordedDifference3") == "moving …"
    assert window.text("aracnaRecordedPresent2") == "200 = 58.7°"
    assert window.text("aracnaRecordedPresent3") == "–"


def test_click_in_plot_seeks_to_that_time(window: RecordingWindowDriver) -> None:
    plot = window.plot
    canvas = plot._canvas
    window.wait(lambda: canvas.frame.width() > 100)
    frame = canvas.frame
    place = QPointF(canvas.x_of(T0 + 30 - plot.span.end), frame.center().y()).toPoint()
    QTest.mouseClick(canvas.viewport, Qt.MouseButton.LeftButton, pos=place)
    assert window.playback.position == pytest.approx(T0 + 30, abs=0.5)


def test_curve_check_box_hides_and_shows_curve(window: RecordingWindowDriver) -> None:
    plot = window.plot
    assert len(plot.shown) == MOTORS
    window.click("aracnaCurveBox3")
    assert "motor_3" not in plot.shown
    QTest.keyClick(window.button("aracnaCurveBox3"), Qt.Key.Key_Space)
    assert "motor_3" in plot.shown


def test_drawing_shows_recorded_pose_and_focuses_clicked_row(window: RecordingWindowDriver) -> None:
    drawing = window.find_only(RobotDrawing)
    window.wait(drawing.isVisible)
    window.playback.set_position(T0 + 9)
    before = drawing.joint_place(1)
    window.playback.set_position(T0 + 20)
    assert drawing.joint_place(1) != before
    QTest.mouseClick(drawing, Qt.MouseButton.LeftButton, pos=drawing.joint_place(1).toPoint())
    box = window.find(QCheckBox, "aracnaCurveBox1")
    assert window.window.focusWidget() is box
    QTest.mouseMove(drawing, drawing.joint_place(2).toPoint())
    window.wait(lambda: window.find(QCheckBox, "aracnaCurveBox2").font().bold())
    assert not box.font().bold()


def test_recording_window_works_with_the_keyboard(window: RecordingWindowDriver) -> None:
    window.playback.set_position(T0 + 20)
    check_keyboard(window.window)
    for kind in (QPushButton, QToolButton, QSlider, QComboBox, QCheckBox, QListView, TracePlot):
        for widget in window.find_all(kind):
            if widget.isVisible() and not isinstance(widget.parent(), QScrollArea):
                interface = QAccessible.queryAccessibleInterface(widget)
                assert interface.text(QAccessible.Text.Name), widget.objectName()
                assert widget.objectName() or isinstance(widget.parent(), QAbstractScrollArea)
    assert window.find(QLabel, "aracnaRecordedPresent0").accessibleName() == (
        "Motor 0 inner, front left leg, present position: 201 = 58.9°"
    )
    assert "positions" in window.plot.accessibleName()


def test_stop_button_is_disabled_without_robot(window: RecordingWindowDriver) -> None:
    assert not window.is_enabled("aracnaPlaybackStopButton")
