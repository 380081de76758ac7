"""Window of a robot's recording, which may be damaged."""

from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QListView, QSlider
from pytestqt.qtbot import QtBot

from tests.devices.aracna.recordings import HEADER, MOTORS, T0, open_recording, write
from tests.support.keyboard import check_keyboard
from tests.support.playing import loading
from tests.support.window import LEFT, WidgetDriver
from trex_gui.core.recording.kinds import Marker
from trex_gui.devices.aracna.model.recordings import RobotPlayback
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.recording import Record, RobotHeader
from trex_gui.devices.aracna.session.messages import Moved, Moving, Progress, SpeedsHeld
from trex_gui.devices.aracna.views.playback import JointValues, RobotPlaybackWindow
from trex_gui.devices.aracna.views.robot.drawing import RobotDrawing
from trex_gui.ui.plotting.plot import TracePlot

COLUMNS = ("Curve", "Present", "Goal", "Difference", "Speed")
GOALS, REACHED = (200,) * MOTORS, (201, 199, *(200,) * 5, -1)
SAMPLE_SESSION: list[Record] = [
    SpeedsHeld(T0 + 1, (100,) * MOTORS, (100, 0, *(100,) * 5, -1)),
    Marker(T0 + 1, "fault", "Motor 7 does not answer (−1)"),
    Moving(T0 + 10, GOALS, (None,) * MOTORS, 2.0),
    Progress(T0 + 11, (201, 199, 200)),
    Moved(T0 + 12, GOALS, REACHED, 2.0),
    Marker(T0 + 40, "note", "Not moved: No robot is connected that could move."),
    Marker(T0 + 60, "stop", "Nothing more is sent."),
]


class RecordingWindow(WidgetDriver):
    """Driver of a window with a recording, which may still be loading."""

    def __init__(self, path: Path, qtbot: QtBot) -> None:
        self.window = RobotPlaybackWindow(loading(RobotPlayback(open_recording(path))), Robot())
        super().__init__(self.window, qtbot)
        self.playback = self.window.playback
        self.plot = self.find_only(TracePlot)
        qtbot.addWidget(self.window)

    @property
    def joints(self) -> JointValues:
        return self.find(JointValues, "aracnaRecordedJoints")

    def value(self, motor: int, column: str) -> str:
        """Return the text in a motor's row of the table."""
        return str(self.joints.model().index(motor, COLUMNS.index(column)).data())

    def curve_box(self, motor: int) -> QPoint:
        """Return the position of a curve's check box."""
        table = self.joints
        row = table.visualRect(table.model().index(motor, 0))
        return QPoint(row.left() + 8, row.center().y())

    def wait_until_loaded(self) -> None:
        self.wait(lambda: self.playback.is_loaded)


def show_recording(
    path: Path, qtbot: QtBot, records: list[Record], header: RobotHeader = HEADER
) -> RecordingWindow:
    """Write a recording and show it in a window."""
    write(path, records, header)
    driver = RecordingWindow(path, qtbot)
    driver.window.show()
    driver.wait_until_loaded()
    return driver


@pytest.fixture
def window(tmp_path: Path, qtbot: QtBot) -> RecordingWindow:
    return show_recording(tmp_path / "walk.trexrec", qtbot, SAMPLE_SESSION)


def test_window_shows_recording_and_state_at_selected_time(window: RecordingWindow) -> None:
    heading = window.text("recordingHeading")
    assert heading.startswith("Aracna, firmware 1, 8 motors, recorded ")
    assert heading.endswith("0:01:00 long")
    assert window.window.windowTitle().startswith("walk.trexrec")
    assert not window.is_enabled("aracnaPlaybackStopButton"), "no robot is connected"
    assert window.text("aracnaRecordedActivity").startswith("Nothing is sent.")
    assert window.value(0, "Present") == "–"
    window.playback.set_position(T0 + 11.5)
    assert window.text("aracnaRecordedActivity") == "The motion ends by itself in about 0.5 s."
    assert window.value(3, "Difference") == "moving …"
    assert window.value(2, "Present") == "200 = 58.7°"
    assert window.value(3, "Present") == "–"
    slider = window.find(QSlider, "timeSlider")
    window.wait(slider.isVisible)
    window.wait(lambda: slider.width() > 200)
    window.drag("timeSlider", slider.maximum() * 2 // 3)
    assert window.playback.position - T0 == pytest.approx(40, abs=2)
    assert window.text("timeLabel").endswith(" / 0:01:00.0")
    assert window.value(0, "Present") == "201 = 58.9°"
    assert window.value(0, "Goal") == "200 = 58.7°"
    assert window.value(0, "Difference") == "+1"
    assert window.value(1, "Difference") == "−1"
    assert window.value(7, "Present") == "–"
    assert window.value(7, "Difference") == "no reply (−1)"
    assert window.value(0, "Speed") == "100 = 67 °/s"
    assert window.value(1, "Speed") == "unlimited"
    assert window.value(7, "Speed") == "no reply (−1)"
    assert window.text("aracnaRecordedActivity") == "At rest: nothing is sent."
    assert window.plot.cursor_time == window.playback.position


def test_plot_boxes_and_drawing_follow_mouse_and_keys(window: RecordingWindow) -> None:
    plot = window.plot
    canvas = plot._canvas
    window.wait(lambda: canvas.frame.width() > 100)
    frame = canvas.frame
    point = QPointF(canvas.x_of(T0 + 30 - plot.span.end), frame.center().y()).toPoint()
    QTest.mouseClick(canvas.viewport, Qt.MouseButton.LeftButton, pos=point)
    assert window.playback.position == pytest.approx(T0 + 30, abs=0.5)
    assert len(plot.shown) == MOTORS
    QTest.mouseClick(window.joints.viewport(), LEFT, pos=window.curve_box(3))
    assert "motor_3" not in plot.shown
    window.joints.focus(3)
    QTest.keyClick(window.joints, Qt.Key.Key_Space)
    assert "motor_3" in plot.shown

    drawing = window.find_only(RobotDrawing)
    window.wait(drawing.isVisible)
    window.playback.set_position(T0 + 9)
    before = drawing.joint_place(1)
    window.playback.set_position(T0 + 20)
    assert drawing.joint_place(1) != before
    QTest.mouseClick(drawing, Qt.MouseButton.LeftButton, pos=drawing.joint_place(1).toPoint())
    assert window.window.focusWidget() is window.joints
    assert window.joints.currentRow() == 1
    QTest.mouseMove(drawing, drawing.joint_place(2).toPoint())
    window.wait(lambda: window.joints.currentRow() == 2)


def test_recording_window_works_with_the_keyboard(window: RecordingWindow) -> None:
    window.playback.set_position(T0 + 20)
    check_keyboard(window.window)
    spoken = window.joints.model().headerData(0, Qt.Orientation.Vertical)
    assert spoken == "Motor 0 inner, front left leg"
    assert "positions" in window.plot.accessibleName()


def test_curve_hidden_while_loading_stays_hidden(tmp_path: Path, qtbot: QtBot) -> None:
    path = tmp_path / "walk.trexrec"
    write(path, SAMPLE_SESSION)
    window = RecordingWindow(path, qtbot)
    box = window.joints.model().index(2, 0)
    unchecked = Qt.CheckState.Unchecked
    window.joints.model().setData(box, unchecked, Qt.ItemDataRole.CheckStateRole)
    window.wait_until_loaded()
    plot = window.plot
    window.wait(lambda: plot.source is window.playback.traces)
    assert "motor_2" not in plot.shown
    assert len(plot.shown) == MOTORS - 1


@pytest.mark.parametrize("motors", [2, 18])
def test_recording_with_other_motor_count_is_shown(
    tmp_path: Path, qtbot: QtBot, motors: int
) -> None:
    header = RobotHeader(HEADER.started, T0, version=0, motors=motors)
    goals = (300,) * motors
    moved = Moved(T0 + 1, goals, goals, 1.0)
    window = show_recording(tmp_path / "a.trexrec", qtbot, [moved], header)
    window.playback.set_position(T0 + 1)
    assert window.value(motors - 1, "Present") == "300 = 88.0°"
    assert window.joints.rowCount() == motors
    assert window.window.height() < 1000


def test_empty_recording_shows_that_it_has_no_events(tmp_path: Path, qtbot: QtBot) -> None:
    window = show_recording(tmp_path / "a.trexrec", qtbot, [])
    events = window.find(QListView, "eventList")
    window.wait(lambda: "no events" in events.accessibleDescription())
    assert not window.is_enabled("playButton")
