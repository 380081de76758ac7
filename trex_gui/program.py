"""Models and window, put together."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QCoreApplication

from trex_gui.core.timing import Timeouts
from trex_gui.devices.aracna.discovery import ARACNA_PROBER
from trex_gui.devices.aracna.model.controller import ARACNA, AracnaController
from trex_gui.devices.aracna.model.library import Library
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.views.workspace import AracnaWorkspace
from trex_gui.devices.trex.model.connector import Connector
from trex_gui.devices.trex.model.controller import TrexController
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.views.workspace import TrexWorkspace
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.devices.device_kind import TREX
from trex_gui.ui.devices.device_manager import DeviceManager
from trex_gui.ui.devices.ports import Ports
from trex_gui.ui.frame.connection_bar import ConnectionBar
from trex_gui.ui.frame.main_window import MainWindow
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.workers import orphaned_threads


@dataclass(slots=True)
class Program:
    """A window and what lies under it."""

    device: Device
    ports: Ports
    connector: Connector
    device_manager: DeviceManager
    workspace: TrexWorkspace
    robot: Robot
    robot_way: AracnaController
    library: Library
    aracna: AracnaWorkspace
    window: MainWindow
    timeouts: Timeouts

    def connect_to_demo(self, device: str) -> None:
        """Connect to the simulated device of a kind; see `model.kinds`."""
        self.device_manager.connect_to(self.ports.demo_of(device))

    def connect_to_port(self, url: str, device: str | None = None) -> None:
        """Connect to a port; where `device` is given it leads to that kind from now on."""
        port = self.ports.add_typed(url)
        if device is not None:
            port = self.ports.lead_to(port, device)
        self.device_manager.connect_to(port)

    def open_when_connected(self, path: Path) -> None:
        """Open a settings file as soon as a board answers, once."""
        self._when_connected(lambda: self.workspace.files.open_file(path))

    def _when_connected(self, then: Callable[[], object]) -> None:
        def run_once() -> None:
            if self.device.link is ConnectionState.CONNECTED:
                self.device.state_changed.disconnect(run_once)
                then()

        self.device.state_changed.connect(run_once)

    def open_named(self, path: Path, *, connecting: bool) -> None:
        """Open a file that was named at the start, where it belongs.

        Settings wait for the board where one is being connected to; see `open_when_connected`.
        """
        current = self.device_manager.current.kind
        if any(path.suffix.lower() in kind.suffixes for kind in self.aracna.file_kinds):
            if connecting and current != ARACNA:  # its connecting takes messages away, once
                self._when_connected(lambda: self.window.open_file(path))
            else:
                self.window.open_file(path)
        elif connecting and current == TREX:
            self.open_when_connected(path)
        else:
            self.workspace.files.edit_file(path)

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
            self.device_manager.shut_down(),
            self.workspace.recordings.shut_down(),
            self.aracna.recordings.shut_down(),
        ]
        return all(ends) and not orphaned_threads.any_running()

    def end(self) -> None:
        """Stop the motors, close the line and leave, without asking anything."""
        self.device_manager.shut_down()
        QCoreApplication.exit(0)


def build(timeouts: Timeouts | None = None) -> Program:
    """Make the models and the window; nothing is connected yet."""
    timeouts = timeouts or Timeouts()
    notifier = Notifier()
    device = Device(notifier)
    robot = Robot(notifier)
    ports = Ports(kinds=(TREX, ARACNA))
    connector = Connector(device, ports, timeouts=timeouts)
    way = AracnaController(robot, ports, connector.finder, robot, timeouts=timeouts)
    connector.finder.also(ARACNA.key, ARACNA_PROBER, way.simulator, way.demo_name)
    device_manager = DeviceManager([TrexController(device, connector, device), way])
    window = MainWindow(device_manager, notifier)
    workspace = TrexWorkspace(device, connector, window.question, window)
    library = Library(robot)
    aracna = AracnaWorkspace(robot, library, way, window)
    window.add_workspaces(
        ConnectionBar(device_manager, device, ports, connector, window), [workspace, aracna]
    )
    return Program(
        device,
        ports,
        connector,
        device_manager,
        workspace,
        robot,
        way,
        library,
        aracna,
        window,
        timeouts,
    )
