"""The poses: a list, the positions of the current one, and what can be done with it."""

from PySide6.QtCore import QSignalBlocker, Qt, Signal, Slot
from PySide6.QtWidgets import QGroupBox, QSpinBox, QWidget

from trex_gui.core.errors import BadRequest
from trex_gui.devices.aracna.model.library import ItemKind, Library
from trex_gui.devices.aracna.model.pose_models import NameModel
from trex_gui.devices.aracna.poses.playing import Present
from trex_gui.devices.aracna.poses.project import Pose
from trex_gui.devices.aracna.protocol.joints import Limits
from trex_gui.devices.aracna.protocol.units import HIGHEST, MOTORS, degrees
from trex_gui.devices.aracna.views.poses.name_list import NameList, small_button
from trex_gui.devices.aracna.views.typed import take_typed
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.widgets import builders

_ACROSS = 4


class PoseBox(QGroupBox):
    """Edits the poses of a library.

    Signals:
        go_to_requested: positions, a tuple; not cropped.
        pose_chosen: the name of the current pose; empty for none.
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
        self._can_move = False
        self._why_not = ""

        model = NameModel(library, ItemKind.POSE, notifier, self)
        empty = self.tr("No poses. Capture the robot's position, or open a pose file.")
        self._list = builders.named(
            NameList(model, empty, self), "aracnaPoses", accessible=self.tr("Poses")
        )
        self._capture = builders.button(
            self, "aracnaCapture", self.tr("&Capture"), on_click=self.capture
        )
        self._go_to = builders.button(
            self, "aracnaGoTo", self.tr("&Go to"), on_click=self._on_go_to_clicked
        )
        self._take = small_button(
            self,
            "aracnaTakePosition",
            tip=self.tr("Set this pose to the robot's position"),
            icon="edited",
            on_click=self._on_take_clicked,
        )
        self._fields = PositionFields(self)
        builders.column(
            (self._list, 1),
            builders.row(self._take, *self._list.buttons(self), 1),
            self._fields,
            builders.row(self._capture, self._go_to),
            into=self,
            margins=(8, 6, 8, 8),
            spacing=4,
        )

        self._list.chosen.connect(self._on_chosen)
        self._fields.positions_changed.connect(self._on_positions_changed)
        library.changed.connect(self._on_chosen)
        self._on_chosen()

    @property
    def current(self) -> Pose | None:
        key = self._list.current
        return self._library.project.pose(key.name) if key is not None else None

    def show_present(self, present: Present) -> None:
        self._present = tuple(present)
        self._update_buttons()

    def show_link(self, can_move: bool, why_not: str) -> None:
        self._can_move, self._why_not = can_move, why_not
        self._update_buttons()

    def show_limits(self, limits: tuple[Limits, ...]) -> None:
        self._fields.show_limits(limits)

    def _update_buttons(self) -> None:
        is_known = bool(self._present) and None not in self._present
        is_chosen = self.current is not None
        self._capture.setEnabled(is_known)
        self._capture.setToolTip(
            self.tr("Save the robot's position as a new pose.")
            if is_known
            else self.tr("The robot's position is known after its first move.")
        )
        self._take.setEnabled(is_known and is_chosen)
        self._go_to.setEnabled(self._can_move and is_chosen)
        go_to = self.tr("Move every motor to this pose, within its limits.")
        self._go_to.setToolTip(go_to if self._can_move else self._why_not)

    @Slot()
    def _on_chosen(self) -> None:
        pose = self.current
        self._fields.show_positions(pose.positions if pose is not None else ())
        self.pose_chosen.emit(pose.name if pose is not None else "")
        self._update_buttons()

    @Slot()
    def capture(self) -> None:
        take_typed()
        try:
            name = self._library.capture(self._present)
        except BadRequest as error:
            self._notifier.error.emit(self.tr("Not captured: {0}.").format(error))
            return
        self._list.choose_and_edit(name)

    @Slot()
    def _on_go_to_clicked(self) -> None:
        take_typed()
        if self.current is not None:
            self.go_to_requested.emit(self.current.positions)

    @Slot()
    def _on_take_clicked(self) -> None:
        if (pose := self.current) is not None:
            known = tuple(position for position in self._present if position is not None)
            self._library.set_positions(pose.name, known + pose.positions[len(known) :])

    @Slot(object, int)
    def _on_positions_changed(self, positions: tuple[int, ...], motor: int) -> None:
        if (pose := self.current) is not None:
            self._library.set_positions(pose.name, positions, run=("field", pose.name, motor))


class PositionFields(QWidget):
    """A field for each motor's position, 0-1023.

    Signals:
        positions_changed: all positions, a tuple; and the motor that the user has changed.
    """

    positions_changed = Signal(object, int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("aracnaPositions")
        self._limits: tuple[Limits, ...] = ()
        self._positions: tuple[int, ...] = ()
        self._boxes = [self._box(motor) for motor in range(MOTORS)]

        columns = [(2 * column + 1, 1) for column in range(_ACROSS)]
        grid = builders.grid(self, margins=0, spacing=(3, 3), stretch=columns)
        for motor, box in enumerate(self._boxes):
            name = builders.label(self, "", str(motor), buddy=box)
            name.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
            line, column = divmod(motor, _ACROSS)
            grid.addWidget(name, line, 2 * column)
            grid.addWidget(box, line, 2 * column + 1)
        self.show_positions(())

    def _box(self, motor: int) -> QSpinBox:
        accessible = self.tr("Position of motor {0} in this pose").format(motor)
        box = builders.spin_box(self, f"aracnaPosition{motor}", accessible, 0, HIGHEST)
        box.setButtonSymbols(QSpinBox.ButtonSymbols.NoButtons)  # it is narrow
        box.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        box.valueChanged.connect(lambda value: self._on_value_changed(motor, value))
        return box

    def show_positions(self, positions: tuple[int, ...]) -> None:
        """Show the positions of a pose; without any the fields are disabled."""
        self._positions = positions
        self.setEnabled(bool(positions))
        for motor, box in enumerate(self._boxes):
            box.setEnabled(motor < len(positions))
            if motor >= len(positions):
                box.clear()
            elif box.value() != positions[motor] or not box.text():
                with QSignalBlocker(box):
                    box.setValue(positions[motor])
        self._update_tool_tips()

    def show_limits(self, limits: tuple[Limits, ...]) -> None:
        self._limits = limits
        self._update_tool_tips()

    def _update_tool_tips(self) -> None:
        for motor, box in enumerate(self._boxes):
            texts = [self.tr("Motor {0}: {1:.0f}°").format(motor, degrees(box.value()))]
            if motor < len(self._limits):
                limits = self._limits[motor]
                texts.append(self.tr("limits {0} to {1}").format(limits.low, limits.high))
                if not limits.allow(box.value()):
                    texts.append(self.tr("sent as {0}").format(limits.crop(box.value())))
            box.setToolTip(", ".join(texts))

    def _on_value_changed(self, motor: int, value: int) -> None:
        self._positions = (*self._positions[:motor], value, *self._positions[motor + 1 :])
        self._update_tool_tips()
        self.positions_changed.emit(self._positions, motor)
