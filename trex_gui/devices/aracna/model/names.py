"""Poses, and sequences with gaits, as lists for views: in their order, to be renamed in place."""

from dataclasses import dataclass
from typing import Any

from PySide6.QtCore import (
    QAbstractListModel,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    Qt,
    Signal,
    Slot,
)

from trex_gui.core.errors import BadRequest
from trex_gui.devices.aracna.model.library import Library
from trex_gui.devices.aracna.poses.gaits import GAITS, Gait
from trex_gui.devices.aracna.poses.project import missing_poses
from trex_gui.devices.aracna.poses.sequence import Sequence

_Index = QModelIndex | QPersistentModelIndex
_NOWHERE = QModelIndex()


@dataclass(frozen=True, slots=True)
class Motion:
    """What can be played: a sequence of the library, or a gait that comes with the program."""

    name: str
    built_in: bool = False


class Names(QAbstractListModel):
    """A row for each item; the library renames, and this one says so.

    Signals:
        refused: why a name was not taken, for people.
    """

    refused = Signal(str)

    def __init__(self, library: Library, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.library = library
        self._shown = self._keys()
        library.changed.connect(self._on_library_changed)

    def _keys(self) -> tuple[Motion, ...]:
        raise NotImplementedError

    def _rename(self, key: Motion, name: str) -> None:
        raise NotImplementedError

    def key(self, row: int) -> Motion | None:
        """Return what stands in a row; `None` beyond the list."""
        return self._shown[row] if 0 <= row < len(self._shown) else None

    def row(self, key: Motion) -> int:
        """Return the row of an item; -1 where it is not in the list."""
        return self._shown.index(key) if key in self._shown else -1

    def rowCount(self, parent: _Index = _NOWHERE) -> int:
        return 0 if parent.isValid() else len(self._shown)

    def data(self, index: _Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        key = self.key(index.row()) if index.isValid() else None
        if key is None:
            return None
        if role == Qt.ItemDataRole.EditRole:
            return key.name
        if role == Qt.ItemDataRole.DisplayRole:
            return self.tr("{0} (built in)").format(key.name) if key.built_in else key.name
        return self._about(key) if role == Qt.ItemDataRole.ToolTipRole else None

    def _about(self, key: Motion) -> str:
        return key.name

    def flags(self, index: _Index) -> Qt.ItemFlag:
        key = self.key(index.row()) if index.isValid() else None
        if key is None:
            return Qt.ItemFlag.ItemIsDropEnabled  # between the rows
        flags = Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable
        if not key.built_in:
            flags |= Qt.ItemFlag.ItemIsEditable | Qt.ItemFlag.ItemIsDragEnabled
        return flags

    def supportedDropActions(self) -> Qt.DropAction:  # noqa: N802 - Qt's name
        return Qt.DropAction.MoveAction

    def setData(self, index: _Index, value: Any, role: int = Qt.ItemDataRole.EditRole) -> bool:
        key = self.key(index.row()) if index.isValid() else None
        if key is None or key.built_in or role != Qt.ItemDataRole.EditRole:
            return False
        try:
            self._rename(key, str(value))
        except BadRequest as error:
            self.refused.emit(self.tr("Not renamed: {0}.").format(error))
            return False
        return True

    @Slot()
    def _on_library_changed(self) -> None:
        keys = self._keys()
        if len(keys) == len(self._shown):
            self._shown = keys
            if keys:
                self.dataChanged.emit(self.index(0), self.index(len(keys) - 1))
            return
        self.beginResetModel()
        self._shown = keys
        self.endResetModel()


class PoseNames(Names):
    """The poses of a library."""

    def _keys(self) -> tuple[Motion, ...]:
        return tuple(Motion(pose.name) for pose in self.library.poses)

    def _rename(self, key: Motion, name: str) -> None:
        self.library.rename_pose(key.name, name)

    def _about(self, key: Motion) -> str:
        pose = self.library.pose(key.name)
        return ", ".join(map(str, pose.positions)) if pose else ""


class MotionNames(Names):
    """The sequences of a library, and behind them the gaits."""

    def _keys(self) -> tuple[Motion, ...]:
        sequences = tuple(Motion(sequence.name) for sequence in self.library.sequences)
        return sequences + tuple(Motion(gait.name, built_in=True) for gait in GAITS)

    def _rename(self, key: Motion, name: str) -> None:
        self.library.rename_sequence(key.name, name)

    def _about(self, key: Motion) -> str:
        played = played_of(self.library, key)
        if isinstance(played, Gait):
            ours = self.tr("It is made of the authors' poses, but not theirs.")
            return f"{played.about} {ours}" if played.ours else played.about
        if played is None:
            return ""
        missing = missing_poses(played, self.library.poses)
        if missing:
            return self.tr("Poses that are not defined: {0}").format(", ".join(missing))
        return self.tr("{0} steps, {1:g} s").format(len(played.steps), played.seconds)


def played_of(library: Library, motion: Motion | None) -> Sequence | Gait | None:
    """Return what is meant by a motion; `None` where it is gone."""
    if motion is None:
        return None
    if motion.built_in:
        return next((gait for gait in GAITS if gait.name == motion.name), None)
    return library.sequence(motion.name)
