"""The track of live bars, and the signs and limits of values."""

from collections.abc import Sequence
from enum import Enum

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QAccessible, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from trex_gui.core.texts import signed_text
from trex_gui.core.translation import tr
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.accessible import SpokenRange
from trex_gui.ui.widgets.circuit import write
from trex_gui.ui.widgets.painted import Painted, Painter

NO_VALUE = "\N{EN DASH}"
MINUS = "\N{MINUS SIGN}"

WARNING_SIGN = "⚠"
_NEAR = 0.8  # share of a limit from which a value is near it


class LimitState(Enum):
    """Position of a value relative to its limit: a colour of the theme, or empty."""

    BELOW = ""
    NEAR = "warning"
    OVER = "danger"


def limit_state(value: float | None, limit: float | None) -> LimitState:
    """Return the state of a value of at least 0. Without a limit it is `BELOW`."""
    if not limit or value is None or value < _NEAR * limit:
        return LimitState.BELOW
    return LimitState.NEAR if value <= limit else LimitState.OVER


def paint_track(
    painter: QPainter,
    track: QRectF,
    axis: tuple[int, int],
    value: int | None,
    marks: Sequence[int],
    *,
    fill: str = "bar",
) -> None:
    """Paint a value as a bar from the middle mark, or as a needle if there are no marks."""
    color, radius = theme().color, track.height() / 2

    def x_of(at: int) -> float:
        low, high = axis
        return track.left() + track.width() * min(max((at - low) / (high - low), 0.0), 1.0)

    painter.setPen(QPen(color("hairline"), 1))
    painter.setBrush(color("track"))
    painter.drawRoundedRect(track, radius, radius)
    if value is not None:
        left, right = sorted(map(x_of, (marks[len(marks) // 2] if marks else value, value)))
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(color(fill))
        filled = QRectF(left - 1, track.top(), right - left + 2, track.height())
        painter.drawRoundedRect(filled, 2, 2)
    painter.setPen(QPen(color("mark"), 1))
    for mark in marks:
        x = x_of(mark)
        painter.drawLine(QPointF(x, track.top() - 3), QPointF(x, track.bottom() + 3))


class PartBar(Painted):
    """Bar from the centre for a part from -1 to 1, with its percentage at the right.

    Screen readers get the value when they request it.
    """

    spoken_role = QAccessible.Role.ProgressBar

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._percent: int | None = None
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

    def set_part(self, part: float | None) -> None:
        percent = None if part is None else round(100 * part)
        if percent != self._percent:
            self._percent = percent
            self.update()

    def _text(self) -> str:
        return NO_VALUE if self._percent is None else f"{signed_text(self._percent)} %"

    def spoken_state(self) -> str:
        return tr("not connected") if self._percent is None else self._text()

    def spoken_range(self) -> SpokenRange:
        return SpokenRange(-100, self._percent or 0, 100)

    def _size(self, characters: int) -> QSize:
        metrics = self.fontMetrics()
        return QSize(characters * metrics.averageCharWidth(), metrics.height() + 6)

    def sizeHint(self) -> QSize:
        return self._size(48)

    def minimumSizeHint(self) -> QSize:
        return self._size(20)

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        metrics, rect = self.fontMetrics(), QRectF(self.rect())
        width = rect.width() - metrics.horizontalAdvance(f" {MINUS}100 %") - 2
        height = metrics.height() - 4
        track = QRectF(1, (rect.height() - height) / 2, max(1, width), height)
        marks = () if self._percent is None else (0,)
        with Painter(self) as painter:
            paint_track(painter, track, (-100, 100), self._percent, marks)
            color = "window_text" if marks else "muted"
            write(painter, rect, self._text(), color, align=Qt.AlignmentFlag.AlignRight)
