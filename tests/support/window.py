"""Drivers that operate a window by the object names of its widgets.

`WidgetDriver` finds, reads and operates the widgets below a root. `WindowDriver` does so for the
whole program. A page object is a `WidgetDriver` for one page, panel or dialog, with methods for its
special gestures. All drivers work in virtual and in real time, depending on their `qtbot`.
"""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TypeVar

from PySide6.QtCore import QMimeData, QObject, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QAction, QDragEnterEvent, QDropEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QDialog,
    QLabel,
    QLineEdit,
    QScrollArea,
    QSlider,
    QStyle,
    QStyleOptionSlider,
    QWidget,
)
from pytestqt.qtbot import QtBot

from tests.support.program import aracna, trex
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.trex.views.workspace import TrexWorkspace
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.devices.ports import Port
from trex_gui.ui.files import background
from trex_gui.ui.frame.workspace import Menu, entries_of
from trex_gui.ui.program import Program
from trex_gui.ui.runtime import now
from trex_gui.ui.widgets.behaviour import ConfirmButton

ObjectT = TypeVar("ObjectT", bound=QObject)

TIMEOUT_MS = 30_000
"""Default timeout of a wait."""

LEFT = Qt.MouseButton.LeftButton


class WidgetDriver:
    """Driver of the widgets below a root.

    Attributes:
        root: widget that contains them.
        qtbot: bot that lets time pass.
    """

    def __init__(self, root: QWidget, qtbot: QtBot) -> None:
        self.root = root
        self.qtbot = qtbot

    # --- Find and read ------------------------------------------------------------------

    def find(self, kind: type[ObjectT], name: str) -> ObjectT:
        """Return the widget or action with this object name. Fail if there is none."""
        found = self.root.findChild(kind, name)
        assert isinstance(found, kind), f"{self.root.objectName()} has no {name}"
        return found

    def find_all(self, kind: type[ObjectT]) -> list[ObjectT]:
        """Return all objects of a type."""
        return self.root.findChildren(kind)

    def find_only(self, kind: type[ObjectT]) -> ObjectT:
        """Return the single object of a type."""
        found = self.find_all(kind)
        assert len(found) == 1, f"{self.root.objectName()} has {len(found)} {kind.__name__}"
        return found[0]

    def has(self, name: str) -> bool:
        """Return whether a widget with this object name is visible."""
        widget = self.root.findChild(QWidget, name)
        return widget is not None and widget.isVisible()

    def text(self, name: str) -> str:
        """Return the text of a label."""
        return self.find(QLabel, name).text()

    def button(self, name: str) -> QAbstractButton:
        return self.find(QAbstractButton, name)

    def combo(self, name: str) -> QComboBox:
        return self.find(QComboBox, name)

    def is_enabled(self, name: str) -> bool:
        return self.find(QWidget, name).isEnabled()

    # --- Wait ---------------------------------------------------------------------------

    def wait(self, condition: Callable[[], object], timeout: int = TIMEOUT_MS) -> None:
        """Let time pass until a condition holds. `timeout` in milliseconds."""
        self.qtbot.waitUntil(lambda: bool(condition()), timeout=timeout)

    def wait_seconds(self, seconds: float) -> None:
        end = now() + seconds
        self.wait(lambda: now() >= end)

    def wait_for_files(self) -> None:
        """Wait until all file operations are done and the window has settled."""
        quiet = 0

        def is_quiet() -> bool:
            nonlocal quiet
            quiet = 0 if background else quiet + 1
            return quiet > 3

        self.wait(is_quiet)

    def wait_for_text(self, name: str, part: str) -> None:
        """Wait until a label contains a text."""

        def contains() -> None:
            text = self.text(name)
            assert part in text, f"{name}: {text}"

        self.qtbot.waitUntil(contains, timeout=TIMEOUT_MS)

    # --- Operate ------------------------------------------------------------------------

    def activate(self) -> None:
        """Bring the window to the front."""
        self.root.activateWindow()
        self.wait(self.root.isActiveWindow)

    def click(self, name: str) -> None:
        """Click a button or check box once it is visible. Scroll to it if necessary."""
        button = self.button(name)
        self.wait(button.isVisible)
        assert button.isEnabled(), f"{name} is disabled"
        if isinstance(button, ConfirmButton):
            self.wait(lambda: button.accepts_clicks)
        self.scroll_to(button)
        place = QPoint(min(8, button.width() // 2), button.height() // 2)
        QTest.mouseClick(button, LEFT, pos=place)

    def scroll_to(self, widget: QWidget) -> None:
        """Bring a widget into view."""
        parent = widget.parentWidget()
        while parent is not None and not isinstance(parent, QScrollArea):
            parent = parent.parentWidget()
        if parent is not None:
            parent.ensureWidgetVisible(widget)

    def select(self, name: str, data: object) -> None:
        """Select the entry of a combo box with this data, like a user with the mouse."""
        combo = self.combo(name)
        index = next((i for i in range(combo.count()) if combo.itemData(i) == data), -1)
        assert index >= 0, f"{name} has no {data}"
        combo.setCurrentIndex(index)
        combo.activated.emit(index)  # there is no popup to open offscreen

    def type_into(self, name: str, text: str, *, enter: bool = True) -> None:
        """Replace the text of an editor."""
        editor = self.find(QWidget, name)
        assert isinstance(editor, QAbstractSpinBox | QLineEdit), name
        editor.setFocus()
        editor.selectAll()
        QTest.keyClicks(editor, text)
        if enter:
            QTest.keyClick(editor, Qt.Key.Key_Return)

    def handle_of(self, slider: QSlider, value: int | None = None) -> QPoint:
        """Return the position of a slider's handle at a value, by default the current value."""
        option = QStyleOptionSlider()
        slider.initStyleOption(option)
        if value is not None:
            option.sliderPosition = option.sliderValue = value
        kind, part = QStyle.ComplexControl.CC_Slider, QStyle.SubControl.SC_SliderHandle
        return slider.style().subControlRect(kind, option, part, slider).center()

    def drag(self, name: str, value: int, *, release: bool = True) -> QSlider:
        """Drag the handle of a slider to a value with the mouse."""
        slider = self.find(QSlider, name)
        start, end = self.handle_of(slider), self.handle_of(slider, value)
        QTest.mousePress(slider, LEFT, pos=start)
        for step in range(1, 11):
            QTest.mouseMove(slider, start + (end - start) * step / 10)
        if release:
            QTest.mouseRelease(slider, LEFT, pos=end)
        return slider

    def move_slider(self, name: str, value: int) -> None:
        """Move the mouse to the position of a slider's handle at a value."""
        slider = self.find(QSlider, name)
        QTest.mouseMove(slider, self.handle_of(slider, value))

    def release_slider(self, name: str) -> None:
        slider = self.find(QSlider, name)
        QTest.mouseRelease(slider, LEFT, pos=self.handle_of(slider))

    def press_escape(self) -> None:
        QTest.keyClick(self.root, Qt.Key.Key_Escape)


class WindowDriver(WidgetDriver):
    """Driver of the whole program."""

    def __init__(self, program: Program, qtbot: QtBot) -> None:
        super().__init__(program.window, qtbot)
        self.program = program
        self.window = program.window
        self.device = trex(program).device
        self.motors = trex(program).device.motors

    def find(self, kind: type[ObjectT], name: str) -> ObjectT:
        """Return the widget or action with this object name. Create all pages if necessary."""
        if self.root.findChild(kind, name) is None:
            self.program.complete()
        return super().find(kind, name)

    def find_all(self, kind: type[ObjectT]) -> list[ObjectT]:
        """Return all objects of a type. Create all pages."""
        self.program.complete()
        return super().find_all(kind)

    @property
    def robot(self) -> Robot:
        """Model of the Aracna, created on first use."""
        return aracna(self.program).robot

    @property
    def help(self) -> QDialog:
        """Help window, which must be open."""
        assert self.window.help_dialog is not None
        return self.window.help_dialog

    # --- Connect ------------------------------------------------------------------------

    def connect(self, url: str) -> None:
        """Connect to a TReX like a user. Wait until the board is read."""
        self.connect_port(self.program.ports.add_typed(url))
        self.wait(lambda: self.device.link is ConnectionState.CONNECTED)
        self.motors.accept_arming_without_timeout()

    def connect_port(self, port: Port) -> None:
        """Select an entry of the port list and press Connect. Does not wait."""
        self.select("portCombo", port)
        self.click("connectButton")

    def connect_to_demo(self, kind: str = "trex") -> None:
        """Connect to the demo TReX or Aracna. Wait until it is read."""
        self.program.connect_to_demo(kind)
        self.wait_until_up(kind)

    def wait_until_up(self, kind: str = "aracna") -> None:
        """Wait until the TReX or the Aracna is connected."""
        model = self.device if kind == "trex" else self.robot
        self.wait(lambda: model.link is ConnectionState.CONNECTED)

    def disconnect(self) -> None:
        self.trigger("disconnect")
        self.wait(lambda: self.program.device_manager.current.link is ConnectionState.DISCONNECTED)

    def apply(self, **values: int) -> None:
        """Edit settings, and write all edits without a review."""
        for key, value in values.items():
            self.device.parameters.edit(key, value)
        with self.qtbot.waitSignal(self.device.applied):
            self.device.writer.apply()

    def drop(self, *paths: Path) -> bool:
        """Drop files onto the window. Return whether it accepts them."""
        data = QMimeData()
        data.setUrls([QUrl.fromLocalFile(str(path)) for path in paths])
        action = (Qt.DropAction.CopyAction, data, LEFT, Qt.KeyboardModifier.NoModifier)
        enter = QDragEnterEvent(QPoint(9, 9), *action)
        QApplication.sendEvent(self.window, enter)
        if enter.isAccepted():
            QApplication.sendEvent(self.window, QDropEvent(QPointF(9, 9), *action))
        return enter.isAccepted()

    # --- Pages, dialogs, menus ----------------------------------------------------------

    def open_page(self, name: str) -> WidgetDriver:
        """Show the page with this object name. Return its driver."""
        workspace = self.program.workspace(self.program.device_manager.current.plugin.key)
        entries = entries_of({Menu.WINDOW: workspace.page_entries()})
        keys = [entry.key.removeprefix(f"{workspace.key}_") for entry in entries]
        workspace.show_page(next(key for key in keys if name.lower().endswith(f"{key}page")))
        return WidgetDriver(self.find(QWidget, name), self.qtbot)

    def each_page(self) -> Iterator[QWidget]:
        """Yield one page after the other, in its scroll area."""
        workspace = self.program.workspace(self.program.device_manager.current.plugin.key)
        for number in range(workspace.page_count):
            workspace.show_page_at(number)
            page = workspace.page_at(number)
            assert page is not None
            yield page

    def dialog(self, name: str) -> WidgetDriver:
        """Return the dialog with this object name. Create it if necessary."""
        creators: dict[str, Callable[[TrexWorkspace], object]] = {
            "learnDialog": lambda workspace: workspace._tools.learn,
            "powerCycleDialog": lambda workspace: workspace._settings._power,
            "reviewDialog": lambda workspace: workspace._settings._review,
        }
        if name in creators:
            creators[name](trex(self.program).workspace)
        return WidgetDriver(self.find(QDialog, name), self.qtbot)

    def action(self, key: str) -> QAction:
        """Return the menu entry with this key."""
        return self.find(QAction, f"{key}Action")

    def trigger(self, key: str) -> None:
        """Trigger a menu entry."""
        action = self.action(key)
        assert action.isEnabled(), f"{key} is disabled"
        action.trigger()
