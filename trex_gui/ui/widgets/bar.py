"""Base of the live bars; signs and limits of values."""

from collections.abc import Sequence
from enum import Enum

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QAccessible, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from trex_gui.core.translation import tr, tr_noop
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.accessible import SpokenRange
from trex_gui.ui.widgets.circuit import write
from trex_gui.ui.widgets.painted import Painted, Painter

NO_VALUE = "\N{EN DASH}"
MINUS = "\N{MINUS SIGN}"

WARNING_SIGN = "⚠"
_NEAR = 0.8  # share of a limit from which a value is near it


class LimitState(Enum):
    """Place of a value below or above its limit: a colour of the theme, if not empty."""

    BELOW = ""
    NEAR = "warning"
    OVER = "danger"


def limit_state(value: float | None, limit: float | None) -> LimitState:
    """Return where a value of at least 0 is; without a limit it is below."""
    if not limit or value is None or value < _NEAR * limit:
        return LimitState.BELOW
    return LimitState.NEAR if value <= limit else LimitState.OVER


class BarState(Enum):
    """State of a bar: the words in its place, until it has a value."""

    DISCONNECTED = tr_noop("not connected")
    WAITING = tr_noop("no data yet")
    NO_SIGNAL = tr_noop("no signal")
    LIVE = ""


def paint_track(
    painter: QPainter,
    track: QRectF,
    axis: tuple[int, int],
    value: int | None,
    marks: Sequence[int],
    *,
    fill: str = "bar",
) -> None:
    """Paint a value as the way from the middle mark to it, or as a needle if there are no marks."""
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


class Bar(Painted):
    """A value on an axis, and its number at the right.

    Screen readers find its value when they look for it.
    """

    spoken_role = QAccessible.Role.ProgressBar

    def __init__(self, axis: tuple[int, int], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.axis = axis  # values at the left and the right end
        self.state = BarState.DISCONNECTED
        self.value: int | None = None
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

    def set_connected(self, connected: bool) -> None:
        """A new connection starts without a value."""
        if connected is (self.state is BarState.DISCONNECTED):
            self._show(BarState.WAITING if connected else BarState.DISCONNECTED, None)

    def set_value(self, value: int | None) -> None:
        """Show a value; `None` means no valid signal. Without a connection it is ignored."""
        if self.state is not BarState.DISCONNECTED:
            self._show(BarState.NO_SIGNAL if value is None else BarState.LIVE, value)

    def _show(self, state: BarState, value: int | None) -> None:
        if (state, value) != (self.state, self.value):
            self.state, self.value = state, value
            self.update()

    # --- For each kind of bar -----------------------------------------------------------

    def text_of(self, value: int) -> str:
        raise NotImplementedError

    def spoken_value(self, value: int) -> str:
        raise NotImplementedError

    def spoken_range(self) -> SpokenRange:
        raise NotImplementedError

    def paint(self, painter: QPainter, track: QRectF) -> None:
        """Paint the track with a value."""
        raise NotImplementedError

    # --- For all ------------------------------------------------------------------------

    def spoken_state(self) -> str:
        return tr(self.state.value) if self.value is None else self.spoken_value(self.value)

    def track(self) -> QRectF:
        height = self.fontMetrics().height() - 4
        width = max(1, self.width() - self._column() - 2)
        return QRectF(1, (self.height() - height) / 2, width, height)

    def _column(self) -> int:
        """Return the width of the number right of the bar, its gap included."""
        metrics = self.fontMetrics()
        widest = max(metrics.horizontalAdvance(self.text_of(end)) for end in self.axis)
        return widest + metrics.averageCharWidth()

    def _size(self, characters: int) -> QSize:
        metrics = self.fontMetrics()
        return QSize(characters * metrics.averageCharWidth(), metrics.height() + 6)

    def sizeHint(self) -> QSize:
        return self._size(48)

    def minimumSizeHint(self) -> QSize:
        return self._size(12) + QSize(self._column(), 0)

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        track, value, rect = self.track(), self.value, QRectF(self.rect())
        right, middle = Qt.AlignmentFlag.AlignRight, Qt.AlignmentFlag.AlignHCenter
        with Painter(self) as painter:
            if value is None:
                paint_track(painter, track, self.axis, None, ())
                words = track.adjusted(0, -2, 0, 2)
                write(painter, words, tr(self.state.value), "muted", align=middle)
                write(painter, rect, NO_VALUE, "muted", align=right)
            else:
                self.paint(painter, track)
                write(painter, rect, self.text_of(value), "window_text", align=right)
