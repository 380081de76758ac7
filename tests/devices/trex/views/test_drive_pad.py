"""Pad and slider under mouse, touch and keys."""

from collections.abc import Callable

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
        self.pad.steered.connect(lambda *way: self.setpoints.append(way))
        self.pad.released.connect(lambda: self.released.append("pad"))
        self.slider.released.connect(lambda: self.released.append("slider"))
        self.window.resize(600, 300)
        with qtbot.waitExposed(self.window):
            self.window.show()
        self.window.activateWindow()
        self.wait(self.window.isActiveWindow)

    def hold_pad(self) -> None:
        QTest.mousePress(self.pad, LEFT, pos=self.pad.rect().center() - QPoint(0, 40))


@pytest.fixture
def controls(qtbot: QtBot) -> DriveControlsDriver:
    return DriveControlsDriver(qtbot)


@pytest.mark.parametrize("can_turn", [True, False])
def test_pad_maps_its_places_to_forward_and_turn(
    controls: DriveControlsDriver, *, can_turn: bool
) -> None:
    controls.pad.set_can_turn(can_turn)
    QTest.mousePress(controls.pad, LEFT, pos=controls.pad.rect().center() + QPoint(40, -80))
    forward, turn = controls.setpoints[-1]
    assert 0 < forward <= 1
    assert (0 < turn < forward) if can_turn else turn == 0
    QTest.mouseMove(controls.pad, controls.pad.rect().center() + QPoint(2, -80))
    assert controls.setpoints[-1][1] == 0, "near an axis"
    QTest.mouseMove(controls.pad, QPoint(3000, 3000))
    assert controls.setpoints[-1] == (-1, 1 if can_turn else 0), "beyond its edge"


def cancel_touch(pad: DrivePad) -> None:
    finger = QTest.createTouchDevice()
    assert isinstance(finger, QPointingDevice)
    cancelled = QTouchEvent(QEvent.Type.TouchCancel, finger)
    QApplication.sendEvent(pad, cancelled)


@pytest.mark.qt_log_ignore("not accepted by receiving widget", extend=True)  # disabled widget
@pytest.mark.parametrize(
    "end",
    [
        lambda controls: QTest.mouseRelease(controls.pad, LEFT, pos=QPoint(5, 5)),
        lambda controls: QTest.mousePress(controls.pad, Qt.MouseButton.RightButton),
        lambda controls: controls.other_button.setFocus(),
        lambda controls: controls.pad.setEnabled(False),
        lambda controls: controls.window.setEnabled(False),
        lambda controls: controls.pad.hide(),
        lambda controls: controls.window.hide(),
        lambda controls: controls.pad.set_can_turn(False),
        lambda controls: controls.pad.release(),
        lambda controls: cancel_touch(controls.pad),
        lambda controls: QApplication.sendEvent(controls.pad, QEvent(QEvent.Type.UngrabMouse)),
        lambda controls: QApplication.sendEvent(controls.pad, QEvent(QEvent.Type.WindowDeactivate)),
    ],
)
def test_pad_is_released_once_and_then_ignores_the_mouse(
    controls: DriveControlsDriver, end: Callable[[DriveControlsDriver], object]
) -> None:
    controls.hold_pad()
    end(controls)
    assert controls.released == ["pad"]
    count = len(controls.setpoints)
    QTest.mouseMove(controls.pad, QPoint(20, 20))
    assert len(controls.setpoints) == count
    assert "At rest" in spoken_state(controls.pad)


@pytest.mark.parametrize(
    "end",
    [
        lambda controls: QTest.mouseRelease(controls.slider, LEFT, pos=QPoint(5, 5)),
        lambda controls: controls.other_button.setFocus(),
        lambda controls: controls.slider.setEnabled(False),
        lambda controls: controls.window.hide(),
        lambda controls: controls.slider.release(),
        lambda controls: QApplication.sendEvent(controls.slider, QEvent(QEvent.Type.UngrabMouse)),
    ],
)
def test_slider_is_released_once_and_then_ignores_the_mouse(
    controls: DriveControlsDriver, end: Callable[[DriveControlsDriver], object]
) -> None:
    QTest.mousePress(controls.slider, LEFT, pos=controls.handle_of(controls.slider))
    assert controls.slider.held
    end(controls)
    assert controls.released == ["slider"]
    value = controls.slider.value()
    QTest.mouseMove(controls.slider, QPoint(20, 20))
    assert controls.slider.value() == value


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


def typing_in(qtbot: QtBot, text: str) -> tuple[SpeedEntry, list[int]]:
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
    entry, chosen = typing_in(qtbot, "10")
    entry.show_setpoint(30)
    assert entry.text() == "10"
    QTest.keyClick(entry, Qt.Key.Key_Return)
    assert chosen == [10]
    entry.show_setpoint(30)
    assert entry.text() == "30"


def test_retyped_number_is_sent_once_and_a_step_at_once(qtbot: QtBot) -> None:
    entry, chosen = typing_in(qtbot, "7")
    QTest.keyClick(entry, Qt.Key.Key_Return)
    QTest.keyClick(entry, Qt.Key.Key_Return)
    assert chosen == [7]
    QTest.keyClick(entry, Qt.Key.Key_Up)
    assert chosen[-1] == 8


@pytest.mark.parametrize("leave", [SpeedEntry.clearFocus, SpeedEntry.hide, SpeedEntry.close])
def test_unentered_number_is_discarded(qtbot: QtBot, leave: Callable[[SpeedEntry], object]) -> None:
    entry, chosen = typing_in(qtbot, "100")
    entry.show_setpoint(30)
    leave(entry)
    assert not chosen
    assert entry.text() == "30"
