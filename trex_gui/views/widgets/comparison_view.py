"""Settings side by side: what would change, what matches, and which changes are wanted."""

from collections.abc import Mapping

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, Qt, Signal, Slot
from PySide6.QtGui import QFont, QKeyEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QCheckBox,
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QPushButton,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTableView,
    QVBoxLayout,
    QWidget,
)

from trex_gui.model.comparison_table import ComparisonColumn, ComparisonRole, ComparisonTable
from trex_gui.settings.comparison import Comparison
from trex_gui.views.icons import icon
from trex_gui.views.theme import theme


class _Delegate(QStyledItemDelegate):
    """Lets what changes stand out, and marks what is stored and what is not."""

    def initStyleOption(
        self, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex
    ) -> None:
        super().initStyleOption(option, index)
        if index.data(ComparisonRole.CHANGED) and index.column() == ComparisonColumn.AFTER:
            font: QFont = option.font
            font.setBold(True)
            option.font = font
        if index.column() == ComparisonColumn.OUTCOME:
            failed, stored = index.data(ComparisonRole.FAILED), index.data(ComparisonRole.STORED)
            if failed or stored:
                option.icon = icon("warning" if failed else "ok")
                option.features |= QStyleOptionViewItem.ViewItemFeature.HasDecoration


class _Table(QTableView):
    """Lets the space bar tick a row, whatever column the keyboard is in."""

    def keyPressEvent(self, event: QKeyEvent) -> None:
        model, current = self.model(), self.currentIndex()
        if (
            event.key() == Qt.Key.Key_Space
            and isinstance(model, ComparisonTable)
            and current.isValid()
        ):
            model.toggle(current.row())
        else:
            super().keyPressEvent(event)


class ComparisonView(QWidget):
    """The table with its counts above it, and below what cannot be carried over.

    Signals:
        ticked_changed: how many changes are ticked.
    """

    ticked_changed = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._table = ComparisonTable(self)

        self._summary = QLabel(self)
        self._summary.setObjectName("comparisonSummary")
        self._summary.setWordWrap(True)
        self._all = QPushButton(self.tr("Tick all"), self)
        self._all.setObjectName("tickAllButton")
        self._none = QPushButton(self.tr("Tick none"), self)
        self._none.setObjectName("tickNoneButton")
        for button in (self._all, self._none):  # Enter means something else in a dialog
            button.setAutoDefault(False)
        self._equal = QCheckBox(self.tr("Show what matches, too"), self)
        self._equal.setObjectName("showEqualBox")
        self._view = _Table(self)
        self._view.setObjectName("comparisonTable")
        self._view.setAccessibleName(self.tr("Comparison of settings"))
        self._view.setModel(self._table)
        self._view.setItemDelegate(_Delegate(self._view))
        self._view.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self._view.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self._view.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self._view.setAlternatingRowColors(True)
        self._view.setShowGrid(False)
        self._view.setWordWrap(False)
        self._view.setTabKeyNavigation(False)
        self._view.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._view.verticalHeader().hide()
        self._view.verticalHeader().setDefaultSectionSize(self.fontMetrics().height() + 12)
        header = self._view.horizontalHeader()
        header.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        header.setHighlightSections(False)
        self._left_out = QLabel(self)
        self._left_out.setObjectName("comparisonLeftOut")
        self._left_out.setWordWrap(True)

        top = QHBoxLayout()
        top.addWidget(self._summary, 1)
        top.addWidget(self._equal)
        top.addWidget(self._all)
        top.addWidget(self._none)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addLayout(top)
        layout.addWidget(self._view, 1)
        layout.addWidget(self._left_out)

        self._all.clicked.connect(lambda: self._table.tick_all(True))
        self._none.clicked.connect(lambda: self._table.tick_all(False))
        self._equal.toggled.connect(self._table.set_with_equal)
        self._table.ticked_changed.connect(self._on_ticked_changed)
        self._table.modelReset.connect(self._fit_columns)
        theme().changed.connect(self._view.viewport().update)
        self.show_nothing()

    @property
    def table(self) -> ComparisonTable:
        """What is shown and ticked."""
        return self._table

    def show_comparison(
        self,
        comparison: Comparison,
        before: str,
        after: str,
        *,
        with_ticks: bool = True,
        summary: str = "",
    ) -> None:
        """Show a comparison with every change ticked; `before` and `after` head the columns.

        Args:
            comparison: what to show.
            before: what the left side is, in few words.
            after: what the right side is.
            with_ticks: whether a person chooses among the changes.
            summary: a sentence in place of the counts.
        """
        self._table.show_comparison(comparison, before, after, with_ticks=with_ticks)
        for button in (self._all, self._none):
            button.setVisible(with_ticks)
        self._describe(summary)

    def show_nothing(self, why: str = "") -> None:
        """Show an empty table, and say why."""
        self.show_comparison(Comparison(()), self.tr("Before"), self.tr("After"), with_ticks=False)
        self._summary.setText(why)

    def freeze(self, before: str, after: str) -> None:
        """Keep what is ticked, under new heads, with no tick to change: it is being written."""
        self._table.freeze(before, after)
        for button in (self._all, self._none, self._equal):
            button.hide()
        self._summary.clear()

    def show_outcomes(self, outcomes: Mapping[str, str]) -> None:
        """Say how writing went, by key: empty where it is stored, else why it is not."""
        self._table.set_outcomes(outcomes)
        self._fit_columns()

    def renew(self, comparison: Comparison, summary: str = "", *, tick_new: bool = True) -> None:
        """Show the same two sides as they are now; what was unticked stays so.

        Other changes are ticked; without `tick_new` only those that were there.
        """
        self._table.renew(comparison, tick_new=tick_new)
        self._describe(summary)

    def _describe(self, summary: str) -> None:
        comparison = self._table.comparison
        self._summary.setText(summary or f"{comparison.summary()}.")
        self._left_out.setText("\n".join(comparison.left_out))
        self._left_out.setVisible(bool(comparison.left_out))
        self._equal.setVisible(comparison.equal > 0)

    @Slot()
    def _on_ticked_changed(self) -> None:
        self.ticked_changed.emit(len(self._table.ticked))

    @Slot()
    def _fit_columns(self) -> None:
        """Give each column what it needs, and what is left to the physical values."""
        header = self._view.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.Interactive)
        self._view.resizeColumnsToContents()
        character = self.fontMetrics().averageCharWidth()
        for column, widest in (
            (ComparisonColumn.SETTING, 42),
            (ComparisonColumn.BEFORE, 40),
            (ComparisonColumn.AFTER, 44),
            (ComparisonColumn.WIRE, 24),
        ):
            size = header.sectionSize(column) + 2 * character
            header.resizeSection(column, min(size, widest * character))
        header.setStretchLastSection(True)
        self._make_room(2 * character, 18 * character)

    def _make_room(self, margin: int, narrowest: int) -> None:
        """Let long physical values be cut short before the last column is."""
        if not self._view.isVisible():
            return
        header, last = self._view.horizontalHeader(), self._table.columnCount() - 1
        bar = self._view.verticalScrollBar()
        room = self._view.viewport().width() - (0 if bar.isVisible() else bar.sizeHint().width())
        needed = sum(header.sectionSize(column) for column in range(last))
        excess = needed + self._view.sizeHintForColumn(last) + margin - room
        for column in (ComparisonColumn.AFTER, ComparisonColumn.BEFORE):
            size, least = header.sectionSize(column), header.sectionSizeHint(column)
            least = max(least, narrowest)
            if excess > 0 and size > least:
                header.resizeSection(column, max(least, size - excess))
                excess -= size - header.sectionSize(column)
