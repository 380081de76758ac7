"""The rows of a transcript that are to be seen: which, and how they look."""

from bisect import bisect_right
from collections.abc import Sequence
from datetime import datetime

from PySide6.QtCore import QAbstractTableModel, QModelIndex, QObject, QPersistentModelIndex, Qt
from PySide6.QtGui import QFont, QFontDatabase

from trex_gui.core.transport.transactions import Transaction
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.traffic.model import Shelf, TrafficModel

TIME, SENT, RECEIVED, TOOK, WORDS = range(5)

Index = QModelIndex | QPersistentModelIndex


class TrafficTable(QAbstractTableModel):
    """What was sent, what came back, and what it means; a row an exchange.

    It changes only in `refresh`, so that nothing is done for a page that nobody sees.

    Attributes:
        mono: what bytes are written in.
    """

    def __init__(self, traffic: TrafficModel, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._traffic = traffic
        self._rows: list[Transaction] = []
        self._seen = 0
        self._last: Transaction | None = None
        self._polling = False
        self._faults = False
        self._text = ""
        self._held_at: int | None = None
        self.mono = QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont)
        traffic.cleared.connect(self.begin)
        theme().changed.connect(self._repaint)

    # --- Which rows ---------------------------------------------------------------------

    @property
    def rows(self) -> Sequence[Transaction]:
        """What is listed, oldest first."""
        return self._rows

    @property
    def shelf(self) -> Shelf:
        """Where the rows come from."""
        polling = self._polling
        return self._traffic.everything if polling else self._traffic.without_polling

    def choose(self, *, polling: bool, faults: bool, text: str) -> None:
        """List what is polled too; only what went wrong; only what has `text` in it."""
        self._polling, self._faults, self._text = polling, faults, text.strip().casefold()
        self.begin()

    def hold(self, *, still: bool) -> None:
        """List no row that comes from now on, or everything again with the next `refresh`."""
        rows = self._traffic.everything.rows
        self._held_at = (rows[-1].number if rows else 0) if still else None

    def begin(self) -> None:
        """List everything anew, but for what came since it was held."""
        self.beginResetModel()
        last = self._held_at
        known = [row for row in self.shelf.rows if last is None or row.number <= last]
        self._rows = [row for row in known if self._is_wanted(row)]
        self._note_seen(self.shelf.count - len(self.shelf.rows) + len(known), known)
        self.endResetModel()

    def refresh(self) -> None:
        """Take what is new, and let go of what is kept no longer."""
        self._drop_old()
        if self._last is not None:  # bytes may have come to it since
            self._renew(self._last)
        new = [row for row in self.shelf.since(self._seen) if self._is_wanted(row)]
        if new:
            first = len(self._rows)
            self.beginInsertRows(QModelIndex(), first, first + len(new) - 1)
            self._rows += new
            self.endInsertRows()
        self._note_seen(self.shelf.count, self.shelf.rows)

    def _note_seen(self, count: int, rows: Sequence[Transaction]) -> None:
        self._seen = count
        self._last = rows[-1] if rows and not rows[-1].is_over else None

    def _drop_old(self) -> None:
        kept = self.shelf.rows
        oldest = kept[0].number if kept else 0
        gone = bisect_right(self._rows, oldest - 1, key=lambda row: row.number)
        if gone:
            self.beginRemoveRows(QModelIndex(), 0, gone - 1)
            del self._rows[:gone]
            self.endRemoveRows()

    def _renew(self, row: Transaction) -> None:
        """Show a row as it is now; it may only now have become one that is wanted, or none."""
        listed = bool(self._rows) and self._rows[-1] is row
        wanted = self._is_wanted(row)
        last = len(self._rows) - 1
        if listed and wanted:
            self.dataChanged.emit(self.index(last, 0), self.index(last, WORDS))
        elif listed:
            self.beginRemoveRows(QModelIndex(), last, last)
            self._rows.pop()
            self.endRemoveRows()
        elif wanted:
            self.beginInsertRows(QModelIndex(), last + 1, last + 1)
            self._rows.append(row)
            self.endInsertRows()

    def _is_wanted(self, row: Transaction) -> bool:
        if not self._faults and not self._text:
            return True
        words = self._traffic.decoded(row)
        if self._faults and not words.is_fault:
            return False
        if not self._text:
            return True
        shown = (words.text, self._traffic.shown(row.sent), self._traffic.shown(row.received))
        return any(self._text in text.casefold() for text in shown)

    def _repaint(self) -> None:
        if self._rows:
            last = self.index(len(self._rows) - 1, WORDS)
            self.dataChanged.emit(self.index(0, 0), last)

    # --- How they look ------------------------------------------------------------------

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008 - as Qt has it
        return 0 if parent.isValid() else len(self._rows)

    def columnCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008
        return 0 if parent.isValid() else WORDS + 1

    def headerData(
        self,
        section: int,
        orientation: Qt.Orientation,
        role: int = Qt.ItemDataRole.DisplayRole,
    ) -> object:
        if orientation is not Qt.Orientation.Horizontal:
            return None
        if role == Qt.ItemDataRole.TextAlignmentRole:
            return _alignment(section)
        if role != Qt.ItemDataRole.DisplayRole:
            return None
        return (
            self.tr("Time"),
            self.tr("Sent"),
            self.tr("Received"),
            self.tr("Took (ms)"),
            self.tr("Meaning"),
        )[section]

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        if not index.isValid():
            return None
        row, column = self._rows[index.row()], index.column()
        match role:
            case Qt.ItemDataRole.DisplayRole:
                return self.text(row, column)
            case Qt.ItemDataRole.AccessibleTextRole:
                return self._said(row, column)
            case Qt.ItemDataRole.TextAlignmentRole:
                return _alignment(column)
            case Qt.ItemDataRole.FontRole:
                return self._font(row, column)
            case Qt.ItemDataRole.ForegroundRole:
                return self._colour(row, column)
            case Qt.ItemDataRole.DecorationRole if column == WORDS:
                return icon("warning", "warning") if self._is_fault(row) else None
        return None

    def text(self, row: Transaction, column: int) -> str:
        """Return what stands in a column of a row."""
        match column:
            case 0:  # TIME
                moment = datetime.fromtimestamp(self._traffic.wall_time(row)).astimezone()
                return moment.strftime("%H:%M:%S.") + f"{moment.microsecond // 1000:03d}"
            case 1:  # SENT
                return self._traffic.shown(row.sent)
            case 2:  # RECEIVED
                return self._traffic.shown(row.received)
            case 3:  # TOOK
                return "" if row.seconds is None else f"{row.seconds * 1e3:.1f}"
        return self._traffic.decoded(row).text

    def _said(self, row: Transaction, column: int) -> str | None:
        """Say to who does not see it what the colour says."""
        if column == WORDS and self._is_fault(row):
            return self.tr("Fault: {0}").format(self.text(row, column))
        return None

    def _font(self, row: Transaction, column: int) -> QFont | None:
        if column in {SENT, RECEIVED}:
            return self.mono
        if column == WORDS and row.note:
            font = QFont()
            font.setItalic(True)
            return font
        return None

    def _colour(self, row: Transaction, column: int) -> object:
        if self._is_fault(row):
            return theme().color("danger") if column == WORDS else None
        quiet = row.note or row.is_routine or column in {TIME, TOOK}
        return theme().color("muted") if quiet else None

    def _is_fault(self, row: Transaction) -> bool:
        return self._traffic.decoded(row).is_fault


def _alignment(column: int) -> Qt.AlignmentFlag:
    side = Qt.AlignmentFlag.AlignRight if column == TOOK else Qt.AlignmentFlag.AlignLeft
    return side | Qt.AlignmentFlag.AlignVCenter
