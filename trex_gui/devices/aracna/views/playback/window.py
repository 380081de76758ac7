"""The window that shows the recording of a robot: how it stood at any time, and what happened."""

from PySide6.QtCore import QCoreApplication, Slot
from PySide6.QtWidgets import QLabel, QSizePolicy, QVBoxLayout, QWidget

from trex_gui.devices.aracna.model.playback import RobotPlayback
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.protocol.units import MOTORS
from trex_gui.devices.aracna.views.playback.shown import RecordedRobot
from trex_gui.devices.aracna.views.playback.values import JointValues
from trex_gui.devices.aracna.views.playback.words import doing_text
from trex_gui.devices.aracna.views.robot.drawing import RobotDrawing
from trex_gui.devices.aracna.views.robot.words import assumed_text
from trex_gui.devices.aracna.views.stop_button import StopSequenceButton
from trex_gui.ui.playback.window import RecordingWindow
from trex_gui.ui.widgets.note import Note
from trex_gui.ui.widgets.scroll_box import ScrollBox


class RobotPlaybackWindow(RecordingWindow):
    """One recording of a robot. The stop button is that of the robot that is connected."""

    def __init__(
        self, playback: RobotPlayback, robot: Robot, parent: QWidget | None = None
    ) -> None:
        super().__init__(playback, "aracnaPlayback", _plot_name(), parent)
        self._playback = playback
        self._recorded = RecordedRobot(playback, self)

        self._doing = Note(3, self)
        self._doing.setObjectName("aracnaRecordedDoing")
        self._doing.setAccessibleName(self.tr("What the robot did"))
        self._robot_drawing = RobotDrawing(self._recorded, self)
        caption = QLabel(
            self.tr("Full lines: as last reported; dashed: goal.") + f"\n* {assumed_text()}", self
        )
        caption.setObjectName("aracnaRecordedCaption")
        caption.setWordWrap(True)
        caption.setForegroundRole(caption.palette().ColorRole.PlaceholderText)
        caption.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        caption.setMinimumHeight(
            caption.heightForWidth(self._robot_drawing.minimumSizeHint().width())
        )
        self._joints = JointValues(self._recorded, self)
        more = playback.header.motors > MOTORS  # as many as the published robot have room
        beside = QWidget(self)
        column = QVBoxLayout(beside)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self._doing)
        column.addWidget(self._robot_drawing, 1)
        column.addWidget(caption)

        self._recorded.changed.connect(self._on_recorded_changed)
        self._robot_drawing.pointed.connect(self._on_pointed)
        self._robot_drawing.chosen.connect(self._joints.focus)
        self._joints.toggled.connect(self._on_toggled)
        self.arrange(
            StopSequenceButton(robot, "aracnaPlaybackStopButton", self),
            [],
            below_plot=ScrollBox(self._joints, self) if more else self._joints,
            above_events=beside,
        )
        self._on_recorded_changed()

    @property
    def playback(self) -> RobotPlayback:
        """The recording that is shown."""
        return self._playback

    def of_what(self) -> str:
        header = self._playback.header
        text = self.tr("Aracna, firmware {0}, {1} motors")
        return text.format(header.version, header.motors)

    def take_curves(self) -> None:
        hidden = {trace.name for trace in self._playback.traces.traces} - self.plot.shown
        super().take_curves()
        for name in hidden:
            self.plot.set_shown(name, shown=False)

    @Slot()
    def _on_recorded_changed(self) -> None:
        text, alarming = doing_text(self._recorded.moment, self._recorded.position)
        self._doing.show_note(text, alarming=alarming)

    @Slot(int)
    def _on_pointed(self, motor: int) -> None:
        marked = motor if motor >= 0 else None
        self._robot_drawing.mark(marked)
        self._joints.mark(marked)

    @Slot(int, bool)
    def _on_toggled(self, motor: int, on: bool) -> None:
        self.plot.set_shown(self._playback.traces.traces[motor].name, shown=on)


def _plot_name() -> str:
    words = "Plot of the motors' positions against time"
    return QCoreApplication.translate("RobotPlaybackWindow", words)
