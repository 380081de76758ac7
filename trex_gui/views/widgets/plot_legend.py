"""What stands around a plot and names its curves: the legend above, the tags at the right."""

from collections.abc import Sequence
from dataclasses import dataclass

from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QWidget

from trex_gui.views.theme import theme
from trex_gui.views.widgets.axis import spread
from trex_gui.views.widgets.bar import MINUS, NO_VALUE


@dataclass(frozen=True, slots=True)
class CurveStyle:
    """How one curve looks; `color` is a name of the theme."""

    name: str  # by which `set_samples` finds it
    label: str  # for people: "Motor 1"
    color: str
    tag: str = ""  # one or two letters at the end of the line: "1"


class LegendEntry(QWidget):
    """A piece of the line, the curve's name, its value now and its limit."""

    def __init__(self, style: CurveStyle, unit: str, parent: QWidget) -> None:
        super().__init__(parent)
        self._style = style
        self._unit = unit
        self._value: float | None = None
        self._limit: float | None = None
        self.setObjectName(f"legend_{style.name}")
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        self.setAccessibleName(style.label)
        theme().changed.connect(self.update)

    def set_value(self, value: float | None) -> None:
        before = self._value_text()
        self._value = value
        if self._value_text() != before:
            self.setAccessibleDescription(self._value_text())
            self.update()

    def set_limit(self, limit: float | None) -> None:
        if limit == self._limit:
            return
        self._limit = limit
        self.updateGeometry()
        self.update()

    def text(self) -> str:
        """What it says, as it would be read out."""
        return " ".join(filter(None, [self._style.label, self._value_text(), self._limit_text()]))

    def _value_text(self) -> str:
        if self._value is None:
            return f"{NO_VALUE} {self._unit}"
        return f"{self._value:.2f} {self._unit}".replace("-", MINUS)

    def _limit_text(self) -> str:
        if self._limit is None:
            return ""
        return self.tr("limit {value}").format(value=f"{self._limit:.2f} {self._unit}")

    def _widths(self) -> tuple[int, int, int, int]:
        metrics = self.fontMetrics()
        swatch = metrics.averageCharWidth() * 3
        name = metrics.horizontalAdvance(self._style.label)
        value = metrics.horizontalAdvance(f"00.00 {self._unit}")
        limit = metrics.horizontalAdvance(self._limit_text())
        return swatch, name, value, limit

    def sizeHint(self) -> QSize:
        gap = self.fontMetrics().averageCharWidth()
        return QSize(sum(self._widths()) + 3 * gap, self.fontMetrics().height() + 4)

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002 - it is small
        swatch, name, value, limit = self._widths()
        gap, height = self.fontMetrics().averageCharWidth(), self.height()
        color = theme().color
        middle = Qt.AlignmentFlag.AlignVCenter
        with QPainter(self) as painter:
            painter.fillRect(0, height // 2 - 1, swatch, 3, color(self._style.color))
            x = swatch + gap
            painter.setPen(color("text"))
            painter.drawText(QRectF(x, 0, name + 1, height), middle, self._style.label)
            x += name + gap
            painter.setPen(color(self._style.color))
            right = middle | Qt.AlignmentFlag.AlignRight
            painter.drawText(QRectF(x, 0, value, height), right, self._value_text())
            x += value + gap
            painter.setPen(color("muted"))
            painter.drawText(QRectF(x, 0, limit + 1, height), middle, self._limit_text())


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
