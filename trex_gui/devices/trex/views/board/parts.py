"""Parts of the board drawing. Each part is a button."""

import math
from collections.abc import Callable

from PySide6.QtCore import QPointF, QRect, QRectF, Qt
from PySide6.QtGui import QAccessible, QColor, QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QAbstractButton, QWidget

from trex_gui.devices.trex.protocol.calibration import FULL_SCALE, Calibration
from trex_gui.devices.trex.views.bars import paint_input
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.accessible import Spoken
from trex_gui.ui.widgets.builders import plain
from trex_gui.ui.widgets.circuit import (
    jumper_size,
    paint_block,
    paint_jumper,
    text_width,
    write,
    write_lines,
)
from trex_gui.ui.widgets.leds import is_lit, paint_lamp
from trex_gui.ui.widgets.painted import Painter, never_mirror

PLUG_GAP = 10  # pixels between the socket and a pulled plug
_SPOKES = 5
WHEEL = 3.9  # diameter, in lines of text
_TURNS = 0.8  # turns per second at full speed (symbolic: the board measures no speed)


class BoardPart(QAbstractButton, Spoken):
    """Button with its name in bold above its state."""

    spoken_role = QAccessible.Role.Button
    spoken_from = 0  # index of the first line that is spoken
    background = ""  # theme colour, or empty for a transparent background

    def __init__(
        self,
        name: str,
        accessible: str,
        open_page: Callable[[], object],
        parent: QWidget,
        color: str = "outline",
    ) -> None:
        """Create the part. A click calls `open_page`. `color` is the name of a theme colour."""
        super().__init__(parent)
        self.color = color
        never_mirror(self)
        self.setObjectName(f"boardPart{name}")
        self.setAccessibleName(accessible)
        self.setToolTip(plain(accessible))
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setCursor(Qt.CursorShape.PointingHandCursor)
        self.lines: tuple[str, ...] = ()
        self._painted = QRect()  # area of the current paint event
        self.alarm = ""  # theme colour of the last line if that line is an alarm
        self.clicked.connect(open_page)
        theme().changed.connect(self.update)

    def show_lines(self, *lines: str, alarm: str = "") -> None:
        if (lines, alarm) != (self.lines, self.alarm):
            self.lines, self.alarm = lines, alarm
            self.update(self._lines_rect())

    def _lines_rect(self) -> QRect:
        return self.rect()

    def spoken_state(self) -> str:
        return ", ".join(filter(None, self.lines[self.spoken_from :]))

    def paintEvent(self, event: QPaintEvent) -> None:
        self._painted = event.rect()
        # Set the attribute in every paint event, because styles clear it for buttons.
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent, bool(self.background))
        with Painter(self) as painter:
            if self.background:
                painter.fillRect(self.rect(), theme().color(self.background))
            if self.underMouse() and self.isEnabled():
                painter.setPen(Qt.PenStyle.NoPen)
                painter.setBrush(theme().color("selected"))
                painter.drawRoundedRect(self.rect(), 6, 6)
            self.paint(painter)

    def paint(self, painter: QPainter) -> None:
        raise NotImplementedError

    def write_beside(self, painter: QPainter, left: float) -> None:
        """Write the lines to the right of `left` if that area needs to be painted."""
        if self._painted.right() > left:
            area = QRectF(left, 0, self.width() - left, self.height())
            write_lines(painter, area, self.lines, alarm=self.alarm)


class ChannelPart(BoardPart):
    spoken_from = 2
    background = "base"
    _axis = (0, 1)
    _count: int | None = None
    _calibration: Calibration | None = None

    @property
    def bar_y(self) -> int:
        """Vertical position of the centre of the bar, in pixels."""
        return round(1.7 * self.fontMetrics().height())

    def show_input(
        self, axis: tuple[int, int], count: int | None, calibration: Calibration | None
    ) -> None:
        """Show a raw count on an axis. `None` means no signal or an unknown value."""
        if (axis, count, calibration) != (self._axis, self._count, self._calibration):
            self._axis, self._count, self._calibration = axis, count, calibration
            self.update()

    def paint(self, painter: QPainter) -> None:
        area = QRectF(self.rect()).adjusted(4, 2, -4, -2)
        line = QRectF(area.left(), area.top(), area.width(), self.fontMetrics().height())
        title, role, value = (*self.lines, "", "", "")[:3]
        left, right = (text_width(self.font(), f"{text} ") + 4 for text in (title, value))
        write(painter, line, title, "window_text", bold=True)
        write(painter, line.adjusted(left, 0, -right, 0), role, "muted")
        write(painter, line, value, "window_text", bold=True, align=Qt.AlignmentFlag.AlignRight)
        bar_height = 0.6 * line.height()
        track = QRectF(area.left(), self.bar_y - bar_height / 2, area.width(), bar_height)
        paint_input(painter, track, self._axis, self._count, self._calibration)


class LedPart(BoardPart):
    spoken_from = 1
    background = "board"
    pattern = ""  # argument of `is_lit`, or empty while the pattern is unknown
    _is_lit = False

    @property
    def is_blinking(self) -> bool:
        return self.pattern not in {"", "on", "off"}

    def show_moment(self, seconds: float) -> None:
        lit = is_lit(self.pattern, seconds)
        if lit != self._is_lit:
            self._is_lit = lit
            self.update(0, 0, self.fontMetrics().height() + 12, self.height())

    def paint(self, painter: QPainter) -> None:
        radius = self.fontMetrics().height() / 2
        middle, color = QPointF(radius + 6, self.height() / 2), self.color if self._is_lit else ""
        paint_lamp(painter, middle, radius, color, is_known=bool(self.pattern))
        self.write_beside(painter, 2 * radius + 14)


class JumperPart(BoardPart):
    """Two pins with or without a jumper. A jumper in an unknown state is dashed."""

    background = "board"
    is_on: bool | None = None

    def show_jumper(self, is_on: bool | None, *lines: str) -> None:
        self.is_on = is_on
        self.show_lines(*lines)

    def paint(self, painter: QPainter) -> None:
        line = self.fontMetrics().height()
        width, height = jumper_size(max(0.7 * line, min(1.3 * line, self.width() / 12)))
        paint_jumper(painter, QRectF(4, (self.height() - height) / 2, width, height), self.is_on)
        self.write_beside(painter, width + 14)


class MotorPart(BoardPart):
    spoken_from = 1
    speed = 0  # -127 to 127
    _angle = 0.0

    def show_speed(self, speed: int) -> None:
        if speed != self.speed:
            self.speed = speed
            self._update_wheel()

    def turn(self, seconds: float) -> None:
        if self.speed:
            self._angle += 360 * _TURNS * self.speed / FULL_SCALE * seconds
            self._update_wheel()

    def _update_wheel(self) -> None:
        self.update(0, 0, self._wheel().toRect().right() + 12, self.height())

    def _wheel(self) -> QRectF:
        line = self.fontMetrics().height()
        preferred = min(max(WHEEL * line, 0.6 * self.height()), 7 * line, 0.38 * self.width())
        side = min(self.height() - 22.0, preferred)
        return QRectF(10, (self.height() - side) / 2, side, side)

    def paint(self, painter: QPainter) -> None:
        wheel = self._wheel()
        color = theme().color(self.color if self.speed else "outline")
        painter.setPen(QPen(color, 4))
        painter.setBrush(theme().color("track"))
        painter.drawEllipse(wheel)
        painter.setPen(QPen(color, 2))
        radius = wheel.width() / 2
        for spoke in range(_SPOKES):
            angle = math.radians(self._angle + 360 * spoke / _SPOKES)
            reach = QPointF(math.sin(angle), -math.cos(angle)) * (radius - 3)
            painter.drawLine(wheel.center(), wheel.center() + reach)
        painter.setBrush(color)
        painter.drawEllipse(wheel.center(), radius / 5, radius / 5)
        if self.speed:
            self._paint_arrow(painter, wheel, color)
        self.write_beside(painter, wheel.right() + 14)

    def _paint_arrow(self, painter: QPainter, wheel: QRectF, color: QColor) -> None:
        """Paint an arrow in the direction of rotation. Clockwise is forward."""
        around = wheel.adjusted(-7, -7, 7, 7)
        painter.setPen(QPen(color, 2.5))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawArc(around, 45 * 16, 100 * 16)
        side = 1 if self.speed > 0 else -1
        angle = math.radians(45 if side > 0 else 145)
        tip = around.center() + QPointF(math.cos(angle), -math.sin(angle)) * around.width() / 2
        along = QPointF(math.sin(angle), math.cos(angle)) * side * 7
        across = QPointF(along.y(), -along.x()) * 0.7
        painter.setBrush(color)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.drawPolygon(QPolygonF([tip + along, tip - across, tip + across]))


class SerialPart(BoardPart):
    PINS = ("SI", "SO", "GND")
    body_width = 0  # width of the board, in pixels

    def _lines_rect(self) -> QRect:
        return self.rect().adjusted(0, int(self._box().bottom()), 0, 0)

    def _box(self) -> QRectF:
        height = self.fontMetrics().height()
        pin = text_width(self.font(), *self.PINS) + height
        return QRectF((self.body_width - 3 * pin) / 2, 1, 3 * pin, 1.7 * height)

    def paint(self, painter: QPainter) -> None:
        height, box = self.fontMetrics().height(), self._box()
        paint_block(painter, box, self.PINS)
        x = box.center().x()
        painter.setPen(QPen(theme().color(self.color), 4))
        painter.drawLine(QPointF(x, box.bottom() + 2), QPointF(x, self.height()))
        beside = QRectF(x + 12, box.bottom() + 2, self.width() - x - 12, height + 4)
        write(painter, beside, self.lines[0] if self.lines else "", self.alarm or "muted")


class PlugPart(BoardPart):
    """Wire with a plug. A pulled plug is drawn beside its socket."""

    is_out = False
    is_labelled = False  # True if the name and the state are written above the wire

    def show_plug(self, *lines: str, out: bool) -> None:
        self.is_out = out
        self.show_lines(*lines, alarm="danger" if out else "")

    @property
    def wire_y(self) -> float:
        return self.height() - 0.7 * self.fontMetrics().height()

    def paint(self, painter: QPainter) -> None:
        y, end = self.wire_y, self.width() - (PLUG_GAP if self.is_out else 2)
        plug = QRectF(end - 12, y - 6, 12, 12)
        painter.setPen(QPen(theme().color("board_edge"), 3))
        painter.drawLine(QPointF(4, y), QPointF(plug.left(), y))
        painter.setPen(QPen(theme().color("outline"), 1.5))
        painter.setBrush(theme().color("base" if self.is_out else "mark"))
        painter.drawRoundedRect(plug, 3, 3)
        if self.is_labelled and self.lines:
            line = QRectF(2, 0, self.width() - 30, self.fontMetrics().height() + 2)
            write(painter, line, self.lines[0], "window_text", bold=True)
            right = Qt.AlignmentFlag.AlignRight
            write(painter, line, self.lines[1], self.alarm or "muted", align=right)
