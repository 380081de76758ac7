"""Comparing a saved traffic log with the simulated board, from the menu."""

from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, Slot
from PySide6.QtWidgets import QFileDialog, QWidget

from trex_gui.devices.trex.replay import RecordedTraffic
from trex_gui.ui.files import in_background
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.widgets.file_questions import last_folder


class TrafficComparison(QObject):
    """Replays a file beside the window's thread; nothing reaches a port."""

    def __init__(self, notifier: Notifier, window: QWidget) -> None:
        super().__init__(window)
        self._notifier = notifier
        self._window = window

    @Slot()
    def ask_and_compare(self) -> None:
        title, kinds = self.tr("Compare a traffic log"), self.tr("Text (*.txt *.tsv)")
        path, _ = QFileDialog.getOpenFileName(self._window, title, str(last_folder()), kinds)
        if path:
            self.compare(Path(path))

    def compare(self, path: Path) -> None:
        work = partial(_first_difference, path)
        in_background(self, work, self._report, self._notifier.report_error)

    def _report(self, found: tuple[int, tuple[int, str, str, str] | None]) -> None:
        count, difference = found
        if difference is None:
            text = self.tr("%n transaction(s): the simulated board replies the same.", "", count)
            self._notifier.info.emit(text)
            return
        text = self.tr("First difference, line {0}: {1}. The simulated board: {2} ({3}).")
        self._notifier.error.emit(text.format(*difference))


def _first_difference(path: Path) -> tuple[int, tuple[int, str, str, str] | None]:
    """Return the number of transactions, and line, meaning, and the simulator's reply in words."""
    recorded = RecordedTraffic.load(path)
    for row, received in recorded.replayed():
        shown = received.hex(" ").upper() or "–"
        before, after = recorded.meaning(row, row.received), recorded.meaning(row, received)
        return len(recorded.rows), (row.line, before, after.rpartition("→ ")[2], shown)
    return len(recorded.rows), None
