"""Picture of the wires between an adapter, or a receiver, and a board."""

from collections.abc import Sequence
from dataclasses import dataclass

from PySide6.QtCore import QLineF, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from trex_gui.core.translation import tr
from trex_gui.ui.theme.theme import follow_theme, theme
from trex_gui.ui.widgets.painted import Painted, Painter

_GAP = 12  # characters between the boxes
_LEAST_BOX = 11
_MARGIN = 8  # pixels beside the name of a pin
_WIRE_COLORS = ("motor1", "motor2", "muted")


@dataclass(frozen=True, slots=True)
class Wires:
    board: str  # name of what is wired
    # Names of the pins at the adapter and at the board, from top to bottom; at most three.
    wires: Sequence[tuple[str, str]]
    text: str  # the wires in words
    adapter: str = ""  # name of what the board is wired to, if it is no adapter


class WiringSketch(Painted):
    def __init__(self, wiring: Wires, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName(name)
        self.setAccessibleName(wiring.text)
        self._wiring = wiring
        follow_theme(self, "room", self._take_room)

    def _take_room(self) -> None:
        self.setFixedSize(self.sizeHint())
        self.update()

    def sizeHint(self) -> QSize:
        metrics = self.fontMetrics()
        gap = metrics.averageCharWidth() * _GAP
        return QSize(2 * self._box_width() + gap, metrics.height() * 9)

    def _box_width(self) -> int:
        metrics = self.fontMetrics()
        pins = [pin for wire in self._wiring.wires for pin in wire]
        widths = [metrics.horizontalAdvance(text) for text in (*pins, *self._titles())]
        return max(metrics.averageCharWidth() * _LEAST_BOX, max(widths) + 2 * _MARGIN)

    def _titles(self) -> tuple[str, str]:
        return self._wiring.adapter or tr("Adapter"), self._wiring.board

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        painter = Painter(self)
        line = self.fontMetrics().height()
        box = QRectF(0.5, 1.5 * line, self._box_width(), 6 * line)
        board = box.translated(self.width() - box.width() - 1, 0)
        text = theme().color("window_text")
        painter.setPen(QPen(text, 1))
        for place, title in zip((box, board), self._titles(), strict=True):
            painter.drawRoundedRect(place, 6, 6)
            above = QRectF(place.left(), 0, place.width(), 1.4 * line)
            painter.drawText(above, Qt.AlignmentFlag.AlignCenter, title)
        for number, (left, right) in enumerate(self._wiring.wires):
            y = box.top() + (2 * number + 1) * line
            begin, end = QPointF(box.right(), y), QPointF(board.left(), y)
            color = theme().color(_WIRE_COLORS[number])
            painter.setPen(QPen(color, 2))
            painter.drawLine(QLineF(begin, end))
            painter.setBrush(color)
            for pin in (begin, end):
                painter.drawEllipse(pin, 3, 3)
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.setPen(text)
            room = QRectF(0, y - line / 2, box.width() - _MARGIN, line)
            middle = Qt.AlignmentFlag.AlignVCenter
            painter.drawText(room, middle | Qt.AlignmentFlag.AlignRight, left)
            room.moveLeft(board.left() + _MARGIN)
            painter.drawText(room, middle | Qt.AlignmentFlag.AlignLeft, right)
