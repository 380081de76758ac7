"""Everything that takes the focus, or is a table or a plot, has a name for a screen reader."""

import sys
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAccessible
from PySide6.QtWidgets import QAbstractScrollArea, QHeaderView, QScrollArea, QWidget

from tests.recording.samples import an_hour, write
from tests.support.simulator import SimulatedDevice
from tests.support.window import WindowDriver
from trex_gui.views.driving.gamepad_panel import GamepadPanel
from trex_gui.views.find_dialog import FindDialog

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")

_OFTEN_SILENT = {"bannerText"}
"""Empty most of the time, and can take the focus at any time."""


def is_part(widget: QWidget) -> bool:
    """Return whether a widget belongs to another one that has the name."""
    classes = {each.metaObject().className() for each in _up_from(widget)}
    is_inside = widget.focusProxy() is widget.parentWidget() and not widget.objectName()
    return (
        is_inside or widget.objectName().startswith("qt_") or "QComboBoxPrivateContainer" in classes
    )


def _up_from(widget: QWidget) -> list[QWidget]:
    above = widget.parentWidget()
    return [widget, *(_up_from(above) if above is not None else [])]


def takes_part(widget: QWidget) -> bool:
    """Return whether a screen reader comes to a widget."""
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
    """Return the widgets without an accessible name; names by buddy or text count."""
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


def test_window_has_names_with_and_without_a_board(
    window: WindowDriver, quick_simulator: SimulatedDevice
) -> None:
    pages = window.window.pages
    for index in range(pages.count()):
        pages.setCurrentIndex(index)
    window.find(GamepadPanel, "gamepadPanel")
    assert_named(window.root)

    window.trigger("find")
    find = window.find(FindDialog, "findDialog")
    assert_named(find)
    find.close()

    window.connect(quick_simulator.url)
    for index in range(pages.count()):
        pages.setCurrentIndex(index)
    window.trigger("bench")
    bench = window.dialog("benchDialog")
    for plot in ("benchCurrents", "benchSpeeds"):
        viewport = bench.find(QWidget, plot)
        assert takes_part(viewport)
        assert not is_part(viewport)
    assert_named(window.root)  # with the windows that belong to it
    bench.root.close()


def test_recording_window_has_names(window: WindowDriver, tmp_path: Path) -> None:
    write(tmp_path / "minute.trexrec", list(an_hour(60)))
    window.program.desk.recordings.open_file(tmp_path / "minute.trexrec")
    recording = window.program.desk.recordings.windows[0]
    window.wait(lambda: recording.playback.is_loaded)
    assert_named(recording)
    recording.close()
