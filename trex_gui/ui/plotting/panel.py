"""Plot with controls, statistics, events and export.

Importing this module loads pyqtgraph, so import it lazily.
"""

import math
from collections.abc import Sequence
from functools import partial

from PySide6.QtCore import QSize, Qt, Slot
from PySide6.QtGui import QIcon, QResizeEvent
from PySide6.QtWidgets import QMenu, QSplitter, QToolButton, QWidget

from trex_gui.core.events import Event
from trex_gui.core.texts import title_of
from trex_gui.core.translation import Number, tr, tr_noop
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.plotting.axes import MAX_SPAN, MIN_SPAN, duration_text
from trex_gui.ui.plotting.export import ExportButton
from trex_gui.ui.plotting.figures import EventList, TraceTable, TraceTableView, swatch
from trex_gui.ui.plotting.plot import TracePlot
from trex_gui.ui.plotting.traces import TraceInfo, Traces
from trex_gui.ui.preferences import Preferences
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import only_when_visible
from trex_gui.ui.widgets.labels import PageHead

_WINDOWS = (10, 30, 60, 300, 600, 1800, 3600)  # selectable spans in seconds
_DEFAULT_SECONDS = 30.0
_TOPS = (1, 2, 5, 10, 20, 50)  # selectable upper limits of the left axis in A
_MAX_TOP = 1e6  # largest valid saved limit in A
_COLORS = {
    "blue": ("motor1", tr_noop("Blue")),
    "orange": ("motor2", tr_noop("Orange")),
    "green": ("good", tr_noop("Green")),
    "yellow": ("warning", tr_noop("Yellow")),
    "purple": ("dirty", tr_noop("Purple")),
    "red": ("danger", tr_noop("Red")),
    "teal": ("teal", tr_noop("Teal")),
    "pink": ("pink", tr_noop("Pink")),
    "grey": ("muted", tr_noop("Grey")),
    "foreground": ("plot_text", tr_noop("Text colour")),
}
"""Name in the preferences → name in the theme, name for the user."""

_COLOR_NAMES = {color: name for name, (color, _) in _COLORS.items()}


class TracePanel(QWidget):
    """Plot with controls. Saves the selected curves, colours, time span, range and layout.

    While the source grows, its owner calls `draw_live` and, less often, `refresh_figures`.
    """

    def __init__(self, parent: QWidget | None = None, *, key: str = "currents") -> None:
        """`key`: prefix of the preferences."""
        super().__init__(parent)
        self._store = Preferences()
        self._key = f"{key}/"
        self._default_colors: dict[str, str] = {}  # curve name → colour

        self.plot: TracePlot = TracePlot(self)
        self.notifier = Notifier(self)
        self.export = ExportButton(self.plot, self.notifier, self)
        title = title_of(tr("C&urrents"))
        self._head = PageHead(title, self, self._layout_button(), self.export)
        items = [(duration_text(seconds), seconds) for seconds in _WINDOWS]
        self._window = ui.combo_box(self, "currentsWindow", tr("Time shown"), items=items)
        self._window.activated.connect(lambda index: self._select_window(_WINDOWS[index]))
        window_label = ui.label(self, text=tr("Show the &last"), buddy=self._window)
        tops = [(tr("automatic"), 0), *((f"0–{amps} A", amps) for amps in _TOPS)]
        tip = tr("A fixed range keeps plots comparable; peaks above it are cut off")
        title = tr("Range of the currents")
        self._top = ui.combo_box(self, "currentsTop", title, items=tops, tip=tip)
        self._top.activated.connect(lambda index: self._select_top((0, *_TOPS)[index]))
        top_label = ui.label(self, text=tr("Ran&ge"), buddy=self._top)
        self._pause = ui.button(
            self,
            "pauseButton",
            tr("Pa&use"),
            checkable=True,
            on_click=lambda paused: self.plot.set_live(not paused),
        )
        self._hold = ui.button(
            self,
            "holdPeaksButton",
            tr("Hold pea&ks"),
            tip=tr("From now on, show the highest value of each curve as a line and in the table"),
            checkable=True,
            on_toggle=self._on_hold_toggled,
        )
        self._table = TraceTable(self.plot, self)
        self._view = TraceTableView(self._table, self)
        self._list = EventList(self.plot, self)

        sides, figures = Qt.Orientation, ((self._view, 0), (self._list, 1))
        self._below = below = ui.splitter(self, "figuresSplitter", sides.Horizontal, *figures)
        parts = ui.splitter(self, "tracesSplitter", sides.Vertical, (self.plot, 1), (below, 0))
        bar = ui.row(
            *(window_label, self._window, top_label, self._top, self._pause, self._hold, 1),
            spacing=4,
        )
        ui.column(self._head, bar, (parts, 1), into=self, margins=0)
        controls = self._window, self._top, self._pause, self._hold
        ui.tab_order(self._head, *controls, self.plot, self._view, self._list)
        self._restore_layout(parts, "plot_splitter")
        self._restore_layout(below, "figures_splitter")
        seconds = self._store.real(f"{self._key}window", _DEFAULT_SECONDS, MIN_SPAN, MAX_SPAN)
        self.plot.select_length(seconds)
        self._show_top(self._store.real(f"{self._key}top", 0, 0, _MAX_TOP))

        self.plot.view_changed.connect(self._show_state)
        self.plot.view_changed.connect(self._table.refresh)
        self.plot.cursor_changed.connect(self._table.refresh)
        self.plot.cursor_changed.connect(self._view.show_needed_columns)
        self.plot.shown_changed.connect(self._on_shown_changed)
        self.plot.colors_changed.connect(self._on_colors_changed)
        columns_changed = self._view.horizontalHeader().geometriesChanged
        columns_changed.connect(self._update_widths, Qt.ConnectionType.QueuedConnection)
        self._list.chosen.connect(self._on_event_chosen)
        self.notifier.info.connect(self.set_note)
        self.notifier.error.connect(self.set_note)
        self._show_state()

    def _layout_button(self) -> QToolButton:
        text = tr("La&yout")
        layout = ui.tool_button(self, "layoutButton", text, icon="settings")
        layout.setAccessibleName(title_of(text))
        layout.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        menu = QMenu(self)
        layout.setMenu(menu)
        self._color_menu = menu.addMenu(tr("&Colours"))
        self._color_menu.aboutToShow.connect(self._fill_colors)
        menu.addSeparator()
        reset = tr("&Reset layout")
        menu.addAction(ui.action(self, "layoutResetAction", reset, on_trigger=self._reset_layout))
        return layout

    @Slot()
    def _fill_colors(self) -> None:
        for old in self._color_menu.findChildren(QMenu):
            old.deleteLater()
        self._color_menu.clear()
        for trace in self._traces:
            menu = self._color_menu.addMenu(trace.label)
            for name, (color, text) in _COLORS.items():
                select = partial(self.plot.set_color, trace.name, color)
                key = f"color_{trace.name}_{name}"
                entry = ui.action(menu, key, tr(text), checkable=True, on_trigger=select)
                entry.setIcon(QIcon(swatch(theme().color(color), QSize(14, 14))))
                entry.setChecked(trace.color == color)
                menu.addAction(entry)

    def _restore_layout(self, parts: QSplitter, key: str) -> None:
        key, store = self._key + key, self._store
        parts.splitterMoved.connect(lambda *_: store.set(key, parts.saveState()))
        parts.restoreState(store.data(key))

    @Slot()
    def _update_widths(self) -> None:
        """Fit the width of the table, unless the user has moved the splitter."""
        if self._store.data(f"{self._key}figures_splitter").isEmpty():
            figures = self._view.sizeHint().width()
            self._below.setSizes([figures, max(0, self._below.width() - figures)])

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._update_widths()

    def set_source(self, source: Traces) -> None:
        self.plot.set_source(source)
        self._default_colors = {trace.name: trace.color for trace in source.traces}
        shown = self._store.text(f"{self._key}shown", " ".join(self.plot.shown)).split()
        self.plot.shown = self._default_colors.keys() & set(shown)
        colors = self._store.text(f"{self._key}colors").split()
        for name, _, color in (entry.partition("=") for entry in colors):
            if name in self._default_colors and color in _COLORS:
                self.plot.set_color(name, _COLORS[color][0])
        self._table.show_source()
        self._view.resizeColumnToContents(0)
        self.refresh()

    @Slot(str)
    def set_note(self, text: str) -> None:
        self._head.show_state(text)

    @Slot()
    @only_when_visible
    def draw_live(self) -> None:
        if self.plot.span.live:
            self.plot.draw()

    def refresh(self) -> None:
        self.plot.draw()
        self.refresh_figures()

    def refresh_figures(self) -> None:
        self._table.refresh()
        self._view.show_needed_columns()
        self._update_widths()
        self._list.refresh()

    def _select_window(self, seconds: float) -> None:
        self._store.set(f"{self._key}window", seconds)
        self.plot.select_length(seconds)

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
        colors = [
            f"{trace.name}={_COLOR_NAMES[trace.color]}"
            for trace in self._traces
            if trace.color != self._default_colors[trace.name]
        ]
        self._store.set(f"{self._key}colors", " ".join(colors))
        self._table.show_source()

    @property
    def _traces(self) -> Sequence[TraceInfo]:
        return self.plot.source.traces if self.plot.source is not None else ()

    def _reset_layout(self) -> None:
        self._select_window(_DEFAULT_SECONDS)
        self._select_top(0)
        self.plot.shown = {trace.name for trace in self._traces if trace.shown}
        for name, color in self._default_colors.items():
            self.plot.set_color(name, color)
        self.plot.shown_changed.emit()
        self.refresh()

    @Slot(bool)
    def _on_hold_toggled(self, hold: bool) -> None:
        span = self.plot.source.span if self.plot.source is not None else None
        # Peaks are held from the newest sample on.
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
        """Show the last event with this text at or before a time.

        If there is no such event, show the time.
        """
        self.refresh()
        source = self.plot.source
        events = [] if source is None else source.events_between(-math.inf, time)
        if matches := [event for event in events if event.text == text]:
            self._list.select(matches[-1])
            time = matches[-1].time
        self._show_time(time)

    @Slot(object)
    def _on_event_chosen(self, event: Event) -> None:
        self._show_time(event.time)

    def _show_time(self, time: float) -> None:
        half = self.plot.span.length / 2
        self.plot.show_span(time - half, time + half)
        self.plot.set_cursor(time)
