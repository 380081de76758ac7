"""Window of a recording of a robot."""

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtGui import QPixmap
from PySide6.QtWidgets import QCheckBox, QGridLayout, QLabel, QSizePolicy, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.aracna.model.recordings import COLORS, RobotPlayback
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.model.robot_state import RobotState
from trex_gui.devices.aracna.model.texts import (
    activity_text,
    assumed_text,
    difference_text,
    joint_text,
    position_text,
    speed_text,
    spoken_joint,
)
from trex_gui.devices.aracna.protocol.joints import CENTRE, MOTORS
from trex_gui.devices.aracna.protocol.replies import UNREADABLE
from trex_gui.devices.aracna.views.motion_bar import StopSequenceButton
from trex_gui.devices.aracna.views.robot.drawing import RobotDrawing
from trex_gui.ui.playback.window import RecordingWindow
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import Note
from trex_gui.ui.widgets.scroll_box import ScrollBox

_NONE = "–"
_LEFT = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter


class RobotPlaybackWindow(RecordingWindow):
    """One recording of a robot. The stop button is that of the connected robot."""

    def __init__(
        self, playback: RobotPlayback, robot: Robot, parent: QWidget | None = None
    ) -> None:
        plot_name = tr("Plot of the motors' positions against time")
        super().__init__(playback, "aracnaPlayback", plot_name, parent)
        self.playback = playback
        state = playback.state()

        self._activity = ui.named(Note(3, self), "aracnaRecordedDoing")
        self._drawing = RobotDrawing(state, self)
        caption = ui.label(
            self,
            "aracnaRecordedCaption",
            tr("Full lines: as last reported; dashed: goal.") + f"\n* {assumed_text()}",
            wrap=True,
        )
        caption.setForegroundRole(caption.palette().ColorRole.PlaceholderText)
        caption.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        caption.setMinimumHeight(caption.heightForWidth(self._drawing.minimumSizeHint().width()))
        self._joints = JointValues(state.motors, self)
        scrolls = playback.header.motors > MOTORS  # as many as the published robot fit
        beside = QWidget(self)
        ui.column(self._activity, (self._drawing, 1), caption, into=beside, margins=0)

        playback.moved.connect(self._show_moment)
        playback.loaded.connect(self._show_moment)
        self._drawing.pointed.connect(self._joints.mark)
        self._drawing.chosen.connect(self._joints.focus)
        self._joints.toggled.connect(self._on_toggled)
        self.arrange(
            StopSequenceButton(robot, "aracnaPlaybackStopButton", self),
            [],
            below_plot=ScrollBox(self._joints, self) if scrolls else self._joints,
            above_events=beside,
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
        goals = state.goals  # before the first one the positions
        if goals is None:
            goals = tuple(CENTRE if place is None else place for place in state.present)
        self._drawing.show_robot(state, goals)
        self._joints.show_state(state)
        left = max((state.moving_until or 0.0) - self.playback.position, 0.0)
        text, alarming = activity_text(state, left)
        self._activity.show_note(text, alarming=alarming)

    @Slot(int, bool)
    def _on_toggled(self, motor: int, on: bool) -> None:
        self.plot.set_shown(self.playback.traces.traces[motor].name, shown=on)


class JointValues(QWidget):
    """A row for each motor; a dash where nothing was known."""

    toggled = Signal(int, bool)  # a motor, and whether its curve is drawn

    def __init__(self, motors: int, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("aracnaRecordedJoints")
        self._boxes: list[QCheckBox] = []
        self._cells: dict[tuple[int, str], QLabel] = {}
        # Part of the object name: heading, name for screen readers, widest text.
        self._parts = {
            "Present": (tr("Present"), tr("present position"), position_text(1023)),
            "Goal": (tr("Goal"), tr("goal"), position_text(1023)),
            "Difference": (tr("Difference"), tr("difference"), "1023 = 684 °/s"),
            "Speed": (tr("Speed"), tr("speed"), "1023 = 684 °/s"),
        }

        grid = ui.grid(self, margins=0, spacing=(12, 2), stretch=[(len(self._parts) + 1, 1)])
        headings = (tr("Curve"), *(heading for heading, _, _ in self._parts.values()))
        for column, text in enumerate(headings):
            label = ui.label(self, text=text)
            label.setAlignment(_LEFT if column == 0 else _RIGHT)
            grid.addWidget(label, 0, column)
        for motor in range(motors):
            self._add_row(grid, motor)

        theme().changed.connect(self._on_theme_changed)
        self._on_theme_changed()

    def _add_row(self, grid: QGridLayout, motor: int) -> None:
        box = ui.check_box(
            self,
            f"aracnaCurveBox{motor}",
            joint_text(motor),
            accessible=tr("{0}: draw its curve").format(spoken_joint(motor)),
            tip=tr("Draw the position of this motor in the plot"),
            checked=True,
            on_toggle=lambda on: self.toggled.emit(motor, on),
        )
        grid.addWidget(box, motor + 1, 0)
        self._boxes.append(box)
        for column, (part, (_, _, widest)) in enumerate(self._parts.items(), 1):
            cell = ui.label(self, f"aracnaRecorded{part}{motor}", _NONE)
            cell.setAlignment(_RIGHT)
            cell.setMinimumWidth(self.fontMetrics().horizontalAdvance(widest))
            grid.addWidget(cell, motor + 1, column)
            self._cells[motor, part] = cell

    def focus(self, motor: int) -> None:
        if motor < len(self._boxes):
            self._boxes[motor].setFocus(Qt.FocusReason.OtherFocusReason)

    @Slot(int)
    def mark(self, motor: int) -> None:
        for number, box in enumerate(self._boxes):
            ui.set_bold(box, number == motor)

    def show_state(self, known: RobotState) -> None:
        for motor in range(len(self._boxes)):
            goal = known.goals[motor] if known.goals is not None else None
            self._set(motor, "Present", position_text(known.present[motor]))
            self._set(motor, "Goal", position_text(goal))
            text, alarming = difference_text(known, motor)
            self._set(motor, "Difference", text or _NONE, bold=alarming)
            held = known.held_speed(motor)
            self._set(motor, "Speed", self._speed(held), bold=held == UNREADABLE)

    def _speed(self, held: int | None) -> str:
        if held is None:
            return _NONE
        if held == UNREADABLE:
            return tr("no reply (−1)")
        return f"{held} = {speed_text(held)}" if held else speed_text(held)

    def _set(self, motor: int, part: str, text: str, *, bold: bool = False) -> None:
        cell = self._cells[motor, part]
        if cell.text() != text:
            cell.setText(text)
            cell.setAccessibleName(f"{spoken_joint(motor)}, {self._parts[part][1]}: {text}")
        ui.set_bold(cell, bold)

    @Slot()
    def _on_theme_changed(self) -> None:
        for motor, box in enumerate(self._boxes):
            swatch = QPixmap(14, 4)
            swatch.fill(theme().color(COLORS[motor % len(COLORS)]))
            box.setIcon(swatch)
            box.setIconSize(swatch.size())
