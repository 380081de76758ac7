"""The legend as a table: which curves are drawn, their values and their statistics."""

import math
from enum import IntEnum, auto

from PySide6.QtCore import (
    QAbstractTableModel,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    QSize,
    Qt,
    Slot,
)
from PySide6.QtGui import QColor, QPixmap
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTableView, QWidget

from trex_gui.ui.plotting.data.history import Statistics
from trex_gui.ui.plotting.data.traces import TraceInfo
from trex_gui.ui.plotting.marks import charge_text, mean_text, value_text
from trex_gui.ui.plotting.plot import TracePlot
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.bar import MINUS
from trex_gui.ui.widgets.behaviour import name_headers

Index = QModelIndex | QPersistentModelIndex

_RIGHT = int(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)

_PADDING = 8
"""Pixels around the text of a cell, as the style paints it."""


class TraceColumn(IntEnum):
    """The columns, in order."""

    CURVE = 0
    NOW = auto()
    PEAK = auto()
    MEAN = auto()
    RMS = auto()
    CHARGE = auto()
    LIMIT = auto()
    CURSOR = auto()
    DIFFERENCE = auto()
    HELD = auto()
    LOW = auto()


class TraceTable(QAbstractTableModel):
    """A row for each curve of a plot; checking a row draws the curve.

    Low, peak, mean, RMS and charge are those of the span that the plot shows.
    """

    def __init__(self, plot: TracePlot, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._plot = plot
        self._traces: tuple[TraceInfo, ...] = ()
        self._statistics: dict[str, Statistics] = {}
        span = self.tr("of what the plot shows")
        self._heads = {
            TraceColumn.CURVE: (self.tr("Curve"), self.tr("Check what is to be drawn")),
            TraceColumn.NOW: (self.tr("Now"), self.tr("The newest value")),
            TraceColumn.PEAK: (self.tr("Peak"), self.tr("The highest value {0}").format(span)),
            TraceColumn.MEAN: (self.tr("Mean"), self.tr("The mean over time {0}").format(span)),
            TraceColumn.RMS: (
                self.tr("RMS"),
                self.tr("The root mean square {0}: what heats wires").format(span),
            ),
            TraceColumn.CHARGE: (
                self.tr("Charge"),
                self.tr("Ampere times time {0}; gaps count nothing").format(span),
            ),
            TraceColumn.LIMIT: (
                self.tr("Limit"),
                self.tr("The current limit that the board stores"),
            ),
            TraceColumn.CURSOR: (self.tr("Cursor"), self.tr("The value under the cursor")),
            TraceColumn.DIFFERENCE: (
                self.tr("To mark"),
                self.tr("From the mark to the cursor; click into the plot or press M to set it"),
            ),
            TraceColumn.HELD: (
                self.tr("Held"),
                self.tr("The highest value since Hold peaks was switched on"),
            ),
            TraceColumn.LOW: (self.tr("Low"), self.tr("The lowest value {0}").format(span)),
        }
        theme().changed.connect(self._on_theme_changed)
        self.show_source()

    def show_source(self) -> None:
        """Take the curves of the plot's source."""
        self.beginResetModel()
        self._traces = self._plot.source.traces if self._plot.source is not None else ()
        self._statistics = {}
        self.endResetModel()
        self.refresh()

    def refresh(self) -> None:
        """Show the values of now, for the curves that are drawn."""
        source, span = self._plot.source, self._plot.span
        if source is None or not self._traces:
            return
        self._statistics = {
            trace.name: source.statistics(trace.name, span.start, span.end)
            for trace in self._traces
            if trace.name in self._plot.shown
        }
        self._emit_changed(TraceColumn.LIMIT, Qt.ItemDataRole.DisplayRole)

    def _emit_changed(self, last: TraceColumn, role: Qt.ItemDataRole) -> None:
        if self._traces:
            end = self.index(len(self._traces) - 1, last)
            self.dataChanged.emit(self.index(0, 0), end, [role])

    @Slot()
    def _on_theme_changed(self) -> None:
        self._emit_changed(TraceColumn.CURVE, Qt.ItemDataRole.DecorationRole)

    def is_needed(self, column: TraceColumn) -> bool:
        """Return whether a column has values: some depend on what the user has set."""
        match column:
            case TraceColumn.DIFFERENCE:
                return self._plot.mark_time is not None
            case TraceColumn.HELD:
                return self._plot.peaks_since is not None
            case TraceColumn.LIMIT if self._plot.source is not None:
                return bool(self._plot.source.limits)
        return True

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008 - as Qt has it
        return 0 if parent.isValid() else len(self._traces)

    def columnCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008 - as Qt has it
        return 0 if parent.isValid() else len(TraceColumn)

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> object:
        if orientation != Qt.Orientation.Horizontal:
            return None
        column = TraceColumn(section)
        match role:
            case Qt.ItemDataRole.DisplayRole:
                return self._heads[column][0]
            case Qt.ItemDataRole.ToolTipRole:
                return self._heads[column][1]
            case Qt.ItemDataRole.TextAlignmentRole if column is not TraceColumn.CURVE:
                return _RIGHT
        return None

    def flags(self, index: Index) -> Qt.ItemFlag:
        flags = super().flags(index)
        if index.isValid() and index.column() == TraceColumn.CURVE:
            flags |= Qt.ItemFlag.ItemIsUserCheckable
        return flags

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        if not index.isValid():
            return None
        trace, column = self._traces[index.row()], TraceColumn(index.column())
        if column is not TraceColumn.CURVE:
            match role:
                case Qt.ItemDataRole.DisplayRole:
                    return self._text(trace, column)
                case Qt.ItemDataRole.TextAlignmentRole:
                    return _RIGHT
                case Qt.ItemDataRole.AccessibleTextRole:
                    return f"{trace.label}, {self._heads[column][0]}: {self._text(trace, column)}"
            return None
        match role:
            case Qt.ItemDataRole.DisplayRole | Qt.ItemDataRole.AccessibleTextRole:
                return trace.label
            case Qt.ItemDataRole.CheckStateRole:
                shown = trace.name in self._plot.shown
                return Qt.CheckState.Checked if shown else Qt.CheckState.Unchecked
            case Qt.ItemDataRole.DecorationRole:
                return _swatch(theme().color(trace.color))
        return None

    def setData(self, index: Index, value: object, role: int = Qt.ItemDataRole.EditRole) -> bool:
        if role != Qt.ItemDataRole.CheckStateRole or index.column() != TraceColumn.CURVE:
            return False
        shown = Qt.CheckState(value) == Qt.CheckState.Checked
        self._plot.set_shown(self._traces[index.row()].name, shown)
        self.dataChanged.emit(index, index, [role])
        self.refresh()
        return True

    def _text(self, trace: TraceInfo, column: TraceColumn) -> str:
        plot, name, unit = self._plot, trace.name, trace.unit
        source = plot.source
        if source is None or (name not in plot.shown and column is not TraceColumn.LIMIT):
            return ""
        found = self._statistics.get(name, Statistics())
        cursor = math.nan
        if plot.cursor_time is not None:
            cursor = source.value_at(name, plot.cursor_time)
        value: float | None = math.nan
        match column:
            case TraceColumn.NOW if source.span is not None:
                value = source.value_at(name, source.span[1])
            case TraceColumn.CURSOR:
                value = cursor
            case TraceColumn.DIFFERENCE:
                value = None
                if plot.mark_time is not None and plot.cursor_time is not None:
                    value = cursor - source.value_at(name, plot.mark_time)
            case TraceColumn.LOW | TraceColumn.PEAK:
                value = found.low if column is TraceColumn.LOW else found.high
            case TraceColumn.MEAN | TraceColumn.RMS:
                return mean_text(found.mean if column is TraceColumn.MEAN else found.rms, unit)
            case TraceColumn.CHARGE:
                return charge_text(found) if unit == "A" else ""
            case TraceColumn.HELD:
                value = plot.peak_of(name)
            case TraceColumn.LIMIT:
                value = source.limits.get(name)
        return "" if value is None else value_text(value, unit)


def _swatch(color: QColor) -> QPixmap:
    picture = QPixmap(14, 4)
    picture.fill(color)
    return picture


class TraceTableView(QTableView):
    """The table below a plot: as high as four curves, more by scrolling."""

    def __init__(self, model: TraceTable, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._table = model
        self.setObjectName("traceTable")
        self.setAccessibleName(self.tr("Curves and their figures"))
        name_headers(self)
        self.setModel(model)
        self.verticalHeader().hide()
        self._row = self.fontMetrics().height() + 6
        self.verticalHeader().setDefaultSectionSize(self._row)
        self.verticalHeader().setMinimumSectionSize(self._row)
        self.setShowGrid(False)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setTabKeyNavigation(False)
        header = self.horizontalHeader()
        header.setHighlightSections(False)
        for column in TraceColumn:
            widest = "000.00 mAh" if column is TraceColumn.CHARGE else f"{MINUS}00.00 A"
            head = str(model.headerData(column, Qt.Orientation.Horizontal))
            width = max(self.fontMetrics().horizontalAdvance(text) for text in (widest, head))
            header.resizeSection(column, width + _PADDING)
        header.setSectionResizeMode(TraceColumn.CURVE, QHeaderView.ResizeMode.ResizeToContents)
        header.setStretchLastSection(False)
        self.show_needed_columns()

    def show_needed_columns(self) -> None:
        """Hide the columns without values, so that the others have room."""
        for column in TraceColumn:
            if self.isColumnHidden(column) == self._table.is_needed(column):
                self.setColumnHidden(column, not self._table.is_needed(column))

    def full_width(self) -> int:
        """Return the width that shows every column."""
        bar = self.verticalScrollBar()
        beside = bar.sizeHint().width() if bar.isVisibleTo(self) else 0
        return self.horizontalHeader().length() + beside + 2 * self.frameWidth() + 2

    def _height_of(self, rows: float) -> int:
        return self.horizontalHeader().sizeHint().height() + round(rows * self._row)

    def sizeHint(self) -> QSize:
        # Half a row shows that there are more.
        return QSize(self.horizontalHeader().length(), self._height_of(4.5))

    def minimumSizeHint(self) -> QSize:
        return QSize(self._row * 8, self._height_of(2.5))
