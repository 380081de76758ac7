"""The servos of the simulated robot, a row each: where they really are, and what ails them."""

from PySide6.QtCore import QObject, Slot
from PySide6.QtWidgets import QCheckBox, QLabel, QWidget

from trex_gui.devices.aracna.model.demo_robot import DemoRobot
from trex_gui.devices.aracna.model.demo_snapshot import DemoServo, RobotSnapshot
from trex_gui.devices.aracna.protocol.units import HIGHEST, MOTORS
from trex_gui.devices.aracna.views.demo.gauge import ServoGauge
from trex_gui.devices.aracna.views.demo.words import servo_text, tr
from trex_gui.devices.aracna.views.robot.words import spoken_joint
from trex_gui.ui.devices.demo.rows import Columns, Rows
from trex_gui.ui.widgets.sliders import StickSlider

_STEP, _PAGE = 5, 20  # per cent of the speed
_LEAST = 44  # pixels of a slider


class ServoRow(QObject):
    """One servo."""

    def __init__(self, motor: int, robot: DemoRobot, rows: "DemoServos") -> None:
        super().__init__(rows)
        self._motor = motor
        self._robot = robot
        spoken = spoken_joint(motor)

        self.gauge = ServoGauge(rows)
        self.gauge.setObjectName(f"aracnaDemoGauge{motor}")
        self._where = QLabel(rows)
        self._where.setObjectName(f"aracnaDemoWhere{motor}")
        self._spoken = self.tr("{0}: where it really is").format(spoken)
        self.load = StickSlider(0, 100, 0, "bar", rows)
        self.load.setObjectName(f"aracnaDemoLoad{motor}")
        self.load.setSingleStep(_STEP)
        self.load.setPageStep(_PAGE)
        self.load.setMinimumWidth(_LEAST)
        self.load.setAccessibleName(self.tr("{0}: slowed by a load, in per cent").format(spoken))
        self.dead = QCheckBox(rows)
        self.dead.setObjectName(f"aracnaDemoDead{motor}")
        self.dead.setAccessibleName(self.tr("{0}: dead").format(spoken))
        self.dead.setToolTip(
            self.tr(
                "{0} neither hears nor answers, as with its cable off: speeds come back as −1, "
                "and a move waits for it for ever"
            ).format(spoken)
        )
        self.blocked = QCheckBox(rows)
        self.blocked.setObjectName(f"aracnaDemoBlocked{motor}")
        self.blocked.setAccessibleName(self.tr("{0}: blocked").format(spoken))
        self.blocked.setToolTip(
            self.tr("Something holds {0}: it stays “moving”, and the firmware waits").format(spoken)
        )

        name = rows.add_row(
            f"<b>{motor}</b>", self.gauge, self._where, (self.load, self.dead, self.blocked)
        )
        name.setToolTip(spoken)
        name.setBuddy(self.load)
        self._show_load()

        self.load.valueChanged.connect(self._on_load_moved)
        self.dead.clicked.connect(self._on_dead_clicked)
        self.blocked.clicked.connect(self._on_blocked_clicked)

    def show_servo(self, servo: DemoServo, *, powered: bool) -> None:
        """Show the servo as it is."""
        self.gauge.show_servo(servo.position, servo.goal, holds=servo.torque)
        self._where.setText(str(servo.position))
        text = servo_text(servo, powered)
        for widget in (self.gauge, self._where):
            widget.setToolTip(text)
            widget.setAccessibleName(self._spoken)
            widget.setAccessibleDescription(text)
        self.load.follow(round(servo.load * 100))
        self._show_load()
        self.dead.setChecked(servo.dead)
        self.blocked.setChecked(servo.blocked)

    def _show_load(self) -> None:
        text = self.tr("It loses {0} % of its speed; at the right end it stands").format(
            self.load.value()
        )
        self.load.setToolTip(text)
        self.load.setAccessibleDescription(text)

    @Slot(int)
    def _on_load_moved(self, per_cent: int) -> None:
        self._show_load()
        self._robot.set_load(self._motor, per_cent / 100)

    @Slot(bool)
    def _on_dead_clicked(self, dead: bool) -> None:
        self._robot.set_dead(self._motor, dead)

    @Slot(bool)
    def _on_blocked_clicked(self, blocked: bool) -> None:
        self._robot.set_blocked(self._motor, blocked)


class DemoServos(Rows[RobotSnapshot]):
    """A row a servo; a robot in the simulator has eight."""

    def __init__(self, robot: DemoRobot, parent: QWidget | None = None) -> None:
        headings = (tr("Slowed"), tr("Dead"), tr("Blocked"))
        super().__init__(Columns("0", str(HIGHEST), headings), parent)
        self.setTitle(self.tr("Servos"))

        self.add_headings(self.tr("Really at"), *headings, over_value=True)
        self._rows = [ServoRow(motor, robot, self) for motor in range(MOTORS)]

    def show_snapshot(self, snapshot: RobotSnapshot) -> None:
        """Show every servo."""
        for row, servo in zip(self._rows, snapshot.servos, strict=False):
            row.show_servo(servo, powered=snapshot.servo_power)

    def controls(self) -> list[QWidget]:
        """Return everything that takes the focus, in the order of Tab."""
        return [widget for row in self._rows for widget in (row.load, row.dead, row.blocked)]
