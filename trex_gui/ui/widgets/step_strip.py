"""The numbered steps of a dialog in a row."""

from collections.abc import Collection, Sequence

from PySide6.QtCore import QPointF, QRect, QRectF, QSize, Qt
from PySide6.QtGui import QFont, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from trex_gui.core.translation import tr
from trex_gui.ui.theme.theme import follow_theme, theme
from trex_gui.ui.widgets.painted import Painted, Painter

_GAP = 8  # pixels between a circle, its title and the line to the next circle
_LEAST_LINE = 16


class StepStrip(Painted):
    """Ticks the steps that are done; names all steps, or the current one where space is short."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._steps: Sequence[str] = ()
        self._now = 0
        self._undone: Collection[str] = ()
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        follow_theme(self, "room", self.updateGeometry)

    def show_steps(self, steps: Sequence[str], now: int, undone: Collection[str] = ()) -> None:
        """`now` may be the number of steps, when all are done.

        `undone`: steps that are not done although a later one is shown.
        """
        if (steps, now, undone) == (self._steps, self._now, self._undone):
            return
        self._steps, self._now, self._undone = steps, now, undone
        spoken = tr("All steps are done.")
        if now < len(steps):
            spoken = tr("Step {0} of {1}: {2}.").format(now + 1, len(steps), steps[now])
        if passed := [step for step in steps[:now] if step in undone]:
            spoken = f"{spoken} {tr('Not done: {0}.').format(', '.join(passed))}"
        self.setAccessibleName(spoken)
        self.updateGeometry()
        self.update()

    def minimumSizeHint(self) -> QSize:
        widest = max((self._width_of(step) for step in self._steps), default=0)
        circles = (len(self._steps) - 1) * (self._side() + 2 * _GAP + _LEAST_LINE)
        return QSize(widest + circles + self._side(), self._side() + 4)

    def sizeHint(self) -> QSize:
        lines = len(self._steps) * (self._side() + 2 * _GAP + _LEAST_LINE)
        return QSize(sum(map(self._width_of, self._steps)) + lines, self._side() + 4)

    def _side(self) -> int:
        """Return the diameter of a circle."""
        return round(1.7 * self.fontMetrics().height())

    def _width_of(self, title: str) -> int:
        return round(1.1 * self.fontMetrics().horizontalAdvance(title)) + 2 * _GAP

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        side, color = self._side(), theme().color
        names_all = self.sizeHint().width() <= self.width()
        shown = [names_all or number == self._now for number in range(len(self._steps))]
        widths = [
            side + (self._width_of(step) if named else _GAP)
            for step, named in zip(self._steps, shown, strict=True)
        ]
        free = max(0, self.width() - sum(widths)) / max(1, len(widths) - 1)
        line, left, top = min(free, 6.0 * side), 1.0, (self.height() - side) / 2
        with Painter(self) as painter:
            for number, (step, width) in enumerate(zip(self._steps, widths, strict=True)):
                self._paint_circle(painter, QRectF(left, top, side - 2, side), number)
                if shown[number]:
                    font = QFont(self.font())
                    is_now = number == self._now
                    font.setWeight(QFont.Weight.DemiBold if is_now else QFont.Weight.Normal)
                    painter.setFont(font)
                    painter.setPen(color("window_text" if is_now else "muted"))
                    place = QRect(round(left) + side + _GAP, 0, width, self.height())
                    painter.drawText(place, Qt.AlignmentFlag.AlignVCenter, step)
                left += width
                if number < len(widths) - 1:
                    painter.setPen(QPen(color("hairline"), 2))
                    middle = self.height() / 2
                    painter.drawLine(QPointF(left, middle), QPointF(left + line - _GAP, middle))
                left += line

    def _paint_circle(self, painter: QPainter, place: QRectF, number: int) -> None:
        color, middle = theme().color, place.center()
        is_undone = self._steps[number] in self._undone
        is_filled = number == self._now or (number < self._now and not is_undone)
        circle = QRectF(0, 0, place.width(), place.width())
        circle.moveCenter(middle)
        ink = color("primary_text" if is_filled else "muted")
        painter.setPen(QPen(color("primary" if is_filled else "outline"), 1.5))
        painter.setBrush(color("primary" if is_filled else "base"))
        painter.drawEllipse(circle)
        unit = circle.width() / 8
        painter.setPen(QPen(ink, max(1.5, unit / 2), c=Qt.PenCapStyle.RoundCap))
        if number >= self._now:
            font = QFont(self.font())
            font.setWeight(QFont.Weight.DemiBold)
            painter.setFont(font)
            painter.drawText(circle, Qt.AlignmentFlag.AlignCenter, str(number + 1))
        elif is_undone:
            painter.drawLine(middle - QPointF(1.5 * unit, 0), middle + QPointF(1.5 * unit, 0))
        else:
            foot = middle + QPointF(-0.4 * unit, 1.2 * unit)
            painter.drawLine(middle + QPointF(-1.6 * unit, 0), foot)
            painter.drawLine(foot, middle + QPointF(1.7 * unit, -1.2 * unit))
