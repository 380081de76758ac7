"""Table of curves that serves as a legend, and list of events."""

import math
from enum import IntEnum, auto

from PySide6.QtCore import (
    QAbstractTableModel,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    QSize,
    Qt,
    Signal,
    Slot,
)
from PySide6.QtGui import QColor, QIcon, QPainter, QPaintEvent, QPixmap
from PySide6.QtWidgets import QHeaderView, QListWidget, QListWidgetItem, QTableView, QWidget

from trex_gui.core.events import Event
from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.ui.plotting.axes import clock_text
from trex_gui.ui.plotting.history import Statistics
from trex_gui.ui.plotting.marks import EVENT_LOOKS, charge_text, value_text
from trex_gui.ui.plotting.plot import TracePlot
from trex_gui.ui.plotting.traces import TraceInfo, Traces
from trex_gui.ui.theme.theme import follow_theme, theme
from trex_gui.ui.widgets.bar import MINUS, WARNING_SIGN, LimitState, limit_state
from trex_gui.ui.widgets.behaviour import paint_placeholder
from trex_gui.ui.widgets.builders import flat_table, plain, set_row_height

Index = QModelIndex | QPersistentModelIndex

_RIGHT = int(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)

_PADDING = 8  # pixels around the text of a cell in the Fusion style
_ROW_PADDING = 6  # pixels added to the height of a line
_MAX_EVENTS = 1000  # maximum number of events in the list
_MIN_EVENT_WIDTH = 24  # minimum width of the list in average characters


class TraceColumn(IntEnum):
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


_STATISTICS = {  # column → field of `Statistics`
    TraceColumn.PEAK: "high",
    TraceColumn.MEAN: "mean",
    TraceColumn.RMS: "rms",
    TraceColumn.LOW: "low",
}
_WIDEST = {TraceColumn.NOW: f"{WARNING_SIGN} 00.00 A", TraceColumn.CHARGE: "000.00 mAh"}


class TraceTable(QAbstractTableModel):
    """Table with one row per curve. Check boxes select the curves to draw."""

    def __init__(self, plot: TracePlot, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._plot = plot
        self._traces: tuple[TraceInfo, ...] = ()
        self._statistics: dict[str, Statistics] = {}
        visible = tr("In the visible span")
        self._headers = (  # in the order of `TraceColumn`
            (tr("Curve"), tr("Select the curves to draw")),
            (tr("Now"), tr("Newest value; ⚠ means 80 % of the limit or more")),
            (tr("Peak"), visible),
            (tr("Mean"), visible),
            (
                tr("RMS"),
                tr("Root mean square in the visible span; determines the heat in wires"),
            ),
            (tr("Charge"), tr("Current times time in the visible span, without gaps")),
            (tr("Limit"), ""),
            (tr("Cursor"), ""),
            (
                tr("To mark"),
                tr(
                    "Difference between the mark and the cursor; click the plot or press M to "
                    "set the mark"
                ),
            ),
            (tr("Held"), tr("Highest value since Hold peaks was switched on")),
            (tr("Low"), visible),
        )
        self.show_source()

    def show_source(self) -> None:
        self.beginResetModel()
        self._traces = self._plot.source.traces if self._plot.source is not None else ()
        self._statistics = {}
        self.endResetModel()
        self.refresh()

    def refresh(self) -> None:
        source, span = self._plot.source, self._plot.span
        if source is None or not self._traces:
            return
        self._statistics = {
            trace.name: source.statistics(trace.name, span.start, span.end)
            for trace in self._traces
            if trace.name in self._plot.shown
        }
        last = self.index(len(self._traces) - 1, TraceColumn.LOW)
        self.dataChanged.emit(
            self.index(0, 0), last, [Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.ForegroundRole]
        )

    def is_needed(self, column: TraceColumn) -> bool:
        plot = self._plot
        needed = {
            TraceColumn.DIFFERENCE: plot.mark_time is not None,
            TraceColumn.HELD: plot.peaks_since is not None,
            TraceColumn.LIMIT: plot.source is None or bool(plot.source.limits),
        }
        return needed.get(column, True)

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008 - Qt's signature
        return 0 if parent.isValid() else len(self._traces)

    def columnCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008 - Qt's signature
        return 0 if parent.isValid() else len(TraceColumn)

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> object:
        if orientation != Qt.Orientation.Horizontal:
            return None
        column = TraceColumn(section)
        match role:
            case Qt.ItemDataRole.DisplayRole:
                return self._headers[column][0]
            case Qt.ItemDataRole.ToolTipRole:
                return plain(self._headers[column][1])
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
                    return self._spoken(trace, column)
                case Qt.ItemDataRole.ForegroundRole:
                    color = self._limit_state(trace, column).value
                    return theme().color(color) if color else None
            return None
        match role:
            case Qt.ItemDataRole.DisplayRole | Qt.ItemDataRole.AccessibleTextRole:
                return trace.label
            case Qt.ItemDataRole.CheckStateRole:
                shown = trace.name in self._plot.shown
                return Qt.CheckState.Checked if shown else Qt.CheckState.Unchecked
            case Qt.ItemDataRole.DecorationRole:
                dotted = self._plot.uses_right_axis(trace)
                return swatch(theme().color(trace.color), QSize(14, 4), dotted=dotted)
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
        source, unit = self._plot.source, trace.unit
        if source is None or not (trace.name in self._plot.shown or column is TraceColumn.LIMIT):
            return ""
        if column is TraceColumn.CHARGE:
            statistics = self._statistics.get(trace.name, Statistics())
            return charge_text(statistics) if unit == "A" else ""
        value = self._value(source, trace.name, column)
        if value is None:
            return ""
        text = value_text(value, unit, mean=column in {TraceColumn.MEAN, TraceColumn.RMS})
        is_below = self._limit_state(trace, column) is LimitState.BELOW
        return text if is_below else f"{WARNING_SIGN} {text}"

    def _limit_state(self, trace: TraceInfo, column: TraceColumn) -> LimitState:
        source = self._plot.source
        if source is None or column is not TraceColumn.NOW or trace.name not in self._plot.shown:
            return LimitState.BELOW
        value = self._value(source, trace.name, column)
        return limit_state(value, source.limits.get(trace.name))

    def _spoken(self, trace: TraceInfo, column: TraceColumn) -> str:
        text = {
            LimitState.BELOW: "{0}, {1}: {2}",
            LimitState.NEAR: tr("{0}, {1}: {2}, near its limit"),
            LimitState.OVER: tr("{0}, {1}: {2}, over its limit"),
        }[self._limit_state(trace, column)]
        return text.format(trace.label, self._headers[column][0], self._text(trace, column))

    def _value(self, source: Traces, name: str, column: TraceColumn) -> float | None:
        cursor, mark = self._plot.cursor_time, self._plot.mark_time
        match column:
            case TraceColumn.NOW if source.span is not None:
                return source.value_at(name, source.span[1])
            case TraceColumn.CURSOR if cursor is not None:
                return source.value_at(name, cursor)
            case TraceColumn.NOW | TraceColumn.CURSOR:
                return math.nan
            case TraceColumn.DIFFERENCE if cursor is not None and mark is not None:
                return source.value_at(name, cursor) - source.value_at(name, mark)
            case TraceColumn.HELD:
                return self._plot.peak_of(name)
            case TraceColumn.LIMIT:
                return source.limits.get(name)
            case column if field := _STATISTICS.get(column):
                value: float = getattr(self._statistics.get(name, Statistics()), field)
                return value
        return None


def swatch(color: QColor, size: QSize, *, dotted: bool = False) -> QPixmap:
    picture = QPixmap(size)
    picture.fill(Qt.GlobalColor.transparent if dotted else color)
    if dotted:
        with QPainter(picture) as painter:
            for left in range(0, size.width(), 5):
                painter.fillRect(left, 0, 3, size.height(), color)
    return picture


class TraceTableView(QTableView):
    def __init__(self, model: TraceTable, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        flat_table(self, "traceTable", tr("Curves and their figures"))
        set_row_height(self, _ROW_PADDING)
        self._table = model
        self.setModel(model)
        header = self.horizontalHeader()
        header.setSectionResizeMode(TraceColumn.CURVE, QHeaderView.ResizeMode.ResizeToContents)
        follow_theme(self, "space", self._update_sizes)
        self.show_needed_columns()

    def _update_sizes(self) -> None:
        self._row_height = self.fontMetrics().height() + _ROW_PADDING
        self.verticalHeader().setMinimumSectionSize(self._row_height)
        header = self.horizontalHeader()
        for column in TraceColumn:
            widest = _WIDEST.get(column, f"{MINUS}00.00 A")
            width = self.fontMetrics().horizontalAdvance(widest) + _PADDING
            header.resizeSection(column, max(width, header.sectionSizeHint(column)))

    def show_needed_columns(self) -> None:
        for column in TraceColumn:
            if self.isColumnHidden(column) == self._table.is_needed(column):
                self.setColumnHidden(column, not self._table.is_needed(column))

    def sizeHintForColumn(self, column: int) -> int:
        # Qt's hint assumes smaller check boxes.
        return super().sizeHintForColumn(column) + _PADDING

    def _height_of(self, rows: float) -> int:
        return self.horizontalHeader().sizeHint().height() + round(rows * self._row_height)

    def sizeHint(self) -> QSize:
        width = self.horizontalHeader().length() + self.verticalScrollBar().sizeHint().width()
        # Half a visible row indicates that more rows follow.
        return QSize(width + 2 * self.frameWidth() + 2, self._height_of(4.5))

    def minimumSizeHint(self) -> QSize:
        return QSize(self._row_height * 8, self._height_of(2.5))


class EventList(QListWidget):
    chosen = Signal(object)  # the `Event` that the user chose

    def __init__(self, plot: TracePlot, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._plot = plot
        self._events: tuple[Event, ...] = ()
        self._origin: float | None = None
        self._placeholder = ""
        self.setObjectName("eventList")
        self.setAccessibleName(title_of(tr("E&vents")))
        self.setUniformItemSizes(True)
        self.setTextElideMode(Qt.TextElideMode.ElideRight)
        self.itemActivated.connect(self._on_chosen)
        self.itemClicked.connect(self._on_chosen)
        theme().changed.connect(self._fill)
        self.set_placeholder(
            tr(
                "No events yet. Stops, applied settings, faults and exceeded limits will be "
                "listed here."
            )
        )

    def sizeHint(self) -> QSize:
        metrics = self.fontMetrics()
        return QSize(metrics.averageCharWidth() * 34, metrics.height() * 5)

    def minimumSizeHint(self) -> QSize:
        width = self.fontMetrics().averageCharWidth() * _MIN_EVENT_WIDTH
        return QSize(width, super().minimumSizeHint().height())

    def refresh(self) -> None:
        events: tuple[Event, ...] = ()
        if self._plot.source is not None:
            events = tuple(self._plot.source.events_between(-math.inf, math.inf)[-_MAX_EVENTS:])
        if (events, self._plot.origin) != (self._events, self._origin):
            self._events, self._origin = events, self._plot.origin
            self._fill()
            self.scrollToBottom()
            self._describe()

    @Slot()
    def _fill(self) -> None:
        self.clear()
        for event in self._events:
            dot = swatch(theme().color(EVENT_LOOKS[event.kind][0]), QSize(8, 8))
            # The event of a new connection precedes the first sample.
            elapsed = max(0.0, event.time - (self._origin or 0.0))
            text = f"{clock_text(elapsed)}  {event.text}"
            item = QListWidgetItem(QIcon(dot), text, self)
            item.setToolTip(plain(event.text))
            item.setSizeHint(QSize(1, self.fontMetrics().height() + 4))  # elides long texts

    def set_placeholder(self, text: str) -> None:
        self._placeholder = text
        self._describe()
        self.viewport().update()

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if not self._events:
            paint_placeholder(self, self._placeholder, short=tr("No events"))

    def _describe(self) -> None:
        hint = tr("Select an event to show it in the plot.")
        self.setAccessibleDescription(hint if self._events else self._placeholder)

    def select(self, event: Event) -> None:
        if event in self._events:
            self.setCurrentRow(self._events.index(event))

    @Slot(QListWidgetItem)
    def _on_chosen(self, item: QListWidgetItem) -> None:
        self.chosen.emit(self._events[self.row(item)])
