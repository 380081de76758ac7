"""The name of a curve beside a piece of its line."""

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QLabel, QWidget

from trex_gui.ui.theme.theme import theme


class LegendKey(QLabel):
    """Names a curve; `color` is a name of the theme. Without a style it is a dot."""

    def __init__(
        self,
        text: str,
        color: str,
        parent: QWidget,
        style: Qt.PenStyle | None = Qt.PenStyle.SolidLine,
    ) -> None:
        super().__init__(text, parent)
        self._color = color
        self._style = style
        self._sample = self.fontMetrics().averageCharWidth() * 3
        self.setContentsMargins(16 if style is None else self._sample * 4 // 3, 0, 0, 0)
        theme().changed.connect(self.update)

    def set_color(self, color: str) -> None:
        """Change the color."""
        if color != self._color:
            self._color = color
            self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        color, middle = theme().color(self._color), self.height() // 2
        with QPainter(self) as painter:
            if self._style is None:
                painter.setRenderHint(QPainter.RenderHint.Antialiasing)
                painter.setPen(Qt.PenStyle.NoPen)
                painter.setBrush(color)
                painter.drawEllipse(QPointF(6, middle), 5, 5)
            else:
                painter.setPen(QPen(color, 2, self._style))
                painter.drawLine(0, middle, self._sample, middle)
