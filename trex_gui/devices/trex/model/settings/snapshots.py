"""The history as a table: one row a snapshot, the newest first, and what each holds."""

from collections import Counter
from datetime import datetime, timedelta
from enum import IntEnum
from pathlib import Path
from typing import Any, cast

from PySide6.QtCore import (
    QAbstractTableModel,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    QSortFilterProxyModel,
    Qt,
)

from trex_gui.core.files import SettingsError
from trex_gui.devices.trex.model.settings.rows import renew_rows
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.history import SettingsHistory, Snapshot

Index = QModelIndex | QPersistentModelIndex
Stamp = tuple[int, int]

_FINDINGS = 3


class SnapshotColumn(IntEnum):
    """The columns, left to right."""

    TIME = 0
    REASON = 1
    BOARD = 2
    NUMBER = 3
    ADAPTER = 4


class SnapshotRole(IntEnum):
    """Data of a cell besides its text."""

    SNAPSHOT = Qt.ItemDataRole.UserRole
    PROBLEM = Qt.ItemDataRole.UserRole + 1
    WORDS = Qt.ItemDataRole.UserRole + 2


class SnapshotTable(QAbstractTableModel):
    """Lists the folder of a history; `refresh` looks again.

    A snapshot whose head is sound may still be damaged further down; that shows when it is
    loaded, and stays known.
    """

    def __init__(self, history: SettingsHistory, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._history = history
        self._rows: list[Snapshot] = []
        self._busy: set[datetime] = set()
        self._loaded: dict[Path, tuple[Stamp, Settings]] = {}
        self._damaged: dict[Path, tuple[Stamp, str]] = {}

    # --- What is there ------------------------------------------------------------------

    def refresh(self) -> None:
        """Look at the folder again; what is still there stays where it is."""
        found = self._history.snapshots()
        paths = {snapshot.path for snapshot in found}
        minutes = Counter(map(_minute, found))
        self._busy = {minute for minute, count in minutes.items() if count > 1}
        self._loaded = {path: known for path, known in self._loaded.items() if path in paths}
        self._damaged = {p: known for p, known in self._damaged.items() if _stamp(p) == known[0]}
        renew_rows(self, self._rows, found, lambda snapshot: snapshot.path)
        if self._rows:  # it may be tomorrow now, or a file was repaired
            self.dataChanged.emit(self.index(0, 0), self.index(len(self._rows) - 1, 0))

    @property
    def snapshots(self) -> tuple[Snapshot, ...]:
        """All of them, in the order of the rows."""
        return tuple(self._rows)

    def row_of(self, path: Path) -> int | None:
        """Return the row of a snapshot; `None` when it is gone."""
        rows = (row for row, snapshot in enumerate(self._rows) if snapshot.path == path)
        return next(rows, None)

    def neighbour(self, snapshot: Snapshot) -> Snapshot | None:
        """Return the next newer sound snapshot of the same product, else the next older one."""
        row = self.row_of(snapshot.path)
        if row is None:
            return None
        candidates = (*reversed(self._rows[:row]), *self._rows[row + 1 :])
        return next(
            (c for c in candidates if c.product == snapshot.product and not self.problem_of(c)),
            None,
        )

    def load(self, snapshot: Snapshot) -> Settings:
        """Return what a snapshot holds.

        Raises:
            SettingsError: the file is gone or damaged; the table shows it from then on.
        """
        stamp = _stamp(snapshot.path)
        known = self._loaded.get(snapshot.path)
        if known is not None and known[0] == stamp:
            return known[1]
        try:
            settings = self._history.load(snapshot)
        except SettingsError as error:
            self._note_damage(snapshot, stamp, error)
            raise
        self._loaded[snapshot.path] = (stamp, settings)
        return settings

    def _note_damage(self, snapshot: Snapshot, stamp: Stamp, error: SettingsError) -> None:
        self._loaded.pop(snapshot.path, None)
        self._damaged[snapshot.path] = (stamp, _in_short(error))
        row = self.row_of(snapshot.path)
        if row is not None:
            self.dataChanged.emit(self.index(row, 0), self.index(row, self.columnCount() - 1))

    def problem_of(self, snapshot: Snapshot) -> str:
        """Return why a snapshot is of no use, as far as that is known; empty for a sound one."""
        known = self._damaged.get(snapshot.path)
        return known[1] if known is not None else snapshot.problem

    # --- Qt -----------------------------------------------------------------------------

    def rowCount(self, parent: Index | None = None) -> int:
        return 0 if parent is not None and parent.isValid() else len(self._rows)

    def columnCount(self, parent: Index | None = None) -> int:
        return 0 if parent is not None and parent.isValid() else len(SnapshotColumn)

    def headerData(
        self,
        section: int,
        orientation: Qt.Orientation,
        role: int = Qt.ItemDataRole.DisplayRole,
    ) -> Any:
        if orientation is not Qt.Orientation.Horizontal:
            return None
        titles = (
            (self.tr("Time"), self.tr("When what the board stored was saved")),
            (self.tr("Before"), self.tr("What came next")),
            (self.tr("Board"), self.tr("Model and firmware")),
            (self.tr("No."), self.tr("Device number")),
            (self.tr("Adapter"), self.tr("The port that the board was connected to")),
        )
        match role:
            case Qt.ItemDataRole.DisplayRole:
                return titles[section][0]
            case Qt.ItemDataRole.ToolTipRole:
                return titles[section][1]
        return None

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        if not index.isValid():
            return None
        snapshot = self._rows[index.row()]
        problem = self.problem_of(snapshot)
        match role:
            case Qt.ItemDataRole.DisplayRole:
                return self._text(snapshot, SnapshotColumn(index.column()))
            case Qt.ItemDataRole.ToolTipRole:
                return self._tip(snapshot, problem)
            case SnapshotRole.SNAPSHOT:
                return snapshot
            case SnapshotRole.PROBLEM:
                return problem
            case SnapshotRole.WORDS:
                cells = [self._text(snapshot, column) for column in SnapshotColumn]
                return " ".join((*cells, self._tip(snapshot, problem))).casefold()
        return None

    def _text(self, snapshot: Snapshot, column: SnapshotColumn) -> str:
        match column:
            case SnapshotColumn.TIME:
                return self.time_text(snapshot)
            case SnapshotColumn.BOARD:
                if self.problem_of(snapshot):
                    return self.tr("damaged")
                return f"{snapshot.product} {snapshot.firmware}".strip()
            case SnapshotColumn.NUMBER:
                return "" if snapshot.device_number is None else str(snapshot.device_number)
            case SnapshotColumn.ADAPTER:
                return snapshot.adapter
            case SnapshotColumn.REASON:
                return snapshot.reason

    def _tip(self, snapshot: Snapshot, problem: str) -> str:
        when = snapshot.taken.astimezone().strftime("%Y-%m-%d %H:%M:%S")
        lines = [when, snapshot.path.name]
        if problem:
            lines.append(self.tr("This snapshot is damaged and cannot be restored. {0}"))
            lines[-1] = lines[-1].format(problem)
        return "\n".join(lines)

    def time_text(self, snapshot: Snapshot) -> str:
        """Return when a snapshot was taken, such as `today 14:03`; local time.

        Where others are of the same minute, seconds tell them apart.
        """
        local = snapshot.taken.astimezone()
        today = datetime.now().astimezone().date()
        clock = local.strftime("%H:%M:%S" if _minute(snapshot) in self._busy else "%H:%M")
        if local.date() == today:
            return self.tr("today {0}").format(clock)
        if local.date() == today - timedelta(days=1):
            return self.tr("yesterday {0}").format(clock)
        year = "" if local.year == today.year else f" {local.year}"
        return f"{local.day} {local.strftime('%b')}{year} {clock}"


class SnapshotFilter(QSortFilterProxyModel):
    """The snapshots with all the words that are searched for, in any of their columns."""

    def __init__(self, snapshots: SnapshotTable, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._words: tuple[str, ...] = ()
        self.setSourceModel(snapshots)

    def set_words(self, text: str) -> None:
        """Show rows with all these words, whatever their case."""
        self._words = tuple(text.casefold().split())
        self.invalidate()

    def filterAcceptsRow(self, source_row: int, source_parent: Index) -> bool:
        if not self._words:
            return True
        index = self.sourceModel().index(source_row, SnapshotColumn.TIME, source_parent)
        words = cast("str", index.data(SnapshotRole.WORDS))
        return all(word in words for word in self._words)


def _in_short(error: SettingsError) -> str:
    """Return the first findings as sentences, and how many more there are."""
    first = error.findings[:_FINDINGS]
    more = len(error.findings) - len(first)
    sentences = [f"{str(found)[:1].upper()}{str(found)[1:]}." for found in first]
    return " ".join([*sentences, f"And {more} more."] if more else sentences)


def _minute(snapshot: Snapshot) -> datetime:
    return snapshot.taken.replace(second=0)


def _stamp(path: Path) -> Stamp:
    """Return what changes when a file does."""
    try:
        found = path.stat()
    except OSError:
        return 0, 0
    return found.st_mtime_ns, found.st_size
