"""Picture buttons for the driver and the ramps of a robot."""

from collections.abc import Callable, Mapping
from enum import Enum
from functools import partial
from typing import TypeVar

from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QIcon, QPainter, QPen, QPixmap, QResizeEvent
from PySide6.QtWidgets import QButtonGroup, QSizePolicy, QToolButton, QWidget

from trex_gui.devices.trex.model.setup.wiring import Driver
from trex_gui.ui.theme.theme import follow_theme, set_look, set_text_color, theme
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import Note
from trex_gui.ui.widgets.painted import Painter

ChoiceT = TypeVar("ChoiceT", bound=Enum | None)
Paint = Callable[[QPainter, QRectF], None]

_SPAN_S, _REVERSAL_S = 4.0, 2.0  # seconds: length of the curve, start of the reversal


class _Choice(QToolButton):
    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._paint: Paint | None = None
        self.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextUnderIcon)
        self.setCheckable(True)
        set_look(self, "choice")
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Ignored)
        follow_theme(self, "picture", self._draw)

    def show_picture(self, paint: Paint) -> None:
        self._paint = paint
        self._draw()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._draw()

    def _draw(self) -> None:
        line = self.fontMetrics().height()
        self.setMinimumSize(11 * line, 8 * line)
        height = max(self.height() - 3 * line, 5 * line)
        width = min(max(self.width() - 2 * line, 9 * line), 2 * height)
        self.setIconSize(QSize(width, height))
        if self._paint is not None:
            picture = QPixmap(self.iconSize() * self.devicePixelRatioF())
            picture.setDevicePixelRatio(self.devicePixelRatioF())
            picture.fill(Qt.GlobalColor.transparent)
            with Painter(picture) as painter:
                self._paint(painter, QRectF(8, 8, width - 16, height - 16))
            self.setIcon(QIcon(picture))


class Choices(QWidget):
    chosen = Signal(object)  # key of the button that the user has clicked

    def __init__(
        self, name: str, texts: Mapping[ChoiceT, str], parent: QWidget, *, columns: int
    ) -> None:
        super().__init__(parent)
        self.setObjectName(name)
        self._buttons: dict[object, _Choice] = {}
        self._captions: dict[object, Note] = {}
        group, grid = QButtonGroup(self), ui.grid(self, margins=0, spacing=(12, 6))
        for number, (choice, text) in enumerate(texts.items()):
            key = "Keep" if choice is None else choice.name.title().replace("_", "")
            button = self._buttons[choice] = ui.named(_Choice(self), f"{name}{key}")
            button.setText(text)
            button.clicked.connect(partial(self.chosen.emit, choice))
            group.addButton(button)
            caption = self._captions[choice] = Note(2, self)
            caption.setAlignment(Qt.AlignmentFlag.AlignHCenter)
            set_text_color(caption, "muted")
            row, column = divmod(number, columns)
            grid.addWidget(button, 2 * row, column)
            grid.addWidget(caption, 2 * row + 1, column)
            grid.setRowStretch(2 * row, 1)

    def show_choice(self, choice: object) -> None:
        self._buttons[choice].setChecked(True)

    def show_picture(self, choice: object, paint: Paint, caption: str) -> None:
        self._captions[choice].setText(caption)
        self._buttons[choice].setAccessibleDescription(caption)
        self._buttons[choice].show_picture(paint)


def paint_driver(driver: Driver, painter: QPainter, box: QRectF) -> None:
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
        has_one_stick = driver is Driver.ONE_STICK
        painter.setBrush(color("base"))
        for x in (8.0,) if has_one_stick else (4.6, 11.4):
            middle = QPointF(x, 6)
            painter.drawEllipse(middle, 3, 3)
            painter.setPen(QPen(color("accent"), 0.45, c=Qt.PenCapStyle.RoundCap))
            directions = [QPointF(0, -1), QPointF(0, 1), QPointF(-1, 0), QPointF(1, 0)]
            for direction in directions[: 4 if has_one_stick else 2]:
                across = QPointF(direction.y(), direction.x()) * 0.6
                tip = middle + direction * 2.3
                painter.drawPolyline(
                    [tip - direction * 0.7 + across, tip, tip - direction * 0.7 - across]
                )
            painter.setBrush(color("accent"))
            painter.drawEllipse(middle, 0.6, 0.6)
            painter.setPen(pen)
            painter.setBrush(color("base"))
    painter.restore()


def paint_ramp(ramp: float, brake: float, painter: QPainter, box: QRectF) -> None:
    """Paint a start and a reversal. `ramp`: seconds to full speed. `brake`: seconds of braking."""

    def point(seconds: float, speed: float) -> QPointF:
        y = box.center().y() - speed * box.height() / 2
        return QPointF(box.left() + seconds / _SPAN_S * box.width(), y)

    reversal = _REVERSAL_S + brake
    ramp_end = min(ramp, _REVERSAL_S)  # a slow ramp does not reach full speed
    top = ramp_end / ramp if ramp else 1.0
    start = point(0, 0), point(ramp_end, top), point(_REVERSAL_S, top), point(_REVERSAL_S, 0)
    back = point(reversal, 0), point(reversal + ramp, -1), point(_SPAN_S + ramp, -1)
    color = theme().color
    painter.save()
    painter.setPen(QPen(color("hatch"), 1))
    painter.drawLine(point(0, 0), point(_SPAN_S, 0))
    painter.drawLine(point(0, -1), point(0, 1))
    painter.setClipRect(box.adjusted(-3, -3, 0, 3))
    painter.setPen(QPen(color("accent"), 2.5))
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.drawPolyline([*start, *back])
    painter.restore()
