"""Table of joints, with one row per motor."""

from PySide6.QtCore import QEvent, QObject, QPointF, QRect, QSignalBlocker, QSize, Qt, Signal, Slot
from PySide6.QtGui import QPainter, QPen, QPolygonF
from PySide6.QtWidgets import QLabel, QSizePolicy, QSpinBox, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.model.texts import (
    difference_text,
    joint_text,
    position_text,
    speed_text,
    spoken_joint,
)
from trex_gui.devices.aracna.protocol.joints import HIGHEST, LEGS, MOTORS, Limits, degrees, position
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.theme.theme import set_text_color, theme
from trex_gui.ui.translations import error_text
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import LiveLabel
from trex_gui.ui.widgets.sliders import PressSlider

_LEG, _NAME, _SLIDER, _UNITS, _DEGREES, _PRESENT, _STATE, _SPEED, _LOW, _HIGH = range(10)
_ALTERNATING = (_SPEED, _LOW, _HIGH)  # either the speeds or the limits are visible

_WEDGE = 7  # height in pixels


class JointSlider(PressSlider):
    """Slider from 0 to 1023. Its handle shows the goal.

    A wedge shows the present position. Outside the limits, the groove is thin and grey.
    """

    space_below = _WEDGE

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(0, HIGHEST, parent)
        self._limits = Limits()
        self._present: int | None = None
        self.setSingleStep(4)
        self.setPageStep(50)

    def spoken_state(self) -> str:
        if self._present is None:
            return tr("Present position unknown")
        return tr("Present position {0}").format(self._present)

    def set_limits(self, limits: Limits) -> None:
        if limits != self._limits:
            self._limits = limits
            self.update()

    def set_present(self, present: int | None) -> None:
        if present != self._present:
            self._present = present
            self.update()

    def sizeHint(self) -> QSize:
        hint = super().sizeHint()
        return QSize(max(hint.width(), 200), hint.height() + _WEDGE)

    def minimumSizeHint(self) -> QSize:
        return QSize(70, self.sizeHint().height())

    def paint_groove(self, painter: QPainter, handle: QRect) -> None:
        middle = handle.center().y()
        left, right = self.x_of(0, handle), self.x_of(HIGHEST, handle)
        painter.setPen(QPen(theme().color("track_edge")))
        painter.setBrush(theme().color("track_off"))
        painter.drawRect(QRect(left, middle - 3, right - left, 7))
        start, end = self.x_of(self._limits.low, handle), self.x_of(self._limits.high, handle)
        painter.setBrush(theme().color("track" if self.isEnabled() else "track_off"))
        painter.setPen(QPen(theme().color("neutral")))
        painter.drawRect(QRect(start, middle - 4, max(end - start, 1), 9))

    def paint_below(self, painter: QPainter, handle: QRect) -> None:
        if self._present is None:
            return
        x, bottom = self.x_of(self._present, handle) + 0.5, float(self.height())
        top = handle.bottom() + 1.0
        wedge = [QPointF(x, top), QPointF(x - 4.5, bottom), QPointF(x + 4.5, bottom)]
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(theme().color("bar"))
        painter.drawPolygon(QPolygonF(wedge))


class SpeedBox(ui.SpinBox):
    def __init__(self, name: str, accessible: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        ui.named(self, name, accessible=accessible)
        self.setLocale(ui.UNGROUPED)
        self.setRange(0, HIGHEST)
        self.setSingleStep(10)
        self.setKeyboardTracking(False)
        self.setToolTip(
            tr(
                "Speed setting 1–1023 in steps of 0.669 °/s; 0 means unlimited, not "
                "“stopped”. Above about 870 (AX-18A) or 530 (AX-12A) a servo gets no faster."
            )
        )
        self.valueChanged.connect(self.update_suffix)
        self.update_suffix()

    @Slot()
    def update_suffix(self) -> None:
        """Show the speed in degrees per second. Call this after a change with blocked signals."""
        self.setSuffix(f" = {speed_text(self.value())}")


class JointRow(QObject):
    def __init__(self, robot: Robot, motor: int, parent: "JointTable") -> None:
        super().__init__(parent)
        self._table = parent
        self._robot = robot
        self._motor = motor
        spoken = spoken_joint(motor)

        def name(text: str) -> str:
            return f"{spoken}: {text}"

        def position_box(kind: str, accessible: str) -> QSpinBox:
            box = ui.spin_box(parent, f"aracna{kind}{motor}", name(accessible), 0, HIGHEST)
            ui.strip_style(box, str(HIGHEST))  # the slider replaces the buttons
            return box

        self.name = ui.label(parent, f"aracnaName{motor}", joint_text(motor))
        self.slider = ui.named(
            JointSlider(parent), f"aracnaSlider{motor}", accessible=name(tr("goal"))
        )
        self._units = position_box("Goal", tr("goal in units"))
        self._degrees = ui.double_spin_box(
            parent,
            f"aracnaDegrees{motor}",
            name(tr("goal in degrees")),
            0,
            degrees(HIGHEST),
            decimals=1,
            suffix="°",
        )
        ui.strip_style(self._degrees, self._degrees.textFromValue(degrees(HIGHEST)) + "°")
        present = name(tr("present position"))
        self._present = LiveLabel(f"aracnaPresent{motor}", present, parent)
        width = self._present.fontMetrics().horizontalAdvance(position_text(HIGHEST))
        self._present.setMinimumWidth(width + 4)
        self._state = LiveLabel(f"aracnaState{motor}", name(tr("state")), parent)
        ui.set_bold(self._state)
        width = self._state.fontMetrics().horizontalAdvance(tr("no reply (−1)"))
        self._state.setMinimumWidth(width + 4)
        self.speed = SpeedBox(f"aracnaSpeed{motor}", name(tr("speed")), parent)
        self.low = position_box("Low", tr("lowest position"))
        self.high = position_box("High", tr("highest position"))
        self.widgets: tuple[QWidget, ...] = (
            *(self.name, self.slider, self._units, self._degrees, self._present, self._state),
            *(self.speed, self.low, self.high),
        )

        self.slider.valueChanged.connect(self._on_goal_edited)
        self._units.valueChanged.connect(self._on_goal_edited)
        self._degrees.valueChanged.connect(lambda angle: self._on_goal_edited(position(angle)))
        self.speed.valueChanged.connect(self._on_speed_edited)
        for box in (self.low, self.high):
            box.valueChanged.connect(self._on_limit_edited)
        for widget in self.widgets:
            widget.installEventFilter(self)
            widget.setAttribute(Qt.WidgetAttribute.WA_Hover)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        match event.type():
            case QEvent.Type.HoverEnter | QEvent.Type.FocusIn:
                self._table.pointed.emit(self._motor)
            case QEvent.Type.HoverLeave:
                self._table.pointed.emit(-1)
        return super().eventFilter(watched, event)

    def show_goal(self) -> None:
        goal = self._robot.targets.goals[self._motor]
        with (
            QSignalBlocker(self.slider),
            QSignalBlocker(self._units),
            QSignalBlocker(self._degrees),
        ):
            self.slider.setValue(goal)
            self._units.setValue(goal)
            if position(self._degrees.value()) != goal:
                self._degrees.setValue(degrees(goal))

    def show_limits(self) -> None:
        limits = self._robot.limits.of(self._motor)
        with QSignalBlocker(self.slider), QSignalBlocker(self.low), QSignalBlocker(self.high):
            self.slider.set_limits(limits)
            self.low.setValue(limits.low)
            self.high.setValue(limits.high)

    def show_state(self) -> None:
        state = self._robot.state
        if self.speed.value() != (speed := self._robot.speeds[self._motor]):
            self.speed.setValue(speed)  # setting an equal value would replace typed text
        held = state.held_speed(self._motor)
        text = (
            ""
            if held is None
            else tr("last speed reported by the servo: {0}").format(speed_text(held))
        )
        self.speed.setAccessibleDescription(text)
        for widget in (self.slider, self._units, self._degrees):
            widget.setEnabled(state.play is None)
        present = state.present[self._motor]
        self.slider.set_present(present)
        self._present.setText(position_text(present))
        is_observed = self._robot.link is ConnectionState.CONNECTED
        text, alarming = difference_text(state, self._motor, is_observed=is_observed)
        missed = state.missed_goals.get(self._motor)
        self._state.setText(text)
        self._state.setToolTip(ui.plain("" if missed is None else error_text(missed)))
        ui.set_bold(self._state, alarming)
        set_text_color(self._state, "danger" if alarming else "")

    def _on_goal_edited(self, goal: int) -> None:
        self._robot.targets.set(self._motor, goal)
        self.show_goal()
        self._table.goal_edited.emit()

    def _on_speed_edited(self, speed: int) -> None:
        speeds = list(self._robot.speeds)
        if speeds[self._motor] != speed:
            speeds[self._motor] = speed
            self._robot.set_speeds(speeds)

    def _on_limit_edited(self) -> None:
        """Set the limits. If the edited limit crosses the other limit, both become equal."""
        before = self._robot.limits.of(self._motor)
        low, high = self.low.value(), self.high.value()
        if low > high:
            low, high = (low, low) if low != before.low else (high, high)
        self._robot.limits.set(self._motor, low, high)
        self.show_limits()


class JointTable(QWidget):
    goal_edited = Signal()  # the user has edited a goal
    grabbed = Signal()  # a slider was pressed
    released = Signal()
    pointed = Signal(int)  # motor below the mouse or with the focus, or -1

    def __init__(self, robot: Robot, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("aracnaJoints")
        self._robot = robot
        self._rows: list[JointRow] = []
        self._legs: list[QLabel] = []
        self._limits_shown = False

        self._grid = ui.grid(self, margins=0, spacing=(4, 3), stretch=[(_SLIDER, 1)])
        self._headers = {
            column: self._add_header(column, text, tip)
            for column, text, tip in (
                (_LEG, tr("Leg*"), tr("The order of the legs is assumed")),
                (_NAME, tr("Motor"), ""),
                (
                    _SLIDER,
                    tr("Goal"),
                    tr("Handle: the goal. Wedge below: the last reported position."),
                ),
                (_PRESENT, tr("Present"), tr("Last reported position")),
                (_STATE, tr("Difference"), tr("Present position minus goal")),
                (_SPEED, tr("Speed"), tr("Setting and degrees per second")),
                (_LOW, tr("From"), ""),
                (_HIGH, tr("To"), ""),
            )
        }

        self.pointed.connect(self.mark)
        robot.targets.changed.connect(self._on_targets_changed)
        robot.limits.changed.connect(self._on_limits_changed)
        robot.changed.connect(self._on_changed)
        self.show_limits(shown=False)
        self._on_limits_changed()
        self._on_changed()

    @property
    def is_held(self) -> bool:
        return any(row.slider.held for row in self._rows)

    def show_limits(self, *, shown: bool) -> None:
        self._limits_shown = shown
        for column, header in self._headers.items():
            header.setVisible(column not in _ALTERNATING or shown is (column != _SPEED))
        self._show_rows(self._robot.state.motors)

    @Slot(int)
    def mark(self, motor: int) -> None:
        for number, row in enumerate(self._rows):
            set_text_color(row.name, "accent" if number == motor else "")

    def focus(self, motor: int) -> None:
        if motor < len(self._rows):
            self._rows[motor].slider.setFocus(Qt.FocusReason.MouseFocusReason)

    def _add_header(self, column: int, text: str, tip: str) -> QLabel:
        label = ui.label(self, "", text, tip=tip)
        label.setForegroundRole(label.palette().ColorRole.PlaceholderText)
        label.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Maximum)
        self._grid.addWidget(label, 0, column)
        return label

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
        row = JointRow(self._robot, motor, self)
        line = 1 + motor + motor // 2  # leaves a gap between legs
        if motor < MOTORS and motor % 2 == 0:
            text = tr(LEGS[motor // 2]).replace(" ", "\n")
            label = ui.label(self, f"aracnaLeg{motor // 2}", text)
            label.setAlignment(Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft)
            self._grid.addWidget(label, line, _LEG, 2, 1)
            self._legs.append(label)
            if motor:
                self._grid.setRowMinimumHeight(line - 1, 3)
        for column, widget in enumerate(row.widgets, start=_NAME):
            self._grid.addWidget(widget, line, column)
        row.slider.grabbed.connect(self.grabbed)
        row.slider.released.connect(self.released)
        self._robot.halted.connect(row.slider.release)
        self._rows.append(row)

    @Slot()
    def _on_targets_changed(self) -> None:
        for row in self._rows[: len(self._robot.targets.goals)]:
            if not row.slider.held:
                row.show_goal()

    @Slot()
    def _on_limits_changed(self) -> None:
        for row in self._rows:
            row.show_limits()
        self._on_targets_changed()

    @Slot()
    def _on_changed(self) -> None:
        motors = self._robot.state.motors
        if sum(row.slider.isVisibleTo(self) for row in self._rows) != motors:
            self._show_rows(motors)
            self._on_limits_changed()
        for row in self._rows[:motors]:
            row.show_state()
