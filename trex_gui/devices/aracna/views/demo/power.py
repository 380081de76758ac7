"""The switches of the simulated robot: board, servos, and the board's reset line."""

from PySide6.QtWidgets import QCheckBox, QPushButton, QWidget

from trex_gui.devices.aracna.model.demo_robot import DemoRobot
from trex_gui.devices.aracna.model.demo_snapshot import RobotSnapshot
from trex_gui.devices.aracna.views.demo.words import columns, power_text
from trex_gui.ui.devices.demo.rows import Rows, side_by_side
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.widgets.labels import Note


class RobotPower(Rows[RobotSnapshot]):
    """Power of all, power of the servos, and what restarts the firmware."""

    def __init__(self, robot: DemoRobot, parent: QWidget | None = None) -> None:
        super().__init__(columns(), parent)
        self.setTitle(self.tr("Power"))

        self._power = QCheckBox(self.tr("Robot on"), self)
        self._power.setObjectName("aracnaDemoPower")
        self._power.setAccessibleName(self.tr("Robot switched on"))
        self._power.setToolTip(self.tr("The robot's own switch: board and servos"))
        self._restart = QPushButton(self.tr("Restart board"), self)
        self._restart.setObjectName("aracnaDemoRestart")
        self._restart.setToolTip(
            self.tr("The reset line: the firmware begins anew, the servos go on to their goals")
        )
        set_icon(self._restart, "reload")
        self._servos = QCheckBox(self.tr("Servo power"), self)
        self._servos.setObjectName("aracnaDemoServoPower")
        self._servos.setAccessibleName(self.tr("Servo power"))
        self._servos.setToolTip(
            self.tr(
                "The power of the servos alone: off, they stop where they are, hold nothing and "
                "forget their speeds; the firmware waits for them"
            )
        )
        self._hint = Note(2, self)
        self._hint.setObjectName("aracnaDemoPowerHint")

        self.add_wide(side_by_side(self, (self._power, 1), (self._restart, 0)))
        self.add_wide(self._servos)
        self.add_wide(self._hint)

        self._power.clicked.connect(robot.set_power)
        self._restart.clicked.connect(robot.restart)
        self._servos.clicked.connect(robot.set_servo_power)

    def show_snapshot(self, snapshot: RobotSnapshot) -> None:
        """Show the switches as they are."""
        self._power.setChecked(snapshot.power)
        self._servos.setChecked(snapshot.servo_power)
        self._restart.setEnabled(snapshot.power)
        self._servos.setEnabled(snapshot.power)
        text, alarming = power_text(snapshot)
        self._hint.show_note(text, alarming=alarming)

    def controls(self) -> list[QWidget]:
        """Return everything that takes the focus, in the order of Tab."""
        return [self._power, self._restart, self._servos]
