"""Traffic page, with all bytes on the line and their meaning."""

from collections.abc import Sequence
from functools import partial
from pathlib import Path

from PySide6.QtCore import QLocale, Qt, Slot
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QWidget

from trex_gui.core.code import Language
from trex_gui.core.translation import tr
from trex_gui.core.transport.row_code import rows_as_code
from trex_gui.core.transport.traffic import Transaction
from trex_gui.ui.files import write_in_background
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.preferences import Preferences
from trex_gui.ui.runtime import new_timer
from trex_gui.ui.traffic.model import TrafficModel
from trex_gui.ui.traffic.send_row import PacketSender, SendRow
from trex_gui.ui.traffic.table import RowDetails, TrafficTable, TrafficView
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets import file_questions
from trex_gui.ui.widgets.behaviour import only_when_visible
from trex_gui.ui.widgets.view import View, copy_lines

_TYPING_MS = 200

_MAX_CODE_ROWS = 1000  # maximum number of rows copied as code, since long code compiles slowly


class TrafficPage(View):
    def __init__(
        self,
        traffic: TrafficModel,
        key: str,
        device: str,
        notifier: Notifier,
        parent: QWidget | None = None,
        *,
        sender: PacketSender | None = None,
    ) -> None:
        """`key`: prefix of object names and preferences. `device`: name for the user."""
        super().__init__(parent)
        self.setObjectName(f"{key}Page")
        self._traffic = traffic
        self._notifier = notifier
        self._polling_key = f"{key}/polling"
        self._device = device
        self._store = Preferences()
        self._table = TrafficTable(traffic, self)

        polling = tr("Also show the requests that the program repeats many times a second")
        self._polling, self._faults, self._paused = (
            ui.check_box(self, f"{key}{name}", text, tip=tip)
            for name, text, tip in (
                ("Polling", tr("&Show polling"), polling),
                ("Faults", tr("O&nly faults"), tr("Show only failed transactions and line errors")),
                ("Pause", tr("Pa&use"), tr("Stop adding rows; the traffic is still logged")),
            )
        )
        text, tip = tr("C&lear"), tr("Remove all rows")
        clear = ui.button(
            self, f"{key}ClearButton", text, icon="clear", tip=tip, on_click=traffic.clear
        )
        self._view = ui.named(TrafficView(self._table, self), f"{key}View")
        self._details = ui.named(RowDetails(traffic, self._table, self), f"{key}Details")
        self._typing = new_timer(self, _TYPING_MS, self._apply_filter, single_shot=True)

        above = ui.row(self._polling, self._faults, self._paused, 1, clear, spacing=16)
        send = () if sender is None else (SendRow(sender, key, self),)
        parts = above, (self._view, 1), self._details, *send
        ui.column(*parts, into=self, margins=(0, 12, 0, 16))

        copy_python = partial(self._copy_code, Language.PYTHON)
        copy_sketch = partial(self._copy_code, Language.ARDUINO)
        for name, text, shortcut, then in (
            ("Copy", tr("&Copy"), QKeySequence.StandardKey.Copy, self._copy_rows),
            ("CopyPython", tr("Copy as &Python"), "Ctrl+Shift+P", copy_python),
            ("CopyArduino", tr("Copy as &Arduino sketch"), "Ctrl+Shift+A", copy_sketch),
            ("Save", tr("Sa&ve as text…"), "", self._prompt_and_save),
        ):
            action = ui.action(
                self._view, f"{key}{name}Action", text, shortcut=shortcut, on_trigger=then
            )
            action.setShortcutContext(Qt.ShortcutContext.WidgetShortcut)
            self._view.addAction(action)
        self._view.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        self._polling.toggled.connect(self._apply_filter)
        self._faults.toggled.connect(self._apply_filter)
        self._paused.toggled.connect(self._table.set_paused)
        self._paused.toggled.connect(self.refresh)
        self._view.selectionModel().currentRowChanged.connect(self._show_current)
        self._table.modelReset.connect(lambda: self._details.show_row(None))
        traffic.changed.connect(self.refresh)
        traffic.cleared.connect(self.refresh)
        self._polling.setChecked(self._store.flag(self._polling_key, default=False))
        self._apply_filter()

    @Slot(str)
    def search(self, text: str) -> None:
        self.searched = text.strip().casefold()
        self._typing.start()

    @Slot()
    def _apply_filter(self) -> None:
        self._typing.stop()
        self._store.set(self._polling_key, self._polling.isChecked())
        self._table.set_filter(
            polling=self._polling.isChecked(), faults=self._faults.isChecked(), text=self.searched
        )
        if not self._paused.isChecked():
            self._view.scrollToBottom()
        self._summarize()

    @Slot()
    @only_when_visible
    def refresh(self) -> None:
        if not self._paused.isChecked():
            follows = self._view.is_at_bottom
            self._table.refresh()
            if follows:
                self._view.scrollToBottom()
            self._show_current()
        self._summarize()

    def show_moment(self, time: float, text: str) -> None:
        """Select the row nearest to `time`, preferably a row with `text`."""
        row = self._table.row_near(time, text)
        self._view.selectRow(row)
        self._view.scrollTo(self._table.index(row, 0), TrafficView.ScrollHint.PositionAtCenter)
        self._view.setFocus()
        self._paused.setChecked(self._polling.isChecked())  # otherwise the row scrolls away

    def _summarize(self) -> None:
        traffic, number_text = self._traffic, QLocale().toString
        shown = tr("{0} of {1} shown")
        parts = [
            shown.format(
                number_text(self._table.rowCount()), number_text(traffic.everything.count)
            ),
            tr("%n fault(s)", "", traffic.faults) if traffic.faults else tr("no faults"),
        ]
        if not self._polling.isChecked():
            parts.append(tr("polling hidden"))
        if self._paused.isChecked():
            parts.append(tr("paused"))
        if lost := traffic.log.lost:  # the GUI thread was blocked
            parts.append(tr("events lost: {0}").format(number_text(lost)))
        self.summarized.emit(", ".join(parts))
        self._view.set_placeholder(self._placeholder())

    def _placeholder(self) -> str:
        if self._traffic.everything.rows and self.searched:
            return tr("No row matches the search.")
        if self._traffic.everything.rows and self._faults.isChecked():
            return tr("No faults so far.")
        return tr(
            "No traffic yet. While {0} is connected, this page lists every byte on the line and "
            "its meaning."
        ).format(self._device)

    @Slot()
    def _show_current(self) -> None:
        index = self._view.currentIndex()
        self._details.show_row(self._table.rows[index.row()] if index.isValid() else None)

    @Slot()
    def _copy_rows(self) -> None:
        copy_lines(self.lines(), self._notifier)

    def _copy_code(self, language: Language) -> None:
        rows = self._selected_rows()[:_MAX_CODE_ROWS]
        copy_lines(rows_as_code(rows, self._traffic.decoder, language).splitlines(), self._notifier)

    def lines(self) -> Sequence[str]:
        return list(map(self._traffic.line_of, self._selected_rows()))

    def _selected_rows(self) -> Sequence[Transaction]:
        selected = sorted(index.row() for index in self._view.selectionModel().selectedRows())
        rows = self._table.rows
        return [rows[row] for row in selected] if selected else rows

    @Slot()
    def _prompt_and_save(self) -> None:
        if not self._table.rows:
            self._notifier.error.emit(tr("No rows to save."))
            return
        suggested = file_questions.last_folder() / "traffic.txt"
        title, kinds = tr("Save the traffic log"), tr("Text (*.txt *.tsv)")
        path = file_questions.prompt_to_save(self, title, suggested, kinds, ".txt")
        if path is not None:
            self.save(path)

    def save(self, path: Path) -> None:
        file_questions.remember_folder(path)
        write = partial(self._traffic.write, rows=tuple(self._table.rows))

        def saved(count: int) -> str:
            text = tr("{0} row(s) written to {1}.", "", count)
            return text.format(QLocale().toString(count), path)

        write_in_background(self, path, write, self._notifier, saved)
