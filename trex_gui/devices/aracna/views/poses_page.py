"""Poses, sequences and gaits beside the robot that plays them."""

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QHBoxLayout, QLabel, QVBoxLayout, QWidget

from trex_gui.devices.aracna.model.library import Library
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.model.targets import CENTRE
from trex_gui.devices.aracna.views.poses.panel import PosesPanel
from trex_gui.devices.aracna.views.robot.drawing import RobotDrawing
from trex_gui.devices.aracna.views.robot.words import assumed_text, why_not_move


class PosesPage(QWidget):
    """Lets the panel know of the robot, and the robot do what is asked for there."""

    def __init__(self, robot: Robot, library: Library, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("aracnaPosesPage")
        self._robot = robot
        self.panel = PosesPanel(library, robot.notifier, self)
        drawing = RobotDrawing(robot, self)
        drawing.setObjectName("aracnaPosesDrawing")
        footnote = QLabel(f"* {assumed_text()}", self)
        footnote.setObjectName("aracnaPosesFootnote")
        footnote.setWordWrap(True)
        footnote.setForegroundRole(footnote.palette().ColorRole.PlaceholderText)

        layout = QHBoxLayout(self)
        layout.setSpacing(16)
        left = QVBoxLayout()
        left.addWidget(drawing, 1)
        left.addWidget(footnote)
        left.addStretch(0)
        layout.addLayout(left, 1)
        layout.addWidget(self.panel, 4)

        drawing.pointed.connect(drawing.mark)
        self.panel.go_to_requested.connect(self._on_go_to_requested)
        self.panel.play_requested.connect(robot.play)
        self.panel.scale_changed.connect(robot.set_time_scale)
        robot.changed.connect(self._on_changed)
        robot.link_changed.connect(self._on_changed)
        robot.limits.changed.connect(self._on_changed)
        self._on_changed()

    @Slot(object)
    def _on_go_to_requested(self, positions: tuple[int, ...]) -> None:
        """Go to a pose; what it says nothing of goes to the centre."""
        motors = self._robot.motors
        self._robot.move((*positions, *(CENTRE,) * motors)[:motors])

    @Slot()
    def _on_changed(self) -> None:
        robot = self._robot
        why = why_not_move(robot)
        self.panel.show_link(not why, why)
        self.panel.show_present(robot.present)
        self.panel.show_limits(robot.limits.first(robot.motors))
        self.panel.show_playing(robot.playing)
