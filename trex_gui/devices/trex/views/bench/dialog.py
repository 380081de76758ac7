"""The window of bench tests: hold a button, see what the motor draws, tune, hold it again."""

from typing import TYPE_CHECKING

from PySide6.QtCore import Signal, Slot
from PySide6.QtGui import QCloseEvent, QPixmap, QShowEvent
from PySide6.QtWidgets import (
    QComboBox,
    QDialog,
    QGridLayout,
    QGroupBox,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QSpinBox,
    QVBoxLayout,
    QWidget,
)

from trex_gui.devices.trex.bench.figures import BAND
from trex_gui.devices.trex.bench.run import End, Run
from trex_gui.devices.trex.model.bench.bench import Bench, Phase
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.traces import current_limit
from trex_gui.devices.trex.views.bench.figures_table import FiguresTable
from trex_gui.devices.trex.views.bench.files import BenchFiles
from trex_gui.devices.trex.views.bench.hold_button import HoldButton
from trex_gui.devices.trex.views.bench.plan_form import PlanForm
from trex_gui.devices.trex.views.bench.tuning import Tuning
from trex_gui.devices.trex.views.stop_button import StopButton
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.runtime import runtime
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.theme.theme import tint
from trex_gui.ui.widgets.note import Note
from trex_gui.ui.widgets.scroll_box import ScrollBox
from trex_gui.ui.widgets.visibility import only_when_visible

if TYPE_CHECKING:
    from trex_gui.devices.trex.views.bench.plot import BenchPlot

_FRAME_MS = 33
_BEFORE, _NOTHING = -1, -2  # what is chosen to be compared with, beside the runs


class BenchDialog(QDialog):
    """Beside the main window, never in its way; Esc stops the motors here as everywhere.

    Closing it while a test runs stops and disarms everything.

    Signals:
        apply_requested: a person wants the edits written.
    """

    apply_requested = Signal()

    def __init__(self, device: Device, bench: Bench, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("benchDialog")
        self.setWindowTitle(self.tr("Bench test"))
        self.resize(1040, 700)
        self._device = device
        self._bench = bench
        self._said = ""
        self._plot: BenchPlot | None = None
        self._notifier = Notifier(self)
        self._files = BenchFiles(bench, self._notifier, self, self._picture)
        self._timer = runtime().timer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(_FRAME_MS)

        self._note = Note(2, self)
        self._note.setObjectName("benchNote")
        plan = QGroupBox(self.tr("Test"), self)
        self._plan = PlanForm(bench, device.motors, plan)
        self._hold = HoldButton(self.tr("Hold to run"), self)
        self._hold.setObjectName("benchHoldButton")
        self._hold.setToolTip(
            self.tr("Runs the test while it is held, with the mouse or the space bar; brakes then")
        )
        font = self._hold.font()
        font.setBold(True)
        self._hold.setFont(font)
        self._hold.setMinimumHeight(3 * self.fontMetrics().height())
        self._compare = QComboBox(self)
        self._compare.setObjectName("benchCompare")
        self._compare.setAccessibleName(self.tr("Test to compare with"))
        band_name = QLabel(self.tr("Settled &within"), self)
        self._band = QSpinBox(self)
        self._band.setObjectName("benchBand")
        self._band.setAccessibleName(
            self.tr("How far from the steady current counts as settled, in percent")
        )
        self._band.setRange(2, 50)
        self._band.setSuffix(self.tr(" %"))
        self._band.setValue(round(100 * BAND))
        band_name.setBuddy(self._band)
        self._figures = FiguresTable(self)
        self._tuning = Tuning(device, bench, self)
        self._stop = StopButton(device, "benchStopButton", self)
        self._run = self._button("benchRunButton", self.tr("Run motor"), "run")
        self._run.setToolTip(self.tr("Let tests move the motors"))
        self._run.setFont(font)
        tint(self._run, "run")
        set_icon(self._run, "run", "run_text")
        tint(self._hold, "run")
        self._save = self._button("benchSaveButton", self.tr("Sa&ve…"), "save")
        self._save.setToolTip(self.tr("Save this test to compare with later, or a picture of it"))
        self._open = self._button("benchOpenButton", self.tr("&Open…"), "open")
        self._open.setToolTip(self.tr("Look at a test that was saved"))
        self._leave = self._button("benchCloseButton", self.tr("Close"))

        inside = QVBoxLayout(plan)
        inside.addWidget(self._plan)
        left_side = QWidget(self)
        left_side.setObjectName("benchLeft")
        left = QVBoxLayout(left_side)
        left.setContentsMargins(0, 0, 0, 0)
        left.addWidget(plan)
        left.addWidget(self._tuning)
        left.addStretch(1)
        compare = QHBoxLayout()
        label = QLabel(self.tr("Co&mpare with"), self)
        label.setBuddy(self._compare)
        compare.addWidget(label)
        compare.addWidget(self._compare, 1)
        compare.addWidget(band_name)
        compare.addWidget(self._band)
        self._right = QVBoxLayout()
        self._right.addLayout(compare)
        self._right.addWidget(self._figures)
        middle = QGridLayout()
        middle.setColumnStretch(1, 1)
        middle.addWidget(ScrollBox(left_side, self), 0, 0)
        middle.addWidget(self._hold, 1, 0)
        middle.addLayout(self._right, 0, 1, 2, 1)
        buttons = QHBoxLayout()
        buttons.addWidget(self._stop)
        buttons.addWidget(self._run)
        buttons.addStretch(1)
        for button in (self._open, self._save, self._leave):
            buttons.addWidget(button)
        layout = QVBoxLayout(self)
        layout.addWidget(self._note)
        layout.addLayout(middle, 1)
        layout.addLayout(buttons)

        self._hold.held.connect(bench.begin)
        self._hold.let_go.connect(bench.let_go)
        self._run.clicked.connect(device.motors.arm)
        self._save.clicked.connect(self._on_save_clicked)
        self._open.clicked.connect(self._files.ask_and_open)
        self._leave.clicked.connect(self.close)
        self._notifier.info.connect(self._on_notified)
        self._notifier.error.connect(self._on_notified)
        self._tuning.apply_requested.connect(self.apply_requested)
        self._compare.currentIndexChanged.connect(self._on_compare_changed)
        self._band.valueChanged.connect(self._show_figures)
        bench.changed.connect(self._on_changed)
        bench.finished.connect(self._on_finished)
        device.telemetry.updated.connect(self._on_telemetry_updated)
        device.link_changed.connect(self._on_changed)
        bench.begun.connect(self._on_begun)
        self._timer.timeout.connect(self._draw)
        self._fill_compare()
        self._on_changed()

    def _button(self, name: str, text: str, icon: str = "") -> QPushButton:
        button = QPushButton(text, self)
        button.setObjectName(name)
        button.setAutoDefault(False)  # Enter in a field must not press anything here
        if icon:
            set_icon(button, icon)
        return button

    @property
    def files(self) -> BenchFiles:
        """Opening and saving of tests."""
        return self._files

    def open_bench(self) -> None:
        """Show it, or bring it forward."""
        self.show()
        self.activateWindow()

    def reject(self) -> None:
        """Esc stops the motors and leaves the window: a result is not to be lost by it."""

    def closeEvent(self, event: QCloseEvent) -> None:
        """Close with the button or the window's cross: Qt's own asks `reject`, which stays."""
        self._bench.abort(self.tr("The window of the bench test was closed."))
        event.accept()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        if self._plot is None:
            self._plot = self._make_plot()
        self._on_changed()

    def _make_plot(self) -> "BenchPlot":
        """Load the plotting library when it is first needed: it takes as long as Qt."""
        from trex_gui.devices.trex.views.bench.plot import BenchPlot  # noqa: PLC0415

        plot = BenchPlot(self)
        self._right.insertWidget(0, plot, 1)
        return plot

    def _picture(self) -> QPixmap:
        return QPixmap() if self._plot is None else self._plot.grab()

    # --- What has changed ---------------------------------------------------------------

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
        obstacle = self._bench.obstacle
        driving = self._bench.is_driving
        self._hold.setEnabled(driving or not obstacle)
        text = self.tr("Let go to stop") if driving else self.tr("Hold to run")
        if self._hold.text() != text:
            self._hold.setText(text)
        self._note.show_note(self._note_text(obstacle), alarming=self._is_alarming())

    def _is_alarming(self) -> bool:
        last = self._bench.runs[-1] if self._bench.runs else None
        aborted = last is not None and last.end is End.ABORTED
        return self._device.motors.armed or (aborted and not self._said)

    def _note_text(self, obstacle: str) -> str:
        """How things stand, what became of the last test, and what to do next."""
        bench = self._bench
        if bench.is_driving and bench.current is not None:
            run = bench.current
            return self.tr("Motor {0} runs: {1:.1f} of {2:g} s.").format(
                run.motor, run.ended, run.profile.duration
            )
        now = obstacle or self.tr("Armed. Hold the button: the motor runs only while it is held.")
        return " ".join(filter(None, [self._said or self._last_text(), now]))

    def _last_text(self) -> str:
        if not self._bench.runs:
            return ""
        run = self._bench.runs[-1]
        match run.end:
            case End.ABORTED:
                return self.tr("Aborted after {0:.2f} s: {1}").format(run.ended, run.reason)
            case End.LET_GO:
                return self.tr("Let go after {0:.2f} s.").format(run.ended)
            case End.COMPLETE:
                return self.tr("The test is complete.")

    @Slot(str)
    def _on_notified(self, text: str) -> None:
        self._said = text
        self._on_telemetry_updated()

    @Slot()
    def _on_save_clicked(self) -> None:
        if self._bench.runs:
            self._files.ask_and_save(self._bench.runs[-1])

    @Slot()
    def _on_begun(self) -> None:
        self._said = ""
        self._show_figures()

    @Slot(object)
    def _on_finished(self, _run: Run) -> None:
        self._said = ""
        self._fill_compare()
        self._on_changed()
        self._show_figures()

    # --- Comparing ----------------------------------------------------------------------

    def _fill_compare(self) -> None:
        """Offer every test but the last; go on comparing with the one chosen."""
        chosen = self._compare.currentData()
        runs = self._bench.runs
        self._compare.blockSignals(True)
        self._compare.clear()
        self._compare.addItem(self.tr("the test before"), _BEFORE)
        self._compare.addItem(self.tr("nothing"), _NOTHING)
        for run in reversed(runs[:-1]):
            text = self.tr("{0:%H:%M:%S}, motor {1}: {2}").format(run.began, run.motor, run.title)
            self._compare.addItem(text, run)
        kept = next(
            (row for row in range(self._compare.count()) if self._compare.itemData(row) == chosen),
            0,
        )
        self._compare.setCurrentIndex(kept)
        self._compare.blockSignals(False)

    @property
    def _before(self) -> Run | None:
        """The test to compare with what is shown."""
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
        """Draw soon: however much changes meanwhile, the line must not wait for a picture."""
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
