"""A window that shows a recording, whatever it is of: curves, events, and a row to move through."""

from collections.abc import Sequence
from typing import Any

from PySide6.QtCore import QByteArray, QDateTime, QLocale, QSettings, Qt, Signal, Slot
from PySide6.QtGui import QCloseEvent, QKeySequence, QResizeEvent, QShortcut
from PySide6.QtWidgets import (
    QHBoxLayout,
    QLabel,
    QMainWindow,
    QPushButton,
    QSplitter,
    QVBoxLayout,
    QWidget,
)

from trex_gui.ui.devices.event_log import Event
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.playback.events import RecordedEvents
from trex_gui.ui.playback.formats import time_text
from trex_gui.ui.playback.player import RecordingPlayer
from trex_gui.ui.playback.transport import TransportBar
from trex_gui.ui.playback.work_row import WorkRow
from trex_gui.ui.plotting.event_list import EventModel
from trex_gui.ui.plotting.export import ExportButton
from trex_gui.ui.plotting.plot import TracePlot
from trex_gui.ui.runtime import runtime
from trex_gui.ui.theme.icons import application_icon
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.banner import Banner

_DRAW_MS = 100
"""Milliseconds from a new size of the window to the next picture."""

_BEFORE_EVENT = 5.0
"""Seconds shown before and after an event that is jumped to, where less is shown already."""


class RecordingWindow(QMainWindow):
    """One recording; it needs no device and does not stand in the way of the other windows.

    One for each device derives from it, calls `arrange` with what it shows beside plot and
    events, and says in `of_what` what the recording is of. It may cover the main window while
    motors turn, and so `arrange` wants a stop button.

    Signals:
        closed: the window is closed.
    """

    closed = Signal()

    def __init__(
        self,
        playback: RecordingPlayer[Any, Any, Any],
        name: str,
        plot_name: str = "",
        parent: QWidget | None = None,
    ) -> None:
        """Show this recording; the window and what it remembers go by `name`.

        A screen reader calls the plot `plot_name`, where it is no plot of currents.
        """
        super().__init__(parent)
        self.setObjectName(f"{name}Window")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowIcon(application_icon())
        self.setWindowTitle(self.tr("{0} – recording").format(playback.path.name))
        self._player = playback
        playback.setParent(self)
        self._name = name
        self._store = QSettings(self)
        self._marked: float | None = None
        self._drawing = runtime().timer(self)
        self._drawing.setSingleShot(True)
        self._drawing.setInterval(_DRAW_MS)

        self.notifier = Notifier(self)
        self.banner = Banner(self, self.notifier)
        self._heading = QLabel(self)
        self._heading.setObjectName("recordingHeading")
        self._heading.setWordWrap(True)
        self._heading.setTextFormat(Qt.TextFormat.PlainText)
        self._whole = QPushButton(self.tr("Show &all"), self)
        self._whole.setObjectName("showAllButton")
        self._whole.setToolTip(self.tr("Show the whole recording again"))
        self._work = WorkRow(self)
        self.plot = TracePlot(parent=self, name=plot_name)
        self.plot.set_source(playback.traces)
        self._picture = ExportButton(
            self.plot, self.notifier, self, name=playback.path.stem, tables=False
        )
        self._events = EventModel(self.plot, self)
        self._list = RecordedEvents(self._events, playback, self)
        self._transport = TransportBar(playback, self)

        QShortcut(QKeySequence(QKeySequence.StandardKey.Close), self, self.close)
        self._drawing.timeout.connect(self.plot.draw)
        self._whole.clicked.connect(self.show_all)
        self._work.cancelled.connect(self._on_cancelled)
        self.plot.view_changed.connect(self.show_figures)
        self.plot.cursor_changed.connect(self._on_cursor_changed)
        self.plot.event_chosen.connect(self._on_event_chosen)
        self._list.chosen.connect(self._on_event_chosen)
        playback.progressed.connect(self.show_state)
        playback.loaded.connect(self._on_loaded)
        playback.moved.connect(self._on_moved)
        playback.failed.connect(self._on_failed)
        theme().changed.connect(self.plot.draw)

    @property
    def player(self) -> RecordingPlayer[Any, Any, Any]:
        """The recording, and the place in it."""
        return self._player

    def arrange(
        self,
        stop: QWidget,
        buttons: Sequence[QWidget],
        below_plot: QWidget,
        above_events: QWidget,
    ) -> None:
        """Lay all of it out, once, and show what is known.

        `buttons` stand in the top row; `below_plot` is not stretched.
        """
        top = QHBoxLayout()
        top.addWidget(self._heading, 1)
        for button in (self._whole, *buttons, self._picture):
            top.addWidget(button)
        below = QHBoxLayout()
        below.addWidget(stop)
        below.addWidget(self._transport, 1)
        left, right = QWidget(self), QWidget(self)
        column = QVBoxLayout(left)
        column.setContentsMargins(0, 0, 6, 0)
        column.addWidget(self.plot, 1)
        column.addWidget(below_plot)
        column = QVBoxLayout(right)
        column.setContentsMargins(6, 0, 0, 0)
        column.addWidget(above_events)
        heading = QLabel(self.tr("E&vents"), self)
        heading.setBuddy(self._list)
        column.addWidget(heading)
        column.addWidget(self._list, 1)
        halves = QSplitter(Qt.Orientation.Horizontal, self)
        halves.setObjectName(f"{self._name}Splitter")
        halves.setChildrenCollapsible(False)
        halves.addWidget(left)
        halves.addWidget(right)
        halves.setStretchFactor(0, 1)
        frame = QWidget(self)
        layout = QVBoxLayout(frame)
        layout.addWidget(self.banner)
        layout.addLayout(top)
        layout.addWidget(self._work)
        layout.addWidget(halves, 1)
        layout.addLayout(below)
        self.setCentralWidget(frame)
        geometry = self._store.value(f"{self._name}/geometry")
        if not isinstance(geometry, QByteArray) or not self.restoreGeometry(geometry):
            self.resize(1100, 700)
        self.show_all()
        self.show_state()
        if self._player.is_loaded:
            self._on_loaded()

    # --- What the windows of a device show ----------------------------------------------

    def of_what(self) -> str:
        """Say what the recording is of."""
        raise NotImplementedError

    def work_words(self) -> str:
        """Say what is being done with the file; `%p` is the share in per cent."""
        return self.tr("Reading, %p %")

    def cancel_work(self) -> None:
        """End what is done with a recording that is read already."""
        self._player.cancel_work()

    @Slot()
    def show_figures(self) -> None:
        """Show what depends on the part that the plot shows, and on its cursor."""

    @Slot()
    def show_state(self) -> None:
        """Show what the recording is of, how much of it was read, and what can be done."""
        player = self._player
        self._heading.setText(self._heading_text())
        self._work.show_share(player.working, self.work_words())
        for button in (self._whole, self._picture):
            button.setEnabled(player.is_loaded)

    def take_curves(self) -> None:
        """Show the curves, once they are read."""
        self.plot.set_source(self._player.traces)

    # --- While it is read ---------------------------------------------------------------

    @Slot()
    def show_all(self) -> None:
        """Show all of the recording in the plot."""
        player = self._player
        self.plot.origin = player.start
        self.plot.show_span(player.start, max(player.end, player.start + 1.0))

    @Slot()
    def _on_loaded(self) -> None:
        self.take_curves()
        self.show_all()
        self._events.refresh()
        self.show_figures()
        self.plot.set_cursor(self._player.position)
        self.show_state()
        if self._player.problems:
            text = self.tr("This recording is not whole. {0}")
            self.banner.show_problem(text.format(" ".join(self._player.problems)))

    @Slot(str)
    def _on_failed(self, text: str) -> None:
        self.show_state()
        self.banner.show_problem(text)

    @Slot()
    def _on_cancelled(self) -> None:
        """Without its end there is nothing to look at; else there is."""
        if self._player.is_loaded:
            self.cancel_work()
        else:
            self.close()

    def _heading_text(self) -> str:
        player = self._player
        begun = QDateTime.fromSecsSinceEpoch(int(player.header.started.timestamp()))
        started = QLocale().toString(begun, QLocale.FormatType.ShortFormat)
        text = self.tr("{0}, recorded {1}").format(self.of_what(), started)
        if player.is_loaded:
            length = time_text(player.end - player.start)
            text = self.tr("{0}, {1} long").format(text, length)
        drawn, there = player.drawn
        if drawn < there:
            text += ". " + self.drawn_text().format(
                QLocale().toString(drawn), QLocale().toString(there)
            )
        return text

    def drawn_text(self) -> str:
        """Say that of `{1}` samples only the last `{0}` are drawn."""
        return self.tr("The curves show its last {0} of {1} samples.")

    # --- Moving through it --------------------------------------------------------------

    @Slot()
    def _on_moved(self) -> None:
        position, span = self._player.position, self.plot.span
        if not span.start <= position <= span.end:
            begin = position - span.length / 10
            self.plot.show_span(begin, begin + span.length)
        self.plot.set_cursor(position)

    @Slot()
    def _on_cursor_changed(self) -> None:
        """A click in the plot goes there; a pointer that leaves it gives the cursor back."""
        mark = self.plot.mark_time
        if mark is not None and mark != self._marked:
            self._player.set_position(mark)
        self._marked = mark
        if self.plot.cursor_time is None and self._player.is_loaded:
            self.plot.set_cursor(self._player.position)
            return
        self.show_figures()

    @Slot(object)
    def _on_event_chosen(self, event: Event) -> None:
        self._player.pause()
        span = self.plot.span
        if span.length > 12 * _BEFORE_EVENT:
            self.plot.show_span(event.time - _BEFORE_EVENT, event.time + _BEFORE_EVENT)
        self._player.set_position(event.time)
        self._list.choose(event)

    # --- Room, colours and the end ------------------------------------------------------

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._drawing.start()  # words above the plot stand where its lines are then

    def closeEvent(self, event: QCloseEvent) -> None:
        self._drawing.stop()
        self._store.setValue(f"{self._name}/geometry", self.saveGeometry())
        self._player.close()
        self.closed.emit()
        super().closeEvent(event)
