"""Pictures to choose from: what drives a robot, and how its motors start and stop."""

from collections.abc import Callable, Mapping
from enum import Enum
from functools import partial
from typing import TypeVar

from PySide6.QtCore import QPoint, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QFont, QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QButtonGroup, QRadioButton, QSizePolicy, QWidget

from trex_gui.devices.trex.model.setup.wiring import Driver
from trex_gui.ui.theme.theme import follow_theme, theme
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.painted import Painted, Painter, never_mirror

ChoiceT = TypeVar("ChoiceT", bound=Enum | None)
Points = tuple[tuple[float, float], ...]
Paint = Callable[[QPainter, QRectF], None]

_AFTER_S, _REVERSAL_S = 4.0, 2.0  # seconds that a curve shows, and its change of direction


class PictureChoice(QRadioButton):
    """A radio button that is a picture with its name, and a caption of two lines."""

    def __init__(self, name: str, text: str, paint: Paint | None, parent: QWidget) -> None:
        super().__init__(text, parent)
        self.setObjectName(name)
        self.setCursor(Qt.CursorShape.PointingHandCursor)
        expanding = QSizePolicy.Policy.Expanding
        self.setSizePolicy(expanding, expanding)
        self.setMaximumHeight(20 * self.fontMetrics().height())
        self.paint = paint
        self._caption = ""
        never_mirror(self)
        follow_theme(self, "room", self.updateGeometry)

    def show_caption(self, text: str) -> None:
        if text != self._caption:
            self._caption = text
            self.setAccessibleDescription(text)
            self.setToolTip(ui.plain(text))
            self.update()

    def hitButton(self, place: QPoint) -> bool:  # noqa: N802 - of Qt
        return self.rect().contains(place)

    def minimumSizeHint(self) -> QSize:
        line, name = self.fontMetrics().height(), self.fontMetrics().horizontalAdvance(self.text())
        return QSize(max(8 * line, round(1.1 * name) + 2 * line), 8 * line)

    def sizeHint(self) -> QSize:
        return QSize(self.minimumSizeHint().width(), 11 * self.fontMetrics().height())

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        line, color = self.fontMetrics().height(), theme().color
        is_marked = self.isChecked() or self.underMouse()
        box = QRectF(self.rect()).adjusted(1, 1, -1, -1)
        texts = box.adjusted(8, box.height() - 3.4 * line, -8, 0)
        with Painter(self) as painter:
            painter.setPen(QPen(color("accent" if self.isChecked() else "outline"), 1.5))
            painter.setBrush(color("selected" if is_marked else "base"))
            painter.drawRoundedRect(box, 8, 8)
            dot = QRectF(box.left() + 8, box.top() + 8, 0.8 * line, 0.8 * line)
            painter.setBrush(color("base"))
            painter.drawEllipse(dot)
            if self.isChecked():
                painter.setPen(Qt.PenStyle.NoPen)
                painter.setBrush(color("accent"))
                painter.drawEllipse(dot.adjusted(*[0.2 * line] * 2, *[-0.2 * line] * 2))
            if self.paint is not None:
                self.paint(painter, box.adjusted(2 * line, line, -2 * line, -3.8 * line))
            font = QFont(self.font())
            font.setWeight(QFont.Weight.DemiBold)
            painter.setFont(font)
            painter.setPen(color("text" if self.isEnabled() else "muted"))
            how = Qt.AlignmentFlag.AlignHCenter | Qt.TextFlag.TextShowMnemonic
            painter.drawText(texts, how, self.text())
            painter.setFont(self.font())
            painter.setPen(color("muted"))
            how = Qt.AlignmentFlag.AlignHCenter | Qt.TextFlag.TextWordWrap
            painter.drawText(texts.adjusted(0, 1.2 * line, 0, 0), how, self._caption)


class Choices(QWidget):
    """Pictures of which one is chosen, in rows of `columns`."""

    chosen = Signal(object)

    def __init__(
        self, name: str, texts: Mapping[ChoiceT, str], parent: QWidget, *, columns: int
    ) -> None:
        super().__init__(parent)
        self.setObjectName(name)
        self.buttons: dict[object, PictureChoice] = {}
        group, grid = QButtonGroup(self), ui.grid(self, margins=0, spacing=(12, 12))
        for number, (choice, text) in enumerate(texts.items()):
            key = "Keep" if choice is None else choice.name.title().replace("_", "")
            paint = partial(_paint_driver, choice) if isinstance(choice, Driver) else None
            button = PictureChoice(f"{name}{key}", text, paint, self)
            button.clicked.connect(partial(self.chosen.emit, choice))
            group.addButton(button)
            grid.addWidget(button, number // columns, number % columns)
            self.buttons[choice] = button

    def show_choice(self, choice: object) -> None:
        self.buttons[choice].setChecked(True)


class CurvePicture(Painted):
    """Shows `paint` alone."""

    paint: Paint | None = None

    def sizeHint(self) -> QSize:
        line = self.fontMetrics().height()
        return QSize(20 * line, 10 * line)

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        with Painter(self) as painter:
            if self.paint is not None:
                self.paint(painter, QRectF(self.rect()).adjusted(8, 8, -8, -8))


def _paint_driver(driver: Driver, painter: QPainter, box: QRectF) -> None:
    """Paint a transmitter with its sticks, or a computer."""
    color = theme().color
    unit = min(box.width() / 16, box.height() / 10)
    painter.save()
    painter.translate(box.center() - QPointF(8, 5) * unit)
    painter.scale(unit, unit)
    pen = QPen(color("mark"), 0.35, c=Qt.PenCapStyle.RoundCap)
    painter.setPen(pen)
    painter.setBrush(color("board"))
    if driver is Driver.COMPUTER:
        painter.drawRoundedRect(QRectF(3, 0.5, 10, 6.5), 0.6, 0.6)
        painter.drawRoundedRect(QRectF(1.5, 7.6, 13, 1.6), 0.6, 0.6)
        painter.drawPolyline([QPointF(4.6, 2.2), QPointF(6, 3.4), QPointF(4.6, 4.6)])
        painter.drawLine(QPointF(6.8, 4.8), QPointF(8.8, 4.8))
    else:
        painter.drawLine(QPointF(13, 2), QPointF(13, -0.5))
        painter.drawRoundedRect(QRectF(0.5, 2, 15, 8), 1.4, 1.4)
        is_one = driver is Driver.ONE_STICK
        painter.setBrush(color("base"))
        for x in (8.0,) if is_one else (4.6, 11.4):
            middle = QPointF(x, 6)
            painter.drawEllipse(middle, 3, 3)
            painter.setPen(QPen(color("accent"), 0.45, c=Qt.PenCapStyle.RoundCap))
            ways = [QPointF(0, -1), QPointF(0, 1), QPointF(-1, 0), QPointF(1, 0)]
            for way in ways[: 4 if is_one else 2]:
                across = QPointF(way.y(), way.x()) * 0.6
                tip = middle + way * 2.3
                painter.drawPolyline([tip - way * 0.7 + across, tip, tip - way * 0.7 - across])
            painter.setBrush(color("accent"))
            painter.drawEllipse(middle, 0.6, 0.6)
            painter.setPen(pen)
            painter.setBrush(color("base"))
    painter.restore()


def paint_ramp(ramp: float, brake: float, painter: QPainter, box: QRectF) -> None:
    """Paint a start, and a change of direction: seconds to full speed, seconds of braking."""
    there = _REVERSAL_S + brake
    end = min(ramp, _REVERSAL_S)  # a slow ramp does not get to full speed
    top = end / ramp if ramp else 1.0
    start: Points = ((0, 0), (end, top), (_REVERSAL_S, top), (_REVERSAL_S, 0))
    points = (*start, (there, 0), (there + ramp, -1), (_AFTER_S + ramp, -1))
    paint_curve(points, painter, box, span=_AFTER_S)


def paint_curve(
    points: Points,
    painter: QPainter,
    box: QRectF,
    *,
    span: float,
    lowest: float = -1,
    mark: float | None = None,
) -> None:
    """Paint a speed, 1 is full, over `span` seconds, and a line where something happens."""

    def place(seconds: float, speed: float) -> QPointF:
        y = box.bottom() - (speed - lowest) / (1 - lowest) * box.height()
        return QPointF(box.left() + seconds / span * box.width(), y)

    color = theme().color
    painter.save()
    painter.setPen(QPen(color("hatch"), 1))
    painter.drawLine(place(0, 0), place(span, 0))
    painter.drawLine(place(0, lowest), place(0, 1))
    if mark is not None:
        painter.setPen(QPen(color("mark"), 1.5, Qt.PenStyle.DashLine))
        painter.drawLine(place(mark, 0), place(mark, 1))
    painter.setClipRect(box.adjusted(-3, -3, 0, 3))
    painter.setPen(QPen(color("accent"), 2.5))
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.drawPolyline(QPolygonF([place(*point) for point in points]))
    painter.restore()
