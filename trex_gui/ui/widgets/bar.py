"""Bars for live values, and the limits of the values."""

from collections.abc import Sequence
from enum import Enum

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QPainter, QPen

from trex_gui.ui.theme.theme import theme

NO_VALUE = "\N{EN DASH}"
MINUS = "\N{MINUS SIGN}"

WARNING_SIGN = "⚠"
_NEAR = 0.8  # fraction of the limit; from this fraction on, a value is near its limit


class LimitState(Enum):
    """Theme colour of a value near or over its limit."""

    BELOW = ""
    NEAR = "warning"
    OVER = "danger"


def limit_state(value: float | None, limit: float | None) -> LimitState:
    """Return the state of a non-negative value. Without a limit, the state is `BELOW`."""
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
    """Paint a bar from the middle mark to the value. Without marks, paint a needle."""
    color, radius = theme().color, track.height() / 2

    def x_of(position: int) -> float:
        low, high = axis
        return track.left() + track.width() * min(max((position - low) / (high - low), 0.0), 1.0)

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
