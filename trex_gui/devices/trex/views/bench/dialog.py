"""The window of bench tests: hold a button, see what the motor draws, tune, hold it again."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QSignalBlocker, Signal, Slot
from PySide6.QtGui import QCloseEvent, QPixmap, QShowEvent
from PySide6.QtWidgets import QDialog, QGroupBox, QWidget

from trex_gui.devices.trex.bench.figures import BAND
from trex_gui.devices.trex.bench.run import End, Run
from trex_gui.devices.trex.model.bench import Bench, Phase
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.views.action_bar import StopButton
from trex_gui.devices.trex.views.bench.figures_table import FiguresTable
from trex_gui.devices.trex.views.bench.files import BenchFiles
from trex_gui.devices.trex.views.bench.hold_button import HoldButton
from trex_gui.devices.trex.views.bench.plan_form import PlanForm
from trex_gui.devices.trex.views.bench.tuning import Tuning
from trex_gui.devices.trex.views.pages.currents import current_limit
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.runtime import runtime
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.theme.theme import tint
from trex_gui.ui.widgets.behaviour import only_when_visible
from trex_gui.ui.widgets.builders import (
    button,
    column,
    combo_box,
    grid,
    label,
    named,
    row,
    set_bold,
    spin_box,
)
from trex_gui.ui.widgets.labels import Note
from trex_gui.ui.widgets.scroll_box import ScrollBox

if TYPE_CHECKING:
    from trex_gui.devices.trex.views.bench.plot import BenchPlot

_FRAME_MS = 33
_PREVIOUS, _NOTHING = -1, -2  # choices of what to compare with, beside the runs


class BenchOpener(QObject):
    """Creates the window of bench tests when it is first opened.

    Signals:
        apply_requested: write the edits.
    """

    apply_requested = Signal()

    def __init__(self, device: Device, window: QWidget) -> None:
        super().__init__(window)
        self._device = device
        self._window = window
        self._dialog: BenchDialog | None = None
        self.bench = Bench(device, self)

    def open(self) -> None:
        """Show the window, or bring it forward."""
        if self._dialog is None:
            self._dialog = BenchDialog(self._device, self.bench, self._window)
            self._dialog.apply_requested.connect(self.apply_requested)
        self._dialog.open_bench()

    def close(self) -> None:
        """Close the window; a test that runs is aborted."""
        if self._dialog is not None:
            self._dialog.close()


class BenchDialog(QDialog):
    """Not modal; Esc stops the motors here as everywhere.

    Closing it while a test runs stops and disarms all motors.

    Signals:
        apply_requested: write the edits.
    """

    apply_requested = Signal()

    def __init__(self, device: Device, bench: Bench, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("benchDialog")
        self.setWindowTitle(self.tr("Bench test"))
        self.resize(1040, 700)
        self._device = device
        self._bench = bench
        self._message = ""
        self._plot: BenchPlot | None = None
        notifier = Notifier(self)
        self.files = BenchFiles(bench, notifier, self, self._picture)
        self._timer = runtime().timer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(_FRAME_MS)

        self._note = named(Note(2, self), "benchNote")
        plan = QGroupBox(self.tr("Test"), self)
        column(PlanForm(bench, device.motors, plan), into=plan)
        self._hold = named(
            HoldButton(self.tr("Hold to run"), self),
            "benchHoldButton",
            tip=self.tr("Runs the test while it is held, with the mouse or the space bar"),
        )
        set_bold(self._hold)
        tint(self._hold, "run")
        self._hold.setMinimumHeight(3 * self.fontMetrics().height())
        self._compare = combo_box(
            self,
            "benchCompare",
            self.tr("Test to compare with"),
            on_change=self._on_compare_changed,
        )
        self._band = spin_box(
            self,
            "benchBand",
            self.tr("How far from the steady current counts as settled, in percent"),
            2,
            50,
            value=round(100 * BAND),
            suffix=self.tr(" %"),
            on_change=self._show_figures,
        )
        self._band.setKeyboardTracking(True)
        self._figures = FiguresTable(self)
        tuning = Tuning(device, bench, self)
        self._run = button(
            self,
            "benchRunButton",
            self.tr("Run motor"),
            tip=self.tr("Let tests move the motors"),
            default=False,
            on_click=device.motors.arm,
        )
        set_bold(self._run)
        tint(self._run, "run")
        set_icon(self._run, "run", "run_text")
        self._save = button(
            self,
            "benchSaveButton",
            self.tr("Sa&ve…"),
            icon="save",
            tip=self.tr("Save this test to compare with later, or a picture of it"),
            default=False,
            on_click=self._on_save_clicked,
        )
        self._open = button(
            self,
            "benchOpenButton",
            self.tr("&Open…"),
            icon="open",
            tip=self.tr("Open a saved test"),
            default=False,
            on_click=self.files.ask_and_open,
        )
        close = button(
            self, "benchCloseButton", self.tr("Close"), default=False, on_click=self.close
        )

        left = QWidget(self)
        left.setObjectName("benchLeft")
        column(plan, tuning, 1, into=left, margins=0)
        compare = row(
            label(self, text=self.tr("Co&mpare with"), buddy=self._compare),
            (self._compare, 1),
            label(self, text=self.tr("Settled &within"), buddy=self._band),
            self._band,
        )
        self._right = column(compare, self._figures)
        middle = grid(stretch=[(1, 1)])
        middle.addWidget(ScrollBox(left, self), 0, 0)
        middle.addWidget(self._hold, 1, 0)
        middle.addLayout(self._right, 0, 1, 2, 1)
        stop = StopButton(device, "benchStopButton", self)
        buttons = row(stop, self._run, 1, self._open, self._save, close)
        column(self._note, (middle, 1), buttons, into=self)

        self._hold.hold_started.connect(bench.start)
        self._hold.hold_ended.connect(bench.release)
        notifier.info.connect(self._on_notified)
        notifier.error.connect(self._on_notified)
        tuning.apply_requested.connect(self.apply_requested)
        bench.changed.connect(self._on_changed)
        bench.started.connect(self._on_started)
        bench.finished.connect(self._on_finished)
        device.telemetry.updated.connect(self._on_telemetry_updated)
        device.link_changed.connect(self._on_changed)
        self._timer.timeout.connect(self._draw)
        self._fill_compare()
        self._on_changed()

    def open_bench(self) -> None:
        """Show it, or bring it forward."""
        self.show()
        self.activateWindow()

    def reject(self) -> None:
        """Esc stops the motors; the window stays open, so that no result is lost."""

    def closeEvent(self, event: QCloseEvent) -> None:
        """Close; the one of Qt calls `reject`, which keeps the window open."""
        self._bench.abort(self.tr("The window of the bench test was closed."))
        event.accept()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        if self._plot is None:
            self._plot = self._make_plot()
        self._on_changed()

    def _make_plot(self) -> "BenchPlot":
        """Import pyqtgraph when the window is first shown."""
        from trex_gui.devices.trex.views.bench.plot import BenchPlot  # noqa: PLC0415

        plot = BenchPlot(self)
        self._right.insertWidget(0, plot, 1)
        return plot

    def _picture(self) -> QPixmap:
        return QPixmap() if self._plot is None else self._plot.grab()

    # --- State --------------------------------------------------------------------------

    @Slot()
    def _on_changed(self) -> None:
        bench, motors = self._bench, self._device.motors
        self._run.setEnabled(motors.is_available and not motors.armed and not motors.locked_for)
        self._save.setEnabled(bool(bench.runs) and bench.phase is Phase.IDLE)
        self._open.setEnabled(bench.phase is Phase.IDLE)
        self._compare.setEnabled(bench.phase is Phase.IDLE)
        self._on_telemetry_updated()
        self._want_frame()

    @Slot()
    @only_when_visible
    def _on_telemetry_updated(self) -> None:
        blocker = self._bench.blocker
        driving = self._bench.is_driving
        self._hold.setEnabled(driving or not blocker)
        text = self.tr("Release to stop") if driving else self.tr("Hold to run")
        if self._hold.text() != text:
            self._hold.setText(text)
        self._note.show_note(self._note_text(blocker), alarming=self._is_alarming())

    def _is_alarming(self) -> bool:
        last = self._bench.runs[-1] if self._bench.runs else None
        aborted = last is not None and last.end is End.ABORTED
        return self._device.motors.armed or (aborted and not self._message)

    def _note_text(self, blocker: str) -> str:
        """Return the result of the last test and what to do next."""
        bench = self._bench
        if bench.is_driving and bench.current is not None:
            run = bench.current
            return self.tr("Motor {0} runs: {1:.1f} of {2:g} s.").format(
                run.motor, run.ended, run.profile.duration
            )
        now = blocker or self.tr("Armed. Hold the button: the motor runs only while it is held.")
        return " ".join(filter(None, [self._message or self._last_text(), now]))

    def _last_text(self) -> str:
        if not self._bench.runs:
            return ""
        run = self._bench.runs[-1]
        match run.end:
            case End.ABORTED:
                return self.tr("Aborted after {0:.2f} s: {1}").format(run.ended, run.reason)
            case End.RELEASED:
                return self.tr("Released after {0:.2f} s.").format(run.ended)
            case End.COMPLETE:
                return self.tr("The test is complete.")

    @Slot(str)
    def _on_notified(self, text: str) -> None:
        self._message = text
        self._on_telemetry_updated()

    @Slot()
    def _on_save_clicked(self) -> None:
        if self._bench.runs:
            self.files.ask_and_save(self._bench.runs[-1])

    @Slot()
    def _on_started(self) -> None:
        self._message = ""
        self._show_figures()

    @Slot(object)
    def _on_finished(self, _run: Run) -> None:
        self._message = ""
        self._fill_compare()
        self._on_changed()
        self._show_figures()

    # --- Comparing ----------------------------------------------------------------------

    def _fill_compare(self) -> None:
        """Offer every test but the last; keep the choice."""
        chosen = self._compare.currentData()
        runs = self._bench.runs
        blocker = QSignalBlocker(self._compare)
        self._compare.clear()
        self._compare.addItem(self.tr("the previous test"), _PREVIOUS)
        self._compare.addItem(self.tr("nothing"), _NOTHING)
        for run in reversed(runs[:-1]):
            text = self.tr("{0:%H:%M:%S}, motor {1}: {2}").format(run.started, run.motor, run.title)
            self._compare.addItem(text, run)
        rows = range(self._compare.count())
        kept = next((index for index in rows if self._compare.itemData(index) == chosen), 0)
        self._compare.setCurrentIndex(kept)
        del blocker

    @property
    def _before(self) -> Run | None:
        """The test to compare with."""
        chosen, runs = self._compare.currentData(), self._bench.runs
        if isinstance(chosen, Run):
            return chosen
        if chosen == _NOTHING:
            return None
        index = -1 if self._bench.phase is not Phase.IDLE else -2
        return runs[index] if len(runs) >= -index else None

    @Slot()
    def _on_compare_changed(self) -> None:
        self._want_frame()
        self._show_figures()

    # --- Showing ------------------------------------------------------------------------

    @Slot()
    def _show_figures(self) -> None:
        run = None if self._bench.is_driving else self._bench.current
        self._figures.show_runs(run, self._before, self._band.value() / 100)

    def _want_frame(self) -> None:
        """Draw at most once a frame, so that drawing does not delay the line."""
        if self.isVisible() and not self._timer.isActive():
            self._timer.start()

    @Slot()
    def _draw(self) -> None:
        if self._plot is None or not self.isVisible():
            return
        plan = self._bench.plan
        profile = plan.profile.limited(self._device.motors.ceiling)
        self._plot.show_plan(profile, plan.abort_current, current_limit(self._device, plan.motor))
        self._plot.show_runs(self._bench.current, self._before)
        if self._bench.phase is not Phase.IDLE:
            self._want_frame()
