"""The list of snapshots, and the field that searches it."""

from pathlib import Path
from typing import cast

from PySide6.QtCore import (
    QItemSelectionModel,
    QModelIndex,
    QPersistentModelIndex,
    Qt,
    Signal,
    Slot,
)
from PySide6.QtGui import QKeyEvent, QKeySequence, QShortcut
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
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.behaviour import name_headers
from trex_gui.ui.widgets.builders import column, label

_WIDEST = 34  # characters of a column, to begin with


class _Delegate(QStyledItemDelegate):
    """Marks what is damaged."""

    def initStyleOption(
        self, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex
    ) -> None:
        super().initStyleOption(option, index)
        if index.column() == SnapshotColumn.BOARD and index.data(SnapshotRole.PROBLEM):
            option.icon = icon("warning", "warning")
            option.features |= QStyleOptionViewItem.ViewItemFeature.HasDecoration


class _View(QTableView):
    """Tells of the Delete key.

    Signals:
        delete_pressed: what is selected shall go.
    """

    delete_pressed = Signal()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.matches(QKeySequence.StandardKey.Delete):
            self.delete_pressed.emit()
        else:
            super().keyPressEvent(event)


class SnapshotList(QWidget):
    """The newest first; one or several may be chosen.

    Signals:
        chosen_changed: others are chosen.
        delete_requested: the Delete key was pressed.
    """

    chosen_changed = Signal()
    delete_requested = Signal()

    def __init__(self, table: SnapshotTable, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._table = table
        self._rows = SnapshotFilter(table, self)

        self._search = QLineEdit(self)
        self._search.setObjectName("snapshotSearch")
        self._search.setAccessibleName(self.tr("Search snapshots"))
        self._search.setPlaceholderText(self.tr("Search times, boards, adapters (Ctrl+F)"))
        self._search.setClearButtonEnabled(True)
        self._view = _View(self)
        self._view.setObjectName("snapshotView")
        self._view.setAccessibleName(self.tr("Snapshots"))
        name_headers(self._view)
        self._view.setModel(self._rows)
        self._view.setItemDelegate(_Delegate(self._view))
        self._view.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self._view.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self._view.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self._view.setAlternatingRowColors(True)
        self._view.setShowGrid(False)
        self._view.setWordWrap(False)
        self._view.setTabKeyNavigation(False)
        self._view.verticalHeader().hide()
        self._view.verticalHeader().setDefaultSectionSize(self.fontMetrics().height() + 12)
        header = self._view.horizontalHeader()
        header.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        header.setHighlightSections(False)
        header.setStretchLastSection(True)
        header.setResizeContentsPrecision(50)  # rows that are looked at for a width
        self._none = label(self, "snapshotNoMatch", self.tr("No snapshot has these words."))

        column(self._search, (self._view, 1), self._none, into=self, margins=0)

        QShortcut(QKeySequence.StandardKey.Find, self.window(), self._search.setFocus)
        self._view.delete_pressed.connect(self.delete_requested)
        self._search.textChanged.connect(self._on_search_changed)
        self._view.selectionModel().selectionChanged.connect(self.chosen_changed)
        theme().changed.connect(self._view.viewport().update)
        self._on_search_changed("")

    @property
    def chosen(self) -> tuple[Snapshot, ...]:
        """What is selected, the newest first."""
        rows = sorted(index.row() for index in self._view.selectionModel().selectedRows())
        return tuple(
            cast("Snapshot", self._rows.index(row, 0).data(SnapshotRole.SNAPSHOT)) for row in rows
        )

    def choose(self, path: Path) -> None:
        """Select one snapshot, and nothing else."""
        row = self._table.row_of(path)
        if row is not None:
            self._choose_row(self._rows.mapFromSource(self._table.index(row, 0)))

    def refresh(self) -> None:
        """Look at the folder again; where all that was chosen is gone, choose what is there."""
        was_empty = self._table.rowCount() == 0
        chosen = {snapshot.path for snapshot in self.chosen}
        place = min((index.row() for index in self._selected), default=0)
        self._table.refresh()
        if was_empty:
            self._fit_columns()
        if not self._selected and self._rows.rowCount() and (chosen or was_empty):
            self._choose_row(self._rows.index(min(place, self._rows.rowCount() - 1), 0))
        self._on_search_changed(self._search.text())

    @property
    def _selected(self) -> list[QModelIndex]:
        return self._view.selectionModel().selectedRows()

    def _choose_row(self, index: QModelIndex) -> None:
        if index.isValid():
            self._view.selectionModel().setCurrentIndex(
                index,
                QItemSelectionModel.SelectionFlag.ClearAndSelect
                | QItemSelectionModel.SelectionFlag.Rows,
            )
            self._view.scrollTo(index)

    @Slot(str)
    def _on_search_changed(self, text: str) -> None:
        self._rows.set_words(text)
        self._none.setVisible(bool(text.strip()) and self._rows.rowCount() == 0)

    def _fit_columns(self) -> None:
        """Give each column what it needs, within reason; a person may change that."""
        self._view.resizeColumnsToContents()
        character = self.fontMetrics().averageCharWidth()
        for section in SnapshotColumn:
            size = self._view.columnWidth(section) + 2 * character
            self._view.setColumnWidth(section, min(size, _WIDEST * character))
