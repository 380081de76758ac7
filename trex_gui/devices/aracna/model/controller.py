"""Controller of an Aracna."""

from trex_gui.core.plugin import DevicePlugin
from trex_gui.core.timing import Timeouts
from trex_gui.core.transport.settings import PortSettings
from trex_gui.devices.aracna.model.demo import DemoRobot
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.session.client import LINE
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.devices.controller import DeviceController
from trex_gui.ui.devices.ports import Ports
from trex_gui.ui.devices.scanner import DeviceScanner
from trex_gui.ui.notifier import Notifier


class AracnaController(DeviceController[PortSettings]):
    """Controller of an Aracna. After a stop, nothing more is sent, but a motion continues."""

    def __init__(
        self,
        plugin: DevicePlugin,
        notifier: Notifier,
        ports: Ports,
        scanner: DeviceScanner,
        timeouts: Timeouts,
    ) -> None:
        self.robot = robot = Robot(notifier)
        super().__init__(plugin, robot, ports, scanner, PortSettings("", LINE, timeouts=timeouts))
        robot.setParent(self)
        self.show_searches_in(robot.traffic)
        self.demo_robot = DemoRobot(self.simulator, self)

    @property
    def needs_stop(self) -> bool:
        robot = self.robot
        return robot.remaining() > 0 or (
            self.link is not ConnectionState.DISCONNECTED and not robot.is_at_rest
        )

    def press_stop(self) -> None:
        self.robot.halt()

    def stop_because(self, reason: str) -> str:
        return self.robot.stop_because(reason)

    def stop_now(self, *, ending: bool = False) -> None:
        self.robot.halt_now(ending=ending)
