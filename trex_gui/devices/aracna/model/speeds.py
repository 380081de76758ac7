"""How fast each servo is to go: chosen by a person, or low at first."""

from collections.abc import Sequence

from PySide6.QtCore import QObject, Signal

from trex_gui.core.errors import BadRequest, sentence
from trex_gui.core.session.messages import Outcome
from trex_gui.devices.aracna.model.connection import RobotConnection
from trex_gui.devices.aracna.protocol.units import HIGHEST, MOTORS
from trex_gui.devices.aracna.session.messages import SetSpeeds

FIRST_SPEED = 100
"""What every servo gets before the first motion, unless a person has chosen: 67 degrees a second.

Where the motors are is not known then, and a servo that was just switched on has no speed limit.
"""


class ServoSpeeds(QObject):
    """One speed a motor, 0-1023; 0 is as fast as it can.

    Signals:
        changed: `wanted` or `are_chosen`.
        refused: why they were not set, for people.
    """

    changed = Signal()
    refused = Signal(str)

    def __init__(self, line: RobotConnection, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._line = line
        self._motors = MOTORS
        self._chosen: tuple[int, ...] | None = None
        self._asked = 0

    @property
    def wanted(self) -> tuple[int, ...]:
        """The speeds that the next motion goes with."""
        return self._chosen if self._chosen is not None else (FIRST_SPEED,) * self._motors

    @property
    def are_chosen(self) -> bool:
        """Whether a person has chosen them since the robot was connected."""
        return self._chosen is not None

    def choose(self, speeds: Sequence[int]) -> None:
        """Want others.

        Raises:
            BadRequest: too few, too many, or one out of range.
        """
        if len(speeds) != self._motors or any(not 0 <= speed <= HIGHEST for speed in speeds):
            given = ", ".join(map(str, speeds))
            raise BadRequest(f"{self._motors} speeds of 0 to {HIGHEST}, not {given}")
        self._chosen = tuple(speeds)
        self.changed.emit()

    def give(self) -> None:
        """Let the servos have them now; every motion is sent with them anyhow."""
        wanted = self.wanted
        if self._line.ask(lambda number: SetSpeeds(number, wanted), self._on_over):
            self._asked += 1

    def begin(self, motors: int) -> None:
        """Begin with a robot that nobody has chosen speeds for."""
        self._motors = motors
        self._chosen = None
        self._asked = 0
        self.changed.emit()

    def _on_over(self, outcome: Outcome) -> None:
        self._asked = max(self._asked - 1, 0)
        if outcome.error is not None and not self._asked:  # else newer ones have taken its place
            self.refused.emit(self.tr("Speeds not set: {0}").format(sentence(outcome.error)))
