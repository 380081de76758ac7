"""A plot with everything around it: time shown, pause, figures, events, export.

Importing it loads the plotting library: do so when a plot is to be shown.
"""

from PySide6.QtCore import QEvent, Qt, Slot
from PySide6.QtWidgets import (
    QComboBox,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QSplitter,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from trex_gui.ui.devices.event_log import Event
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.plotting.below import Below
from trex_gui.ui.plotting.data.traces import Traces
from trex_gui.ui.plotting.event_list import EventList, EventModel
from trex_gui.ui.plotting.export import TraceExport
from trex_gui.ui.plotting.plot import TracePlot
from trex_gui.ui.plotting.table import TraceTable, TraceTableView
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.theme.theme import theme

WINDOWS = (10, 30, 60, 300, 600, 1800, 3600)
"""Seconds that can be chosen to be shown."""

_EVERY = 8
"""Frames from one renewal of the figures to the next: digits that run cannot be read."""


class TracePanel(QWidget):
    """Shows a source of traces; whoever owns it calls `frame` while the source may grow."""

    def __init__(self, window: float = 30.0, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._frames = 0

        self._note = QLabel(self)
        self._note.setObjectName("currentsNote")
        self._note.setWordWrap(True)
        label = QLabel(self.tr("Show the &last"), self)
        self._window = QComboBox(self)
        self._window.setObjectName("currentsWindow")
        self._window.setAccessibleName(self.tr("Time shown"))
        for seconds in WINDOWS:
            self._window.addItem(self._length_text(seconds), seconds)
        self._window.setCurrentIndex(self._window.findData(int(window)))
        label.setBuddy(self._window)
        self._pause = QPushButton(self.tr("Pa&use"), self)
        self._pause.setObjectName("pauseButton")
        self._pause.setCheckable(True)
        self._hold = QPushButton(self.tr("&Hold peaks"), self)
        self._hold.setObjectName("holdPeaksButton")
        self._hold.setCheckable(True)
        self._hold.setToolTip(
            self.tr("Keep the greatest value of each curve from now on, as a line and a figure")
        )
        self.plot = TracePlot(window, self)
        self.notifier = Notifier(self)
        self.export = TraceExport(self.plot, self.notifier, self)
        self._export_button = QToolButton(self)
        self._export_button.setObjectName("exportButton")
        self._export_button.setText(self.tr("E&xport"))
        self._export_button.setAccessibleName(self.tr("Export"))
        self._export_button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self._export_button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self._export_button.setMenu(self.export.menu)
        set_icon(self._export_button, "save")
        self._table = TraceTable(self.plot, self)
        self._view = TraceTableView(self._table, self)
        self._events = EventModel(self.plot, self)
        self._list = EventList(self._events, self)

        self._bar = QHBoxLayout()
        self._bar.addWidget(self._note, 1)
        self._bar.addWidget(label)
        self._bar.addWidget(self._window)
        self._bar.addWidget(self._pause)
        self._bar.addWidget(self._hold)
        self._bar.addWidget(self._export_button)
        below = Below(self._view, self._list, self)
        both = QSplitter(Qt.Orientation.Vertical, self)
        both.setObjectName("tracesSplitter")
        both.addWidget(self.plot)
        both.addWidget(below)
        both.setStretchFactor(0, 1)
        both.setStretchFactor(1, 0)
        both.setChildrenCollapsible(False)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addLayout(self._bar)
        layout.addWidget(both, 1)

        self._window.activated.connect(self._on_window_chosen)
        self._pause.clicked.connect(self._on_pause_clicked)
        self._hold.toggled.connect(self._on_hold_toggled)
        self.plot.view_changed.connect(self._on_view_changed)
        self.plot.cursor_changed.connect(self._on_cursor_changed)
        self.plot.event_chosen.connect(self._list.choose)
        self._list.chosen.connect(self._on_event_chosen)
        self.notifier.info.connect(self.set_note)
        self.notifier.error.connect(self.set_note)
        theme().changed.connect(self._table.recolour)
        self._show_state()

    def set_source(self, source: Traces) -> None:
        """Show these curves."""
        self.plot.set_source(source)
        self._table.show_source()
        self._view.resizeColumnToContents(0)
        self.refresh()

    @Slot(str)
    def set_note(self, text: str) -> None:
        """Say something at the top left; it stays until something else is said."""
        self._note.setText(text)

    def add_control(self, control: QWidget) -> None:
        """Put a control of the owner's at the right end of the bar."""
        self._bar.addWidget(control)

    def frame(self) -> None:
        """Draw what has come; figures follow some frames later."""
        self._frames += 1
        if self.plot.span.live:
            self.plot.draw()
        if self._frames % _EVERY == 0:
            self._renew()

    def refresh(self) -> None:
        """Draw everything at once."""
        self.plot.draw()
        self._renew()

    def _renew(self) -> None:
        self._table.refresh()
        self._view.show_what_is_there()
        self._events.refresh()

    def _length_text(self, seconds: float) -> str:
        if seconds < 60:
            return self.tr("{n} s").format(n=f"{seconds:.3g}")
        if seconds < 3600:
            return self.tr("{n} min").format(n=f"{seconds / 60:.3g}")
        return self.tr("{n} h").format(n=f"{seconds / 3600:.3g}")

    @Slot(int)
    def _on_window_chosen(self, index: int) -> None:
        self.plot.set_window(float(self._window.itemData(index)))

    @Slot()
    def _on_pause_clicked(self) -> None:
        if self._pause.isChecked():
            self.plot.hold()
        else:
            self.plot.go_live()

    @Slot(bool)
    def _on_hold_toggled(self, hold: bool) -> None:
        source = self.plot.source
        span = source.span if source is not None else None
        # From the newest sample on: what was before is over.
        self.plot.peaks_since = (span[1] if span is not None else float("-inf")) if hold else None
        self.refresh()

    @Slot()
    def _on_view_changed(self) -> None:
        self._show_state()
        self._table.refresh()

    @Slot()
    def _on_cursor_changed(self) -> None:
        self._table.refresh()
        self._view.show_what_is_there()

    def _show_state(self) -> None:
        live = self.plot.span.live
        self._pause.setChecked(not live)
        self._pause.setText(self.tr("Pa&use") if live else self.tr("Back to li&ve"))
        set_icon(self._pause, "pause" if live else "run")
        self._window.setCurrentIndex(self._window.findData(self.plot.span.length))
        self._window.setPlaceholderText(self._length_text(self.plot.span.length))

    @Slot(object)
    def _on_event_chosen(self, event: Event) -> None:
        """Show an event in the middle, as much around it as is shown now."""
        half = self.plot.span.length / 2
        self.plot.show_span(event.time - half, event.time + half)
        self.plot.set_cursor(event.time)

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.DeferredDelete:
            self.export.finish()
        return super().event(event)
