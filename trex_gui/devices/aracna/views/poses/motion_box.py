"""Sequences and gaits: a list, the steps of the one that is chosen, and how to change them."""

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtWidgets import QGroupBox, QHBoxLayout, QVBoxLayout, QWidget

from trex_gui.devices.aracna.model.library import Library
from trex_gui.devices.aracna.model.names import Motion, MotionNames, played_of
from trex_gui.devices.aracna.model.step_table import StepTable
from trex_gui.devices.aracna.poses.gaits import GAITS, Gait
from trex_gui.devices.aracna.poses.sequence import USUAL_MS, Sequence, SequenceStep, can_be_named
from trex_gui.devices.aracna.views.poses.name_list import NameList
from trex_gui.devices.aracna.views.poses.parts import arrow_button, follow, tool_button
from trex_gui.devices.aracna.views.poses.step_view import StepView
from trex_gui.devices.aracna.views.typed import take_typed
from trex_gui.ui.notifier import Notifier


class MotionBox(QGroupBox):
    """A part of the panel.

    Signals:
        shown: another motion is chosen, or its steps are others.

    Attributes:
        table: the steps of what is chosen.
    """

    shown = Signal()

    def __init__(self, library: Library, notifier: Notifier, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("aracnaMotionBox")
        self.setTitle(self.tr("Sequences and gaits"))
        self._library = library
        self._notifier = notifier
        self._next_pose = ""
        self.table = StepTable(library, self)

        names = MotionNames(library, self)
        self._list = NameList(names, "", self)
        self._list.setObjectName("aracnaMotions")
        self._list.setAccessibleName(self.tr("Sequences and gaits"))
        self._steps = StepView(self.table, library, self)
        self._new = tool_button(
            self, "aracnaNewSequence", self.tr("New"), self.tr("New sequence"), "new"
        )
        self._copy = tool_button(
            self,
            "aracnaDuplicateSequence",
            "",
            self.tr("Duplicate; of a gait it makes a sequence that can be changed"),
            "copy",
        )
        self._delete = tool_button(
            self, "aracnaDeleteSequence", "", self.tr("Delete this sequence"), "clear"
        )
        up, down = Qt.ArrowType.UpArrow, Qt.ArrowType.DownArrow
        self._up = arrow_button(self, "aracnaSequenceUp", self.tr("Move this sequence up"), up)
        self._down = arrow_button(
            self, "aracnaSequenceDown", self.tr("Move this sequence down"), down
        )
        self._add = tool_button(
            self, "aracnaAddStep", self.tr("Add step"), self.tr("Add a step"), "new"
        )
        self._remove = tool_button(
            self, "aracnaRemoveStep", "", self.tr("Remove this step"), "clear"
        )
        self._step_up = arrow_button(self, "aracnaStepUp", self.tr("Move this step up"), up)
        self._step_down = arrow_button(self, "aracnaStepDown", self.tr("Move this step down"), down)

        of_list, of_steps = QHBoxLayout(), QHBoxLayout()
        for row, buttons in (
            (of_list, (self._new, self._copy, self._delete, self._up, self._down)),
            (of_steps, (self._add, self._remove, self._step_up, self._step_down)),
        ):
            for button in buttons:
                row.addWidget(button)
            row.addStretch(1)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(8, 6, 8, 8)
        layout.setSpacing(4)
        layout.addWidget(self._list, 2)
        layout.addLayout(of_list)
        layout.addWidget(self._steps, 3)
        layout.addLayout(of_steps)

        follow(self._copy, self._list.duplicate_action)
        follow(self._delete, self._list.delete_action)
        follow(self._up, self._list.up_action)
        follow(self._down, self._list.down_action)
        names.refused.connect(self._notifier.error)
        self._list.chosen.connect(self._on_chosen)
        self._list.delete_requested.connect(self._on_delete_requested)
        self._list.duplicate_requested.connect(self._on_duplicate_requested)
        self._list.move_requested.connect(self._on_move_requested)
        self._new.clicked.connect(self._on_new_clicked)
        self._add.clicked.connect(self._on_add_clicked)
        self._remove.clicked.connect(self._on_remove_clicked)
        self._step_up.clicked.connect(self._on_step_up_clicked)
        self._step_down.clicked.connect(self._on_step_down_clicked)
        self._steps.selectionModel().currentChanged.connect(self._allow)
        self.table.shown.connect(self._on_table_shown)
        self._list.choose(Motion(GAITS[0].name, built_in=True))  # something that can be played
        self._allow()

    @property
    def current(self) -> Motion | None:
        """What is chosen."""
        return self._list.current

    @property
    def played(self) -> Sequence | Gait | None:
        """What is chosen, as it can be played."""
        return played_of(self._library, self._list.current)

    def choose(self, motion: Motion) -> None:
        """Choose a sequence or gait."""
        self._list.choose(motion)

    def show_pose(self, name: str) -> None:
        """Say which pose a new step takes."""
        self._next_pose = name
        self._allow()

    @Slot()
    def _allow(self) -> None:
        editable, row = self.table.editable, self._steps.row
        last = self.table.rowCount() - 1
        pose = self._pose_for_step()
        self._add.setEnabled(editable and bool(pose) and can_be_named(pose))
        self._add.setToolTip(self._about_adding(pose))
        self._remove.setEnabled(editable and row >= 0)
        self._step_up.setEnabled(editable and row > 0)
        self._step_down.setEnabled(editable and 0 <= row < last)

    def _about_adding(self, pose: str) -> str:
        if not self.table.editable:
            return self.tr("Choose a sequence; gaits that are built in cannot be changed")
        if not pose:
            return self.tr("There is no pose that a step could go to")
        if not can_be_named(pose):
            text = self.tr("A step cannot name “{0}”: give the pose a name without comma and bar")
            return text.format(pose)
        return self.tr("Add a step to “{0}” after the one that is chosen").format(pose)

    def _pose_for_step(self) -> str:
        poses = self._library.poses
        if self._library.pose(self._next_pose) is not None:
            return self._next_pose
        return poses[0].name if poses else ""

    @Slot()
    def _on_chosen(self) -> None:
        self.table.show_motion(self._list.current)

    @Slot()
    def _on_table_shown(self) -> None:
        self._allow()
        self.shown.emit()

    @Slot()
    def _on_new_clicked(self) -> None:
        name = self._library.add_sequence()
        self._list.choose(Motion(name))
        self._list.setFocus()
        self._list.edit(self._list.currentIndex())

    @Slot(object)
    def _on_delete_requested(self, key: Motion) -> None:
        row = self._list.currentIndex().row()
        self._library.delete_sequence(key.name)
        self._list.choose_row(row)  # so that the next one can be deleted, too

    @Slot(object)
    def _on_duplicate_requested(self, key: Motion) -> None:
        played = played_of(self._library, key)
        if isinstance(played, Gait):
            name = self._library.add_gait(played)
        else:
            name = self._library.duplicate_sequence(key.name)
        self._list.choose(Motion(name))

    @Slot(object, int)
    def _on_move_requested(self, key: Motion, row: int) -> None:
        self._library.move_sequence(key.name, row)
        self._list.choose(key)

    @Slot()
    def _on_add_clicked(self) -> None:
        take_typed()
        row, steps = self._steps.row, self.table.steps
        after = row if row >= 0 else len(steps) - 1
        time = steps[after].milliseconds if steps else USUAL_MS
        self.table.add(after + 1, SequenceStep(self._pose_for_step(), time))
        self._steps.choose(after + 1)
        self._allow()

    @Slot()
    def _on_remove_clicked(self) -> None:
        self._steps.remove()
        self._allow()

    @Slot()
    def _on_step_up_clicked(self) -> None:
        self._steps.shift(-1)

    @Slot()
    def _on_step_down_clicked(self) -> None:
        self._steps.shift(1)
