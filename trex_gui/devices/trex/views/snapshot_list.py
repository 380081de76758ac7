"""The list of snapshots, and the field that searches it."""

from pathlib import Path

from PySide6.QtCore import (
    QItemSelectionModel,
    QModelIndex,
    QPersistentModelIndex,
    Qt,
    Signal,
    Slot,
)
from PySide6.QtGui import QKeySequence, QShortcut
from PySide6.QtWidgets import (
    QAbstractItemView,
    QLineEdit,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTableView,
    QWidget,
)

from trex_gui.devices.trex.model.settings.snapshots import (
    SnapshotColumn,
    SnapshotFilter,
    SnapshotRole,
    SnapshotTable,
)
from trex_gui.devices.trex.settings.history import Snapshot
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.widgets import builders as ui

_WIDEST = 34
"""The initial width of a column, in characters."""


class _Delegate(QStyledItemDelegate):
    """Marks damaged snapshots."""

    def initStyleOption(
        self, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex
    ) -> None:
        super().initStyleOption(option, index)
        if index.column() == SnapshotColumn.BOARD and index.data(SnapshotRole.PROBLEM):
            option.icon = icon("warning", "warning")
            option.features |= QStyleOptionViewItem.ViewItemFeature.HasDecoration


class SnapshotList(QWidget):
    """A search field above the snapshots, of which one or several can be chosen.

    Signals:
        chosen_changed: the selection.
        delete_requested: the Delete key was pressed.
    """

    chosen_changed = Signal()
    delete_requested = Signal()

    def __init__(self, table: SnapshotTable, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._table = table
        self._rows = SnapshotFilter(table, self)

        self._search = ui.named(
            QLineEdit(self), "snapshotSearch", accessible=self.tr("Search snapshots")
        )
        self._search.setPlaceholderText(self.tr("Search times, boards, adapters (Ctrl+F)"))
        self._search.setClearButtonEnabled(True)
        self._view = ui.flat_table(QTableView(self), "snapshotView", self.tr("Snapshots"))
        self._view.setModel(self._rows)
        self._view.setItemDelegate(_Delegate(self._view))
        self._view.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self._view.setWordWrap(False)
        header = self._view.horizontalHeader()
        header.setStretchLastSection(True)
        header.setResizeContentsPrecision(50)  # rows that are measured for a width
        self._none = ui.label(self, "snapshotNoMatch", self.tr("No snapshot has these words."))

        ui.column(self._search, (self._view, 1), self._none, into=self, margins=0)

        QShortcut(QKeySequence.StandardKey.Find, self.window(), self._search.setFocus)
        delete = QShortcut(QKeySequence.StandardKey.Delete, self._view)
        delete.setContext(Qt.ShortcutContext.WidgetShortcut)
        delete.activated.connect(self.delete_requested)
        self._search.textChanged.connect(self._on_search_changed)
        self._view.selectionModel().selectionChanged.connect(self.chosen_changed)
        self._on_search_changed("")

    @property
    def chosen(self) -> tuple[Snapshot, ...]:
        """The selected snapshots, the newest first."""
        rows = sorted(self._rows.mapToSource(index).row() for index in self._selected)
        return tuple(self._table.snapshots[row] for row in rows)

    def choose(self, path: Path) -> None:
        """Select only this snapshot."""
        row = self._table.row_of(path)
        if row is not None:
            self._choose_row(self._rows.mapFromSource(self._table.index(row, 0)))

    def refresh(self) -> None:
        """Read the folder again; if all chosen snapshots are gone, choose another one."""
        was_empty = self._table.rowCount() == 0
        selected = self._selected
        place = min((index.row() for index in selected), default=0)
        self._table.refresh()
        if was_empty:
            self._fit_columns()
        if not self._selected and self._rows.rowCount() and (selected or was_empty):
            self._choose_row(self._rows.index(min(place, self._rows.rowCount() - 1), 0))
        self._on_search_changed(self._search.text())

    @property
    def _selected(self) -> list[QModelIndex]:
        return self._view.selectionModel().selectedRows()

    def _choose_row(self, index: QModelIndex) -> None:
        if index.isValid():
            flags = QItemSelectionModel.SelectionFlag
            self._view.selectionModel().setCurrentIndex(index, flags.ClearAndSelect | flags.Rows)
            self._view.scrollTo(index)

    @Slot(str)
    def _on_search_changed(self, text: str) -> None:
        self._rows.set_words(text)
        self._none.setVisible(bool(text.strip()) and self._rows.rowCount() == 0)

    def _fit_columns(self) -> None:
        self._view.resizeColumnsToContents()
        character = self.fontMetrics().averageCharWidth()
        for section in SnapshotColumn:
            size = self._view.columnWidth(section) + 2 * character
            self._view.setColumnWidth(section, min(size, _WIDEST * character))
