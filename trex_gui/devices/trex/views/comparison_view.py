"""Settings side by side: what would change, what matches, and which changes to make."""

from PySide6.QtCore import QSize, Qt, Signal, Slot
from PySide6.QtGui import QFontMetrics, QKeyEvent, QResizeEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTableView,
    QWidget,
)

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.settings.comparison_table import (
    ComparisonColumn,
    ComparisonTable,
    Index,
)
from trex_gui.devices.trex.settings.comparison import Comparison
from trex_gui.ui.widgets.builders import button, check_box, column, flat_table, label, row

_ROW_MARGIN = 8


class _Delegate(QStyledItemDelegate):
    def sizeHint(self, option: QStyleOptionViewItem, index: Index) -> QSize:
        size = super().sizeHint(option, index)
        return QSize(size.width(), size.height() + _ROW_MARGIN)


class _Table(QTableView):
    """Lets the space bar tick a row from any column."""

    resized = Signal()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.resized.emit()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        model, current = self.model(), self.currentIndex()
        is_space = event.key() == Qt.Key.Key_Space
        if is_space and isinstance(model, ComparisonTable) and current.isValid():
            model.toggle(current.row())
        else:
            super().keyPressEvent(event)


class ComparisonView(QWidget):
    """Counts, table and settings left out; no text is cut: it decides what is written."""

    ticked_changed = Signal(int)  # the number of ticked changes

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.table = ComparisonTable(self)
        self._fitting = False
        self._widths_chosen = False
        self._has_comparison = False

        self._summary = label(self, "comparisonSummary", wrap=True)
        text = tr("Show &matching settings, too")
        self._equal = check_box(self, "showEqualBox", text, on_toggle=self._on_equal_toggled)
        # Not default: Enter means something else in a dialog.
        self._all = button(self, "tickAllButton", tr("Select &all"), default=False)
        self._none = button(self, "tickNoneButton", tr("Select &none"), default=False)
        self._view = flat_table(_Table(self), "comparisonTable", tr("Comparison of settings"))
        self._view.setModel(self.table)
        self._view.setItemDelegate(_Delegate(self._view))
        self._view.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        header = self._view.horizontalHeader()
        header.setStretchLastSection(True)
        self._left_out = label(self, "comparisonLeftOut", wrap=True)

        top = row((self._summary, 1), self._equal, self._all, self._none)
        column(top, (self._view, 1), self._left_out, into=self, margins=0)

        self._all.clicked.connect(lambda: self.table.tick_all(True))
        self._none.clicked.connect(lambda: self.table.tick_all(False))
        self.table.ticked_changed.connect(lambda: self.ticked_changed.emit(len(self.table.ticked)))
        self.table.modelReset.connect(self._fit_columns)
        self.table.columnsInserted.connect(self._fit_columns)
        self._view.resized.connect(self._on_resized)
        header.sectionResized.connect(self._on_section_resized)
        self.show_nothing()

    def show_comparison(
        self,
        comparison: Comparison,
        before: str,
        after: str,
        *,
        with_ticks: bool = True,
        summary: str = "",
        keep_ticks: bool = False,
    ) -> None:
        """Show a comparison with every change ticked; `summary` replaces the counts.

        `before` and `after` head the two sides; `with_ticks`: the user chooses among the changes.
        With `keep_ticks` a comparison that is shown is only renewed.
        """
        if keep_ticks and self._has_comparison:
            self.renew(comparison, summary)
            return
        self.table.show_comparison(comparison, before, after, with_ticks=with_ticks)
        self._all.setVisible(with_ticks)
        self._none.setVisible(with_ticks)
        self._has_comparison = True
        self._describe(summary)

    def show_nothing(self, reason: str = "") -> None:
        """Show an empty table, and why it is empty."""
        before, after = tr("Before", "value"), tr("After", "value")
        self.show_comparison(Comparison(()), before, after, with_ticks=False)
        self._has_comparison = False
        self._summary.setText(reason)

    def freeze(self, before: str, after: str) -> None:
        """Keep the checked rows under new headings, without check boxes, while writing."""
        self.table.freeze(before, after)
        for part in (self._all, self._none, self._equal):
            part.hide()
        self._summary.clear()

    def renew(self, comparison: Comparison, summary: str = "", *, tick_new: bool = True) -> None:
        """Update both sides; cleared check boxes stay cleared, new changes get `tick_new`."""
        self.table.renew(comparison, tick_new=tick_new)
        self._view.resizeRowsToContents()
        self._describe(summary)

    def _describe(self, summary: str) -> None:
        comparison = self.table.comparison
        self._summary.setText(summary or f"{comparison.summary()}.")
        self._left_out.setText("\n".join(comparison.left_out))
        self._left_out.setVisible(bool(comparison.left_out))
        self._equal.setVisible(comparison.equal > 0)

    @Slot(bool)
    def _on_equal_toggled(self, with_equal: bool) -> None:
        self.table.set_with_equal(with_equal)
        self._view.resizeRowsToContents()

    @Slot()
    def _on_resized(self) -> None:
        if self._widths_chosen:
            self._view.resizeRowsToContents()
        else:
            self._fit_columns()

    @Slot(int, int, int)
    def _on_section_resized(self, column: int, _before: int, _after: int) -> None:
        if not self._fitting:
            # The last one stretches by itself.
            self._widths_chosen |= column < self.table.columnCount() - 1
            self._view.resizeRowsToContents()

    @Slot()
    def _fit_columns(self) -> None:
        """Give each column the width that it needs; if there is too little, wrap the widest."""
        self._widths_chosen = False
        self._fitting = True
        bar = self._view.verticalScrollBar()
        room = self._view.viewport().width() - (0 if bar.isVisible() else bar.sizeHint().width())
        margin = 2 * self.fontMetrics().averageCharWidth()
        title_width = self._view.horizontalHeader().sectionSizeHint
        cell_width, sections = self._view.sizeHintForColumn, range(self.table.columnCount())
        wanted = [max(cell_width(at), title_width(at)) + margin for at in sections]
        narrowest_first = sorted(sections, key=wanted.__getitem__)
        for number, section in enumerate(narrowest_first):
            share = max(room, 0) // (len(wanted) - number)
            width = max(min(wanted[section], share), self._least_width(section))
            self._view.setColumnWidth(section, width)
            room -= width
        self._fitting = False
        self._view.resizeRowsToContents()

    def _least_width(self, column: int) -> int:
        """Return the width of the longest word, which cannot be wrapped, and its box or sign."""
        font = self._view.font()
        font.setBold(True)
        metrics, table = QFontMetrics(font), self.table
        texts = {table.index(row, column).data() for row in range(table.rowCount())}
        words = {word for text in texts for word in text.split()}
        longest = max((metrics.horizontalAdvance(word) for word in words), default=0)
        has_sign = column in {ComparisonColumn.SETTING, ComparisonColumn.OUTCOME}
        least = longest + metrics.height() * (2 if has_sign else 1)
        return max(least, self._view.horizontalHeader().sectionSizeHint(column))
