"""The joints at the position of a recording: where they were, were sent, and how fast."""

from PySide6.QtCore import QSignalBlocker, QSize, Qt, Signal, Slot
from PySide6.QtGui import QColor, QIcon, QPixmap
from PySide6.QtWidgets import QCheckBox, QGridLayout, QLabel, QWidget

from trex_gui.devices.aracna.model.playback import COLORS
from trex_gui.devices.aracna.model.robot_state import UNREADABLE
from trex_gui.devices.aracna.views.playback.shown import RecordedRobot
from trex_gui.devices.aracna.views.robot.words import (
    joint_text,
    position_text,
    signed,
    speed_text,
    spoken_joint,
)
from trex_gui.ui.theme.theme import theme

_NONE = "–"
_PARTS = ("Present", "Goal", "Difference", "Speed")


class JointValues(QWidget):
    """A row for each motor; a dash where nothing was known.

    Signals:
        toggled: whether the curve of a motor is to be drawn: its number, and that.
    """

    toggled = Signal(int, bool)

    def __init__(self, robot: RecordedRobot, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("aracnaRecordedJoints")
        self._robot = robot
        self._boxes: list[QCheckBox] = []
        self._cells: dict[tuple[int, str], QLabel] = {}

        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(12)
        grid.setVerticalSpacing(2)
        heads = (
            self.tr("Curve"),
            self.tr("Present"),
            self.tr("Goal"),
            self.tr("Difference"),
            self.tr("Speed"),
        )
        for column, text in enumerate(heads):
            head = QLabel(text, self)
            head.setAlignment(_LEFT if column == 0 else _RIGHT)
            grid.addWidget(head, 0, column)
        for motor in range(robot.motors):
            self._add_row(grid, motor)
        grid.setColumnStretch(len(heads), 1)

        robot.changed.connect(self._on_changed)
        theme().changed.connect(self._on_theme_changed)
        self._on_theme_changed()
        self._on_changed()

    def _add_row(self, grid: QGridLayout, motor: int) -> None:
        box = QCheckBox(joint_text(motor), self)
        box.setObjectName(f"aracnaCurveBox{motor}")
        box.setAccessibleName(self.tr("{0}: draw its curve").format(spoken_joint(motor)))
        box.setToolTip(self.tr("Draw the position of this motor in the plot"))
        box.setChecked(True)
        box.toggled.connect(lambda on: self.toggled.emit(motor, on))
        grid.addWidget(box, motor + 1, 0)
        self._boxes.append(box)
        widest = {"Present": position_text(1023), "Goal": position_text(1023)}
        for column, part in enumerate(_PARTS, 1):
            cell = QLabel(_NONE, self)
            cell.setObjectName(f"aracnaRecorded{part}{motor}")
            cell.setAlignment(_RIGHT)
            text = widest.get(part, "1023 = 684 °/s")
            cell.setMinimumWidth(self.fontMetrics().horizontalAdvance(text))
            grid.addWidget(cell, motor + 1, column)
            self._cells[motor, part] = cell

    def focus(self, motor: int) -> None:
        """Put the keyboard on the row of a motor."""
        if motor < len(self._boxes):
            self._boxes[motor].setFocus(Qt.FocusReason.OtherFocusReason)

    def mark(self, motor: int | None) -> None:
        """Let the name of a motor stand out."""
        for number, box in enumerate(self._boxes):
            font = box.font()
            if font.bold() != (number == motor):
                font.setBold(number == motor)
                box.setFont(font)

    def show_drawn(self, drawn: frozenset[int]) -> None:
        """Tick the motors whose curves are drawn."""
        for motor, box in enumerate(self._boxes):
            with QSignalBlocker(box):
                box.setChecked(motor in drawn)

    @Slot()
    def _on_changed(self) -> None:
        known = self._robot.known
        missed = {each.motor: each for each in known.missed}
        for motor in range(self._robot.motors):
            present = known.present[motor]
            goal = known.goals[motor] if known.goals is not None else None
            self._set(motor, "Present", position_text(present))
            self._set(motor, "Goal", position_text(goal))
            alarming = motor in missed
            if alarming and missed[motor].unreadable:
                text = self.tr("no answer (−1)")
            elif known.moving is not None:
                alarming = known.stuck is not None and known.stuck.motor == motor
                text = self.tr("waited for") if motor == known.waited_for else _NONE
            elif present is None or goal is None:
                text = _NONE
            else:
                text = signed(present - goal)
            self._set(motor, "Difference", text, bold=alarming)
            held = known.held(motor)
            self._set(motor, "Speed", self._speed(held), bold=held == UNREADABLE)

    def _speed(self, held: int | None) -> str:
        if held is None:
            return _NONE
        if held == UNREADABLE:
            return self.tr("no answer (−1)")
        return f"{held} = {speed_text(held)}" if held else speed_text(held)

    def _set(self, motor: int, part: str, text: str, *, bold: bool = False) -> None:
        cell = self._cells[motor, part]
        if cell.text() != text:
            cell.setText(text)
            name = {
                "Present": self.tr("present position"),
                "Goal": self.tr("goal"),
                "Difference": self.tr("difference"),
                "Speed": self.tr("speed"),
            }[part]
            cell.setAccessibleName(f"{spoken_joint(motor)}, {name}: {text}")
        font = cell.font()
        if font.bold() != bold:
            font.setBold(bold)
            cell.setFont(font)

    @Slot()
    def _on_theme_changed(self) -> None:
        for motor, box in enumerate(self._boxes):
            box.setIcon(_swatch(theme().color(COLORS[motor % len(COLORS)])))
            box.setIconSize(QSize(14, 4))


_LEFT = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter


def _swatch(color: QColor) -> QIcon:
    picture = QPixmap(14, 4)
    picture.fill(color)
    return QIcon(picture)
