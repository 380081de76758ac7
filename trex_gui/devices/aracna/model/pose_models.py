"""Qt models of a library: names of poses or sequences, and the steps of a sequence or gait."""

from dataclasses import replace
from enum import IntEnum
from typing import Any

from PySide6.QtCore import (
    QAbstractListModel,
    QAbstractTableModel,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    Qt,
    Signal,
    Slot,
)
from PySide6.QtGui import QFont

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import Number, tr
from trex_gui.devices.aracna.model.library import ItemKey, ItemKind, Library
from trex_gui.devices.aracna.poses.gaits import GAITS, Gait
from trex_gui.devices.aracna.poses.project import LONGEST_MS, SHORTEST_MS, SequenceStep
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.widgets.builders import plain

_Index = QModelIndex | QPersistentModelIndex
_NO_PARENT = QModelIndex()
_EDITABLE = Qt.ItemFlag.ItemIsEditable
_Role = Qt.ItemDataRole


class NameModel(QAbstractListModel):
    """Editable names: the poses of a library, or its sequences and the built-in gaits."""

    def __init__(
        self, library: Library, kind: ItemKind, notifier: Notifier, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._notifier = notifier
        self._library = library
        self._kind = kind
        self._rows = self._keys()
        library.changed.connect(self._on_library_changed)

    def _keys(self) -> tuple[ItemKey, ...]:
        if self._kind is ItemKind.POSE:
            return tuple(map(ItemKey, self._library.project.pose_names))
        sequences = tuple(ItemKey(one.name) for one in self._library.project.sequences)
        return sequences + tuple(ItemKey(gait.name, built_in=True) for gait in GAITS)

    def key(self, row: int) -> ItemKey | None:
        return self._rows[row] if 0 <= row < len(self._rows) else None

    def row(self, key: ItemKey) -> int:
        """Return the row of an item; -1 if it is not in the list."""
        return self._rows.index(key) if key in self._rows else -1

    def rowCount(self, parent: _Index = _NO_PARENT) -> int:
        return 0 if parent.isValid() else len(self._rows)

    def data(self, index: _Index, role: int = _Role.DisplayRole) -> Any:
        key = self.key(index.row()) if index.isValid() else None
        if key is None:
            return None
        if role == _Role.EditRole:
            return key.name
        if role == _Role.DisplayRole:
            return tr("{0} (built in)").format(key.name) if key.built_in else key.name
        return plain(self._tool_tip(key)) if role == _Role.ToolTipRole else None

    def _tool_tip(self, key: ItemKey) -> str:
        if self._kind is ItemKind.POSE:
            pose = self._library.project.pose(key.name)
            return ", ".join(map(str, pose.positions)) if pose else ""
        played = self._library.playable(key)
        if isinstance(played, Gait):
            ours = tr("Uses the authors' poses, but was not made by them.")
            about = tr(played.about)
            return f"{about} {ours}" if played.ours else about
        if played is None:
            return ""
        if missing := played.missing(self._library.project.pose_names):
            return tr("Undefined poses: {0}").format(", ".join(missing))
        return tr("%n step(s), {0:g} s", "", len(played.steps)).format(Number(played.seconds))

    def flags(self, index: _Index) -> Qt.ItemFlag:
        key = self.key(index.row()) if index.isValid() else None
        if key is None:
            return Qt.ItemFlag.ItemIsDropEnabled  # between the rows
        flags = Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable
        return flags if key.built_in else flags | _EDITABLE | Qt.ItemFlag.ItemIsDragEnabled

    def supportedDropActions(self) -> Qt.DropAction:  # noqa: N802 - Qt's name
        return Qt.DropAction.MoveAction

    def setData(self, index: _Index, value: Any, role: int = _Role.EditRole) -> bool:
        key = self.key(index.row()) if index.isValid() else None
        if key is None or key.built_in or role != _Role.EditRole:
            return False
        try:
            self._library.rename(self._kind, key.name, str(value))
        except BadRequest as error:
            self._notifier.error.emit(tr("Not renamed: {0}.").format(error))
            return False
        return True

    @Slot()
    def _on_library_changed(self) -> None:
        keys = self._keys()
        if len(keys) == len(self._rows):
            self._rows = keys
            if keys:
                self.dataChanged.emit(self.index(0), self.index(len(keys) - 1))
            return
        self.beginResetModel()
        self._rows = keys
        self.endResetModel()


class StepColumn(IntEnum):
    NUMBER = 0
    POSE = 1
    TIME = 2
    NOTE = 3


class StepTable(QAbstractTableModel):
    """The steps of one sequence or gait; edits go to the library, gaits are read-only."""

    shown = Signal()  # another item is shown, or its steps have changed

    def __init__(self, library: Library, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._library = library
        self.item: ItemKey | None = None  # the sequence or gait; it may be gone from the library
        self.steps: tuple[SequenceStep, ...] = ()
        self._notes: dict[int, str] = {}
        self._running: int | None = None
        library.changed.connect(self._on_library_changed)

    @property
    def editable(self) -> bool:
        item = self.item
        return item is not None and not item.built_in and self._library.playable(item) is not None

    def show_item(self, item: ItemKey | None) -> None:
        if item != self.item:
            self.item = item
            self._running = None
            self._on_library_changed()

    def show_notes(self, notes: dict[int, str]) -> None:
        if notes != self._notes:
            self._notes = notes
            self._emit_changed()

    def show_running(self, step: int | None) -> None:
        if step != self._running:
            self._running = step
            self._emit_changed()

    def add(self, row: int, step: SequenceStep) -> None:
        self._set_steps((*self.steps[:row], step, *self.steps[row:]))

    def remove(self, row: int) -> None:
        self._set_steps(self.steps[:row] + self.steps[row + 1 :])

    def move(self, row: int, place: int) -> bool:
        if not (0 <= row < len(self.steps) and 0 <= place < len(self.steps)):
            return False
        steps = list(self.steps)
        steps.insert(place, steps.pop(row))
        self._set_steps(tuple(steps))
        return True

    def _set_steps(self, steps: tuple[SequenceStep, ...]) -> None:
        if self.editable and self.item is not None:
            self._library.set_steps(self.item.name, steps)

    def rowCount(self, parent: _Index = _NO_PARENT) -> int:
        return 0 if parent.isValid() else len(self.steps)

    def columnCount(self, parent: _Index = _NO_PARENT) -> int:
        return 0 if parent.isValid() else len(StepColumn)

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = _Role.DisplayRole
    ) -> Any:
        if role != _Role.DisplayRole or orientation is not Qt.Orientation.Horizontal:
            return None
        titles = (tr("Step"), tr("Pose"), tr("Time"), tr("Remarks"))
        return titles[section] if 0 <= section < len(titles) else None

    def data(self, index: _Index, role: int = _Role.DisplayRole) -> Any:
        if not index.isValid() or index.row() >= len(self.steps):
            return None
        row, column = index.row(), StepColumn(index.column())
        step, is_running, note = self.steps[row], row == self._running, self._notes.get(row, "")
        if role == _Role.FontRole:
            font = QFont()
            font.setBold(is_running)
            return font
        if role == _Role.ToolTipRole and column is StepColumn.NOTE:
            return plain(note)
        if role not in (_Role.DisplayRole, _Role.EditRole):
            return None
        match column:
            case StepColumn.NUMBER:
                return f"{'▶ ' if is_running else ''}{row + 1}"
            case StepColumn.POSE:
                return step.pose_name
            case StepColumn.TIME:
                ms = step.milliseconds
                return ms if role == _Role.EditRole else tr("{0} ms").format(ms)
            case StepColumn.NOTE:
                return note

    def flags(self, index: _Index) -> Qt.ItemFlag:
        flags = super().flags(index)
        if index.isValid() and index.column() in (StepColumn.POSE, StepColumn.TIME):
            return flags | _EDITABLE if self.editable else flags
        return flags

    def setData(self, index: _Index, value: Any, role: int = _Role.EditRole) -> bool:
        if role != _Role.EditRole or not index.isValid() or not self.flags(index) & _EDITABLE:
            return False
        row, step = index.row(), self.steps[index.row()]
        try:
            if index.column() == StepColumn.POSE:
                step = replace(step, pose_name=str(value))
            else:
                step = replace(step, milliseconds=min(max(int(value), SHORTEST_MS), LONGEST_MS))
        except ValueError:
            return False
        self._set_steps((*self.steps[:row], step, *self.steps[row + 1 :]))
        return True

    def _emit_changed(self) -> None:
        if self.steps:
            last = self.index(len(self.steps) - 1, len(StepColumn) - 1)
            self.dataChanged.emit(self.index(0, 0), last)

    @Slot()
    def _on_library_changed(self) -> None:
        played = self._library.playable(self.item)
        steps = played.steps if played is not None else ()
        if len(steps) != len(self.steps):
            self.beginResetModel()
            self.steps = steps
            self._notes = {}
            self.endResetModel()
        elif steps != self.steps:
            self.steps = steps
            self._emit_changed()
        self.shown.emit()
