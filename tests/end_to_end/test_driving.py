"""A person drives a simulated board with mouse and keys; what counts is what its motors do."""

import sys
from collections.abc import Callable
from functools import partial
from typing import TypeVar

import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QKeyEvent, QPointingDevice
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QApplication,
    QCheckBox,
    QLabel,
    QLineEdit,
    QListView,
    QMenu,
    QSlider,
    QSpinBox,
    QStyle,
    QStyleOptionSlider,
    QTreeView,
    QWidget,
)
from pytestqt.qtbot import QtBot

from tests.link.helpers import moving
from tests.support.virtual_devices import VirtualSimulator
from trex_gui.link.settings import LinkSettings
from trex_gui.model.device import Link
from trex_gui.model.driving.lockout import remembered_lockout
from trex_gui.model.driving.timeout import weakness_on
from trex_gui.protocol.commands import Drive, DriveAuxiliary, DriveBoth, DriveMotor
from trex_gui.protocol.line_settings import LineSettings
from trex_gui.views.widgets.speed_slider import SpeedSlider
from trex_gui.window import Program

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")

BRAKE = ("brake", 127)
LEFT = Qt.MouseButton.LeftButton

WidgetT = TypeVar("WidgetT", bound=QWidget)


class Driver:
    """The Motors page of a window with a simulated board."""

    def __init__(self, program: Program, simulator: VirtualSimulator, qtbot: QtBot) -> None:
        self.program, self.device, self.window = program, program.device, program.window
        self.motors, self.simulator, self.qtbot = program.device.motors, simulator, qtbot
        self.device.connect_to(LinkSettings(simulator.url))
        self.wait(lambda: self.device.link is Link.UP)
        self.open_page(3)
        self.window.activateWindow()
        self.wait(self.window.isActiveWindow)

    def wait(self, condition: Callable[[], bool]) -> None:
        self.qtbot.waitUntil(condition, timeout=20_000)

    def find(self, kind: type[WidgetT], name: str) -> WidgetT:
        found = self.window.findChild(kind, name)
        assert isinstance(found, kind), name
        return found

    def text(self, name: str) -> str:
        return self.find(QLabel, name).text()

    def open_page(self, index: int) -> None:
        self.window.pages.setCurrentIndex(index)

    def press(self, name: str) -> None:
        button = self.find(QAbstractButton, name)
        assert button.isEnabled(), f"{name} is greyed"
        QTest.mouseClick(button, LEFT, pos=QPoint(8, button.height() // 2))

    def arm(self) -> None:
        self.wait(self.find(QAbstractButton, "motorsRunButton").isEnabled)
        self.press("motorsRunButton")
        self.wait(self.pad.isEnabled)

    # --- What the board does ------------------------------------------------------------

    def runs(self, motor: int) -> tuple[str, int]:
        shown = self.simulator.show()["motors"][motor - 1]
        return shown["target_direction"], shown["target_speed"]

    def wait_for(self, first: tuple[str, int] | None, second: tuple[str, int] | None) -> None:
        """Wait until the board's motors do this; `None`: whatever they do."""
        for motor, wanted in enumerate((first, second), 1):
            if wanted is not None:
                self.qtbot.waitUntil(partial(self._check, motor, wanted), timeout=20_000)

    def _check(self, motor: int, wanted: tuple[str, int]) -> None:
        said = self.text(f"motor{motor}Asked"), self.text("motorsReason")
        assert self.runs(motor) == wanted, said

    # --- What hands do ------------------------------------------------------------------

    @property
    def pad(self) -> QWidget:
        return self.find(QWidget, "drivePad")

    def in_pad(self, forward: float, turn: float) -> QPoint:
        """Where the pad means this; its ends are beyond what the knob can reach."""
        middle, reach = self.pad.rect().center(), min(self.pad.width(), self.pad.height()) / 2
        return middle + QPoint(round(turn * reach), round(-forward * reach))

    def hold_pad(self, forward: float, turn: float) -> None:
        QTest.mousePress(self.pad, LEFT, pos=self.pad.rect().center())
        QTest.mouseMove(self.pad, self.in_pad(forward, turn))

    def let_go_of_pad(self, place: QPoint | None = None) -> None:
        QTest.mouseRelease(self.pad, LEFT, pos=place or self.pad.rect().center())

    def slider(self, motor: str) -> SpeedSlider:
        return self.find(SpeedSlider, f"{motor}Slider")

    def place_of(self, slider: QSlider, value: int) -> QPoint:
        option = QStyleOptionSlider()
        slider.initStyleOption(option)
        part = QStyle.SubControl.SC_SliderHandle
        style = slider.style()
        handle = style.subControlRect(QStyle.ComplexControl.CC_Slider, option, part, slider)
        room = slider.width() - handle.width()
        along = QStyle.sliderPositionFromValue(slider.minimum(), slider.maximum(), value, room)
        return QPoint(along + handle.width() // 2, handle.center().y())

    def drag(self, motor: str, value: int) -> None:
        slider = self.slider(motor)
        QTest.mousePress(slider, LEFT, pos=self.place_of(slider, slider.value()))
        QTest.mouseMove(slider, self.place_of(slider, value))

    def release(self, motor: str, place: QPoint | None = None) -> None:
        slider = self.slider(motor)
        QTest.mouseRelease(slider, LEFT, pos=place or self.place_of(slider, slider.value()))

    def key_down(self, key: Qt.Key) -> None:
        QTest.keyPress(self.window.windowHandle(), key)

    def key_up(self, key: Qt.Key) -> None:
        QTest.keyRelease(self.window.windowHandle(), key)


@pytest.fixture
def driver(program: Program, quick_simulator: VirtualSimulator, qtbot: QtBot) -> Driver:
    return Driver(program, quick_simulator, qtbot)


@pytest.fixture
def armed(driver: Driver) -> Driver:
    driver.arm()
    return driver


@pytest.fixture
def keys(armed: Driver) -> Driver:
    """With driving by keys switched on."""
    armed.press("driveWithKeys")
    return armed


# --- Sliders ----------------------------------------------------------------------------


def test_nothing_is_sent_before_run_motor(driver: Driver) -> None:
    before = driver.simulator.show()["motors"]
    driver.drag("motor1", 100)
    driver.release("motor1")
    driver.hold_pad(1, 0)
    driver.let_go_of_pad()
    driver.key_down(Qt.Key.Key_W)
    driver.key_up(Qt.Key.Key_W)
    QTest.keyClicks(driver.find(QSpinBox, "motor2Entry"), "55\r")
    assert not driver.motors.armed
    assert driver.simulator.show()["motors"] == before
    assert "nothing is sent yet" in driver.text("motorsReason")


def test_a_dragged_slider_drives_and_stays_where_it_was_let_go(armed: Driver) -> None:
    armed.drag("motor1", 60)
    armed.wait_for(("forward", 60), None)
    armed.release("motor1")
    armed.qtbot.wait(100)
    assert armed.runs(1) == ("forward", 60)
    assert armed.slider("motor1").value() == 60
    assert "forward 60 (47 %)" in armed.text("motor1Asked")


def hold_the_pad(driver: Driver) -> Callable[[], None]:
    driver.hold_pad(1, 0)
    return driver.let_go_of_pad


def hold_a_key(driver: Driver) -> Callable[[], None]:
    driver.pad.setFocus()
    driver.key_down(Qt.Key.Key_Up)
    return lambda: driver.key_up(Qt.Key.Key_Up)


def hold_a_slider_of_linked_motors(driver: Driver) -> Callable[[], None]:
    for name in ("returnToZero", "linkMotors"):
        box = driver.find(QCheckBox, name)
        if not box.isChecked():
            driver.press(name)
    driver.drag("motor2", 127)
    return lambda: driver.release("motor2")


@pytest.mark.parametrize(
    "hold",
    [hold_the_pad, hold_a_key, hold_a_slider_of_linked_motors],
    ids=lambda each: each.__name__,
)
def test_every_packet_of_a_control_for_both_motors_is_for_both(
    armed: Driver, hold: Callable[[Driver], Callable[[], None]]
) -> None:
    """Else one wheel begins, or brakes, a packet before the other."""
    sent = bytearray()
    armed.simulator.on_write = sent.extend
    for _ in range(20):
        let_go = hold(armed)
        armed.wait_for(("forward", 127), ("forward", 127))
        let_go()
        armed.wait_for(BRAKE, BRAKE)
    driven = moving(sent)
    pairs = [command for command in driven if isinstance(command, DriveBoth)]
    assert len(pairs) >= 40
    # On a busy machine an answer may be late, and what rests is told to rest again, one by one.
    doing = dict.fromkeys((1, 2), Drive.brake())
    for command in driven:
        match command:
            case DriveBoth(motor1=first, motor2=second):
                doing = {1: first, 2: second}
            case DriveMotor(motor=motor, drive=drive):
                assert doing[motor] == drive, "one motor alone does something else"
            case DriveAuxiliary(speed=speed):
                assert speed == 0


def test_leaving_the_page_with_a_slider_in_hand_stops_and_disarms(armed: Driver) -> None:
    """Without *Return to zero* it would go on, and nobody could see it."""
    armed.drag("motor1", 60)
    armed.wait_for(("forward", 60), None)
    armed.open_page(0)
    armed.wait_for(BRAKE, BRAKE)
    assert not armed.motors.armed
    assert "Motors page was left" in armed.motors.stop_reason


@pytest.mark.parametrize("deactivated", [False, True])
def test_minimising_the_window_with_a_slider_in_hand_stops_and_disarms(
    armed: Driver, *, deactivated: bool
) -> None:
    armed.drag("motor1", 60)
    armed.wait_for(("forward", 60), None)
    if deactivated:  # as most systems do first
        other = QLineEdit()
        armed.qtbot.addWidget(other)
        other.show()
        other.activateWindow()
        armed.wait(lambda: not armed.window.isActiveWindow())
        armed.qtbot.wait(20)
        assert armed.motors.armed
    armed.window.showMinimized()
    armed.wait_for(BRAKE, BRAKE)
    assert not armed.motors.armed


def test_leaving_the_page_with_a_slider_that_was_let_go_drives_on(armed: Driver) -> None:
    armed.drag("motor1", 60)
    armed.wait_for(("forward", 60), None)
    armed.release("motor1")
    armed.qtbot.wait(20)
    armed.open_page(0)
    armed.qtbot.wait(100)
    assert armed.runs(1) == ("forward", 60)
    assert armed.motors.armed


def test_a_slider_that_springs_back_brakes_its_motor(armed: Driver) -> None:
    armed.press("returnToZero")
    armed.drag("motor2", -80)
    armed.wait_for(None, ("reverse", 80))
    armed.release("motor2")
    armed.wait_for(None, BRAKE)
    assert armed.slider("motor2").value() == 0
    assert armed.motors.armed


def test_a_slider_let_go_far_outside_springs_back_all_the_same(armed: Driver) -> None:
    armed.press("returnToZero")
    armed.drag("motor1", 80)
    armed.wait_for(("forward", 80), None)
    armed.release("motor1", QPoint(-4000, 4000))
    armed.wait_for(BRAKE, None)


def test_a_slider_moved_with_keys_springs_back_when_the_key_goes_up(armed: Driver) -> None:
    armed.press("returnToZero")
    slider = armed.slider("motor1")
    slider.setFocus()
    for _ in range(3):
        QTest.keyPress(slider, Qt.Key.Key_PageUp)
    armed.wait_for(("forward", 48), None)
    QTest.keyRelease(slider, Qt.Key.Key_PageUp)
    armed.wait_for(BRAKE, None)


def test_a_held_slider_that_loses_the_focus_springs_back(armed: Driver) -> None:
    armed.press("returnToZero")
    armed.drag("motor1", 80)
    armed.wait_for(("forward", 80), None)
    armed.find(QSpinBox, "motor2Entry").setFocus()
    armed.wait_for(BRAKE, None)
    QTest.mouseMove(armed.slider("motor1"), armed.place_of(armed.slider("motor1"), 100))
    armed.qtbot.wait(50)
    assert armed.runs(1) == BRAKE


def test_a_number_typed_with_enter_drives(armed: Driver) -> None:
    entry = armed.find(QSpinBox, "motor2Entry")
    entry.setFocus()
    entry.selectAll()
    QTest.keyClicks(entry, "-45")
    QTest.keyClick(entry, Qt.Key.Key_Return)
    armed.wait_for(None, ("reverse", 45))
    assert armed.slider("motor2").value() == -45


def test_a_number_that_was_not_entered_never_drives(armed: Driver) -> None:
    sent: list[object] = []
    armed.motors.requested.connect(sent.append)
    entry = armed.find(QSpinBox, "motor1Entry")
    entry.setFocus()
    entry.selectAll()
    QTest.keyClicks(entry, "120")
    armed.find(QAbstractButton, "stopButton").setFocus(Qt.FocusReason.MouseFocusReason)
    assert entry.value() == 0
    entry.setFocus()
    entry.selectAll()
    QTest.keyClicks(entry, "120")
    armed.open_page(0)
    assert not [wish for wish in sent if "120" in repr(wish)]


def test_the_auxiliary_motor_is_driven_one_way(armed: Driver) -> None:
    armed.drag("aux", 70)
    armed.wait(lambda: armed.simulator.show()["aux"]["target_speed"] == 70)
    armed.release("aux")
    armed.press("auxZero")
    armed.wait(lambda: armed.simulator.show()["aux"]["target_speed"] == 0)


def test_brake_brakes_as_hard_as_is_set(armed: Driver) -> None:
    entry = armed.find(QSpinBox, "brakeEntry")
    entry.setValue(40)
    armed.press("motor1Brake")
    armed.wait_for(("brake", 40), None)
    entry.setValue(0)
    armed.press("motor1Brake")
    armed.wait_for(("brake", 0), None)
    assert armed.text("motor1Asked") == "Asked: coast"


def test_stop_takes_a_slider_out_of_the_hand_and_back_to_zero(armed: Driver) -> None:
    armed.drag("motor1", 90)
    armed.wait_for(("forward", 90), None)
    QTest.keyClick(armed.window.windowHandle(), Qt.Key.Key_Escape)
    QTest.mouseMove(armed.slider("motor1"), armed.place_of(armed.slider("motor1"), 120))
    armed.wait_for(BRAKE, BRAKE)
    assert armed.slider("motor1").value() == 0
    assert not armed.motors.armed


def test_linked_motors_do_the_same(armed: Driver) -> None:
    armed.press("linkMotors")
    armed.drag("motor1", 33)
    armed.release("motor1")
    armed.wait_for(("forward", 33), ("forward", 33))
    armed.drag("motor2", -50)
    armed.release("motor2")
    armed.wait_for(("reverse", 50), ("reverse", 50))
    armed.hold_pad(1.0, 0.5)
    armed.wait_for(("forward", 127), ("forward", 127))
    armed.let_go_of_pad()
    armed.wait_for(BRAKE, BRAKE)


def test_motors_that_run_differently_cannot_be_linked_until_they_do_not(armed: Driver) -> None:
    box = armed.find(QCheckBox, "linkMotors")
    armed.drag("motor1", 50)
    armed.release("motor1")
    armed.wait_for(("forward", 50), None)
    assert not box.isEnabled()
    assert "run differently" in box.toolTip()
    QTest.mouseClick(box, LEFT, pos=QPoint(8, box.height() // 2))
    assert not box.isChecked()
    armed.press("motor1Brake")
    armed.wait_for(BRAKE, None)
    armed.press("linkMotors")
    assert box.isChecked()
    assert armed.motors.linked
    assert armed.motors.drive(2) is None  # a tick asks for nothing


# --- The ceiling ------------------------------------------------------------------------


def test_no_greater_speed_than_the_ceiling_is_sent(armed: Driver) -> None:
    armed.find(QSpinBox, "ceilingEntry").setValue(50)
    armed.drag("motor1", 127)
    armed.wait_for(("forward", 50), None)
    assert armed.slider("motor1").value() == 50
    armed.release("motor1")
    armed.hold_pad(-1.0, 0.0)
    armed.wait_for(("reverse", 50), ("reverse", 50))


def test_lowering_the_ceiling_slows_down_what_runs_faster(armed: Driver) -> None:
    armed.motors.set_speed(1, 120)
    armed.wait_for(("forward", 120), None)
    armed.find(QSlider, "ceilingSlider").setValue(64)
    armed.wait_for(("forward", 64), None)
    assert armed.find(QSpinBox, "motor1Entry").maximum() == 64
    assert armed.find(QSpinBox, "ceilingEntry").text() == "64 (50 %)"


def type_into(entry: QSpinBox, text: str) -> None:
    entry.setFocus()
    entry.selectAll()
    QTest.keyClicks(entry, text)


@pytest.mark.parametrize("name", ["ceilingEntry", "brakeEntry", "lockoutEntry"])
def test_an_option_that_was_typed_without_enter_is_given_up(armed: Driver, name: str) -> None:
    entry = armed.find(QSpinBox, name)
    before = entry.value()
    type_into(entry, "7")
    armed.find(QAbstractButton, "stopButton").setFocus(Qt.FocusReason.TabFocusReason)
    assert entry.value() == before
    type_into(entry, "7")
    armed.open_page(0)
    assert entry.value() == before
    assert (armed.motors.ceiling, armed.motors.release_brake, armed.motors.lockout) == (127, 127, 3)


def test_a_half_typed_ceiling_neither_slows_down_nor_speeds_up(armed: Driver) -> None:
    entry = armed.find(QSpinBox, "ceilingEntry")
    armed.motors.set_speed(1, 90)
    armed.wait_for(("forward", 90), None)
    type_into(entry, "5")
    armed.motors.set_speed(2, 20)  # whatever changes meanwhile leaves what is typed alone
    armed.wait_for(("forward", 90), ("forward", 20))
    assert entry.text().startswith("5")
    QTest.keyClicks(entry, "0\r")
    armed.wait_for(("forward", 50), ("forward", 20))
    assert entry.text() == "50 (39 %)"
    type_into(entry, "127\r")
    assert armed.motors.ceiling == 127
    armed.qtbot.wait(100)
    assert armed.runs(1) == ("forward", 50)


def test_raising_the_ceiling_under_a_held_pad_makes_nothing_faster(armed: Driver) -> None:
    armed.find(QSpinBox, "ceilingEntry").setValue(50)
    armed.hold_pad(1, 0)
    armed.wait_for(("forward", 50), ("forward", 50))
    armed.motors.set_ceiling(127)
    QTest.mouseMove(armed.pad, armed.in_pad(1, 0) - QPoint(0, 1))
    armed.qtbot.wait(50)
    assert armed.runs(1) == ("forward", 50)
    armed.let_go_of_pad()
    armed.wait_for(BRAKE, BRAKE)
    armed.hold_pad(1, 0)
    armed.wait_for(("forward", 127), ("forward", 127))


# --- The lock after Stop ----------------------------------------------------------------


def test_how_long_stop_locks_is_set_here_and_remembered(armed: Driver) -> None:
    entry = armed.find(QSpinBox, "lockoutEntry")
    assert entry.text() == "3 s"
    assert "Run motor" in entry.toolTip()
    assert "Seconds" in entry.accessibleName()
    type_into(entry, "8\r")
    QTest.keyClick(armed.window.windowHandle(), Qt.Key.Key_Escape)
    assert 3 < armed.motors.locked_for <= 8  # not the three that it was
    assert remembered_lockout() == 8


def test_without_a_lock_the_motors_can_be_armed_right_after_stop(armed: Driver) -> None:
    entry = armed.find(QSpinBox, "lockoutEntry")
    type_into(entry, "0\r")
    assert entry.text() == "none (0 s)"
    QTest.keyClick(armed.window.windowHandle(), Qt.Key.Key_Escape)
    assert not armed.motors.armed
    armed.arm()
    assert armed.motors.armed


# --- The pad ----------------------------------------------------------------------------


def test_the_pad_drives_forward_and_back(armed: Driver) -> None:
    armed.hold_pad(1, 0)
    armed.wait_for(("forward", 127), ("forward", 127))
    QTest.mouseMove(armed.pad, armed.in_pad(-1, 0))
    armed.wait_for(("reverse", 127), ("reverse", 127))


def test_the_pad_turns_on_the_spot(armed: Driver) -> None:
    armed.hold_pad(0, 1)
    armed.wait_for(("forward", 127), ("reverse", 127))


def test_the_pad_springs_back_and_brakes_when_it_is_let_go(armed: Driver) -> None:
    armed.hold_pad(1, 0)
    armed.wait_for(("forward", 127), None)
    armed.let_go_of_pad()
    armed.wait_for(BRAKE, BRAKE)
    assert armed.motors.armed
    assert "At rest" in armed.pad.accessibleDescription()


def test_the_pad_let_go_outside_of_the_window_brakes(armed: Driver) -> None:
    armed.hold_pad(1, 0)
    armed.wait_for(("forward", 127), None)
    armed.let_go_of_pad(QPoint(-5000, 200))
    armed.wait_for(BRAKE, BRAKE)


def test_the_pad_that_loses_the_focus_brakes(armed: Driver) -> None:
    armed.hold_pad(1, 0)
    armed.wait_for(("forward", 127), None)
    armed.find(QSpinBox, "motor2Entry").setFocus()
    armed.wait_for(BRAKE, BRAKE)
    QTest.mouseMove(armed.pad, armed.in_pad(-1, 0))
    armed.qtbot.wait(50)
    assert armed.runs(1) == BRAKE


@pytest.mark.qt_log_ignore("This plugin does not support", extend=True)  # said by offscreen
def test_a_menu_that_opens_over_the_pad_brakes(armed: Driver) -> None:
    armed.hold_pad(1, 0)
    armed.wait_for(("forward", 127), None)
    menu = QMenu(armed.window)
    menu.addAction("anything")
    menu.popup(armed.window.mapToGlobal(QPoint(10, 10)))
    armed.wait_for(BRAKE, BRAKE)
    menu.close()


def test_another_window_in_front_brakes(armed: Driver) -> None:
    armed.hold_pad(1, 0)
    armed.wait_for(("forward", 127), None)
    other = QLineEdit()
    armed.qtbot.addWidget(other)
    other.show()
    other.activateWindow()
    armed.wait_for(BRAKE, BRAKE)


def test_a_finger_drives_the_pad_and_lets_go(armed: Driver) -> None:
    finger = QTest.createTouchDevice()
    assert isinstance(finger, QPointingDevice)
    QTest.touchEvent(armed.pad, finger).press(0, armed.pad.rect().center(), armed.pad).commit()
    QTest.touchEvent(armed.pad, finger).move(0, armed.in_pad(1, 0), armed.pad).commit()
    armed.wait_for(("forward", 127), ("forward", 127))
    QTest.touchEvent(armed.pad, finger).release(0, armed.in_pad(1, 0), armed.pad).commit()
    armed.wait_for(BRAKE, BRAKE)


def test_leaving_the_page_with_the_pad_held_stops_and_disarms(armed: Driver) -> None:
    armed.hold_pad(1, 0)
    armed.wait_for(("forward", 127), None)
    armed.open_page(0)
    armed.wait_for(BRAKE, BRAKE)
    assert not armed.motors.armed
    armed.open_page(3)
    assert "page was left" in armed.text("motorsReason")


def test_escape_with_the_pad_held_needs_a_new_press(armed: Driver) -> None:
    armed.hold_pad(1, 0)
    armed.wait_for(("forward", 127), None)
    QTest.keyClick(armed.window.windowHandle(), Qt.Key.Key_Escape)
    QTest.mouseMove(armed.pad, armed.in_pad(0.5, 0))
    armed.wait_for(BRAKE, BRAKE)


def test_the_pad_has_the_motors_while_it_is_held(armed: Driver) -> None:
    armed.hold_pad(1, 0)
    armed.wait_for(("forward", 127), None)
    armed.find(QSpinBox, "motor1Entry").setValue(-20)
    armed.qtbot.wait(50)
    assert armed.runs(1) == ("forward", 127)


# --- Keys -------------------------------------------------------------------------------


def test_keys_drive_while_they_are_held(keys: Driver) -> None:
    keys.key_down(Qt.Key.Key_Up)
    keys.wait_for(("forward", 127), ("forward", 127))
    keys.key_up(Qt.Key.Key_Up)
    keys.wait_for(BRAKE, BRAKE)
    assert keys.motors.armed


def test_two_keys_make_a_curve(keys: Driver) -> None:
    keys.key_down(Qt.Key.Key_W)
    keys.key_down(Qt.Key.Key_D)
    keys.wait_for(("forward", 127), ("forward", 42))
    keys.key_up(Qt.Key.Key_W)
    keys.wait_for(("forward", 127), ("reverse", 127))
    keys.key_up(Qt.Key.Key_D)
    keys.wait_for(BRAKE, BRAKE)


def test_keys_do_nothing_unless_switched_on(armed: Driver) -> None:
    before = armed.simulator.show()["motors"]
    armed.find(QCheckBox, "returnToZero").setFocus()
    armed.key_down(Qt.Key.Key_W)
    armed.key_up(Qt.Key.Key_W)
    armed.qtbot.wait(50)
    assert armed.simulator.show()["motors"] == before


def test_arrow_keys_in_the_pad_drive_without_being_switched_on(armed: Driver) -> None:
    armed.pad.setFocus()
    armed.key_down(Qt.Key.Key_Down)
    armed.wait_for(("reverse", 127), ("reverse", 127))
    assert "back 100%" in armed.pad.accessibleDescription()
    armed.key_up(Qt.Key.Key_Down)
    armed.wait_for(BRAKE, BRAKE)


def test_keys_in_the_pad_let_go_when_the_focus_leaves_it(armed: Driver) -> None:
    armed.pad.setFocus()
    armed.key_down(Qt.Key.Key_Up)
    armed.wait_for(("forward", 127), ("forward", 127))
    armed.find(QAbstractButton, "motor1Zero").setFocus()
    armed.wait_for(BRAKE, BRAKE)


def test_keys_let_go_when_the_focus_goes_where_keys_are_needed(keys: Driver) -> None:
    keys.key_down(Qt.Key.Key_W)
    keys.wait_for(("forward", 127), None)
    keys.find(QSpinBox, "motor1Entry").setFocus()
    keys.wait_for(BRAKE, BRAKE)


@pytest.mark.parametrize(
    "end",
    [
        lambda keys: keys.key_up(Qt.Key.Key_Z),
        lambda keys: keys.key_up(Qt.Key.Key_8),
        lambda keys: keys.key_down(Qt.Key.Key_Shift),
        lambda keys: keys.key_down(Qt.Key.Key_NumLock),
    ],
)
def test_keys_that_cannot_be_told_any_more_let_go(
    keys: Driver, end: Callable[[Driver], None]
) -> None:
    keys.key_down(Qt.Key.Key_W)
    keys.wait_for(("forward", 127), None)
    end(keys)
    assert not keys.motors.holder
    keys.wait_for(BRAKE, BRAKE)


def test_a_key_is_known_by_its_place_whatever_it_is_called(keys: Driver) -> None:
    window = keys.window.windowHandle()
    none, place = Qt.KeyboardModifier.NoModifier, 25

    def send(kind: QEvent.Type, key: Qt.Key, scan_code: int) -> None:
        QApplication.sendEvent(window, QKeyEvent(kind, key, none, scan_code, 0, 0))

    send(QEvent.Type.KeyPress, Qt.Key.Key_W, place)
    send(QEvent.Type.KeyPress, Qt.Key.Key_D, 40)
    keys.wait_for(("forward", 127), ("forward", 42))
    send(QEvent.Type.KeyRelease, Qt.Key.Key_Z, place)
    keys.wait_for(("forward", 127), ("reverse", 127))
    send(QEvent.Type.KeyRelease, Qt.Key.Key_D, 40)
    keys.wait_for(BRAKE, BRAKE)


def test_a_slider_with_the_focus_does_not_take_the_arrow_keys(keys: Driver) -> None:
    keys.slider("motor1").setFocus()
    keys.key_down(Qt.Key.Key_Right)
    keys.wait_for(("forward", 127), ("reverse", 127))
    keys.key_up(Qt.Key.Key_Right)
    keys.wait_for(BRAKE, BRAKE)


def test_a_number_field_keeps_its_keys(keys: Driver) -> None:
    entry = keys.find(QSpinBox, "brakeEntry")
    entry.setFocus()
    keys.key_down(Qt.Key.Key_Down)
    keys.key_up(Qt.Key.Key_Down)
    assert entry.value() == 126
    assert keys.runs(1)[1] == 0 or keys.runs(1)[0] == "brake"
    assert not keys.motors.holder


def test_repeated_presses_of_a_held_key_are_one(keys: Driver) -> None:
    keys.key_down(Qt.Key.Key_W)
    keys.wait_for(("forward", 127), None)
    window = keys.window.windowHandle()
    for _ in range(5):
        QTest.simulateEvent(window, True, Qt.Key.Key_W, Qt.KeyboardModifier.NoModifier, "w", True)
        QTest.simulateEvent(window, False, Qt.Key.Key_W, Qt.KeyboardModifier.NoModifier, "w", True)
    assert keys.motors.holder
    assert keys.runs(1) == ("forward", 127)
    keys.key_up(Qt.Key.Key_W)
    keys.wait_for(BRAKE, BRAKE)


def test_a_shortcut_is_no_driving(keys: Driver) -> None:
    QTest.keyPress(
        keys.window.windowHandle(), Qt.Key.Key_Right, Qt.KeyboardModifier.ControlModifier
    )
    assert not keys.motors.holder


def test_a_window_that_loses_the_focus_lets_go_of_the_keys(keys: Driver) -> None:
    keys.key_down(Qt.Key.Key_W)
    keys.wait_for(("forward", 127), None)
    other = QLineEdit()
    keys.qtbot.addWidget(other)
    other.show()
    other.activateWindow()
    keys.wait_for(BRAKE, BRAKE)


def test_leaving_the_page_with_a_key_held_stops_and_disarms(keys: Driver) -> None:
    keys.key_down(Qt.Key.Key_W)
    keys.wait_for(("forward", 127), None)
    keys.open_page(5)
    keys.wait_for(BRAKE, BRAKE)
    assert not keys.motors.armed


def test_keys_on_another_page_do_not_drive(keys: Driver) -> None:
    keys.open_page(5)
    keys.find(QTreeView, "parametersView").setFocus()
    keys.key_down(Qt.Key.Key_Down)
    keys.key_up(Qt.Key.Key_Down)
    assert not keys.motors.holder


def test_stop_with_a_key_held_needs_a_new_press(keys: Driver) -> None:
    keys.key_down(Qt.Key.Key_W)
    keys.wait_for(("forward", 127), None)
    keys.press("stopButton")
    keys.wait_for(BRAKE, BRAKE)
    keys.key_up(Qt.Key.Key_W)
    assert not keys.motors.armed


# --- Modes ------------------------------------------------------------------------------


def test_where_channels_drive_the_page_shows_what_they_wish_for(driver: Driver) -> None:
    driver.simulator.do("jumper mode rc")
    driver.simulator.do("power cycle")
    driver.wait(lambda: "RC channels control the motors" in driver.text("motorsReason"))
    driver.wait(lambda: not driver.simulator.show()["safe_start"])
    driver.simulator.do("channel 2 1800us")
    driver.wait(lambda: "Channel 2: forward" in driver.text("motor2Asked"))
    assert not driver.slider("motor2").isVisible()
    assert not driver.pad.isVisible()
    assert driver.find(QWidget, "motor2Channel").isVisible()
    assert not driver.find(QAbstractButton, "motorsRunButton").isEnabled()
    driver.simulator.do("channel 2 1500us")


def test_a_stick_away_from_rest_at_power_up_is_perhaps_held_by_safe_start(driver: Driver) -> None:
    driver.simulator.do("jumper mode rc")
    driver.simulator.do("channel 2 1800us")
    driver.simulator.do("power cycle")
    driver.wait(lambda: "perhaps held by safe-start" in driver.text("motorsReason"))
    assert driver.simulator.show()["safe_start"]
    driver.simulator.do("channel 2 1500us")
    driver.wait(lambda: not driver.simulator.show()["safe_start"])
    driver.wait(lambda: "perhaps" not in driver.text("motorsReason"))
    driver.simulator.do("channel 2 1800us")
    driver.wait(lambda: "Channel 2: forward" in driver.text("motor2Asked"))
    driver.qtbot.wait(100)
    assert "perhaps" not in driver.text("motorsReason")
    driver.simulator.do("channel 2 1500us")


def test_who_is_in_control_stands_beside_the_wish(driver: Driver) -> None:
    driver.wait(lambda: "serial in control, 0.00 A" in driver.text("motor1Reported"))
    assert "waits" not in driver.text("motor1Reported")  # in serial mode channels drive nothing
    driver.simulator.do("jumper mode rc")
    driver.simulator.do("power cycle")
    driver.wait(lambda: "serial not in control" in driver.text("motor1Reported"))
    driver.wait(lambda: "serial not in control" in driver.text("auxReported"))
    driver.wait(lambda: not driver.simulator.show()["safe_start"])  # it wins over the override
    driver.simulator.do("channel 5 1000us")
    driver.simulator.do("channel 2 1300us")
    driver.wait(lambda: "channel 2 waits with −" in driver.text("motor2Reported"))
    assert "serial in control" in driver.text("motor2Reported")
    driver.simulator.do("channel 2 1500us")
    driver.simulator.do("channel 5 1500us")


def test_a_required_channel_without_signal_is_named(driver: Driver) -> None:
    driver.simulator.do("jumper mode rc")
    driver.simulator.do("power cycle")
    driver.wait(lambda: "RC channels" in driver.text("motorsReason"))
    driver.simulator.do("channel 1 silent")
    driver.wait(lambda: "channel 1 is required and has no signal" in driver.text("motorsReason"))


def test_with_the_override_switch_on_the_page_drives_until_it_goes_off(driver: Driver) -> None:
    driver.simulator.do("jumper mode rc")
    driver.simulator.do("power cycle")
    driver.wait(lambda: "RC channels" in driver.text("motorsReason"))
    driver.simulator.do("channel 5 1000us")
    driver.wait(lambda: "Channel 5 overrides" in driver.text("motorsReason"))
    driver.arm()
    driver.hold_pad(1, 0)
    driver.wait_for(("forward", 127), ("forward", 127))
    driver.simulator.do("channel 5 2000us")
    driver.wait(lambda: "RC channels" in driver.text("motorsReason"))
    assert not driver.motors.armed
    assert not driver.pad.isVisible()
    driver.simulator.do("channel 5 1500us")


def test_after_stop_the_page_says_for_how_long_the_motors_are_locked(armed: Driver) -> None:
    armed.press("stopButton")
    assert "locked for" in armed.text("motorsReason")
    assert not armed.find(QAbstractButton, "motorsRunButton").isEnabled()


def test_joint_mode_leaves_one_motor_and_nothing_to_turn_with(driver: Driver) -> None:
    driver.device.parameters.edit("motor_mode", 1)
    driver.device.apply()
    driver.wait(lambda: not driver.device.applying)
    driver.simulator.do("power off")
    driver.wait(lambda: driver.device.link is Link.SILENT)
    assert "does not answer" in driver.text("motorsReason")
    driver.simulator.do("power on")
    driver.wait(lambda: driver.device.is_joint and driver.motors.can_arm)
    driver.arm()
    assert driver.text("motor1Title") == "Motor (joint)"
    assert not driver.slider("motor2").isEnabled()
    assert not driver.find(QCheckBox, "linkMotors").isEnabled()
    driver.hold_pad(1, 1)
    driver.wait_for(("forward", 127), None)
    driver.let_go_of_pad()
    driver.wait_for(BRAKE, None)


def test_a_fault_is_named_with_what_to_do(armed: Driver) -> None:
    armed.motors.set_speed(1, 60)
    armed.simulator.do("fault 1 on")
    armed.wait(lambda: "Motor 1 without drive" in armed.text("motorsReason"))
    armed.simulator.do("fault 1 off")
    armed.wait(lambda: "armed" in armed.text("motorsReason"))


# --- Facts ------------------------------------------------------------------------------


def test_a_fact_leads_to_its_parameter(driver: Driver) -> None:
    facts = driver.find(QLabel, "motorsFacts")
    assert "no ramp" in facts.text()
    facts.linkActivated.emit("motor2_current_limit")
    view = driver.find(QTreeView, "parametersView")
    assert view.isVisible()
    assert "Current Limit" in str(view.currentIndex().siblingAtColumn(0).data())


def test_every_control_has_a_name_for_who_does_not_see_it(driver: Driver) -> None:
    page = driver.find(QWidget, "motorsPage")
    for widget in page.findChildren(QWidget):
        is_part = "qt_" in widget.objectName() or isinstance(widget, QListView)
        is_silent = isinstance(widget, QLabel) and not widget.text()
        if is_part or is_silent or widget.focusPolicy() is Qt.FocusPolicy.NoFocus:
            continue
        named = widget.accessibleName() or getattr(widget, "text", str)()
        assert named, f"{type(widget).__name__} {widget.objectName()}"
        assert widget.objectName(), named


def test_the_page_fits_a_small_window_without_scrolling_sideways(driver: Driver) -> None:
    driver.window.resize(900, 600)
    for motor in (1, 2):  # as much as the board can say at once
        driver.find(QLabel, f"motor{motor}Reported").setText("Board: serial in control, " * 4)
    QApplication.processEvents()
    page = driver.find(QWidget, "motorsPage")
    area = page.parentWidget()
    assert area is not None
    assert page.minimumSizeHint().width() <= area.width()
    assert QPointF(page.width(), 0).x() <= area.width()


# --- A serial timeout that is too short -------------------------------------------------


def test_a_timeout_that_a_slow_line_cannot_keep_fed_is_said_and_set_with_a_click(
    program: Program, simulator: VirtualSimulator, qtbot: QtBot
) -> None:
    simulator.do("eeprom uart_settings 0")  # 1200 baud
    simulator.do("eeprom serial_timeout 1")
    simulator.do("power cycle")
    device = program.device
    device.connect_to(LinkSettings(simulator.url, LineSettings(1200)))
    qtbot.waitUntil(lambda: device.link is Link.UP, timeout=30_000)
    notice = program.window.findChild(QWidget, "timeoutNotice")
    label = program.window.findChild(QLabel, "timeoutLabel")
    button = program.window.findChild(QAbstractButton, "timeoutButton")
    assert notice is not None
    assert label is not None
    assert button is not None
    assert notice.isVisible()
    assert "0.1 s is short for 1200 baud" in label.text()
    assert "faster baud rate" in label.text()
    assert button.accessibleName() == "Set the serial timeout to 0.5 seconds"
    with qtbot.waitSignal(device.applied, timeout=20_000):
        button.click()
    assert device.serial_timeout_s == pytest.approx(0.5)
    assert not notice.isVisible()


@pytest.mark.parametrize(
    ("url", "baud", "timeout", "said", "offered"),
    [
        ("/dev/ttyUSB0", 19200, 0.1, "", 0.0),
        ("/dev/ttyUSB0", 2400, 0.2, "", 0.0),
        ("/dev/ttyUSB0", 2400, 0.1, "short for 2400 baud", 0.5),
        ("/dev/ttyUSB0", 1200, 0.0, "is off", 0.5),
        ("socket://robot:23", 19200, 0.5, "short for a network port", 1.0),
        ("socket://robot:23", 19200, 0.0, "is off", 1.0),
        ("socket://robot:23", 19200, 1.0, "", 0.0),
    ],
)
def test_what_is_said_of_a_timeout_fits_the_line(
    url: str, baud: int, timeout: float, said: str, offered: float
) -> None:
    weakness = weakness_on(LinkSettings(url, LineSettings(baud)), timeout)
    assert (weakness is None) == (not said)
    if weakness is not None:
        assert said in weakness.text
        assert weakness.seconds == offered
