"""The legend as a table: which curves are drawn, their values and what they come to."""

import math
from enum import IntEnum, auto

from PySide6.QtCore import (
    QAbstractTableModel,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    QSize,
    Qt,
)
from PySide6.QtGui import QColor, QPixmap
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTableView, QWidget

from trex_gui.ui.plotting.data.history import Statistics
from trex_gui.ui.plotting.data.traces import TraceInfo
from trex_gui.ui.plotting.number_format import charge_text, mean_text, value_text
from trex_gui.ui.plotting.plot import TracePlot
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.header_names import name_headers

Index = QModelIndex | QPersistentModelIndex


class TraceColumn(IntEnum):
    """What stands where."""

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
    """A row for each curve of a plot; ticking a row draws the curve.

    Low, peak, mean, RMS and charge are those of what the plot shows.
    """

    def __init__(self, plot: TracePlot, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._plot = plot
        self._traces: tuple[TraceInfo, ...] = ()
        self._statistics: dict[str, Statistics] = {}
        self.show_source()

    def show_source(self) -> None:
        """Take the curves of the plot's source."""
        self.beginResetModel()
        source = self._plot.source
        self._traces = tuple(source.traces) if source is not None else ()
        self._statistics = {}
        self.endResetModel()
        self.refresh()

    def refresh(self) -> None:
        """Show the values of now; those of curves that are not drawn are left out."""
        source, span = self._plot.source, self._plot.span
        if source is None or not self._traces:
            return
        self._statistics = {
            trace.name: source.statistics(trace.name, span.start, span.end)
            for trace in self._traces
            if trace.name in self._plot.shown
        }
        last = self.index(len(self._traces) - 1, TraceColumn.LIMIT)
        self.dataChanged.emit(self.index(0, 0), last, [Qt.ItemDataRole.DisplayRole])

    def is_of_use(self, column: TraceColumn) -> bool:
        """Whether a column has anything to say: some wait for what a person does."""
        source = self._plot.source
        match column:
            case TraceColumn.DIFFERENCE:
                return self._plot.mark_time is not None
            case TraceColumn.HELD:
                return self._plot.peaks_since is not None
            case TraceColumn.LIMIT if source is not None:
                return any(source.limits.get(trace.name) is not None for trace in self._traces)
        return True

    def recolour(self) -> None:
        """Take the colours of the theme as it is now."""
        if self._traces:
            last = self.index(len(self._traces) - 1, 0)
            self.dataChanged.emit(self.index(0, 0), last, [Qt.ItemDataRole.DecorationRole])

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
        if role == Qt.ItemDataRole.DisplayRole:
            return self._heads()[column][0]
        if role == Qt.ItemDataRole.ToolTipRole:
            return self._heads()[column][1]
        if role == Qt.ItemDataRole.TextAlignmentRole and column is not TraceColumn.CURVE:
            return _RIGHT
        return None

    def _heads(self) -> dict[TraceColumn, tuple[str, str]]:
        shown = self.tr("of what the plot shows")
        return {
            TraceColumn.CURVE: (self.tr("Curve"), self.tr("Tick what is to be drawn")),
            TraceColumn.NOW: (self.tr("Now"), self.tr("The newest value")),
            TraceColumn.CURSOR: (self.tr("Cursor"), self.tr("The value under the cursor")),
            TraceColumn.DIFFERENCE: (
                self.tr("To mark"),
                self.tr("From the mark to the cursor; click into the plot or press M to set it"),
            ),
            TraceColumn.LOW: (self.tr("Low"), self.tr("The smallest value {0}").format(shown)),
            TraceColumn.PEAK: (self.tr("Peak"), self.tr("The greatest value {0}").format(shown)),
            TraceColumn.MEAN: (self.tr("Mean"), self.tr("The mean over time {0}").format(shown)),
            TraceColumn.RMS: (
                self.tr("RMS"),
                self.tr("The root of the mean square {0}: what heats wires").format(shown),
            ),
            TraceColumn.CHARGE: (
                self.tr("Charge"),
                self.tr("Ampere times time {0}; nothing is counted for gaps").format(shown),
            ),
            TraceColumn.HELD: (
                self.tr("Held"),
                self.tr("The greatest value since Hold peaks was switched on"),
            ),
            TraceColumn.LIMIT: (
                self.tr("Limit"),
                self.tr("The current limit that the board stores"),
            ),
        }

    def flags(self, index: Index) -> Qt.ItemFlag:
        flags = super().flags(index)
        if index.isValid() and index.column() == TraceColumn.CURVE:
            flags |= Qt.ItemFlag.ItemIsUserCheckable
        return flags

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        if not index.isValid():
            return None
        trace, column = self._traces[index.row()], TraceColumn(index.column())
        match role:
            case Qt.ItemDataRole.DisplayRole:
                return trace.label if column is TraceColumn.CURVE else self._text(trace, column)
            case Qt.ItemDataRole.CheckStateRole if column is TraceColumn.CURVE:
                shown = trace.name in self._plot.shown
                return Qt.CheckState.Checked if shown else Qt.CheckState.Unchecked
            case Qt.ItemDataRole.DecorationRole if column is TraceColumn.CURVE:
                return _swatch(theme().color(trace.color))
            case Qt.ItemDataRole.TextAlignmentRole if column is not TraceColumn.CURVE:
                return _RIGHT
            case Qt.ItemDataRole.AccessibleTextRole:
                head = self._heads()[column][0]
                text = trace.label if column is TraceColumn.CURVE else self._text(trace, column)
                return f"{trace.label}, {head}: {text}" if column is not TraceColumn.CURVE else text
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
        source, name = self._plot.source, trace.name
        if source is None or (name not in self._plot.shown and column is not TraceColumn.LIMIT):
            return ""
        found = self._statistics.get(name, Statistics())
        value = math.nan
        match column:
            case TraceColumn.NOW:
                span = source.span
                value = source.value_at(name, span[1]) if span is not None else math.nan
            case TraceColumn.CURSOR:
                value = self._at_cursor(name)
            case TraceColumn.DIFFERENCE:
                return self._difference(trace)
            case TraceColumn.LOW:
                value = found.low
            case TraceColumn.PEAK:
                value = found.high
            case TraceColumn.MEAN:
                return mean_text(found.mean, trace.unit)
            case TraceColumn.RMS:
                return mean_text(found.rms, trace.unit)
            case TraceColumn.CHARGE:
                return charge_text(found) if trace.unit == "A" else ""
            case TraceColumn.HELD:
                held = self._plot.peak_of(name)
                return "" if held is None else value_text(held, trace.unit)
            case TraceColumn.LIMIT:
                limit = source.limits.get(name)
                return "" if limit is None else value_text(limit, trace.unit)
        return value_text(value, trace.unit)

    def _at_cursor(self, name: str) -> float:
        source, cursor = self._plot.source, self._plot.cursor_time
        if source is None or cursor is None:
            return math.nan
        return source.value_at(name, cursor)

    def _difference(self, trace: TraceInfo) -> str:
        source, mark = self._plot.source, self._plot.mark_time
        if source is None or mark is None or self._plot.cursor_time is None:
            return ""
        return value_text(
            self._at_cursor(trace.name) - source.value_at(trace.name, mark), trace.unit
        )


_PADDING = 8
"""Pixels around the text of a cell, as the style paints it."""

_RIGHT = int(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)


def _swatch(color: QColor) -> QPixmap:
    picture = QPixmap(14, 4)
    picture.fill(color)
    return picture


class TraceTableView(QTableView):
    """The table as it stands below a plot: as high as four curves, more by scrolling.

    Columns that have nothing to say are not there, so that the others have room.
    """

    def __init__(self, model: TraceTable, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._table = model
        self.setObjectName("traceTable")
        self.setAccessibleName(self.tr("Curves and their figures"))
        name_headers(self)
        self.setModel(model)
        self.verticalHeader().hide()
        row = self.fontMetrics().height() + 6
        self.verticalHeader().setDefaultSectionSize(row)
        self.verticalHeader().setMinimumSectionSize(row)
        self.setShowGrid(False)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setTabKeyNavigation(False)
        header = self.horizontalHeader()
        header.setHighlightSections(False)
        for column in TraceColumn:
            texts = ("000.00 mAh" if column is TraceColumn.CHARGE else "\N{MINUS SIGN}00.00 A", "")
            head = str(model.headerData(column, Qt.Orientation.Horizontal))
            widest = max(self.fontMetrics().horizontalAdvance(text) for text in (*texts, head))
            header.resizeSection(column, widest + _PADDING)
        header.setSectionResizeMode(TraceColumn.CURVE, QHeaderView.ResizeMode.ResizeToContents)
        header.setStretchLastSection(False)
        self._row = row
        self.show_what_is_there()

    def show_what_is_there(self) -> None:
        """Hide the columns that have nothing to say now, and show the others."""
        for column in TraceColumn:
            if self.isColumnHidden(column) == self._table.is_of_use(column):
                self.setColumnHidden(column, not self._table.is_of_use(column))

    def whole_width(self) -> int:
        """Return the width at which every column that is there can be seen."""
        bar = self.verticalScrollBar()
        beside = bar.sizeHint().width() if bar.isVisibleTo(self) else 0
        return self.horizontalHeader().length() + beside + 2 * self.frameWidth() + 2

    def sizeHint(self) -> QSize:
        # Half a row tells that there are more.
        height = self.horizontalHeader().sizeHint().height() + round(4.5 * self._row)
        return QSize(self.horizontalHeader().length(), height)

    def minimumSizeHint(self) -> QSize:
        height = self.horizontalHeader().sizeHint().height() + round(2.5 * self._row)
        return QSize(self._row * 8, height)
