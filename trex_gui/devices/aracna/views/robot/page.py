"""Robot page: drawing, table of joints, and controls for all joints."""

from collections.abc import Callable, Sequence

from PySide6.QtCore import QSignalBlocker, QTimer, Slot
from PySide6.QtGui import QFocusEvent, QResizeEvent
from PySide6.QtWidgets import QPushButton, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.aracna.model.robot import FIRST_SPEED, Robot
from trex_gui.devices.aracna.model.texts import (
    assumed_text,
    drawing_text,
    missed_goals_text,
    speed_text,
    stuck_text,
)
from trex_gui.devices.aracna.poses.gaits import STAND
from trex_gui.devices.aracna.protocol.joints import CENTER
from trex_gui.devices.aracna.views.robot.drawing import RobotCard
from trex_gui.devices.aracna.views.robot.joint_table import JointTable, SpeedBox
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.theme.theme import set_look
from trex_gui.ui.translations import error_text
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import commit_typed
from trex_gui.ui.widgets.labels import PAGE_MARGINS, PageHead


class RobotPage(QWidget):
    def __init__(
        self,
        robot: Robot,
        create_start: Callable[[QWidget], QWidget],
        parent: QWidget | None = None,
    ) -> None:
        """`create_start`: creates the start panel, which is visible without a connection."""
        super().__init__(parent)
        self.setObjectName("aracnaRobotPage")
        self._robot = robot
        self._is_set_up_offline = False
        self._content = QWidget(self)
        self._head = PageHead("", self._content)
        self._head.title.setObjectName("aracnaTitle")
        joints = ui.Card(parent=self._content)
        set_look(joints, "compact")  # so that the table fits on a low screen
        table = JointTable(robot, joints)
        self.controls = Controls(robot, table, joints)
        ui.column((table, 1), self.controls, into=joints, spacing=4)
        remark = f"{drawing_text()}\n* {assumed_text()}"
        self._drawn = RobotCard(robot, remark, joints, self._content)
        drawing = self._drawn.drawing
        cards = ui.row((self._drawn, 2), (joints, 7), spacing=16)
        ui.column(self._head, (cards, 1), into=self._content, margins=0, spacing=8)
        self._start = create_start(self)
        ui.column(self._start, self._content, into=self, margins=PAGE_MARGINS)

        drawing.pointed.connect(table.mark)
        table.pointed.connect(drawing.mark)
        drawing.joint_clicked.connect(table.focus)
        robot.changed.connect(self._on_changed)
        self._on_changed()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._drawn.show_in(self.contentsRect().width())

    def set_up_offline(self) -> None:
        """Show goals and limits until the next connection."""
        self._is_set_up_offline = True
        self._on_changed()

    @Slot()
    def _on_changed(self) -> None:
        is_connected = self._robot.link is not ConnectionState.DISCONNECTED
        self._is_set_up_offline &= not is_connected
        shows_joints = is_connected or self._is_set_up_offline
        self._start.setVisible(not shows_joints)
        self._content.setVisible(shows_joints)
        title, more, alarming = self._report_text()
        self._head.sign.show_sign("warning" if alarming else "", "warning")
        self._head.show_title(title)
        self._head.show_state(more)

    def _report_text(self) -> tuple[str, str, bool]:
        state = self._robot.state
        if self._robot.link not in {ConnectionState.CONNECTED, ConnectionState.NOT_RESPONDING}:
            return tr("No robot is connected."), tr("Goals and limits can already be set."), False
        if state.stuck is not None:
            return *_parts(stuck_text(state.stuck.motor)), True
        faults = [missed_goals_text(state)] if state.missed_goals else []
        if state.speed_error is not None:
            faults.append(error_text(state.speed_error))
        if faults:
            return *_parts(" ".join(faults)), True
        unknown = tr("The positions of the motors are unknown.")
        if state.uncertain:
            more = tr(
                "The last motion may still be running; the next move will report the positions."
            )
            return unknown, more, True
        if all(position is None for position in state.present):
            return unknown, self._before_first_move_text(), False
        if state.moved is not None:
            return tr("Every motor has reached its goal within a few units."), "", False
        return *_parts(self._robot.status), False

    def _before_first_move_text(self) -> str:
        text = tr("This robot reports positions only in its reply to a move.")
        if self._robot.has_user_speeds:
            return text
        more = tr("The first move runs at speed {0} ({1}) unless you set other speeds.")
        return f"{text} {more.format(FIRST_SPEED, speed_text(FIRST_SPEED))}"


def _parts(text: str) -> tuple[str, str]:
    first, dot, more = text.partition(". ")
    return f"{first}{dot}".rstrip(), more


class CommonSpeedBox(SpeedBox):
    """Speed of all motors, or a remark that the speeds differ."""

    _DIFFER = -1

    def __init__(self, name: str, accessible: str, parent: QWidget | None = None) -> None:
        super().__init__(name, accessible, parent)
        self.setMinimumWidth(self.sizeHint().width())  # also while the speeds differ

    @property
    def differ(self) -> bool:
        return self.value() == self._DIFFER

    def show_speeds(self, speeds: Sequence[int]) -> None:
        """Show the speeds without emitting a signal. Unchanged speeds do not replace typed text."""
        value = speeds[0] if len(set(speeds)) == 1 else self._DIFFER
        lowest = min(value, 0)
        if (value, lowest) == (self.value(), self.minimum()):
            return
        with QSignalBlocker(self):
            self.setMinimum(lowest)
            self.setSpecialValueText(tr("differ") if value == self._DIFFER else "")
            self.setValue(value)
        self.update_suffix()

    def stepBy(self, steps: int) -> None:
        if not self.differ:
            super().stepBy(steps)
        elif steps > 0:
            self.setValue(steps * self.singleStep())

    def focusInEvent(self, event: QFocusEvent) -> None:
        """Select the remark that the speeds differ, even after a click."""
        super().focusInEvent(event)
        if self.differ:
            QTimer.singleShot(0, self, self.selectAll)


class Controls(QWidget):
    def __init__(self, robot: Robot, table: JointTable, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._robot = robot
        self._table = table

        self._present = self._button(
            "Present", tr("Pre&sent"), tr("Present positions"), self._on_present_clicked
        )
        self._centre = self._button(
            "Centre",
            tr("Ce&ntre"),
            tr("512 = 150°; nothing moves yet"),
            lambda: self._aim_at((CENTER,) * robot.state.motors),
        )
        self._stand = self._button(
            "Stand",
            tr("S&tand"),
            tr("Inner 512, outer 550; nothing moves yet"),
            lambda: self._aim_at(STAND.for_motors(robot.state.motors)),
        )
        self._speed = CommonSpeedBox("aracnaSpeedAll", tr("Speed of all motors"), self)
        self._move = self._button("Move", tr("Mo&ve"), "", self.move_now)
        ui.set_bold(self._move)
        set_look(self._move, "primary")
        set_icon(self._move, "run", "primary_text")
        self._move.setMinimumWidth(8 * self.fontMetrics().averageCharWidth() + 60)
        self._live = ui.check_box(
            self,
            "aracnaLiveBox",
            tr("Send while dra&gging"),
            tip=tr("The newest goal is sent as soon as the robot has reached the previous goal"),
        )
        self._factory = self._button(
            "FactoryLimits",
            tr("Reset li&mits"),
            tr("Inner 50–600, outer 0–550: tuned on the robot by its authors"),
            robot.limits.reset,
        )
        limits = ui.check_box(
            self,
            "aracnaLimitsBox",
            tr("&Limits instead of speeds"),
            tip=tr(
                "Range of each joint. Goals outside this range are clamped before they are sent."
            ),
            on_toggle=self._on_limits_toggled,
        )
        speed_label = ui.label(self, "", tr("Speed &of all:"), buddy=self._speed)
        ui.column(
            ui.row(
                ui.label(self, "", tr("Set sliders to:")),
                self._present,
                self._centre,
                self._stand,
                ui.row(speed_label, self._speed, margins=(16, 0, 0, 0)),
                1,
            ),
            ui.row(self._move, self._live, 1, self._factory, limits),
            into=self,
            margins=0,
        )

        table.goal_edited.connect(self._on_goal_edited)
        table.grabbed.connect(self._on_grabbed)
        table.released.connect(robot.end_drag)
        self._speed.valueChanged.connect(self._on_speed_changed)
        robot.changed.connect(self._on_changed)
        robot.limits.changed.connect(self._on_changed)
        self._on_limits_toggled(shown=False)
        self._on_changed()

    @Slot()
    def move_now(self) -> None:
        commit_typed()
        self._robot.move(self._robot.targets.goals)

    @property
    def _is_live(self) -> bool:
        return self._live.isChecked() and not self._robot.move_blocker

    @Slot()
    def _on_grabbed(self) -> None:
        if self._is_live:
            self._robot.start_drag()

    @Slot()
    def _on_goal_edited(self) -> None:
        """Send the goals in live mode. An edit by key or spin box counts as a drag."""
        robot = self._robot
        if self._is_live and robot.dragging:
            robot.drag(robot.targets.goals)
        elif self._is_live and not self._table.is_held:
            robot.start_drag()
            robot.drag(robot.targets.goals)
            robot.end_drag()

    @Slot()
    def _on_present_clicked(self) -> None:
        commit_typed()
        self._robot.aim_at_present()

    def _aim_at(self, goals: Sequence[int]) -> None:
        commit_typed()
        self._robot.targets.set_all(goals)

    def _button(self, name: str, text: str, tip: str, slot: ui.Handler) -> QPushButton:
        return ui.button(self, f"aracna{name}Button", text, tip=tip, on_click=slot)

    @Slot(bool)
    def _on_limits_toggled(self, shown: bool) -> None:
        self._factory.setVisible(shown)
        self._table.show_limits(shown=shown)

    @Slot(int)
    def _on_speed_changed(self, speed: int) -> None:
        self._robot.set_speeds((speed,) * self._robot.state.motors)

    @Slot()
    def _on_changed(self) -> None:
        robot = self._robot
        blocker = robot.move_blocker
        self._move.setEnabled(not blocker)
        tip = tr("Move every motor to its goal, within its limits (Ctrl+M)")
        self._move.setToolTip(ui.plain(blocker or tip))
        is_idle = robot.state.play is None
        is_known = any(value is not None for value in robot.state.present)
        self._present.setEnabled(is_idle and is_known)
        for button in (self._centre, self._stand):
            button.setEnabled(is_idle)
        self._factory.setEnabled(not robot.limits.are_factory)
        if robot.link is ConnectionState.DISCONNECTED:
            self._live.setChecked(False)  # must be selected again for each robot
        self._speed.show_speeds(robot.speeds)
