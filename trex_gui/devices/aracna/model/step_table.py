"""The steps of a sequence or gait as a table, with what is to be said of each."""

from dataclasses import replace
from enum import IntEnum
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
from PySide6.QtGui import QFont

from trex_gui.devices.aracna.model.library import Library
from trex_gui.devices.aracna.model.names import Motion, played_of
from trex_gui.devices.aracna.poses.gaits import Gait
from trex_gui.devices.aracna.poses.sequence import LONGEST_MS, SHORTEST_MS, SequenceStep

_Index = QModelIndex | QPersistentModelIndex
_NOWHERE = QModelIndex()
_EDITABLE = Qt.ItemFlag.ItemIsEditable


class StepColumn(IntEnum):
    """What stands where."""

    NUMBER = 0
    POSE = 1
    TIME = 2
    NOTE = 3


class StepTable(QAbstractTableModel):
    """Edits go into the library; a gait is only shown.

    Signals:
        shown: another motion, or other steps of it.
    """

    shown = Signal()

    def __init__(self, library: Library, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._library = library
        self._motion: Motion | None = None
        self._steps: tuple[SequenceStep, ...] = ()
        self._notes: dict[int, str] = {}
        self._running: int | None = None
        library.changed.connect(self._on_library_changed)

    @property
    def motion(self) -> Motion | None:
        """What is shown; it may be gone from the library."""
        return self._motion

    @property
    def steps(self) -> tuple[SequenceStep, ...]:
        """The steps shown."""
        return self._steps

    @property
    def editable(self) -> bool:
        """Whether there is a sequence whose steps can be changed."""
        return (
            self._motion is not None
            and not self._motion.built_in
            and played_of(self._library, self._motion) is not None
        )

    def show_motion(self, motion: Motion | None) -> None:
        """Show the steps of a motion."""
        if motion != self._motion:
            self._motion = motion
            self._running = None
            self._on_library_changed()

    def show_notes(self, notes: dict[int, str]) -> None:
        """Say something of steps, by their index."""
        if notes != self._notes:
            self._notes = notes
            self._tell_of(StepColumn.NOTE)

    def show_running(self, step: int | None) -> None:
        """Mark the step that runs."""
        if step != self._running:
            self._running = step
            self._tell_of(StepColumn.NUMBER)

    # --- What a person does -------------------------------------------------------------

    def add(self, row: int, step: SequenceStep) -> None:
        """Put a step before a row."""
        self._put((*self._steps[:row], step, *self._steps[row:]))

    def remove(self, row: int) -> None:
        """Take a step away."""
        self._put(self._steps[:row] + self._steps[row + 1 :])

    def move(self, row: int, place: int) -> bool:
        """Put a step elsewhere; return whether there is such a place."""
        if not (0 <= row < len(self._steps) and 0 <= place < len(self._steps)):
            return False
        steps = list(self._steps)
        steps.insert(place, steps.pop(row))
        self._put(tuple(steps))
        return True

    def _put(self, steps: tuple[SequenceStep, ...]) -> None:
        if self.editable and self._motion is not None:
            self._library.set_steps(self._motion.name, steps)

    # --- What Qt asks -------------------------------------------------------------------

    def rowCount(self, parent: _Index = _NOWHERE) -> int:
        return 0 if parent.isValid() else len(self._steps)

    def columnCount(self, parent: _Index = _NOWHERE) -> int:
        return 0 if parent.isValid() else len(StepColumn)

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Qt.ItemDataRole.DisplayRole
    ) -> Any:
        if role != Qt.ItemDataRole.DisplayRole or orientation is not Qt.Orientation.Horizontal:
            return None
        titles = (self.tr("Step"), self.tr("Pose"), self.tr("Time"), self.tr("Remarks"))
        return titles[section] if 0 <= section < len(titles) else None

    def data(self, index: _Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        if not index.isValid() or index.row() >= len(self._steps):
            return None
        step, column = self._steps[index.row()], StepColumn(index.column())
        if role == Qt.ItemDataRole.FontRole:
            font = QFont()
            font.setBold(index.row() == self._running)
            return font
        if role == Qt.ItemDataRole.ToolTipRole and column is StepColumn.NOTE:
            return self._notes.get(index.row(), "")
        if role not in (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.EditRole):
            return None
        match column:
            case StepColumn.NUMBER:
                sign = "▶ " if index.row() == self._running else ""
                return f"{sign}{index.row() + 1}"
            case StepColumn.POSE:
                return step.pose_name
            case StepColumn.TIME:
                ms = step.milliseconds
                return ms if role == Qt.ItemDataRole.EditRole else self.tr("{0} ms").format(ms)
            case StepColumn.NOTE:
                return self._notes.get(index.row(), "")

    def flags(self, index: _Index) -> Qt.ItemFlag:
        flags = super().flags(index)
        if index.isValid() and index.column() in (StepColumn.POSE, StepColumn.TIME):
            return flags | _EDITABLE if self.editable else flags
        return flags

    def setData(self, index: _Index, value: Any, role: int = Qt.ItemDataRole.EditRole) -> bool:
        if (
            role != Qt.ItemDataRole.EditRole
            or not index.isValid()
            or not self.flags(index) & _EDITABLE
        ):
            return False
        row, step = index.row(), self._steps[index.row()]
        try:
            if index.column() == StepColumn.POSE:
                step = replace(step, pose_name=str(value))
            else:
                step = replace(step, milliseconds=min(max(int(value), SHORTEST_MS), LONGEST_MS))
        except ValueError:
            return False
        self._put((*self._steps[:row], step, *self._steps[row + 1 :]))
        return True

    # --- Keeping up ---------------------------------------------------------------------

    def _tell_of(self, column: StepColumn) -> None:
        if self._steps:
            last = self.index(len(self._steps) - 1, column)
            self.dataChanged.emit(self.index(0, column), last)

    @Slot()
    def _on_library_changed(self) -> None:
        steps = self._read()
        if steps == self._steps:
            self.shown.emit()
            return
        if len(steps) == len(self._steps):
            self._steps = steps
            last = self.index(len(steps) - 1, len(StepColumn) - 1)
            self.dataChanged.emit(self.index(0, 0), last)
        else:
            self.beginResetModel()
            self._steps = steps
            self._notes = {}
            self.endResetModel()
        self.shown.emit()

    def _read(self) -> tuple[SequenceStep, ...]:
        played = played_of(self._library, self._motion)
        if isinstance(played, Gait):
            return tuple(
                SequenceStep(stage.pose.name, max(round(stage.seconds * 1000), SHORTEST_MS))
                for stage in played.stages
            )
        return played.steps if played is not None else ()
