"""Row of numbered steps in a dialog."""

from collections.abc import Collection, Sequence

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from trex_gui.core.translation import tr
from trex_gui.ui.theme.theme import follow_theme, theme
from trex_gui.ui.widgets.circuit import write
from trex_gui.ui.widgets.painted import Painted, Painter

_GAP = 8  # pixels between a circle, its title and the line to the next circle
_MIN_LINE = 16  # pixels; minimum length of a line between two circles


class StepStrip(Painted):
    """Row of steps. If space is short, only the current step has its name beside it."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._steps: Sequence[str] = ()
        self._current = 0
        self._undone: Collection[str] = ()
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        follow_theme(self, "space", self.updateGeometry)

    def show_steps(self, steps: Sequence[str], current: int, undone: Collection[str] = ()) -> None:
        """Show steps. `current`: index of the current step. `undone`: skipped steps."""
        if (steps, current, undone) == (self._steps, self._current, self._undone):
            return
        self._steps, self._current, self._undone = steps, current, undone
        spoken = tr("All steps are done.")
        if current < len(steps):
            spoken = tr("Step {0} of {1}: {2}.").format(current + 1, len(steps), steps[current])
        if skipped := [step for step in steps[:current] if step in undone]:
            spoken = f"{spoken} {tr('Not done: {0}.').format(', '.join(skipped))}"
        self.setAccessibleName(spoken)
        self.updateGeometry()
        self.update()

    def minimumSizeHint(self) -> QSize:
        widest = max((self._width_of(step) for step in self._steps), default=0)
        circles = (len(self._steps) - 1) * (self._diameter() + 2 * _GAP + _MIN_LINE)
        return QSize(widest + circles + self._diameter(), self._diameter() + 4)

    def sizeHint(self) -> QSize:
        lines = len(self._steps) * (self._diameter() + 2 * _GAP + _MIN_LINE)
        return QSize(sum(map(self._width_of, self._steps)) + lines, self._diameter() + 4)

    def _diameter(self) -> int:
        return round(1.7 * self.fontMetrics().height())

    def _width_of(self, title: str) -> int:
        return round(1.1 * self.fontMetrics().horizontalAdvance(title)) + 2 * _GAP

    def paintEvent(self, _event: QPaintEvent) -> None:
        diameter, color, height = self._diameter(), theme().color, self.height()
        shows_all_names = self.sizeHint().width() <= self.width()
        last = len(self._steps) - 1
        widths = [
            diameter + (self._width_of(step) if shows_all_names or index == self._current else _GAP)
            for index, step in enumerate(self._steps)
        ]
        line = max(0.0, self.width() - sum(widths)) / max(1, last)
        left = 1.0
        with Painter(self) as painter:
            for index, (step, width) in enumerate(zip(self._steps, widths, strict=True)):
                self._paint_circle(painter, QPointF(left + diameter / 2, height / 2), index)
                is_current = index == self._current
                if shows_all_names or is_current:
                    rect = QRectF(left + diameter + _GAP, 0, width, height)
                    write(
                        painter,
                        rect,
                        step,
                        "window_text" if is_current else "muted",
                        bold=is_current,
                    )
                left += width + line
                if index < last:
                    painter.setPen(QPen(color("hairline"), 2))
                    start, end = QPointF(left - line, height / 2), QPointF(left - _GAP, height / 2)
                    painter.drawLine(start, end)

    def _paint_circle(self, painter: QPainter, middle: QPointF, index: int) -> None:
        color, radius = theme().color, self._diameter() / 2 - 1
        is_undone = self._steps[index] in self._undone
        is_filled = index == self._current or (index < self._current and not is_undone)
        painter.setPen(QPen(color("primary" if is_filled else "outline"), 1.5))
        painter.setBrush(color("primary" if is_filled else "base"))
        painter.drawEllipse(middle, radius, radius)
        ink = "primary_text" if is_filled else "muted"
        if index >= self._current:
            box = QRectF(middle.x() - radius, middle.y() - radius, 2 * radius, 2 * radius)
            center = Qt.AlignmentFlag.AlignHCenter
            write(painter, box, str(index + 1), ink, bold=True, align=center)
        else:
            painter.setPen(QPen(color(ink), radius / 7))
            tick = ((-0.4, 0.0), (0.4, 0.0)) if is_undone else ((-0.4, 0), (-0.1, 0.3), (0.4, -0.3))
            painter.drawPolyline([middle + QPointF(x, y) * radius for x, y in tick])
