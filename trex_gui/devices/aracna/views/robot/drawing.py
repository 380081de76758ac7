"""Sketch of the robot from above: solid lines for reported positions, dashed lines for goals.

No publication describes how a servo's angle turns a leg, so the sketch does not use kinematics.
All angles are drawn flat, reduced so that legs do not overlap, and mirrored so that equal angles
look alike on both sides.
"""

import math
from dataclasses import dataclass

from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal, Slot
from PySide6.QtGui import QMouseEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.devices.aracna.model.robot_state import RobotState
from trex_gui.devices.aracna.protocol.joints import MOTORS, degrees
from trex_gui.ui.theme.theme import CARD_PADDING, follow_theme, theme
from trex_gui.ui.widgets.builders import Card, column, label
from trex_gui.ui.widgets.circuit import paint_chassis, write
from trex_gui.ui.widgets.painted import Painted, Painter

_CENTER = 150.0  # degrees
_REDUCTION = 0.35  # drawn angle divided by the servo's angle
_BODY = 0.24  # half the edge length of the body; both axes of the picture span -1 to 1
_HIP = 0.26  # distance of each hip from the centre, along both axes
_UPPER, _LOWER = 0.33, 0.34  # lengths of the two parts of a leg
_LEG = 0.08  # width of a leg
_RADIUS = 0.075  # of a joint
_REACH = 0.13  # maximum distance at which the mouse points at a joint
_MAX_WIDTH = 130  # maximum width of the widget next to the drawing, in average characters

Point = tuple[float, float]


@dataclass(frozen=True, slots=True)
class DrawnLeg:
    """Joints and foot of a leg: x to the right and y down, -1 to 1."""

    inner: Point
    outer: Point
    foot: Point


def drawn_legs(positions: tuple[float, ...]) -> tuple[DrawnLeg, ...]:
    """Return the legs in motor order. A leg needs the positions (units) of two motors."""
    return tuple(
        _drawn_leg(motor // 2, positions[motor], positions[motor + 1])
        for motor in range(0, min(len(positions), MOTORS) - 1, 2)
    )


def _drawn_leg(number: int, inner: float, outer: float) -> DrawnLeg:
    outward = 135.0 - 90 * number  # degrees anticlockwise from the right, with the front up
    mirror = 1 if number % 2 else -1
    hip = _along((0.0, 0.0), outward, _HIP * math.sqrt(2))
    first = outward + mirror * _REDUCTION * (degrees(inner) - _CENTER)
    knee = _along(hip, first, _UPPER)
    second = first + mirror * _REDUCTION * (degrees(outer) - _CENTER)
    return DrawnLeg(hip, knee, _along(knee, second, _LOWER))


def _along(start: Point, angle: float, length: float) -> Point:
    turn = math.radians(angle)
    return start[0] + length * math.cos(turn), start[1] - length * math.sin(turn)


class RobotDrawing(Painted):
    pointed = Signal(int)  # motor of the joint below the mouse, or -1
    joint_clicked = Signal(int)  # motor

    def __init__(self, state: RobotState, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("aracnaDrawing")
        self.setAccessibleName(tr("The robot from above"))
        self.setAccessibleDescription(
            tr("Legs at their reported positions, goals dashed; the table shows both as numbers.")
        )
        self._state = state
        self._goals: tuple[int, ...] = ()
        self._marked = -1
        self.setMouseTracking(True)
        self.pointed.connect(self.mark)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)

    def show_robot(self, state: RobotState, goals: tuple[int, ...]) -> None:
        self._state, self._goals = state, goals
        self.update()

    def sizeHint(self) -> QSize:
        return QSize(330, 330)

    def minimumSizeHint(self) -> QSize:
        return QSize(170, 170)

    @Slot(int)
    def mark(self, motor: int) -> None:
        """Highlight a motor's joint, or no joint (-1)."""
        if motor != self._marked:
            self._marked = motor
            self.update()

    def joint_place(self, motor: int) -> QPointF:
        """Return a joint's position in pixels."""
        leg = self._present_legs()[motor // 2]
        return self._to_pixels(leg.outer if motor % 2 else leg.inner)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        motor = self._joint_at(event.position())
        hand = Qt.CursorShape.PointingHandCursor
        self.setCursor(Qt.CursorShape.ArrowCursor if motor < 0 else hand)
        self.pointed.emit(motor)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        motor = self._joint_at(event.position())
        if motor >= 0:
            self.joint_clicked.emit(motor)

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self.pointed.emit(-1)

    def _joint_at(self, point: QPointF) -> int:
        """Return the motor of the joint at a point, or -1."""
        nearest, limit = -1, _REACH * self._scale()
        for motor in range(2 * len(self._present_legs())):
            offset = point - self.joint_place(motor)
            distance = math.hypot(offset.x(), offset.y())
            if distance < limit:
                nearest, limit = motor, distance
        return nearest

    def _present_legs(self) -> tuple[DrawnLeg, ...]:
        """Return the legs at their reported positions. Goals replace unknown positions."""
        pairs = zip(self._state.present, self._goals, strict=False)
        return drawn_legs(tuple(goal if present is None else present for present, goal in pairs))

    def _scale(self) -> float:
        return min(self.width(), self.height()) / 2.06  # the axes span 2, and lines have a width

    def _to_pixels(self, point: Point) -> QPointF:
        scale = self._scale()
        x, y = point
        return QPointF(self.width() / 2 + x * scale, self.height() / 2 + y * scale)

    def paintEvent(self, _event: QPaintEvent) -> None:
        with Painter(self) as painter:
            solid = self._present_legs()
            body = QRectF(self._to_pixels((-_BODY, -_BODY)), self._to_pixels((_BODY, _BODY)))
            paint_chassis(painter, body)
            front = tr("front") + "*"
            write(painter, body, front, "muted", align=Qt.AlignmentFlag.AlignHCenter)
            for index, leg in enumerate(solid):
                is_known = None not in self._state.present[2 * index : 2 * index + 2]
                self._paint_leg(painter, leg, "outline", dashed=not is_known)
            for goal, leg in zip(drawn_legs(self._goals), solid, strict=False):
                if _differ(goal, leg):
                    self._paint_leg(painter, goal, "accent", dashed=True)
            for motor in range(2 * len(solid)):
                self._paint_joint(painter, motor)

    def _paint_leg(self, painter: QPainter, leg: DrawnLeg, color: str, *, dashed: bool) -> None:
        points = [self._to_pixels(point) for point in (leg.inner, leg.outer, leg.foot)]
        style = Qt.PenStyle.DashLine if dashed else Qt.PenStyle.SolidLine
        wide, join = _LEG * self._scale(), Qt.PenJoinStyle.RoundJoin
        pens = [(color, 2.0)] if dashed else [(color, wide), ("track", wide - 4)]
        for name, width in pens:  # edge, then fill
            cap = Qt.PenCapStyle.RoundCap
            painter.setPen(QPen(theme().color(name), max(width, 1.0), style, cap, join))
            painter.drawPolyline(points)

    def _paint_joint(self, painter: QPainter, motor: int) -> None:
        state = self._state
        centre, radius = self.joint_place(motor), max(_RADIUS * self._scale(), 10.0)
        marked = motor == self._marked
        is_bad = (
            motor in state.missed_goals
            or (state.stuck is not None and state.stuck.motor == motor)
            or (state.held_speed(motor) or 0) < 0
        )
        is_awaited = state.moving is not None and state.awaited_motor == motor
        edge = "danger" if is_bad else "accent" if is_awaited or marked else "outline"
        painter.setPen(QPen(theme().color(edge), 4 if is_bad or is_awaited else 2))
        painter.setBrush(theme().color("selected" if marked else "base"))
        painter.drawEllipse(centre, radius, radius)
        painter.setPen(theme().color("window_text"))
        box = QRectF(centre.x() - radius, centre.y() - radius, 2 * radius, 2 * radius)
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, f"{motor}!" if is_bad else str(motor))


class RobotCard(Card):
    """Card with the drawing of a robot and a remark. `beside`: the widget next to the card."""

    def __init__(self, robot: Robot, remark: str, beside: QWidget, parent: QWidget) -> None:
        super().__init__(parent=parent)
        self._beside = beside
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self.drawing = RobotDrawing(robot.state, self)
        self._robot = robot
        caption = label(self, "aracnaCaption", remark, wrap=True, size="caption")
        column((self.drawing, 1), caption, into=self)
        follow_theme(beside, "width", self._limit_width)
        robot.changed.connect(self._on_changed)
        robot.targets.changed.connect(self._on_changed)
        self._on_changed()

    @Slot()
    def _on_changed(self) -> None:
        self.drawing.show_robot(self._robot.state, self._robot.targets.goals)

    def _limit_width(self) -> None:
        limit = _MAX_WIDTH * self.fontMetrics().averageCharWidth()
        self._beside.setMaximumWidth(max(limit, self._beside.minimumSizeHint().width()))

    def show_in(self, width: int) -> None:
        """Show the card if it and the widget next to it fit into `width` pixels."""
        needed = self.drawing.minimumSizeHint().width() + 3 * CARD_PADDING
        self.setVisible(width >= self._beside.minimumSizeHint().width() + needed)


def _differ(leg: DrawnLeg, other: DrawnLeg) -> bool:
    pairs = zip((*leg.outer, *leg.foot), (*other.outer, *other.foot), strict=True)
    return any(abs(a - b) > 0.01 for a, b in pairs)
