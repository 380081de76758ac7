"""Dialog for boards that are served on the network."""

from collections.abc import Callable
from functools import partial
from typing import Any

from PySide6.QtCore import Slot
from PySide6.QtWidgets import QHeaderView, QTableWidget, QTableWidgetItem, QWidget

from trex_gui.core.errors import StudioError
from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.serve.robots import Robots
from trex_gui.devices.trex.views.motor_controls import MotorBar
from trex_gui.ui.files import in_background
from trex_gui.ui.translations import error_sentence
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import RedButton, ReusedDialog
from trex_gui.ui.widgets.labels import Muted, Note
from trex_gui.ui.widgets.placement import resize_with_font


class RobotsDialog(ReusedDialog):
    stays_on_stop = True

    def __init__(
        self,
        device: Device,
        connect: Callable[[str], object],
        set_served: Callable[[dict[str, str]], object],
        parent: QWidget,
    ) -> None:
        """Create the dialog. `connect` receives a URL, `set_served` the label of each URL."""
        super().__init__(parent)
        self._device, self._connect, self._set_served = device, connect, set_served
        self._rows: list[dict[str, Any]] = []
        self._reports_stop = False  # True if the note is about a stop during or after the search
        self._is_stopping = False
        self._robots = Robots()  # keeps the connections open, so that a stop is not delayed
        self.setObjectName("robotsDialog")
        self.setWindowTitle(title_of(tr("Robots on the net&work…")))
        resize_with_font(self, 820, 420)
        about = tr("Robots that “trexcmd serve” offers on this computer and on the local network.")
        headings = [tr("Robot"), tr("Board"), tr("Driver"), tr("Problems")]
        table = QTableWidget(0, len(headings), self)
        self._table = ui.flat_table(table, "robotsTable", tr("Robots"))
        self._table.setHorizontalHeaderLabels(headings)
        header = self._table.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        header.setStretchLastSection(True)
        self._note = ui.named(Note(1, self), "robotsNote")
        bar = MotorBar(device, "robotsStopButton", self)
        self._stop_all = RedButton("stopAllRobots", tr("Stop &all robots"), self._on_stop_all, bar)
        self._search = ui.button(
            bar, "findRobots", tr("&Search again"), default=False, on_click=self.search
        )
        self._connect_button = ui.button(
            bar, "connectRobot", tr("&Connect"), default=True, on_click=self._on_connect
        )
        close = ui.button(bar, "closeRobots", tr("Close"), default=False, on_click=self.close)
        bar.fill(self._stop_all, bar.armed, 1, self._search, close, self._connect_button)
        ui.column(Muted(about, self), (self._table, 1), self._note, bar, into=self)
        self.finished.connect(self._on_finished)
        self._table.itemSelectionChanged.connect(self._on_selected)
        self._table.itemActivated.connect(self._on_connect)
        self._on_selected()

    def show_in_front(self) -> None:
        super().show_in_front()
        self.search()

    @Slot()
    def search(self) -> None:
        self._search.setEnabled(False)
        self._note.show_note(tr("Searching …"))
        self._reports_stop = False
        in_background(self, self._robots.find, self._on_found, self._on_failed)

    @Slot()
    def _on_finished(self) -> None:
        if not self._is_stopping:  # closing the connections could lose the stop
            in_background(self, self._robots.close, lambda _: None, self._on_failed)

    def _on_found(self, rows: list[dict[str, Any]]) -> None:
        self._rows, note = rows, "" if rows else tr("No robots found.")
        self._search.setEnabled(True)
        if not self._reports_stop:
            self._note.show_note(note)
        self._table.setRowCount(len(rows))
        for number, row in enumerate(rows):
            board = row["board"] or tr("no board")
            if row["board"] and not row["responds"]:
                board = tr("{0}, not responding").format(board)
            texts = row["url"], board, row["driver"] or "–", ", ".join(map(tr, row["problems"]))
            for column, text in enumerate(texts):
                self._table.setItem(number, column, QTableWidgetItem(text))
        if rows:
            self._table.selectRow(0)
        self._on_selected()
        self._set_served({row["url"]: f"{row['name']}  ({row['url']})" for row in rows})

    def _on_failed(self, error: StudioError) -> None:
        self._search.setEnabled(True)
        self._note.show_note(error_sentence(error), alarming=True)

    @Slot()
    def _on_selected(self) -> None:
        self._connect_button.setEnabled(bool(self._rows) and self._table.currentRow() >= 0)
        self._stop_all.setEnabled(bool(self._rows))

    @Slot()
    def _on_connect(self) -> None:
        if 0 <= (row := self._table.currentRow()) < len(self._rows):
            self.close()
            self._connect(self._rows[row]["url"])

    @Slot()
    def _on_stop_all(self) -> None:
        self._device.press_stop()  # the board of this window stops without delay
        urls = [row["url"] for row in self._rows]
        self._note.show_note(tr("Stopping …"))
        self._reports_stop = self._is_stopping = True
        stop = partial(self._robots.stop, urls)
        in_background(self, stop, self._on_stopped, self._on_stop_failed)

    def _on_stopped(self, results: dict[str, str]) -> None:
        failed = [f"{url}: {error}" for url, error in results.items() if error]
        text = tr("%n robot(s) stopped.", "", len(results) - len(failed))
        if failed:
            text = tr("Stop not confirmed: {0}").format(" ".join(failed))
        self._note.show_note(text, alarming=bool(failed))
        self._end_stop(text if failed else "")

    def _on_stop_failed(self, error: StudioError) -> None:
        self._on_failed(error)
        self._end_stop(error_sentence(error))

    def _end_stop(self, problem: str) -> None:
        """Report a problem in the main window if the dialog was closed during the stop."""
        self._is_stopping = False
        if not self.isVisible():
            if problem:
                self._device.notifier.error.emit(problem)
            self._on_finished()
