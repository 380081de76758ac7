"""The joints in rows, two a leg: what is wanted of each, and how it goes."""

from functools import partial

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtGui import QFontMetrics
from PySide6.QtWidgets import QFrame, QGridLayout, QLabel, QSizePolicy, QWidget

from trex_gui.devices.aracna.model.event_log import missed_text
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.views.robot.joint_row import JointRow, JointState
from trex_gui.devices.aracna.views.robot.words import joint_of, side_text, signed, speed_text
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.theme.theme import theme

_LEG, _NAME, _SLIDER, _UNITS, _DEGREES, _PRESENT, _STATE, _SPEED, _LOW, _HIGH = range(10)
_BY_TURNS = (_SPEED, _LOW, _HIGH)


class JointTable(QWidget):
    """Shows and changes the targets, speeds and limits of a robot.

    Signals:
        wanted: a person wants a motor somewhere: its number; the target is set already.
        grabbed: a hand is on a slider.
        released: it is not any more.
        pointed: the motor that mouse or focus is on; -1 for none.
    """

    wanted = Signal(int)
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

        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setHorizontalSpacing(6)
        self._grid.setVerticalSpacing(3)
        self._grid.setColumnStretch(_SLIDER, 1)
        self._heads = {
            _LEG: self._head(self.tr("Leg*"), self.tr("Which leg is which is assumed")),
            _NAME: self._head(self.tr("Motor")),
            _SLIDER: self._head(
                self.tr("Goal"),
                self.tr("Handle: where to go. Wedge below: where the motor was last reported."),
            ),
            _PRESENT: self._head(self.tr("Present"), self.tr("As the robot reported last")),
            _STATE: self._head(self.tr("Difference"), self.tr("Present position less goal")),
            _SPEED: self._head(self.tr("Speed"), self.tr("Setting and degrees a second")),
            _LOW: self._head(self.tr("From")),
            _HIGH: self._head(self.tr("To")),
        }
        for column, head in self._heads.items():
            self._grid.addWidget(head, 0, column)

        robot.targets.changed.connect(self._on_targets_changed)
        robot.limits.changed.connect(self._on_limits_changed)
        robot.changed.connect(self._on_changed)
        robot.link_changed.connect(self._on_changed)
        robot.halted.connect(self._on_halted)
        theme().changed.connect(self._on_theme_changed)
        self.show_limits(shown=False)
        self._on_limits_changed()
        self._on_changed()

    @property
    def rows(self) -> tuple[JointRow, ...]:
        """One a motor."""
        return tuple(self._rows)

    @property
    def held(self) -> bool:
        """Whether a hand is on a slider."""
        return any(row.slider.held for row in self._rows)

    def show_limits(self, *, shown: bool) -> None:
        """Show the columns of the limits in place of the speeds, or not."""
        self._limits_shown = shown
        for column, head in self._heads.items():
            head.setVisible(column not in _BY_TURNS or shown is (column != _SPEED))
        self._fit(self._robot.motors)

    def mark(self, motor: int | None) -> None:
        """Let the name of a motor stand out."""
        for number, row in enumerate(self._rows):
            row.set_marked(number == motor)

    def focus(self, motor: int) -> None:
        """Put the keyboard on the slider of a motor."""
        if motor < len(self._rows):
            self._rows[motor].slider.setFocus(Qt.FocusReason.MouseFocusReason)

    def _head(self, text: str, tip: str = "") -> QLabel:
        label = QLabel(text, self)
        label.setForegroundRole(label.palette().ColorRole.PlaceholderText)
        label.setToolTip(tip)
        label.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Maximum)
        return label

    # --- As many rows as motors -----------------------------------------------------------

    def _fit(self, motors: int) -> None:
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
            label = QLabel(side_text(joint.side).replace(" ", "\n"), self)
            label.setObjectName(f"aracnaLeg{motor // 2}")
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
        widest = QFontMetrics(font).horizontalAdvance(self.tr("no answer (−1)"))
        row.state.setMinimumWidth(widest + 4)

        row.wanted.connect(partial(self._on_wanted, motor))
        row.grabbed.connect(self.grabbed)
        row.released.connect(self.released)
        row.speed_wanted.connect(partial(self._on_speed_wanted, motor))
        row.limits_wanted.connect(partial(self._on_limits_wanted, motor))
        row.pointed.connect(partial(self._on_pointed, motor))
        self._rows.append(row)

    # --- What a person does -----------------------------------------------------------------

    def _on_wanted(self, motor: int, goal: int) -> None:
        self._robot.targets.set(motor, goal)
        self._rows[motor].show_goal(self._robot.targets.goals[motor])
        self.wanted.emit(motor)

    def _on_speed_wanted(self, motor: int, speed: int) -> None:
        speeds = list(self._robot.speeds.wanted)
        if speeds[motor] != speed:
            speeds[motor] = speed
            self._robot.set_speeds(speeds)

    def _on_limits_wanted(self, motor: int, low: int, high: int) -> None:
        """Take limits; who moves one beyond the other moves both."""
        before = self._robot.limits.of(motor)
        if low > high:
            low, high = (low, low) if low != before.low else (high, high)
        self._robot.limits.set(motor, low, high)
        self._rows[motor].show_limits(self._robot.limits.of(motor))

    def _on_pointed(self, motor: int, is_pointed: bool) -> None:
        self.pointed.emit(motor if is_pointed else -1)

    # --- What has changed -------------------------------------------------------------------

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
        robot = self._robot
        if sum(row.slider.isVisibleTo(self) for row in self._rows) != robot.motors:
            self._fit(robot.motors)
            self._on_limits_changed()
        enabled = robot.playing is None
        for motor, (row, speed) in enumerate(zip(self._rows, robot.speeds.wanted, strict=False)):
            row.show_speed(speed)
            row.show_state(self._state(motor))
            for widget in (row.slider, row.units, row.degrees):
                if widget.isEnabled() != enabled:
                    widget.setEnabled(enabled)
            held = robot.known.held(motor)
            row.speed.setAccessibleDescription(
                "" if held is None else self.tr("the servo holds {0}").format(speed_text(held))
            )

    def _state(self, motor: int) -> JointState:
        known = self._robot.known
        present = known.present[motor]
        missed = next((each for each in known.missed if each.motor == motor), None)
        if known.stuck is not None and known.stuck.motor == motor:
            return JointState(present, self.tr("stuck here"), alarming=True)
        if known.moving is not None:
            if self._robot.link is not ConnectionState.CONNECTED or known.waited_for > motor:
                return JointState(present, self._difference(motor))
            return JointState(present, self.tr("moving …"))
        if missed is not None and missed.unreadable:
            return JointState(None, self.tr("no answer (−1)"), alarming=True)
        if missed is not None:
            words = self.tr("{0} missed").format(self._difference(motor))
            return JointState(present, words, alarming=True, tip=missed_text(missed))
        held = known.held(motor)
        if held is not None and held < 0:
            return JointState(present, self.tr("no answer (−1)"), alarming=True)
        return JointState(present, self._difference(motor))

    def _difference(self, motor: int) -> str:
        present, goals = self._robot.known.present[motor], self._robot.known.goals
        if present is None or goals is None:
            return ""
        return signed(present - goals[motor])

    @Slot()
    def _on_theme_changed(self) -> None:
        for row in self._rows:
            row.renew_colours()
