"""Widgets around a plot for events, curve names and values at the cursor."""

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
"""Theme colour and word for each kind of event."""

MAX_MARKS = 200  # events in one plot; newer events take precedence
_HOVER_DISTANCE = 6  # pixels between mouse and event
_MAX_SHIFT = 60  # pixels by which a word may move left of its event
_READOUT_DISTANCE = 8  # pixels between cursor and readout


def value_text(value: float, unit: str, *, mean: bool = False) -> str:
    """Format a value with its unit, or a count with its sign. `mean`: add one decimal place."""
    if not math.isfinite(value):
        return NO_VALUE
    text = f"{value:+.0f}" if round(value) else "0"
    if unit:
        text = f"{Number(value):.{3 if mean else 2}f} {unit}"
    elif mean:
        text = f"{Number(value):.1f}"
    return text.replace("-", MINUS)


def charge_text(statistics: Statistics) -> str:
    """Format the charge of a current in Ah, or in mAh below 1 Ah."""
    if not statistics.seconds:
        return NO_VALUE
    charge = statistics.integral / 3600
    text = f"{Number(charge):.3f} Ah" if abs(charge) >= 1 else f"{Number(charge * 1000):.2f} mAh"
    return text.replace("-", MINUS)


class EventMarks(Painted):
    """Strip above the plot with words for the newest events. Tool tips show the events' texts."""

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

    def paintEvent(self, _event: QPaintEvent) -> None:
        metrics, end = self.fontMetrics(), float(self.width())
        with Painter(self) as painter:
            for x, marked in reversed(self.marks):
                color, noun = EVENT_LOOKS[marked.kind]
                word = tr(noun)
                width = metrics.horizontalAdvance(word) + 4.0
                left = max(0.0, min(x - width / 2, end - width))
                if left + width > end or x - (left + width / 2) > _MAX_SHIFT:
                    return
                painter.setPen(theme().color(color))
                box = QRectF(left, 0, width, metrics.height())
                painter.drawText(box, Qt.AlignmentFlag.AlignCenter, word)
                painter.drawLine(int(x), self.height() - 2, int(x), self.height())
                end = left - 4

    def _near(self, x: float) -> list[Event]:
        distance = max(_HOVER_DISTANCE, self.fontMetrics().averageCharWidth() * 2)
        return [event for mark_x, event in self.marks if abs(mark_x - x) <= distance]

    def event(self, event: QEvent) -> bool:
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            texts = [near.text for near in self._near(event.pos().x())]
            QToolTip.showText(event.globalPos(), plain("\n".join(texts)), self)
            return True
        return super().event(event)


class CurveTags(Painted):
    """Strip to the right of the plot with a tag at the end of each curve."""

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

    def paintEvent(self, _event: QPaintEvent) -> None:
        ends = sorted((y, name) for name, y in self._heights.items() if name in self._traces)
        height = self.fontMetrics().height() + 1.0
        centers = spread([y for y, _ in ends], [height] * len(ends), 0, self.height(), 2)
        if centers is None:
            return
        color = theme().color
        with Painter(self) as painter:
            for (_, name), center in zip(ends, centers, strict=True):
                box = QRectF(1, center - height / 2, self.width() - 2, height)
                painter.setPen(Qt.PenStyle.NoPen)
                painter.setBrush(color(self._traces[name].color))
                painter.drawRoundedRect(box, 3, 3)
                painter.setPen(color("plot_background"))
                painter.drawText(box, Qt.AlignmentFlag.AlignCenter, self._traces[name].tag)


class Readout(QLabel):
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
        left = x + _READOUT_DISTANCE
        if left + self.width() > frame.right():
            left = x - _READOUT_DISTANCE - self.width()
        self.move(int(max(left, frame.left())), int(frame.top()) + 4)
        self.show()
