"""Figures and events side by side: figures get the room that they need first."""

from PySide6.QtCore import QEvent, QObject, Qt, Slot
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QSplitter, QWidget

from trex_gui.ui.plotting.event_list import EventList
from trex_gui.ui.plotting.table import TraceTableView

_LEAST_EVENTS = 12  # letters


class Below(QSplitter):
    """Shares its width anew when it changes, until a person has moved the handle."""

    def __init__(
        self, figures: TraceTableView, events: EventList, parent: QWidget | None = None
    ) -> None:
        super().__init__(Qt.Orientation.Horizontal, parent)
        self._figures = figures
        self._is_moved = False
        events.setMinimumWidth(events.fontMetrics().averageCharWidth() * _LEAST_EVENTS)
        self.addWidget(figures)
        self.addWidget(events)
        self.setChildrenCollapsible(False)
        self._least_events = events.minimumWidth()

        figures.horizontalHeader().geometriesChanged.connect(self._share)
        figures.horizontalHeader().sectionResized.connect(self._share)
        figures.verticalScrollBar().installEventFilter(self)
        self.splitterMoved.connect(self._on_moved)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._share()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """A bar that comes or goes takes or gives room."""
        if event.type() in {QEvent.Type.Show, QEvent.Type.Hide}:
            self._share()
        return super().eventFilter(watched, event)

    @Slot()
    def _share(self) -> None:
        room = self.width() - self.handleWidth()
        if self._is_moved or room <= 0:
            return
        figures = min(self._figures.whole_width(), room - self._least_events)
        if self.sizes()[0] != figures:
            self.setSizes([figures, room - figures])

    @Slot()
    def _on_moved(self) -> None:
        self._is_moved = True
