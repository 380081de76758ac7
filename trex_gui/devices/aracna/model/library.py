"""The user's poses and sequences: a pose file with undo."""

from collections.abc import Mapping
from collections.abc import Sequence as Many
from dataclasses import dataclass, replace
from enum import Enum
from pathlib import Path
from typing import Any

from PySide6.QtCore import QObject, Signal, Slot
from PySide6.QtGui import QUndoStack

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import tr
from trex_gui.devices.aracna.poses.gaits import BUILT_IN_POSES, GAITS, Gait
from trex_gui.devices.aracna.poses.ppr import PoseFile, write_ppr
from trex_gui.devices.aracna.poses.project import (
    Pose,
    Project,
    Sequence,
    SequenceStep,
    checked_name,
    free_name,
)
from trex_gui.ui.devices.undo import Edit
from trex_gui.ui.files import Content

UNTITLED = "poses.ppr"


class ItemKind(Enum):
    """Kind of library item. The value is the name of the `Project` field."""

    POSE = "poses"
    SEQUENCE = "sequences"


@dataclass(frozen=True, slots=True)
class ItemKey:
    name: str
    built_in: bool = False


class Library(QObject):
    """Project in which each edit is an undo step.

    An edit raises `BadRequest` and changes nothing if a name is invalid, unknown or taken, or if a
    position is outside 0-1023. The undo steps remain after saving.
    """

    changed = Signal()  # poses, sequences, file or saved state have changed

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.undo = QUndoStack(self)
        self.project = self._saved = Project(poses=BUILT_IN_POSES)
        self.path: Path | None = None
        self.on_disk: bytes | None = None  # content of the file as opened or saved
        self._opened = object()  # identifies the open file

    @property
    def name(self) -> str:
        return UNTITLED if self.path is None else self.path.name

    @property
    def modified(self) -> bool:
        return self.project != self._saved

    def playable(self, key: ItemKey | None) -> Sequence | None:
        if key is None:
            return None
        if key.built_in:
            return next((gait for gait in GAITS if gait.name == key.name), None)
        return self.project.sequence(key.name)

    # --- Files --------------------------------------------------------------------------

    @Slot()
    def new(self) -> None:
        self._load(Project(poses=BUILT_IN_POSES), None, None)

    def set_file(self, path: Path, file: PoseFile) -> None:
        self._load(file.project, path, file.data)

    def content(self) -> Content:
        """Return the content to save, without later edits."""
        text, project, opened = write_ppr(self.project), self.project, self._opened

        def record_saved(path: Path) -> None:
            if opened is self._opened:  # otherwise another file is open
                self.path, self._saved = path, project
                self.on_disk = text.encode("utf-8")
                self.changed.emit()

        return Content(text, record_saved)

    def _load(self, project: Project, path: Path | None, data: bytes | None) -> None:
        self.undo.clear()
        self._opened = object()
        self.project = self._saved = project
        self.path, self.on_disk = path, data
        self.changed.emit()

    # --- Edits of poses and sequences ---------------------------------------------------

    def rename(self, kind: ItemKind, name: str, new_name: str) -> None:
        items, index = self._find(kind, name)
        new_name = checked_name(new_name, [item.name for item in items if item.name != name])
        after = self._with(kind, index, [replace(items[index], name=new_name)])
        if kind is ItemKind.POSE:
            names = {name: new_name}
            sequences = tuple(_with_poses(sequence, names) for sequence in after.sequences)
            after = replace(after, sequences=sequences)
        self._edit(tr("Rename {0}").format(name), after)

    def duplicate(self, kind: ItemKind, name: str) -> str:
        items, index = self._find(kind, name)
        copy = replace(items[index], name=free_name(name, [item.name for item in items]))
        self._edit(tr("Duplicate {0}").format(name), self._with(kind, index, [items[index], copy]))
        return str(copy.name)

    def delete(self, kind: ItemKind, name: str) -> None:
        """Delete an item. Sequences retain the names of deleted poses."""
        _, index = self._find(kind, name)
        self._edit(tr("Delete {0}").format(name), self._with(kind, index, []))

    def move(self, kind: ItemKind, name: str, index: int) -> None:
        items, old = self._find(kind, name)
        others = [*items[:old], *items[old + 1 :]]
        others.insert(min(max(index, 0), len(others)), items[old])
        self._edit(tr("Move {0}").format(name), self._with_items(kind, others))

    def add_pose(self, positions: Many[int], name: str = "") -> str:
        taken = self.project.pose_names
        name = checked_name(name.strip() or free_name(tr("pose"), taken), taken)
        poses = (*self.project.poses, Pose(name, tuple(positions)))
        self._edit(tr("Add pose {0}").format(name), replace(self.project, poses=poses))
        return name

    def set_positions(self, name: str, positions: Many[int], *, run: object = None) -> None:
        """Change a pose. Successive edits with the same `run` are one undo step."""
        _, index = self._find(ItemKind.POSE, name)
        after = self._with(ItemKind.POSE, index, [Pose(name, tuple(positions))])
        self._edit(tr("Change pose {0}").format(name), after, run)

    def add_sequence(self, name: str = "", steps: Many[SequenceStep] = ()) -> str:
        taken = [sequence.name for sequence in self.project.sequences]
        name = checked_name(name.strip() or free_name(tr("sequence"), taken), taken)
        self._add_sequence(self.project, Sequence(name, tuple(steps)))
        return name

    def set_steps(self, name: str, steps: Many[SequenceStep]) -> None:
        _, index = self._find(ItemKind.SEQUENCE, name)
        after = self._with(ItemKind.SEQUENCE, index, [Sequence(name, tuple(steps))])
        self._edit(tr("Change sequence {0}").format(name), after)

    def add_gait(self, gait: Gait) -> str:
        """Append a gait as a sequence, with its poses. Return its name.

        A pose with an existing name but other positions gets a new name.
        """
        poses, names = list(self.project.poses), {}
        for gait_pose in gait.poses:
            pose = gait_pose
            if pose not in self.project.poses:
                pose = replace(pose, name=f"{gait.name} {pose.name}")
            if pose not in poses:
                pose = replace(pose, name=free_name(pose.name, [item.name for item in poses]))
                poses.append(pose)
            names[gait_pose.name] = pose.name
        name = free_name(gait.name, [sequence.name for sequence in self.project.sequences])
        sequence = _with_poses(Sequence(name, gait.steps), names)
        self._add_sequence(replace(self.project, poses=tuple(poses)), sequence)
        return name

    def _add_sequence(self, project: Project, sequence: Sequence) -> None:
        after = replace(project, sequences=(*project.sequences, sequence))
        self._edit(tr("Add sequence {0}").format(sequence.name), after)

    def _find(self, kind: ItemKind, name: str) -> tuple[tuple[Any, ...], int]:
        items: tuple[Any, ...] = getattr(self.project, kind.value)
        for index, item in enumerate(items):
            if item.name == name:
                return items, index
        raise BadRequest(f"the name {name} is unknown")

    def _with(self, kind: ItemKind, index: int, replacement: Many[Any]) -> Project:
        items: tuple[Any, ...] = getattr(self.project, kind.value)
        return self._with_items(kind, (*items[:index], *replacement, *items[index + 1 :]))

    def _with_items(self, kind: ItemKind, items: Many[Any]) -> Project:
        changes: dict[str, Any] = {kind.value: tuple(items)}
        return replace(self.project, **changes)

    def _edit(self, text: str, after: Project, run: object = None) -> None:
        if after != self.project:
            self.undo.push(Edit(text, self._set_project, None, self.project, after, run=run))

    def _set_project(self, _key: None, project: Project) -> None:
        self.project = project
        self.changed.emit()


def _with_poses(sequence: Sequence, names: Mapping[str, str]) -> Sequence:
    steps = tuple(
        replace(step, pose_name=names.get(step.pose_name, step.pose_name))
        for step in sequence.steps
    )
    return replace(sequence, steps=steps)
