"""The poses and sequences that a person works on: one pose file, with undo."""

from collections.abc import Sequence as Many
from pathlib import Path

from PySide6.QtCore import QObject, Signal, Slot
from PySide6.QtGui import QUndoStack

from trex_gui.core.errors import BadRequest
from trex_gui.core.files.errors import Finding, SettingsError
from trex_gui.devices.aracna.model.pose_file import read_file, write_file
from trex_gui.devices.aracna.poses import editing
from trex_gui.devices.aracna.poses.gaits import Gait
from trex_gui.devices.aracna.poses.named_poses import KNOWN_POSES
from trex_gui.devices.aracna.poses.naming import free_name
from trex_gui.devices.aracna.poses.pose import Pose
from trex_gui.devices.aracna.poses.project import Project
from trex_gui.devices.aracna.poses.sequence import Sequence, SequenceStep
from trex_gui.ui.devices.undo import Edit

UNTITLED = "poses.ppr"


class Library(QObject):
    """One project; each edit replaces it by another and is one step to undo.

    What cannot be, such as a name that is taken, a position outside 0-1023 or an item that is not
    there, is refused with a `BadRequest` that says why; then nothing has changed.

    Signals:
        changed: poses, sequences, the file, or whether it is saved.

    Attributes:
        undo: what was edited since the file was opened; saving does not empty it.
        findings: what reading the file found, line by line; gone with the next file.
    """

    changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        """Begin with the authors' poses and no file."""
        super().__init__(parent)
        self.undo = QUndoStack(self)
        self.findings: tuple[Finding, ...] = ()
        self._project = self._saved = Project(poses=KNOWN_POSES)
        self._path: Path | None = None
        self._on_disk: bytes | None = None

    # --- What is there ------------------------------------------------------------------

    @property
    def project(self) -> Project:
        """All of it."""
        return self._project

    @property
    def poses(self) -> tuple[Pose, ...]:
        """In the order in which they are shown."""
        return self._project.poses

    @property
    def sequences(self) -> tuple[Sequence, ...]:
        """In the order in which they are shown."""
        return self._project.sequences

    def pose(self, name: str) -> Pose | None:
        """Return the pose of a name."""
        return self._project.pose(name)

    def sequence(self, name: str) -> Sequence | None:
        """Return the sequence of a name."""
        return self._project.sequence(name)

    @property
    def path(self) -> Path | None:
        """Where the file lies; `None` before it is saved."""
        return self._path

    @property
    def name(self) -> str:
        """What people call the file."""
        return UNTITLED if self._path is None else self._path.name

    @property
    def modified(self) -> bool:
        """Whether saving would write something else than was opened or saved last."""
        return self._project != self._saved

    def changed_on_disk(self) -> bool:
        """Whether the file holds something else now than when it was opened or saved."""
        if self._path is None or self._on_disk is None:
            return False
        try:
            return self._path.read_bytes() != self._on_disk
        except OSError:
            return False  # saving writes it anew, or says why it cannot

    # --- Files --------------------------------------------------------------------------

    @Slot()
    def new(self) -> None:
        """Begin with the authors' poses and no file; what was there is gone."""
        self._begin(Project(poses=KNOWN_POSES), None, None, ())

    def open(self, path: Path) -> tuple[Finding, ...]:
        """Open a pose file, and return what a person should know of it.

        Raises:
            SettingsError: it cannot be read, is too large or no text; then nothing has changed.
        """
        file = read_file(path)
        self._begin(file.project, path, file.data, file.findings)
        return file.findings

    def save(self, path: Path | None = None) -> None:
        """Write the file, here or elsewhere; it is the file from now on.

        Raises:
            SettingsError: it cannot be written, or has no place yet; the old one is still there.
        """
        target = path or self._path
        if target is None:
            raise SettingsError(self.name, [Finding(None, None, "it has no place on disk yet")])
        self._on_disk = write_file(target, self._project)
        self._path = target
        self._saved = self._project
        self.changed.emit()

    def _begin(
        self,
        project: Project,
        path: Path | None,
        data: bytes | None,
        findings: tuple[Finding, ...],
    ) -> None:
        self.undo.clear()
        self._project = self._saved = project
        self._path, self._on_disk, self.findings = path, data, findings
        self.changed.emit()

    # --- Poses --------------------------------------------------------------------------

    def add_pose(self, positions: Many[int], name: str = "") -> str:
        """Keep positions (0-1023, one a motor) as the last pose, and return its name.

        Without a name it is the first free one of `pose`, `pose 2` and so on.
        """
        name = name.strip() or free_name(self.tr("pose"), [pose.name for pose in self.poses])
        after = editing.with_pose(self._project, name, positions)
        self._edit(self.tr("Add pose {0}").format(name), after)
        return name

    def capture(self, present: Many[int | None], name: str = "") -> str:
        """Keep where the robot is as a pose, and return its name.

        A motor of which that is not known (`None`, or the -1 that the robot reports) refuses it.
        """
        unknown = [motor for motor, place in enumerate(present) if place is None or not place >= 0]
        if unknown or not present:
            of = f" of motor {', '.join(map(str, unknown))}" if len(unknown) < len(present) else ""
            raise BadRequest(f"where the robot is, is not known{of}; it tells that when it moves")
        return self.add_pose([place for place in present if place is not None], name)

    def set_positions(self, name: str, positions: Many[int], *, run: object = None) -> None:
        """Move a pose; edits with the same `run`, one after the other, are one step to undo."""
        after = editing.with_positions(self._project, name, positions)
        self._edit(self.tr("Change pose {0}").format(name), after, run)

    def rename_pose(self, name: str, new_name: str) -> None:
        """Give a pose another name, which the sequences follow."""
        after = editing.with_pose_renamed(self._project, name, new_name)
        self._edit(self.tr("Rename pose {0}").format(name), after)

    def duplicate_pose(self, name: str) -> str:
        """Put a copy of a pose behind it, and return the copy's name."""
        after, copied = editing.with_pose_copied(self._project, name)
        self._edit(self.tr("Duplicate pose {0}").format(name), after)
        return copied

    def delete_pose(self, name: str) -> None:
        """Take a pose away; sequences go on naming it, and undo brings it back."""
        after = editing.without_pose(self._project, name)
        self._edit(self.tr("Delete pose {0}").format(name), after)

    def move_pose(self, name: str, place: int) -> None:
        """Put a pose at a place in the order, from 0; one beyond the end is the end."""
        after = editing.with_pose_moved(self._project, name, place)
        self._edit(self.tr("Move pose {0}").format(name), after)

    # --- Sequences ----------------------------------------------------------------------

    def add_sequence(self, name: str = "", steps: Many[SequenceStep] = ()) -> str:
        """Add a sequence at the end, and return its name."""
        taken = [sequence.name for sequence in self.sequences]
        name = name.strip() or free_name(self.tr("sequence"), taken)
        after = editing.with_sequence(self._project, name, steps)
        self._edit(self.tr("Add sequence {0}").format(name), after)
        return name

    def set_steps(self, name: str, steps: Many[SequenceStep], *, run: object = None) -> None:
        """Give a sequence other steps; edits with the same `run` are one step to undo."""
        after = editing.with_steps(self._project, name, steps)
        self._edit(self.tr("Change sequence {0}").format(name), after, run)

    def rename_sequence(self, name: str, new_name: str) -> None:
        """Give a sequence another name."""
        after = editing.with_sequence_renamed(self._project, name, new_name)
        self._edit(self.tr("Rename sequence {0}").format(name), after)

    def duplicate_sequence(self, name: str) -> str:
        """Put a copy of a sequence behind it, and return the copy's name."""
        after, copied = editing.with_sequence_copied(self._project, name)
        self._edit(self.tr("Duplicate sequence {0}").format(name), after)
        return copied

    def add_gait(self, gait: Gait) -> str:
        """Add a gait as a sequence with its poses, to be changed; return its name."""
        after, name = editing.with_gait(self._project, gait)
        self._edit(self.tr("Add sequence {0}").format(name), after)
        return name

    def delete_sequence(self, name: str) -> None:
        """Take a sequence away; undo brings it back."""
        after = editing.without_sequence(self._project, name)
        self._edit(self.tr("Delete sequence {0}").format(name), after)

    def move_sequence(self, name: str, place: int) -> None:
        """Put a sequence at a place in the order, from 0; one beyond the end is the end."""
        after = editing.with_sequence_moved(self._project, name, place)
        self._edit(self.tr("Move sequence {0}").format(name), after)

    # --- Undo ---------------------------------------------------------------------------

    def _edit(self, text: str, after: Project, run: object = None) -> None:
        """Make an edit a step to undo; one that changes nothing is none."""
        if after != self._project:
            self.undo.push(Edit(text, self._put, None, self._project, after, run=run))

    def _put(self, _key: None, project: Project) -> None:
        self._project = project
        self.changed.emit()
