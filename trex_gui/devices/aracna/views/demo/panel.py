"""The dock of the Demo Aracna: a robot in software that can be handled like a real one."""

from PySide6.QtCore import QSize
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QWidget

from trex_gui.devices.aracna.model.controller import AracnaController
from trex_gui.devices.aracna.model.demo_snapshot import RobotSnapshot
from trex_gui.devices.aracna.views.demo.cable import RobotCable
from trex_gui.devices.aracna.views.demo.power import RobotPower
from trex_gui.devices.aracna.views.demo.servos import DemoServos
from trex_gui.devices.aracna.views.demo.words import state_text
from trex_gui.ui.devices.demo.dock import DemoDock
from trex_gui.ui.devices.demo.view import DemoPanelBody
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.widgets.leds import Lamp

_MORE = 34  # pixels, of which a scroll bar may take some


class RobotPanel(DemoDock):
    """The dock of the simulated robot."""

    def __init__(self, controller: AracnaController, parent: QWidget | None = None) -> None:
        super().__init__("aracnaDemoPanel", "aracna/demo_panel", controller, parent)
        self.setWindowTitle(self.tr("Demo Aracna"))
        self.hold(DemoRobotView(controller, self))
        controller.changed.connect(self.show_if_wanted)


class DemoRobotView(DemoPanelBody[RobotSnapshot]):
    """The robot itself: LED, switches, servos, cable."""

    def __init__(self, controller: AracnaController, parent: QWidget | None = None) -> None:
        robot = controller.demo_robot
        super().__init__(robot, controller, "aracnaDemoState", parent)
        head = QWidget(self)
        self._lamp = Lamp("led_green", head)
        self._lamp.setObjectName("aracnaDemoLed")
        self._lit = QLabel(head)
        self._lit.setObjectName("aracnaDemoLedText")
        self._boots = QLabel(head)
        self._boots.setObjectName("aracnaDemoBoots")
        mend = QPushButton(self.tr("Mend all"), self)
        mend.setObjectName("aracnaDemoMend")
        mend.setToolTip(
            self.tr("Servos alive, free and unloaded, a quiet line, everything switched on")
        )
        set_icon(mend, "reload")

        line = QHBoxLayout(head)
        line.setContentsMargins(0, 0, 0, 0)
        line.addWidget(self._lamp)
        line.addWidget(self._lit, 1)
        line.addWidget(self._boots)
        groups = (RobotPower(robot, self), DemoServos(robot, self), RobotCable(robot, self))
        self.arrange(head, groups, mend)

        mend.clicked.connect(robot.mend)
        controller.changed.connect(self.renew)

    def sizeHint(self) -> QSize:
        """Little wider than it needs: the robot's pages use what they get better."""
        return QSize(self.minimumSizeHint().width() + _MORE, super().sizeHint().height())

    def absent_text(self, *, starts: bool) -> str:
        """Say that the robot does not run, or that it is being started."""
        if starts:
            return self.tr("The simulated robot is being started …")
        return self.tr("The simulated robot does not run. Press Connect.")

    def state_text(self, snapshot: RobotSnapshot) -> str:
        """Say what the firmware does, and what it waits for."""
        return state_text(snapshot)

    def show_head(self, snapshot: RobotSnapshot | None) -> None:
        """Show the LED of the board, and how often its firmware has started."""
        self._lamp.set_lit(snapshot is not None and snapshot.led)
        text = self._led_text(snapshot)
        for widget in (self._lamp, self._lit):
            widget.setAccessibleName(text)
            widget.setToolTip(self.tr("The debug LED; it blinks while the firmware boots"))
        self._lit.setText(text)
        boots = "" if snapshot is None else self.tr("Starts: {0}").format(snapshot.boots)
        self._boots.setText(boots)
        self._boots.setToolTip(self.tr("How often the firmware has started"))

    def _led_text(self, snapshot: RobotSnapshot | None) -> str:
        if snapshot is not None and snapshot.state == "booting":
            return self.tr("LED: blinks")
        lit = snapshot is not None and snapshot.led
        return self.tr("LED: on") if lit else self.tr("LED: off")
