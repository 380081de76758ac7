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
    found = (one for one in shiboken6.getAllValidWrappers() if isinstance(one, QObject))
    return {one for one in found if not isinstance(one, QStyle)}


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


def test_close_leaves_no_qt_object(
    qtbot: QtBot, quick_simulator: SimulatedDevice, tmp_path: Path
) -> None:
    settings = tmp_path / "rover.txt"
    settings.write_text("product: TReX\n", encoding="utf-8")
    before = {theme(), units(), *_objects()}
    _use(qtbot, quick_simulator.url, settings)
    gc.collect()  # preferences are Qt objects that Python owns
    assert _objects() - before == set()


@pytest.fixture
def started(qtbot: QtBot) -> Iterator[Program]:
    """Program whose window is not painted yet."""
    program = build()
    yield program
    assert program.close()


def _pages(program: Program) -> set[str]:
    names = ("boardPage", "motorsPage", "parametersPage", "aracnaRobotPage")
    return {name for name in names if program.window.findChild(QWidget, name) is not None}


def test_pages_and_plots_are_created_when_first_shown(
    started: Program,
) -> None:
    assert _pages(started) == {"boardPage"}
    tabs = started.window.pages
    titles = [tabs.tabText(index) for index in range(tabs.count())]
    assert titles == ["Board", "Channels", "Motors", "Currents", "Parameters", "Diagnostics"]
    tabs.setCurrentIndex(2)
    assert _pages(started) == {"boardPage", "motorsPage"}
    started.connect_to_demo("trex")
    assert _pages(started) == {"boardPage", "motorsPage"}
    started.complete()
    assert _pages(started) == {"boardPage", "motorsPage", "parametersPage"}
    assert [tabs.tabText(index) for index in range(tabs.count())] == titles
    assert tabs.currentIndex() == 2
    assert started.window.findChild(QWidget, "curvePlot") is None
    started.create_plots()
    assert started.window.findChild(QWidget, "curvePlot") is not None


def test_unused_kind_of_device_is_found_with_all_its_pages(
    started: Program, start_simulator: StartSimulator, qtbot: QtBot
) -> None:
    robot = start_simulator("--aracna", "--unpaced")
    port, scanner = started.ports.add_typed(robot.url), started.device_manager.scanner
    scanner.start([port])
    qtbot.waitUntil(lambda: not scanner.running, timeout=60_000)
    (finding,) = scanner.findings
    assert finding.device == "aracna"
    assert "aracnaRobotPage" not in _pages(started)
    started.connect_to_demo("aracna")
    assert "aracnaRobotPage" in _pages(started)
    assert started.window.pages is started.workspace("aracna").pages


def test_file_of_an_unused_kind_of_device_is_opened(started: Program, tmp_path: Path) -> None:
    path = tmp_path / "one.ppr"
    path.write_text("", encoding="ascii")
    started.window.files.open_file(path)
    assert started.device_manager.current.plugin.key == "aracna"


def _panel(program: Program, name: str) -> QDockWidget:
    return next(one for one in program.window.findChildren(QDockWidget) if one.objectName() == name)


def test_first_use_of_another_kind_of_device_changes_nothing_shown(
    started: Program, qtbot: QtBot
) -> None:
    window, left = started.window, Qt.DockWidgetArea.LeftDockWidgetArea
    panel = _panel(started, "demoPanel")
    QSettings().setValue("window/state", window.saveState())
    window.addDockWidget(left, panel)
    banner = window.findChild(QLabel, "bannerText")
    assert isinstance(banner, QLabel)
    started.device_manager.stop_because("The computer was suspended", (Remedy.REPORT,))
    qtbot.waitUntil(lambda: "suspended" in banner.text())
    assert len(started.workspaces) == 2
    assert window.dockWidgetArea(panel) is left
    assert "suspended" in banner.text()

    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    actions = window.findChildren(QAction, options=Qt.FindChildOption.FindDirectChildrenOnly)
    names = [action.objectName() for action in actions if action.objectName()]
    assert len(names) == len(set(names)), "each entry of the menus has one action"
    assert {"stopAction", "openAction", "aracna_openAction"} <= set(names)


def test_panel_of_device_that_is_not_used_stays_where_it_was(qtbot: QtBot) -> None:
    del qtbot
    left = Qt.DockWidgetArea.LeftDockWidgetArea
    for use in (True, False, True):
        program = build()
        if use:
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
    """Without `close`, one process in six crashes."""
    count = 12

    def embed(_: int) -> subprocess.CompletedProcess[str]:
        command = [sys.executable, "-c", _EMBEDDING]
        return subprocess.run(command, capture_output=True, text=True, timeout=80, check=False)

    with ThreadPoolExecutor(2) as pool:
        results = list(pool.map(embed, range(count)))
    assert [result.returncode for result in results] == [0] * count, results
    assert not any("Traceback" in result.stderr for result in results), results
