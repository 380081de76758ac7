"""Table of the snapshots in the settings history."""

from collections.abc import Callable, Mapping
from datetime import datetime, timedelta
from enum import IntEnum
from functools import partial
from pathlib import Path
from typing import Any

from PySide6.QtCore import (
    QAbstractTableModel,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    Qt,
    Signal,
)

from trex_gui.core.errors import StudioError
from trex_gui.core.files import reason_of
from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.settings.comparison_table import renew_rows
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.history import SettingsHistory, Snapshot, Stamp
from trex_gui.ui.files import in_background, start_in_background
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.widgets.builders import plain
from trex_gui.ui.workers.file_worker import ProgressCallback

Index = QModelIndex | QPersistentModelIndex


class SnapshotColumn(IntEnum):
    TIME = 0
    NAME = 1
    NOTE = 2
    REASON = 3
    BOARD = 4
    NUMBER = 5
    ADAPTER = 6


_LABELS = {SnapshotColumn.NAME: "name", SnapshotColumn.NOTE: "note"}  # editable columns


def _read(
    history: SettingsHistory, known: Mapping[Path, Snapshot], progress: ProgressCallback
) -> tuple[Snapshot, ...]:
    files, snapshots = history.files(), list[Snapshot]()
    for number, file in enumerate(files, 1):
        snapshots.append(history.read_header(file, known.get(history.folder / file[2])))
        progress(number / len(files))
    return tuple(snapshots)


class SnapshotTable(QAbstractTableModel):
    """Snapshots that match a search, newest first.

    Files are listed and loaded in threads. Listing reads the header of each file. Damage below the
    header is found when the file is loaded.
    """

    listed = Signal()  # the folder was read, or the search has changed
    loaded = Signal()  # `content_of` can return the content of another snapshot
    failed = Signal(str)  # reason for the user

    def __init__(self, history: SettingsHistory, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._history = history
        self.matches: list[Snapshot] = []
        self.all_snapshots: tuple[Snapshot, ...] | None = None  # `None` until the folder is read
        self._contents: dict[Path, tuple[Stamp, Settings | str]] = {}  # settings or damage
        self._loading: set[Path] = set()
        self._words: list[str] = []
        self._cancel: Callable[[], None] = lambda: None

    def set_search_text(self, text: str) -> None:
        self._words = text.casefold().split()
        if self.all_snapshots is not None:
            self.beginResetModel()
            self.matches = self._matching(self.all_snapshots)
            self.endResetModel()
            self.listed.emit()

    def refresh(self) -> None:
        self._cancel()
        known = {snapshot.path: snapshot for snapshot in self.all_snapshots or ()}
        read = partial(_read, self._history, known)
        self._cancel = start_in_background(
            self, read, self._on_read, lambda error: self.failed.emit(str(error))
        )

    def _on_read(self, snapshots: tuple[Snapshot, ...]) -> None:
        self.all_snapshots = snapshots
        matching = self._matching(snapshots)
        renew_rows(self, self.matches, matching, lambda snapshot: snapshot.path)
        self.matches[:] = matching  # equal snapshots may have different stamps
        if matching:  # `today` becomes `yesterday` at midnight
            self._emit_changed(0, len(matching) - 1)
        self.listed.emit()

    def _matching(self, snapshots: tuple[Snapshot, ...]) -> list[Snapshot]:
        return [snapshot for snapshot in snapshots if not self._words or self._matches(snapshot)]

    def _matches(self, snapshot: Snapshot) -> bool:
        text = " ".join((*self._cells(snapshot), self._tip(snapshot))).casefold()
        return all(word in text for word in self._words)

    def _emit_changed(self, first: int, last: int) -> None:
        self.dataChanged.emit(self.index(first, 0), self.index(last, self.columnCount() - 1))

    def row_of(self, path: Path) -> int | None:
        rows = enumerate(self.matches)
        return next((row for row, snapshot in rows if snapshot.path == path), None)

    def neighbor(self, snapshot: Snapshot) -> Snapshot | None:
        """Return the next newer undamaged snapshot of the same product, or else the next older."""
        row = self.row_of(snapshot.path)
        if row is None:
            return None
        others = [*reversed(self.matches[:row]), *self.matches[row + 1 :]]
        same_model = (other for other in others if other.product == snapshot.product)
        return next((other for other in same_model if not self.problem_of(other)), None)

    def content_of(self, snapshot: Snapshot) -> Settings | str | None:
        """Return the settings, or a description of the damage.

        If neither is known yet, load the file in a thread and return `None`.
        """
        stamp, content = self._contents.get(snapshot.path, (None, None))
        if stamp == snapshot.stamp:
            return content
        if snapshot.path not in self._loading:
            self._loading.add(snapshot.path)
            load, then = partial(self._history.load, snapshot), partial(self._on_loaded, snapshot)

            def on_failed(error: StudioError) -> None:
                reason = reason_of(error)
                then(f"{reason[:1].upper()}{reason[1:]}.")

            in_background(self, load, then, on_failed)
        return None

    def _on_loaded(self, snapshot: Snapshot, content: Settings | str) -> None:
        self._loading.discard(snapshot.path)
        self._contents[snapshot.path] = (snapshot.stamp, content)
        row = self.row_of(snapshot.path)
        if row is not None:  # the file may be damaged
            self._emit_changed(row, row)
        self.loaded.emit()

    def problem_of(self, snapshot: Snapshot) -> str:
        """Return a description of the known damage, or an empty string."""
        stamp, content = self._contents.get(snapshot.path, (None, snapshot.problem))
        is_current = stamp == snapshot.stamp
        return content if is_current and isinstance(content, str) else snapshot.problem

    def rowCount(self, parent: Index | None = None) -> int:
        return 0 if parent is not None and parent.isValid() else len(self.matches)

    def columnCount(self, parent: Index | None = None) -> int:
        return 0 if parent is not None and parent.isValid() else len(SnapshotColumn)

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        if orientation is not Qt.Orientation.Horizontal or role != Qt.ItemDataRole.DisplayRole:
            return None
        titles = tr("Time"), tr("Name"), tr("Note"), tr("Before"), tr("Board"), tr("No.")
        return (*titles, tr("Adapter"))[section]

    def flags(self, index: Index) -> Qt.ItemFlag:
        flags = super().flags(index)
        return flags | Qt.ItemFlag.ItemIsEditable if index.column() in _LABELS else flags

    def setData(self, index: Index, value: Any, role: int = Qt.ItemDataRole.EditRole) -> bool:
        """Set the name or note of a snapshot in a thread. `failed` reports an error."""
        if role != Qt.ItemDataRole.EditRole or str(value) == self.data(index):
            return False
        text = {_LABELS[SnapshotColumn(index.column())]: str(value)}
        label = partial(self._history.label, self.matches[index.row()], **text)
        in_background(
            self, label, lambda _: self.refresh(), lambda error: self.failed.emit(str(error))
        )
        return True

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        if not index.isValid():
            return None
        snapshot = self.matches[index.row()]
        match role:
            case Qt.ItemDataRole.DisplayRole | Qt.ItemDataRole.EditRole:
                return self._cells(snapshot)[index.column()]
            case Qt.ItemDataRole.ToolTipRole:
                return plain(self._tip(snapshot))
            case Qt.ItemDataRole.DecorationRole if index.column() == SnapshotColumn.BOARD:
                return icon("warning", "warning") if self.problem_of(snapshot) else None
        return None

    def _cells(self, snapshot: Snapshot) -> tuple[str, ...]:
        board = f"{snapshot.product} {snapshot.firmware}".strip()
        return (
            self.time_text(snapshot),
            snapshot.name,
            snapshot.note,
            snapshot.reason,
            tr("damaged") if self.problem_of(snapshot) else board,
            "" if snapshot.device_number is None else str(snapshot.device_number),
            snapshot.adapter,
        )

    def _tip(self, snapshot: Snapshot) -> str:
        when = snapshot.taken.astimezone().strftime("%Y-%m-%d %H:%M:%S")
        lines = [when, snapshot.path.name]
        if problem := self.problem_of(snapshot):
            lines.append(tr("This snapshot is damaged and cannot be restored. {0}").format(problem))
        return "\n".join(lines)

    def time_text(self, snapshot: Snapshot) -> str:
        """Return the local time, such as `today 14:03`."""
        local = snapshot.taken.astimezone()
        today, clock = datetime.now().astimezone().date(), f"{local:%H:%M}"
        if local.date() == today:
            return tr("today {0}").format(clock)
        if local.date() == today - timedelta(days=1):
            return tr("yesterday {0}").format(clock)
        year = "" if local.year == today.year else f" {local.year}"
        return f"{local.day} {local.strftime('%b')}{year} {clock}"
