"""What the robot has not done as it was asked, and what nobody knows yet."""

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QVBoxLayout, QWidget

from trex_gui.devices.aracna.model.event_log import joined, missed_texts, speed_texts, stuck_text
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.model.speeds import FIRST_SPEED
from trex_gui.devices.aracna.views.robot.words import speed_text as meaning
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.widgets.labels import Note


class Reports(QWidget):
    """Two lines below the joints."""

    def __init__(self, robot: Robot, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._robot = robot
        self._note = Note(2, self)
        self._note.setObjectName("aracnaReport")
        self._note.setAccessibleName(self.tr("What the robot has reported"))

        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self._note)

        robot.changed.connect(self._on_changed)
        robot.link_changed.connect(self._on_changed)
        self._on_changed()

    @Slot()
    def _on_changed(self) -> None:
        text, alarming = self._words()
        self._note.show_note(text, alarming=alarming)

    def _words(self) -> tuple[str, bool]:
        robot, known = self._robot, self._robot.known
        if robot.link in {
            ConnectionState.DISCONNECTED,
            ConnectionState.DISCONNECTING,
            ConnectionState.CONNECTING,
        }:
            return self._without_a_robot(), False
        if known.stuck is not None:
            return stuck_text(known.stuck.motor), True
        faults = missed_texts(known) + speed_texts(known)
        if faults:
            return joined(faults), True
        if known.unsure:
            return self._out_of_sight(), True
        if all(position is None for position in robot.present):
            return self._before_the_first_move(), False
        if known.moved is not None:
            text = self.tr("Every motor is where it was sent, give or take a few units.")
            return text, False
        return "", False

    def _without_a_robot(self) -> str:
        return self.tr(
            "No robot is connected. Choose its port above, or Demo Aracna to try without one; "
            "limits and goals can be set already."
        )

    def _out_of_sight(self) -> str:
        return self.tr(
            "Where the motors are is not known any more: what was sent last goes on to its goal. "
            "The answer to the next move tells it."
        )

    def _before_the_first_move(self) -> str:
        text = self.tr(
            "Where the motors are is not known before the first move: this robot tells it only "
            "in its answer to one."
        )
        if not self._robot.speeds.are_chosen:
            more = self.tr("That move goes at speed {0} ({1}), unless you choose others.").format(
                FIRST_SPEED, meaning(FIRST_SPEED)
            )
            text = f"{text} {more}"
        return text
