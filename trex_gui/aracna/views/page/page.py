"""The robot: seen from above, and its joints in rows."""

from PySide6.QtCore import Qt, Slot
from PySide6.QtWidgets import QHBoxLayout, QLabel, QSizePolicy, QVBoxLayout, QWidget

from trex_gui.aracna.model.robot import Robot
from trex_gui.aracna.views.page.controls import Controls
from trex_gui.aracna.views.page.drawing import RobotDrawing
from trex_gui.aracna.views.page.joint_table import JointTable
from trex_gui.aracna.views.page.reports import Reports
from trex_gui.aracna.views.page.words import assumed_text

_CAPTION_LINES = 6


class RobotPage(QWidget):
    """Sliders are what a person wants; the robot goes there on Move, or while they are dragged."""

    def __init__(self, robot: Robot, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("aracnaRobotPage")
        self._robot = robot

        self._drawing = RobotDrawing(robot, self)
        caption = QLabel(
            self.tr("Full lines: as last reported; dashed: goal. A sketch: angles are drawn flat.")
            + f"\n* {assumed_text()}",
            self,
        )
        caption.setObjectName("aracnaCaption")
        caption.setWordWrap(True)
        caption.setForegroundRole(caption.palette().ColorRole.PlaceholderText)
        caption.setAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop)
        caption.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        caption.setMinimumHeight(_CAPTION_LINES * caption.fontMetrics().lineSpacing())
        self._table = JointTable(robot, self)
        self._reports = Reports(robot, self)
        self.controls = Controls(robot, self)

        left = QVBoxLayout()
        left.addWidget(self._drawing, 1)
        left.addWidget(caption)
        left.addStretch(0)
        right = QVBoxLayout()
        right.setSpacing(10)
        right.addWidget(self._table)
        right.addWidget(self.controls)
        right.addWidget(self._reports)
        right.addStretch(1)
        layout = QHBoxLayout(self)
        layout.setSpacing(16)
        layout.addLayout(left, 2)
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

    @Slot()
    def move_now(self) -> None:
        """Send every motor to its goal."""
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
