"""Drawing of the wires between an adapter or receiver and a board, not to scale."""

from collections.abc import Sequence
from dataclasses import dataclass

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from trex_gui.core.translation import tr
from trex_gui.ui.theme.theme import follow_theme, scaled_font, theme
from trex_gui.ui.widgets.circuit import (
    Jumper,
    jumpers_size,
    paint_block,
    paint_body,
    paint_jumpers,
    text_width,
    write,
)
from trex_gui.ui.widgets.painted import Painted, Painter

_COLORS = ("window_text", "accent", "outline")  # theme colours of the wires from top to bottom
_FIRST_WIRE = 3.6  # y position in line heights
_MIN_SCALE, _MAX_SCALE, _MAX_TEXT_SCALE = 0.85, 2.0, 1.2  # a scale of 1 fits the font


@dataclass(frozen=True, slots=True)
class Wires:
    board: str  # name of the board
    adapter: str  # name of the adapter or receiver
    wires: Sequence[tuple[str, str]]  # (adapter pin, board pin), from the top; at most 3
    jumpers: Sequence[Jumper] = ()


class WiringSketch(Painted):
    def __init__(self, wiring: Wires, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName(name)
        wires = ", ".join(f"{pin} – {board_pin}" for pin, board_pin in wiring.wires)
        names = f"{wiring.adapter} – {wiring.board}"
        self.setAccessibleName(tr("{0}: {1}").format(names, wires))
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)
        self._wiring = wiring
        follow_theme(self, "space", self.updateGeometry)

    def spoken_state(self) -> str:
        return ". ".join(text for text, _ in self._wiring.jumpers)

    def sizeHint(self) -> QSize:
        _, body = self._boxes()
        return QSize(round(body.right()) + 2, round(body.bottom()) + 2)

    def minimumSizeHint(self) -> QSize:
        return self.sizeHint() * _MIN_SCALE

    def _boxes(self) -> tuple[QRectF, QRectF]:
        wiring, font, line = self._wiring, self.font(), self.fontMetrics().height()
        left, right = self._pin_widths()
        rows, jumpers = 2 * len(wiring.wires), jumpers_size(font, wiring.jumpers)
        width = max(8.5 * line, text_width(font, wiring.adapter) + line + left / 2)
        adapter = QRectF(1, (_FIRST_WIRE - 1.4) * line, width, (rows + 0.8) * line)
        board_left = adapter.right() + (left + right) / 2 + 5 * line
        board = max(12 * line, right + text_width(font, wiring.board))
        height = (_FIRST_WIRE + rows + 1) * line + jumpers.height()
        return adapter, QRectF(board_left, 1, max(board, jumpers.width() + 3 * line), height)

    def _pin_widths(self) -> tuple[float, float]:
        line = self.fontMetrics().height()
        left, right = zip(*self._wiring.wires, strict=True)
        return text_width(self.font(), *left) + line, text_width(self.font(), *right) + line

    def paintEvent(self, _event: QPaintEvent) -> None:
        hint, line = self.sizeHint(), self.fontMetrics().height()
        (adapter, body), (left, right) = self._boxes(), self._pin_widths()
        height = self.height() - line  # without the space above and below
        scale = min(self.width() / hint.width(), height / hint.height(), _MAX_SCALE)
        with Painter(self) as painter:
            painter.translate(
                (self.width() - scale * hint.width()) / 2,
                (self.height() - scale * hint.height()) / 2,
            )
            painter.scale(scale, scale)
            painter.setFont(scaled_font(self.font(), min(1.0, _MAX_TEXT_SCALE / scale)))
            painter.setPen(QPen(theme().color("outline"), 1.5))
            painter.setBrush(theme().color("track"))
            painter.drawRoundedRect(adapter, 8, 8)
            title = adapter.adjusted(0, 0, -left / 2, 0)
            center = Qt.AlignmentFlag.AlignHCenter
            write(painter, title, self._wiring.adapter, "window_text", bold=True, align=center)
            paint_body(painter, body, self._wiring.board)
            for number, (pin, board_pin) in enumerate(self._wiring.wires):
                y = (_FIRST_WIRE + 2 * number) * line
                painter.setPen(QPen(theme().color(_COLORS[number]), 3))
                painter.drawLine(QPointF(adapter.right(), y), QPointF(body.left(), y))
                for x, width, name in (
                    (adapter.right(), left, pin),
                    (body.left(), right, board_pin),
                ):
                    rect = QRectF(x - width / 2, y - 0.75 * line, width, 1.5 * line)
                    paint_block(painter, rect, (name,))
                top = (_FIRST_WIRE + 2 * len(self._wiring.wires) - 0.4) * line
            top_left = QPointF(body.left() + 2 * line, top)
            paint_jumpers(painter, top_left, self._wiring.jumpers, line)
