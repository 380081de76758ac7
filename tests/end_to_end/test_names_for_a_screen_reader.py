"""Everything that takes the focus, or is a table or a plot, has a name that can be spoken."""

import sys
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAccessible, QAction
from PySide6.QtWidgets import QAbstractScrollArea, QHeaderView, QScrollArea, QWidget
from pytestqt.qtbot import QtBot

from tests.recording.samples import an_hour, write
from tests.support.simulator import SimulatedDevice
from trex_gui.link.settings import LinkSettings
from trex_gui.model.device import Link
from trex_gui.views.bench.dialog import BenchDialog
from trex_gui.views.driving.gamepad_panel import GamepadPanel
from trex_gui.views.find_dialog import FindDialog
from trex_gui.window import Program

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")

_OFTEN_SILENT = {"bannerText"}
"""Says something only now and then, and takes the focus at any time."""


def is_part(widget: QWidget) -> bool:
    """Whether Qt has made it for another widget, which has the name."""
    classes = {each.metaObject().className() for each in _up_from(widget)}
    is_inside = widget.focusProxy() is widget.parentWidget() and not widget.objectName()
    return (
        is_inside or widget.objectName().startswith("qt_") or "QComboBoxPrivateContainer" in classes
    )


def _up_from(widget: QWidget) -> list[QWidget]:
    above = widget.parentWidget()
    return [widget, *(_up_from(above) if above is not None else [])]


def takes_part(widget: QWidget) -> bool:
    """Whether somebody who reads a screen by ear comes to it."""
    if isinstance(widget, QScrollArea):  # only a frame around what has names
        return False
    is_area = isinstance(widget, QAbstractScrollArea | QHeaderView)
    parent = widget.parentWidget()
    is_viewport = (
        isinstance(parent, QAbstractScrollArea)
        and parent.viewport() is widget
        and bool(widget.objectName())
    )
    focusable = widget.focusPolicy() is not Qt.FocusPolicy.NoFocus
    return focusable or is_area or is_viewport or widget.objectName() in _OFTEN_SILENT


def nameless(root: QWidget) -> list[str]:
    """Return what a screen reader could say nothing of; names by buddy or text count."""
    found = []
    for widget in [root, *root.findChildren(QWidget)]:
        if is_part(widget) or not takes_part(widget) or not widget.window().isVisible():
            continue
        interface = QAccessible.queryAccessibleInterface(widget)
        name = interface.text(QAccessible.Text.Name) if interface is not None else ""
        if not name.strip():
            path = [each.objectName() or type(each).__name__ for each in _up_from(widget)[:5]]
            found.append(f"{type(widget).__name__}: {' < '.join(path)}")
    return sorted(set(found))


def assert_named(root: QWidget) -> None:
    found = nameless(root)
    assert not found, "\n".join(found)


def trigger(program: Program, name: str) -> None:
    action = program.window.findChild(QAction, name)
    assert isinstance(action, QAction)
    action.trigger()


def test_everything_has_a_name_without_a_board(program: Program) -> None:
    for index in range(program.window.pages.count()):
        program.window.pages.setCurrentIndex(index)
    assert program.window.findChild(GamepadPanel) is not None
    assert_named(program.window)


def test_everything_has_a_name(
    program: Program, quick_simulator: SimulatedDevice, qtbot: QtBot
) -> None:
    device = program.device
    trigger(program, "findAction")
    find = program.window.findChild(FindDialog)
    assert find is not None
    assert_named(find)
    find.close()
    device.connect_to(LinkSettings(quick_simulator.url))
    qtbot.waitUntil(lambda: device.link is Link.UP, timeout=8000)
    for index in range(program.window.pages.count()):
        program.window.pages.setCurrentIndex(index)
    trigger(program, "benchAction")
    bench = program.window.findChild(BenchDialog)
    assert bench is not None
    for plot in ("benchCurrents", "benchSpeeds"):
        viewport = bench.findChild(QWidget, plot)
        assert viewport is not None
        assert takes_part(viewport)
        assert not is_part(viewport)
    assert_named(program.window)  # with the windows that belong to it
    bench.close()


def test_everything_in_the_window_of_a_recording_has_a_name(
    program: Program, qtbot: QtBot, tmp_path: Path
) -> None:
    write(tmp_path / "minute.trexrec", list(an_hour(60)))
    program.desk.recordings.open_file(tmp_path / "minute.trexrec")
    window = program.desk.recordings.windows[0]
    qtbot.waitUntil(lambda: window.playback.is_loaded)
    assert_named(window)
    window.close()
