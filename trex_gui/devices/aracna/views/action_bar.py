"""The row below the robot's pages: the red button, and how long what moves goes on."""

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QGridLayout, QLabel, QPushButton, QWidget

from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.model.robot_state import PlayState
from trex_gui.devices.aracna.views.stop_button import StopSequenceButton
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.runtime import runtime
from trex_gui.ui.widgets.labels import Note

_LOOK_MS = 100


class RobotBar(QWidget):
    """Says plainly what the button can do: end what is sent, not what moves."""

    def __init__(self, robot: Robot, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._robot = robot
        self._timer = runtime().timer(self)
        self._timer.setInterval(_LOOK_MS)

        self._stop = StopSequenceButton(robot, "aracnaStopButton", self)
        height = 2 * self.fontMetrics().height() + 4
        self._stop.setMinimumSize(4 * height, height)
        self._end = QPushButton(self.tr("End after this step"), self)
        self._end.setObjectName("aracnaEndButton")
        self._end.setToolTip(self.tr("Let the step finish, then what leads out of the sequence"))
        self._end.setMinimumHeight(height)
        self._state = Note(1, self)
        self._state.setObjectName("aracnaMotionLabel")
        self._state.setAccessibleName(self.tr("What the robot does"))
        honest = QLabel(
            self.tr(
                "This link has no stop: a motion that runs ends only by itself, or by cutting the "
                "servo power."
            ),
            self,
        )
        honest.setObjectName("aracnaHonestLabel")
        honest.setWordWrap(True)

        layout = QGridLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setVerticalSpacing(2)
        layout.addWidget(self._stop, 0, 0, 2, 1)
        layout.addWidget(self._state, 0, 1)
        layout.addWidget(honest, 1, 1)
        layout.addWidget(self._end, 0, 2, 2, 1)
        layout.setColumnStretch(1, 1)

        self._end.clicked.connect(robot.end_play)
        self._timer.timeout.connect(self._show)
        robot.changed.connect(self._on_changed)
        robot.link_changed.connect(self._on_changed)
        self._on_changed()

    @Slot()
    def _on_changed(self) -> None:
        robot = self._robot
        self._end.setEnabled(robot.playing is not None and robot.link is ConnectionState.CONNECTED)
        self._show()

    @Slot()
    def _show(self) -> None:
        left = self._robot.remaining()
        text, alarming = self._words(left)
        self._state.show_note(text, alarming=alarming)
        counts = self._robot.known.moving is not None or left > 0
        if counts != self._timer.isActive():
            self._timer.start() if counts else self._timer.stop()

    def _words(self, left: float) -> tuple[str, bool]:
        """Say what is known of the motion, which should last `left` seconds; never more."""
        robot, known = self._robot, self._robot.known
        if robot.link in {
            ConnectionState.DISCONNECTED,
            ConnectionState.DISCONNECTING,
            ConnectionState.CONNECTING,
        }:
            return self._unconnected_words(left)
        if known.stuck is not None:
            return self._stuck_text(known.stuck.motor), True
        wait = self._wait_text(left)
        if robot.playing is not None:
            return f"{self._playing_text(robot.playing)} {wait}", True
        if wait:
            return wait, True
        if robot.link is ConnectionState.NOT_RESPONDING or known.may_move_unseen:
            return self._unseen_words(left)
        return self.tr("At rest: nothing is sent."), False

    def _unseen_words(self, left: float) -> tuple[str, bool]:
        sent = self._robot.known.unsure
        if left > 0 and sent:
            text = self.tr("Not known: what was sent last may go on for about {0:.0f} s.")
        elif left > 0:
            text = self.tr("Not known: what was left running may go on for about {0:.0f} s.")
        elif sent:
            text = self.tr("Not known: what was sent last goes on to its goal.")
        else:
            text = self.tr("Nothing is sent. Whether it moves is known after its first move.")
        return text.format(max(left, 1)), sent or left > 0

    def _unconnected_words(self, left: float) -> tuple[str, bool]:
        text = self.tr("No robot is connected.")
        if left <= 0:
            return text, False
        more = self.tr("The motion goes on for about {0:.0f} s by itself.").format(max(left, 1))
        return f"{text} {more}", True

    def _stuck_text(self, motor: int | None) -> str:
        if motor is None:
            return self.tr("The robot does not answer.")
        return self.tr("Stuck: the robot waits for motor {0} and listens to nothing.").format(motor)

    def _wait_text(self, left: float) -> str:
        known = self._robot.known
        if known.moving is None:
            return ""
        if left > 0:
            return self.tr("The motion ends by itself in about {0:.1f} s.").format(left)
        return self.tr("Waiting for motor {0} to arrive …").format(known.waited_for)

    def _playing_text(self, playing: PlayState) -> str:
        if playing.step is None:
            return self.tr("The sequence begins.")
        where = self.tr("step {0} of {1}").format(playing.step + 1, playing.steps)
        if playing.name:
            where += f" “{playing.name}”"
        if playing.part == "in":
            where = self.tr("on the way in")
        elif playing.part == "out":
            where = self.tr("on the way out")
        elif playing.rounds != 1:
            often = "∞" if playing.rounds == 0 else str(playing.rounds)
            where += self.tr(", round {0} of {1}").format(playing.round + 1, often)
        return self.tr("Playing {0}.").format(where)
