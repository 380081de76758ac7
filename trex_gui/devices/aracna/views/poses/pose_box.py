"""List of poses, with the positions of the current pose and buttons for it."""

from PySide6.QtCore import QSignalBlocker, Qt, Signal, Slot
from PySide6.QtWidgets import QSpinBox, QWidget

from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.devices.aracna.model.library import ItemKind, Library
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.poses.playing import motor_count_warning
from trex_gui.devices.aracna.poses.project import Pose
from trex_gui.devices.aracna.protocol.joints import HIGHEST, MOTORS, degrees
from trex_gui.devices.aracna.views.poses.name_list import NameList, small_button
from trex_gui.ui.theme.theme import set_look
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import commit_typed

_COLUMNS = 4


class PoseBox(ui.Card):
    pose_selected = Signal(str)  # name of the current pose, or empty

    def __init__(self, robot: Robot, library: Library, parent: QWidget | None = None) -> None:
        super().__init__(title_of(tr("Pos&es")), parent)
        self.setObjectName("aracnaPoseBox")
        set_look(self, "compact")
        self._robot = robot
        self._library = library

        placeholder = tr("No poses. Capture the robot's position, or open a pose file.")
        self._list = ui.named(
            NameList(library, ItemKind.POSE, robot.notifier, placeholder, self),
            "aracnaPoses",
            accessible=title_of(tr("Pos&es")),
        )
        self._set_to_present = small_button(
            self,
            "aracnaSetPosition",
            tr("Set this pose to the robot's position"),
            icon="edited",
            on_click=self._on_set_to_present_clicked,
        )
        buttons = self._list.buttons(self)
        self._fields = [self._field(motor) for motor in range(MOTORS)]
        self._capture = ui.button(self, "aracnaCapture", tr("Capt&ure"), on_click=self.capture)
        self._go_to = ui.button(self, "aracnaGoTo", tr("&Go to"), on_click=self._on_go_to_clicked)
        columns = [(2 * column + 1, 1) for column in range(_COLUMNS)]
        fields = ui.grid(margins=0, spacing=(3, 3), stretch=columns)
        for motor, field in enumerate(self._fields):
            name = ui.label(self, "", str(motor), buddy=field)
            name.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
            line, column = divmod(motor, _COLUMNS)
            fields.addWidget(name, line, 2 * column)
            fields.addWidget(field, line, 2 * column + 1)
        ui.column(
            (self._list, 1),
            ui.row(self._set_to_present, *buttons, 1),
            fields,
            ui.row(self._capture, self._go_to),
            into=self,
            spacing=4,
        )

        self._list.current_changed.connect(self._show_pose)
        library.changed.connect(self._show_pose)
        robot.changed.connect(self._update_buttons)
        robot.limits.changed.connect(self._update_tool_tips)
        self._show_pose()

    def _field(self, motor: int) -> QSpinBox:
        accessible = tr("Position of motor {0} in this pose").format(motor)
        box = ui.spin_box(self, f"aracnaPosition{motor}", accessible, 0, HIGHEST)
        ui.strip_style(box, str(HIGHEST))
        box.valueChanged.connect(lambda value: self._on_position_edited(motor, value))
        return box

    @property
    def _pose(self) -> Pose | None:
        return self._library.project.pose(self.current_name)

    @property
    def current_name(self) -> str:
        key = self._list.current
        return "" if key is None else key.name

    @Slot()
    def _show_pose(self) -> None:
        pose = self._pose
        positions = pose.positions if pose is not None else ()
        for motor, box in enumerate(self._fields):
            box.setEnabled(motor < len(positions))
            if motor >= len(positions):
                box.clear()
            elif box.value() != positions[motor] or not box.text():
                with QSignalBlocker(box):
                    box.setValue(positions[motor])
        self._update_tool_tips()
        self._update_buttons()
        self.pose_selected.emit(self.current_name)

    @Slot()
    def _update_tool_tips(self) -> None:
        for motor, box in enumerate(self._fields):
            limits = self._robot.limits.of(motor)
            value = box.value()
            text = tr("Motor {0}: {1:.0f}°, limits {2} to {3}")
            if not limits.allows(value):
                text = tr("Motor {0}: {1:.0f}°, limits {2} to {3}, sent as {4}")
            angle, sent = degrees(value), limits.clamp(value)
            box.setToolTip(ui.plain(text.format(motor, angle, limits.low, limits.high, sent)))

    @Slot()
    def _update_buttons(self) -> None:
        is_known = None not in self._robot.state.present
        is_selected = self._pose is not None
        self._capture.setEnabled(is_known)
        tip = tr("Save the robot's position as a new pose.") if is_known else _unknown_text()
        self._capture.setToolTip(ui.plain(tip))
        self._set_to_present.setEnabled(is_known and is_selected)
        blocker = self._robot.move_blocker
        self._go_to.setEnabled(is_selected and not blocker)
        poses = [] if self._pose is None else [self._pose]
        tip = motor_count_warning(poses, self._robot.state.motors)
        tip = tip or tr("Move every motor to this pose, within its limits.")
        self._go_to.setToolTip(ui.plain(blocker or tip))

    @Slot()
    def capture(self) -> None:
        commit_typed()
        present = self._robot.state.present
        known = tuple(value for value in present if value is not None)
        if len(known) < len(present):
            self._robot.notifier.error.emit(_unknown_text())
        else:
            self._list.select_and_edit(self._library.add_pose(known))

    @Slot()
    def _on_go_to_clicked(self) -> None:
        commit_typed()
        if (pose := self._pose) is not None:
            self._robot.move(pose.for_motors(self._robot.state.motors))

    @Slot()
    def _on_set_to_present_clicked(self) -> None:
        if (pose := self._pose) is not None:
            known = tuple(value for value in self._robot.state.present if value is not None)
            self._library.set_positions(pose.name, known + pose.positions[len(known) :])

    def _on_position_edited(self, motor: int, value: int) -> None:
        if (pose := self._pose) is not None:
            positions = (*pose.positions[:motor], value, *pose.positions[motor + 1 :])
            self._library.set_positions(pose.name, positions, run=("field", pose.name, motor))


def _unknown_text() -> str:
    return tr("The robot's position is unknown until its first move.")
