"""Settings side by side: what would change, what matches, and which changes are wanted."""

from collections.abc import Mapping

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QSize, Qt, Signal, Slot
from PySide6.QtGui import QFont, QFontMetrics, QKeyEvent, QResizeEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QCheckBox,
    QPushButton,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTableView,
    QWidget,
)

from trex_gui.devices.trex.model.settings.comparison_table import (
    ComparisonColumn,
    ComparisonRole,
    ComparisonTable,
)
from trex_gui.devices.trex.settings.comparison import Comparison
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.behaviour import name_headers
from trex_gui.ui.widgets.builders import column, label, row

_ROW_MARGIN = 8


class _Delegate(QStyledItemDelegate):
    """Lets what changes stand out, and marks what is stored and what is not."""

    def sizeHint(
        self, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex
    ) -> QSize:
        size = super().sizeHint(option, index)
        return QSize(size.width(), size.height() + _ROW_MARGIN)

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
    """Lets the space bar check a row, whatever column the keyboard is in.

    Signals:
        resized: it has more or less room.
    """

    resized = Signal()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.resized.emit()

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

    Nothing in it is cut short: what a value means in full decides whether it may be written.

    Signals:
        ticked_changed: how many changes are ticked.
    """

    ticked_changed = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._table = ComparisonTable(self)
        self._fitting = False
        self._widths_chosen = False

        self._summary = label(self, "comparisonSummary", wrap=True)
        self._all = QPushButton(self.tr("Select all"), self)
        self._all.setObjectName("tickAllButton")
        self._none = QPushButton(self.tr("Select none"), self)
        self._none.setObjectName("tickNoneButton")
        for button in (self._all, self._none):  # Enter means something else in a dialog
            button.setAutoDefault(False)
        self._equal = QCheckBox(self.tr("Show what matches, too"), self)
        self._equal.setObjectName("showEqualBox")
        self._view = _Table(self)
        self._view.setObjectName("comparisonTable")
        self._view.setAccessibleName(self.tr("Comparison of settings"))
        name_headers(self._view)
        self._view.setModel(self._table)
        self._view.setItemDelegate(_Delegate(self._view))
        self._view.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self._view.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self._view.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self._view.setAlternatingRowColors(True)
        self._view.setShowGrid(False)
        self._view.setWordWrap(True)
        self._view.setTabKeyNavigation(False)
        self._view.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self._view.verticalHeader().hide()
        self._view.verticalHeader().setDefaultSectionSize(self.fontMetrics().height() + 12)
        header = self._view.horizontalHeader()
        header.setStretchLastSection(True)
        header.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        header.setHighlightSections(False)
        self._left_out = label(self, "comparisonLeftOut", wrap=True)

        top = row((self._summary, 1), self._equal, self._all, self._none)
        column(top, (self._view, 1), self._left_out, into=self, margins=0)

        self._all.clicked.connect(lambda: self._table.tick_all(True))
        self._none.clicked.connect(lambda: self._table.tick_all(False))
        self._equal.toggled.connect(self._on_equal_toggled)
        self._table.ticked_changed.connect(self._on_ticked_changed)
        self._table.modelReset.connect(self._fit_columns)
        self._view.resized.connect(self._on_resized)
        header.sectionResized.connect(self._on_section_resized)
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
            with_ticks: whether the user chooses among the changes.
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
        """Keep the checked rows under new headings, with the check boxes fixed, while writing."""
        self._table.freeze(before, after)
        for button in (self._all, self._none, self._equal):
            button.hide()
        self._summary.clear()

    def show_outcomes(self, outcomes: Mapping[str, str]) -> None:
        """Say how writing went, by key: empty where it is stored, else why it is not."""
        self._table.set_outcomes(outcomes)
        self._fit_columns()

    def renew(self, comparison: Comparison, summary: str = "", *, tick_new: bool = True) -> None:
        """Update both sides; cleared check boxes stay cleared.

        Other changes are ticked; without `tick_new` only those that were there.
        """
        self._table.renew(comparison, tick_new=tick_new)
        self._fit_rows()
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

    @Slot(bool)
    def _on_equal_toggled(self, with_equal: bool) -> None:
        self._table.set_with_equal(with_equal)
        self._fit_rows()

    # --- Room for every word ------------------------------------------------------------

    @Slot()
    def _on_resized(self) -> None:
        if self._widths_chosen:
            self._fit_rows()
        else:
            self._fit_columns()

    @Slot(int, int, int)
    def _on_section_resized(self, column: int, _before: int, _after: int) -> None:
        if self._fitting:
            return
        if column < self._table.columnCount() - 1:  # the last follows by itself
            self._widths_chosen = True
        self._fit_rows()

    @Slot()
    def _fit_columns(self) -> None:
        """Give each column what it needs; where that is too much, wrap the widest first."""
        self._widths_chosen = False
        self._fitting = True
        header, count = self._view.horizontalHeader(), self._table.columnCount()
        wanted = {section: self._wanted_width(section) for section in range(count)}
        room = self._room()
        for number, section in enumerate(sorted(wanted, key=lambda section: wanted[section])):
            share = max(room, 0) // (count - number)
            width = max(min(wanted[section], share), self._least_width(section))
            header.resizeSection(section, width)
            room -= width
        self._fitting = False
        self._fit_rows()

    @Slot()
    def _fit_rows(self) -> None:
        """Let each row be as high as its text is at these widths."""
        self._view.resizeRowsToContents()

    def _room(self) -> int:
        """Width for the columns, with a scroll bar or without one yet."""
        bar = self._view.verticalScrollBar()
        hidden = 0 if bar.isVisible() else bar.sizeHint().width()
        return self._view.viewport().width() - hidden

    def _wanted_width(self, column: int) -> int:
        header = self._view.horizontalHeader()
        wanted = max(self._view.sizeHintForColumn(column), header.sectionSizeHint(column))
        return wanted + 2 * self.fontMetrics().averageCharWidth()

    def _least_width(self, column: int) -> int:
        """Width of the longest word, which cannot be wrapped, with its tick or sign."""
        font = self._view.font()
        font.setBold(True)
        metrics, table = QFontMetrics(font), self._table
        texts = {str(table.index(row, column).data() or "") for row in range(table.rowCount())}
        words = {word for text in texts for word in text.split()}
        longest = max((metrics.horizontalAdvance(word) for word in words), default=0)
        has_sign = column in {ComparisonColumn.SETTING, ComparisonColumn.OUTCOME}
        sign = 2 * metrics.height() if has_sign else metrics.height()
        header = self._view.horizontalHeader()
        return max(longest + sign, header.sectionSizeHint(column))
