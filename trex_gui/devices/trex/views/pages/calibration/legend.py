"""What the lines of the curve mean, and the live value in words."""

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from trex_gui.ui.theme.theme import theme

_SWATCH = 22


class CurveLegend(QWidget):
    """One line: the live dot with its value, the curve, and the stored one while it differs."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("curveLegend")
        self.setAccessibleName(self.tr("Live value"))
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self._live = ""
        self._known = False
        self._differs = False
        self._is_live = True
        theme().changed.connect(self.update)

    @property
    def live(self) -> str:
        """The live value in words."""
        return self._live

    def set_live(self, text: str) -> None:
        """Show the live value."""
        if text != self._live:
            self._live = text
            self.setAccessibleDescription(text)
            self.update()

    def set_curves(self, known: bool, *, differs: bool, live: bool) -> None:
        """Say which lines there are: none, one, or a dashed second one with what is stored."""
        look = (known, differs, live)
        if look != (self._known, self._differs, self._is_live):
            self._known, self._differs, self._is_live = look
            self.update()

    def sizeHint(self) -> QSize:
        return QSize(200, self.fontMetrics().height() + 4)

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002 - it is small
        color, metrics, middle = theme().color, self.fontMetrics(), self.height() / 2
        texts = [(self.tr("stored in the board"), "motor1", False)]
        if not self._known:
            texts = []
        elif not self._is_live:
            texts = [(self.tr("as last seen"), "motor1", False)]
        elif self._differs:
            texts = [
                (self.tr("after Apply"), "motor1", False),
                (self.tr("stored now"), "muted", True),
            ]
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(color("motor2" if self._is_live else "muted"))
            painter.drawEllipse(QPointF(6, middle), 5, 5)
            painter.setPen(color("window_text"))
            vertical = Qt.AlignmentFlag.AlignVCenter
            painter.drawText(QRectF(16, 0, self.width(), self.height()), vertical, self._live)
            x = float(self.width())
            for text, name, dashed in reversed(texts):
                width = metrics.horizontalAdvance(text) + 1
                x -= width
                painter.setPen(color("window_text"))
                painter.drawText(QRectF(x, 0, width, self.height()), vertical, text)
                x -= _SWATCH + 6
                style = Qt.PenStyle.DashLine if dashed else Qt.PenStyle.SolidLine
                painter.setPen(QPen(color(name), 1 if dashed else 2, style))
                painter.drawLine(QPointF(x, middle), QPointF(x + _SWATCH, middle))
                x -= 16
