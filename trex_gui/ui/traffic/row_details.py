"""One row of a transcript in full: all its bytes, what they mean, how long it took."""

from PySide6.QtGui import QFontDatabase
from PySide6.QtWidgets import QFrame, QPlainTextEdit, QWidget

from trex_gui.core.transport.transactions import Transaction
from trex_gui.ui.traffic.model import TrafficModel
from trex_gui.ui.traffic.table import TrafficTable

_LINES = 5


class RowDetails(QPlainTextEdit):
    """Read only, to be selected and copied from."""

    def __init__(
        self, traffic: TrafficModel, table: TrafficTable, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._traffic = traffic
        self._table = table
        self.setAccessibleName(self.tr("The chosen row in full"))
        self.setReadOnly(True)
        self.setTabChangesFocus(True)
        self.setFrameShape(QFrame.Shape.StyledPanel)
        self.setFont(QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont))
        self.setPlaceholderText(self.tr("Choose a row to see all of its bytes."))
        margins = 2 * (round(self.document().documentMargin()) + self.frameWidth())
        self.setFixedHeight(self.fontMetrics().lineSpacing() * _LINES + margins)

    def show_row(self, row: Transaction | None) -> None:
        """Show a row, or that none is chosen."""
        text = "" if row is None else "\n".join(self._lines(row))
        if text != self.toPlainText():  # what somebody has selected in it stays so
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
