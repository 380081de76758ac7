"""Plot of traces, and the panel around it."""

import csv
import math
import re
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QLocale, QPoint, QPointF, Qt
from PySide6.QtGui import QAction, QColor, QImage, QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QApplication,
    QFileDialog,
    QListView,
    QMenu,
    QSplitter,
    QTableView,
    QToolButton,
    QWidget,
)
from pytestqt.modeltest import ModelTester
from pytestqt.qtbot import QtBot

from tests.support.catalogs import in_language
from tests.support.mouse import turn_wheel
from tests.support.window import WidgetDriver
from trex_gui.core.events import Event, EventKind
from trex_gui.ui.plotting.canvas import PlotCanvas
from trex_gui.ui.plotting.figures import TraceColumn, TraceTable
from trex_gui.ui.plotting.history import SampleHistory
from trex_gui.ui.plotting.panel import TracePanel
from trex_gui.ui.plotting.plot import TracePlot
from trex_gui.ui.plotting.traces import TraceInfo, Traces
from trex_gui.ui.theme.theme import theme

RATE = 80
INFOS = [
    TraceInfo("motor1", "Motor 1", "A", "motor1", "1"),
    TraceInfo("motor2", "Motor 2", "A", "motor2", "2"),
    TraceInfo("setpoint1", "Speed setpoint 1", "", "good", "S1", shown=False),
]


class Source(Traces):
    """One minute of two currents and a speed, with limits and events."""

    def __init__(self, seconds: float = 60) -> None:
        self.history = SampleHistory(3)
        self.events: list[Event] = []
        self.limits: dict[str, float] = {}
        super().__init__(INFOS, self.history, self.events, self.limits)
        self.add(seconds)

    def add(self, seconds: float, first: float = 1.0, second: float = 3.0) -> None:
        span = self.span
        begin = span[1] + 1 / RATE if span else 0.0
        times = begin + np.arange(round(seconds * RATE)) / RATE
        values = [np.full_like(times, value) for value in (first, second, -100.0)]
        self.history.extend(times, values)


@pytest.fixture
def source() -> Source:
    return Source()


class TracePanelDriver(WidgetDriver):
    def __init__(self, panel: TracePanel, source: Source, qtbot: QtBot) -> None:
        super().__init__(panel, qtbot)
        qtbot.addWidget(panel)
        panel.resize(900, 500)
        panel.set_source(source)
        panel.grab()
        self._panel = panel
        self.source = source
        self.plot = panel.plot
        self.export = panel.export
        self.notifier = panel.notifier

    @property
    def table(self) -> QTableView:
        return self.find(QTableView, "traceTable")

    @property
    def events(self) -> QListView:
        return self.find(QListView, "eventList")

    def cell(self, name: str, column: TraceColumn) -> str:
        row = [info.name for info in INFOS].index(name)
        return str(self.table.model().index(row, column).data())

    def refresh(self) -> None:
        self._panel.refresh()


@pytest.fixture
def panel(light_scheme: None, qtbot: QtBot, source: Source) -> TracePanelDriver:
    driver = TracePanelDriver(TracePanel(), source, qtbot)
    driver.refresh()
    return driver


@pytest.fixture
def plot(panel: TracePanelDriver) -> TracePlot:
    return panel.plot


def count_pixels(plot: TracePlot, color: str) -> int:
    """Return the number of pixels in a colour of the theme."""
    box = plot._canvas.frame.toRect()
    box.translate(plot._canvas.pos())
    picture = plot.grab(box).toImage().convertToFormat(QImage.Format.Format_RGB32)
    pixels = np.frombuffer(picture.constBits(), dtype=np.uint32)
    return int(np.count_nonzero(pixels == theme().color(color).rgb()))


def x_of(plot: TracePlot, time: float) -> int:
    return round(plot._canvas.x_of(time - plot.span.end))


def send_mouse(
    plot: TracePlot,
    kind: QEvent.Type,
    time: float,
    button: Qt.MouseButton = Qt.MouseButton.NoButton,
    modifiers: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier,
) -> None:
    """Send a mouse event to the plot, at a time of its axis."""
    point = QPointF(x_of(plot, time), 60)
    view = plot._canvas.viewport
    buttons = Qt.MouseButton.NoButton if kind == QEvent.Type.MouseButtonRelease else button
    event = QMouseEvent(kind, point, QPointF(view.mapToGlobal(point)), button, buttons, modifiers)
    QApplication.sendEvent(view, event)


def drag(plot: TracePlot, times: tuple[float, float], modifiers: Qt.KeyboardModifier) -> None:
    """Press at one time and release at another."""
    press, move, release = (
        QEvent.Type.MouseButtonPress,
        QEvent.Type.MouseMove,
        QEvent.Type.MouseButtonRelease,
    )
    left = Qt.MouseButton.LeftButton
    send_mouse(plot, press, times[0], left, modifiers)
    send_mouse(plot, move, times[1], left, modifiers)
    send_mouse(plot, release, times[1], left, modifiers)


# --- Curves -----------------------------------------------------------------------------


def test_curve_is_shown_and_hidden_in_the_legend(panel: TracePanelDriver, plot: TracePlot) -> None:
    view = panel.table
    index = view.model().index(2, TraceColumn.CURVE)
    checked = Qt.ItemDataRole.CheckStateRole
    assert view.model().setData(index, Qt.CheckState.Checked, checked)
    assert "setpoint1" in plot.shown
    assert count_pixels(plot, "good") > 50  # dotted
    keys = [view.model().index(row, 0).data(Qt.ItemDataRole.DecorationRole) for row in (0, 2)]
    assert [key.hasAlphaChannel() for key in keys] == [False, True], "its key is dotted too"
    axis = plot._canvas._axes["right"]
    assert axis.isVisible()
    (shown,) = axis._tickLevels
    assert [text for _, text in shown] == ["−127", "−64", "0", "64", "127"]
    assert view.model().setData(index, Qt.CheckState.Unchecked, checked)
    assert count_pixels(plot, "good") == 0
    assert not axis.isVisible()


def test_value_near_its_limit_has_a_warning_sign(panel: TracePanelDriver, source: Source) -> None:
    roles = Qt.ItemDataRole
    cell = panel.table.model().index(1, TraceColumn.NOW)  # 3 A
    for limit, text, spoken, color in (
        (3.8, "3.00 A", "Motor 2, Now: 3.00 A", None),
        (3.7, "⚠ 3.00 A", "Motor 2, Now: ⚠ 3.00 A, near its limit", theme().color("warning")),
        (2.9, "⚠ 3.00 A", "Motor 2, Now: ⚠ 3.00 A, over its limit", theme().color("danger")),
    ):
        source.limits["motor2"] = limit
        assert cell.data() == text
        assert cell.data(roles.AccessibleTextRole) == spoken
        assert cell.data(roles.ForegroundRole) == color


# --- Visible span -----------------------------------------------------------------------


def test_pause_freezes_the_plot_and_the_table(panel: TracePanelDriver) -> None:
    pause = panel.button("pauseButton")
    pause.click()
    end = panel.plot.span.end
    panel.source.add(5, first=9)
    panel.refresh()
    assert panel.plot.span.end == end
    assert panel.cell("motor1", TraceColumn.PEAK) == "1.00 A"
    assert pause.text() == "Back to li&ve"
    pause.click()
    assert panel.plot.span.end == pytest.approx(end + 5)
    assert panel.cell("motor1", TraceColumn.PEAK) == "9.00 A"
    assert pause.text() == "Pa&use"


def test_drag_selects_a_span_and_pause_button_ends_it(panel: TracePanelDriver) -> None:
    drag(panel.plot, (40, 45), Qt.KeyboardModifier.NoModifier)
    assert panel.plot.span.start == pytest.approx(40, abs=0.1)
    assert panel.plot.span.end == pytest.approx(45, abs=0.1)
    assert panel.plot.mark_time is None
    pause = panel.button("pauseButton")
    assert pause.isChecked()
    pause.click()
    assert panel.plot.span.live
    assert panel.plot.span.length == 30, "the length before the drag"


def test_export_proposes_the_last_folder_and_a_name_with_the_date(
    panel: TracePanelDriver, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    proposals: list[Path] = []

    def select_proposal(
        _window: QWidget, _title: str, proposal: str, _filters: str
    ) -> tuple[str, str]:
        proposals.append(Path(proposal))
        return str(tmp_path / "first.csv"), ""

    monkeypatch.setattr(QFileDialog, "getSaveFileName", select_proposal)
    for _ in range(2):
        panel.find(QAction, "exportAllAction").trigger()
        panel.wait_for_files()
    assert proposals[1].parent == tmp_path
    assert re.fullmatch(r"currents_\d{4}-\d\d-\d\d_\d\d-\d\d-\d\d\.csv", proposals[1].name)


def test_user_choices_are_restored(panel: TracePanelDriver, qtbot: QtBot) -> None:
    model = panel.table.model()
    for row, state in ((0, Qt.CheckState.Unchecked), (2, Qt.CheckState.Checked)):
        model.setData(model.index(row, 0), state, Qt.ItemDataRole.CheckStateRole)
    lengths = panel.combo("currentsWindow")
    texts = [lengths.itemText(row) for row in range(lengths.count())]
    assert texts == ["10 s", "30 s", "1 min", "5 min", "10 min", "30 min", "1 h"]
    lengths.activated.emit(6)
    assert panel.plot.span.length == 3600
    lengths.activated.emit(1)
    panel.combo("currentsTop").activated.emit(3)
    for name in ("tracesSplitter", "figuresSplitter"):
        panel.find(QSplitter, name).moveSplitter(260, 1)

    restored = TracePanelDriver(TracePanel(), Source(), qtbot)
    assert restored.plot.shown == {"motor2", "setpoint1"}
    assert restored.plot.span.length == 30
    assert restored.combo("currentsTop").currentText() == "0–5 A"
    assert restored.plot.top == 5
    for name in ("tracesSplitter", "figuresSplitter"):
        assert restored.find(QSplitter, name).sizes() == panel.find(QSplitter, name).sizes()


def test_layout_is_restored_and_reset(panel: TracePanelDriver, qtbot: QtBot) -> None:
    source = panel.source
    before = [trace.color for trace in source.traces]
    panel.combo("currentsWindow").activated.emit(0)
    panel.plot.set_shown("motor2", shown=False)
    (colors,) = panel.find(QToolButton, "layoutButton").menu().findChildren(QMenu)
    colors.aboutToShow.emit()
    first = colors.findChildren(QMenu)[0]
    assert first.title() == source.traces[0].label
    assert [entry.text() for entry in first.actions() if entry.isChecked()] == ["Blue"]
    panel.find(QAction, "color_motor1_pink").trigger()
    assert source.traces[0].color == "pink"
    assert curve_color(panel.plot) == theme().color("pink")

    restored = TracePanelDriver(TracePanel(), Source(), qtbot)
    assert restored.source.traces[0].color == "pink"
    assert restored.plot.shown == {"motor1"}

    panel.find(QAction, "layoutResetAction").trigger()
    assert [trace.color for trace in source.traces] == before
    assert panel.plot.shown == {"motor1", "motor2"}
    assert panel.plot.span.length == 30


def curve_color(plot: TracePlot) -> QColor:
    color: QColor = plot._shapes["motor1"][0].item.opts["pen"].color()
    return color


def test_fixed_range_does_not_follow_the_values(panel: TracePanelDriver) -> None:
    box, ends = panel.combo("currentsTop"), []
    panel.source.add(5, first=9)
    for amps in (2, 0):
        box.activated.emit(box.findData(amps))
        ends.append(panel.plot._left.ends)
    assert ends == [(0, 2), (0, 10)]


def test_mouse_pans_zooms_and_sets_cursor_and_mark(plot: TracePlot, qapp: QApplication) -> None:
    plot.show_span(20, 40)
    drag(plot, (30, 25), Qt.KeyboardModifier.ShiftModifier)
    assert plot.span.start == pytest.approx(25, abs=0.1)
    assert plot.span.length == 20
    assert plot.mark_time is None

    plot.show_span(20, 40)
    pointer = QPointF(x_of(plot, 25), 60)
    turn_wheel(plot._canvas.viewport, pointer)
    assert plot.span.length == pytest.approx(16)
    assert x_of(plot, 25) == pytest.approx(pointer.x(), abs=2)

    position = QPoint(x_of(plot, 30), 60)
    QTest.mouseClick(plot._canvas.viewport, Qt.MouseButton.LeftButton, pos=position)
    QTest.mouseDClick(plot._canvas.viewport, Qt.MouseButton.LeftButton, pos=position)
    assert plot.mark_time == pytest.approx(30, abs=0.1), "a double click sets only one mark"

    send_mouse(plot, QEvent.Type.MouseMove, 32)
    assert plot.cursor_time == pytest.approx(32, abs=0.1)
    for widget in (plot._canvas.viewport, plot._canvas._plot):
        qapp.sendEvent(widget, QEvent(QEvent.Type.Leave))
    assert plot.cursor_time is None


@pytest.mark.parametrize("is_navigable", [True, False])
def test_wheel_zooms_only_a_navigable_plot(qtbot: QtBot, *, is_navigable: bool) -> None:
    canvas = PlotCanvas("Plot", is_navigable=is_navigable)
    qtbot.addWidget(canvas)
    canvas.resize(300, 200)
    canvas.grab()
    zoomed: list[float] = []
    canvas.zoomed.connect(lambda factor, _x: zoomed.append(factor))
    wheel = turn_wheel(canvas.viewport, canvas.frame.center())
    assert wheel.isAccepted() is is_navigable
    assert len(zoomed) == is_navigable


def test_keys_pan_zoom_and_set_cursor_and_mark(plot: TracePlot) -> None:
    assert "Left and Right move the cursor" in plot.accessibleDescription()
    QTest.keyClick(plot, Qt.Key.Key_Left, Qt.KeyboardModifier.ControlModifier)
    was_live = plot.span.live
    QTest.keyClick(plot, Qt.Key.Key_L)
    assert (was_live, plot.span.live) == (False, True)
    QTest.keyClick(plot, Qt.Key.Key_Plus)
    assert plot.span.length < 30
    QTest.keyClick(plot, Qt.Key.Key_Minus)
    assert plot.span.length == pytest.approx(30)
    QTest.keyClick(plot, Qt.Key.Key_Home)
    assert plot.cursor_time == plot.span.start
    QTest.keyClick(plot, Qt.Key.Key_M)
    assert plot.mark_time == plot.span.start
    QTest.keyClick(plot, Qt.Key.Key_Right, Qt.KeyboardModifier.ShiftModifier)
    assert plot.cursor_time == pytest.approx(plot.span.start + 1.5)
    assert "+1.500 s from the mark" in plot.accessibleDescription()
    assert "Motor 1: 1.00 A\nMotor 2: 3.00 A" in plot.accessibleDescription()
    plot.set_cursor(None)
    assert "Motor" not in plot.accessibleDescription()
    QTest.keyClick(plot, Qt.Key.Key_M)
    assert plot.mark_time is None


def test_empty_plot_shows_and_describes_its_text(qapp: QApplication, qtbot: QtBot) -> None:
    plot = TracePlot()
    qtbot.addWidget(plot)
    plot.set_source(Source(seconds=0))
    plot.set_empty_text("Choose a port.")
    assert plot.accessibleDescription() == "Choose a port."
    assert WidgetDriver(plot, qtbot).text("emptyLabel") == "Choose a port."


# --- Table ------------------------------------------------------------------------------


def test_table_shows_mean_rms_and_charge_of_the_shown_span(panel: TracePanelDriver) -> None:
    panel.plot.show_span(10, 46)
    assert panel.cell("motor2", TraceColumn.MEAN) == "3.000 A"
    assert panel.cell("motor2", TraceColumn.RMS) == "3.000 A"
    assert panel.cell("motor2", TraceColumn.CHARGE) == "30.00 mAh"
    panel.plot.show_span(10, 28)
    assert panel.cell("motor2", TraceColumn.CHARGE) == "15.00 mAh"
    assert panel.cell("motor1", TraceColumn.CHARGE) == "5.00 mAh"
    assert panel.cell("setpoint1", TraceColumn.MEAN) == ""  # hidden curve


def test_cursor_shows_values_and_difference_from_the_mark(panel: TracePanelDriver) -> None:
    panel.source.add(5, first=9)
    panel.refresh()
    send_mouse(panel.plot, QEvent.Type.MouseMove, 50)
    assert panel.cell("motor1", TraceColumn.CURSOR) == "1.00 A"
    send_mouse(panel.plot, QEvent.Type.MouseButtonPress, 50, Qt.MouseButton.LeftButton)
    send_mouse(panel.plot, QEvent.Type.MouseButtonRelease, 50, Qt.MouseButton.LeftButton)
    send_mouse(panel.plot, QEvent.Type.MouseMove, 63)
    assert panel.cell("motor1", TraceColumn.CURSOR) == "9.00 A"
    assert panel.cell("motor1", TraceColumn.DIFFERENCE) == "8.00 A"
    assert "Motor 1: 9.00 A" in panel.text("cursorReadout")
    assert "from the mark" in panel.text("cursorReadout")


def test_optional_columns_are_hidden_until_needed(panel: TracePanelDriver) -> None:
    view = panel.table
    optional = (TraceColumn.LIMIT, TraceColumn.DIFFERENCE, TraceColumn.HELD)
    assert all(view.isColumnHidden(column) for column in optional)
    panel.source.limits["motor1"] = 5.0
    panel.plot.set_mark(20)
    hold = panel.button("holdPeaksButton")
    hold.click()
    assert not any(view.isColumnHidden(column) for column in optional)
    hold.click()
    assert view.isColumnHidden(TraceColumn.HELD)


@pytest.mark.parametrize("language", ["en", "de", "fr"])
def test_table_headings_are_not_cut_off(qapp: QApplication, qtbot: QtBot, language: str) -> None:
    with in_language(qapp, QLocale(language)):
        panel = TracePanel()
        qtbot.addWidget(panel)
        header = WidgetDriver(panel, qtbot).find(QTableView, "traceTable").horizontalHeader()
        for column in TraceColumn:
            assert header.sectionSize(column) >= header.sectionSizeHint(column)


def test_held_peak_remains_after_its_sample_scrolls_out(panel: TracePanelDriver) -> None:
    hold = panel.button("holdPeaksButton")
    hold.click()
    panel.source.add(1, first=7.5)
    panel.source.add(60)
    panel.refresh()
    assert panel.cell("motor1", TraceColumn.PEAK) == "1.00 A"
    assert panel.cell("motor1", TraceColumn.HELD) == "7.50 A"
    hold.click()
    assert panel.cell("motor1", TraceColumn.HELD) == ""


def test_trace_table_passes_the_model_tester(plot: TracePlot, qtmodeltester: ModelTester) -> None:
    qtmodeltester.check(TraceTable(plot))  # type: ignore[no-untyped-call]


# --- Events -----------------------------------------------------------------------------


def test_events_are_marked_listed_and_navigable(panel: TracePanelDriver) -> None:
    before = count_pixels(panel.plot, "danger")
    view = panel.events
    assert "No events yet" in view.accessibleDescription()
    panel.source.events += [
        Event(20.0, EventKind.LINK, "The board answers again"),
        Event(45.0, EventKind.STOP, "Stop: the window was closed"),
    ]
    panel.refresh()
    assert count_pixels(panel.plot, "danger") > before + 50
    assert [event.text for _, event in panel.plot._marks.marks] == ["Stop: the window was closed"]
    assert "No events" not in view.accessibleDescription()
    texts = [str(view.model().index(row, 0).data()) for row in range(2)]
    assert texts == ["0:20.000  The board answers again", "0:45.000  Stop: the window was closed"]
    view.activated.emit(view.model().index(0, 0))
    assert panel.plot.span.start < 20 < panel.plot.span.end
    assert not panel.plot.span.live
    assert panel.plot.cursor_time == 20


# --- Export -----------------------------------------------------------------------------


def test_shown_span_or_whole_history_is_exported(
    panel: TracePanelDriver, qtbot: QtBot, tmp_path: Path
) -> None:
    panel.source.events.append(Event(12.0, EventKind.APPLY, "Apply: Motor 1 Acceleration"))
    panel.plot.show_span(10, 20)
    with qtbot.waitSignal(panel.notifier.info) as reported:
        panel.export.save_table(tmp_path / "shown.csv", panel.plot.span.start, panel.plot.span.end)
    assert "801 samples" in str(reported.args)
    with (tmp_path / "shown.csv").open(newline="") as file:
        rows = list(csv.reader(file))
    assert rows[0] == ["time (s)", "motor1 (A)", "motor2 (A)", "setpoint1", "event"]
    assert rows[1] == ["10.0000", "1", "3", "-100", ""]
    assert len(rows) == 802
    assert [row[0] for row in rows if row[-1]] == ["time (s)", "12.0000"]
    with qtbot.waitSignal(panel.notifier.info):
        panel.export.save_table(tmp_path / "all.csv", -math.inf, math.inf)
    assert len((tmp_path / "all.csv").read_text().splitlines()) == 60 * RATE + 1


def test_unwritable_file_is_reported(panel: TracePanelDriver, qtbot: QtBot, tmp_path: Path) -> None:
    with qtbot.waitSignal(panel.notifier.error) as failed:
        panel.export.save_table(tmp_path / "none" / "all.csv", -math.inf, math.inf)
    assert "cannot be written" in str(failed.args)
    with qtbot.waitSignal(panel.notifier.error):
        panel.export.save_picture(tmp_path / "none" / "picture.png")
    assert "there is no folder" in panel.text("pageState")


def test_picture_has_axes_legend_and_a_light_background(
    panel: TracePanelDriver, tmp_path: Path
) -> None:
    theme().set_scheme("dark")
    panel.export.heading = "Currents of a board"
    panel.export.save_picture(tmp_path / "picture.png")
    panel.wait_for_files()
    image = QImage(str(tmp_path / "picture.png"))
    assert image.width() > 2000
    assert image.pixelColor(3, 3) == QColor(Qt.GlobalColor.white)
    panel.export.save_picture(tmp_path / "picture.svg")
    panel.wait_for_files()
    svg = (tmp_path / "picture.svg").read_text(encoding="utf-8")
    for text in ("Motor 1", "Mean: 1.00 A", "Peak: 3.00 A", "Charge", "0:30", "5 A"):
        assert text in svg, text
    assert "<polyline" in svg
    assert "<image" not in svg
    assert re.search(r">Currents of a board, \d{4}-\d\d-\d\d \d\d:\d\d<", svg)
