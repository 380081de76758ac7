"""Base of the live bars: states, frame, number, and fast painting."""

from enum import Enum
from typing import NamedTuple

from PySide6.QtCore import QEvent, QPointF, QRect, QRectF, QSize, Qt, Slot
from PySide6.QtGui import (
    QAccessible,
    QColor,
    QFont,
    QFontMetrics,
    QPainter,
    QPaintEvent,
    QPen,
    QPixmap,
    QResizeEvent,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from trex_gui.core.translation import tr
from trex_gui.ui.theme.theme import scaled_font, theme
from trex_gui.ui.widgets.accessible import SpokenRange
from trex_gui.ui.widgets.painted import Painted, Painter

NO_VALUE = "\N{EN DASH}"
MINUS = "\N{MINUS SIGN}"

_VALUE_FLAGS = (
    Qt.AlignmentFlag.AlignRight
    | Qt.AlignmentFlag.AlignVCenter
    | Qt.TextFlag.TextSingleLine
    | Qt.TextFlag.TextDontClip
)


WARNING_SIGN = "⚠"
_NEAR = 0.8  # share of a limit from which a value is near it


class LimitState(Enum):
    """Where a value is; each is a colour of the theme, the usual one if empty."""

    BELOW = ""
    NEAR = "warning"
    OVER = "danger"


def limit_state(value: float | None, limit: float | None) -> LimitState:
    """Return where a value of at least 0 is; without a limit it is below."""
    if not limit or value is None or value < _NEAR * limit:
        return LimitState.BELOW
    return LimitState.NEAR if value <= limit else LimitState.OVER


class BarState(Enum):
    DISCONNECTED = "disconnected"
    WAITING = "waiting"  # connected, no value yet
    NO_SIGNAL = "no signal"
    LIVE = "live"


class Marks(NamedTuple):
    """Colours that every repaint needs."""

    fill: QColor
    neutral: QColor
    mark: QColor
    pointer: QColor
    text: QColor
    muted: QColor


class Bar(Painted):
    """A horizontal bar that is grey without a connection and hatched without a signal.

    What changes seldom is painted into a pixmap; a new value costs a copy of it, a rectangle,
    a few lines and a number. Screen readers find its value when they look for it.
    """

    spoken_role = QAccessible.Role.ProgressBar

    def __init__(self, fill: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._fill = fill
        self._connected = False
        self._has_value = False
        self.state = BarState.DISCONNECTED
        self._static = QPixmap()
        self._static_key: tuple[object, ...] = ()
        self._small = QFont()
        self._marks = self._read_marks()
        self._ratio = 1.0
        self._frame = QRect()
        self._measure()

        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

        theme().changed.connect(self._on_theme_changed)

    def set_connected(self, connected: bool) -> None:
        """A new connection starts without a value."""
        if connected == self._connected:
            return
        self._connected = connected
        self._has_value = False
        self._clear()
        self._refresh()

    # --- For each kind of bar -----------------------------------------------------------

    def _clear(self) -> None:
        raise NotImplementedError

    def _has_signal(self) -> bool:
        raise NotImplementedError

    def _value_text(self) -> str:
        raise NotImplementedError

    def _spoken_value(self) -> str:
        raise NotImplementedError

    def spoken_range(self) -> SpokenRange:
        raise NotImplementedError

    def _widest_value(self) -> str:
        raise NotImplementedError

    def _lay_out(self) -> QRect:
        """Return where the track lies, from the widget's size and texts."""
        raise NotImplementedError

    def _cache_key(self) -> tuple[object, ...]:
        """Return what the static picture depends on, beyond size, font, state and theme."""
        return ()

    def _paint_static(self, painter: QPainter, track: QRect) -> None:
        """Paint what does not move, over the frame."""

    def _paint_live(self, painter: QPainter, track: QRect) -> None:
        raise NotImplementedError

    # --- For all ------------------------------------------------------------------------

    def _track(self) -> QRect:
        if self._frame.isNull():
            self._frame = self._lay_out()
        return self._frame

    def _forget_layout(self) -> None:
        self._frame = QRect()
        self._static_key = ()

    def _refresh(self) -> None:
        if not self._connected:
            self.state = BarState.DISCONNECTED
        elif not self._has_value:
            self.state = BarState.WAITING
        else:
            self.state = BarState.LIVE if self._has_signal() else BarState.NO_SIGNAL
        self.update()

    def spoken_state(self) -> str:
        if self.state is BarState.DISCONNECTED:
            return tr("not connected")
        return self._caption() or self._spoken_value()

    def _caption(self) -> str:
        texts = {
            BarState.WAITING: tr("no data yet"),
            BarState.NO_SIGNAL: tr("no signal"),
        }
        return texts.get(self.state, "")

    def _value_column(self) -> int:
        """Return the width of the number right of the bar, its gap included."""
        return self._value_width + self.fontMetrics().averageCharWidth()

    def _measure(self) -> None:
        self._small = scaled_font(self.font(), 0.85)
        self._small_metrics = QFontMetrics(self._small)
        self._value_width = self.fontMetrics().horizontalAdvance(self._widest_value())
        self._forget_layout()

    def _read_marks(self) -> Marks:
        common = ("neutral", "mark", "pointer", "text", "muted")
        return Marks(*(theme().color(name) for name in (self._fill, *common)))

    @Slot()
    def _on_theme_changed(self) -> None:
        self._marks = self._read_marks()
        self._static_key = ()

    def changeEvent(self, event: QEvent) -> None:
        if event.type() in {QEvent.Type.FontChange, QEvent.Type.StyleChange}:
            self._measure()
            self.updateGeometry()
        super().changeEvent(event)

    def resizeEvent(self, event: QResizeEvent) -> None:
        self._forget_layout()
        super().resizeEvent(event)

    def sizeHint(self) -> QSize:
        return QSize(self.fontMetrics().averageCharWidth() * 48, self._height())

    def minimumSizeHint(self) -> QSize:
        width = self._value_column() + self.fontMetrics().averageCharWidth() * 12
        return QSize(width, self._height())

    def _height(self) -> int:
        raise NotImplementedError

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002 - always the whole bar
        track = self._track()
        self._ratio = self.devicePixelRatioF()
        key = (self._ratio, self.state, *self._cache_key())
        if key != self._static_key:
            self._static = self._draw_static(track)
            self._static_key = key
        with Painter(self, smooth=False) as painter:
            painter.drawPixmap(0, 0, self._static)
            if self.state is BarState.LIVE:
                self._paint_live(painter, track)
            self._paint_value(painter, track)

    def _draw_static(self, track: QRect) -> QPixmap:
        pixmap = QPixmap(self.size() * self._ratio)
        pixmap.setDevicePixelRatio(self._ratio)
        pixmap.fill(Qt.GlobalColor.transparent)
        color = theme().color
        live = self.state is BarState.LIVE
        with Painter(pixmap, smooth=False) as painter:
            painter.fillRect(track, color("track" if live else "track_off"))
            if self.state is BarState.NO_SIGNAL:
                self._paint_hatch(painter, track)
            self._paint_static(painter, track)
            painter.setPen(QPen(color("track_edge"), 1))
            painter.drawRect(QRectF(track).adjusted(-0.5, -0.5, 0.5, 0.5))
            self._paint_caption(painter, track)
        return pixmap

    def _paint_hatch(self, painter: QPainter, track: QRect) -> None:
        """Paint slanted lines; Qt's own patterns shrink on fine screens."""
        painter.save()
        painter.setClipRect(track)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(theme().color("hatch"), 1.2))
        height = track.height()
        for x in range(track.left() - height, track.left() + track.width(), 8):
            painter.drawLine(QPointF(x, track.top() + height), QPointF(x + height, track.top()))
        painter.restore()

    def _paint_caption(self, painter: QPainter, track: QRect) -> None:
        caption = self._caption()
        if not caption:
            return
        metrics = self.fontMetrics()
        room = track.width() - metrics.averageCharWidth() * 2
        caption = metrics.elidedText(caption, Qt.TextElideMode.ElideRight, max(room, 0))
        box = metrics.boundingRect(caption)
        box.setWidth(metrics.horizontalAdvance(caption) + metrics.averageCharWidth() * 2)
        box.setHeight(track.height())
        box.moveCenter(track.center())
        painter.fillRect(box, theme().color("track_off"))
        painter.setPen(self._marks.text)
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, caption)

    def _paint_value(self, painter: QPainter, track: QRect) -> None:
        live = self.state is BarState.LIVE
        painter.setPen(self._marks.text if live else self._marks.muted)
        width = self._value_width
        box = QRect(self.width() - width - 1, track.top(), width, track.height())
        painter.drawText(box, _VALUE_FLAGS, self._value_text() if live else NO_VALUE)

    def _paint_fill(
        self, painter: QPainter, track: QRect, start: float, end: float, color: QColor
    ) -> None:
        left, right = sorted((self._snap(start), self._snap(end)))
        painter.fillRect(QRectF(left, track.top(), right - left, track.height()), color)

    def _paint_pointer(self, painter: QPainter, track: QRect, x: float) -> None:
        """Paint the needle at `x`."""
        x = self._snap(min(max(x, track.left()), track.left() + track.width()))
        painter.fillRect(QRectF(x - 1, track.top(), 2, track.height()), self._marks.pointer)

    def _snap(self, x: float) -> float:
        """Return `x` on the nearest edge of a device pixel, so that lines stay sharp."""
        return round(x * self._ratio) / self._ratio
