"""Pad and slider under mouse, touch and keys."""

from collections.abc import Callable
from itertools import product
from typing import Any

import pytest
from PySide6.QtCore import QEvent, QPoint, Qt
from PySide6.QtGui import QPointingDevice, QTouchEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QHBoxLayout, QPushButton, QWidget
from pytestqt.qtbot import QtBot

from tests.support.accessible_names import spoken_state
from tests.support.window import LEFT, WidgetDriver
from trex_gui.devices.trex.views.pages.motors.drive_control import SpeedEntry, SpeedSlider
from trex_gui.devices.trex.views.pages.motors.drive_pad import DrivePad


class DriveControlsDriver(WidgetDriver):
    """Window with a pad, a slider and a button.

    Attributes:
        setpoints: forward and turn, from the signals of the pad.
        released: "pad" or "slider", for each release.
    """

    def __init__(self, qtbot: QtBot) -> None:
        self.window = QWidget()
        super().__init__(self.window, qtbot)
        qtbot.addWidget(self.window)
        self.pad = DrivePad(self.window)
        self.slider = SpeedSlider(-127, self.window)
        self.other_button = QPushButton("other", self.window)
        layout = QHBoxLayout(self.window)
        for widget in (self.pad, self.slider, self.other_button):
            layout.addWidget(widget)
        self.setpoints: list[tuple[float, float]] = []
        self.released: list[str] = []
        self.pad.steered.connect(lambda *setpoint: self.setpoints.append(setpoint))
        self.pad.released.connect(lambda: self.released.append("pad"))
        self.slider.released.connect(lambda: self.released.append("slider"))
        self.window.resize(600, 300)
        with qtbot.waitExposed(self.window):
            self.window.show()
        self.window.activateWindow()
        self.wait(self.window.isActiveWindow)


@pytest.fixture
def controls(qtbot: QtBot) -> DriveControlsDriver:
    return DriveControlsDriver(qtbot)


@pytest.mark.parametrize("can_turn", [True, False])
def test_pad_position_sets_forward_and_turn(
    controls: DriveControlsDriver, *, can_turn: bool
) -> None:
    controls.pad.set_can_turn(can_turn)
    QTest.mousePress(controls.pad, LEFT, pos=controls.pad.rect().center() + QPoint(40, -80))
    forward, turn = controls.setpoints[-1]
    assert 0 < forward <= 1
    assert (0 < turn < forward) if can_turn else turn == 0
    QTest.mouseMove(controls.pad, controls.pad.rect().center() + QPoint(2, -80))
    assert controls.setpoints[-1][1] == 0, "positions near an axis do not turn"
    QTest.mouseMove(controls.pad, QPoint(3000, 3000))
    assert controls.setpoints[-1] == (-1, 1 if can_turn else 0), "limited by the edge"


def cancel_touch(pad: DrivePad) -> None:
    finger = QTest.createTouchDevice()
    assert isinstance(finger, QPointingDevice)
    QApplication.sendEvent(pad, QTouchEvent(QEvent.Type.TouchCancel, finger))


ENDS: list[Callable[[DriveControlsDriver, Any], object]] = [
    lambda _controls, control: QTest.mouseRelease(control, LEFT, pos=QPoint(5, 5)),
    lambda controls, _control: controls.other_button.setFocus(),
    lambda _controls, control: control.setEnabled(False),
    lambda controls, _control: controls.window.setEnabled(False),
    lambda _controls, control: control.hide(),
    lambda controls, _control: controls.window.hide(),
    lambda _controls, control: control.release(),
    lambda _controls, control: QApplication.sendEvent(control, QEvent(QEvent.Type.UngrabMouse)),
]
PAD_ENDS: list[Callable[[DriveControlsDriver, Any], object]] = [
    lambda _controls, pad: QTest.mousePress(pad, Qt.MouseButton.RightButton),
    lambda _controls, pad: pad.set_can_turn(False),
    lambda _controls, pad: cancel_touch(pad),
    lambda _controls, pad: QApplication.sendEvent(pad, QEvent(QEvent.Type.WindowDeactivate)),
]


@pytest.mark.qt_log_ignore("not accepted by receiving widget", extend=True)  # disabled widget
@pytest.mark.parametrize(
    ("name", "end"), [*product(("pad", "slider"), ENDS), *product(("pad",), PAD_ENDS)]
)
def test_control_is_released_once_and_then_ignores_the_mouse(
    controls: DriveControlsDriver,
    name: str,
    end: Callable[[DriveControlsDriver, QWidget], object],
) -> None:
    pad, slider = controls.pad, controls.slider
    control, place = {
        "pad": (pad, pad.rect().center() - QPoint(0, 40)),
        "slider": (slider, controls.handle_of(slider)),
    }[name]
    QTest.mousePress(control, LEFT, pos=place)
    assert pad.held or slider.held
    end(controls, control)
    assert controls.released == [name]
    before = (len(controls.setpoints), slider.value())
    QTest.mouseMove(control, QPoint(20, 20))
    assert (len(controls.setpoints), slider.value()) == before
    assert "At rest" in spoken_state(pad)


def test_no_single_key_sets_full_speed(controls: DriveControlsDriver) -> None:
    controls.slider.setFocus()
    controls.slider.setValue(40)
    QTest.keyClick(controls.slider, Qt.Key.Key_End)
    assert controls.slider.value() == 40
    QTest.keyClick(controls.slider, Qt.Key.Key_Home)
    assert controls.slider.value() == 0


def test_second_finger_changes_nothing(controls: DriveControlsDriver) -> None:
    finger = QTest.createTouchDevice()
    assert isinstance(finger, QPointingDevice)
    centre = controls.pad.rect().center()
    QTest.touchEvent(controls.pad, finger).press(0, centre - QPoint(0, 60), controls.pad).commit()
    first = controls.setpoints[-1]
    both = QTest.touchEvent(controls.pad, finger)
    both.stationary(0)
    both.press(1, centre + QPoint(0, 60), controls.pad).commit()
    assert controls.setpoints[-1] == first
    assert controls.pad.held
    event = QTest.touchEvent(controls.pad, finger)
    event.release(0, centre, controls.pad)
    event.stationary(1).commit()
    assert controls.released == ["pad"]
    QTest.touchEvent(controls.pad, finger).release(1, centre, controls.pad).commit()


@pytest.mark.parametrize("button", [Qt.MouseButton.MiddleButton, Qt.MouseButton.RightButton])
@pytest.mark.qt_log_ignore("not accepted by receiving widget", extend=True)
def test_only_left_button_moves_a_slider(
    controls: DriveControlsDriver, button: Qt.MouseButton
) -> None:
    handle = controls.handle_of(controls.slider)
    QTest.mousePress(controls.slider, button, pos=handle)
    QTest.mouseMove(controls.slider, handle - QPoint(0, 30))
    QTest.mouseRelease(controls.slider, button, pos=handle - QPoint(0, 30))
    assert controls.slider.value() == 0
    assert not controls.slider.held
    QTest.mousePress(controls.slider, LEFT, pos=handle)
    QTest.mouseRelease(controls.slider, button, pos=handle)
    assert controls.slider.held


def test_key_holds_the_slider_until_it_is_released(controls: DriveControlsDriver) -> None:
    controls.slider.setFocus()
    QTest.keyPress(controls.slider, Qt.Key.Key_PageUp)
    assert controls.slider.held
    QTest.keyRelease(controls.slider, Qt.Key.Key_9)  # the key code has changed
    assert controls.released == ["slider"]
    value = controls.slider.value()
    key, none = Qt.Key.Key_PageUp, Qt.KeyboardModifier.NoModifier
    QTest.simulateEvent(controls.slider, True, key, none, "", True)  # auto-repeat
    assert controls.slider.value() == value
    assert not controls.slider.held


def type_number(qtbot: QtBot, text: str) -> tuple[SpeedEntry, list[int]]:
    """Type text into an entry. Return the entry and the list of its chosen speeds."""
    entry = SpeedEntry()
    qtbot.addWidget(entry)
    entry.setRange(-127, 127)
    chosen: list[int] = []
    entry.chosen.connect(chosen.append)
    entry.show()
    entry.activateWindow()
    entry.setFocus()
    qtbot.waitUntil(entry.hasFocus)
    entry.show_setpoint(7)
    entry.selectAll()
    QTest.keyClicks(entry, text)
    return entry, chosen


def test_setpoint_does_not_overwrite_a_typed_number(qtbot: QtBot) -> None:
    entry, chosen = type_number(qtbot, "10")
    entry.show_setpoint(30)
    assert entry.text() == "10"
    QTest.keyClick(entry, Qt.Key.Key_Return)
    assert chosen == [10]
    entry.show_setpoint(30)
    assert entry.text() == "30"


def test_number_is_sent_once_and_a_step_immediately(qtbot: QtBot) -> None:
    entry, chosen = type_number(qtbot, "7")
    QTest.keyClick(entry, Qt.Key.Key_Return)
    QTest.keyClick(entry, Qt.Key.Key_Return)
    assert chosen == [7]
    QTest.keyClick(entry, Qt.Key.Key_Up)
    assert chosen[-1] == 8


@pytest.mark.parametrize("end", [SpeedEntry.clearFocus, SpeedEntry.hide, SpeedEntry.close])
def test_unentered_number_is_discarded(qtbot: QtBot, end: Callable[[SpeedEntry], object]) -> None:
    entry, chosen = type_number(qtbot, "100")
    entry.show_setpoint(30)
    end(entry)
    assert not chosen
    assert entry.text() == "30"
