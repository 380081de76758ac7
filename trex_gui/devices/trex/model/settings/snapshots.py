"""The history as a table with a row per snapshot."""

from bisect import bisect_left
from collections import Counter, deque
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import datetime, timedelta
from enum import IntEnum
from functools import partial
from itertools import chain
from pathlib import Path
from typing import Any

from PySide6.QtCore import (
    QAbstractTableModel,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    Qt,
    Signal,
    Slot,
)

from trex_gui.core.errors import StudioError
from trex_gui.core.files import SettingsError
from trex_gui.core.translation import tr
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.settings.history import (
    Bound,
    Order,
    SettingsHistory,
    Snapshot,
    Stamp,
    order_of,
)
from trex_gui.ui.files import in_background, start_in_background
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.widgets.builders import plain
from trex_gui.ui.workers.file_worker import ProgressCallback

Index = QModelIndex | QPersistentModelIndex

_FINDINGS = 3
_ROWS_AT_ONCE = 200


class SnapshotColumn(IntEnum):
    TIME = 0
    REASON = 1
    BOARD = 2
    NUMBER = 3
    ADAPTER = 4


@dataclass(frozen=True, slots=True)
class Listing:
    """What a folder of snapshots holds besides the snapshots themselves."""

    total: int = 0  # how many snapshots there are, shown or not
    bound: Bound = field(default_factory=Bound)
    has_folder: bool = False


@dataclass(frozen=True, slots=True)
class RowEdit:
    """`removed` rows from `place` on give way to others, or one row to a changed one."""

    place: int
    removed: int = 0
    rows: tuple[Snapshot, ...] = ()


def row_edits(shown: Iterable[Snapshot], wanted: Iterable[Snapshot]) -> Iterator[RowEdit]:
    """Yield what makes the rows shown those wanted, one after the other; both newest first."""
    old = deque(shown)
    place, new = 0, list[Snapshot]()
    for snapshot in wanted:
        order, removed = order_of(snapshot.path), 0
        while old and order_of(old[0].path) > order:
            old.popleft()
            removed += 1
        stays = bool(old) and old[0].path == snapshot.path
        if new and (removed or stays or len(new) >= _ROWS_AT_ONCE):
            yield RowEdit(place, 0, tuple(new))
            place += len(new)
            new = []
        if removed:
            yield RowEdit(place, removed)
        if not stays:
            new.append(snapshot)
            continue
        if old.popleft() is not snapshot:
            yield RowEdit(place, 1, (snapshot,))
        place += 1
    if new:
        yield RowEdit(place, 0, tuple(new))
    if old:
        yield RowEdit(place + len(new), len(old))


class _Search:
    """Lists the snapshots with all the words of a search; `run` is called in a thread of its own.

    What it finds is in `found` as soon as it is known: the minutes with several snapshots, then
    `RowEdit`s.
    """

    def __init__(
        self,
        history: SettingsHistory,
        known: dict[str, Snapshot],
        shown: Sequence[Snapshot],
        words: str,
        problems: Mapping[Path, str],
    ) -> None:
        """`known` are heads that were read before, by file name; it is kept up to date."""
        self.found: deque[frozenset[datetime] | RowEdit] = deque()
        self._history = history
        self._known = known
        self._shown = shown
        self._words = words.casefold().split()
        self._problems = problems

    def run(self, progress: ProgressCallback) -> Listing:
        files = self._history.files()
        minutes = Counter(taken.replace(second=0) for taken, _, _ in files)
        busy = frozenset(minute for minute, count in minutes.items() if count > 1)
        self.found.append(busy)
        self.found.extend(row_edits(self._shown, self._matching(files, busy, progress)))
        for gone in self._known.keys() - {name for _, _, name in files}:
            self._known.pop(gone, None)
        folder = self._history.folder
        return Listing(len(files), self._history.bound(), folder.is_dir())

    def _matching(
        self, files: Sequence[Order], busy: frozenset[datetime], progress: ProgressCallback
    ) -> Iterator[Snapshot]:
        for number, file in enumerate(files, 1):
            name = file[2]
            snapshot = self._known[name] = self._history.look_at(file, self._known.get(name))
            progress(number / len(files))
            if not self._words or self._matches(snapshot, busy):
                yield snapshot

    def _matches(self, snapshot: Snapshot, busy: frozenset[datetime]) -> bool:
        problem = self._problems.get(snapshot.path, snapshot.problem)
        text = " ".join((*_cells(snapshot, problem, busy), _tip(snapshot, problem))).casefold()
        return all(word in text for word in self._words)


class SnapshotTable(QAbstractTableModel):
    """The snapshots in the folder of a history that match a search, the newest first.

    Files are listed and read in threads of their own. Damage below the head of a file is found when
    the snapshot is loaded, and stays known.
    """

    listed = Signal(object)  # the folder was read to its end; `listing`
    loaded = Signal()  # `content_of` knows more
    failed = Signal(str)  # why the folder cannot be listed, for the user

    def __init__(self, history: SettingsHistory, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._history = history
        self.snapshots: list[Snapshot] = []
        self.listing: Listing | None = None  # `None` before the folder was read
        self._busy_minutes: frozenset[datetime] = frozenset()
        self._known: dict[str, Snapshot] = {}
        self._contents: dict[Path, tuple[Stamp, Settings | str]] = {}  # or why it is damaged
        self._loading: set[Path] = set()
        self._words = ""
        self._starts_anew = False
        self._search: _Search | None = None
        self._cancel: Callable[[], None] = lambda: None

    def set_words(self, text: str) -> None:
        """Show only snapshots with all these words, in any of their columns."""
        if text.split() != self._words.split():
            self._words = text
            self._starts_anew = True
            self.refresh()

    def refresh(self) -> None:
        """Read the folder again; rows that stay keep their place."""
        self._cancel()
        known = self._contents.items()
        problems = {path: text for path, (_, text) in known if isinstance(text, str)}
        shown = () if self._starts_anew else tuple(self.snapshots)
        search = _Search(self._history, self._known, shown, self._words, problems)
        self._search = search
        self._cancel = start_in_background(
            self, search.run, self._on_listed, self._on_failed, self._on_progressed
        )

    @Slot(float)
    def _on_progressed(self, _share: float) -> None:
        """Show what was found so far."""
        if self._search is None:
            return
        if self._starts_anew:
            self._starts_anew = False
            self.beginResetModel()
            self.snapshots.clear()
            self.endResetModel()
        found = self._search.found
        while found:
            first = found.popleft()
            if isinstance(first, RowEdit):
                self._edit(first)
            else:
                self._busy_minutes = first

    def _on_listed(self, listing: Listing) -> None:
        self._on_progressed(1.0)
        self._search = None
        self.listing = listing
        if self.snapshots:  # it may be tomorrow now, or a minute have more snapshots
            self._announce(0, len(self.snapshots) - 1)
        self.listed.emit(listing)

    def _on_failed(self, error: StudioError) -> None:
        self._search = None
        self.failed.emit(str(error))

    def _edit(self, edit: RowEdit) -> None:
        nowhere, end = QModelIndex(), edit.place + edit.removed
        if edit.removed == len(edit.rows):
            self.snapshots[edit.place : end] = edit.rows
            self._announce(edit.place, end - 1)
        elif edit.removed:
            self.beginRemoveRows(nowhere, edit.place, end - 1)
            del self.snapshots[edit.place : end]
            self.endRemoveRows()
        else:
            self.beginInsertRows(nowhere, edit.place, edit.place + len(edit.rows) - 1)
            self.snapshots[edit.place : edit.place] = edit.rows
            self.endInsertRows()

    def _announce(self, first: int, last: int) -> None:
        self.dataChanged.emit(self.index(first, 0), self.index(last, self.columnCount() - 1))

    def row_of(self, path: Path) -> int | None:
        rows, order = self.snapshots, order_of(path)
        row = bisect_left(range(len(rows)), True, key=lambda at: order_of(rows[at].path) <= order)
        return row if row < len(rows) and rows[row].path == path else None

    def neighbour(self, snapshot: Snapshot) -> Snapshot | None:
        """Return the next newer sound snapshot of the same product, else the next older one."""
        row = self.row_of(snapshot.path)
        if row is None:
            return None
        newer = (self.snapshots[other] for other in range(row - 1, -1, -1))
        older = (self.snapshots[other] for other in range(row + 1, len(self.snapshots)))
        return next(
            (
                other
                for other in chain(newer, older)
                if other.product == snapshot.product and not self.problem_of(other)
            ),
            None,
        )

    def content_of(self, snapshot: Snapshot) -> Settings | str | None:
        """Return the settings in a snapshot, or why it cannot be used.

        `None` while that is not known: it is being read, and `loaded` follows.
        """
        stamp, content = self._contents.get(snapshot.path, (None, None))
        if stamp == snapshot.stamp:
            return content
        if snapshot.path not in self._loading:
            self._loading.add(snapshot.path)
            in_background(
                self,
                partial(self._history.load, snapshot),
                partial(self._on_loaded, snapshot),
                partial(self._on_not_loaded, snapshot),
            )
        return None

    def _on_not_loaded(self, snapshot: Snapshot, error: StudioError) -> None:
        self._on_loaded(snapshot, _in_short(error))
        row = self.row_of(snapshot.path)
        if row is not None:
            self._announce(row, row)

    def _on_loaded(self, snapshot: Snapshot, content: Settings | str) -> None:
        self._loading.discard(snapshot.path)
        self._contents[snapshot.path] = (snapshot.stamp, content)
        self.loaded.emit()

    def problem_of(self, snapshot: Snapshot) -> str:
        """Return why a snapshot cannot be used, as far as that is known; empty if it can."""
        stamp, content = self._contents.get(snapshot.path, (None, snapshot.problem))
        is_current = stamp == snapshot.stamp
        return content if is_current and isinstance(content, str) else snapshot.problem

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
            (tr("Time"), tr("When the settings of the board were saved")),
            (tr("Before"), tr("The operation that followed")),
            (tr("Board"), tr("Model and firmware")),
            (tr("No."), tr("Device number")),
            (tr("Adapter"), tr("The port that the board was connected to")),
        )
        match role:
            case Qt.ItemDataRole.DisplayRole:
                return titles[section][0]
            case Qt.ItemDataRole.ToolTipRole:
                return plain(titles[section][1])
        return None

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        if not index.isValid():
            return None
        snapshot = self.snapshots[index.row()]
        match role:
            case Qt.ItemDataRole.DisplayRole:
                return self._cells(snapshot)[index.column()]
            case Qt.ItemDataRole.ToolTipRole:
                return plain(_tip(snapshot, self.problem_of(snapshot)))
            case Qt.ItemDataRole.DecorationRole if index.column() == SnapshotColumn.BOARD:
                return icon("warning", "warning") if self.problem_of(snapshot) else None
        return None

    def _cells(self, snapshot: Snapshot) -> tuple[str, ...]:
        return _cells(snapshot, self.problem_of(snapshot), self._busy_minutes)

    def time_text(self, snapshot: Snapshot) -> str:
        """Return local time such as `today 14:03`, with seconds if the minute has several."""
        return _time_text(snapshot, self._busy_minutes)


def _cells(snapshot: Snapshot, problem: str, busy: Collection[datetime]) -> tuple[str, ...]:
    board = f"{snapshot.product} {snapshot.firmware}".strip()
    return (
        _time_text(snapshot, busy),
        snapshot.reason,
        tr("damaged") if problem else board,
        "" if snapshot.device_number is None else str(snapshot.device_number),
        snapshot.adapter,
    )


def _tip(snapshot: Snapshot, problem: str) -> str:
    when = snapshot.taken.astimezone().strftime("%Y-%m-%d %H:%M:%S")
    lines = [when, snapshot.path.name]
    if problem:
        lines.append(tr("This snapshot is damaged and cannot be restored. {0}").format(problem))
    return "\n".join(lines)


def _time_text(snapshot: Snapshot, busy: Collection[datetime]) -> str:
    local = snapshot.taken.astimezone()
    today = datetime.now().astimezone().date()
    is_busy = snapshot.taken.replace(second=0) in busy
    clock = local.strftime("%H:%M:%S" if is_busy else "%H:%M")
    if local.date() == today:
        return tr("today {0}").format(clock)
    if local.date() == today - timedelta(days=1):
        return tr("yesterday {0}").format(clock)
    year = "" if local.year == today.year else f" {local.year}"
    return f"{local.day} {local.strftime('%b')}{year} {clock}"


def _in_short(error: StudioError) -> str:
    if not isinstance(error, SettingsError):
        return str(error)
    first = error.findings[:_FINDINGS]
    more = len(error.findings) - len(first)
    sentences = [f"{str(found)[:1].upper()}{str(found)[1:]}." for found in first]
    if more:
        sentences.append(tr("And %n more problem(s).", "", more))
    return " ".join(sentences)
