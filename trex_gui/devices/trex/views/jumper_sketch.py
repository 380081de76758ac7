"""Picture of the jumpers of a board."""

from collections.abc import Sequence
from dataclasses import dataclass

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from trex_gui.core.translation import tr
from trex_gui.ui.theme.theme import follow_theme, theme
from trex_gui.ui.widgets.painted import Painted, Painter

_PIN = 2.5  # radius of a pin, in pixels
_BOARD_WIDTH = 25  # characters
_ROW = 1.9  # lines from one pair of pins to the next


@dataclass(frozen=True, slots=True)
class JumperPlaces:
    """Where the jumpers of one board are."""

    title: str  # when they are there
    mode: str  # `RC`, `Analog`, or empty without the mode jumper
    mix: bool | None  # whether the mix jumper is on; `None` if that does not matter
    so_ground: bool = False  # whether the SO–G jumper is on
    next_one: str = ""  # the jumper to move now: `mode`, `mix`, `so_ground`, or none


class JumperSketch(Painted):
    """The mode, mix and SO–G jumpers, schematically, of boards side by side."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._boards: Sequence[JumperPlaces] = ()
        self.setObjectName("jumperSketch")
        follow_theme(self, "room", self._take_room)

    def show_boards(self, *boards: JumperPlaces) -> None:
        if boards != self._boards:
            self._boards = boards
            self.setAccessibleName(" ".join(map(_spoken, boards)))
            self._take_room()

    def _take_room(self) -> None:
        self.setFixedSize(self.sizeHint())
        self.update()

    def sizeHint(self) -> QSize:
        metrics, boards = self.fontMetrics(), max(len(self._boards), 1)
        line, advance = metrics.height(), metrics.horizontalAdvance
        titles = max((advance(board.title) for board in self._boards), default=0)
        positions = [position for _, _, position in self._rows()]
        widest = max(map(advance, [*positions, *self._words().values()]))
        row = self._pins_at() + (1.3 + 0.9 + 0.8) * line + widest
        width = max(metrics.averageCharWidth() * _BOARD_WIDTH, titles, round(row))
        return QSize(boards * width + (boards - 1) * line, round(10.8 * line))

    def _rows(self) -> Sequence[tuple[str, str, str]]:
        """Return key, name and position of each pair of pins; without a position it is a word."""
        return (
            ("mode", tr("Mode"), tr("RC")),
            ("", "", tr("Analog")),
            ("mix", tr("Mix"), ""),
            ("so_ground", tr("SO–G"), ""),
        )

    def _words(self) -> dict[bool | None, str]:
        on, off = tr("on", "jumper"), tr("off", "jumper")
        return {True: on, False: off, None: tr("either")}

    def _pins_at(self) -> float:
        """Return where the pins begin, right of the names; pixels."""
        metrics = self.fontMetrics()
        widest = max(metrics.horizontalAdvance(f"▸ {name}") for _, name, _ in self._rows())
        return max(4.8 * metrics.height(), 1.2 * metrics.height() + widest)

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        with Painter(self) as painter:
            line, boards = self.fontMetrics().height(), max(len(self._boards), 1)
            width = (self.width() - (boards - 1) * line) / boards
            height = self.height() - 1.7 * line - 1
            for number, board in enumerate(self._boards):
                place = QRectF(0.5 + number * (width + line), 1.7 * line, width - 1, height)
                self._paint_board(painter, place, board)

    def _paint_board(self, painter: QPainter, place: QRectF, board: JumperPlaces) -> None:
        line, text = self.fontMetrics().height(), theme().color("window_text")
        painter.setPen(QPen(text, 1))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRoundedRect(place, 6, 6)
        title = QRectF(place.left(), 0, place.width(), 1.6 * line)
        painter.drawText(title, Qt.AlignmentFlag.AlignCenter, board.title)
        states = (board.mode == "RC", board.mode == "Analog", board.mix, board.so_ground)
        rows = zip(self._rows(), states, strict=True)
        for number, ((key, name, position), is_on) in enumerate(rows):
            y = place.top() + (0.9 + _ROW * number + 0.5 * (number > 1)) * line
            row = QRectF(place.left(), y, place.width(), line)
            is_next = bool(key) and key == board.next_one
            self._paint_jumper(painter, row, (f"▸ {name}" if is_next else name, position), is_on)

    def _paint_jumper(
        self, painter: QPainter, row: QRectF, names: tuple[str, str], is_on: bool | None
    ) -> None:
        """Paint a pair of pins, with the jumper on them if it is there."""
        line, (name, position) = row.height(), names
        color = theme().color("muted" if is_on is None else "window_text")
        middle = Qt.AlignmentFlag.AlignVCenter
        painter.setPen(QPen(color, 1))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawText(row.adjusted(0.8 * line, 0, 0, 0), middle, name)
        first = QPointF(row.left() + self._pins_at(), row.center().y())
        second = first + QPointF(1.3 * line, 0)
        text = row.adjusted(second.x() + 0.9 * line - row.left(), 0, 0, 0)
        painter.drawText(text, middle, position or self._words()[is_on])
        if is_on:
            painter.setBrush(theme().color("motor1"))
            reach = 0.55 * line
            box = QRectF(first, second).adjusted(-reach, -reach, reach, reach)
            painter.drawRoundedRect(box, 4, 4)
        painter.setBrush(theme().color("window"))
        for pin in (first, second):
            painter.drawEllipse(pin, _PIN, _PIN)


def _spoken(board: JumperPlaces) -> str:
    mode = tr("mode jumper at {0}").format(board.mode)
    texts = [mode if board.mode else tr("no mode jumper")]
    if board.mix is not None:
        texts.append(tr("mix jumper on") if board.mix else tr("no mix jumper"))
    texts.append(tr("SO–G jumper on") if board.so_ground else tr("no SO–G jumper"))
    return f"{board.title}: {', '.join(texts)}."
