"""Gamepad panel and its set-up, with a simulated gamepad."""

from collections.abc import Iterator

import pytest
from PySide6.QtWidgets import QCheckBox, QSpinBox, QVBoxLayout, QWidget
from pytestqt.qtbot import QtBot

from tests.support.keyboard import check_keyboard
from tests.support.pads import PAD, HeldPads
from tests.support.pages.gamepad_panel import GamepadPanelPage, Y
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.views.pages.motors.gamepad_dialog import GamepadDialog
from trex_gui.devices.trex.views.pages.motors.gamepad_panel import GamepadPanel
from trex_gui.gamepad.profile import Axis, Style
from trex_gui.ui.widgets.leds import Lamp

HOLD = 4  # left shoulder button
OTHER_X, OTHER_Y = 2, 3

Panel = GamepadPanelPage[HeldPads]


@pytest.fixture
def panel(qtbot: QtBot) -> Iterator[Panel]:
    """Panel in its own window, with a gamepad and available motors."""
    device, pads, window = Device(), HeldPads(PAD), QWidget()
    qtbot.addWidget(window)
    panel = Panel(GamepadPanel(device, window, source=pads), device, pads, qtbot)
    panel.motors.set_available(True)
    QVBoxLayout(window).addWidget(panel.root)
    window.show()
    panel.activate()
    yield panel
    panel.gamepad.switch_off()


@pytest.fixture
def active_panel(panel: Panel) -> Panel:
    """Panel that reads the gamepad."""
    panel.find(QCheckBox, "gamepadBox").setChecked(True)
    return panel


@pytest.fixture
def set_up(active_panel: Panel) -> Panel:
    """Panel with its set-up open."""
    active_panel.open_set_up()
    return active_panel


# --- The panel --------------------------------------------------------------------------


def test_inactive_panel_reads_nothing_and_hides_its_controls(panel: Panel) -> None:
    assert not panel.pads.is_open
    for name in ("gamepadCombo", "gamepadSetUpButton", "gamepadState"):
        assert not panel.find(QWidget, name).isVisible(), name


def test_state_explains_driving_and_stopping(active_panel: Panel) -> None:
    active_panel.wait_for_state("Arm the motors first.")
    active_panel.drive()
    active_panel.wait_for_state("Release button 5 (left shoulder) to stop")


def test_hiding_the_panel_while_driving_stops_the_motors(active_panel: Panel) -> None:
    active_panel.drive()
    active_panel.root.hide()
    assert not active_panel.motors.armed
    assert "Motors page" in active_panel.motors.stop_reason


def open_another_window(qtbot: QtBot) -> QWidget:
    other = QWidget()
    qtbot.addWidget(other)
    other.show()
    other.activateWindow()
    qtbot.waitUntil(other.isActiveWindow)
    return other


def test_another_window_stops_the_motors_unless_allowed(active_panel: Panel, qtbot: QtBot) -> None:
    active_panel.drive()
    other = open_another_window(qtbot)
    qtbot.waitUntil(lambda: not active_panel.motors.armed)
    assert "Another window" in active_panel.motors.stop_reason
    other.close()
    active_panel.pads.release(HOLD)
    active_panel.pads.move(Y, 0.0)
    active_panel.activate()

    active_panel.click("gamepadUnfocusedBox")
    active_panel.drive()
    open_another_window(qtbot)
    assert active_panel.motors.armed
    active_panel.pads.release(HOLD)
    qtbot.waitUntil(lambda: not active_panel.motors.holder)


def test_every_control_works_with_the_keyboard(set_up: Panel) -> None:
    check_keyboard(set_up.find_only(GamepadDialog))
    check_keyboard(set_up.root.window())


# --- The set-up -------------------------------------------------------------------------


def test_button_is_never_assigned_to_hold_and_stop(set_up: Panel) -> None:
    set_up.select_text("gamepadStopCombo", "button 5")
    assert set_up.profile.stop == HOLD
    assert set_up.profile.hold is None
    assert "bumping a stick" in set_up.text("gamepadSetUpNote")


def test_set_up_changes_apply_at_once(set_up: Panel) -> None:
    before = set_up.profile
    set_up.select_text("gamepadStyleCombo", "for each motor")
    set_up.select_text("gamepadSecondCombo", "axis 4")
    set_up.click("gamepadSecondInvert")
    for name, value in (("gamepadDeadZoneSpin", 20), ("gamepadExpoSpin", 0)):
        set_up.find(QSpinBox, name).setValue(value)
    profile = set_up.profile
    assert profile.style is Style.TANK
    assert profile.second == Axis(OTHER_Y, inverted=True)
    assert (profile.dead_zone, profile.expo) == (0.2, 0.0)
    set_up.click("gamepadDefaultsButton")
    assert set_up.profile == before


def test_axis_value_and_button_lamp_follow_the_gamepad(set_up: Panel) -> None:
    lamp = set_up.find(Lamp, "gamepadLamp7")
    set_up.pads.move(OTHER_X, -0.5)
    set_up.pads.press(7)
    set_up.wait(lambda: lamp.lit)
    assert set_up.text(f"gamepadAxisValue{OTHER_X}") == "−50 %"
    assert lamp.accessibleDescription() == "pressed"


def test_opening_the_set_up_while_driving_stops_the_motors(active_panel: Panel) -> None:
    active_panel.drive()
    active_panel.open_set_up()
    assert not active_panel.motors.armed
    active_panel.pads.release(HOLD)
    active_panel.pads.move(Y, 0.0)
    active_panel.click("gamepadCloseButton")
    active_panel.activate()  # as a window manager does
    active_panel.drive()


def test_unplugging_disables_the_axis_selection_in_set_up(set_up: Panel) -> None:
    set_up.pads.unplug(PAD)
    set_up.wait_for_text("gamepadName", "No gamepad")
    assert not set_up.is_enabled("gamepadFirstCombo")
