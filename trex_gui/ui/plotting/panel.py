"""A plot with its controls: time shown, pause, figures, events, export.

Importing it loads pyqtgraph: do so when a plot is to be shown.
"""

from collections.abc import Sequence

from PySide6.QtCore import QEvent, Qt, Slot
from PySide6.QtWidgets import QSplitter, QWidget

from trex_gui.ui.event_log import Event
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.plotting.export import ExportButton
from trex_gui.ui.plotting.figures import EventList, FiguresAndEvents, TraceTable, TraceTableView
from trex_gui.ui.plotting.plot import TracePlot
from trex_gui.ui.plotting.traces import Traces
from trex_gui.ui.preferences import Preferences
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.widgets.builders import button, column, combo_box, label, row, splitter

_WINDOWS = (10, 30, 60, 300, 600, 1800, 3600)  # seconds that can be chosen to be shown
_TOPS = (1, 2, 5, 10, 20, 50)  # in the unit of the left axis
_KEY = "currents/"


class TracePanel(QWidget):
    """Shows a source of traces.

    While the source grows, its owner calls `draw_live` and, less often, `refresh_figures`. What
    the user chooses is remembered: curves, time, range and layout.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._store = Preferences()

        self._note = label(self, "currentsNote", wrap=True)
        self._window = combo_box(
            self,
            "currentsWindow",
            self.tr("Time shown"),
            items=[(self._length_text(seconds), seconds) for seconds in _WINDOWS],
            on_activate=self._on_window_chosen,
        )
        window_label = label(self, text=self.tr("Show the &last"), buddy=self._window)
        self._top = combo_box(
            self,
            "currentsTop",
            self.tr("Range of the currents"),
            items=[(self.tr("automatic"), 0), *((f"0–{amps} A", amps) for amps in _TOPS)],
            tip=self.tr("A fixed range keeps plots comparable; peaks above it are cut off"),
            on_activate=self._on_top_chosen,
        )
        top_label = label(self, text=self.tr("Ran&ge"), buddy=self._top)
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
        bar = row(
            *((self._note, 1), window_label, self._window, top_label, self._top),
            *(self._pause, self._hold, self.export),
        )
        column(bar, (parts, 1), into=self, margins=0)
        self._restore_layout(parts, "plot_splitter")
        if self._restore_layout(below, "figures_splitter"):
            below.keep_sizes()
        self.plot.set_window(float(self._chosen("window", 30, _WINDOWS)))
        top = self._chosen("top", 0, _TOPS)
        self.plot.set_top(top or None)
        self._top.setCurrentIndex(self._top.findData(top))

        self.plot.view_changed.connect(self._on_view_changed)
        self.plot.cursor_changed.connect(self._on_cursor_changed)
        self.plot.event_chosen.connect(self._list.choose)
        self.plot.shown_changed.connect(self._on_shown_changed)
        self._list.chosen.connect(self._on_event_chosen)
        self.notifier.info.connect(self.set_note)
        self.notifier.error.connect(self.set_note)
        self._show_state()

    def _chosen(self, key: str, default: int, choices: Sequence[int]) -> int:
        """Return what the user chose in an earlier run, if it can be chosen."""
        found = self._store.integer(_KEY + key, default, 0, choices[-1])
        return found if found in choices else default

    def _restore_layout(self, parts: QSplitter, key: str) -> bool:
        """Return whether the user arranged these parts in an earlier run; remember the next."""
        key, store = _KEY + key, self._store
        parts.splitterMoved.connect(lambda *_: store.set(key, parts.saveState()))
        return parts.restoreState(store.data(key))

    def set_source(self, source: Traces) -> None:
        self.plot.set_source(source)
        names = {trace.name for trace in source.traces}
        default = " ".join(self.plot.shown)
        self.plot.shown = names & set(self._store.text(f"{_KEY}shown", default).split())
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
        seconds = int(self._window.itemData(index))
        self._store.set(f"{_KEY}window", seconds)
        self.plot.set_window(float(seconds))

    @Slot(int)
    def _on_top_chosen(self, index: int) -> None:
        amps = int(self._top.itemData(index))
        self._store.set(f"{_KEY}top", amps)
        self.plot.set_top(float(amps) if amps else None)

    @Slot()
    def _on_shown_changed(self) -> None:
        self._store.set(f"{_KEY}shown", " ".join(sorted(self.plot.shown)))

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
