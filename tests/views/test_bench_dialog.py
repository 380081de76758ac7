"""The window of bench tests, its button to hold, and what it shows."""

import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TypeVar

import pytest
from PySide6.QtCore import QCoreApplication, QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QAccessible, QImage, QKeyEvent, QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractSpinBox,
    QApplication,
    QCheckBox,
    QComboBox,
    QDoubleSpinBox,
    QLabel,
    QSpinBox,
    QWidget,
)
from pytestqt.qtbot import QtBot

from tests.bench.runs import run_of
from trex_gui.bench.profile import Profile, Shape
from trex_gui.bench.run import End
from trex_gui.model.bench import Bench
from trex_gui.model.device import Device
from trex_gui.views.bench.dialog import BenchDialog
from trex_gui.views.bench.figures_table import FiguresTable
from trex_gui.views.bench.hold_button import HoldButton
from trex_gui.views.bench.plot import BenchPlot
from trex_gui.views.theme import theme

WidgetT = TypeVar("WidgetT", bound=QWidget)

# --- The button -------------------------------------------------------------------------


class Finger:
    """Somebody at a button in a window with another field."""

    def __init__(self, qtbot: QtBot) -> None:
        self.window = QWidget()
        self.window.resize(300, 120)
        self.other = QSpinBox(self.window)
        self.other.move(0, 70)
        self.button = HoldButton("Hold", self.window)
        self.button.resize(200, 60)
        self.heard: list[str] = []
        self.button.held.connect(lambda: self.heard.append("held"))
        self.button.let_go.connect(lambda: self.heard.append("let go"))
        qtbot.addWidget(self.window)
        self.window.show()
        self.window.activateWindow()
        self.button.setFocus()
        qtbot.waitUntil(self.button.hasFocus)

    def press(self) -> None:
        QTest.mousePress(self.button, Qt.MouseButton.LeftButton)

    def release(self) -> None:
        QTest.mouseRelease(self.button, Qt.MouseButton.LeftButton)

    def move(self, to: QPoint) -> None:
        """Move with the button of the mouse down."""
        left = Qt.MouseButton.LeftButton
        event = QMouseEvent(
            QEvent.Type.MouseMove,
            QPointF(to),
            QPointF(self.button.mapToGlobal(to)),
            left,
            left,
            Qt.KeyboardModifier.NoModifier,
        )
        QCoreApplication.sendEvent(self.button, event)

    def key(self, kind: QEvent.Type, *, repeated: bool = False) -> None:
        none = Qt.KeyboardModifier.NoModifier
        event = QKeyEvent(kind, Qt.Key.Key_Space, none, " ", repeated)
        QCoreApplication.sendEvent(self.button, event)


@pytest.fixture
def finger(qtbot: QtBot) -> Finger:
    return Finger(qtbot)


def test_a_button_is_held_from_the_press_to_the_release(finger: Finger) -> None:
    finger.press()
    assert finger.heard == ["held"]
    assert finger.button.is_held
    finger.release()
    assert finger.heard == ["held", "let go"]


def test_the_space_bar_holds_it_and_its_repeats_mean_nothing(finger: Finger) -> None:
    finger.key(QEvent.Type.KeyPress)
    for _ in range(3):
        finger.key(QEvent.Type.KeyRelease, repeated=True)
        finger.key(QEvent.Type.KeyPress, repeated=True)
    assert finger.heard == ["held"]
    finger.key(QEvent.Type.KeyRelease)
    assert finger.heard == ["held", "let go"]


def test_a_mouse_that_slips_off_lets_go_and_does_not_hold_again_by_coming_back(
    finger: Finger,
) -> None:
    finger.press()
    finger.move(QPoint(500, 500))
    assert finger.heard == ["held", "let go"]
    finger.move(QPoint(10, 10))
    assert not finger.button.is_held
    finger.release()
    assert finger.heard == ["held", "let go"]


LOSSES: dict[str, Callable[[Finger], object]] = {
    "the focus goes elsewhere": lambda finger: finger.other.setFocus(),
    "it is greyed": lambda finger: finger.button.setEnabled(False),
    "it is hidden": lambda finger: finger.button.hide(),
    "its window is hidden": lambda finger: finger.window.hide(),
    "another window comes forward": lambda finger: QCoreApplication.sendEvent(
        finger.button, QEvent(QEvent.Type.WindowDeactivate)
    ),
    "the mouse is taken away": lambda finger: QCoreApplication.sendEvent(
        finger.button, QEvent(QEvent.Type.UngrabMouse)
    ),
    "the touch is cancelled": lambda finger: QCoreApplication.sendEvent(
        finger.button, QEvent(QEvent.Type.TouchCancel)
    ),
}


@pytest.mark.parametrize("loss", LOSSES)
def test_whatever_takes_the_button_away_lets_go(finger: Finger, loss: str) -> None:
    finger.press()
    LOSSES[loss](finger)
    assert finger.heard == ["held", "let go"]


def test_a_greyed_button_cannot_be_held(finger: Finger) -> None:
    finger.button.setEnabled(False)
    finger.press()
    assert finger.heard == []


# --- The window -------------------------------------------------------------------------


class Window:
    """The window of bench tests without a board."""

    def __init__(self, qtbot: QtBot) -> None:
        self.device = Device()
        self.bench = Bench(self.device)
        self.dialog = BenchDialog(self.device, self.bench)
        qtbot.addWidget(self.dialog)
        self.dialog.open_bench()

    def find(self, kind: type[WidgetT], name: str) -> WidgetT:
        widget = self.dialog.findChild(kind, name)
        assert isinstance(widget, kind), name
        return widget

    def choose(self, name: str, data: object) -> None:
        combo = self.find(QComboBox, name)
        combo.setCurrentIndex(combo.findData(data))

    def figure(self, row: int, column: int) -> str:
        item = self.find(FiguresTable, "benchFigures").item(row, column)
        assert item is not None
        return item.text()


@pytest.fixture
def window(qtbot: QtBot, qapp: QApplication) -> Iterator[Window]:
    theme().install(qapp)
    window = Window(qtbot)
    yield window
    window.dialog.close()


def test_without_a_board_the_button_is_greyed_and_the_reason_given(window: Window) -> None:
    assert not window.find(HoldButton, "benchHoldButton").isEnabled()
    assert "Connect to a board" in window.find(QLabel, "benchNote").text()


def test_the_red_button_stops_when_it_goes_down(window: Window) -> None:
    stop = window.find(QAbstractButton, "benchStopButton")
    stop.setEnabled(True)
    assert not window.device.motors.locked_for
    QTest.mousePress(stop, Qt.MouseButton.LeftButton)
    assert window.device.motors.locked_for


def test_the_form_makes_the_plan(window: Window) -> None:
    window.choose("benchMotor", 2)
    window.choose("benchShape", Shape.SINE)
    window.choose("benchDirection", -1)
    window.find(QSpinBox, "benchSpeed").setValue(70)
    window.find(QDoubleSpinBox, "benchDuration").setValue(6.5)
    window.find(QDoubleSpinBox, "benchPeriod").setValue(1.25)
    window.choose("benchSent", False)
    window.find(QDoubleSpinBox, "benchAbort").setValue(7.5)
    window.find(QCheckBox, "benchAbortAtLimit").setChecked(True)
    plan = window.bench.plan
    assert plan.motor == 2
    assert plan.profile == Profile(shape=Shape.SINE, speed=-70, duration=6.5, period=1.25)
    assert not plan.accelerate
    assert plan.abort_current == 7.5
    assert plan.abort_at_limit


def test_a_step_has_no_period_and_a_ramp_a_time_to_rise(window: Window) -> None:
    period = window.find(QDoubleSpinBox, "benchPeriod")
    assert not period.isEnabled()
    window.choose("benchShape", Shape.RAMP)
    assert period.isEnabled()
    assert "rises" in period.toolTip()


def test_no_speed_beyond_the_ceiling_can_be_chosen(window: Window) -> None:
    window.device.motors.set_ceiling(50)
    assert window.find(QSpinBox, "benchSpeed").maximum() == 50


def test_a_plan_is_seen_before_it_runs(window: Window, qtbot: QtBot) -> None:
    plot = window.find(BenchPlot, "benchPlot")
    window.find(QDoubleSpinBox, "benchDuration").setValue(9.4)
    qtbot.waitUntil(lambda: plot.seconds == pytest.approx(10))


READINGS = [(index / 80, 12.0 if index < 10 else 4.0) for index in range(160)]
GENTLER = [(index / 80, 6.0 if index < 10 else 4.0) for index in range(160)]


def test_a_result_stands_beside_the_one_before(window: Window, qtbot: QtBot) -> None:
    window.bench.keep(run_of(READINGS))
    assert [window.figure(0, column) for column in range(3)] == ["12.00 A", "–", "–"]
    window.bench.keep(run_of(GENTLER))
    assert [window.figure(0, column) for column in range(3)] == ["6.00 A", "12.00 A", "−6.00 A"]
    assert window.figure(1, 0) == "4.00 A"
    plot = window.find(BenchPlot, "benchPlot")
    qtbot.waitUntil(lambda: plot.highest >= 12.0)


def test_what_is_compared_with_can_be_chosen(window: Window) -> None:
    for readings in (READINGS, GENTLER, GENTLER):
        window.bench.keep(run_of(readings))
    compare = window.find(QComboBox, "benchCompare")
    assert window.figure(0, 1) == "6.00 A"
    compare.setCurrentIndex(compare.count() - 1)  # the oldest
    assert window.figure(0, 1) == "12.00 A"
    compare.setCurrentIndex(1)  # nothing
    assert window.figure(0, 1) == "–"


def test_what_counts_as_settled_can_be_chosen(window: Window) -> None:
    rising = [(index / 80, index / 40) for index in range(80)]
    window.bench.keep(run_of(rising + [(1 + index / 80, 2.0) for index in range(80)]))
    assert window.figure(5, 0) == "850 ms"  # two counts are more than a tenth of 2 A
    window.find(QSpinBox, "benchBand").setValue(50)
    assert window.figure(5, 0) == "500 ms"
    header = window.find(FiguresTable, "benchFigures").verticalHeaderItem(5)
    assert header is not None
    assert header.text() == "Settled within 50 % after"


def test_why_a_test_was_aborted_is_said(window: Window) -> None:
    reason = "Motor 1 drew 12.00 A, more than the 10 A to abort at."
    window.bench.keep(run_of(READINGS, ended=0.5, end=End.ABORTED, reason=reason))
    note = window.find(QLabel, "benchNote").text()
    assert f"Aborted after 0.50 s: {reason}" in note


def test_a_saved_test_is_opened_again(window: Window, tmp_path: Path) -> None:
    window.bench.keep(run_of(READINGS))
    path = tmp_path / "test.csv"
    window.dialog.files.save(window.bench.runs[0], path)
    assert "Saved as test.csv" in window.find(QLabel, "benchNote").text()
    window.dialog.files.open(path)
    assert len(window.bench.runs) == 2
    assert window.figure(0, 2) == "+0.00 A"


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"product: TReX\n", "a bench test begins with"),
        (b"\xff\xfe\x00", "it is no text"),
        (None, "was not opened"),
    ],
)
def test_a_file_that_is_no_test_is_refused_with_the_reason(
    window: Window, tmp_path: Path, content: bytes | None, words: str
) -> None:
    path = tmp_path / "other.csv"
    if content is not None:
        path.write_bytes(content)
    window.dialog.files.open(path)
    assert words in window.find(QLabel, "benchNote").text()
    assert window.bench.runs == ()


@pytest.mark.skipif(sys.platform == "win32", reason="every folder can be written to")
def test_a_test_is_saved_as_a_picture_of_its_plot(window: Window, tmp_path: Path) -> None:
    window.bench.keep(run_of(READINGS))
    window.dialog.files.save(window.bench.runs[0], tmp_path / "test.PNG")
    picture = QImage(str(tmp_path / "test.PNG"))
    plot = window.find(QWidget, "benchPlot")
    assert picture.size() == plot.size() * plot.devicePixelRatio()
    assert "Saved as test.PNG" in window.find(QLabel, "benchNote").text()
    window.dialog.files.save(window.bench.runs[0], tmp_path / "nowhere" / "test.png")
    assert "test.png was not saved" in window.find(QLabel, "benchNote").text()


def test_a_test_that_cannot_be_saved_is_told(window: Window, tmp_path: Path) -> None:
    window.dialog.files.save(run_of(READINGS), tmp_path / "nowhere" / "test.csv")
    assert "test.csv was not saved" in window.find(QLabel, "benchNote").text()


def test_escape_leaves_the_window_and_its_result(window: Window) -> None:
    QTest.keyClick(window.dialog, Qt.Key.Key_Escape)
    assert window.dialog.isVisible()


def test_every_control_has_a_name_for_those_who_cannot_see_it(window: Window) -> None:
    kinds = (QAbstractButton, QComboBox, QAbstractSpinBox, FiguresTable, BenchPlot)
    found = [
        widget
        for widget in window.dialog.findChildren(QWidget)
        if isinstance(widget, kinds) and widget.objectName().startswith("bench")
    ]
    assert len(found) >= 17
    for widget in found:
        interface = QAccessible.queryAccessibleInterface(widget)
        assert interface is not None
        assert interface.text(QAccessible.Text.Name), widget.objectName()


def test_the_mouse_over_the_plot_reads_the_values(window: Window, qtbot: QtBot) -> None:
    window.bench.keep(run_of(READINGS))
    plot = window.find(BenchPlot, "benchPlot")
    qtbot.waitUntil(lambda: plot.highest >= 12.0)
    viewport = window.find(QWidget, "benchCurrents")
    where = QPointF(viewport.width() / 2, viewport.height() / 2)
    none = Qt.MouseButton.NoButton
    event = QMouseEvent(
        QEvent.Type.MouseMove,
        where,
        QPointF(viewport.mapToGlobal(where.toPoint())),
        none,
        none,
        Qt.KeyboardModifier.NoModifier,
    )
    QCoreApplication.sendEvent(viewport, event)
    assert window.find(QLabel, "benchValues").text().endswith("+40  4.00 A")


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_both_schemes_are_drawn(window: Window, scheme: str) -> None:
    theme().set_scheme("dark" if scheme == "dark" else "light")
    window.bench.keep(run_of(READINGS))
    assert not window.dialog.grab().isNull()
    theme().set_scheme("system")
