"""A window that shows a recording: curves, values and events of any time of it."""

from pathlib import Path

from PySide6.QtCore import QByteArray, QDateTime, QLocale, QSettings, Qt, QTimer, Signal, Slot
from PySide6.QtGui import QCloseEvent, QKeySequence, QResizeEvent, QShortcut
from PySide6.QtWidgets import (
    QFileDialog,
    QHBoxLayout,
    QLabel,
    QMainWindow,
    QProgressBar,
    QPushButton,
    QSplitter,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from trex_gui.model.device import Device
from trex_gui.model.events import Event
from trex_gui.model.playback import Playback
from trex_gui.views.icons import application_icon, set_icon
from trex_gui.views.recording.transport import TransportBar
from trex_gui.views.recording.values import ValuesPanel
from trex_gui.views.recording.words import time_text
from trex_gui.views.theme import theme
from trex_gui.views.traces.event_list import EventList, EventModel
from trex_gui.views.traces.export import TraceExport
from trex_gui.views.traces.plot import TracePlot
from trex_gui.views.traces.table import Column, TraceTable, TraceTableView
from trex_gui.views.widgets.banner import Banner
from trex_gui.views.widgets.stop_button import StopButton

_DRAW_MS = 100
"""Milliseconds from a new size of the window to the next picture."""

_BEFORE_EVENT = 5.0
"""Seconds shown before and after an event that is jumped to, where less is shown already."""


class PlaybackWindow(QMainWindow):
    """One recording; it needs no board and does not stand in the way of the other windows.

    It may cover the main window while motors turn, and so it has a stop button.

    Signals:
        settings_wanted: the settings in force at the position are to be opened: text and name.
        closed: the window is closed.
    """

    settings_wanted = Signal(str, str)
    closed = Signal()

    def __init__(self, playback: Playback, device: Device, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("playbackWindow")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowIcon(application_icon())
        self.setWindowTitle(self.tr("{0} – recording").format(playback.path.name))
        self._playback = playback
        playback.setParent(self)
        self._store = QSettings(self)
        self._drawing = QTimer(self)
        self._drawing.setSingleShot(True)
        self._drawing.setInterval(_DRAW_MS)

        self._banner = Banner(self)
        self._heading = QLabel(self)
        self._heading.setObjectName("recordingHeading")
        self._heading.setWordWrap(True)
        self._heading.setTextFormat(Qt.TextFormat.PlainText)
        self._whole = QPushButton(self.tr("Show &all"), self)
        self._whole.setObjectName("showAllButton")
        self._whole.setToolTip(self.tr("Show the whole recording again"))
        self._settings = QPushButton(self.tr("&Settings in force…"), self)
        self._settings.setObjectName("settingsInForceButton")
        self._settings.setToolTip(
            self.tr("Open what the board stored at this time in the settings editor")
        )
        set_icon(self._settings, "settings")
        self._export = QPushButton(self.tr("&Export span…"), self)
        self._export.setObjectName("exportSpanButton")
        self._export.setToolTip(self.tr("Save what the plot shows as CSV, every sample of it"))
        set_icon(self._export, "save")
        self._progress = QProgressBar(self)
        self._progress.setObjectName("recordingProgress")
        self._progress.setAccessibleName(self.tr("Progress"))
        self._cancel = QPushButton(self.tr("&Cancel"), self)
        self._cancel.setObjectName("cancelRecordingButton")
        self._cancel.setToolTip(self.tr("Read or write no further"))
        self._plot = TracePlot(parent=self)
        self._plot.set_source(playback.traces)
        self._pictures = TraceExport(self._plot, self, name=playback.path.stem, tables=False)
        self._picture = QToolButton(self)
        self._picture.setObjectName("pictureButton")
        self._picture.setText(self.tr("&Picture"))
        self._picture.setAccessibleName(self.tr("Picture"))
        self._picture.setToolTip(self.tr("Save what the plot shows as PNG or SVG"))
        self._picture.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self._picture.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self._picture.setMenu(self._pictures.menu)
        set_icon(self._picture, "save")
        self._table = TraceTable(self._plot, self)
        table = TraceTableView(self._table, self)
        table.setColumnHidden(Column.NOW, True)  # nothing is new in a recording
        self._events = EventModel(self._plot, self)
        self._list = EventList(self._events, self)
        self._values = ValuesPanel(playback, self)
        self._transport = TransportBar(playback, self)

        top = QHBoxLayout()
        top.addWidget(self._heading, 1)
        for button in (self._whole, self._settings, self._export, self._picture):
            top.addWidget(button)
        work = QHBoxLayout()
        work.addWidget(self._progress, 1)
        work.addWidget(self._cancel)
        below = QHBoxLayout()
        below.addWidget(StopButton(device, "playbackStopButton", self))
        below.addWidget(self._transport, 1)
        # The plot is what the window is for: the table scrolls rather than taking its room.
        table.setMaximumHeight(max(table.minimumHeight(), 8 * self.fontMetrics().height()))
        left = QWidget(self)
        column = QVBoxLayout(left)
        column.setContentsMargins(0, 0, 6, 0)
        column.addWidget(self._plot, 1)
        column.addWidget(table)
        right = QWidget(self)
        column = QVBoxLayout(right)
        column.setContentsMargins(6, 0, 0, 0)
        column.addWidget(self._values)
        heading = QLabel(self.tr("E&vents"), self)
        heading.setBuddy(self._list)
        column.addWidget(heading)
        column.addWidget(self._list, 1)
        halves = QSplitter(Qt.Orientation.Horizontal, self)
        halves.setObjectName("playbackSplitter")
        halves.setChildrenCollapsible(False)
        halves.addWidget(left)
        halves.addWidget(right)
        halves.setStretchFactor(0, 1)
        frame = QWidget(self)
        layout = QVBoxLayout(frame)
        layout.addWidget(self._banner)
        layout.addLayout(top)
        layout.addLayout(work)
        layout.addWidget(halves, 1)
        layout.addLayout(below)
        self.setCentralWidget(frame)
        geometry = self._store.value("playback/geometry")
        if not isinstance(geometry, QByteArray) or not self.restoreGeometry(geometry):
            self.resize(1100, 700)

        QShortcut(QKeySequence(QKeySequence.StandardKey.Close), self, self.close)
        self._drawing.timeout.connect(self._draw)
        self._whole.clicked.connect(self.show_all)
        self._settings.clicked.connect(self._on_settings_clicked)
        self._export.clicked.connect(self._on_export_clicked)
        self._cancel.clicked.connect(self._on_cancel_clicked)
        self._pictures.told.connect(self._banner.show_news)
        self._pictures.refused.connect(self._banner.show_problem)
        self._plot.view_changed.connect(self._table.refresh)
        self._plot.cursor_changed.connect(self._on_cursor_changed)
        self._plot.event_chosen.connect(self._on_event_chosen)
        self._list.chosen.connect(self._on_event_chosen)
        playback.progressed.connect(self._show_heading)
        playback.loaded.connect(self._on_loaded)
        playback.moved.connect(self._on_moved)
        playback.exported.connect(self._on_exported)
        playback.failed.connect(self._on_failed)
        theme().changed.connect(self._on_theme_changed)
        self.show_all()
        self._show_heading()
        if playback.is_loaded:
            self._on_loaded()

    @property
    def playback(self) -> Playback:
        """The recording that is shown."""
        return self._playback

    @Slot()
    def show_all(self) -> None:
        """Show all of the recording in the plot."""
        playback = self._playback
        self._plot.origin = playback.start
        self._plot.show_span(playback.start, max(playback.end, playback.start + 1.0))

    # --- While it is read ---------------------------------------------------------------

    @Slot()
    def _draw(self) -> None:
        self._plot.draw()

    @Slot()
    def _on_loaded(self) -> None:
        self._plot.set_source(self._playback.traces)
        self._table.show_source()
        self.show_all()
        self._events.refresh()
        self._table.refresh()
        self._plot.set_cursor(self._playback.position)
        self._show_heading()
        if self._playback.problems:
            text = self.tr("This recording is not whole. {0}")
            self._banner.show_problem(text.format(" ".join(self._playback.problems)))

    @Slot(str)
    def _on_failed(self, text: str) -> None:
        self._show_heading()
        self._banner.show_problem(text)

    @Slot()
    def _on_cancel_clicked(self) -> None:
        """Without its end there is nothing to look at; without an export there is."""
        if self._playback.is_loaded:
            self._playback.cancel_export()
        else:
            self.close()

    @Slot()
    def _show_heading(self) -> None:
        playback, header = self._playback, self._playback.header
        begun = QDateTime.fromSecsSinceEpoch(int(header.started.timestamp()))
        started = QLocale().toString(begun, QLocale.FormatType.ShortFormat)
        text = self.tr("{0}, recorded {1}").format(header.board, started)
        if playback.is_loaded:
            length = time_text(playback.end - playback.start)
            text = self.tr("{0}, {1} long").format(text, length)
        drawn, there = playback.drawn
        if drawn < there:
            text += ". " + self.tr(
                "The curves show its last {0} of {1} samples; all of them are in an export."
            ).format(QLocale().toString(drawn), QLocale().toString(there))
        self._heading.setText(text)
        share = playback.exporting if playback.is_loaded else playback.progress
        for widget in (self._progress, self._cancel):
            widget.setVisible(share is not None and playback.busy)
        if share is not None:
            self._progress.setValue(round(100 * share))
            words = self.tr("Exporting, %p %") if playback.is_loaded else self.tr("Reading, %p %")
            self._progress.setFormat(words)
        for button in (self._whole, self._settings, self._picture):
            button.setEnabled(playback.is_loaded)
        self._export.setEnabled(playback.is_loaded and not playback.busy)

    # --- Moving through it --------------------------------------------------------------

    @Slot()
    def _on_moved(self) -> None:
        position, span = self._playback.position, self._plot.span
        if not span.start <= position <= span.end:
            begin = position - span.length / 10
            self._plot.show_span(begin, begin + span.length)
        self._plot.set_cursor(position)

    @Slot()
    def _on_cursor_changed(self) -> None:
        """A click in the plot goes there; a pointer that leaves it gives the cursor back."""
        mark = self._plot.mark_time
        if mark is not None and mark != self._marked:
            self._playback.set_position(mark)
        self._marked = mark
        if self._plot.cursor_time is None and self._playback.is_loaded:
            self._plot.set_cursor(self._playback.position)
            return
        self._table.refresh()

    _marked: float | None = None

    @Slot(object)
    def _on_event_chosen(self, event: Event) -> None:
        self._playback.pause()
        span = self._plot.span
        if span.length > 12 * _BEFORE_EVENT:
            self._plot.show_span(event.time - _BEFORE_EVENT, event.time + _BEFORE_EVENT)
        self._playback.set_position(event.time)
        self._list.choose(event)

    # --- What else can be done with it --------------------------------------------------

    @Slot()
    def _on_settings_clicked(self) -> None:
        seconds = self._playback.position - self._playback.start
        name = self.tr("{0} at {1}").format(self._playback.path.stem, time_text(seconds))
        self.settings_wanted.emit(self._playback.latest().settings, name)

    @Slot()
    def _on_export_clicked(self) -> None:
        proposal = self._playback.path.with_name(f"{self._playback.path.stem}_span.csv")
        chosen, _ = QFileDialog.getSaveFileName(
            self, self.tr("Export span"), str(proposal), self.tr("CSV (*.csv)")
        )
        if chosen:
            self.export(Path(chosen))

    def export(self, path: Path) -> None:
        """Write every sample of what the plot shows."""
        if path == self._playback.path:
            self._banner.show_problem(
                self.tr("The recording itself cannot be written over while it is open.")
            )
            return
        span = self._plot.span
        self._playback.export(path, span.start, span.end)
        self._show_heading()

    @Slot(object)
    def _on_exported(self, path: Path) -> None:
        self._banner.show_news(self.tr("The span was saved in {0}.").format(path))
        self._show_heading()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._drawing.start()  # words above the plot stand where its lines are then

    @Slot()
    def _on_theme_changed(self) -> None:
        self._table.recolour()
        self._plot.draw()

    def closeEvent(self, event: QCloseEvent) -> None:
        self._drawing.stop()
        self._store.setValue("playback/geometry", self.saveGeometry())
        self._playback.close()
        self.closed.emit()
        super().closeEvent(event)
