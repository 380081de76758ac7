"""Driving of a simulated board with mouse, keys and an SDL gamepad."""

import pytest
from PySide6.QtCore import QEvent, QPoint, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QCheckBox, QLabel, QMenu, QSlider, QSpinBox, QTableView

from tests.devices.trex.session.helpers import motor_commands_in
from tests.gamepad.virtual_pad import VirtualPad
from tests.support.accessible_names import spoken_state
from tests.support.pages.gamepad_panel import GamepadPanelPage, Y
from tests.support.pages.motors import BRAKE, FULL, Gesture, MotorsPage, is_stopped
from tests.support.simulator import SimulatedDevice
from tests.support.virtual_devices import VirtualSimulator
from tests.support.window import WindowDriver
from trex_gui.devices.trex.views.pages.motors.gamepad_panel import GamepadPanel
from trex_gui.devices.trex.views.pages.motors.key_driver import KeyDriver
from trex_gui.ui.preferences import Preferences

LOW = 30
"""Speed ceiling that a held control reaches soon."""

FORWARD, BACK = ("forward", LOW), ("reverse", LOW)
CURVE = (FORWARD, ("forward", 10))
"""Setpoints while W and D are held."""


@pytest.fixture
def page(connected_window: WindowDriver, quick_simulator: VirtualSimulator) -> MotorsPage:
    return MotorsPage(connected_window, quick_simulator)


@pytest.fixture
def armed(page: MotorsPage) -> MotorsPage:
    page.arm()
    return page


@pytest.fixture
def keys(armed: MotorsPage) -> MotorsPage:
    """Armed page that is driven by keys."""
    armed.click("driveWithKeys")
    return armed


# --- Arm, sliders, numbers --------------------------------------------------------------


def test_unarmed_controls_send_nothing(page: MotorsPage) -> None:
    sent = bytearray()
    page.simulator.on_write = sent.extend  # type: ignore[attr-defined]
    before = page.simulator.show()["motors"]
    page.drag("motor1Slider", 100)
    page.hold_pad(1, 0)
    page.release_pad()
    page.click_key(Qt.Key.Key_W)
    QTest.keyClicks(page.find(QSpinBox, "motor2Entry"), "55\r")
    page.let_nothing_happen(0.1)
    assert not page.is_armed()
    assert page.simulator.show()["motors"] == before
    assert not motor_commands_in(sent)
    assert "no motor is driven" in page.text("motorsReason")


def test_slider_entry_and_brake_button_drive_their_motor(armed: MotorsPage) -> None:
    armed.hold_slider("motor1Slider", 60)
    armed.wait_for_targets(("forward", 60), None)
    armed.release_slider("motor1Slider")
    armed.let_nothing_happen(0.1)
    assert armed.target(1) == ("forward", 60)
    assert armed.slider_value("motor1Slider") == 60
    assert armed.text("motor1Setpoint") == "47 %"

    armed.type_into("motor2Entry", "-45")
    armed.wait_for_targets(None, ("reverse", 45))
    assert armed.slider_value("motor2Slider") == -45
    assert "right 41\u00a0%" in spoken_state(armed.pad)

    armed.drag("auxSlider", 70)
    armed.wait(lambda: armed.auxiliary_target == 70)
    armed.click("auxZero")
    armed.wait(lambda: armed.auxiliary_target == 0)

    armed.type_into("brakeEntry", "40")
    armed.click("motor1Brake")
    armed.wait_for_targets(("brake", 40), None)
    armed.type_into("brakeEntry", "0")
    armed.click("motor1Brake")
    armed.wait_for_targets(("brake", 0), None)
    assert armed.text("motor1Setpoint") == "coast"


def test_half_typed_number_is_discarded_and_changes_no_speed(armed: MotorsPage) -> None:
    sent: list[object] = []
    armed.motors.requested.connect(sent.append)
    for name in ("motor1Entry", "ceilingEntry", "brakeEntry", "lockoutEntry"):
        entry = armed.find(QSpinBox, name)
        before = entry.value()
        for reason in (Qt.FocusReason.MouseFocusReason, Qt.FocusReason.TabFocusReason):
            armed.type_into(name, "7", enter=False)
            armed.button("stopButton").setFocus(reason)
            assert entry.value() == before, (name, reason)
        armed.type_into(name, "7", enter=False)
        armed.open_page("boardPage")
        assert entry.value() == before, name
        armed.show_page()
    motors = armed.motors
    assert (motors.ceiling, motors.release_brake, motors.lockout) == (127, 127, 3)
    armed.let_nothing_happen(0.1)
    assert not sent
    assert armed.target(1)[0] == "brake"

    entry = armed.find(QSpinBox, "ceilingEntry")
    armed.motors.set_speed(1, 90)
    armed.wait_for_targets(("forward", 90), None)
    armed.type_into("ceilingEntry", "5", enter=False)
    armed.motors.set_speed(2, 20)  # other changes do not affect the typed text
    armed.wait_for_targets(("forward", 90), ("forward", 20))
    assert entry.text().startswith("5")
    QTest.keyClicks(entry, "0\r")
    armed.wait_for_targets(("forward", 50), ("forward", 20))
    assert entry.text() == "50 (39 %)"
    armed.type_into("ceilingEntry", "127")
    assert armed.motors.ceiling == 127
    armed.let_nothing_happen(0.1)
    assert armed.target(1) == ("forward", 50)


def test_return_to_zero_slider_brakes_at_every_release(armed: MotorsPage) -> None:
    armed.click("returnToZero")
    armed.hold_slider("motor2Slider", -80)
    armed.wait_for_targets(None, ("reverse", 80))
    armed.release_slider("motor2Slider")
    armed.wait_for_targets(None, BRAKE)
    assert armed.slider_value("motor2Slider") == 0
    assert armed.is_armed()

    slider = armed.find(QSlider, "motor1Slider")
    slider.setFocus()
    for _ in range(3):
        QTest.keyPress(slider, Qt.Key.Key_PageUp)
    armed.wait_for_targets(("forward", 48), None)
    QTest.keyRelease(slider, Qt.Key.Key_PageUp)
    armed.wait_for_targets(BRAKE, None, "key")


# --- Leave and stop ---------------------------------------------------------------------


def test_leaving_page_with_held_control_stops_and_disarms(keys: MotorsPage) -> None:
    """Otherwise a slider without *Return to zero* would keep driving on a hidden page."""
    sixty = ("forward", 60)
    controls: dict[str, tuple[Gesture, Gesture]] = {
        "slider": (
            lambda: keys.hold_slider("motor1Slider", 60),
            lambda: keys.release_slider("motor1Slider"),
        ),
        "pad": (lambda: keys.hold_pad(1, 0), keys.release_pad),
        "key": (
            lambda: keys.press_key(Qt.Key.Key_W),
            lambda: keys.release_key(Qt.Key.Key_W),
        ),
    }
    for name, (hold, release) in controls.items():
        hold()
        keys.wait_for_targets(sixty if name == "slider" else FULL, None, name)
        keys.open_page("parametersPage" if name == "key" else "boardPage")
        keys.wait_for_brake(name)
        assert not keys.is_armed()
        assert "Motors page was left" in keys.motors.stop_reason
        keys.show_page()
        assert "page was left" in keys.text("motorsReason")
        release()
        keys.arm()

    keys.drag("motor1Slider", 60)
    keys.wait_for_targets(sixty, None)
    keys.let_nothing_happen(0.02)
    sign = keys.open_page("boardPage").find(QLabel, "motorsSign")
    assert sign.accessibleName() == "Now"
    keys.let_nothing_happen(0.1)
    assert keys.target(1) == sixty, "a released slider keeps driving"
    assert keys.is_armed()

    keys.show_page()
    keys.click("stopOnLeaving")
    keys.open_page("boardPage")
    keys.wait_for_brake("every control was released")
    assert not keys.is_armed()
    assert keys.motors.stop_reason == "The Motors page was left."
    keys.show_page()
    keys.arm()
    keys.window.showMinimized()
    keys.wait(lambda: not keys.is_armed())
    assert Preferences().flag("motors/stop_on_leaving", default=False), "the option is saved"


def test_focus_moves_from_arming_to_stop_button(page: MotorsPage) -> None:
    ceiling = page.motors.ceiling
    run = page.button("runButton")
    assert "Nothing moves yet" in run.accessibleDescription()
    run.setFocus()
    QTest.keyClick(run, Qt.Key.Key_Space)
    page.wait(page.is_armed)
    assert page.button("stopButton").hasFocus()
    for key in (Qt.Key.Key_Up, Qt.Key.Key_Right, Qt.Key.Key_PageUp, Qt.Key.Key_Home):
        page.click_key(key)
    assert page.motors.ceiling == ceiling
    assert not page.motors.text
    page.click_key(Qt.Key.Key_Space)
    assert not page.is_armed()
    page.wait(run.isEnabled)

    facts = page.find(QLabel, "motorsStored")
    assert facts.isEnabled()
    facts.linkActivated.emit("motor2_current_limit")
    view = page.find(QTableView, "parametersView")
    assert view.isVisible()
    assert "Current Limit" in str(view.currentIndex().siblingAtColumn(0).data())
    page.disconnect()
    assert not facts.isEnabled(), "the next board may store other values"
    assert "no ramp" in facts.text()
    assert "href" not in facts.text()


def test_stop_moves_focus_to_stop_button(armed: MotorsPage) -> None:
    slider, entry = armed.find(QSlider, "motor1Slider"), armed.find(QSpinBox, "motor2Entry")
    for control in (slider, entry, armed.pad):
        control.setFocus()
        armed.motors.stop()
        assert armed.button("stopButton").hasFocus(), control.objectName()
        armed.arm()


def test_minimizing_with_held_slider_stops_and_disarms(armed: MotorsPage) -> None:
    armed.hold_slider("motor1Slider", 60)
    armed.wait_for_targets(("forward", 60), None)
    armed.window.showMinimized()
    armed.wait_for_brake()
    assert not armed.is_armed()
    armed.release_slider("motor1Slider")
    armed.window.showNormal()
    armed.activate()

    armed.arm()
    armed.hold_slider("motor1Slider", 60)
    armed.wait_for_targets(("forward", 60), None)
    with armed.another_window():  # most systems deactivate a window first
        armed.let_nothing_happen(0.02)
        assert armed.is_armed()
        armed.window.showMinimized()
        armed.wait_for_brake("deactivated")
        assert not armed.is_armed()
        armed.window.showNormal()


def test_held_control_needs_new_press_after_stop(keys: MotorsPage) -> None:
    keys.type_into("lockoutEntry", "0")
    keys.hold_slider("motor1Slider", 90)
    keys.wait_for_targets(("forward", 90), None)
    keys.press_escape()
    keys.move_slider("motor1Slider", 120)
    keys.wait_for_brake("slider")
    assert keys.slider_value("motor1Slider") == 0
    assert not keys.is_armed()
    keys.arm()
    keys.move_slider("motor1Slider", 100)
    keys.let_nothing_happen(0.05)
    assert keys.target(1)[0] == "brake"
    keys.release_slider("motor1Slider")

    keys.hold_pad(1, 0)
    keys.wait_for_targets(FULL, None)
    keys.press_escape()
    keys.move_pad(0.5, 0)
    keys.wait_for_brake("pad")
    keys.arm()
    keys.move_pad(1, 0)
    keys.let_nothing_happen(0.05)
    assert keys.target(1)[0] == "brake"
    keys.release_pad()

    keys.press_key(Qt.Key.Key_W)
    keys.wait_for_targets(FULL, None)
    keys.click("stopButton")
    keys.wait_for_brake("key")
    keys.release_key(Qt.Key.Key_W)
    assert not keys.is_armed()


# --- The pad ----------------------------------------------------------------------------


@pytest.mark.qt_log_ignore("This plugin does not support", extend=True)  # offscreen
def test_pad_drives_while_held(armed: MotorsPage) -> None:
    armed.motors.set_ceiling(LOW)
    armed.hold_pad(1, 0)
    armed.wait_for_targets(FORWARD, FORWARD)
    armed.move_pad(-1, 0)
    armed.wait_for_targets(BACK, BACK)
    armed.move_pad(0, 1)
    armed.wait_for_targets(FORWARD, BACK)
    armed.find(QSpinBox, "motor1Entry").setValue(-20)
    armed.let_nothing_happen(0.05)
    assert armed.target(1) == FORWARD, "the pad controls the motors"
    armed.release_pad()
    armed.wait_for_brake()
    assert armed.is_armed()
    assert "At rest" in spoken_state(armed.pad)

    armed.hold_pad(1, 0)
    armed.wait_for_targets(FORWARD, None)
    menu = QMenu(armed.window)
    menu.addAction("anything")
    menu.popup(armed.window.mapToGlobal(QPoint(10, 10)))
    armed.wait_for_brake("menu")
    menu.close()
    armed.release_pad()

    armed.hold_pad(1, 0)
    armed.wait_for_targets(FORWARD, None)
    with armed.another_window():
        armed.wait_for_brake("another window")


# --- Keys -------------------------------------------------------------------------------


def test_keys_drive_in_pad_and_if_enabled_elsewhere(armed: MotorsPage) -> None:
    armed.motors.set_ceiling(LOW)
    before = armed.simulator.show()["motors"]
    armed.find(QCheckBox, "returnToZero").setFocus()
    armed.click_key(Qt.Key.Key_W)
    armed.let_nothing_happen(0.05)
    assert armed.simulator.show()["motors"] == before, "driving with keys is off"
    armed.pad.setFocus()
    armed.press_key(Qt.Key.Key_Down)
    armed.wait_for_targets(BACK, BACK)
    assert "back 100\u00a0%" in spoken_state(armed.pad)
    armed.release_key(Qt.Key.Key_Down)
    armed.wait_for_brake()

    armed.click("driveWithKeys")
    armed.button("driveWithKeys").setFocus()
    armed.press_key(Qt.Key.Key_Up)
    armed.wait_for_targets(FORWARD, FORWARD)
    armed.release_key(Qt.Key.Key_Up)
    armed.wait_for_brake()
    assert armed.is_armed()
    armed.find(QSlider, "motor1Slider").setFocus()
    armed.press_key(Qt.Key.Key_Right)
    armed.wait_for_targets(FORWARD, BACK, "a slider does not take the arrow keys")
    armed.release_key(Qt.Key.Key_Right)
    armed.wait_for_brake()


def test_key_is_held_despite_repeats_and_drives_nowhere_else(keys: MotorsPage) -> None:
    keys.motors.set_ceiling(LOW)
    window, none = keys.window.windowHandle(), Qt.KeyboardModifier.NoModifier
    keys.press_key(Qt.Key.Key_W)
    keys.wait_for_targets(FORWARD, None)
    for _ in range(5):
        QTest.simulateEvent(window, True, Qt.Key.Key_W, none, "w", True)
        QTest.simulateEvent(window, False, Qt.Key.Key_W, none, "w", True)
    assert keys.motors.holder, "repeats of a held key count as one press"
    assert keys.target(1) == FORWARD
    keys.release_key(Qt.Key.Key_W)
    keys.wait_for_brake()

    def send(kind: QEvent.Type, key: Qt.Key, scan_code: int) -> None:
        QApplication.sendEvent(window, QKeyEvent(kind, key, none, scan_code, 0, 0))

    scan_code = 25  # of a key whose name depends on the keyboard layout
    send(QEvent.Type.KeyPress, Qt.Key.Key_W, scan_code)
    send(QEvent.Type.KeyPress, Qt.Key.Key_D, 40)
    keys.wait_for_targets(*CURVE)
    send(QEvent.Type.KeyRelease, Qt.Key.Key_Z, scan_code)
    keys.wait_for_targets(FORWARD, BACK)
    send(QEvent.Type.KeyRelease, Qt.Key.Key_D, 40)
    keys.wait_for_brake()

    QTest.keyPress(window, Qt.Key.Key_Right, Qt.KeyboardModifier.ControlModifier)
    assert not keys.motors.holder, "a shortcut does not drive"
    QTest.keyRelease(window, Qt.Key.Key_Right, Qt.KeyboardModifier.ControlModifier)

    entry = keys.find(QSpinBox, "brakeEntry")
    entry.setFocus()
    keys.click_key(Qt.Key.Key_Down)
    assert entry.value() == 126
    assert not keys.motors.holder, "a number field uses the key"

    keys.open_page("parametersPage")
    keys.find(QTableView, "parametersView").setFocus()
    keys.click_key(Qt.Key.Key_Down)
    assert not keys.motors.holder, "another page does not drive"
    keys.let_nothing_happen(0.05)
    assert all(keys.target(motor)[0] == "brake" for motor in (1, 2))


def test_key_repeat_as_release_and_press_does_not_brake(keys: MotorsPage) -> None:
    driver = keys.window.findChild(KeyDriver)
    assert driver is not None
    driver.has_split_repeats = True  # as on X11
    window, none = keys.window.windowHandle(), Qt.KeyboardModifier.NoModifier

    def send(kind: QEvent.Type, time: int, key: Qt.Key = Qt.Key.Key_W) -> None:
        event = QKeyEvent(kind, key, none, key.value, 0, 0)
        event.setTimestamp(time)
        QApplication.sendEvent(window, event)

    keys.motors.set_ceiling(LOW)
    send(QEvent.Type.KeyPress, 1)
    keys.wait_for_targets(FORWARD, FORWARD)
    send(QEvent.Type.KeyRelease, 2)
    send(QEvent.Type.KeyPress, 2)
    keys.let_nothing_happen(0.1)
    assert keys.target(1) == FORWARD
    send(QEvent.Type.KeyRelease, 3)
    keys.wait_for_brake("released")
    send(QEvent.Type.KeyPress, 4)
    keys.wait_for_targets(FORWARD, FORWARD)
    send(QEvent.Type.KeyRelease, 5)
    send(QEvent.Type.KeyPress, 6, Qt.Key.Key_S)
    keys.wait_for_targets(BACK, BACK, "another key")
    send(QEvent.Type.KeyRelease, 7, Qt.Key.Key_S)
    keys.wait_for_brake("all are released")


def test_keys_are_released_when_they_cannot_be_tracked(keys: MotorsPage) -> None:
    keys.motors.set_ceiling(LOW)
    keys.press_key(Qt.Key.Key_W)
    keys.wait_for_targets(FORWARD, FORWARD)
    keys.find(QSpinBox, "motor1Entry").setFocus()  # this field uses the key
    keys.wait_for_brake("number field")
    keys.release_key(Qt.Key.Key_W)

    keys.button("motor1Zero").setFocus()
    for event, key in (
        (keys.release_key, Qt.Key.Key_Z),
        (keys.release_key, Qt.Key.Key_8),
        (keys.press_key, Qt.Key.Key_Shift),
        (keys.press_key, Qt.Key.Key_NumLock),
    ):
        keys.press_key(Qt.Key.Key_W)
        keys.wait_for_targets(FORWARD, None, key)
        event(key)
        assert not keys.motors.holder, key
        keys.wait_for_brake(key)
        keys.release_key(Qt.Key.Key_W)
        keys.release_key(key)

    keys.press_key(Qt.Key.Key_W)
    keys.wait_for_targets(FORWARD, None)
    with keys.another_window():
        keys.wait_for_brake("another window")
        keys.release_key(Qt.Key.Key_W)

    keys.click("driveWithKeys")  # off, so the pad follows keys only while it has the focus
    keys.pad.setFocus()
    keys.press_key(Qt.Key.Key_Up)
    keys.wait_for_targets(FORWARD, FORWARD)
    keys.button("motor1Zero").setFocus()
    keys.wait_for_brake("focus lost")


HOLD, STOP = 9, 1  # buttons of SDL's virtual gamepads: left shoulder, B


def test_gamepad_drives_and_its_stop_button_works_on_other_pages(
    connected_window: WindowDriver, quick_simulator: SimulatedDevice
) -> None:
    page = MotorsPage(connected_window, quick_simulator)
    page.motors.accelerate = False
    page.click("gamepadBox")  # loads SDL
    pad = VirtualPad()
    widget = page.find(GamepadPanel, "gamepadPanel")
    panel = GamepadPanelPage(widget, page.device, pad, page.qtbot)
    page.wait(lambda: panel.gamepad.pad is not None)

    def runs() -> bool:
        motors = quick_simulator.show()["motors"]
        return all(each["direction"] == "forward" and each["speed"] >= 40 for each in motors)

    panel.drive()
    page.wait(runs)
    pad.press(HOLD, down=False)
    page.wait(lambda: is_stopped(quick_simulator))
    assert page.is_armed()
    pad.move(Y, 0.0)
    for name in ("boardPage", "currentsPage", "parametersPage"):
        page.open_page(name)
        page.motors.arm()
        page.motors.set_speed(1, 60)
        page.motors.set_speed(2, 60)
        page.wait(runs)
        pad.press(STOP)
        page.wait(lambda: is_stopped(quick_simulator))
        assert not page.is_armed(), name
        pad.press(STOP, down=False)
        page.let_nothing_happen(0.1)  # the button is released
        assert not page.is_armed(), name
    panel.gamepad.switch_off()
