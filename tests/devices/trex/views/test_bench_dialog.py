"""Dialog for bench tests, and its hold button."""

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QCoreApplication, QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QKeyEvent, QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QCheckBox, QDoubleSpinBox, QSpinBox, QWidget
from pytestqt.qtbot import QtBot

from tests.devices.trex.bench.runs import run_of
from tests.support.pages.bench_dialog import BenchTestDialog
from tests.support.window import LEFT, WidgetDriver
from trex_gui.devices.trex.bench.run import End, Profile, Shape
from trex_gui.devices.trex.model.bench import Bench
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.views.bench.dialog import BenchDialog
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.behaviour import HoldButton

# --- The button -------------------------------------------------------------------------


class HoldButtonDriver(WidgetDriver):
    """Hold button in a window with another field.

    Attributes:
        signals: "held" and "released", in the order of the signals.
    """

    def __init__(self, qtbot: QtBot) -> None:
        window = QWidget()
        super().__init__(window, qtbot)
        window.resize(300, 120)
        self.other_field = QSpinBox(window)
        self.other_field.move(0, 70)
        self.widget = HoldButton("Hold", window)
        self.widget.resize(200, 60)
        self.signals: list[str] = []
        self.widget.hold_started.connect(lambda: self.signals.append("held"))
        self.widget.hold_ended.connect(lambda: self.signals.append("released"))
        qtbot.addWidget(window)
        window.show()
        window.activateWindow()
        self.widget.setFocus()
        self.wait(self.widget.hasFocus)

    def press(self) -> None:
        QTest.mousePress(self.widget, LEFT)

    def release(self) -> None:
        QTest.mouseRelease(self.widget, LEFT)

    def move(self, to: QPoint) -> None:
        """Move with the mouse button pressed."""
        event = QMouseEvent(
            QEvent.Type.MouseMove,
            QPointF(to),
            QPointF(self.widget.mapToGlobal(to)),
            LEFT,
            LEFT,
            Qt.KeyboardModifier.NoModifier,
        )
        QCoreApplication.sendEvent(self.widget, event)

    def send_space(self, kind: QEvent.Type, *, repeated: bool = False) -> None:
        none = Qt.KeyboardModifier.NoModifier
        event = QKeyEvent(kind, Qt.Key.Key_Space, none, " ", repeated)
        QCoreApplication.sendEvent(self.widget, event)


@pytest.fixture
def hold_button(qtbot: QtBot) -> HoldButtonDriver:
    return HoldButtonDriver(qtbot)


def test_space_bar_holds_button_and_repeats_are_ignored(hold_button: HoldButtonDriver) -> None:
    hold_button.send_space(QEvent.Type.KeyPress)
    for _ in range(3):
        hold_button.send_space(QEvent.Type.KeyRelease, repeated=True)
        hold_button.send_space(QEvent.Type.KeyPress, repeated=True)
    assert hold_button.signals == ["held"]
    hold_button.send_space(QEvent.Type.KeyRelease)
    assert hold_button.signals == ["held", "released"]


def test_disabled_button_cannot_be_held(hold_button: HoldButtonDriver) -> None:
    hold_button.widget.setEnabled(False)
    hold_button.press()
    assert hold_button.signals == []


def test_returning_mouse_does_not_hold_a_released_button(hold_button: HoldButtonDriver) -> None:
    hold_button.press()
    assert (hold_button.signals, hold_button.widget.is_held) == (["held"], True)
    hold_button.move(QPoint(500, 500))
    assert hold_button.signals == ["held", "released"]
    hold_button.move(QPoint(10, 10))
    assert not hold_button.widget.is_held
    hold_button.release()
    assert hold_button.signals == ["held", "released"]


CAUSES: dict[str, Callable[[HoldButtonDriver], object]] = {
    "the button is released": lambda hold_button: hold_button.release(),
    "another field gets the focus": lambda hold_button: hold_button.other_field.setFocus(),
    "the button is disabled": lambda hold_button: hold_button.widget.setEnabled(False),
    "the button is hidden": lambda hold_button: hold_button.widget.hide(),
    "the window is hidden": lambda hold_button: hold_button.root.hide(),
    "another window is activated": lambda hold_button: QCoreApplication.sendEvent(
        hold_button.widget, QEvent(QEvent.Type.WindowDeactivate)
    ),
    "the mouse grab is lost": lambda hold_button: QCoreApplication.sendEvent(
        hold_button.widget, QEvent(QEvent.Type.UngrabMouse)
    ),
    "the touch is cancelled": lambda hold_button: QCoreApplication.sendEvent(
        hold_button.widget, QEvent(QEvent.Type.TouchCancel)
    ),
}


@pytest.mark.parametrize("cause", CAUSES)
def test_loss_of_input_releases_the_button(hold_button: HoldButtonDriver, cause: str) -> None:
    hold_button.press()
    CAUSES[cause](hold_button)
    assert hold_button.signals == ["held", "released"]


# --- The window -------------------------------------------------------------------------


@pytest.fixture
def dialog(qtbot: QtBot, qapp: QApplication) -> Iterator[BenchTestDialog]:
    theme().install(qapp)
    device = Device()
    bench = Bench(device)
    dialog = BenchDialog(device, bench)
    qtbot.addWidget(dialog)
    dialog.show_in_front()
    yield BenchTestDialog(dialog, device, bench, qtbot)
    dialog.close()


def test_stop_button_stops_on_press(dialog: BenchTestDialog) -> None:
    stop = dialog.button("benchStopButton")
    stop.setEnabled(True)
    dialog.device.driving.may_move = True
    with dialog.qtbot.waitSignal(dialog.device.stop_pressed_offline):
        QTest.mousePress(stop, LEFT)


def test_form_fields_define_the_plan(dialog: BenchTestDialog) -> None:
    assert not dialog.is_enabled("benchHoldButton")
    assert "Connect to a board" in dialog.shown_note
    period = dialog.find(QDoubleSpinBox, "benchPeriod")
    assert not period.isEnabled(), "a step has no period"
    dialog.select("benchMotor", 2)
    dialog.select("benchShape", Shape.SINE)
    dialog.select("benchDirection", -1)
    speed = dialog.find(QSpinBox, "benchSpeed")
    dialog.motors.set_ceiling(50)
    assert speed.maximum() == 50
    speed.setValue(35)
    dialog.find(QDoubleSpinBox, "benchDuration").setValue(6.5)
    assert period.isEnabled()
    period.setValue(1.25)
    dialog.select("benchSent", False)
    dialog.find(QDoubleSpinBox, "benchAbort").setValue(7.5)
    dialog.find(QCheckBox, "benchAbortAtLimit").setChecked(True)
    plan = dialog.bench.plan
    assert plan.motor == 2
    assert plan.profile == Profile(shape=Shape.SINE, speed=-35, duration=6.5, period=1.25)
    assert not plan.accelerate
    assert plan.abort_current == 7.5
    assert plan.abort_at_limit
    dialog.wait(lambda: dialog.plot.seconds == pytest.approx(7.1))  # duration of the plan


READINGS = [(index / 80, 12.0 if index < 10 else 4.0) for index in range(160)]
LOWER_READINGS = [(index / 80, 6.0 if index < 10 else 4.0) for index in range(160)]


def test_result_is_compared_with_the_previous_or_selected_run(dialog: BenchTestDialog) -> None:
    dialog.bench.add_run(run_of(READINGS))
    assert [dialog.figure(0, column) for column in range(3)] == ["12.00 A", "–", "–"]
    dialog.bench.add_run(run_of(LOWER_READINGS))
    assert [dialog.figure(0, column) for column in range(3)] == ["6.00 A", "12.00 A", "−6.00 A"]
    assert dialog.figure(1, 0) == "4.00 A"
    dialog.wait(lambda: dialog.plot.highest >= 12.0)

    dialog.bench.add_run(run_of(LOWER_READINGS))
    compare = dialog.combo("benchCompare")
    assert dialog.figure(0, 1) == "6.00 A"
    compare.setCurrentIndex(compare.count() - 1)  # the oldest
    assert dialog.figure(0, 1) == "12.00 A"


def test_reason_for_an_abort_is_shown(dialog: BenchTestDialog) -> None:
    reason = "Motor 1 drew 12.00 A, more than the abort current of 10 A."
    dialog.bench.add_run(run_of(READINGS, ended=0.5, end=End.ABORTED, reason=reason))
    note = dialog.shown_note
    assert f"Aborted after 0.50 s: {reason}" in note


def test_saved_run_can_be_opened(dialog: BenchTestDialog, tmp_path: Path) -> None:
    dialog.bench.add_run(run_of(READINGS))
    path = tmp_path / "test.csv"
    dialog.dialog.save_run(dialog.bench.runs[0], path)
    dialog.wait_for_files()
    assert "Saved as test.csv" in dialog.shown_note
    dialog.dialog.open_run(path)
    dialog.wait_for_files()
    assert len(dialog.bench.runs) == 2
    assert dialog.figure(0, 2) == "+0.00 A"


@pytest.mark.parametrize(
    ("content", "text"),
    [
        (b"product: TReX\n", "a bench test begins with"),
        (b"\xff\xfe\x00", "it is not a text file"),
        (None, "was not opened"),
    ],
)
def test_invalid_file_is_rejected_with_the_reason(
    dialog: BenchTestDialog, tmp_path: Path, content: bytes | None, text: str
) -> None:
    path = tmp_path / "other.csv"
    if content is not None:
        path.write_bytes(content)
    dialog.dialog.open_run(path)
    dialog.wait_for_files()
    assert text in dialog.shown_note
    assert dialog.bench.runs == ()
