"""The wire to the simulated robot, with what may get lost on it."""

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QWidget

from trex_gui.devices.aracna.model.demo_robot import DemoRobot, Loss
from trex_gui.devices.aracna.model.demo_snapshot import RobotSnapshot
from trex_gui.devices.aracna.views.demo.words import columns
from trex_gui.ui.devices.demo.cable import CableRows


class RobotCable(CableRows[RobotSnapshot]):
    """The cable, and bytes that get lost once."""

    def __init__(self, robot: DemoRobot, parent: QWidget | None = None) -> None:
        super().__init__(robot, "aracnaDemo", columns(), parent)
        self._robot = robot
        self.plugged.setToolTip(
            self.tr("Pulled out, the port is gone; a motion that runs goes on to its goal")
        )
        self.mute.setToolTip(
            self.tr("The wire back is broken: the robot hears and obeys, nothing comes back")
        )
        self.noise.setToolTip(
            self.tr(
                "This share of the bytes is spoilt on the way, either way; nothing in this "
                "protocol finds them, and a spoilt command may restart the firmware"
            )
        )
        self.mishaps.setObjectName("aracnaDemoLoss")
        self.mishaps.setAccessibleName(self.tr("What gets lost once"))
        self.mishaps.setToolTip(
            self.tr(
                "A lost byte of a command may leave too few values in it, which restarts the "
                "firmware"
            )
        )
        for text, loss in (
            (self.tr("Answer byte"), Loss.ANSWER_BYTE),
            (self.tr("Command byte"), Loss.COMMAND_BYTE),
            (self.tr("Answer: end"), Loss.ANSWER_END),
        ):
            self.mishaps.addItem(text, loss.name)
        self.once.setText(self.tr("Lose it"))
        self.once.setObjectName("aracnaDemoLose")
        self.once.setToolTip(self.tr("It gets lost from what goes over the wire next"))
        self.once.clicked.connect(self._on_lose_clicked)

    @Slot()
    def _on_lose_clicked(self) -> None:
        self._robot.lose(Loss[str(self.mishaps.currentData())])
