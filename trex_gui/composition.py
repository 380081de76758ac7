"""The one place where models and window are put together."""

from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QCoreApplication, Qt

from trex_gui.core.timing import Timeouts
from trex_gui.devices.aracna.discovery.prober import SEEK_ARACNA
from trex_gui.devices.aracna.model.controller import ARACNA, AracnaWay
from trex_gui.devices.aracna.model.library import Library
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.views.workspace import AracnaDesk
from trex_gui.devices.trex.model.connector import Connector
from trex_gui.devices.trex.model.controller import TrexWay
from trex_gui.devices.trex.model.device import Device, Link
from trex_gui.devices.trex.views.workspace import TrexDesk
from trex_gui.ui.devices.device_kind import TREX
from trex_gui.ui.devices.device_manager import Switchboard
from trex_gui.ui.devices.ports import Ports
from trex_gui.ui.frame.connection_bar import ConnectionBar
from trex_gui.ui.frame.main_window import MainWindow
from trex_gui.ui.workers import orphaned_threads


@dataclass(slots=True)
class Program:
    """A window and what lies under it."""

    device: Device
    ports: Ports
    connector: Connector
    switchboard: Switchboard
    desk: TrexDesk
    robot: Robot
    robot_way: AracnaWay
    library: Library
    aracna: AracnaDesk
    window: MainWindow
    timeouts: Timeouts

    def connect_to_demo(self, device: str) -> None:
        """Connect to the simulated device of a kind; see `model.kinds`."""
        self.switchboard.connect_to(self.ports.demo_of(device))

    def connect_to_port(self, url: str, device: str | None = None) -> None:
        """Connect to a port; where `device` is given it leads to that kind from now on."""
        port = self.ports.add_typed(url)
        if device is not None:
            port = self.ports.lead_to(port, device)
        self.switchboard.connect_to(port)

    def open_when_connected(self, path: Path) -> None:
        """Open a settings file as soon as a board answers, once."""

        def open_once() -> None:
            if self.device.link is Link.UP:
                self.device.state_changed.disconnect(open_once)
                self.desk.files.open_file(path)

        self.device.state_changed.connect(open_once)

    def open_named(self, path: Path, *, connecting: bool) -> None:
        """Open a file that was named at the start, where it belongs.

        Settings wait for the board where one is being connected to; see `open_when_connected`.
        """
        current = self.switchboard.current.kind
        if any(path.suffix.lower() in kind.suffixes for kind in self.aracna.file_kinds):
            if connecting and current != ARACNA:  # its connecting takes messages away, once
                self.desk.settled.connect(
                    lambda: self.window.open_file(path), Qt.ConnectionType.SingleShotConnection
                )
            else:
                self.window.open_file(path)
        elif connecting and current == TREX:
            self.open_when_connected(path)
        else:
            self.desk.files.edit_file(path)

    def stop_now(self, *, ending: bool = False) -> None:
        """Stop every device, from any thread; see `Device.stop_now` and `Robot.halt_now`."""
        self.device.stop_now(ending=ending)
        self.robot.halt_now(ending=ending)

    def shut_down(self) -> bool:
        """Stop the motors, close the line, then end what is recorded; for the end of the program.

        Return whether every thread has ended, of whatever was going on; Qt aborts on destroying one
        that runs.
        """
        ends = [
            self.switchboard.shut_down(),
            self.desk.recordings.shut_down(),
            self.aracna.recordings.shut_down(),
        ]
        return all(ends) and not orphaned_threads.any_running()

    def end(self) -> None:
        """Stop the motors, close the line and leave, without asking anything."""
        self.switchboard.shut_down()
        QCoreApplication.exit(0)


def build(timeouts: Timeouts | None = None) -> Program:
    """Make the models and the window; nothing is connected yet."""
    timeouts = timeouts or Timeouts()
    device = Device()
    robot = Robot()
    ports = Ports(kinds=(TREX, ARACNA))
    connector = Connector(device, ports, timeouts=timeouts)
    way = AracnaWay(robot, ports, connector.finder, robot, timeouts=timeouts)
    connector.finder.also(ARACNA.key, SEEK_ARACNA, way.simulator, way.demo_name)
    switchboard = Switchboard([TrexWay(device, connector, device), way])
    window = MainWindow(switchboard)
    desk = TrexDesk(device, connector, window.question, window)
    library = Library(robot)
    aracna = AracnaDesk(robot, library, way, window)
    window.furnish(ConnectionBar(switchboard, device, ports, connector, window), [desk, aracna])
    return Program(
        device, ports, connector, switchboard, desk, robot, way, library, aracna, window, timeouts
    )
