"""Window for bench tests of a motor."""

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QSignalBlocker, QSize, Qt, Signal, Slot
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from trex_gui.core.errors import StudioError
from trex_gui.core.files import reason_of, save
from trex_gui.core.texts import title_of
from trex_gui.core.timing import FRAME_MS
from trex_gui.core.translation import Number, tr
from trex_gui.devices.trex.bench.files import load_run, to_csv
from trex_gui.devices.trex.bench.run import SETTLED_BAND, End, Figures, Run, figures
from trex_gui.devices.trex.model.bench import Bench, Phase
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.views.bench.forms import PlanForm, TuningForm
from trex_gui.devices.trex.views.motor_controls import ArmButton, MotorBar
from trex_gui.ui.files import ResultT, in_background
from trex_gui.ui.runtime import new_timer
from trex_gui.ui.theme.theme import set_look
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.bar import MINUS, NO_VALUE
from trex_gui.ui.widgets.behaviour import HoldButton, ReusedDialog, name_headers, only_when_visible
from trex_gui.ui.widgets.file_questions import (
    last_folder,
    prompt_to_open,
    prompt_to_save,
    remember_folder,
)
from trex_gui.ui.widgets.labels import Note
from trex_gui.ui.widgets.placement import resize_with_font
from trex_gui.ui.widgets.scroll_box import ScrollBox

if TYPE_CHECKING:
    from trex_gui.devices.trex.views.bench.plot import BenchPlot

_PREVIOUS = -1  # data of the list item for the previous test


class BenchDialog(ReusedDialog):
    """Window for bench tests. Closing it during a test stops and disarms all motors."""

    stays_on_stop = True  # the result remains visible

    apply_requested = Signal()

    def __init__(self, device: Device, bench: Bench, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("benchDialog")
        self.setWindowTitle(title_of(tr("&Bench test…")))
        resize_with_font(self, 1040, 700)
        self._device = device
        self.bench = bench
        self._message = ""
        self._plot: BenchPlot | None = None
        self._frame_timer = new_timer(self, FRAME_MS, self._draw, single_shot=True)
        self._plot_timer = new_timer(self, FRAME_MS, self._add_plot, single_shot=True)

        self._note = ui.named(Note(2, self), "benchNote")
        tip = tr("Runs the test while you hold the button with the mouse or the space bar")
        self._hold = ui.named(HoldButton(tr("Hold to run"), self), "benchHoldButton", tip=tip)
        self._hold.setMinimumHeight(3 * self.fontMetrics().height())
        self._compare = ui.combo_box(self, "benchCompare", tr("Test to compare with"))
        self._figures = FiguresTable(self)
        tuning = TuningForm(device, bench, self)
        forms = ui.named(QWidget(self), "benchForms")
        ui.column(PlanForm(device, bench, forms), tuning, 1, into=forms, margins=0)
        left = ui.named(QWidget(self), "benchLeft")
        ui.column((ScrollBox(forms, left), 1), self._hold, into=left, margins=0)
        button = partial(ui.button, self, default=False)
        bar = MotorBar(device, "benchStopButton", self)
        self._stop = bar.stop
        run = ArmButton(device, "benchRunButton", self)
        run.setAutoDefault(False)
        ui.set_bold(self._hold)
        set_look(self._hold, "primary")
        text, on_click = tr("&Open…"), self._prompt_and_open
        tip = tr("Open a saved test")
        self._open = button("benchOpenButton", text, tip=tip, on_click=on_click)
        self._save = button("benchSaveButton", tr("Sa&ve…"), on_click=self._prompt_and_save)
        close = button("benchCloseButton", tr("&Close"), on_click=self.close)

        compare_title = ui.label(self, text=tr("Compar&e with"), buddy=self._compare)
        compare = ui.row(compare_title, (self._compare, 1))
        self._right = ui.column(compare, self._figures)
        middle = ui.row(left, (self._right, 1))
        bar.fill(run, bar.armed, 1, self._open, self._save, close)
        ui.column(self._note, (middle, 1), bar, into=self)
        ui.tab_order(left, self._compare, self._figures, bar.stop)

        self._compare.currentIndexChanged.connect(self._schedule_frame)
        self._compare.currentIndexChanged.connect(self._show_figures)
        self._hold.hold_started.connect(bench.start)
        self._hold.hold_ended.connect(bench.release)
        tuning.apply.clicked.connect(self.apply_requested)
        bench.changed.connect(self._on_changed)
        bench.started.connect(self._on_started)
        bench.finished.connect(self._on_finished)
        device.telemetry.text_due.connect(self._on_text_due)
        device.link_changed.connect(self._on_changed)
        self._fill_compare()
        self._on_changed()

    def reject(self) -> None:  # Esc and the close buttons also call this
        self.bench.abort(tr("The window of the bench test was closed."))
        super().reject()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        if self._plot is None:
            self._plot_timer.start()
        self._stop.setFocus()
        self._on_changed()

    def _add_plot(self) -> None:
        """Create the plot once the window is visible. Creating both at once would take 200 ms."""
        from trex_gui.devices.trex.views.bench.plot import BenchPlot  # noqa: PLC0415 - pyqtgraph

        self._plot = BenchPlot(self)
        self._right.insertWidget(0, self._plot, 1)
        ui.tab_order(self._hold, self._plot, self._compare)
        self._schedule_frame()

    # --- Files --------------------------------------------------------------------------

    @Slot()
    def _prompt_and_save(self) -> None:
        run = self.bench.runs[-1]
        name = f"bench_motor{run.motor}_{run.profile.shape.value}_{run.started:%Y%m%d_%H%M%S}.csv"
        kinds = tr("Bench tests (*.csv);;All files (*)")
        if path := prompt_to_save(self, tr("Save bench test"), last_folder() / name, kinds):
            self.save_run(run, path)

    @Slot()
    def _prompt_and_open(self) -> None:
        kinds = tr("Bench tests (*.csv);;All files (*)")
        if path := prompt_to_open(self, tr("Open bench test"), kinds):
            self.open_run(path)

    def save_run(self, run: Run, path: Path) -> None:
        text, work = tr("Saved as {0}.").format(path.name), partial(save, path, to_csv(run))
        self._start(work, path, lambda _: self._report(text), tr("{0} was not saved: {1}."))

    def open_run(self, path: Path) -> None:
        def add(run: Run) -> None:
            self.bench.add_run(run)
            self._report(tr("{0}: {1}.").format(path.name, run.title))

        self._start(partial(load_run, path), path, add, tr("{0} was not opened: {1}."))

    def _start(
        self,
        work: Callable[[], ResultT],
        path: Path,
        on_done: Callable[[ResultT], object],
        failure: str,
    ) -> None:
        def on_failed(error: StudioError) -> None:
            self._report(failure.format(path.name, reason_of(error)))

        remember_folder(path)
        in_background(self, work, on_done, on_failed)

    def _report(self, text: str) -> None:
        self._message = text
        self._on_text_due()

    # --- Display ------------------------------------------------------------------------

    @Slot()
    def _on_changed(self) -> None:
        idle = self.bench.phase is Phase.IDLE
        self._save.setEnabled(idle and bool(self.bench.runs))
        self._open.setEnabled(idle)
        self._compare.setEnabled(idle)
        self._on_text_due()
        self._schedule_frame()

    @Slot()
    @only_when_visible
    def _on_text_due(self) -> None:
        bench, blocker = self.bench, self.bench.blocker
        self._hold.setEnabled(bench.is_driving or not blocker)
        text = tr("Release to stop") if bench.is_driving else tr("Hold to run")
        if self._hold.text() != text:
            self._hold.setText(text)
        was_aborted = bool(bench.runs) and bench.runs[-1].end is End.ABORTED
        alarming = self._device.motors.armed or (was_aborted and not self._message)
        self._note.show_note(self._status_text(blocker), alarming=alarming)

    def _status_text(self, blocker: str) -> str:
        bench = self.bench
        if bench.is_driving and (run := bench.latest_run) is not None:
            text = tr("Motor {0} is running: {1:.1f} of {2:g} s.")
            return text.format(run.motor, Number(run.ended), Number(run.profile.duration))
        next_step = blocker or tr(
            "Armed. Hold the button to run the motor. The motor stops when you release the button."
        )
        last = self._message or (self._end_text(bench.runs[-1]) if bench.runs else "")
        return f"{last} {next_step}".lstrip()

    def _end_text(self, run: Run) -> str:
        text = {
            End.ABORTED: tr("Aborted after {0:.2f} s: {1}"),
            End.RELEASED: tr("Released after {0:.2f} s."),
            End.COMPLETE: tr("The test is complete."),
        }[run.end]
        return text.format(Number(run.ended), run.reason)

    @Slot()
    def _on_started(self) -> None:
        self._message = ""
        self._show_figures()

    @Slot()
    def _on_finished(self) -> None:
        self._message = ""
        self._fill_compare()
        self._on_changed()
        self._show_figures()

    def _fill_compare(self) -> None:
        """List all tests except the last, and restore the selection."""
        selected = self._compare.currentData()
        text = tr("{0:%H:%M:%S}, motor {1}: {2}")
        with QSignalBlocker(self._compare):
            self._compare.clear()
            self._compare.addItem(tr("the previous test"), _PREVIOUS)
            for run in reversed(self.bench.runs[:-1]):
                self._compare.addItem(text.format(run.started, run.motor, run.title), run)
            data = [self._compare.itemData(row) for row in range(self._compare.count())]
            self._compare.setCurrentIndex(data.index(selected) if selected in data else 0)

    @property
    def _compared_run(self) -> Run | None:
        selected, runs = self._compare.currentData(), self.bench.runs
        if isinstance(selected, Run):
            return selected
        earlier = runs[:-1] if self.bench.phase is Phase.IDLE else runs
        return earlier[-1] if earlier else None

    @Slot()
    def _show_figures(self) -> None:
        run = None if self.bench.is_driving else self.bench.latest_run
        self._figures.show_runs(run, self._compared_run)

    @Slot()
    def _schedule_frame(self) -> None:
        """Draw at most once per frame, so that drawing does not delay the serial line."""
        if self.isVisible() and not self._frame_timer.isActive():
            self._frame_timer.start()

    @Slot()
    def _draw(self) -> None:
        if self._plot is None or not self.isVisible():
            return
        plan = self.bench.plan
        profile = plan.profile.limited(self._device.motors.ceiling)
        self._plot.show_plan(profile, plan.abort_current, self._device.current_limit(plan.motor))
        self._plot.show_runs(self.bench.latest_run, self._compared_run)
        if self.bench.phase is not Phase.IDLE:
            self._schedule_frame()


def _rows() -> tuple[tuple[str, str, str, str], ...]:
    """Return the name, the `Figures` field, the unit and the explanation of each row."""
    until_braking = tr("From the first setpoint until braking.")
    return (
        (tr("Peak current"), "peak", "A", tr("The highest reading.")),
        (
            tr("Steady current"),
            "steady",
            "A",
            tr("At the end of the first phase at constant speed."),
        ),
        (tr("Mean current"), "mean", "A", until_braking),
        (tr("Charge"), "charge", "mAh", until_braking),
        (
            tr("Setpoint to current"),
            "delay",
            "ms",
            tr(
                "Time until the first reading of at least two counts. It includes the delays "
                "of the line, the board and the measurement."
            ),
        ),
        (
            tr("Settled within {0:.0f} % after").format(100 * SETTLED_BAND),
            "settled",
            "ms",
            tr(
                "Time until the current stayed within this percentage of the steady current, "
                "or within two counts of the steady current."
            ),
        ),
    )


class FiguresTable(QTableWidget):
    def __init__(self, parent: QWidget) -> None:
        rows = _rows()
        super().__init__(len(rows), 3, parent)
        ui.named(self, "benchFigures", accessible=tr("Figures of the test"))
        name_headers(self)
        self.setHorizontalHeaderLabels([tr("This test"), tr("Compared"), tr("Change")])
        for index, (name, _, _, explanation) in enumerate(rows):
            header = QTableWidgetItem(name)
            header.setToolTip(ui.plain(explanation))
            self.setVerticalHeaderItem(index, header)
            for column in range(3):
                item = QTableWidgetItem(NO_VALUE)
                item.setFlags(Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable)
                item.setTextAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
                item.setToolTip(ui.plain(explanation))
                self.setItem(index, column, item)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setTabKeyNavigation(False)
        self.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        for headers in (self.horizontalHeader(), self.verticalHeader()):
            headers.setHighlightSections(False)
        ui.set_row_height(self, 12)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)

    def show_runs(self, run: Run | None, before: Run | None) -> None:
        new, old = (Figures() if test is None else figures(test) for test in (run, before))
        for index, (_, field, unit, _) in enumerate(_rows()):
            value, compared = getattr(new, field), getattr(old, field)
            change = None if value is None or compared is None else value - compared
            texts = _text(value, unit), _text(compared, unit), _text(change, unit, "+")
            for column, text in enumerate(texts):
                self.model().setData(self.model().index(index, column), text)

    def sizeHint(self) -> QSize:
        rows = self.rowCount() * self.verticalHeader().defaultSectionSize()
        height = rows + self.horizontalHeader().sizeHint().height() + 2 * self.frameWidth()
        return QSize(super().sizeHint().width(), height)

    def minimumSizeHint(self) -> QSize:
        return QSize(super().minimumSizeHint().width(), self.sizeHint().height() // 2)


def _text(value: float | None, unit: str, sign: str = "") -> str:
    if value is None:
        return NO_VALUE
    number = f"{1000 * value:{sign}.0f}" if unit == "ms" else f"{Number(value):{sign}.2f}"
    return f"{number.replace('-', MINUS)} {unit}"
