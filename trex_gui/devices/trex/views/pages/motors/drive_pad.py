"""Pad for driving with the mouse or a finger."""

import math

from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal, Slot
from PySide6.QtGui import (
    QAccessible,
    QEventPoint,
    QFont,
    QFontMetrics,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QTouchEvent,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from trex_gui.core.translation import Number, tr
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.views.robot_view import RobotView
from trex_gui.ui.theme.theme import scaled_font, theme
from trex_gui.ui.widgets.behaviour import PressMonitor
from trex_gui.ui.widgets.circuit import write
from trex_gui.ui.widgets.painted import Painter

_DEAD_ZONE = 0.06  # fraction of the travel around the centre that counts as zero
_KNOB = 13  # minimum radius in pixels
_MARGIN = 4  # pixels around the field
_ROBOT = 0.42  # height of the robot as a fraction of the field


class DrivePad(RobotView):
    """Pad that steers while a mouse button or a finger holds it. `KeyDriver` handles keys."""

    spoken_role = QAccessible.Role.Canvas

    steered = Signal(float, float)  # forward and turn to the right, each -1 to 1
    released = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.held = False
        self._finger = 0
        self._can_turn = True
        self._ceiling = FULL_SCALE
        self._forward = self._turn = 0.0
        self._watch = PressMonitor(self)
        self.setObjectName("drivePad")
        self.setAccessibleName(tr("Drive pad"))
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAttribute(Qt.WidgetAttribute.WA_AcceptTouchEvents)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self._watch.lost.connect(self.release)

    def set_can_turn(self, can_turn: bool) -> None:
        if can_turn != self._can_turn:
            self._can_turn = can_turn
            self.release()
            self.update()

    def set_ceiling(self, ceiling: int) -> None:
        if ceiling != self._ceiling:
            self._ceiling = ceiling
            self.update()

    def show_setpoints(self, left: int, right: int) -> None:
        """Move the knob to the position for these speeds, unless the pad is held."""
        if not self.held:
            full = 2 * max(self._ceiling, abs(left), abs(right))
            self._move_knob((left + right) / full, (left - right) / full)

    @Slot()
    def release(self) -> None:
        if self.held:
            self.held = False
            self._watch.end()
            self._move_knob(0.0, 0.0)
            self.released.emit()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() is Qt.MouseButton.LeftButton:
            self._grab(event.position())
        elif self.held:
            self.release()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if not event.buttons() & Qt.MouseButton.LeftButton:
            self.release()
        self._follow(event.position())

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if event.button() is Qt.MouseButton.LeftButton:
            self.release()

    def event(self, event: QEvent) -> bool:
        return self._on_touch(event) if isinstance(event, QTouchEvent) else super().event(event)

    def _on_touch(self, event: QTouchEvent) -> bool:
        """Steer with the first finger until it lifts. Ignore other fingers."""
        event.accept()
        if event.type() == QEvent.Type.TouchBegin:
            self._finger = event.points()[0].id()
            self._grab(event.points()[0].position())
            return True
        for point in event.points():
            if event.type() != QEvent.Type.TouchUpdate or point.id() != self._finger:
                continue
            match point.state():
                case QEventPoint.State.Released:
                    break
                case QEventPoint.State.Updated:
                    self._follow(point.position())
            return True
        self.release()
        return True

    def _grab(self, position: QPointF) -> None:
        self.setFocus(Qt.FocusReason.MouseFocusReason)
        self.held = True
        self._watch.start()
        self._follow(position)

    def _follow(self, position: QPointF) -> None:
        if self.held:
            self._move_knob(*self._setpoint_at(position))
            self.steered.emit(self._forward, self._turn)

    def _field(self) -> QRectF:
        border = _MARGIN + QFontMetrics(self._small_font()).height()
        side = min(self.width(), self.height()) - 2 * border - 2
        center = QRectF(self.rect()).center()
        return QRectF(center.x() - side / 2, center.y() - side / 2, side, side)

    def robot_area(self) -> QRectF:
        field, area = self._field(), super().robot_area()
        size = area.size() * (field.height() * _ROBOT / max(area.height(), 1))
        return QRectF(field.center() - QPointF(size.width(), size.height()) / 2, size)

    def _small_font(self) -> QFont:
        return scaled_font(self.font(), 0.85)

    def _setpoint_at(self, position: QPointF) -> tuple[float, float]:
        field = self._field()
        half = max(field.width() / 2, 1)
        forward = _limited((field.center().y() - position.y()) / half)
        turn = _limited((position.x() - field.center().x()) / half)
        return forward, turn if self._can_turn else 0.0

    def _move_knob(self, forward: float, turn: float) -> None:
        position = forward, turn if self._can_turn else 0.0
        if position != (self._forward, self._turn):
            self._forward, self._turn = position
            self.update()

    def spoken_state(self) -> str:
        turning = tr("Hold an arrow key to drive while the pad has the focus.")
        straight = tr("Hold Up or Down to drive. The motors cannot be driven separately.")
        position = tr("At rest.")
        if self._forward or self._turn:
            ahead = tr("forward") if self._forward >= 0 else tr("back")
            side = tr("right") if self._turn >= 0 else tr("left")
            position = tr("{0} {1:.0%}, {2} {3:.0%}.").format(
                ahead, Number(abs(self._forward)), side, Number(abs(self._turn))
            )
        parts = [position, turning if self._can_turn else straight]
        if self._ceiling < FULL_SCALE:
            share = 100 * self._ceiling / FULL_SCALE
            parts.append(tr("Full deflection is {0:.0f} % of full speed.").format(share))
        return " ".join(parts)

    def sizeHint(self) -> QSize:
        return QSize(260, 260)

    def minimumSizeHint(self) -> QSize:
        return QSize(170, 170)

    def paintEvent(self, _event: QPaintEvent) -> None:
        field, color, active = self._field(), theme().color, self.isEnabled()
        with Painter(self) as painter:
            focus = self.hasFocus() and active
            painter.setPen(QPen(color("highlight" if focus else "track_edge"), 2 if focus else 1))
            painter.setBrush(color("track" if active else "track_off"))
            painter.drawEllipse(field)
            self.paint_robot(painter, self.robot_area())
            self._paint_words(painter, field)
            if active:
                self._paint_knob(painter, field)

    def _paint_words(self, painter: QPainter, field: QRectF) -> None:
        painter.setFont(self._small_font())
        height = painter.fontMetrics().height()
        below = (field.bottom() + self.robot_area().bottom() - height) / 2
        words = {field.top() - height - 2: tr("forward"), field.bottom() + 2: tr("back")}
        if self._ceiling < FULL_SCALE:
            share = 100 * self._ceiling / FULL_SCALE
            words[below] = tr("ceiling {0:.0f} %").format(share)
        for top, word in words.items():
            box = QRectF(0, top, self.width(), height)
            write(painter, box, word, "muted", align=Qt.AlignmentFlag.AlignHCenter)

    def _paint_knob(self, painter: QPainter, field: QRectF) -> None:
        center, radius = field.center(), max(_KNOB, field.width() / 18)
        deflection = max(1.0, math.hypot(self._turn, self._forward))
        half = field.width() / 2 / deflection
        knob = QPointF(center.x() + self._turn * half, center.y() - self._forward * half)
        accent = theme().color("bar")
        if self._forward or self._turn:
            painter.setPen(QPen(accent, 4, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap))
            painter.drawLine(center, knob)
        painter.setPen(QPen(theme().color("base"), 3))
        painter.setBrush(accent)
        painter.drawEllipse(knob, radius, radius)


def _limited(deflection: float) -> float:
    deflection = max(-1.0, min(1.0, deflection))
    return 0.0 if abs(deflection) < _DEAD_ZONE else deflection
