"""What stands beside a plot and names its curves: the tags at the right."""

from collections.abc import Sequence
from dataclasses import dataclass

from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from trex_gui.ui.plotting.axis_ticks import spread
from trex_gui.ui.theme.theme import theme


@dataclass(frozen=True, slots=True)
class CurveStyle:
    """How one curve looks; `color` is a name of the theme."""

    name: str  # by which a curve is found
    label: str  # for people: "Motor 1"
    color: str
    tag: str = ""  # one or two letters at the end of the line: "1"


class Tags(QWidget):
    """The strip right of the plot where each curve is named at its newest value."""

    def __init__(self, curves: Sequence[CurveStyle], parent: QWidget) -> None:
        super().__init__(parent)
        self._styles = {style.name: style for style in curves if style.tag}
        self._heights: dict[str, float] = {}
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Preferred)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        theme().changed.connect(self.update)

    def set_heights(self, heights: dict[str, float]) -> None:
        """Point at these heights, in pixels from the top."""
        if heights != self._heights:
            self._heights = heights
            self.update()

    def sizeHint(self) -> QSize:
        if not self._styles:
            return QSize(0, 0)
        widest = max(self.fontMetrics().horizontalAdvance(s.tag) for s in self._styles.values())
        return QSize(widest + self.fontMetrics().averageCharWidth() + 4, 0)

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002 - it is small
        named = sorted(
            (height, name) for name, height in self._heights.items() if name in self._styles
        )
        tall = self.fontMetrics().height() + 1.0
        heights = [height for height, _ in named]
        centres = spread(heights, [tall] * len(named), 0, self.height(), 2)
        if centres is None:
            return
        color = theme().color
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            for (_, name), centre in zip(named, centres, strict=True):
                style = self._styles[name]
                box = QRectF(1, centre - tall / 2, self.width() - 2, tall)
                painter.setPen(Qt.PenStyle.NoPen)
                painter.setBrush(color(style.color))
                painter.drawRoundedRect(box, 3, 3)
                painter.setPen(color("plot_background"))
                painter.drawText(box, Qt.AlignmentFlag.AlignCenter, style.tag)
