"""The one place where models and window are put together."""

from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QCoreApplication

from trex_gui.model.connector import Connector
from trex_gui.model.device import Device, Link
from trex_gui.model.ports import Ports
from trex_gui.views.main_window import MainWindow


@dataclass(slots=True)
class Program:
    """A window and what lies under it."""

    device: Device
    ports: Ports
    connector: Connector
    window: MainWindow

    def open_when_connected(self, path: Path) -> None:
        """Open a settings file as soon as a board answers, once."""

        def open_once() -> None:
            if self.device.link is Link.UP:
                self.device.state_changed.disconnect(open_once)
                self.window.files.open_file(path)

        self.device.state_changed.connect(open_once)

    def shut_down(self) -> bool:
        """Stop the motors, close the line, then end what is recorded; for the end of the program.

        Return whether every thread has ended; Qt aborts on destroying one that runs.
        """
        is_closed = self.connector.shut_down()
        return self.window.recordings.shut_down() and is_closed

    def end(self) -> None:
        """Stop the motors, close the line and leave, without asking anything."""
        self.connector.shut_down()
        QCoreApplication.exit(0)


def build() -> Program:
    """Make the models and the window; nothing is connected yet."""
    device = Device()
    ports = Ports()
    connector = Connector(device, ports)
    return Program(device, ports, connector, MainWindow(device, ports, connector))
