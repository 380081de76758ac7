"""The robot seen from above: where it is in full lines, where it is to go in dashes."""

from typing import Protocol

from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal, SignalInstance
from PySide6.QtGui import QColor, QMouseEvent, QPainter, QPaintEvent, QPen, QResizeEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from trex_gui.devices.aracna.model.robot_state import RobotState
from trex_gui.devices.aracna.protocol.joints import JOINTS
from trex_gui.devices.aracna.views.robot.geometry import BODY, Leg, legs
from trex_gui.devices.aracna.views.robot.words import position_text, spoken_joint
from trex_gui.ui.theme.theme import theme

_RADIUS = 0.075
_REACH = 0.13
"""How near the mouse has to be to a joint."""


class Wanted(Protocol):
    """Where each joint is wanted."""

    @property
    def changed(self) -> SignalInstance:
        """Told when one of the goals is another."""
        ...

    @property
    def goals(self) -> tuple[int, ...]:
        """All of them in units, motor 0 first."""
        ...


class Posed(Protocol):
    """A robot as far as it is drawn: one that is connected, or one that was recorded."""

    @property
    def changed(self) -> SignalInstance:
        """Told when anything is other than it was, but for what is wanted."""
        ...

    @property
    def known(self) -> RobotState:
        """Everything that it has reported."""
        ...

    @property
    def present(self) -> tuple[int | None, ...]:
        """Where each motor was last reported; `None` where that is not known."""
        ...

    @property
    def motors(self) -> int:
        """How many motors it has."""
        ...

    @property
    def targets(self) -> Wanted:
        """Where each joint is wanted."""
        ...


class RobotDrawing(QWidget):
    """A sketch: it shows which joint is meant and which way it goes, and measures nothing.

    The rows beside it do everything by keyboard; it takes no focus.

    Signals:
        pointed: the motor whose joint the mouse is on; -1 for none.
        chosen: a joint was clicked: its motor.
    """

    pointed = Signal(int)
    chosen = Signal(int)

    def __init__(self, robot: Posed, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("aracnaDrawing")
        self.setAccessibleName(self.tr("The robot from above"))
        self._robot = robot
        self._marked: int | None = None
        self.setMouseTracking(True)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)

        robot.changed.connect(self.update)
        robot.targets.changed.connect(self.update)
        theme().changed.connect(self.update)

    def sizeHint(self) -> QSize:
        return QSize(330, 330)

    def minimumSizeHint(self) -> QSize:
        return QSize(190, 190)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Be no higher than wide: what stands below follows at once."""
        super().resizeEvent(event)
        self.setMaximumHeight(max(self.width(), self.minimumSizeHint().height()))

    def mark(self, motor: int | None) -> None:
        """Let the joint of a motor stand out."""
        if motor != self._marked:
            self._marked = motor
            self.update()

    def joint_place(self, motor: int) -> QPointF:
        """Return where the joint of a motor is drawn, in pixels of this widget."""
        leg = self._solid()[motor // 2]
        return self._place(leg.outer if motor % 2 else leg.inner)

    # --- The mouse ----------------------------------------------------------------------

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        motor = self._joint_at(event.position())
        self.setCursor(
            Qt.CursorShape.ArrowCursor if motor < 0 else Qt.CursorShape.PointingHandCursor
        )
        tip = ""
        if motor >= 0:
            present = position_text(self._robot.present[motor])
            tip = self.tr("{0}: {1}").format(spoken_joint(motor), present)
        self.setToolTip(tip)
        self.pointed.emit(motor)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        motor = self._joint_at(event.position())
        if motor >= 0:
            self.chosen.emit(motor)

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self.pointed.emit(-1)

    def _joint_at(self, point: QPointF) -> int:
        """Return the motor of the joint that a point is on; -1: none."""
        found, nearest = -1, _REACH * self._scale()
        for motor in range(min(self._robot.motors, len(JOINTS))):
            away = point - self.joint_place(motor)
            distance = (away.x() ** 2 + away.y() ** 2) ** 0.5
            if distance < nearest:
                found, nearest = motor, distance
        return found

    # --- Looks --------------------------------------------------------------------------

    def _solid(self) -> tuple[Leg, ...]:
        """Return the legs as reported; of a motor that was never, where it is wanted."""
        pairs = zip(self._robot.present, self._robot.targets.goals, strict=False)
        return legs(tuple(goal if present is None else present for present, goal in pairs))

    def _scale(self) -> float:
        return min(self.width(), self.height()) / 2.06

    def _place(self, point: tuple[float, float]) -> QPointF:
        scale = self._scale()
        return QPointF(self.width() / 2 + point[0] * scale, (1.03 + point[1]) * scale)

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        solid = self._solid()
        self._paint_body(painter)
        for index, leg in enumerate(solid):
            known = None not in self._robot.present[2 * index : 2 * index + 2]
            self._paint_leg(painter, leg, theme().color("neutral"), dashed=not known)
        for wanted, leg in zip(legs(self._robot.targets.goals), solid, strict=False):
            if _is_elsewhere(wanted, leg):
                self._paint_leg(painter, wanted, theme().color("info"), dashed=True, width=0.018)
        for motor in range(2 * len(solid)):
            self._paint_joint(painter, motor)
        painter.end()

    def _paint_body(self, painter: QPainter) -> None:
        scale = self._scale()
        corner = self._place((-BODY, -BODY))
        body = QRectF(corner.x(), corner.y(), 2 * BODY * scale, 2 * BODY * scale)
        painter.setPen(QPen(theme().color("neutral"), max(0.012 * scale, 1)))
        painter.setBrush(theme().color("track_off"))
        painter.drawRoundedRect(body, 0.06 * scale, 0.06 * scale)
        painter.setPen(theme().color("muted"))
        above = QRectF(0, 0, self.width(), 1.4 * painter.fontMetrics().height())
        painter.drawText(above, Qt.AlignmentFlag.AlignCenter, self.tr("▲ front*"))

    def _paint_leg(
        self, painter: QPainter, leg: Leg, color: QColor, *, dashed: bool, width: float = 0.05
    ) -> None:
        pen = QPen(color, max(width * self._scale(), 1.5))
        pen.setCapStyle(Qt.PenCapStyle.RoundCap)
        if dashed:
            pen.setWidthF(max(0.018 * self._scale(), 1.5))
            pen.setStyle(Qt.PenStyle.DashLine)
        painter.setPen(pen)
        places = [self._place(point) for point in (leg.inner, leg.outer, leg.foot)]
        painter.drawPolyline(places)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(color)
        radius = (0.022 if dashed else 0.035) * self._scale()
        painter.drawEllipse(places[2], radius, radius)

    def _paint_joint(self, painter: QPainter, motor: int) -> None:
        known = self._robot.known
        place, radius = self.joint_place(motor), max(_RADIUS * self._scale(), 10.0)
        marked = motor == self._marked
        bad = any(each.motor == motor for each in known.missed)
        bad = bad or (known.stuck is not None and known.stuck.motor == motor)
        bad = bad or (known.held(motor) or 0) < 0
        waited = known.moving is not None and known.waited_for == motor
        edge = "danger" if bad else "info" if waited else "mark"
        painter.setPen(QPen(theme().color(edge), 3.5 if bad or waited else 1.5))
        painter.setBrush(theme().color("highlight" if marked else "track"))
        painter.drawEllipse(place, radius, radius)
        painter.setPen(theme().color("highlighted_text" if marked else "text"))
        box = QRectF(place.x() - radius, place.y() - radius, 2 * radius, 2 * radius)
        text = f"{motor}!" if bad else str(motor)
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, text)


def _is_elsewhere(one: Leg, other: Leg) -> bool:
    """Whether two pictures of a leg differ by more than a hair."""
    pairs = zip((*one.outer, *one.foot), (*other.outer, *other.foot), strict=True)
    return any(abs(a - b) > 0.01 for a, b in pairs)
