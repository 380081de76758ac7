"""Driver of the dialog that finds boards."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QListWidget, QListWidgetItem
from pytestqt.qtbot import QtBot

from tests.support.window import WidgetDriver, WindowDriver
from trex_gui.ui.devices.scanner import DeviceScanner
from trex_gui.ui.frame.find_dialog import FindDialog


class FindBoardDialog(WidgetDriver):
    """Find dialog, in the main window or alone."""

    def __init__(self, dialog: FindDialog, finder: DeviceScanner, qtbot: QtBot) -> None:
        super().__init__(dialog, qtbot)
        self.finder = finder

    def ports(self) -> list[QListWidgetItem]:
        ports = self.find(QListWidget, "findPorts")
        return [ports.item(row) for row in range(ports.count())]

    def rows(self) -> dict[str, bool]:
        """Return whether each listed port is checked, by its text."""
        return {port.text(): port.checkState() is Qt.CheckState.Checked for port in self.ports()}

    def search(self, window: WindowDriver, url: str) -> None:
        """Open the dialog from the window. Scan only this port."""
        self.root.close()
        window.program.ports.add_typed(url)
        window.click("findButton")
        for port in self.ports():
            checked = port.text().startswith(url)
            port.setCheckState(Qt.CheckState.Checked if checked else Qt.CheckState.Unchecked)
        self.click("findStartButton")

    def is_searching(self) -> bool:
        return self.finder.running

    def wait_for_end(self) -> None:
        self.wait(lambda: not self.is_searching(), 60_000)
