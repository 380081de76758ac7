"""Picture of the jumpers of a board."""

from collections.abc import Sequence
from dataclasses import dataclass

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets import builders as ui

_PIN = 2.5  # radius of a pin, in pixels


@dataclass(frozen=True, slots=True)
class JumperPlaces:
    """Where the jumpers of one board are.

    Attributes:
        title: when they are there.
        mode: `RC`, `Analog`, or empty without the mode jumper.
        mix: whether the mix jumper is on; `None` if that does not matter.
    """

    title: str
    mode: str
    mix: bool | None


class JumperSketch(QWidget):
    """The mode jumper and the mix jumper, schematically, of boards side by side."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._boards: Sequence[JumperPlaces] = ()
        ui.named(self, "jumperSketch")
        self.setFixedSize(self.sizeHint())
        theme().changed.connect(self.update)

    def show_boards(self, *boards: JumperPlaces) -> None:
        if boards != self._boards:
            self._boards = boards
            self.setAccessibleName(" ".join(map(self._describe, boards)))
            self.update()

    def _describe(self, board: JumperPlaces) -> str:
        mode = self.tr("mode jumper at {0}").format(board.mode)
        texts = [mode if board.mode else self.tr("no mode jumper")]
        if board.mix is not None:
            texts.append(self.tr("mix jumper on") if board.mix else self.tr("no mix jumper"))
        return f"{board.title}: {', '.join(texts)}."

    def sizeHint(self) -> QSize:
        line = self.fontMetrics().height()
        return QSize(self.fontMetrics().averageCharWidth() * 50, line * 11)

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            line = self.fontMetrics().height()
            width = (self.width() - line) / 2
            for number, board in enumerate(self._boards):
                place = QRectF(0.5 + number * (width + line), 1.7 * line, width - 1, 9 * line)
                self._paint_board(painter, place, board)

    def _paint_board(self, painter: QPainter, place: QRectF, board: JumperPlaces) -> None:
        line, text = self.fontMetrics().height(), theme().color("window_text")
        painter.setPen(QPen(text, 1))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRoundedRect(place, 6, 6)
        title = QRectF(place.left(), 0, place.width(), 1.6 * line)
        painter.drawText(title, Qt.AlignmentFlag.AlignCenter, board.title)
        rows = (
            (self.tr("Mode"), self.tr("RC"), board.mode == "RC"),
            ("", self.tr("Analog"), board.mode == "Analog"),
            (self.tr("Mix"), "", board.mix),
        )
        for number, (name, position, is_on) in enumerate(rows):
            y = place.top() + (1.3 + 2.4 * number + 0.6 * (number == 2)) * line
            row = QRectF(place.left(), y, place.width(), line)
            self._paint_jumper(painter, row, (name, position), is_on)

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
        first = QPointF(row.left() + 4.2 * line, row.center().y())
        second = first + QPointF(1.3 * line, 0)
        words = {True: self.tr("on"), False: self.tr("off"), None: self.tr("either")}
        text = row.adjusted(second.x() + 0.9 * line - row.left(), 0, 0, 0)
        painter.drawText(text, middle, position or words[is_on])
        if is_on:
            painter.setBrush(theme().color("motor1"))
            reach = 0.55 * line
            painter.drawRoundedRect(
                QRectF(first, second).adjusted(-reach, -reach, reach, reach), 4, 4
            )
        painter.setBrush(theme().color("window"))
        for pin in (first, second):
            painter.drawEllipse(pin, _PIN, _PIN)
