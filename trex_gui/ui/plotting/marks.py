"""Events in a plot: a line through it, and a word above the line."""

from collections.abc import Sequence

from PySide6.QtCore import QCoreApplication, QEvent, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QHelpEvent, QMouseEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QSizePolicy, QToolTip, QWidget

from trex_gui.ui.devices.event_log import Event, EventKind
from trex_gui.ui.plotting.axis_ticks import spread
from trex_gui.ui.theme.theme import theme

COLOURS: dict[EventKind, str] = {
    EventKind.APPLY: "dirty",
    EventKind.STOP: "danger",
    EventKind.FAULT: "danger",
    EventKind.OVER_LIMIT: "warning",
    EventKind.TIMEOUT: "warning",
    EventKind.LINK: "info",
    EventKind.NOTE: "muted",
}
"""The theme's colours of the kinds; a word stands beside each, so colour tells nothing alone."""

MOST_MARKS = 200
"""Events marked in one picture; more would be a wall, and the list has them all."""

_NEAR = 6
"""Pixels from a line at which its tool tip still shows."""


_FAR = 60
"""Pixels that a word may stand beside its line to make room for others."""


def word_of(kind: EventKind) -> str:
    """Return what stands above the line of an event of this kind."""
    tr = QCoreApplication.translate
    return {
        EventKind.APPLY: tr("marks", "Apply"),
        EventKind.STOP: tr("marks", "Stop"),
        EventKind.FAULT: tr("marks", "Fault"),
        EventKind.OVER_LIMIT: tr("marks", "Limit"),
        EventKind.TIMEOUT: tr("marks", "Timeout"),
        EventKind.LINK: tr("marks", "Line"),
        EventKind.NOTE: tr("marks", "Note"),
    }[kind]


def places(centres: Sequence[float], widths: Sequence[float], room: float) -> list[float]:
    """Return where words begin that stand at rising places; only the last ones that fit."""
    for first in range(len(centres)):
        moved = spread(centres[first:], widths[first:], 0, room, 4)
        if moved is not None and all(
            abs(new - old) <= _FAR for new, old in zip(moved, centres[first:], strict=True)
        ):
            return [new - wide / 2 for new, wide in zip(moved, widths[first:], strict=True)]
    return []


class MarkStrip(QWidget):
    """The strip above the plot with the words; point at one to read the whole event.

    Signals:
        chosen: an `Event` was clicked.
    """

    chosen = Signal(object)

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._marks: list[tuple[float, Event]] = []
        self._words = {kind: word_of(kind) for kind in EventKind}
        self.setObjectName("eventMarks")
        self.setAccessibleName(self.tr("Events in the plot"))
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        theme().changed.connect(self.update)

    def set_marks(self, marks: Sequence[tuple[float, Event]]) -> None:
        """Mark these events at these pixels from the left, which rise."""
        if list(marks) != self._marks:
            self._marks = list(marks)
            self.update()

    @property
    def marks(self) -> Sequence[tuple[float, Event]]:
        """What is marked, and where."""
        return self._marks

    def sizeHint(self) -> QSize:
        return QSize(100, self.fontMetrics().height() + 2)

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002 - it is small
        metrics = self.fontMetrics()
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            for x, left, word, kind in self._places():
                painter.setPen(theme().color(COLOURS[kind]))
                box = QRectF(left, 0, metrics.horizontalAdvance(word) + 4, metrics.height())
                painter.drawText(box, Qt.AlignmentFlag.AlignCenter, word)
                painter.drawLine(int(x), self.height() - 2, int(x), self.height())

    def _near(self, x: float) -> list[Event]:
        words = [(abs(at - x), one) for at, one in self._marks]
        reach = max(_NEAR, self.fontMetrics().averageCharWidth() * 2)
        return [one for distance, one in words if distance <= reach]

    def _places(self) -> list[tuple[float, float, str, EventKind]]:
        """Return each mark's pixel, where its word begins, and the word; the newest that fit."""
        marks = [(x, self._words[one.kind]) for x, one in self._marks]
        widths = [self.fontMetrics().horizontalAdvance(word) + 4.0 for _, word in marks]
        lefts = places([x for x, _ in marks], widths, self.width())
        hidden = len(marks) - len(lefts)
        return [
            (x, left, word, one.kind)
            for (x, word), (_, one), left in zip(
                marks[hidden:], self._marks[hidden:], lefts, strict=True
            )
        ]

    def event(self, event: QEvent) -> bool:
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            near = self._near(event.pos().x())
            QToolTip.showText(event.globalPos(), "\n".join(one.text for one in near), self)
            return True
        return super().event(event)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        near = self._near(event.position().x())
        if near:
            self.chosen.emit(near[-1])
