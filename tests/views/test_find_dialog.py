"""Which ports Find offers, and when."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QListWidget, QPushButton, QWidget
from pytestqt.qtbot import QtBot
from serial.tools.list_ports_common import ListPortInfo

from trex_gui.model.connector import Connector
from trex_gui.model.device import Device
from trex_gui.model.ports import Ports
from trex_gui.model.switchboard import Switchboard
from trex_gui.model.trex_way import TrexWay
from trex_gui.views.find_dialog import FindDialog


def port_of_this_computer(name: str, description: str) -> ListPortInfo:
    port = ListPortInfo(name)
    port.description = description
    return port


@pytest.fixture
def listed(monkeypatch: pytest.MonkeyPatch) -> list[ListPortInfo]:
    found = [port_of_this_computer("/dev/ttyUSB0", "An adapter")]
    monkeypatch.setattr("serial.tools.list_ports.comports", lambda: found)
    return found


@pytest.fixture
def ports(qtbot: QtBot, listed: list[ListPortInfo]) -> Iterator[Ports]:
    ports = Ports()
    yield ports
    ports.deleteLater()


@pytest.fixture
def dialog(qtbot: QtBot, ports: Ports) -> Iterator[FindDialog]:
    device = Device()
    connector = Connector(device, ports)
    dialog = FindDialog(Switchboard([TrexWay(device, connector)]), ports, connector)
    qtbot.addWidget(dialog)
    yield dialog
    connector.shut_down()


def rows(dialog: QWidget) -> dict[str, bool]:
    """Return the text of each port that is offered, and whether it is ticked."""
    ports = dialog.findChild(QListWidget, "findPorts")
    assert ports is not None
    items = [ports.item(row) for row in range(ports.count())]
    return {item.text(): item.checkState() is Qt.CheckState.Checked for item in items}


def start_button(dialog: QWidget) -> QPushButton:
    button = dialog.findChild(QPushButton, "findStartButton")
    assert button is not None
    return button


def test_every_port_of_this_computer_is_ticked(dialog: FindDialog) -> None:
    assert rows(dialog) == {"/dev/ttyUSB0  (An adapter)": True}
    assert start_button(dialog).isEnabled()


def test_addresses_of_a_network_are_offered_and_not_ticked(
    dialog: FindDialog, ports: Ports
) -> None:
    ports.add_typed("socket://somewhere:1")
    ports.add_typed("/dev/pts/99")
    assert rows(dialog) == {
        "/dev/ttyUSB0  (An adapter)": True,
        "socket://somewhere:1": False,
        "/dev/pts/99": True,
    }


def test_ticks_stay_when_ports_come_and_go(
    dialog: FindDialog, ports: Ports, listed: list[ListPortInfo]
) -> None:
    offered = dialog.findChild(QListWidget, "findPorts")
    assert offered is not None
    offered.item(0).setCheckState(Qt.CheckState.Unchecked)
    assert not start_button(dialog).isEnabled()
    listed.append(port_of_this_computer("/dev/ttyUSB1", "n/a"))
    ports.refresh()
    assert rows(dialog) == {"/dev/ttyUSB0  (An adapter)": False, "/dev/ttyUSB1": True}
    assert start_button(dialog).isEnabled()


def test_without_ports_nothing_can_be_started(
    dialog: FindDialog, ports: Ports, listed: list[ListPortInfo]
) -> None:
    listed.clear()
    ports.refresh()
    assert rows(dialog) == {}
    assert not start_button(dialog).isEnabled()
