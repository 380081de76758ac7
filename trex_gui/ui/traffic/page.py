"""Page of the traffic log: every byte on the line, and its meaning."""

from pathlib import Path

from PySide6.QtCore import QModelIndex, QSettings, Qt, Slot
from PySide6.QtGui import QAction, QGuiApplication, QKeySequence, QShortcut, QShowEvent
from PySide6.QtWidgets import (
    QCheckBox,
    QFileDialog,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from trex_gui.ui.notifier import Notifier
from trex_gui.ui.runtime import runtime
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.traffic.model import TrafficModel
from trex_gui.ui.traffic.saver import TrafficSaver, row_of
from trex_gui.ui.traffic.table import TrafficTable
from trex_gui.ui.traffic.table_view import RowDetails, TrafficView
from trex_gui.ui.widgets import file_questions
from trex_gui.ui.widgets.behaviour import only_when_visible

_TYPING_MS = 200


class TrafficPage(QWidget):
    """The table of transactions with its filters, and details of the selected row."""

    def __init__(
        self,
        traffic: TrafficModel,
        key: str,
        who: str,
        notifier: Notifier,
        parent: QWidget | None = None,
    ) -> None:
        """Show traffic; `key` names the page and its settings, `who` the device."""
        super().__init__(parent)
        self.setObjectName(f"{key}Page")
        self._traffic = traffic
        self._notifier = notifier
        self._key = key
        self._who = who
        self._store = QSettings(self)
        self._table = TrafficTable(traffic, self)
        self._saver = TrafficSaver(traffic, self)

        self._search = QLineEdit(self)
        self._search.setObjectName(f"{key}Search")
        self._search.setAccessibleName(self.tr("Search the traffic log"))
        self._search.setPlaceholderText(self.tr("Search bytes and meanings (Ctrl+F)"))
        self._search.setClearButtonEnabled(True)
        self._polling = self._check_box(
            "Polling",
            self.tr("Show polling"),
            self.tr("Also show the requests that the program repeats many times a second"),
        )
        self._faults = self._check_box(
            "Faults",
            self.tr("Only faults"),
            self.tr("Show only failed transactions and line errors"),
        )
        self._paused = self._check_box(
            "Pause",
            self.tr("Pause"),
            self.tr("Do not add rows for now; the traffic is still logged"),
        )
        copy = self._button("Copy", self.tr("Copy"), "copy", self._copy)
        copy.setToolTip(self.tr("Copy the selected rows (Ctrl+C), or all rows shown"))
        save = self._button("Save", self.tr("Save…"), "save", self._ask_and_save)
        save.setToolTip(self.tr("Save the rows shown as text"))
        clear = self._button("Clear", self.tr("Clear"), "clear", traffic.clear)
        clear.setToolTip(self.tr("Remove every row"))
        self._view = TrafficView(self._table, self)
        self._view.setObjectName(f"{key}View")
        self._details = RowDetails(traffic, self._table, self)
        self._details.setObjectName(f"{key}Details")
        self._summary = QLabel(self)
        self._summary.setObjectName(f"{key}Summary")
        self._typing = runtime().timer(self)
        self._typing.setSingleShot(True)
        self._typing.setInterval(_TYPING_MS)

        above = QHBoxLayout()
        above.addWidget(self._search, 1)
        for box in (self._polling, self._faults, self._paused):
            above.addWidget(box)
        above.addSpacing(above.spacing())
        for button in (copy, save, clear):
            above.addWidget(button)
        layout = QVBoxLayout(self)
        layout.addLayout(above)
        layout.addWidget(self._view, 1)
        layout.addWidget(self._details)
        layout.addWidget(self._summary)

        QShortcut(QKeySequence.StandardKey.Find, self, self._on_find)
        copying = QAction(self.tr("Copy"), self._view)
        copying.setShortcut(QKeySequence.StandardKey.Copy)
        copying.setShortcutContext(Qt.ShortcutContext.WidgetShortcut)
        copying.triggered.connect(self._copy)
        self._view.addAction(copying)
        self._view.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        self._search.textChanged.connect(self._typing.start)
        self._typing.timeout.connect(self._apply_filter)
        self._polling.toggled.connect(self._apply_filter)
        self._faults.toggled.connect(self._apply_filter)
        self._paused.toggled.connect(self._on_paused)
        self._view.selectionModel().currentRowChanged.connect(self._on_current_changed)
        self._table.modelReset.connect(self._on_reset)
        self._saver.saved.connect(self._on_saved)
        self._saver.failed.connect(self._notifier.error)
        traffic.changed.connect(self._refresh)
        traffic.cleared.connect(self._refresh)
        self._polling.setChecked(self._store.value(f"{key}/polling", False, bool) is True)
        self._apply_filter()

    def _check_box(self, name: str, text: str, tip: str) -> QCheckBox:
        box = QCheckBox(text, self)
        box.setObjectName(f"{self._key}{name}")
        box.setToolTip(tip)
        return box

    def _button(self, name: str, text: str, sign: str, slot: object) -> QPushButton:
        button = QPushButton(text, self)
        button.setObjectName(f"{self._key}{name}Button")
        set_icon(button, sign)
        button.clicked.connect(slot)
        return button

    # --- Rows shown ---------------------------------------------------------------------

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._refresh()

    @Slot()
    def _apply_filter(self) -> None:
        self._typing.stop()
        self._store.setValue(f"{self._key}/polling", self._polling.isChecked())
        self._table.set_filter(
            polling=self._polling.isChecked(),
            faults=self._faults.isChecked(),
            text=self._search.text(),
        )
        if not self._paused.isChecked():
            self._view.scrollToBottom()
        self._summarize()

    @Slot(bool)
    def _on_paused(self, paused: bool) -> None:
        self._table.set_paused(paused)
        self._refresh()

    @Slot()
    @only_when_visible
    def _refresh(self) -> None:
        if not self._paused.isChecked():
            follows = self._view.is_at_bottom
            self._table.refresh()
            if follows:
                self._view.scrollToBottom()
            self._show_current()
        self._summarize()

    def _summarize(self) -> None:
        traffic = self._traffic
        faults = traffic.faults
        parts = [
            self.tr("shown: {0}").format(f"{self._table.rowCount():,}"),
            self.tr("transactions: {0}").format(f"{traffic.everything.count:,}"),
            self.tr("faults: {0}").format(f"{faults:,}"),
        ]
        if not self._polling.isChecked():
            parts.append(self.tr("polling is hidden"))
        if self._paused.isChecked():
            parts.append(self.tr("paused"))
        if traffic.lost:
            parts.append(self.tr("events lost: {0}").format(f"{traffic.lost:,}"))
        self._summary.setText(" · ".join(parts))
        self._view.set_empty_text(self._empty_text())

    def _empty_text(self) -> str:
        if self._traffic.everything.rows and self._search.text().strip():
            return self.tr("No row matches the search.")
        if self._traffic.everything.rows and self._faults.isChecked():
            return self.tr("No faults so far.")
        return self.tr(
            "No traffic yet. While {0} is connected, this page lists every byte on the line and "
            "its meaning."
        ).format(self._who)

    @Slot(QModelIndex)
    def _on_current_changed(self, _current: QModelIndex) -> None:
        self._show_current()

    @Slot()
    def _on_reset(self) -> None:
        self._details.show_row(None)

    def _show_current(self) -> None:
        index = self._view.currentIndex()
        self._details.show_row(self._table.rows[index.row()] if index.isValid() else None)

    @Slot()
    def _on_find(self) -> None:
        self._search.setFocus()
        self._search.selectAll()

    # --- Copy and save ------------------------------------------------------------------

    @Slot()
    def _copy(self) -> None:
        """Copy the selected rows, or all."""
        selected = sorted(index.row() for index in self._view.selectionModel().selectedRows())
        rows = self._table.rows
        wanted = [rows[row] for row in selected] if selected else rows
        if not wanted:
            self._notifier.error.emit(self.tr("No rows to copy."))
            return
        lines = [row_of(self._traffic, row).text() for row in wanted]
        QGuiApplication.clipboard().setText("\n".join(lines) + "\n")
        self._notifier.info.emit(self.tr("Copied rows: {0}.").format(f"{len(lines):,}"))

    @Slot()
    def _ask_and_save(self) -> None:
        if not self._table.rows:
            self._notifier.error.emit(self.tr("No rows to save."))
            return
        suggested = file_questions.last_folder(self._store) / "traffic.txt"
        chosen, _ = QFileDialog.getSaveFileName(
            self, self.tr("Save the traffic log"), str(suggested), self.tr("Text (*.txt *.tsv)")
        )
        if chosen:
            path = Path(chosen)
            self.save(path if path.suffix else path.with_suffix(".txt"))

    def save(self, path: Path) -> None:
        """Write the rows shown."""
        file_questions.remember_folder(self._store, path)
        self._saver.save(path, self._table.rows)

    @Slot(int, object)
    def _on_saved(self, count: int, path: Path) -> None:
        self._notifier.info.emit(
            self.tr("{0} rows were written to {1}.").format(f"{count:,}", path)
        )
