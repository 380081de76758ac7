"""The table of a transcript on the screen: columns, and a word where there is nothing."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QFontMetrics, QPainter, QPaintEvent
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTableView, QWidget

from trex_gui.ui.theme.theme import theme
from trex_gui.ui.traffic.table import RECEIVED, SENT, TIME, TOOK, TrafficTable
from trex_gui.ui.widgets.behaviour import name_headers

_SAMPLES = {
    TIME: "00:00:00.000",
    SENT: "80 07 2F 7E 00 55 2A",
    RECEIVED: "54 52 65 58 31 2E 32 00 00 00",
    TOOK: "Took (ms)",
}
"""What has to fit; longer bytes are cut, and stand in full below the table."""


class TrafficView(QTableView):
    """Rows that are chosen together, and follow each other closely."""

    def __init__(self, table: TrafficTable, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._empty = ""
        self.setAccessibleName(self.tr("What went over the line"))
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
        """Whether the newest row is in sight, so that whoever looks wants to see the next."""
        bar = self.verticalScrollBar()
        return bar.value() >= bar.maximum() - self.verticalHeader().defaultSectionSize()

    def set_empty_text(self, text: str) -> None:
        """Say what is shown while there are no rows."""
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
