"""The history as a table with a row per snapshot."""

from collections import Counter
from datetime import datetime, timedelta
from enum import IntEnum
from pathlib import Path
from typing import Any

from PySide6.QtCore import (
    QAbstractTableModel,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    QRegularExpression,
    QSortFilterProxyModel,
    Qt,
)

from trex_gui.core.files import SettingsError
from trex_gui.devices.trex.model.settings.rows import renew_rows
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.history import SettingsHistory, Snapshot
from trex_gui.ui.translations import Plural

Index = QModelIndex | QPersistentModelIndex
Stamp = tuple[int, int]

_FINDINGS = 3


class SnapshotColumn(IntEnum):
    TIME = 0
    REASON = 1
    BOARD = 2
    NUMBER = 3
    ADAPTER = 4


class SnapshotRole(IntEnum):
    PROBLEM = Qt.ItemDataRole.UserRole
    WORDS = Qt.ItemDataRole.UserRole + 1


class SnapshotTable(QAbstractTableModel):
    """The snapshots in the folder of a history, the newest first.

    Damage below the head of a file is found when the snapshot is loaded, and stays known.
    """

    def __init__(self, history: SettingsHistory, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._history = history
        self.snapshots: list[Snapshot] = []
        self._busy_minutes: set[datetime] = set()
        self._contents: dict[Path, tuple[Stamp, Settings | str]] = {}  # or why it is damaged

    def refresh(self) -> None:
        """Read the folder again; rows that stay keep their place."""
        found = self._history.snapshots()
        minutes = Counter(map(_minute, found))
        self._busy_minutes = {minute for minute, count in minutes.items() if count > 1}
        known = self._contents.items()
        self._contents = {path: content for path, content in known if _stamp(path) == content[0]}
        renew_rows(self, self.snapshots, found, lambda snapshot: snapshot.path)
        if found:  # it may be tomorrow now, or a file was repaired
            self._announce(0, len(found) - 1)

    def _announce(self, first: int, last: int) -> None:
        self.dataChanged.emit(self.index(first, 0), self.index(last, self.columnCount() - 1))

    def row_of(self, path: Path) -> int | None:
        rows = (row for row, snapshot in enumerate(self.snapshots) if snapshot.path == path)
        return next(rows, None)

    def neighbour(self, snapshot: Snapshot) -> Snapshot | None:
        """Return the next newer sound snapshot of the same product, else the next older one."""
        row = self.row_of(snapshot.path)
        if row is None:
            return None
        candidates = (*reversed(self.snapshots[:row]), *self.snapshots[row + 1 :])
        return next(
            (c for c in candidates if c.product == snapshot.product and not self.problem_of(c)),
            None,
        )

    def load(self, snapshot: Snapshot) -> Settings:
        """Return the settings in a snapshot.

        Raises:
            SettingsError: the file is gone or damaged; the table shows it from then on.
        """
        path = snapshot.path
        stamp = _stamp(path)
        known_stamp, content = self._contents.get(path, (None, ""))
        if known_stamp == stamp and isinstance(content, Settings):
            return content
        try:
            settings = self._history.load(snapshot)
        except SettingsError as error:
            self._contents[path] = (stamp, _in_short(error))
            row = self.row_of(path)
            if row is not None:
                self._announce(row, row)
            raise
        self._contents[path] = (stamp, settings)
        return settings

    def problem_of(self, snapshot: Snapshot) -> str:
        """Return why a snapshot cannot be used, as far as that is known; empty if it can."""
        _, content = self._contents.get(snapshot.path, (None, snapshot.problem))
        return content if isinstance(content, str) else snapshot.problem

    def rowCount(self, parent: Index | None = None) -> int:
        return 0 if parent is not None and parent.isValid() else len(self.snapshots)

    def columnCount(self, parent: Index | None = None) -> int:
        return 0 if parent is not None and parent.isValid() else len(SnapshotColumn)

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        if orientation is not Qt.Orientation.Horizontal:
            return None
        titles = (
            (self.tr("Time"), self.tr("When the settings of the board were saved")),
            (self.tr("Before"), self.tr("The operation that followed")),
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
        snapshot = self.snapshots[index.row()]
        match role:
            case Qt.ItemDataRole.DisplayRole:
                return self._cells(snapshot)[index.column()]
            case Qt.ItemDataRole.ToolTipRole:
                return self._tip(snapshot)
            case SnapshotRole.PROBLEM:
                return self.problem_of(snapshot)
            case SnapshotRole.WORDS:
                return " ".join((*self._cells(snapshot), self._tip(snapshot)))
        return None

    def _cells(self, snapshot: Snapshot) -> tuple[str, ...]:
        board = f"{snapshot.product} {snapshot.firmware}".strip()
        return (
            self.time_text(snapshot),
            snapshot.reason,
            self.tr("damaged") if self.problem_of(snapshot) else board,
            "" if snapshot.device_number is None else str(snapshot.device_number),
            snapshot.adapter,
        )

    def _tip(self, snapshot: Snapshot) -> str:
        when = snapshot.taken.astimezone().strftime("%Y-%m-%d %H:%M:%S")
        lines = [when, snapshot.path.name]
        if problem := self.problem_of(snapshot):
            text = self.tr("This snapshot is damaged and cannot be restored. {0}")
            lines.append(text.format(problem))
        return "\n".join(lines)

    def time_text(self, snapshot: Snapshot) -> str:
        """Return local time such as `today 14:03`, with seconds if the minute has several."""
        local = snapshot.taken.astimezone()
        today = datetime.now().astimezone().date()
        clock = local.strftime("%H:%M:%S" if _minute(snapshot) in self._busy_minutes else "%H:%M")
        if local.date() == today:
            return self.tr("today {0}").format(clock)
        if local.date() == today - timedelta(days=1):
            return self.tr("yesterday {0}").format(clock)
        year = "" if local.year == today.year else f" {local.year}"
        return f"{local.day} {local.strftime('%b')}{year} {clock}"


class SnapshotFilter(QSortFilterProxyModel):
    """The snapshots with all the words of a search, in any of their columns."""

    def __init__(self, snapshots: SnapshotTable, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.setFilterRole(SnapshotRole.WORDS)
        self.setFilterCaseSensitivity(Qt.CaseSensitivity.CaseInsensitive)
        self.setSourceModel(snapshots)

    def set_words(self, text: str) -> None:
        words = (f"(?=[\\s\\S]*{QRegularExpression.escape(word)})" for word in text.split())
        self.setFilterRegularExpression("".join(words))


def _in_short(error: SettingsError) -> str:
    first = error.findings[:_FINDINGS]
    more = len(error.findings) - len(first)
    sentences = [f"{str(found)[:1].upper()}{str(found)[1:]}." for found in first]
    if more:
        sentences.append(Plural.tr("And %n more problem(s).", "", more))
    return " ".join(sentences)


def _minute(snapshot: Snapshot) -> datetime:
    return snapshot.taken.replace(second=0)


def _stamp(path: Path) -> Stamp:
    try:
        found = path.stat()
    except OSError:
        return 0, 0
    return found.st_mtime_ns, found.st_size
