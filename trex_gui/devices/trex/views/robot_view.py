"""Drawing of the robot from above, with clickable wheels."""

from functools import partial

from PySide6.QtCore import QLineF, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QPainter, QPaintEvent, QPen, QResizeEvent
from PySide6.QtWidgets import QPushButton, QWidget

from trex_gui.core.translation import tr, tr_noop
from trex_gui.devices.trex.model.setup.wiring import Movement, Side
from trex_gui.ui.theme.theme import follow_theme, theme
from trex_gui.ui.widgets.builders import named
from trex_gui.ui.widgets.circuit import paint_chassis, write
from trex_gui.ui.widgets.painted import Animation, Painted, Painter, never_mirror

_TREADS, _TREADS_PER_SECOND = 7, 6.0  # number per wheel; rate at full speed (assumed)
_SIZE = 392.0, 300.0  # size of the drawing, in the units of the rectangles below
_WHEEL, _CHASSIS = QRectF(0, 30, 60, 240), QRectF(86, 0, 220, 300)
_LEFT_PARTS = {True: QRectF(7, 50, 46, 86), False: QRectF(7, 164, 46, 86)}  # True: forward half
MOVEMENTS = {  # in Tab order
    Movement.LEFT_FORWARD: tr_noop("Left wheel, forward"),
    Movement.RIGHT_FORWARD: tr_noop("Right wheel, forward"),
    Movement.LEFT_BACKWARD: tr_noop("Left wheel, backward"),
    Movement.RIGHT_BACKWARD: tr_noop("Right wheel, backward"),
    Movement.NOTHING: tr_noop("Nothing"),
}


class WheelPart(QPushButton):
    """Button for half of a wheel, filled while checked."""

    def __init__(self, movement: Movement, parent: QWidget) -> None:
        super().__init__(parent)
        self._forward = movement.forward
        never_mirror(self)
        name, text = f"{movement.side}Wheel", tr(MOVEMENTS[movement])
        name += "Forward" if movement.forward else "Backward"
        named(self, name, accessible=text, tip=text)
        self.setCheckable(True)
        self.setAutoDefault(False)
        self.setCursor(Qt.CursorShape.PointingHandCursor)

    def paintEvent(self, _event: QPaintEvent) -> None:
        ink, fill = "mark", "selected" if self.underMouse() else "base"
        if not self.isEnabled():
            ink, fill = "outline", "base"
        elif self.isChecked():
            ink, fill = "primary_text", "primary"
        box = QRectF(self.rect()).adjusted(1, 1, -1, -1)
        with Painter(self) as painter:
            painter.setPen(QPen(theme().color("outline"), 1))
            painter.setBrush(theme().color(fill))
            painter.drawRoundedRect(box, 6, 6)
            _paint_arrow(painter, box, 0.6 if self._forward else -0.6, ink)


class RobotView(Painted):
    """Robot with turning wheels. If `with_buttons` is true, each wheel consists of two buttons."""

    wheel_clicked = Signal(object)  # `Movement`

    def __init__(self, parent: QWidget | None = None, *, with_buttons: bool = False) -> None:
        super().__init__(parent)
        self.setAccessibleName(tr("The robot from above"))
        self._speeds = dict.fromkeys(Side, 0.0)
        self._colors = dict.fromkeys(Side, "outline")
        self._shifts = dict.fromkeys(Side, 0.0)  # shift of the treads, in tread spacings
        self._motion = Animation(self, self._on_frame)
        movements = [movement for movement in MOVEMENTS if movement.side] if with_buttons else []
        self._parts = {movement: WheelPart(movement, self) for movement in movements}
        for movement, part in self._parts.items():
            part.clicked.connect(partial(self._on_part_clicked, movement))
        follow_theme(self, "space", self.updateGeometry)

    def show_wheel(self, side: Side, speed: float, color: str = "outline") -> None:
        """Show a wheel that turns. `speed` is from -1 to 1."""
        if (speed, color) != (self._speeds[side], self._colors[side]):
            self._speeds[side], self._colors[side] = speed, color
            self.update()

    def select(self, movement: Movement | None) -> None:
        """Check the button of a movement. `None` clears the selection."""
        for key, part in self._parts.items():
            part.setChecked(key is movement)
        self.update()

    def _on_part_clicked(self, movement: Movement) -> None:
        self.select(movement)
        self.wheel_clicked.emit(movement)

    def spoken_state(self) -> str:
        moving = {(side, speed > 0) for side, speed in self._speeds.items() if speed}
        return ", ".join(
            tr(text) for key, text in MOVEMENTS.items() if (key.side, key.forward) in moving
        )

    def sizeHint(self) -> QSize:
        line = self.fontMetrics().height()
        return QSize(26 * line, 20 * line)

    def minimumSizeHint(self) -> QSize:
        return self.sizeHint() / 2

    def robot_area(self) -> QRectF:
        scale = min(self.width() / _SIZE[0], self.height() / _SIZE[1])
        area = QRectF(0, 0, _SIZE[0] * scale, _SIZE[1] * scale).adjusted(2, 2, -2, -2)
        area.moveCenter(QRectF(self.rect()).center())
        return area

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        area = self.robot_area()
        for movement, part in self._parts.items():
            part.setGeometry(_scaled(_LEFT_PARTS[movement.forward], area, movement.side).toRect())

    def paintEvent(self, _event: QPaintEvent) -> None:
        with Painter(self) as painter:
            area = self.robot_area()
            self.paint_robot(painter, area)
            word = _scaled(_CHASSIS, area).adjusted(0, area.height() / 12, 0, 0)
            word.setHeight(self.fontMetrics().height())
            write(painter, word, tr("front"), "muted", align=Qt.AlignmentFlag.AlignHCenter)

    def paint_robot(self, painter: QPainter, area: QRectF) -> None:
        """Paint the chassis and the wheels. Run the animation while a wheel turns."""
        paint_chassis(painter, _scaled(_CHASSIS, area))
        for side in self._speeds:
            self._paint_wheel(painter, side, _scaled(_WHEEL, area, side))
        self._motion.run(any(self._speeds.values()))

    def _paint_wheel(self, painter: QPainter, side: Side, wheel: QRectF) -> None:
        parts = (part for movement, part in self._parts.items() if movement.side is side)
        is_selected = any(part.isChecked() for part in parts)
        name, radius = self._colors[side], wheel.width() * 0.22
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(theme().color("selected" if is_selected else "track"))
        painter.drawRoundedRect(wheel, radius, radius)
        if speed := self._speeds[side]:
            painter.setPen(QPen(theme().color("hatch"), 1.5))
            for tread in range(_TREADS):
                y = wheel.top() + wheel.height() * (tread + self._shifts[side] % 1) / _TREADS
                if wheel.top() + radius < y < wheel.bottom() - radius:
                    for left in (wheel.left(), wheel.right() - radius):
                        painter.drawLine(QLineF(left, y, left + radius, y))
            if not self._parts:
                _paint_arrow(painter, wheel, speed, name)
        edge = "accent" if is_selected and name == "outline" else name
        painter.setPen(QPen(theme().color(edge), 2 if edge == "outline" else 3))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRoundedRect(wheel, radius, radius)

    def _on_frame(self, seconds: float) -> None:
        for side, speed in self._speeds.items():
            self._shifts[side] -= _TREADS_PER_SECOND * speed * seconds
        self.update()


def _scaled(part: QRectF, area: QRectF, side: Side | None = Side.LEFT) -> QRectF:
    """Scale a part of the drawing to `area`. Mirror the part for the right side."""
    unit = area.height() / _SIZE[1]
    left = _SIZE[0] - part.right() if side is Side.RIGHT else part.left()
    corner = QPointF(area.center().x() + (left - _SIZE[0] / 2) * unit, area.top())
    return QRectF(corner + QPointF(0, part.top() * unit), part.size() * unit)


def _paint_arrow(painter: QPainter, box: QRectF, speed: float, color: str) -> None:
    """Paint an arrow with a length proportional to `speed`. A negative speed points down."""
    up = 1 if speed > 0 else -1
    head = min(box.width() * 0.3, box.height() * 0.2)
    length = max(box.height() * 0.85 * min(abs(speed), 1), 2 * head) / 2
    middle, cap = box.center(), Qt.PenCapStyle.RoundCap
    tip = middle - QPointF(0, up * length)
    painter.setPen(QPen(theme().color(color), max(head / 2.5, 2), Qt.PenStyle.SolidLine, cap))
    painter.drawLine(middle + QPointF(0, up * length), tip)
    for side in (-head, head):
        painter.drawLine(tip, tip + QPointF(side, up * head))
