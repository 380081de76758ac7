"""A device, the list of ports and what connects the two."""

from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from tests.support.program import new_controller, new_ports
from trex_gui.devices.trex.model.device import Device
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.devices.ports import Port


class ConnectorSetup:
    """A device that is not connected, a list of ports, and the controller that connects them."""

    def __init__(self, qtbot: QtBot) -> None:
        self.device = Device()
        self.ports = new_ports()
        self.connector = new_controller(self.device, self.ports)
        self.until = qtbot.waitUntil

    def until_link(self, link: ConnectionState) -> None:
        self.until(lambda: self.device.link is link)

    def connect(self, port: Port) -> None:
        """Connect to a board that responds."""
        self.connector.connect_to(port)
        self.until_link(ConnectionState.CONNECTED)

    def disconnect(self) -> None:
        self.connector.leave()
        self.until_link(ConnectionState.DISCONNECTED)


@pytest.fixture
def setup(qtbot: QtBot) -> Iterator[ConnectorSetup]:
    setup = ConnectorSetup(qtbot)
    yield setup
    setup.connector.shut_down()
    setup.ports.deleteLater()
