"""The drawing of the robot and what there is to say of it, where there is room for them."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QLabel, QSizePolicy, QVBoxLayout, QWidget

from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.views.robot.drawing import RobotDrawing
from trex_gui.devices.aracna.views.robot.words import assumed_text

_CAPTION_LINES = 6
_LEAST = 130
"""Pixels of width below which the circles of the joints lie on one another."""


class Sketch(QWidget):
    """As wide as what stands beside it leaves it; it needs no room, and goes where there is none.

    It is never what makes the page high: else it would come and go with a scroll bar.
    """

    def __init__(self, robot: Robot, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self.drawing = RobotDrawing(robot, self)
        self._caption = QLabel(
            self.tr("Full lines: as last reported; dashed: goal. A sketch: angles are drawn flat.")
            + f"\n* {assumed_text()}",
            self,
        )
        self._caption.setObjectName("aracnaCaption")
        self._caption.setWordWrap(True)
        self._caption.setForegroundRole(self._caption.palette().ColorRole.PlaceholderText)
        self._caption.setAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop)
        self._caption.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)

        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.drawing, 1)
        layout.addWidget(self._caption)
        layout.addStretch(0)

    def fit(self, room: int) -> None:
        """Be there where `room`, in pixels of width, is enough for a sketch."""
        self.setVisible(room >= _LEAST)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Let nothing of the caption be cut, however often it wraps."""
        super().resizeEvent(event)
        lines = _CAPTION_LINES * self._caption.fontMetrics().lineSpacing()
        needed = self._caption.heightForWidth(self.width())
        self._caption.setMinimumHeight(max(lines, needed))
