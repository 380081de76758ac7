"""The poses: a list, the positions of the one that is chosen, and what can be done with it."""

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtWidgets import QGroupBox, QHBoxLayout, QPushButton, QVBoxLayout, QWidget

from trex_gui.core.errors import BadRequest
from trex_gui.devices.aracna.model.library import Library
from trex_gui.devices.aracna.model.names import Motion, PoseNames
from trex_gui.devices.aracna.poses.pose import Pose
from trex_gui.devices.aracna.poses.travel import Present
from trex_gui.devices.aracna.protocol.joints import Limits
from trex_gui.devices.aracna.views.poses.name_list import NameList
from trex_gui.devices.aracna.views.poses.parts import arrow_button, follow, tool_button
from trex_gui.devices.aracna.views.poses.position_fields import PositionFields
from trex_gui.devices.aracna.views.typed import take_typed
from trex_gui.ui.notifier import Notifier


class PoseBox(QGroupBox):
    """A part of the panel.

    Signals:
        go_to_requested: the positions of a pose are to be reached, a tuple; not cropped.
        pose_chosen: the name of the pose that is chosen; empty for none.
    """

    go_to_requested = Signal(object)
    pose_chosen = Signal(str)

    def __init__(self, library: Library, notifier: Notifier, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("aracnaPoseBox")
        self.setTitle(self.tr("Poses"))
        self._library = library
        self._notifier = notifier
        self._present: tuple[int | None, ...] = ()
        self._up = False
        self._why_not = self.tr("There is no robot that could move now.")

        names = PoseNames(library, self)
        empty = self.tr("No poses. Capture where the robot is, or open a pose file.")
        self._list = NameList(names, empty, self)
        self._list.setObjectName("aracnaPoses")
        self._list.setAccessibleName(self.tr("Poses"))
        self._capture = QPushButton(self.tr("&Capture"), self)
        self._capture.setObjectName("aracnaCapture")
        self._go_to = QPushButton(self.tr("&Go to"), self)
        self._go_to.setObjectName("aracnaGoTo")
        self._take = tool_button(
            self, "aracnaTakePosition", "", self.tr("Put this pose where the robot is"), "edited"
        )
        self._copy = tool_button(
            self, "aracnaDuplicatePose", "", self.tr("Duplicate this pose"), "copy"
        )
        self._delete = tool_button(
            self, "aracnaDeletePose", "", self.tr("Delete this pose"), "clear"
        )
        self._up_button = arrow_button(
            self, "aracnaPoseUp", self.tr("Move this pose up"), Qt.ArrowType.UpArrow
        )
        self._down_button = arrow_button(
            self, "aracnaPoseDown", self.tr("Move this pose down"), Qt.ArrowType.DownArrow
        )
        self._fields = PositionFields(self)

        main = QHBoxLayout()
        main.addWidget(self._capture)
        main.addWidget(self._go_to)
        small = QHBoxLayout()
        for button in (self._take, self._copy, self._delete, self._up_button, self._down_button):
            small.addWidget(button)
        small.addStretch(1)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(8, 6, 8, 8)
        layout.setSpacing(4)
        layout.addWidget(self._list, 1)
        layout.addLayout(small)
        layout.addWidget(self._fields)
        layout.addLayout(main)

        follow(self._copy, self._list.duplicate_action)
        follow(self._delete, self._list.delete_action)
        follow(self._up_button, self._list.up_action)
        follow(self._down_button, self._list.down_action)
        names.refused.connect(self._notifier.error)
        self._list.chosen.connect(self._on_chosen)
        self._list.delete_requested.connect(self._on_delete_requested)
        self._list.duplicate_requested.connect(self._on_duplicate_requested)
        self._list.move_requested.connect(self._on_move_requested)
        self._capture.clicked.connect(self.capture)
        self._go_to.clicked.connect(self._on_go_to_clicked)
        self._take.clicked.connect(self._on_take_clicked)
        self._fields.positions_changed.connect(self._on_positions_changed)
        library.changed.connect(self._on_chosen)
        self._on_chosen()

    @property
    def current(self) -> Pose | None:
        """The pose that is chosen."""
        key = self._list.current
        return self._library.pose(key.name) if key is not None else None

    def show_present(self, present: Present) -> None:
        """Know where the robot is: what `Capture` takes."""
        self._present = tuple(present)
        self._allow()

    def show_link(self, up: bool, why_not: str) -> None:
        """Whether there is a robot that may be moved now; else why not."""
        self._up, self._why_not = up, why_not
        self._allow()

    def show_limits(self, limits: tuple[Limits, ...]) -> None:
        """Say of each motor how far it may turn."""
        self._fields.show_limits(limits)

    def _allow(self) -> None:
        known = bool(self._present) and None not in self._present
        chosen = self.current is not None
        tip = self.tr("Keep where the robot is as a new pose.")
        if not known:
            tip = self.tr("Where the robot is, is known after its first move.")
        self._capture.setEnabled(known)
        self._capture.setToolTip(tip)
        self._take.setEnabled(known and chosen)
        self._go_to.setEnabled(self._up and chosen)
        self._go_to.setToolTip(
            self.tr("Move every motor to this pose, within its limits.")
            if self._up
            else self._why_not
        )

    @Slot()
    def _on_chosen(self) -> None:
        pose = self.current
        self._fields.show_positions(pose.positions if pose is not None else ())
        self.pose_chosen.emit(pose.name if pose is not None else "")
        self._allow()

    @Slot()
    def capture(self) -> None:
        """Keep where the robot is as a new pose, and let its name be typed."""
        take_typed()
        try:
            name = self._library.capture(self._present)
        except BadRequest as error:
            self._notifier.error.emit(self.tr("Not captured: {0}.").format(error))
            return
        self._list.choose(Motion(name))
        self._list.setFocus()
        self._list.edit(self._list.currentIndex())  # a name is the next thing it needs

    @Slot()
    def _on_go_to_clicked(self) -> None:
        take_typed()
        if self.current is not None:
            self.go_to_requested.emit(self.current.positions)

    @Slot()
    def _on_take_clicked(self) -> None:
        pose = self.current
        if pose is not None:
            known = tuple(place for place in self._present if place is not None)
            self._library.set_positions(pose.name, known + pose.positions[len(known) :])

    @Slot(object, int)
    def _on_positions_changed(self, positions: tuple[int, ...], motor: int) -> None:
        pose = self.current
        if pose is not None:
            self._library.set_positions(pose.name, positions, run=("field", pose.name, motor))

    @Slot(object)
    def _on_delete_requested(self, key: Motion) -> None:
        row = self._list.currentIndex().row()
        self._library.delete_pose(key.name)
        self._list.choose_row(row)  # so that the next one can be deleted, too

    @Slot(object)
    def _on_duplicate_requested(self, key: Motion) -> None:
        self._list.choose(Motion(self._library.duplicate_pose(key.name)))

    @Slot(object, int)
    def _on_move_requested(self, key: Motion, row: int) -> None:
        self._library.move_pose(key.name, row)
        self._list.choose(key)
