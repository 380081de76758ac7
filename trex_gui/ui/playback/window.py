"""Window of a recording, with curves, events, playback and export."""

from pathlib import Path
from typing import Any

from PySide6.QtCore import QDateTime, QLocale, Qt, Signal, Slot
from PySide6.QtGui import QCloseEvent, QKeySequence, QResizeEvent, QShortcut
from PySide6.QtWidgets import QFileDialog, QMainWindow, QProgressBar, QWidget

from trex_gui.core.events import Event
from trex_gui.core.optional_packages import install_command
from trex_gui.core.recording.export import MCAP_SUFFIX, has_mcap
from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.ui.notifier import CopyCommand, Notifier
from trex_gui.ui.playback.player import RecordingPlayer
from trex_gui.ui.playback.transport import TransportBar, time_text
from trex_gui.ui.plotting.export import ExportButton
from trex_gui.ui.plotting.figures import EventList
from trex_gui.ui.plotting.plot import TracePlot
from trex_gui.ui.runtime import new_timer
from trex_gui.ui.theme.icons import application_icon
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.messages import Banner, MessageSpace
from trex_gui.ui.widgets.placement import fit_on_screen, restore_geometry, save_geometry

_REDRAW_DELAY_MS = 100

_EVENT_MARGIN = 5.0  # seconds shown before and after a selected event if the span is long
_CSV_SUFFIX = ".csv"


class RecordingWindow(QMainWindow):
    """Window of one recording. A subclass for each device calls `arrange`.

    The window has a stop button, since it may cover the main window while motors are turning.
    """

    closed = Signal()

    def __init__(
        self, playback: RecordingPlayer[Any, Any, Any], name: str, plot_name: str = ""
    ) -> None:
        """`name`: prefix of object names and preferences. `plot_name`: name for screen readers."""
        super().__init__()
        self.setObjectName(f"{name}Window")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowIcon(application_icon())
        self.setWindowTitle(tr("{0} – recording").format(playback.path.name))
        self.player: RecordingPlayer[Any, Any, Any] = playback
        playback.setParent(self)
        self._name = name
        self._last_mark: float | None = None

        self.notifier = Notifier(self)
        self.banner = Banner(self, self.notifier)
        self._heading = ui.label(self, "recordingHeading", wrap=True)
        whole = tr("Show the whole recording again")
        span = tr("Save every sample in the plot as CSV or MCAP")
        keep = tr(
            "Save a copy, because old recordings of faults and stops are removed automatically"
        )
        cancel = tr("Stop loading or exporting")
        self._show_all, self._export, self.copy_button, self._cancel = (
            ui.button(self, f"{key}Button", text, icon=icon, tip=tip, on_click=slot)
            for key, text, icon, tip, slot in (
                ("showAll", tr("Show &all"), "", whole, self.show_all),
                ("exportSpan", tr("&Export span…"), "save", span, self._on_export_clicked),
                ("copyRecording", tr("Save a cop&y…"), "copy", keep, None),
                ("cancelRecording", tr("Cancel"), "", cancel, self._on_cancelled),
            )
        )
        self.copy_button.hide()
        self._progress = ui.named(
            QProgressBar(self), "recordingProgress", accessible=tr("Progress")
        )
        self.plot = TracePlot(parent=self, name=plot_name)
        self.plot.set_source(playback.traces)
        self._redraw = new_timer(self, _REDRAW_DELAY_MS, self.plot.draw, single_shot=True)
        self._picture = ExportButton(
            self.plot, self.notifier, self, name=playback.path.stem, tables=False
        )
        self._list = EventList(self.plot, self)
        self._list.set_placeholder("")
        self._transport = TransportBar(playback, self)

        QShortcut(QKeySequence(QKeySequence.StandardKey.Close), self, self.close)
        self.plot.view_changed.connect(self.update_figures)
        self.plot.cursor_changed.connect(self._on_cursor_changed)
        self._list.chosen.connect(self._on_event_chosen)
        playback.progressed.connect(self.update_state)
        playback.loaded.connect(self._on_loaded)
        playback.moved.connect(self._on_moved)
        playback.exported.connect(self._on_exported)
        playback.failed.connect(self._on_failed)
        theme().changed.connect(self.plot.draw)

    def arrange(self, stop: QWidget, below_plot: QWidget, above_events: QWidget) -> None:
        controls = self.copy_button, self._show_all, self._export, self._picture
        top = ui.row((self._heading, 1), *controls)
        left, right = QWidget(self), QWidget(self)
        ui.column((self.plot, 1), below_plot, into=left, margins=(0, 0, 6, 0))
        heading = ui.label(self, text=tr("E&vents"), buddy=self._list)
        ui.column(above_events, heading, (self._list, 1), into=right, margins=(6, 0, 0, 0))
        halves = ui.splitter(
            self, f"{self._name}Splitter", Qt.Orientation.Horizontal, (left, 1), (right, 0)
        )
        ui.tab_order(*controls, self._cancel, left, right, stop, self._transport)
        frame = QWidget(self)
        ui.column(
            MessageSpace(frame, self.banner),
            top,
            ui.row((self._progress, 1), self._cancel),
            (halves, 1),
            ui.row(stop, (self._transport, 1)),
            into=frame,
        )
        self.setCentralWidget(frame)
        restore_geometry(self, self._name, 1100, 700)
        fit_on_screen(self)
        self.show_all()
        self.update_state()
        if self.player.is_loaded:
            self._on_loaded()

    def device_text(self) -> str:
        raise NotImplementedError

    @Slot()
    def update_figures(self) -> None:
        """Update values that depend on the span or the cursor."""

    @Slot()
    def update_state(self) -> None:
        player = self.player
        self._heading.setText(self._heading_text())
        self._picture.heading = self._board_text()
        for button in (self._show_all, self._picture):
            button.setEnabled(player.is_loaded)
        self._export.setEnabled(player.is_loaded and not player.is_busy)
        self._progress.setVisible(player.is_busy)
        self._cancel.setVisible(player.is_busy)
        self._progress.setValue(round(100 * player.progress))
        text = tr("Exporting, %p %") if player.is_loaded else tr("Reading, %p %")
        self._progress.setFormat(text)

    def show_curves(self) -> None:
        self.plot.set_source(self.player.traces)

    @Slot()
    def show_all(self) -> None:
        player = self.player
        self.plot.origin = player.start
        self.plot.show_span(player.start, max(player.end, player.start + 1.0))

    @Slot()
    def _on_loaded(self) -> None:
        self.show_curves()
        self.show_all()
        self._list.set_placeholder(tr("This recording has no events."))
        self._list.refresh()
        self.update_figures()
        self.plot.set_cursor(self.player.position)
        self.update_state()
        if self.player.problems:
            text = tr("This recording is not complete. {0}")
            self.notifier.error.emit(text.format(" ".join(self.player.problems)))

    @Slot(str)
    def _on_failed(self, text: str) -> None:
        self.update_state()
        self.notifier.error.emit(text)

    @Slot()
    def _on_cancelled(self) -> None:
        if self.player.is_loaded:
            self.player.cancel()
        else:  # the window has nothing to show
            self.close()

    @Slot()
    def _on_export_clicked(self) -> None:
        kinds = {
            tr("CSV for spreadsheets (*.csv)"): _CSV_SUFFIX,
            tr("MCAP for PlotJuggler and Foxglove (*.mcap)"): MCAP_SUFFIX,
        }
        path = self.player.path
        proposal = str(path.with_name(f"{path.stem}_span{_CSV_SUFFIX}"))
        chosen, kind = QFileDialog.getSaveFileName(
            self, title_of(tr("&Export span…")), proposal, ";;".join(kinds)
        )
        if chosen:
            target = Path(chosen)
            if target.suffix.lower() not in kinds.values():
                target = target.with_name(target.name + kinds.get(kind, _CSV_SUFFIX))
            self.export(target)

    def export(self, path: Path) -> None:
        if path == self.player.path:
            text = tr("The open recording cannot be overwritten. Select another file.")
            self.notifier.error.emit(text)
        elif path.suffix.lower() == MCAP_SUFFIX and not has_mcap():
            command = install_command("mcap")
            text = tr("Exporting MCAP requires an optional package. Install it with: {0}").format(
                command
            )
            self.notifier.report(text, (CopyCommand(command),))
        else:
            span = self.plot.span
            self.player.export(path, span.start, span.end)
            self.update_state()

    @Slot(object)
    def _on_exported(self, path: Path) -> None:
        self.notifier.info.emit(tr("The span was saved to {0}.").format(path))
        self.update_state()

    def _board_text(self) -> str:
        start = QDateTime.fromSecsSinceEpoch(int(self.player.header.started.timestamp()))
        started = QLocale().toString(start, QLocale.FormatType.ShortFormat)
        return tr("{0}, recorded {1}").format(self.device_text(), started)

    def _heading_text(self) -> str:
        player = self.player
        text = self._board_text()
        if player.is_loaded:
            length = time_text(player.end - player.start)
            text = tr("{0}, {1} long").format(text, length)
        drawn, rows = player.row_counts
        if drawn < rows:
            text += ". " + tr(
                "The curves show the last {0} of {1} samples. Exports contain all samples."
            ).format(QLocale().toString(drawn), QLocale().toString(rows))
        return text

    @Slot()
    def _on_moved(self) -> None:
        position, span = self.player.position, self.plot.span
        if not span.start <= position <= span.end:
            start = position - span.length / 10
            self.plot.show_span(start, start + span.length)
        self.plot.set_cursor(position)

    @Slot()
    def _on_cursor_changed(self) -> None:
        """Move the playback to a new mark. Without a cursor, show the playback position."""
        mark = self.plot.mark_time
        if mark is not None and mark != self._last_mark:
            self.player.set_position(mark)
        self._last_mark = mark
        if self.plot.cursor_time is None and self.player.is_loaded:
            self.plot.set_cursor(self.player.position)
            return
        self.update_figures()

    @Slot(object)
    def _on_event_chosen(self, event: Event) -> None:
        self.player.pause()
        if self.plot.span.length > 12 * _EVENT_MARGIN:
            self.plot.show_span(event.time - _EVENT_MARGIN, event.time + _EVENT_MARGIN)
        self.player.set_position(event.time)
        self._list.select(event)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._redraw.start()  # moves the words of events to their new positions

    def closeEvent(self, event: QCloseEvent) -> None:
        self._redraw.stop()
        save_geometry(self, self._name)
        self.player.close()
        self.closed.emit()
        super().closeEvent(event)
