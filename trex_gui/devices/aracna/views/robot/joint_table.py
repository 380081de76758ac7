"""The joints in rows: goal, present position, difference, speed, limits."""

from dataclasses import dataclass
from functools import partial

from PySide6.QtCore import QEvent, QObject, QSignalBlocker, Qt, Signal, Slot
from PySide6.QtGui import QFontMetrics
from PySide6.QtWidgets import QFrame, QLabel, QSizePolicy, QWidget

from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.model.texts import missed_text
from trex_gui.devices.aracna.protocol.joints import Limits
from trex_gui.devices.aracna.protocol.units import degrees, position
from trex_gui.devices.aracna.views.robot.joint_widgets import (
    DegreesBox,
    JointSlider,
    SpeedBox,
    UnitsBox,
)
from trex_gui.devices.aracna.views.robot.texts import (
    joint_of,
    joint_text,
    position_text,
    side_text,
    signed,
    speed_text,
    spoken_joint,
)
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets import builders

_LEG, _NAME, _SLIDER, _UNITS, _DEGREES, _PRESENT, _STATE, _SPEED, _LOW, _HIGH = range(10)
_ALTERNATING = (_SPEED, _LOW, _HIGH)


@dataclass(frozen=True, slots=True)
class JointState:
    present: int | None
    text: str = ""
    alarming: bool = False
    tip: str = ""


class JointRow(QObject):
    """The widgets of one motor in the table's grid.

    Signals:
        goal_changed: a goal in units.
        speed_changed: a speed setting.
        limits_changed: lowest and highest position.
        pointed: whether the mouse or the focus is on it.
    """

    goal_changed = Signal(int)
    speed_changed = Signal(int)
    limits_changed = Signal(int, int)
    pointed = Signal(bool)

    def __init__(self, motor: int, parent: QWidget) -> None:
        super().__init__(parent)
        spoken = spoken_joint(motor)

        def name(text: str) -> str:
            return f"{spoken}: {text}"

        self.name = builders.label(parent, f"aracnaName{motor}", joint_text(motor))
        self.slider = builders.named(
            JointSlider(parent), f"aracnaSlider{motor}", accessible=name(self.tr("goal"))
        )
        self.units = UnitsBox(f"aracnaGoal{motor}", name(self.tr("goal in units")), parent)
        self.degrees = DegreesBox(f"aracnaDegrees{motor}", name(self.tr("goal in degrees")), parent)
        self.present = builders.label(parent, f"aracnaPresent{motor}")
        self.present.setAccessibleName(name(self.tr("present position")))
        widest = self.present.fontMetrics().horizontalAdvance(position_text(1023))
        self.present.setMinimumWidth(widest + 4)
        self.state = builders.label(parent, f"aracnaState{motor}")
        self.state.setAccessibleName(name(self.tr("state")))
        self.speed = SpeedBox(f"aracnaSpeed{motor}", name(self.tr("speed")), parent)
        self.low = UnitsBox(f"aracnaLow{motor}", name(self.tr("lowest position")), parent)
        self.high = UnitsBox(f"aracnaHigh{motor}", name(self.tr("highest position")), parent)
        self._shown = JointState(None, "?")

        self.slider.valueChanged.connect(self.goal_changed)
        self.units.valueChanged.connect(self.goal_changed)
        self.degrees.valueChanged.connect(lambda angle: self.goal_changed.emit(position(angle)))
        self.speed.valueChanged.connect(self.speed_changed)
        for box in (self.low, self.high):
            box.valueChanged.connect(self._on_limit_changed)
        for widget in self.widgets:
            widget.installEventFilter(self)
            widget.setAttribute(Qt.WidgetAttribute.WA_Hover)
        self.show_state(JointState(None))

    @property
    def widgets(self) -> tuple[QWidget, ...]:
        return (
            *(self.name, self.slider, self.units, self.degrees, self.present, self.state),
            *(self.speed, self.low, self.high),
        )

    def show_goal(self, goal: int) -> None:
        """Show a goal without a signal."""
        with QSignalBlocker(self.units), QSignalBlocker(self.degrees):
            if self.slider.value() != goal:
                with QSignalBlocker(self.slider):
                    self.slider.setValue(goal)
            self.units.setValue(goal)
            if position(self.degrees.value()) != goal:
                self.degrees.setValue(degrees(goal))

    def show_limits(self, limits: Limits) -> None:
        """Show limits without a signal."""
        with QSignalBlocker(self.slider):
            self.slider.set_limits(limits)
        for box, value in ((self.low, limits.low), (self.high, limits.high)):
            with QSignalBlocker(box):
                box.setValue(value)

    def show_state(self, state: JointState) -> None:
        if state == self._shown:
            return
        self._shown = state
        self.slider.set_present(state.present)
        self.present.setText(position_text(state.present))
        self.state.setText(state.text)
        self.state.setToolTip(state.tip)
        builders.set_bold(self.state, state.alarming)
        self.update_colors()

    def update_colors(self) -> None:
        palette = self.name.palette()
        name = "danger" if self._shown.alarming else "window_text"
        palette.setColor(self.state.foregroundRole(), theme().color(name))
        self.state.setPalette(palette)

    def set_marked(self, marked: bool) -> None:
        if marked != self.name.autoFillBackground():
            role = self.name.palette().ColorRole
            self.name.setBackgroundRole(role.Highlight)
            self.name.setForegroundRole(role.HighlightedText if marked else role.WindowText)
            self.name.setAutoFillBackground(marked)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        match event.type():
            case QEvent.Type.HoverEnter | QEvent.Type.FocusIn:
                self.pointed.emit(True)
            case QEvent.Type.HoverLeave:
                self.pointed.emit(False)
            case _:
                pass
        return super().eventFilter(watched, event)

    def _on_limit_changed(self) -> None:
        self.limits_changed.emit(self.low.value(), self.high.value())


class JointTable(QWidget):
    """Shows and changes the targets, speeds and limits of a robot.

    Signals:
        goal_changed: the user has changed a target.
        grabbed, released: the user presses or releases a slider.
        pointed: the motor that mouse or focus is on; -1 for none.
    """

    goal_changed = Signal()
    grabbed = Signal()
    released = Signal()
    pointed = Signal(int)

    def __init__(self, robot: Robot, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("aracnaJoints")
        self._robot = robot
        self._rows: list[JointRow] = []
        self._legs: list[QLabel] = []
        self._limits_shown = False

        self._grid = builders.grid(self, margins=0, spacing=(6, 3), stretch=[(_SLIDER, 1)])
        self._heads = {
            column: self._head(column, text, tip)
            for column, text, tip in (
                (_LEG, self.tr("Leg*"), self.tr("Which leg is which is assumed")),
                (_NAME, self.tr("Motor"), ""),
                (
                    _SLIDER,
                    self.tr("Goal"),
                    self.tr("Handle: the goal. Wedge below: the last reported position."),
                ),
                (_PRESENT, self.tr("Present"), self.tr("Last reported position")),
                (_STATE, self.tr("Difference"), self.tr("Present position minus goal")),
                (_SPEED, self.tr("Speed"), self.tr("Setting and degrees per second")),
                (_LOW, self.tr("From"), ""),
                (_HIGH, self.tr("To"), ""),
            )
        }

        robot.targets.changed.connect(self._on_targets_changed)
        robot.limits.changed.connect(self._on_limits_changed)
        robot.changed.connect(self._on_changed)
        robot.halted.connect(self._on_halted)
        theme().changed.connect(self._on_theme_changed)
        self.show_limits(shown=False)
        self._on_limits_changed()
        self._on_changed()

    @property
    def is_held(self) -> bool:
        return any(row.slider.held for row in self._rows)

    def show_limits(self, *, shown: bool) -> None:
        """Show the limits in place of the speeds, or the speeds."""
        self._limits_shown = shown
        for column, head in self._heads.items():
            head.setVisible(column not in _ALTERNATING or shown is (column != _SPEED))
        self._show_rows(self._robot.state.motors)

    def mark(self, motor: int | None) -> None:
        for number, row in enumerate(self._rows):
            row.set_marked(number == motor)

    def focus(self, motor: int) -> None:
        if motor < len(self._rows):
            self._rows[motor].slider.setFocus(Qt.FocusReason.MouseFocusReason)

    def _head(self, column: int, text: str, tip: str) -> QLabel:
        label = builders.label(self, "", text, tip=tip)
        label.setForegroundRole(label.palette().ColorRole.PlaceholderText)
        label.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Maximum)
        self._grid.addWidget(label, 0, column)
        return label

    # --- Rows -------------------------------------------------------------------------------

    def _show_rows(self, motors: int) -> None:
        while len(self._rows) < motors:
            self._add_row(len(self._rows))
        for motor, row in enumerate(self._rows):
            for widget in row.widgets:
                widget.setVisible(motor < motors)
            row.speed.setVisible(motor < motors and not self._limits_shown)
            for box in (row.low, row.high):
                box.setVisible(motor < motors and self._limits_shown)
        for leg, label in enumerate(self._legs):
            label.setVisible(2 * leg < motors)

    def _add_row(self, motor: int) -> None:
        row = JointRow(motor, self)
        line = 1 + motor + motor // 2  # a gap between legs
        joint = joint_of(motor)
        if joint is not None and motor % 2 == 0:
            text = side_text(joint.side).replace(" ", "\n")
            label = builders.label(self, f"aracnaLeg{motor // 2}", text)
            label.setAlignment(Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft)
            self._grid.addWidget(label, line, _LEG, 2, 1)
            self._legs.append(label)
            if motor:
                gap = QFrame(self)
                gap.setFixedHeight(3)
                self._grid.addWidget(gap, line - 1, _LEG)
        for column, widget in enumerate(row.widgets, start=_NAME):
            self._grid.addWidget(widget, line, column)
        font = self.font()
        font.setBold(True)
        widest = QFontMetrics(font).horizontalAdvance(self.tr("no reply (−1)"))
        row.state.setMinimumWidth(widest + 4)

        row.goal_changed.connect(partial(self._on_goal_changed, motor))
        row.slider.grabbed.connect(self.grabbed)
        row.slider.released.connect(self.released)
        row.speed_changed.connect(partial(self._on_speed_changed, motor))
        row.limits_changed.connect(partial(self._on_row_limits_changed, motor))
        row.pointed.connect(partial(self._on_pointed, motor))
        self._rows.append(row)

    def _on_goal_changed(self, motor: int, goal: int) -> None:
        self._robot.targets.set(motor, goal)
        self._rows[motor].show_goal(self._robot.targets.goals[motor])
        self.goal_changed.emit()

    def _on_speed_changed(self, motor: int, speed: int) -> None:
        speeds = list(self._robot.speeds.values)
        if speeds[motor] != speed:
            speeds[motor] = speed
            self._robot.set_speeds(speeds)

    def _on_row_limits_changed(self, motor: int, low: int, high: int) -> None:
        """Set limits; one that is moved beyond the other takes it along."""
        before = self._robot.limits.of(motor)
        if low > high:
            low, high = (low, low) if low != before.low else (high, high)
        self._robot.limits.set(motor, low, high)
        self._rows[motor].show_limits(self._robot.limits.of(motor))

    def _on_pointed(self, motor: int, is_pointed: bool) -> None:
        self.pointed.emit(motor if is_pointed else -1)

    # --- Updates ----------------------------------------------------------------------------

    @Slot()
    def _on_halted(self) -> None:
        for row in self._rows:
            row.slider.let_go()

    @Slot()
    def _on_targets_changed(self) -> None:
        for row, goal in zip(self._rows, self._robot.targets.goals, strict=False):
            if not row.slider.held:
                row.show_goal(goal)

    @Slot()
    def _on_limits_changed(self) -> None:
        for motor, row in enumerate(self._rows):
            row.show_limits(self._robot.limits.of(motor))
        self._on_targets_changed()

    @Slot()
    def _on_changed(self) -> None:
        state = self._robot.state
        if sum(row.slider.isVisibleTo(self) for row in self._rows) != state.motors:
            self._show_rows(state.motors)
            self._on_limits_changed()
        enabled = state.play is None
        speeds = self._robot.speeds.values
        for motor, (row, speed) in enumerate(zip(self._rows, speeds, strict=False)):
            if row.speed.value() != speed:
                row.speed.setValue(speed)
            row.show_state(self._joint_state(motor))
            for widget in (row.slider, row.units, row.degrees):
                if widget.isEnabled() != enabled:
                    widget.setEnabled(enabled)
            held = state.held_speed(motor)
            row.speed.setAccessibleDescription(
                "" if held is None else self.tr("the servo holds {0}").format(speed_text(held))
            )

    def _joint_state(self, motor: int) -> JointState:
        state = self._robot.state
        present = state.present[motor]
        difference = ""
        if present is not None and state.goals is not None:
            difference = signed(present - state.goals[motor])
        missed = next((each for each in state.missed_goals if each.motor == motor), None)
        if state.stuck is not None and state.stuck.motor == motor:
            return JointState(present, self.tr("stuck here"), alarming=True)
        if state.moving is not None:
            is_observed = self._robot.link is ConnectionState.CONNECTED
            if is_observed and state.awaited_motor <= motor:
                return JointState(present, self.tr("moving …"))
            return JointState(present, difference)
        if missed is not None and not missed.unreadable:
            text = self.tr("{0} missed").format(difference)
            return JointState(present, text, alarming=True, tip=missed_text(missed))
        if missed is not None or (state.held_speed(motor) or 0) < 0:
            return JointState(present, self.tr("no reply (−1)"), alarming=True)
        return JointState(present, difference)

    @Slot()
    def _on_theme_changed(self) -> None:
        for row in self._rows:
            row.update_colors()
