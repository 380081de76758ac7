"""A plot with its controls: time shown, pause, figures, events, export.

Importing it loads pyqtgraph: import it when a plot is needed.
"""

import math

from PySide6.QtCore import QPoint, Qt, Slot
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QSplitter, QWidget

from trex_gui.core.events import Event
from trex_gui.core.texts import title_of
from trex_gui.core.translation import Number, tr
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.plotting.axes import MAX_SPAN, MIN_SPAN, duration_text
from trex_gui.ui.plotting.export import ExportButton
from trex_gui.ui.plotting.figures import EventList, TraceTable, TraceTableView
from trex_gui.ui.plotting.layout_button import LayoutButton
from trex_gui.ui.plotting.layout_file import COLORS, LARGEST_TOP, PlotLayout, color_name
from trex_gui.ui.plotting.plot import TracePlot
from trex_gui.ui.plotting.traces import Traces
from trex_gui.ui.preferences import Preferences
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.widgets.behaviour import only_when_visible
from trex_gui.ui.widgets.builders import button, column, combo_box, label, row, splitter, tab_order
from trex_gui.ui.widgets.labels import PageHead

_WINDOWS = (10, 30, 60, 300, 600, 1800, 3600)  # choices of the time shown, in seconds
_USUAL_SECONDS = 30.0
_TOPS = (1, 2, 5, 10, 20, 50)  # in the unit of the left axis


class TracePanel(QWidget):
    """Shows a source of traces.

    While the source grows, its owner calls `draw_live` and, less often, `refresh_figures`. The
    user's choices are saved: curves, time, range and layout.
    """

    def __init__(self, parent: QWidget | None = None, *, key: str = "currents") -> None:
        """`key`: prefix of the preferences in which the choices are saved."""
        super().__init__(parent)
        self._store = Preferences()
        self._key = f"{key}/"
        # Defaults of the source. Hidden curves have a default colour, too.
        self._usual = PlotLayout(_USUAL_SECONDS, 0, {})
        self._usual_colors: dict[str, str] = {}

        self.plot: TracePlot = TracePlot(self)
        self.notifier = Notifier(self)
        self.layout_button = LayoutButton(
            self.plot, self.notifier, self, layout=self.shown_layout, use=self._use_layout
        )
        self.export = ExportButton(self.plot, self.notifier, self)
        title = title_of(tr("C&urrents"))
        self._head = PageHead(title, self, self.layout_button, self.export)
        self._window = combo_box(
            self,
            "currentsWindow",
            tr("Time shown"),
            items=[(duration_text(seconds), seconds) for seconds in _WINDOWS],
            on_activate=lambda index: self._select_window(_WINDOWS[index]),
        )
        window_label = label(self, text=tr("Show the &last"), buddy=self._window)
        self._top = combo_box(
            self,
            "currentsTop",
            tr("Range of the currents"),
            items=[(tr("automatic"), 0), *((f"0–{amps} A", amps) for amps in _TOPS)],
            tip=tr("A fixed range keeps plots comparable; peaks above it are cut off"),
            on_activate=lambda index: self._select_top((0, *_TOPS)[index]),
        )
        top_label = label(self, text=tr("Ran&ge"), buddy=self._top)
        self._pause = button(
            self,
            "pauseButton",
            tr("Pa&use"),
            checkable=True,
            on_click=lambda paused: self.plot.set_live(not paused),
        )
        self._hold = button(
            self,
            "holdPeaksButton",
            tr("Hold pea&ks"),
            tip=tr("Keep the highest value of each curve from now on, as a line and a figure"),
            checkable=True,
            on_toggle=self._on_hold_toggled,
        )
        self._table = TraceTable(self.plot, self)
        self._view = TraceTableView(self._table, self)
        self._list = EventList(self.plot, self)

        ways, figures = Qt.Orientation, ((self._view, 0), (self._list, 1))
        self._below = below = splitter(self, "figuresSplitter", ways.Horizontal, *figures)
        parts = splitter(self, "tracesSplitter", ways.Vertical, (self.plot, 1), (below, 0))
        bar = row(
            *(window_label, self._window, top_label, self._top, self._pause, self._hold, 1),
            spacing=4,
        )
        column(self._head, bar, (parts, 1), into=self, margins=0)
        controls = self._window, self._top, self._pause, self._hold
        tab_order(self._head, *controls, self.plot, self._view, self._list)
        self._restore_layout(parts, "plot_splitter")
        self._restore_layout(below, "figures_splitter")
        seconds = self._store.real(f"{self._key}window", _USUAL_SECONDS, MIN_SPAN, MAX_SPAN)
        self.plot.set_window(seconds)
        self._show_top(self._store.real(f"{self._key}top", 0, 0, LARGEST_TOP))

        self.plot.view_changed.connect(self._show_state)
        self.plot.view_changed.connect(self._table.refresh)
        self.plot.cursor_changed.connect(self._table.refresh)
        self.plot.cursor_changed.connect(self._view.show_needed_columns)
        self.plot.event_chosen.connect(self._list.select)
        self.plot.shown_changed.connect(self._on_shown_changed)
        self.plot.colors_changed.connect(self._on_colors_changed)
        self._view.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self._view.customContextMenuRequested.connect(self._on_menu_requested)
        columns_changed = self._view.horizontalHeader().geometriesChanged
        columns_changed.connect(self._share_width, Qt.ConnectionType.QueuedConnection)
        self._list.chosen.connect(self._on_event_chosen)
        self.notifier.info.connect(self.set_note)
        self.notifier.error.connect(self.set_note)
        self._show_state()

    def _restore_layout(self, parts: QSplitter, key: str) -> None:
        """Restore the sizes of parts, and save them when the user moves the handle."""
        key, store = self._key + key, self._store
        parts.splitterMoved.connect(lambda *_: store.set(key, parts.saveState()))
        parts.restoreState(store.data(key))

    @Slot()
    def _share_width(self) -> None:
        """Give the figures the width that they need, until the user has moved the handle."""
        if self._store.data(f"{self._key}figures_splitter").isEmpty():
            figures = self._view.sizeHint().width()
            self._below.setSizes([figures, max(0, self._below.width() - figures)])

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._share_width()

    def set_source(self, source: Traces) -> None:
        self.plot.set_source(source)
        colors = {trace.name: color_name(trace.color) for trace in source.traces}
        drawn = {name: color for name, color in colors.items() if name in self.plot.shown}
        self._usual, self._usual_colors = PlotLayout(_USUAL_SECONDS, 0, drawn), colors
        shown = self._store.text(f"{self._key}shown", " ".join(drawn)).split()
        self.plot.shown = colors.keys() & set(shown)
        chosen = self._store.text(f"{self._key}colors").split()
        for name, _, color in (entry.partition("=") for entry in chosen):
            if name in colors and color in COLORS:
                self.plot.set_color(name, COLORS[color][0])
        self._table.show_source()
        self._view.resizeColumnToContents(0)
        self.refresh()

    @Slot(str)
    def set_note(self, text: str) -> None:
        self._head.show_state(text)

    @Slot()
    @only_when_visible
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
        self._share_width()
        self._list.refresh()

    def _select_window(self, seconds: float) -> None:
        self._store.set(f"{self._key}window", seconds)
        self.plot.set_window(seconds)

    def _select_top(self, amps: float) -> None:
        self._store.set(f"{self._key}top", amps)
        self._show_top(amps)

    def _show_top(self, amps: float) -> None:
        self.plot.set_top(amps or None)
        self._top.setCurrentIndex(self._top.findData(amps))
        self._top.setPlaceholderText(f"0–{Number(amps):g} A")

    @Slot()
    def _on_shown_changed(self) -> None:
        self._store.set(f"{self._key}shown", " ".join(sorted(self.plot.shown)))

    @Slot()
    def _on_colors_changed(self) -> None:
        chosen = [
            f"{name}={color}"
            for name, color in self._colors().items()
            if color != self._usual_colors[name]
        ]
        self._store.set(f"{self._key}colors", " ".join(chosen))
        self._table.show_source()

    @Slot(QPoint)
    def _on_menu_requested(self, place: QPoint) -> None:
        row, source = self._view.rowAt(place.y()), self.plot.source
        if source is not None and row >= 0:
            at = self._view.viewport().mapToGlobal(place)
            self.layout_button.show_colors_of(source.traces[row], at)

    def _colors(self) -> dict[str, str]:
        traces = self.plot.source.traces if self.plot.source is not None else ()
        return {trace.name: color_name(trace.color) for trace in traces}

    def shown_layout(self) -> PlotLayout:
        shown = self.plot.shown
        curves = {name: color for name, color in self._colors().items() if name in shown}
        return PlotLayout(self.plot.span.length, self.plot.top or 0, curves)

    def _use_layout(self, layout: PlotLayout | None) -> None:
        """Show the plot in this layout, or with `None` in the default layout."""
        layout = layout or self._usual
        self._select_window(layout.seconds)
        self._select_top(layout.top)
        self.plot.shown = set(layout.curves)
        for name, color in (self._usual_colors | dict(layout.curves)).items():
            self.plot.set_color(name, COLORS[color][0])
        self.plot.shown_changed.emit()
        self.refresh()

    @Slot(bool)
    def _on_hold_toggled(self, hold: bool) -> None:
        span = self.plot.source.span if self.plot.source is not None else None
        # From the newest sample on, not from the beginning of the history.
        self.plot.peaks_since = (span[1] if span is not None else -math.inf) if hold else None
        self.refresh()

    @Slot()
    def _show_state(self) -> None:
        span = self.plot.span
        self._pause.setChecked(not span.live)
        self._pause.setText(tr("Pa&use") if span.live else tr("Back to li&ve"))
        set_icon(self._pause, "pause" if span.live else "run")
        self._window.setCurrentIndex(self._window.findData(span.length))
        self._window.setPlaceholderText(duration_text(span.length))

    def show_moment(self, time: float, text: str) -> None:
        """Show the last event with this text up to a time. Without such an event, show the time."""
        self.refresh()
        source = self.plot.source
        events = [] if source is None else source.events_between(-math.inf, time)
        for event in reversed(events):
            if event.text == text:
                self._list.select(event)
                self._on_event_chosen(event)
                return
        self._show_time(time)

    @Slot(object)
    def _on_event_chosen(self, event: Event) -> None:
        self._show_time(event.time)

    def _show_time(self, time: float) -> None:
        """Show a time in the middle, at the present zoom."""
        half = self.plot.span.length / 2
        self.plot.show_span(time - half, time + half)
        self.plot.set_cursor(time)
