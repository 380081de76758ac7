"""A plot of a source of traces: it follows the newest sample or shows a part of the past.

Importing it loads the plotting library, which takes as long as all of Qt: do so when a plot is
to be shown, not at the start.
"""

import math

from PySide6.QtCore import QEvent, QSize, Qt, Signal, Slot
from PySide6.QtGui import QFontMetrics, QKeyEvent, QPalette
from PySide6.QtWidgets import QLabel, QVBoxLayout, QWidget

from trex_gui.ui.plotting.axes import clock_text
from trex_gui.ui.plotting.canvas import PlotCanvas
from trex_gui.ui.plotting.data.traces import Traces
from trex_gui.ui.plotting.layers import Layers
from trex_gui.ui.plotting.legend_tags import CurveStyle, Tags
from trex_gui.ui.plotting.marks import MOST_MARKS, MarkStrip
from trex_gui.ui.plotting.number_format import keys_text
from trex_gui.ui.plotting.pointer import Pointer
from trex_gui.ui.plotting.readout import Readout
from trex_gui.ui.plotting.span import Span
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.bar import MINUS
from trex_gui.ui.widgets.focus_frame import FocusFramed

_PAN = 0.25
_ZOOM = 0.7
_FINE, _COARSE = 0.002, 0.05


class TracePlot(FocusFramed):
    """Curves on up to two axes, limits, events and two cursors.

    Curves of the source's first unit are on the left axis, all others on the right one. The
    mouse: wheel zooms, a drag chooses a span, Shift and drag moves, a click sets the mark that
    differences count from. The keys: arrows move the cursor, with Ctrl the picture; + and -
    zoom, M sets or takes away the mark, L goes back to live.

    Signals:
        view_changed: another span is shown, or it is live again or no longer.
        cursor_changed: `cursor_time` or `mark_time`.
        event_chosen: an `Event` was clicked.
    """

    view_changed = Signal()
    cursor_changed = Signal()
    event_chosen = Signal(object)

    def __init__(
        self, window: float = 30.0, parent: QWidget | None = None, *, name: str = ""
    ) -> None:
        """Show so many seconds; a screen reader says `name`, where it is no plot of currents."""
        super().__init__(parent)
        self.span = Span(window)
        self.origin: float | None = None
        self.peaks_since: float | None = None
        self._source: Traces | None = None
        self._shown: set[str] = set()
        self._cursor: float | None = None
        self._hovered: float | None = None  # pixels: under a mouse that rests the time moves on
        self._mark: float | None = None
        self.setObjectName("tracePlot")
        self.setAccessibleName(name or self.tr("Plot of currents and speeds against time"))
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

        self._strip = MarkStrip(self)
        self._canvas = PlotCanvas(self.accessibleName(), self)
        self._canvas.setMinimumSize(160, 90)
        self._layers = Layers(self._canvas)
        self._tags: Tags | None = None
        self._empty = QLabel(self.tr("No data yet"), self._canvas)
        self._empty.setObjectName("emptyLabel")
        self._empty.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._empty.setWordWrap(True)
        self._empty.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._readout = Readout(self._canvas)
        pointer = Pointer(self._canvas.viewport)

        layout = QVBoxLayout(self)
        layout.setContentsMargins(1, 1, 1, 1)  # for the frame of the focus
        layout.setSpacing(0)
        layout.addWidget(self._strip)
        layout.addWidget(self._canvas, 1)

        pointer.hovered.connect(self._on_hovered)
        pointer.left.connect(self._on_left)
        pointer.clicked.connect(self._on_clicked)
        pointer.chosen.connect(self._on_chosen)
        pointer.zoomed.connect(self._on_zoomed)
        pointer.panned.connect(self._on_panned)
        self._strip.chosen.connect(self.event_chosen)
        self._canvas.arranged.connect(self._on_arranged)
        theme().changed.connect(self._on_theme_changed)
        self._canvas.viewport.setFocusProxy(self)
        self._on_theme_changed()

    # --- What is shown ------------------------------------------------------------------

    @property
    def source(self) -> Traces | None:
        """Where the curves come from."""
        return self._source

    def set_source(self, source: Traces) -> None:
        """Show these curves from now on; those that are there at the beginning, once."""
        self._source = source
        self.origin = None
        self._layers.set_source(source)
        self._shown = {trace.name for trace in source.traces if trace.shown}
        if self._tags is not None:
            self._tags.deleteLater()
        styles = [CurveStyle(t.name, t.label, t.color, t.tag) for t in source.traces]
        self._tags = Tags(styles, self._canvas)
        self._tags.show()
        self._show_margins()
        self.draw()

    @property
    def shown(self) -> frozenset[str]:
        """The names of the curves that are drawn."""
        return frozenset(self._shown)

    def set_empty_text(self, text: str) -> None:
        """Say this while there is nothing to draw: why, and what to do."""
        if text != self._empty.text():
            self._empty.setText(text)
            self._show_readout()

    def set_shown(self, name: str, shown: bool) -> None:
        """Draw a curve, or no longer."""
        (self._shown.add if shown else self._shown.discard)(name)
        self.draw()

    @property
    def cursor_time(self) -> float | None:
        """The time under the cursor; `None` while there is none."""
        return self._cursor

    @property
    def mark_time(self) -> float | None:
        """The time that differences count from; `None` while there is none."""
        return self._mark

    def set_cursor(self, time: float | None) -> None:
        """Put the cursor there, or take it away."""
        if time is None:
            self._hovered = None
        self._cursor = time
        self._show_cursors()
        self.cursor_changed.emit()

    def set_mark(self, time: float | None) -> None:
        """Count differences from there, or from nowhere."""
        self._mark = time
        self._show_cursors()
        self.cursor_changed.emit()

    def set_window(self, seconds: float) -> None:
        """Show so many seconds."""
        self.span.set_length(seconds)
        self._on_view_changed()

    def show_span(self, start: float, end: float) -> None:
        """Show this part and stay there."""
        self.span.show(start, end)
        self._on_view_changed()

    def hold(self) -> None:
        """Stay at what is shown now."""
        self.span.hold()
        self._on_view_changed()

    def go_live(self) -> None:
        """Follow the newest sample."""
        self.span.go_live()
        self._on_view_changed()

    def _on_view_changed(self) -> None:
        self.draw()
        self.view_changed.emit()

    def text_of_time(self, time: float) -> str:
        """A time as a person reads it, counted from the beginning of the data."""
        return clock_text(time - (self.origin or 0.0))

    # --- Drawing ------------------------------------------------------------------------

    def draw(self) -> None:
        """Draw a frame; it costs the same however much there is."""
        source = self._source
        if source is None or self._tags is None:
            return
        there = source.span
        if there is None:
            self.origin = None
        else:
            self.span.take(*there)
            # A full history loses its beginning; times still count from where it all began.
            if self.origin is None or there[0] < self.origin:
                self.origin = there[0]
        heights = self._layers.draw(self.span, self.origin or 0.0, self._shown)
        self._layers.draw_levels(self.span, self._shown, self.peak_of)
        events = source.events_between(self.span.start, self.span.end)[-MOST_MARKS:]
        self._strip.set_marks(self._layers.draw_events(self.span, events))
        self._show_cursors()
        self._tags.set_heights(heights)
        self._empty.setVisible(self._layers.is_empty)

    @property
    def points_drawn(self) -> int:
        """How many points the curves of the last frame have together."""
        return self._layers.points_drawn

    def peak_of(self, name: str) -> float | None:
        """Return the greatest value since peaks are held; `None` while they are not."""
        if self._source is None or self.peaks_since is None:
            return None
        high = self._source.statistics(name, self.peaks_since, math.inf).high
        return high if math.isfinite(high) else None

    def _show_cursors(self) -> None:
        if self._hovered is not None:
            self._cursor = self._time_at(self._hovered)
        self._layers.draw_cursors(self.span, self._cursor, self._mark)
        self._show_readout()

    def _show_readout(self) -> None:
        time, source = self._cursor, self._source
        if time is None or source is None or not self.span.start <= time <= self.span.end:
            self._readout.hide()
            empty = self._layers.is_empty
            self.setAccessibleDescription(self._empty.text() if empty else keys_text())
            return
        text = self._readout.text_at(source, time, self._mark, self.origin or 0.0, self._shown)
        if self._hovered is None:  # under a mouse it would be told anew with each frame
            self.setAccessibleDescription(text)
        self._readout.show_beside(self._canvas.x_of(time - self.span.end), self._canvas.frame)

    # --- The mouse ----------------------------------------------------------------------

    def _time_at(self, x: float) -> float:
        count = min(0.0, max(-self.span.length, self._canvas.count_at(x)))
        return self.span.end + count

    @Slot(float)
    def _on_hovered(self, x: float) -> None:
        frame = self._canvas.frame
        inside = frame.left() <= x <= frame.right() and self._source is not None
        self._hovered = x if inside else None
        self.set_cursor(self._time_at(x) if inside else None)

    @Slot()
    def _on_left(self) -> None:
        self._hovered = None
        self.set_cursor(None)

    @Slot(float)
    def _on_clicked(self, x: float) -> None:
        near = self._mark is not None and (
            abs(self._canvas.x_of(self._mark - self.span.end) - x) < 6
        )
        self.set_mark(None if near else self._time_at(x))

    @Slot(float, float)
    def _on_chosen(self, x0: float, x1: float) -> None:
        self.show_span(self._time_at(x0), self._time_at(x1))

    @Slot(float, float)
    def _on_zoomed(self, factor: float, x: float) -> None:
        self.span.zoom(factor, self._time_at(x))
        self._on_view_changed()

    @Slot(float)
    def _on_panned(self, pixels: float) -> None:
        width = max(1.0, self._canvas.frame.width())
        self.span.pan(-pixels / width * self.span.length)
        self._on_view_changed()

    # --- Keys ---------------------------------------------------------------------------

    def keyPressEvent(self, event: QKeyEvent) -> None:
        modifiers = event.modifiers()
        with_control = bool(modifiers & Qt.KeyboardModifier.ControlModifier)
        step = _COARSE if modifiers & Qt.KeyboardModifier.ShiftModifier else _FINE
        middle = self._cursor if self._cursor is not None else self.span.end
        match event.key():
            case Qt.Key.Key_Left | Qt.Key.Key_Right as key:
                sign = -1 if key == Qt.Key.Key_Left else 1
                if with_control:
                    self.span.pan(sign * _PAN * self.span.length)
                    self._on_view_changed()
                else:
                    self._move_cursor(sign * step * self.span.length)
            case Qt.Key.Key_Home:
                self.set_cursor(self.span.start)
            case Qt.Key.Key_End:
                self.set_cursor(self.span.end)
            case Qt.Key.Key_Plus | Qt.Key.Key_Equal:
                self.span.zoom(_ZOOM, middle)
                self._on_view_changed()
            case Qt.Key.Key_Minus:
                self.span.zoom(1 / _ZOOM, middle)
                self._on_view_changed()
            case Qt.Key.Key_M:
                self.set_mark(self._cursor if self._mark is None else None)
            case Qt.Key.Key_L:
                self.go_live()
            case _:
                super().keyPressEvent(event)

    def _move_cursor(self, seconds: float) -> None:
        self._hovered = None
        time = self._cursor if self._cursor is not None else self.span.end
        self.set_cursor(min(self.span.end, max(self.span.start, time + seconds)))

    # --- Room and colours ---------------------------------------------------------------

    def sizeHint(self) -> QSize:
        return QSize(self.fontMetrics().averageCharWidth() * 80, self.fontMetrics().height() * 16)

    def _show_margins(self) -> None:
        metrics = QFontMetrics(self._canvas.small_font())
        now = metrics.horizontalAdvance(self.tr("now")) // 2
        tags = self._tags.sizeHint().width() if self._tags is not None else 0
        widest = f"{MINUS}0.005 {self._layers.unit}"
        half = metrics.height() // 2 + 2
        self._canvas.set_margins(left=widest, top=half, right=max(now, tags) + 2, x_axis=True)

    @Slot()
    def _on_theme_changed(self) -> None:
        palette = QPalette()
        palette.setColor(QPalette.ColorRole.WindowText, theme().color("muted"))
        self._empty.setPalette(palette)

    @Slot()
    def _on_arranged(self) -> None:
        box = self._canvas.frame.toRect()
        self._empty.setGeometry(box)
        if self._tags is not None:
            width = self._tags.sizeHint().width()
            left = int(self._canvas.right_edge) + 1
            self._tags.setGeometry(left, 0, width, box.bottom() + 6)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange and hasattr(self, "_readout"):
            self._show_margins()
