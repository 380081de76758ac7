"""A plot with its controls: time shown, pause, figures, events, export.

Importing it loads pyqtgraph: do so when a plot is to be shown.
"""

from PySide6.QtCore import QEvent, Qt, Slot
from PySide6.QtWidgets import QWidget

from trex_gui.ui.event_log import Event
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.plotting.export import ExportButton
from trex_gui.ui.plotting.figures import EventList, FiguresAndEvents, TraceTable, TraceTableView
from trex_gui.ui.plotting.plot import TracePlot
from trex_gui.ui.plotting.traces import Traces
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.widgets.builders import button, column, combo_box, label, row, splitter

_WINDOWS = (10, 30, 60, 300, 600, 1800, 3600)  # seconds that can be chosen to be shown


class TracePanel(QWidget):
    """Shows a source of traces.

    While the source grows, its owner calls `draw_live` and, less often, `refresh_figures`.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)

        self._note = label(self, "currentsNote", wrap=True)
        self._window = combo_box(
            self,
            "currentsWindow",
            self.tr("Time shown"),
            items=[(self._length_text(seconds), seconds) for seconds in _WINDOWS],
            on_activate=self._on_window_chosen,
        )
        window_label = label(self, text=self.tr("Show the &last"), buddy=self._window)
        self._pause = button(
            self,
            "pauseButton",
            self.tr("Pa&use"),
            checkable=True,
            on_click=self._on_pause_clicked,
        )
        self._hold = button(
            self,
            "holdPeaksButton",
            self.tr("Hold pea&ks"),
            tip=self.tr("Keep the highest value of each curve from now on, as a line and a figure"),
            checkable=True,
            on_toggle=self._on_hold_toggled,
        )
        self.plot = TracePlot(self)
        self.notifier = Notifier(self)
        self.export = ExportButton(self.plot, self.notifier, self)
        self._table = TraceTable(self.plot, self)
        self._view = TraceTableView(self._table, self)
        self._list = EventList(self.plot, self)

        below = FiguresAndEvents(self._view, self._list, self)
        vertical = Qt.Orientation.Vertical
        parts = splitter(self, "tracesSplitter", vertical, (self.plot, 1), (below, 0))
        bar = row((self._note, 1), window_label, self._window, self._pause, self._hold, self.export)
        column(bar, (parts, 1), into=self, margins=0)

        self.plot.view_changed.connect(self._on_view_changed)
        self.plot.cursor_changed.connect(self._on_cursor_changed)
        self.plot.event_chosen.connect(self._list.choose)
        self._list.chosen.connect(self._on_event_chosen)
        self.notifier.info.connect(self.set_note)
        self.notifier.error.connect(self.set_note)
        self._show_state()

    def set_source(self, source: Traces) -> None:
        self.plot.set_source(source)
        self._table.show_source()
        self._view.resizeColumnToContents(0)
        self.refresh()

    @Slot(str)
    def set_note(self, text: str) -> None:
        self._note.setText(text)

    def draw_live(self) -> None:
        """Draw new samples, unless the plot is paused."""
        if self.plot.span.live:
            self.plot.draw()

    def refresh(self) -> None:
        self.plot.draw()
        self.refresh_figures()

    def refresh_figures(self) -> None:
        self._table.refresh()
        self._view.show_needed_columns()
        self._list.refresh()

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
        span = self.plot.source.span if self.plot.source is not None else None
        # From the newest sample on, not from the beginning of the history.
        self.plot.peaks_since = (span[1] if span is not None else float("-inf")) if hold else None
        self.refresh()

    @Slot()
    def _on_view_changed(self) -> None:
        self._show_state()
        self._table.refresh()

    @Slot()
    def _on_cursor_changed(self) -> None:
        self._table.refresh()
        self._view.show_needed_columns()

    def _show_state(self) -> None:
        span = self.plot.span
        self._pause.setChecked(not span.live)
        self._pause.setText(self.tr("Pa&use") if span.live else self.tr("Back to li&ve"))
        set_icon(self._pause, "pause" if span.live else "run")
        self._window.setCurrentIndex(self._window.findData(span.length))
        self._window.setPlaceholderText(self._length_text(span.length))

    @Slot(object)
    def _on_event_chosen(self, event: Event) -> None:
        """Show an event in the middle, at the present zoom."""
        half = self.plot.span.length / 2
        self.plot.show_span(event.time - half, event.time + half)
        self.plot.set_cursor(event.time)

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.DeferredDelete:
            self.export.finish()
        return super().event(event)
