"""The events of a plot's source, newest at the bottom; choosing one shows it in the plot."""

from PySide6.QtCore import QSize, Qt, Signal, Slot
from PySide6.QtGui import QIcon, QPainter, QPaintEvent, QPixmap
from PySide6.QtWidgets import QListWidget, QListWidgetItem, QWidget

from trex_gui.ui.event_log import Event
from trex_gui.ui.plotting.marks import EVENT_COLORS
from trex_gui.ui.plotting.plot import TracePlot
from trex_gui.ui.theme.theme import theme

MAX_LISTED = 1000
"""Events listed: the newest."""


class EventList(QListWidget):
    """A line for each event: its time since the origin of the plot, and its text.

    Signals:
        chosen: the `Event` to show.
    """

    chosen = Signal(object)

    def __init__(self, plot: TracePlot, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._plot = plot
        self._events: tuple[Event, ...] = ()
        self._origin: float | None = None
        self.setObjectName("eventList")
        self.setAccessibleName(self.tr("Events"))
        self.setUniformItemSizes(True)
        self.setTextElideMode(Qt.TextElideMode.ElideRight)
        self.itemActivated.connect(self._on_chosen)
        self.itemClicked.connect(self._on_chosen)
        theme().changed.connect(self._fill)
        self._describe()

    def sizeHint(self) -> QSize:
        metrics = self.fontMetrics()
        return QSize(metrics.averageCharWidth() * 34, metrics.height() * 5)

    def refresh(self) -> None:
        """Take the events that there are now."""
        events: tuple[Event, ...] = ()
        if self._plot.source is not None:
            found = self._plot.source.events_between(float("-inf"), float("inf"))
            events = tuple(found[-MAX_LISTED:])
        if (events, self._plot.origin) != (self._events, self._origin):
            self._events, self._origin = events, self._plot.origin
            self._fill()
            self.scrollToBottom()
            self._describe()

    @Slot()
    def _fill(self) -> None:
        self.clear()
        for event in self._events:
            dot = QPixmap(8, 8)
            dot.fill(theme().color(EVENT_COLORS[event.kind]))
            text = f"{self._plot.text_of_time(event.time)}  {event.text}"
            item = QListWidgetItem(QIcon(dot), text, self)
            item.setToolTip(event.text)

    @property
    def empty_text(self) -> str:
        """What is shown instead of events; empty when there are some."""
        if self._events:
            return ""
        return self.tr("No events yet. Stops, Apply, faults and limits will be listed here.")

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if text := self.empty_text:
            with QPainter(self.viewport()) as painter:
                painter.setPen(theme().color("muted"))
                box = self.viewport().rect().adjusted(8, 4, -8, -4)
                how = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap
                if not box.contains(painter.boundingRect(box, how, text)):
                    text = self.tr("No events yet")
                painter.drawText(box, how, text)

    @Slot()
    def _describe(self) -> None:
        """Set the description that a screen reader reads."""
        shown = self.tr("Choosing one shows its place in the plot.")
        self.setAccessibleDescription(self.empty_text or shown)

    def choose(self, event: Event) -> None:
        """Select an event, as the user does."""
        if event in self._events:
            self.setCurrentRow(self._events.index(event))

    @Slot(QListWidgetItem)
    def _on_chosen(self, item: QListWidgetItem) -> None:
        self.chosen.emit(self._events[self.row(item)])
