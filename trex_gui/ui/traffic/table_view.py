"""Views of the traffic table: the table itself, and the selected row in full."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QFontDatabase, QFontMetrics, QPainter, QPaintEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QFrame,
    QHeaderView,
    QPlainTextEdit,
    QTableView,
    QWidget,
)

from trex_gui.core.transport.traffic import Transaction
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.traffic.model import TrafficModel
from trex_gui.ui.traffic.table import RECEIVED, SENT, TIME, TOOK, TrafficTable
from trex_gui.ui.widgets.behaviour import name_headers

_SAMPLES = {
    TIME: "00:00:00.000",
    SENT: "80 07 2F 7E 00 55 2A",
    RECEIVED: "54 52 65 58 31 2E 32 00 00 00",
    TOOK: "Took (ms)",
}
"""Texts that set the column widths; longer bytes are elided, and complete below the table."""

_DETAIL_LINES = 5


class TrafficView(QTableView):
    """Table of transactions, with a text if it is empty."""

    def __init__(self, table: TrafficTable, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._empty = ""
        self.setAccessibleName(self.tr("Traffic on the line"))
        self.setModel(table)
        name_headers(self)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.setAlternatingRowColors(True)
        self.setShowGrid(False)
        self.setWordWrap(False)
        self.setTabKeyNavigation(False)
        self.setVerticalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        rows = self.verticalHeader()
        rows.hide()
        rows.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        rows.setDefaultSectionSize(self.fontMetrics().height() + 6)
        header = self.horizontalHeader()
        header.setHighlightSections(False)
        header.setStretchLastSection(True)
        for column, sample in _SAMPLES.items():
            font = table.mono if column in {SENT, RECEIVED} else self.font()
            width = QFontMetrics(font).horizontalAdvance(sample)
            header.resizeSection(column, width + 3 * self.fontMetrics().averageCharWidth())
        header.setMinimumSectionSize(self.fontMetrics().averageCharWidth() * 6)
        self.setMinimumHeight(self.fontMetrics().height() * 6)

    @property
    def is_at_bottom(self) -> bool:
        """Whether the newest row is visible, so that the next one should be, too."""
        bar = self.verticalScrollBar()
        return bar.value() >= bar.maximum() - self.verticalHeader().defaultSectionSize()

    def set_empty_text(self, text: str) -> None:
        """Set the text that is shown while there are no rows."""
        if text != self._empty:
            self._empty = text
            self.viewport().update()

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self._empty and self.model().rowCount() == 0:
            with QPainter(self.viewport()) as painter:
                painter.setPen(theme().color("muted"))
                box = self.viewport().rect().adjusted(24, 8, -24, -8)
                how = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap
                painter.drawText(box, how, self._empty)


class RowDetails(QPlainTextEdit):
    """All bytes of the selected row, their meaning and timing; read-only."""

    def __init__(
        self, traffic: TrafficModel, table: TrafficTable, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._traffic = traffic
        self._table = table
        self.setAccessibleName(self.tr("Details of the selected row"))
        self.setReadOnly(True)
        self.setTabChangesFocus(True)
        self.setFrameShape(QFrame.Shape.StyledPanel)
        self.setFont(QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont))
        self.setPlaceholderText(self.tr("Select a row to see all its bytes."))
        margins = 2 * (round(self.document().documentMargin()) + self.frameWidth())
        self.setFixedHeight(self.fontMetrics().lineSpacing() * _DETAIL_LINES + margins)

    def show_row(self, row: Transaction | None) -> None:
        """Show a row, or that none is selected."""
        text = "" if row is None else "\n".join(self._lines(row))
        if text != self.toPlainText():  # keeps a selection in it
            self.setPlainText(text)

    def _lines(self, row: Transaction) -> list[str]:
        shown = self._traffic.shown
        settings = row.settings
        where = "" if settings is None else self.tr(" at {0}").format(settings.short)
        lines = [f"{self._table.text(row, 0)}  #{row.number}{where}"]
        if row.sent:
            lines.append(self.tr("sent      {0}").format(shown(row.sent)))
        if row.received:
            lines.append(self.tr("received  {0}").format(shown(row.received)))
        if row.seconds is not None and settings is not None:
            wire = settings.line.seconds(len(row.sent) + len(row.received))
            text = self.tr("took      {0:.1f} ms; {1} bytes need {2:.1f} ms on this wire")
            count = len(row.sent) + len(row.received)
            lines.append(text.format(row.seconds * 1e3, count, wire * 1e3))
        lines.append(self._traffic.decoded(row).text)
        return lines
