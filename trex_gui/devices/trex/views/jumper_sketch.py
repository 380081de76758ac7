"""Picture of the jumpers of a board."""

from collections.abc import Sequence
from dataclasses import dataclass

from PySide6.QtCore import QPointF, QRectF, QSize
from PySide6.QtGui import QPaintEvent
from PySide6.QtWidgets import QWidget

from trex_gui.core.translation import tr
from trex_gui.ui.theme.theme import follow_theme
from trex_gui.ui.widgets.circuit import (
    Jumper,
    jumpers_size,
    paint_body,
    paint_jumpers,
    text_width,
)
from trex_gui.ui.widgets.painted import Painted, Painter

_ABOVE = 3  # lines of text for the title


@dataclass(frozen=True, slots=True)
class JumperPlaces:
    """Where the jumpers of one board are."""

    title: str  # when they are there
    mode: str  # `RC`, `Analog`, or empty without the mode jumper
    mix: bool | None  # whether the mix jumper is on; `None` if that does not matter
    so_ground: bool = False  # whether the SO–G jumper is on
    next_one: str = ""  # the jumper to move now: `mode`, `mix`, `so_ground`, or none

    @property
    def rows(self) -> Sequence[Jumper]:
        """The jumpers, with a sign before the one to move now."""
        position = tr("RC") if self.mode == "RC" else tr("Analog")
        mode = tr("Mode: {0}").format(position) if self.mode else tr("Mode: off")
        so_ground = tr("SO–G: on") if self.so_ground else tr("SO–G: off")
        rows = [("mode", mode, bool(self.mode)), ("so_ground", so_ground, self.so_ground)]
        if self.mix is not None:
            rows.insert(1, ("mix", tr("Mix: on") if self.mix else tr("Mix: off"), self.mix))
        return [(f"▸ {text}" if key == self.next_one else text, on) for key, text, on in rows]

    @property
    def spoken(self) -> str:
        return f"{self.title}: {', '.join(text for text, _ in self.rows)}."


class JumperSketch(Painted):
    """The mode, mix and SO–G jumpers, schematically, of boards side by side."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._boards: Sequence[JumperPlaces] = (JumperPlaces("", "", None),)
        self.setObjectName("jumperSketch")
        follow_theme(self, "room", self._take_room)

    def show_boards(self, *boards: JumperPlaces) -> None:
        if boards != self._boards:
            self._boards = boards
            self.setAccessibleName(" ".join(board.spoken for board in boards))
            self._take_room()

    def _take_room(self) -> None:
        self.setFixedSize(self.sizeHint())
        self.update()

    def sizeHint(self) -> QSize:
        line, boards = self.fontMetrics().height(), self._boards
        sizes = [jumpers_size(self.font(), board.rows) for board in boards]
        widths = [text_width(self.font(), f"{board.title}       ") for board in boards]
        width = max([*widths, *(round(size.width() + 2.5 * line) for size in sizes)], default=0)
        height = max((size.height() for size in sizes), default=0) + (_ABOVE + 1) * line
        return QSize(len(boards) * (width + line), round(height))

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        line = self.fontMetrics().height()
        with Painter(self) as painter:
            for number, board in enumerate(self._boards):
                step = self.width() / len(self._boards)
                body = QRectF(number * step + 1, 1, step - line, self.height() - 2)
                paint_body(painter, body, board.title)
                at = QPointF(body.left() + 1.5 * line, _ABOVE * line)
                paint_jumpers(painter, at, board.rows, line)
