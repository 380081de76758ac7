"""The events of a plot's source, newest at the bottom; choosing one shows it in the plot."""

from collections.abc import Sequence

from PySide6.QtCore import (
    QAbstractListModel,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    QSize,
    Qt,
    Signal,
    Slot,
)
from PySide6.QtGui import QPainter, QPaintEvent, QPixmap
from PySide6.QtWidgets import QListView, QWidget

from trex_gui.ui.devices.event_log import Event
from trex_gui.ui.plotting.marks import EVENT_COLORS
from trex_gui.ui.plotting.plot import TracePlot
from trex_gui.ui.theme.theme import theme

MAX_LISTED = 1000
"""Events listed: the newest."""

Index = QModelIndex | QPersistentModelIndex


class EventModel(QAbstractListModel):
    """A line for each event: its time since the origin, and its text."""

    def __init__(self, plot: TracePlot, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._plot = plot
        self._events: Sequence[Event] = ()
        self._origin: float | None = None

    def refresh(self) -> None:
        """Take the events that there are now."""
        events: Sequence[Event] = ()
        if self._plot.source is not None:
            events = self._plot.source.events_between(float("-inf"), float("inf"))[-MAX_LISTED:]
        if tuple(events) != self._events or self._origin != self._plot.origin:
            self.beginResetModel()
            self._events = tuple(events)
            self._origin = self._plot.origin
            self.endResetModel()

    def event_at(self, index: Index) -> Event:
        """Return the event of a row."""
        return self._events[index.row()]

    def row_of(self, event: Event) -> int:
        """Return the row of an event; -1 when it is not listed."""
        return self._events.index(event) if event in self._events else -1

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008 - as Qt has it
        return 0 if parent.isValid() else len(self._events)

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        if not index.isValid():
            return None
        event = self._events[index.row()]
        match role:
            case Qt.ItemDataRole.DisplayRole:
                return f"{self._plot.text_of_time(event.time)}  {event.text}"
            case Qt.ItemDataRole.ToolTipRole:
                return event.text
            case Qt.ItemDataRole.DecorationRole:
                dot = QPixmap(8, 8)
                dot.fill(theme().color(EVENT_COLORS[event.kind]))
                return dot
        return None


class EventList(QListView):
    """The list of events.

    Signals:
        chosen: the `Event` to show.
    """

    chosen = Signal(object)

    def __init__(self, model: EventModel, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._events = model
        self.setObjectName("eventList")
        self.setAccessibleName(self.tr("Events"))
        self.setModel(model)
        self.setUniformItemSizes(True)
        self.setTextElideMode(Qt.TextElideMode.ElideRight)
        self.activated.connect(self._on_activated)
        self.clicked.connect(self._on_activated)
        model.modelReset.connect(self.scrollToBottom)
        model.modelReset.connect(self._describe)
        theme().changed.connect(self.viewport().update)
        self._describe()

    def sizeHint(self) -> QSize:
        metrics = self.fontMetrics()
        return QSize(metrics.averageCharWidth() * 34, metrics.height() * 5)

    @property
    def empty_text(self) -> str:
        """What is shown instead of events; empty when there are some."""
        if self._events.rowCount():
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
        row = self._events.row_of(event)
        if row >= 0:
            self.setCurrentIndex(self._events.index(row, 0))

    @Slot(QModelIndex)
    def _on_activated(self, index: QModelIndex) -> None:
        self.chosen.emit(self._events.event_at(index))
