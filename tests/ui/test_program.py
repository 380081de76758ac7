"""Creation, completion and destruction of the program."""

import gc
import subprocess
import sys
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
import shiboken6
from PySide6.QtCore import QCoreApplication, QEvent, QObject, QSettings, Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QDockWidget, QLabel, QStyle, QWidget
from pytestqt.qtbot import QtBot

from tests.support.program import trex
from tests.support.simulator import SimulatedDevice, StartSimulator
from trex_gui.composition import build
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.notifier import Remedy
from trex_gui.ui.program import Program
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.units import units

_EMBEDDING = """
from PySide6.QtWidgets import QApplication
from tests.support.program import trex
from trex_gui.composition import build
app = QApplication([])
program = build()
program.window.show()
program.complete()
program.connect_to_demo("trex")
while trex(program).device.telemetry.raw is None:
    app.processEvents()
assert program.close()
"""


def _objects() -> set[QObject]:
    """Return all Qt objects known to Python, except styles that Qt retains."""
    wrappers = shiboken6.getAllValidWrappers()
    return {each for each in wrappers if isinstance(each, QObject) and not isinstance(each, QStyle)}


def _use(qtbot: QtBot, url: str, settings: Path) -> None:
    program = build()
    program.window.show()
    program.complete()
    program.open_file(settings, connecting=False)
    program.window.show_help("safety.md")
    device = trex(program).device
    device.connect_to(ConnectionSettings(url))
    qtbot.waitUntil(lambda: device.link is ConnectionState.CONNECTED)
    assert program.close()


def test_close_destroys_every_qt_object(
    qtbot: QtBot, quick_simulator: SimulatedDevice, tmp_path: Path
) -> None:
    settings = tmp_path / "rover.txt"
    settings.write_text("product: TReX\n", encoding="utf-8")
    before = {theme(), units(), *_objects()}
    _use(qtbot, quick_simulator.url, settings)
    gc.collect()  # frees the preferences, which Python owns
    assert _objects() - before == set()


@pytest.fixture
def new_program(qtbot: QtBot) -> Iterator[Program]:
    """Program whose window has not been painted yet."""
    program = build()
    yield program
    assert program.close()


def _pages(program: Program) -> set[str]:
    names = ("boardPage", "motorsPage", "parametersPage", "aracnaRobotPage")
    return {name for name in names if program.window.findChild(QWidget, name) is not None}


def test_pages_and_plots_are_created_when_first_shown(new_program: Program) -> None:
    assert _pages(new_program) == {"boardPage"}
    tabs = new_program.window.pages
    titles = [tabs.tabText(index) for index in range(tabs.count())]
    assert titles == ["Board", "Channels", "Motors", "Currents", "Parameters", "Diagnostics"]
    tabs.setCurrentIndex(2)
    assert _pages(new_program) == {"boardPage", "motorsPage"}
    new_program.connect_to_demo("trex")
    assert _pages(new_program) == {"boardPage", "motorsPage"}
    new_program.complete()
    assert _pages(new_program) == {"boardPage", "motorsPage", "parametersPage"}
    assert [tabs.tabText(index) for index in range(tabs.count())] == titles
    assert tabs.currentIndex() == 2
    assert new_program.window.findChild(QWidget, "curvePlot") is None
    new_program.create_plots()
    assert new_program.window.findChild(QWidget, "curvePlot") is not None


def test_unused_device_kind_can_be_found_and_connected(
    new_program: Program, start_simulator: StartSimulator, qtbot: QtBot
) -> None:
    robot = start_simulator("--aracna", "--unpaced")
    port, scanner = new_program.ports.add_typed(robot.url), new_program.device_manager.scanner
    scanner.start([port])
    qtbot.waitUntil(lambda: not scanner.running, timeout=60_000)
    (finding,) = scanner.findings
    assert finding.device == "aracna"
    assert "aracnaRobotPage" not in _pages(new_program)
    new_program.connect_to_demo("aracna")
    assert "aracnaRobotPage" in _pages(new_program)
    assert new_program.window.pages is new_program.workspace("aracna").pages


def test_file_of_an_unused_kind_shows_the_workspace(new_program: Program, tmp_path: Path) -> None:
    path = tmp_path / "poses.ppr"
    path.write_text("", encoding="ascii")
    new_program.window.files.open_file(path)
    assert new_program.device_manager.current.plugin.key == "aracna"


def _panel(program: Program, name: str) -> QDockWidget:
    panel = program.window.findChild(QDockWidget, name)
    assert isinstance(panel, QDockWidget)
    return panel


def test_first_use_of_a_device_kind_retains_layout_and_message(
    new_program: Program, qtbot: QtBot
) -> None:
    window, left = new_program.window, Qt.DockWidgetArea.LeftDockWidgetArea
    panel = _panel(new_program, "demoPanel")
    QSettings().setValue("window/state", window.saveState())
    window.addDockWidget(left, panel)
    banner = window.findChild(QLabel, "bannerText")
    assert isinstance(banner, QLabel)
    new_program.device_manager.stop_because("The computer was suspended", (Remedy.REPORT,))
    qtbot.waitUntil(lambda: "suspended" in banner.text())
    assert len(new_program.workspaces) == 2
    assert window.dockWidgetArea(panel) is left
    assert "suspended" in banner.text()

    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    actions = window.findChildren(QAction, options=Qt.FindChildOption.FindDirectChildrenOnly)
    names = [action.objectName() for action in actions if action.objectName()]
    assert len(names) == len(set(names)), "each menu entry has one action"
    assert {"stopAction", "openAction", "aracna_openAction"} <= set(names)


@pytest.mark.usefixtures("qapp")
def test_panel_of_an_unused_device_kind_retains_its_position() -> None:
    left = Qt.DockWidgetArea.LeftDockWidgetArea
    for is_used in (True, False, True):
        program = build()
        if is_used:
            panel = _panel(program, "aracnaDemoPanel") if len(program.workspaces) == 2 else None
            assert panel is not None
            if not QSettings().contains("window/state"):
                program.window.addDockWidget(left, panel)
            assert program.window.dockWidgetArea(panel) is left
        assert program.window.close()
        assert program.close()


@pytest.mark.realtime
@pytest.mark.slow
@pytest.mark.timeout(180)
def test_embedding_processes_end_without_crash() -> None:
    """Without `close`, one of six processes crashes."""
    count = 12

    def embed(_: int) -> subprocess.CompletedProcess[str]:
        command = [sys.executable, "-c", _EMBEDDING]
        return subprocess.run(command, capture_output=True, text=True, timeout=80, check=False)

    with ThreadPoolExecutor(2) as pool:
        results = list(pool.map(embed, range(count)))
    assert [result.returncode for result in results] == [0] * count, results
    assert not any("Traceback" in result.stderr for result in results), results
