"""A device needs one package and one line in `composition.PLUGINS`."""

from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path

import pytest
from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QComboBox, QLabel, QStackedWidget, QWidget
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice
from trex_gui.composition import PLUGINS
from trex_gui.core.plugin import DevicePlugin, Lazy
from trex_gui.core.timing import Timeouts
from trex_gui.core.transport.settings import PortSettings, SerialFormat
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.devices.controller import DeviceController
from trex_gui.ui.devices.ports import Ports
from trex_gui.ui.devices.scanner import DeviceScanner
from trex_gui.ui.frame.main_window import MainWindow
from trex_gui.ui.frame.workspace import FileKind, PageInfo, Workspace
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.program import Program

URL = "loop://lamp"


class Lamp(QObject):
    """Model of a lamp, which is on from connection to stop."""

    link_changed = Signal()

    def __init__(self, notifier: Notifier) -> None:
        super().__init__()
        self.notifier = notifier
        self.link = ConnectionState.DISCONNECTED
        self.status = "The lamp is not connected."
        self.settings: PortSettings | None = None
        self.url = ""
        self.is_on = False

    def connect_to(self, settings: PortSettings) -> None:
        self.settings = settings
        self.url, self.is_on = settings.url, True
        self._set(ConnectionState.CONNECTED, "Connected to a lamp.")

    def disconnect_line(self) -> None:
        self.is_on = False
        self._set(ConnectionState.DISCONNECTED, "The lamp is not connected.")

    def shut_down(self) -> bool:
        return True

    def _set(self, link: ConnectionState, status: str) -> None:
        self.link, self.status = link, status
        self.link_changed.emit()


class LampController(DeviceController[PortSettings]):
    def __init__(
        self,
        plugin: DevicePlugin,
        notifier: Notifier,
        ports: Ports,
        scanner: DeviceScanner,
        timeouts: Timeouts,
    ) -> None:
        self.lamp = Lamp(notifier)
        settings = PortSettings("", SerialFormat(9600), timeouts=timeouts)
        super().__init__(plugin, self.lamp, ports, scanner, settings)

    def press_stop(self) -> None:
        self.lamp.is_on = False

    def stop_because(self, reason: str) -> str:
        was_on, self.lamp.is_on = self.lamp.is_on, False
        return f"{reason}. The lamp was switched off." if was_on else ""

    def stop_now(self, *, ending: bool = False) -> None:
        self.lamp.is_on = False


class LampWorkspace(Workspace):
    def __init__(self, controller: LampController, window: MainWindow) -> None:
        super().__init__(controller.plugin.key, controller.lamp.notifier, window.stack)
        self.bar = QWidget(self)
        self.opened: list[Path] = []
        self.add_pages([PageInfo("light", "&Light", partial(QLabel, "On"))])
        self.file_kinds = (FileKind({".lamp"}, "a scene of a lamp", self.opened.append),)


LAMP = replace(
    PLUGINS[0],
    key="lamp",
    name="Lamp",
    controller=Lazy(f"{__name__}:LampController"),
    workspace=Lazy(f"{__name__}:LampWorkspace"),
    commands={},
)


@pytest.fixture
def lamp_program(qtbot: QtBot) -> Iterator[Program]:
    program = Program((*PLUGINS, LAMP))
    program.window.show()
    yield program
    program.window.close()
    assert program.close()


def test_third_device_needs_only_its_plugin(
    lamp_program: Program, tmp_path: Path, qtbot: QtBot, quick_simulator: SimulatedDevice
) -> None:
    program, window = lamp_program, lamp_program.window
    controller, workspace = program.device_manager.controller("lamp"), program.workspace("lamp")
    assert isinstance(controller, LampController)
    assert isinstance(workspace, LampWorkspace)
    ports = window.findChild(QComboBox, "portCombo")
    assert ports is not None
    assert "Demo Lamp (no hardware)" in [ports.itemText(i) for i in range(ports.count())]

    program.connect_to_port(URL, "lamp")
    assert controller.lamp.url == URL
    stack = window.findChild(QStackedWidget)
    assert stack is not None
    assert stack.currentWidget() is workspace
    assert "Connected to a lamp" in {label.text() for label in window.findChildren(QLabel)}
    assert controller.lamp.is_on

    QTest.keyClick(window, Qt.Key.Key_Escape)
    qtbot.waitUntil(lambda: not controller.lamp.is_on)

    program.open_file(tmp_path / "evening.lamp", connecting=False)
    assert workspace.opened == [tmp_path / "evening.lamp"]

    program.connect_to_port(quick_simulator.url, "trex")
    qtbot.waitUntil(lambda: program.device_manager.current.link is ConnectionState.CONNECTED)
    assert controller.link is ConnectionState.DISCONNECTED
    assert stack.currentWidget() is program.workspace("trex")

    program.connect_to_port(URL)
    qtbot.waitUntil(lambda: controller.link is ConnectionState.CONNECTED)
    assert stack.currentWidget() is workspace, "the program knows that a lamp is at this port"
