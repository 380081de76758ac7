"""The window that shows the recording of a board: curves, values and events of any time of it."""

from pathlib import Path

from PySide6.QtCore import Signal, Slot
from PySide6.QtWidgets import QFileDialog, QPushButton, QWidget

from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.recordings.playback import Playback
from trex_gui.devices.trex.views.recordings.values import ValuesPanel
from trex_gui.devices.trex.views.stop_button import StopButton
from trex_gui.ui.playback.formats import time_text
from trex_gui.ui.playback.window import RecordingWindow
from trex_gui.ui.plotting.table import TraceColumn, TraceTable, TraceTableView
from trex_gui.ui.theme.icons import set_icon


class PlaybackWindow(RecordingWindow):
    """One recording of a board.

    Signals:
        settings_wanted: the settings in force at the position are to be opened: text and name.
    """

    settings_wanted = Signal(str, str)

    def __init__(self, playback: Playback, device: Device, parent: QWidget | None = None) -> None:
        super().__init__(playback, "playback", parent=parent)
        self._playback = playback

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
        self._table = TraceTable(self.plot, self)
        table = TraceTableView(self._table, self)
        table.setColumnHidden(TraceColumn.NOW, True)  # nothing is new in a recording
        # The plot is what the window is for: the table scrolls rather than taking its room.
        table.setMaximumHeight(max(table.minimumHeight(), 8 * self.fontMetrics().height()))

        self._settings.clicked.connect(self._on_settings_clicked)
        self._export.clicked.connect(self._on_export_clicked)
        playback.exported.connect(self._on_exported)
        self.arrange(
            StopButton(device, "playbackStopButton", self),
            [self._settings, self._export],
            below_plot=table,
            above_events=ValuesPanel(playback, self),
        )

    @property
    def playback(self) -> Playback:
        """The recording that is shown."""
        return self._playback

    def of_what(self) -> str:
        return self._playback.header.board

    def work_words(self) -> str:
        return self.tr("Exporting, %p %") if self._playback.is_loaded else super().work_words()

    def drawn_text(self) -> str:
        return self.tr("The curves show its last {0} of {1} samples; all of them are in an export.")

    def cancel_work(self) -> None:
        self._playback.cancel_export()

    def take_curves(self) -> None:
        super().take_curves()
        self._table.show_source()

    @Slot()
    def show_figures(self) -> None:
        self._table.refresh()

    @Slot()
    def show_state(self) -> None:
        super().show_state()
        self._settings.setEnabled(self._playback.is_loaded)
        self._export.setEnabled(self._playback.is_loaded and not self._playback.busy)

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
            self.banner.show_problem(
                self.tr("The recording itself cannot be written over while it is open.")
            )
            return
        span = self.plot.span
        self._playback.export(path, span.start, span.end)
        self.show_state()

    @Slot(object)
    def _on_exported(self, path: Path) -> None:
        self.banner.show_news(self.tr("The span was saved in {0}.").format(path))
        self.show_state()
