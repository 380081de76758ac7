"""A piece of a line and its name."""

from PySide6.QtCore import QPoint, QSize, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from trex_gui.ui.theme.theme import theme


class LegendKey(QWidget):
    """Names a curve; `color` is a name of the theme."""

    def __init__(self, text: str, color: str, parent: QWidget, *, dashed: bool = False) -> None:
        super().__init__(parent)
        self._text = text
        self._color = color
        self._dashed = dashed
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        self.setAccessibleName(text)
        theme().changed.connect(self.update)

    @property
    def text(self) -> str:
        """The name."""
        return self._text

    def set_text(self, text: str) -> None:
        """Name it so from now on."""
        if text != self._text:
            self._text = text
            self.setAccessibleName(text)
            self.updateGeometry()
            self.update()

    def sizeHint(self) -> QSize:
        metrics = self.fontMetrics()
        width = metrics.averageCharWidth() * 4 + metrics.horizontalAdvance(self._text) + 2
        return QSize(width, metrics.height() + 4)

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002 - it is small
        unit, middle = self.fontMetrics().averageCharWidth(), self.height() // 2
        style = Qt.PenStyle.DashLine if self._dashed else Qt.PenStyle.SolidLine
        with QPainter(self) as painter:
            painter.setPen(QPen(theme().color(self._color), 2, style))
            painter.drawLine(QPoint(0, middle), QPoint(unit * 3, middle))
            painter.setPen(theme().color("text"))
            rest = self.rect().adjusted(unit * 4, 0, 0, 0)
            painter.drawText(rest, Qt.AlignmentFlag.AlignVCenter, self._text)
