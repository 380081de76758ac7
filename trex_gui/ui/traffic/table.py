"""Traffic table: model with a filter, view, and details of the selected row."""

from bisect import bisect_right
from collections.abc import Sequence
from datetime import datetime

from PySide6.QtCore import QAbstractTableModel, QModelIndex, QObject, QPersistentModelIndex, Qt
from PySide6.QtGui import QFont, QFontMetrics, QPaintEvent, QResizeEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QFrame,
    QHeaderView,
    QPlainTextEdit,
    QTableView,
    QWidget,
)

from trex_gui.core.translation import Number, tr
from trex_gui.core.transport.traffic import Transaction
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import fixed_font, follow_theme, theme
from trex_gui.ui.traffic.model import RowBuffer, TrafficModel
from trex_gui.ui.widgets.behaviour import paint_placeholder
from trex_gui.ui.widgets.builders import flat_table, set_row_height

TIME, SENT, RECEIVED, TOOK, MEANING = range(5)

_SAMPLES = (
    ("00:00:00.000", "80 07 2F 7E 00 55 2A", "54 52 65 58 31 2E 32 00 00 00", "1000.0"),
    ("00:00:00.000", "80 07 2F", "54 52 65 58", "1000.0"),
)
"""Texts that set the column widths in wide and in narrow windows.

Longer texts are elided. The details below the table show all bytes.
"""

_HORIZONTAL = Qt.Orientation.Horizontal

_MIN_MEANING = 50  # width in average characters

_DETAIL_LINES = 5

Index = QModelIndex | QPersistentModelIndex


class TrafficTable(QAbstractTableModel):
    """Table with one row per transaction. Only `refresh` adds rows."""

    def __init__(self, traffic: TrafficModel, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._traffic = traffic
        self._decoder = traffic.decoder
        self.rows: list[Transaction] = []  # oldest first
        self._count = 0  # number of rows read from the source
        self._last: Transaction | None = None  # last row of the source if it is incomplete
        self._polling = False
        self._faults = False
        self._text = ""
        self._paused_at: int | None = None  # number of the newest row at the start of the pause
        self._headers = tr("Time"), tr("Sent"), tr("Received"), tr("Took (ms)"), tr("Meaning")
        follow_theme(self, "font", self._update_font)
        traffic.cleared.connect(self.rebuild)

    def _update_font(self) -> None:
        self._fixed = fixed_font()

    @property
    def _source(self) -> RowBuffer:
        # In the buffer of all rows, new polls soon displace a fault.
        with_polling = self._polling and not self._faults
        return self._traffic.everything if with_polling else self._traffic.without_polling

    def set_filter(self, *, polling: bool, faults: bool, text: str) -> None:
        """Select the visible rows.

        `polling`: show polls. `faults`: show only faults. `text`: show only rows with this text.
        """
        self._polling, self._faults, self._text = polling, faults, text.strip().casefold()
        self.rebuild()

    def set_paused(self, paused: bool) -> None:
        rows = self._traffic.everything.rows
        self._paused_at = (rows[-1].number if rows else 0) if paused else None

    def rebuild(self) -> None:
        self.beginResetModel()
        newest = self._paused_at
        rows = [row for row in self._source.rows if newest is None or row.number <= newest]
        self.rows = [row for row in rows if self._matches(row)]
        self._record_progress(self._source.count - len(self._source.rows) + len(rows), rows)
        self.endResetModel()

    def refresh(self) -> None:
        self._remove_dropped()
        if self._last is not None:  # may have received more bytes
            self._update(self._last)
        new = [row for row in self._source.since(self._count) if self._matches(row)]
        if new:
            first = len(self.rows)
            self.beginInsertRows(QModelIndex(), first, first + len(new) - 1)
            self.rows += new
            self.endInsertRows()
        self._record_progress(self._source.count, self._source.rows)

    def _record_progress(self, count: int, rows: Sequence[Transaction]) -> None:
        self._count = count
        self._last = rows[-1] if rows and not rows[-1].is_over else None

    def _remove_dropped(self) -> None:
        rows = self._source.rows
        oldest = rows[0].number if rows else 0
        count = bisect_right(self.rows, oldest - 1, key=lambda row: row.number)
        if count:
            self.beginRemoveRows(QModelIndex(), 0, count - 1)
            del self.rows[:count]
            self.endRemoveRows()

    def _update(self, row: Transaction) -> None:
        """Update a row that has more bytes. The row may start or stop matching the filter."""
        is_listed = bool(self.rows) and self.rows[-1] is row
        matches = self._matches(row)
        last = len(self.rows) - 1
        if is_listed and matches:
            self.dataChanged.emit(self.index(last, 0), self.index(last, MEANING))
        elif is_listed:
            self.beginRemoveRows(QModelIndex(), last, last)
            self.rows.pop()
            self.endRemoveRows()
        elif matches:
            self.beginInsertRows(QModelIndex(), last + 1, last + 1)
            self.rows.append(row)
            self.endInsertRows()

    def _matches(self, row: Transaction) -> bool:
        if not self._faults and not self._text:
            return True
        words, shown = self._decoder.decoded(row), self._decoder.display_text
        if self._faults and not words.is_fault:
            return False
        texts = (words.text, shown(row.sent), shown(row.received))
        return any(self._text in text.casefold() for text in texts)

    def row_near(self, time: float, text: str) -> int:
        """Return the index of the row nearest to `time`, or -1 in an empty table.

        If rows within a second of `time` contain `text`, return the nearest of these rows.
        """

        def rank(index: int) -> tuple[bool, float]:
            row = self.rows[index]
            distance = abs(row.time - time)
            return distance > 1 or text not in self._decoder.decoded(row).text, distance

        return min(range(len(self.rows)), key=rank, default=-1)

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008 - Qt's signature
        return 0 if parent.isValid() else len(self.rows)

    def columnCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008 - Qt's signature
        return 0 if parent.isValid() else MEANING + 1

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> object:
        if orientation is not Qt.Orientation.Horizontal:
            return None
        if role == Qt.ItemDataRole.DisplayRole:
            return self._headers[section]
        return _alignment(section) if role == Qt.ItemDataRole.TextAlignmentRole else None

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        if not index.isValid():
            return None
        row, column = self.rows[index.row()], index.column()
        match role:
            case Qt.ItemDataRole.DisplayRole:
                return self.text(row, column)
            case Qt.ItemDataRole.AccessibleTextRole if column == MEANING and self._is_fault(row):
                return tr("Fault: {0}").format(self.text(row, column))
            case Qt.ItemDataRole.TextAlignmentRole:
                return _alignment(column)
            case Qt.ItemDataRole.FontRole:
                return self._font(row, column)
            case Qt.ItemDataRole.ForegroundRole:
                return self._color(row, column)
            case Qt.ItemDataRole.DecorationRole if column == MEANING:
                return icon("warning", "warning") if self._is_fault(row) else None
        return None

    def text(self, row: Transaction, column: int) -> str:
        if column == TIME:
            moment = datetime.fromtimestamp(self._traffic.wall_time(row)).astimezone()
            return moment.time().isoformat("milliseconds")
        if column in {SENT, RECEIVED}:
            return self._decoder.display_text(row.sent if column == SENT else row.received)
        if column == TOOK:
            return "" if row.seconds is None else f"{Number(row.seconds * 1e3):.1f}"
        return self._decoder.decoded(row).text

    def _font(self, row: Transaction, column: int) -> QFont | None:
        if column in {SENT, RECEIVED}:
            return self._fixed
        if column == MEANING and row.note:
            font = QFont()
            font.setItalic(True)
            return font
        return None

    def _color(self, row: Transaction, column: int) -> object:
        if self._is_fault(row):
            return theme().color("danger") if column == MEANING else None
        is_muted = row.note or row.is_routine or column in {TIME, TOOK}
        return theme().color("muted") if is_muted else None

    def _is_fault(self, row: Transaction) -> bool:
        return self._decoder.decoded(row).is_fault


def _alignment(column: int) -> Qt.AlignmentFlag:
    side = Qt.AlignmentFlag.AlignRight if column == TOOK else Qt.AlignmentFlag.AlignLeft
    return side | Qt.AlignmentFlag.AlignVCenter


class TrafficView(QTableView):
    def __init__(self, table: TrafficTable, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._placeholder = ""
        self._widths: list[int] = []
        flat_table(self, "", tr("Traffic on the line"))
        self.setModel(table)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.setWordWrap(False)
        self.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.verticalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        set_row_height(self, 6)
        self.horizontalHeader().setStretchLastSection(True)
        follow_theme(self, "space", self._update_widths)

    def _update_widths(self) -> None:
        proportional, fixed = self.fontMetrics(), QFontMetrics(fixed_font())
        unit = proportional.averageCharWidth()
        fonts = {SENT: fixed, RECEIVED: fixed}
        titles = [
            proportional.horizontalAdvance(self.model().headerData(column, _HORIZONTAL))
            for column in range(len(_SAMPLES[0]))
        ]
        for samples in _SAMPLES:
            widths = [
                max(fonts.get(column, proportional).horizontalAdvance(text), title) + 2 * unit
                for column, (text, title) in enumerate(zip(samples, titles, strict=True))
            ]
            if sum(widths) + _MIN_MEANING * unit <= self.viewport().width():
                break
        if widths == self._widths:  # the user may have resized the columns
            return
        self._widths = widths
        header = self.horizontalHeader()
        for column, width in enumerate(widths):
            header.resizeSection(column, width)
        header.setMinimumSectionSize(self.fontMetrics().averageCharWidth() * 6)
        self.setMinimumHeight(self.fontMetrics().height() * 6)

    def resizeEvent(self, event: QResizeEvent) -> None:
        follows = self.is_at_bottom
        super().resizeEvent(event)
        self._update_widths()
        if follows:  # for example when a banner appears
            self.scrollToBottom()

    @property
    def is_at_bottom(self) -> bool:
        bar = self.verticalScrollBar()
        return bar.value() >= bar.maximum() - self.verticalHeader().defaultSectionSize()

    def set_placeholder(self, text: str) -> None:
        if text != self._placeholder:
            self._placeholder = text
            self.viewport().update()

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self.model().rowCount() == 0:
            paint_placeholder(self, self._placeholder)


class RowDetails(QPlainTextEdit):
    def __init__(
        self, traffic: TrafficModel, table: TrafficTable, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._decoder = traffic.decoder
        self._table = table
        self.setAccessibleName(tr("Details of the selected row"))
        self.setReadOnly(True)
        self.setTabChangesFocus(True)
        self.setFrameShape(QFrame.Shape.StyledPanel)
        self.setPlaceholderText(tr("Select a row to see all its bytes."))
        follow_theme(self, "space", self._update_font)

    def _update_font(self) -> None:
        self.setFont(fixed_font())
        margins = 2 * (round(self.document().documentMargin()) + self.frameWidth())
        self.setFixedHeight(self.fontMetrics().lineSpacing() * _DETAIL_LINES + margins)

    def show_row(self, row: Transaction | None) -> None:
        text = "" if row is None else "\n".join(self._lines(row))
        if text != self.toPlainText():  # `setPlainText` would clear the selection
            self.setPlainText(text)

    def _lines(self, row: Transaction) -> list[str]:
        shown = self._decoder.display_text
        settings = row.settings
        heading = f"{self._table.text(row, TIME)}  #{row.number}"
        if settings is not None:
            heading = tr("{0} at {1}").format(heading, settings.short)
        lines = [heading]
        if row.sent:
            lines.append(tr("sent      {0}").format(shown(row.sent)))
        if row.received:
            lines.append(tr("received  {0}").format(shown(row.received)))
        if row.seconds is not None and settings is not None:
            count = len(row.sent) + len(row.received)
            text = tr(
                "took      {0:.1f} ms; %n byte(s) take {1:.1f} ms at this baud rate", "", count
            )
            wire = settings.line.seconds(count)
            lines.append(text.format(Number(row.seconds * 1e3), Number(wire * 1e3)))
        lines.append(self._decoder.decoded(row).text)
        return lines
