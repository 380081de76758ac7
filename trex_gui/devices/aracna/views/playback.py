"""Window of a robot's recording."""

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtGui import QIcon, QPixmap
from PySide6.QtWidgets import QHeaderView, QSizePolicy, QTableWidget, QTableWidgetItem, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.aracna.model.recordings import COLORS, RobotPlayback
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.model.robot_state import RobotState
from trex_gui.devices.aracna.model.texts import (
    activity_text,
    assumed_text,
    difference_text,
    drawing_text,
    joint_text,
    position_text,
    speed_text,
    spoken_joint,
)
from trex_gui.devices.aracna.protocol.joints import CENTER
from trex_gui.devices.aracna.protocol.replies import UNREADABLE
from trex_gui.devices.aracna.views.motion_bar import StopSequenceButton
from trex_gui.devices.aracna.views.robot.drawing import RobotDrawing
from trex_gui.ui.playback.window import RecordingWindow
from trex_gui.ui.theme.theme import follow_theme, theme
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import Note

_NONE = "–"


class RobotPlaybackWindow(RecordingWindow):
    """Window of a robot's recording. Its stop button acts on the connected robot."""

    def __init__(self, playback: RobotPlayback, robot: Robot) -> None:
        plot_name = tr("Plot of the motors' positions against time")
        super().__init__(playback, "aracnaPlayback", plot_name)
        self.playback = playback
        state = playback.state()

        self._activity = ui.named(Note(3, self), "aracnaRecordedActivity")
        self._drawing = RobotDrawing(state, self)
        text = f"{drawing_text()}\n* {assumed_text()}"
        caption = ui.label(self, "aracnaRecordedCaption", text, wrap=True, size="caption")
        caption.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        caption.setMinimumHeight(caption.heightForWidth(self._drawing.minimumSizeHint().width()))
        self._joints = JointValues(state.motors, self)
        side = QWidget(self)
        ui.column(self._activity, (self._drawing, 1), caption, into=side, margins=0)

        playback.moved.connect(self._show_moment)
        playback.loaded.connect(self._show_moment)
        self._drawing.pointed.connect(self._joints.mark)
        self._drawing.joint_clicked.connect(self._joints.focus)
        self._joints.toggled.connect(self._on_toggled)
        self.arrange(
            StopSequenceButton(robot, "aracnaPlaybackStopButton", self),
            below_plot=self._joints,
            above_events=side,
        )
        self._show_moment()

    def device_text(self) -> str:
        header = self.playback.header
        text = tr("Aracna, firmware {0}, %n motor(s)", "", header.motors)
        return text.format(header.version)

    def show_curves(self) -> None:
        hidden = {trace.name for trace in self.playback.traces.traces} - self.plot.shown
        super().show_curves()
        for name in hidden:
            self.plot.set_shown(name, shown=False)

    @Slot()
    def _show_moment(self) -> None:
        state = self.playback.state()
        goals = state.goals  # `None` before the first goals
        if goals is None:
            goals = tuple(CENTER if value is None else value for value in state.present)
        self._drawing.show_robot(state, goals)
        self._joints.show_state(state)
        remaining = max((state.moving_until or 0.0) - self.playback.position, 0.0)
        text, alarming = activity_text(state, remaining)
        self._activity.show_note(text, alarming=alarming)

    @Slot(int, bool)
    def _on_toggled(self, motor: int, on: bool) -> None:
        self.plot.set_shown(self.playback.traces.traces[motor].name, shown=on)


class JointValues(QTableWidget):
    toggled = Signal(int, bool)  # motor, True if its curve is drawn

    def __init__(self, motors: int, parent: QWidget | None = None) -> None:
        headings = tr("Curve"), tr("Present"), tr("Goal"), tr("Difference"), tr("Speed")
        super().__init__(motors, len(headings), parent)
        ui.flat_table(self, "aracnaRecordedJoints", tr("Servos"))
        ui.set_row_height(self, 8)
        self.setHorizontalHeaderLabels(headings)
        self.setVerticalHeaderLabels([*map(spoken_joint, range(motors))])  # for screen readers
        self.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        for motor in range(motors):
            for column in range(len(headings)):
                self.setItem(motor, column, QTableWidgetItem(_NONE))
            curve = self._cell(motor, 0)
            curve.setText(joint_text(motor))
            curve.setCheckState(Qt.CheckState.Checked)
            curve.setToolTip(tr("Draw the position of this motor in the plot"))
        self.itemChanged.connect(self._on_changed)
        follow_theme(self, "curves", self._show_colors)

    def _cell(self, row: int, column: int) -> QTableWidgetItem:
        cell = self.item(row, column)
        assert cell is not None  # noqa: S101 - all cells exist
        return cell

    def focus(self, motor: int) -> None:
        self.setCurrentCell(motor, 0)
        self.setFocus(Qt.FocusReason.OtherFocusReason)

    @Slot(int)
    def mark(self, motor: int) -> None:
        self.setCurrentCell(motor, 0)

    def show_state(self, state: RobotState) -> None:
        for motor in range(self.rowCount()):
            goal = state.goals[motor] if state.goals is not None else None
            difference, alarming = difference_text(state, motor)
            held = state.held_speed(motor)
            self._show(motor, 1, position_text(state.present[motor]))
            self._show(motor, 2, position_text(goal))
            self._show(motor, 3, difference or _NONE, bold=alarming)
            self._show(motor, 4, _speed_text(held), bold=held == UNREADABLE)

    def _show(self, motor: int, column: int, text: str, *, bold: bool = False) -> None:
        cell, font = self._cell(motor, column), self.font()
        font.setBold(bold)
        cell.setFont(font)
        cell.setText(text)

    @Slot(QTableWidgetItem)
    def _on_changed(self, cell: QTableWidgetItem) -> None:
        if cell.column() == 0:
            self.toggled.emit(cell.row(), cell.checkState() is Qt.CheckState.Checked)

    def _show_colors(self) -> None:
        for motor in range(self.rowCount()):
            swatch = QPixmap(14, 4)
            swatch.fill(theme().color(COLORS[motor % len(COLORS)]))
            self._cell(motor, 0).setIcon(QIcon(swatch))


def _speed_text(held: int | None) -> str:
    if held is None:
        return _NONE
    if held == UNREADABLE:
        return tr("no reply (−1)")
    return f"{held} = {speed_text(held)}" if held else speed_text(held)
