"""Around a plot: events above it, tags of the curves beside it, values at the cursor."""

import math
from collections.abc import Collection, Sequence

from PySide6.QtCore import QEvent, QRectF, QSize, Qt
from PySide6.QtGui import QHelpEvent, QPaintEvent, QPalette
from PySide6.QtWidgets import QLabel, QSizePolicy, QToolTip, QWidget

from trex_gui.core.events import Event, EventKind
from trex_gui.core.translation import Number, tr, tr_noop
from trex_gui.ui.plotting.axes import clock_text, spread
from trex_gui.ui.plotting.history import Statistics
from trex_gui.ui.plotting.traces import TraceInfo, Traces
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.bar import MINUS, NO_VALUE
from trex_gui.ui.widgets.builders import plain
from trex_gui.ui.widgets.painted import Painted, Painter

EVENT_LOOKS = {
    EventKind.APPLY: ("dirty", tr_noop("Apply")),
    EventKind.STOP: ("danger", tr_noop("Stop")),
    EventKind.FAULT: ("danger", tr_noop("Fault")),
    EventKind.OVER_LIMIT: ("warning", tr_noop("Limit")),
    EventKind.TIMEOUT: ("warning", tr_noop("Timeout")),
    EventKind.LINK: ("info", tr_noop("Line")),
    EventKind.NOTE: ("muted", tr_noop("Note")),
}
"""Colour of the theme for each kind of event, and the word beside it."""

MAX_MARKS = 200  # newest events that are marked in one plot
_NEAR = 6  # pixels around an event within which the mouse finds it
_FAR = 60  # pixels that a word may move to the left to make space for newer words
_BESIDE = 8  # pixels between the cursor and its values


def value_text(value: float, unit: str, *, mean: bool = False) -> str:
    """Format a value with two decimals and its unit, or a plain count with its sign.

    A `mean` has one decimal more, because it is known better than a single sample.
    """
    if not math.isfinite(value):
        return NO_VALUE
    text = f"{value:+.0f}" if round(value) else "0"
    if unit:
        text = f"{Number(value):.{3 if mean else 2}f} {unit}"
    elif mean:
        text = f"{Number(value):.1f}"
    return text.replace("-", MINUS)


def charge_text(found: Statistics) -> str:
    """Return a current's charge in Ah, below 1 Ah in mAh."""
    if not found.seconds:
        return NO_VALUE
    charge = found.integral / 3600
    text = f"{Number(charge):.3f} Ah" if abs(charge) >= 1 else f"{Number(charge * 1000):.2f} mAh"
    return text.replace("-", MINUS)


class EventMarks(Painted):
    """Strip above the plot with a word for each event. The tool tip has the whole text."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.marks: list[tuple[float, Event]] = []
        self.setObjectName("eventMarks")
        self.setAccessibleName(tr("Events in the plot"))
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

    def set_marks(self, marks: list[tuple[float, Event]]) -> None:
        if marks != self.marks:
            self.marks = marks
            self.update()

    def sizeHint(self) -> QSize:
        return QSize(100, self.fontMetrics().height() + 2)

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002 - it is small
        metrics, end = self.fontMetrics(), float(self.width())
        with Painter(self) as painter:
            for x, marked in reversed(self.marks):
                color, noun = EVENT_LOOKS[marked.kind]
                word = tr(noun)
                wide = metrics.horizontalAdvance(word) + 4.0
                left = max(0.0, min(x - wide / 2, end - wide))
                if left + wide > end or x - (left + wide / 2) > _FAR:
                    return
                painter.setPen(theme().color(color))
                box = QRectF(left, 0, wide, metrics.height())
                painter.drawText(box, Qt.AlignmentFlag.AlignCenter, word)
                painter.drawLine(int(x), self.height() - 2, int(x), self.height())
                end = left - 4

    def _near(self, x: float) -> list[Event]:
        reach = max(_NEAR, self.fontMetrics().averageCharWidth() * 2)
        return [event for at, event in self.marks if abs(at - x) <= reach]

    def event(self, event: QEvent) -> bool:
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            near = self._near(event.pos().x())
            QToolTip.showText(event.globalPos(), plain("\n".join(one.text for one in near)), self)
            return True
        return super().event(event)


class CurveTags(Painted):
    """Strip right of the plot with the tag of each curve at its newest value."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self._traces: dict[str, TraceInfo] = {}
        self.setAccessibleName(tr("Names of the curves"))
        self._heights: dict[str, float] = {}
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Preferred)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)

    def set_traces(self, traces: Sequence[TraceInfo]) -> None:
        self._traces = {trace.name: trace for trace in traces if trace.tag}

    def spoken_state(self) -> str:
        return ", ".join(self._traces[name].label for name in self._heights if name in self._traces)

    def set_heights(self, heights: dict[str, float]) -> None:
        if heights != self._heights:
            self._heights = heights
            self.update()

    def sizeHint(self) -> QSize:
        metrics = self.fontMetrics()
        widths = [metrics.horizontalAdvance(trace.tag) for trace in self._traces.values()]
        return QSize(max(widths) + metrics.averageCharWidth() + 4 if widths else 0, 0)

    def paintEvent(self, event: QPaintEvent) -> None:  # noqa: ARG002 - it is small
        ends = sorted((y, name) for name, y in self._heights.items() if name in self._traces)
        height = self.fontMetrics().height() + 1.0
        centres = spread([y for y, _ in ends], [height] * len(ends), 0, self.height(), 2)
        if centres is None:
            return
        color = theme().color
        with Painter(self) as painter:
            for (_, name), centre in zip(ends, centres, strict=True):
                box = QRectF(1, centre - height / 2, self.width() - 2, height)
                painter.setPen(Qt.PenStyle.NoPen)
                painter.setBrush(color(self._traces[name].color))
                painter.drawRoundedRect(box, 3, 3)
                painter.setPen(color("plot_background"))
                painter.drawText(box, Qt.AlignmentFlag.AlignCenter, self._traces[name].tag)


class Readout(QLabel):
    """Box beside the cursor, with the time and the values there."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("cursorReadout")
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.setAutoFillBackground(True)
        self.setBackgroundRole(QPalette.ColorRole.ToolTipBase)
        self.setForegroundRole(QPalette.ColorRole.ToolTipText)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setMargin(3)
        self.hide()

    def show_values(
        self, source: Traces, time: float, mark: float | None, origin: float, shown: Collection[str]
    ) -> None:
        """Show a time, counted from `origin`, and the values at this time."""
        lines = [clock_text(time - origin)]
        if mark is not None:
            since = f"{Number(time - mark):+.3f} s".replace("-", MINUS)
            lines[0] = tr("{0} ({1} from the mark)").format(lines[0], since)
        for trace in source.traces:
            value = source.value_at(trace.name, time)
            if trace.name in shown and math.isfinite(value):
                shown_value = value_text(value, trace.unit)
                lines.append(tr("{0}: {1}").format(trace.label, shown_value))
        text = "\n".join(lines)
        if text != self.text():
            self.setText(text)
            self.adjustSize()

    def show_beside(self, x: float, frame: QRectF) -> None:
        """Show the box right of a pixel, or left if space is short, within the frame."""
        left = x + _BESIDE
        if left + self.width() > frame.right():
            left = x - _BESIDE - self.width()
        self.move(int(max(left, frame.left())), int(frame.top()) + 4)
        self.show()
