"""A device, the list of ports and what connects the two."""

from collections.abc import Callable, Iterator

import pytest
from pytestqt.qtbot import QtBot

from tests.support.program import new_controller, new_ports
from trex_gui.devices.trex.model.controller import TrexController
from trex_gui.devices.trex.model.device import Device
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.devices.ports import Port, Ports

Until = Callable[[Callable[[], bool]], None]
Connect = Callable[[Port], None]


@pytest.fixture
def device(qtbot: QtBot) -> Device:
    return Device()


@pytest.fixture
def ports(qtbot: QtBot) -> Iterator[Ports]:
    ports = new_ports()
    yield ports
    ports.deleteLater()


@pytest.fixture
def connector(device: Device, ports: Ports) -> Iterator[TrexController]:
    connector = new_controller(device, ports)
    yield connector
    connector.shut_down()


@pytest.fixture
def until(qtbot: QtBot) -> Until:
    return qtbot.waitUntil


@pytest.fixture
def connect(connector: TrexController, device: Device, until: Until) -> Connect:
    """Connect to a board that responds."""

    def connect(port: Port) -> None:
        connector.connect_to(port)
        until(lambda: device.link is ConnectionState.CONNECTED)

    return connect
