"""Ports and results in the Find dialog."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QAbstractButton
from pytestqt.qtbot import QtBot
from serial.tools.list_ports_common import ListPortInfo

from tests.support.pages.find_dialog import FindBoardDialog
from tests.support.program import new_controller, scanner_of
from tests.ui.devices.test_ports import port
from trex_gui.devices.trex.discovery import FoundBoard
from trex_gui.devices.trex.plugin import TREX
from trex_gui.devices.trex.protocol.commands import Signature
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.ui.devices.device_manager import DeviceManager
from trex_gui.ui.devices.ports import Ports
from trex_gui.ui.devices.scanner import ScanFinding
from trex_gui.ui.frame.find_dialog import FindDialog


@pytest.fixture
def ports(qtbot: QtBot, computer: list[ListPortInfo]) -> Iterator[Ports]:
    computer.append(port("/dev/ttyUSB0", "An adapter"))
    ports = Ports([TREX])
    yield ports
    ports.deleteLater()


@pytest.fixture
def dialog(qtbot: QtBot, ports: Ports) -> Iterator[FindBoardDialog]:
    controller = new_controller(ports)
    manager = DeviceManager({"trex": lambda: controller}, scanner_of(controller))
    dialog = FindDialog(manager, ports, lambda then: then())
    qtbot.addWidget(dialog)
    yield FindBoardDialog(dialog, manager.scanner, qtbot)
    manager.shut_down()


def test_network_addresses_are_listed_but_not_checked(
    dialog: FindBoardDialog, ports: Ports
) -> None:
    ports.add_typed("socket://somewhere:1")
    ports.add_typed("/dev/pts/99")
    assert dialog.rows() == {
        "/dev/ttyUSB0  (An adapter)": True,
        "socket://somewhere:1": False,
        "/dev/pts/99": True,
    }


def test_check_marks_survive_a_refresh(
    dialog: FindBoardDialog, ports: Ports, computer: list[ListPortInfo]
) -> None:
    dialog.ports()[0].setCheckState(Qt.CheckState.Unchecked)
    assert not dialog.is_enabled("findStartButton")
    computer.append(port("/dev/ttyUSB1"))
    ports.refresh()
    assert dialog.rows() == {"/dev/ttyUSB0  (An adapter)": False, "/dev/ttyUSB1": True}
    assert dialog.is_enabled("findStartButton")
    computer.clear()
    ports.refresh()
    assert dialog.rows() == {}
    assert not dialog.is_enabled("findStartButton")


def test_selected_port_is_listed_first(
    dialog: FindBoardDialog, ports: Ports, computer: list[ListPortInfo]
) -> None:
    computer.append(port("/dev/ttyUSB1"))
    ports.refresh()
    assert isinstance(dialog.root, FindDialog)
    dialog.root.open_dialog(ports.find("/dev/ttyUSB1"))
    assert list(dialog.rows()) == ["/dev/ttyUSB1", "/dev/ttyUSB0  (An adapter)"]


def test_ports_with_boards_are_listed_first(dialog: FindBoardDialog, ports: Ports) -> None:
    first = ports.entries[0]
    failed = ScanFinding(first, "No TReX responds.", command="sudo usermod -aG dialout ada")
    signature = Signature(device_table().model("trex"), "1.2")
    found = FoundBoard(ConnectionSettings("/dev/ttyUSB1"), signature)
    board = ScanFinding(first, "TReX 1.2", found, "trex")
    dialog.root.show()
    dialog.finder.findings = (failed,)
    dialog.finder.changed.emit()
    dialog.wait(lambda: dialog.has("findText0"))
    dialog.finder.findings = (failed, board)
    dialog.finder.changed.emit()
    dialog.wait(lambda: dialog.has("findText0"))
    assert dialog.text("findText0") == "TReX 1.2"
    assert dialog.text("findText1") == "No TReX responds."
    assert dialog.has("findText1")
    dialog.click("copyCommand1")
    assert QGuiApplication.clipboard().text() == "sudo usermod -aG dialout ada"
    assert not dialog.root.findChild(QAbstractButton, "copyCommand0")
