"""Painted LEDs that are lit, dark or flashing in a pattern."""

import re
from collections.abc import Sequence

from PySide6.QtCore import QPointF, QSize, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QPen, QShowEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from trex_gui.core.translation import tr
from trex_gui.ui.runtime import now
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.builders import column, plain, row
from trex_gui.ui.widgets.labels import ElidedLabel
from trex_gui.ui.widgets.painted import Animation, Painted, Painter

_FAST = 8.0  # flashes per second of the pattern "fast flash"
_PATTERN = re.compile(r"(blink|alternate|short flash) (\d+)/s")
_SHORT = 0.15  # fraction of the period in which an LED with a short flash is lit
_PACKETS = 17.0  # steps per second of the irregular pattern "with packets"


def is_lit(pattern: str, seconds: float, *, second: bool = False) -> bool:
    """Return whether an LED is lit. `second`: second LED of an alternating pair."""
    if pattern == "fast flash":
        return seconds * _FAST % 1 < 0.5
    if pattern == "with packets":
        return int(seconds * _PACKETS) * 5 % 7 < 4
    parsed = _PATTERN.fullmatch(pattern)
    if parsed is None:
        return pattern == "on"
    phase = seconds * int(parsed[2]) % 1
    if parsed[1] == "short flash":
        return phase < _SHORT
    return (phase < 0.5) is not (second and parsed[1] == "alternate")


def paint_lamp(
    painter: QPainter, middle: QPointF, radius: float, color: str, *, is_known: bool = True
) -> None:
    """Paint an LED. Without a colour, it is dark. An unknown state has a dashed outline."""
    style = Qt.PenStyle.SolidLine if is_known else Qt.PenStyle.DashLine
    painter.setPen(QPen(theme().color(color or "track_edge"), 1.5, style))
    painter.setBrush(theme().color(color or "track_off"))
    painter.drawEllipse(middle, radius, radius)
    if color:  # a glint marks a lit LED for users who cannot see the colour
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(Qt.GlobalColor.white)
        painter.drawEllipse(middle - QPointF(radius, radius) * 0.3, radius / 4, radius / 4)


class Lamp(Painted):
    def __init__(self, color: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._color = color
        self.lit = False
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)

    def set_lit(self, lit: bool) -> None:
        if lit != self.lit:
            self.lit = lit
            self.update()

    def sizeHint(self) -> QSize:
        side = self.fontMetrics().height()
        return QSize(side, side)

    def paintEvent(self, _event: QPaintEvent) -> None:
        radius = min(self.width(), self.height()) / 2 - 1.5
        middle = QPointF(self.width() / 2, self.height() / 2)
        with Painter(self) as painter:
            paint_lamp(painter, middle, radius, self._color if self.lit else "")


class Leds(QWidget):
    def __init__(self, parent: QWidget | None = None, *, stacked: bool = False) -> None:
        super().__init__(parent)
        self._patterns = ("", "")
        self._since = now()
        self._motion = Animation(self, self._on_frame)
        self.lamps = (Lamp("led_red", self), Lamp("led_green", self))
        self._labels = (ElidedLabel("", self), ElidedLabel("", self))
        pairs = zip(self.lamps, self._labels, strict=True)
        lamps = ((row(lamp, (label, 1), margins=0), 1) for lamp, label in pairs)
        (column if stacked else row)(*lamps, into=self, margins=0)
        self.show_patterns(("off", "off"))

    def show_patterns(
        self, patterns: tuple[str, str], words: Sequence[str] = ("", ""), meaning: str = ""
    ) -> None:
        """Show a pattern and a description for each LED. `meaning`: description for tool tips."""
        self._patterns = patterns
        names = tr("Red"), tr("Green")
        for lamp, label, name, text in zip(self.lamps, self._labels, names, words, strict=True):
            label.setText(tr("{0}: {1}").format(name, text) if text else name)
            parts = tr("{0} LED").format(name), meaning or text
            lamp.setAccessibleName(": ".join(filter(None, parts)))
            for widget in (lamp, label):
                widget.setToolTip(plain(lamp.accessibleName()))
        self._run()

    def show_moment(self, seconds: float) -> None:
        """Show the patterns `seconds` after their start, until the next frame."""
        for index, lamp in enumerate(self.lamps):
            lamp.set_lit(is_lit(self._patterns[index], seconds, second=index == 1))

    def _on_frame(self, _seconds: float = 0.0) -> None:
        self.show_moment(now() - self._since if self._motion.is_enabled else 0.0)

    def _run(self) -> None:
        self._on_frame()
        self._motion.run(any(pattern not in {"on", "off"} for pattern in self._patterns))

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._run()
