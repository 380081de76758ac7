"""The robot: seen from above, and its joints in rows."""

from PySide6.QtCore import Qt, Slot
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QHBoxLayout, QVBoxLayout, QWidget

from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.views.robot.controls import Controls
from trex_gui.devices.aracna.views.robot.joint_table import JointTable
from trex_gui.devices.aracna.views.robot.reports import Reports
from trex_gui.devices.aracna.views.robot.sketch import Sketch
from trex_gui.devices.aracna.views.typed import take_typed

_GAP = 16


class RobotPage(QWidget):
    """Sliders are what a person wants; the robot goes there on Move, or while they are dragged."""

    def __init__(self, robot: Robot, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("aracnaRobotPage")
        self._robot = robot

        self._sketch = Sketch(robot, self)
        self._drawing = self._sketch.drawing
        self._table = JointTable(robot, self)
        self._reports = Reports(robot, self)
        self.controls = Controls(robot, self)

        self._right = right = QVBoxLayout()
        right.setSpacing(10)
        right.addWidget(self._table)
        right.addWidget(self.controls)
        right.addWidget(self._reports)
        right.addStretch(1)
        self._sides = layout = QHBoxLayout(self)
        layout.setSpacing(_GAP)
        layout.addWidget(self._sketch, 2)
        layout.addLayout(right, 7)
        layout.setAlignment(right, Qt.AlignmentFlag.AlignTop)

        self._drawing.pointed.connect(self._on_pointed)
        self._drawing.chosen.connect(self._table.focus)
        self._table.pointed.connect(self._on_pointed)
        self._table.wanted.connect(self._on_wanted)
        self._table.grabbed.connect(self._on_grabbed)
        self._table.released.connect(self._on_released)
        self.controls.move_wanted.connect(self.move_now)
        self.controls.limits_toggled.connect(self._on_limits_toggled)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        margins = self._sides.contentsMargins()
        taken = margins.left() + margins.right() + self._right.minimumSize().width() + _GAP
        self._sketch.fit(self.width() - taken)

    @Slot()
    def move_now(self) -> None:
        """Send every motor to its goal."""
        take_typed()
        self._robot.move(self._robot.targets.goals)

    @Slot(int)
    def _on_pointed(self, motor: int) -> None:
        marked = motor if motor >= 0 else None
        self._drawing.mark(marked)
        self._table.mark(marked)

    @Slot()
    def _on_grabbed(self) -> None:
        if self.controls.is_live and self.controls.can_move:
            self._robot.begin_drag()

    @Slot()
    def _on_released(self) -> None:
        self._robot.end_drag()

    @Slot(int)
    def _on_wanted(self, motor: int) -> None:
        """Send at once where that is wished; a key or a spin box is a drag of one step."""
        del motor
        if not self.controls.is_live or not self.controls.can_move:
            return
        if self._robot.dragging:
            self._robot.drag(self._robot.targets.goals)
        elif not self._table.held:
            self._robot.begin_drag()
            self._robot.drag(self._robot.targets.goals)
            self._robot.end_drag()

    @Slot(bool)
    def _on_limits_toggled(self, shown: bool) -> None:
        self._table.show_limits(shown=shown)
