"""A gauge of a servo's real position and its goal."""

from PySide6.QtCore import QPointF, QRectF, QSize
from PySide6.QtGui import QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QStyle, QWidget

from trex_gui.devices.aracna.protocol.units import HIGHEST
from trex_gui.ui.theme.theme import theme

_HEIGHT, _LEAST, _USUAL = 14, 26, 70
_RADIUS = 4.5


class ServoGauge(QWidget):
    """A disc at the position, a line at the goal; the disc is hollow without torque."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._shown: tuple[int, int, bool] = (0, 0, False)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        theme().changed.connect(self.update)

    @property
    def position(self) -> int:
        """Position in units."""
        return self._shown[0]

    def show_servo(self, position: int, goal: int, *, holds: bool) -> None:
        """Show position and goal in units, 0-1023, and whether the servo has torque."""
        shown = (position, goal, holds)
        if shown != self._shown:
            self._shown = shown
            self.update()

    def sizeHint(self) -> QSize:
        return QSize(_USUAL, _HEIGHT)

    def minimumSizeHint(self) -> QSize:
        return QSize(_LEAST, _HEIGHT)

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        color = theme().color
        position, goal, holds = self._shown
        enabled = self.isEnabled()
        middle = self.height() / 2
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.setPen(QPen(color("track_edge")))
            painter.setBrush(color("track" if enabled else "track_off"))
            left, right = self._x_of(0), self._x_of(HIGHEST)
            painter.drawRoundedRect(QRectF(left, middle - 2.5, right - left, 5), 2, 2)
            if not enabled:
                return
            if holds:
                painter.setPen(QPen(color("mark"), 2))
                x = self._x_of(goal)
                painter.drawLine(QPointF(x, 0), QPointF(x, self.height()))
            painter.setPen(QPen(color("bar"), 1.5))
            painter.setBrush(color("bar" if holds else "track"))
            painter.drawEllipse(QPointF(self._x_of(position), middle), _RADIUS, _RADIUS)

    def _x_of(self, value: int) -> float:
        edge = int(_RADIUS) + 1
        room = self.width() - 2 * edge
        return edge + QStyle.sliderPositionFromValue(0, HIGHEST, value, room) + 0.5
