"""What tests of the panels of simulated devices have in common."""

from collections.abc import Callable
from itertools import pairwise

from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QWidget

from trex_gui.core.plugin import DevicePlugin
from trex_gui.devices.trex.plugin import TREX
from trex_gui.ui.devices.simulator import Simulator


class Overheard(Simulator):
    """A simulator whose control lines are written down."""

    def __init__(self, plugin: DevicePlugin = TREX) -> None:
        super().__init__(plugin)
        self.lines: list[str] = []

    def send(self, line: str, then: Callable[[str], None] | None = None) -> None:
        self.lines.append(line)
        super().send(line, then)

    def orders(self) -> list[str]:
        return [line for line in self.lines if line != "show"]


def reached_by_tab(last: str) -> list[str]:
    """Return the names of what Tab reaches, from what has the focus to `last`."""
    reached: list[str] = []
    while not reached or (reached[-1] != last and len(reached) < 60):
        focused = QApplication.focusWidget()
        assert focused is not None
        if reached:
            QTest.keyClick(focused, Qt.Key.Key_Tab)
            focused = QApplication.focusWidget()
            assert focused is not None
        reached.append(focused.objectName())
    return reached


def stand_in_order(panel: QWidget, names: list[str]) -> bool:
    """Return whether each of these widgets stands below or beside the one before it."""
    widgets = [panel.findChild(QWidget, name) for name in names]
    heights = [widget.mapTo(panel, QPoint()).y() for widget in widgets if widget is not None]
    return len(heights) == len(names) and all(
        after - before > -12 for before, after in pairwise(heights)
    )
