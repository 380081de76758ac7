"""The robot at the position of a recording, as the drawing wants one."""

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.devices.aracna.model.playback import RobotPlayback
from trex_gui.devices.aracna.model.recorded import Moment
from trex_gui.devices.aracna.model.robot_state import RobotState
from trex_gui.devices.aracna.model.targets import CENTRE


class RecordedGoals(QObject):
    """Where each joint was sent last; one that was not yet is wanted where it is.

    Signals:
        changed: one of them is another.
    """

    changed = Signal()

    def __init__(self, motors: int, parent: QObject) -> None:
        super().__init__(parent)
        self._goals = (CENTRE,) * motors

    @property
    def goals(self) -> tuple[int, ...]:
        """All of them in units, motor 0 first."""
        return self._goals

    def follow(self, known: RobotState) -> None:
        """Be those of this moment."""
        goals = known.goals
        if goals is None:
            goals = tuple(CENTRE if place is None else place for place in known.present)
        if goals != self._goals:
            self._goals = goals
            self.changed.emit()


class RecordedRobot(QObject):
    """What the robot had reported at the position of a recording; it follows the position.

    Signals:
        changed: the position is another one, or the recording was read.

    Attributes:
        targets: where each joint was sent last.
    """

    changed = Signal()

    def __init__(self, playback: RobotPlayback, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._playback = playback
        self._moment = playback.latest()
        self.targets = RecordedGoals(self.motors, self)

        playback.moved.connect(self._on_moved)
        playback.loaded.connect(self._on_moved)
        self._on_moved()

    @property
    def moment(self) -> Moment:
        """Everything that was known."""
        return self._moment

    @property
    def known(self) -> RobotState:
        """Everything that it had reported."""
        return self._moment.known

    @property
    def present(self) -> tuple[int | None, ...]:
        """Where each motor was last reported; `None` where that was not known."""
        return tuple(self.known.present)

    @property
    def motors(self) -> int:
        """How many motors it has."""
        return self._playback.header.motors

    @property
    def position(self) -> float:
        """The time that is looked at, on the session's clock."""
        return self._playback.position

    @Slot()
    def _on_moved(self) -> None:
        self._moment = self._playback.latest()
        self.targets.follow(self.known)
        self.changed.emit()
