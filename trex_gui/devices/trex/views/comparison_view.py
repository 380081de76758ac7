"""Table that compares settings side by side."""

from collections.abc import Mapping
from types import MappingProxyType

from PySide6.QtCore import QSize, Qt, Signal, Slot
from PySide6.QtGui import QBrush, QFontMetrics, QKeyEvent, QPainter, QResizeEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QAbstractScrollArea,
    QHeaderView,
    QStyle,
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
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.builders import check_box, column, flat_table, label, row

_ROW_MARGIN = 16  # pixels
_MIN_ROWS = 3  # number of rows visible at the minimum height
_WITH_SIGN = {ComparisonColumn.SETTING, ComparisonColumn.AFTER, ComparisonColumn.OUTCOME}


class _Delegate(QStyledItemDelegate):
    def sizeHint(self, option: QStyleOptionViewItem, index: Index) -> QSize:
        size = super().sizeHint(option, index)
        return QSize(size.width(), size.height() + _ROW_MARGIN)

    def initStyleOption(self, option: QStyleOptionViewItem, index: Index) -> None:
        super().initStyleOption(option, index)
        if option.state & QStyle.StateFlag.State_Selected:  # the cells keep their text colours
            option.state &= ~QStyle.StateFlag.State_Selected
            option.backgroundBrush = QBrush(theme().color("selected"))

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Index) -> None:
        super().paint(painter, option, index)
        rect = option.rect
        painter.setPen(theme().color("hairline"))
        painter.drawLine(rect.bottomLeft(), rect.bottomRight())


class _Table(QTableView):
    """Table in which the space bar checks or unchecks the current row."""

    resized = Signal()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if event.size().width() != event.oldSize().width():
            self.resized.emit()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        model, current = self.model(), self.currentIndex()
        is_space = event.key() == Qt.Key.Key_Space
        if is_space and isinstance(model, ComparisonTable) and current.isValid():
            model.toggle(current.row())
        else:
            super().keyPressEvent(event)


class ComparisonView(QWidget):
    """Comparison table with a summary. Texts are never cut off, because users rely on them."""

    ticked_changed = Signal(int)  # number of checked changes

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.table = ComparisonTable(self)
        self._shown: object = None  # titles and options of the visible comparison

        self._all = check_box(self, "tickAllBox", tr("Select &all"), on_click=self._on_all_clicked)
        self._summary = label(self, "comparisonSummary", wrap=True, expand=True, size="caption")
        tip = tr("Show wire values, and settings that match")
        self._details = check_box(
            self, "detailsBox", tr("Deta&ils"), tip=tip, on_toggle=self._on_details_toggled
        )
        self._view = flat_table(_Table(self), "comparisonTable", tr("Comparison of settings"))
        self._view.setAlternatingRowColors(False)
        self._view.setModel(self.table)
        self._view.setItemDelegate(_Delegate(self._view))
        self._view.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self._view.setSizeAdjustPolicy(QAbstractScrollArea.SizeAdjustPolicy.AdjustToContents)
        header = self._view.horizontalHeader()
        header.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        header.setStretchLastSection(True)
        self._left_out = label(self, "comparisonLeftOut", wrap=True)
        top = row(self._all, (self._summary, 1), self._details)
        column(top, (self._view, 1), self._left_out, 0, into=self, margins=0)

        self.table.ticked_changed.connect(self._on_ticked_changed)
        for changed in (self.table.modelReset, self._view.resized):
            changed.connect(self._fit_columns)
        self._on_details_toggled(False)
        self.show_nothing()

    def show_comparison(
        self,
        comparison: Comparison,
        before: str,
        after: str,
        *,
        with_ticks: bool = True,
        outcomes: Mapping[str, str] = MappingProxyType({}),
        summary: str = "",
        tick_new: bool = True,
    ) -> None:
        """Show or update a comparison. `summary` is shown instead of the counts.

        `before` and `after` are the titles of the columns. Check boxes are reset if the titles,
        `with_ticks` or `outcomes` change. If `tick_new` is true, new changes are checked.
        """
        shown = (before, after, with_ticks, dict(outcomes))
        if shown == self._shown:
            if comparison != self.table.comparison:
                self.table.renew(comparison, tick_new=tick_new)
                self._view.resizeRowsToContents()
        else:
            self._shown = shown
            self.table.show_comparison(
                comparison, before, after, with_ticks=with_ticks, outcomes=outcomes
            )
        self._summary.setText(summary or f"{comparison.summary()}.")
        self._left_out.setText("\n".join(comparison.left_out))
        self._left_out.setVisible(bool(comparison.left_out))
        self._all.setVisible(with_ticks and comparison.offered > 3)
        self._update()

    def show_nothing(self, reason: str = "") -> None:
        """Hide the table and show the reason. The next comparison has all changes checked."""
        self.show_comparison(Comparison(()), "", "", summary=reason or " ")
        self._shown = None

    def _update(self) -> None:
        rows, header = self._view.verticalHeader(), self._view.horizontalHeader()
        visible_rows = range(min(self.table.rowCount(), _MIN_ROWS))
        min_height = sum(map(rows.sectionSize, visible_rows))
        self._view.setMinimumHeight(header.sizeHint().height() + min_height)
        self._view.setVisible(self.table.rowCount() > 0)
        self._details.setVisible(bool(self.table.comparison.rows))
        self._view.updateGeometry()

    @Slot()
    def _on_ticked_changed(self) -> None:
        ticked, offered = len(self.table.ticked), self.table.comparison.offered
        some = Qt.CheckState.PartiallyChecked if ticked else Qt.CheckState.Unchecked
        self._all.setCheckState(Qt.CheckState.Checked if ticked == offered else some)
        self.ticked_changed.emit(ticked)

    @Slot()
    def _on_all_clicked(self) -> None:
        self.table.tick_all(len(self.table.ticked) < self.table.comparison.offered)

    @Slot(bool)
    def _on_details_toggled(self, details: bool) -> None:
        self.table.set_with_equal(details)
        self._view.setColumnHidden(ComparisonColumn.WIRE, not details)
        self._fit_columns()

    @Slot()
    def _fit_columns(self) -> None:
        """Fit the columns to their content. If space is short, the widest columns wrap."""
        bar = self._view.verticalScrollBar()
        space = self._view.viewport().width() - (0 if bar.isVisible() else bar.sizeHint().width())
        margin = 2 * self.fontMetrics().averageCharWidth()
        title_width = self._view.horizontalHeader().sectionSizeHint
        cell_width, columns = self._view.sizeHintForColumn, range(self.table.columnCount())
        sections = [section for section in columns if not self._view.isColumnHidden(section)]
        widths = {
            section: max(cell_width(section), title_width(section)) + margin for section in sections
        }
        for number, section in enumerate(sorted(sections, key=widths.__getitem__)):
            share = max(space, 0) // (len(widths) - number)
            widths[section] = max(min(widths[section], share), self._min_width(section))
            space -= widths[section]
        spare = max(space, 0) // len(widths)
        for section, width in widths.items():
            self._view.setColumnWidth(section, width + spare)
        self._view.resizeRowsToContents()
        self._update()

    def _min_width(self, column: int) -> int:
        """Return the width of the longest word and the sign. Words do not wrap."""
        font = self._view.font()
        font.setBold(True)
        metrics, table = QFontMetrics(font), self.table
        texts = {table.index(row, column).data() for row in range(table.rowCount())}
        words = {word for text in texts for word in text.split()}
        longest = max((metrics.horizontalAdvance(word) for word in words), default=0)
        width = longest + metrics.height() * (2 if column in _WITH_SIGN else 1)
        return max(width, self._view.horizontalHeader().sectionSizeHint(column))
