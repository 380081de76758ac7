"""The gamepad's place on the Motors page, and its set-up, with a gamepad in a test's hands."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QCheckBox,
    QComboBox,
    QDialog,
    QLabel,
    QSpinBox,
    QVBoxLayout,
    QWidget,
)
from pytestqt.qtbot import QtBot

from tests.support.pads import PAD, HeldPads
from trex_gui.gamepad.profile import Axis, Style
from trex_gui.gamepad.sdl import HOW_TO_INSTALL, SdlPads
from trex_gui.model.device import Device
from trex_gui.views.driving.gamepad_bar import PartBar
from trex_gui.views.driving.gamepad_panel import GamepadPanel
from trex_gui.views.widgets.leds import Lamp

HOLD, STOP = 4, 1
X, Y, OTHER_X, OTHER_Y = 0, 1, 2, 3


class Page:
    """A page with a panel in a window of its own, and armed motors."""

    def __init__(self, qtbot: QtBot) -> None:
        self.qtbot = qtbot
        self.device = Device()
        self.motors = self.device.motors
        self.motors.lockout = 0
        self.motors.allow(True)
        self.pads = HeldPads(PAD)
        self.window = QWidget()
        qtbot.addWidget(self.window)
        self.panel = GamepadPanel(self.device, self.window, source=self.pads)
        QVBoxLayout(self.window).addWidget(self.panel)
        self.window.show()
        self.window.activateWindow()
        qtbot.waitUntil(self.window.isActiveWindow)

    @property
    def dialog(self) -> QDialog:
        dialog = self.panel.findChild(QDialog, "gamepadDialog")
        assert isinstance(dialog, QDialog)
        return dialog

    def switch_on(self) -> None:
        box = self.panel.findChild(QCheckBox, "gamepadBox")
        assert isinstance(box, QCheckBox)
        box.setChecked(True)

    def press(self, name: str) -> None:
        button = self.panel.findChild(QAbstractButton, name)
        assert isinstance(button, QAbstractButton)
        assert button.isEnabled(), name
        QTest.mouseClick(button, Qt.MouseButton.LeftButton)

    def choose(self, name: str, text: str) -> None:
        combo = self.panel.findChild(QComboBox, name)
        assert isinstance(combo, QComboBox)
        index = combo.findText(text, Qt.MatchFlag.MatchContains)
        assert index >= 0, [combo.itemText(row) for row in range(combo.count())]
        combo.setCurrentIndex(index)
        combo.activated.emit(index)

    def text(self, name: str = "gamepadState") -> str:
        label = self.panel.findChild(QLabel, name)
        assert isinstance(label, QLabel)
        return label.text()

    def wait_for(self, words: str, name: str = "gamepadState") -> None:
        self.qtbot.waitUntil(lambda: words in self.text(name))

    def drive(self) -> None:
        self.motors.arm()
        self.wait_for("Hold")
        self.pads.press(HOLD)
        self.wait_for("Driving")
        self.pads.move(Y, -1.0)
        self.qtbot.waitUntil(lambda: self.motors.drive(1) is not None)
        assert self.motors.holder == "gamepad"

    def open_set_up(self) -> None:
        self.press("gamepadSetUpButton")
        self.qtbot.waitUntil(self.dialog.isVisible)
        self.qtbot.waitUntil(lambda: self.panel.gamepad.state is not None)


@pytest.fixture
def page(qtbot: QtBot) -> Iterator[Page]:
    page = Page(qtbot)
    yield page
    page.panel.gamepad.switch_off()


@pytest.fixture
def on(page: Page) -> Page:
    page.switch_on()
    return page


@pytest.fixture
def set_up(on: Page) -> Page:
    on.open_set_up()
    return on


# --- The panel --------------------------------------------------------------------------


def test_before_it_is_switched_on_nothing_is_read_and_little_is_shown(page: Page) -> None:
    assert not page.pads.is_open
    for name in ("gamepadCombo", "gamepadSetUpButton", "gamepadForward", "gamepadState"):
        widget = page.panel.findChild(QWidget, name)
        assert isinstance(widget, QWidget)
        assert not widget.isVisible(), name


def test_it_says_what_to_hold_and_then_how_to_stop(on: Page) -> None:
    assert "Press Run motor, then hold button 5 (left shoulder)" in on.text()
    on.drive()
    assert "Let go of button 5 (left shoulder) to stop" in on.text()


def test_leaving_the_page_while_driving_stops_the_motors(on: Page) -> None:
    on.drive()
    on.panel.hide()
    assert not on.motors.armed
    assert "Motors page" in on.motors.stop_reason


def test_a_window_in_front_while_driving_stops_the_motors(on: Page, qtbot: QtBot) -> None:
    on.drive()
    other = QWidget()
    qtbot.addWidget(other)
    other.show()
    other.activateWindow()
    qtbot.waitUntil(lambda: not on.motors.armed)
    assert "Another window" in on.motors.stop_reason


def test_where_a_person_wants_it_the_window_may_be_behind(on: Page, qtbot: QtBot) -> None:
    on.press("gamepadUnfocusedBox")
    on.drive()
    other = QWidget()
    qtbot.addWidget(other)
    other.show()
    other.activateWindow()
    qtbot.waitUntil(other.isActiveWindow)
    assert on.motors.armed
    on.pads.release(HOLD)
    qtbot.waitUntil(lambda: not on.motors.holder)


def test_a_gamepad_that_goes_is_told(on: Page) -> None:
    on.drive()
    on.pads.unplug(PAD)
    on.wait_for("has gone")
    assert not on.motors.armed


def test_the_bars_show_what_is_asked_for(on: Page) -> None:
    bar = on.panel.findChild(PartBar, "gamepadForward")
    assert isinstance(bar, PartBar)
    on.qtbot.waitUntil(lambda: bar.accessibleDescription() == "0 %")
    on.pads.move(Y, -1.0)
    on.qtbot.waitUntil(lambda: bar.accessibleDescription() == "+100 %")


def test_without_the_extra_the_panel_says_how_to_install_it(
    qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(__import__("sys").modules, "pygame", None)
    panel = GamepadPanel(Device(), source=SdlPads())
    qtbot.addWidget(panel)
    box = panel.findChild(QCheckBox, "gamepadBox")
    state = panel.findChild(QLabel, "gamepadState")
    assert isinstance(box, QCheckBox)
    assert isinstance(state, QLabel)
    box.setChecked(True)
    assert not box.isChecked()
    assert HOW_TO_INSTALL in state.text()


def test_every_control_of_panel_and_set_up_has_names(set_up: Page) -> None:
    controls = (QAbstractButton, QComboBox, QSpinBox, PartBar, Lamp)
    found = [each for each in set_up.panel.findChildren(QWidget) if isinstance(each, controls)]
    for each in found:
        if each.objectName().startswith("qt_"):
            continue
        assert each.objectName(), each
        spoken = each.accessibleName() or (each.text() if isinstance(each, QAbstractButton) else "")
        assert spoken, each.objectName()


# --- The set-up -------------------------------------------------------------------------


def test_a_stick_is_found_by_moving_it(set_up: Page) -> None:
    set_up.press("gamepadFirstDetect")
    assert "Move the stick that shall drive forward" in set_up.text("gamepadSetUpNote")
    set_up.pads.move(OTHER_Y, -1.0)
    set_up.qtbot.waitUntil(
        lambda: set_up.panel.gamepad.profile.first == Axis(OTHER_Y, inverted=True)
    )
    set_up.press("gamepadSecondDetect")
    set_up.pads.move(OTHER_X, 1.0)
    set_up.qtbot.waitUntil(lambda: set_up.panel.gamepad.profile.second == Axis(OTHER_X))


def test_a_button_is_found_by_pressing_it(set_up: Page) -> None:
    set_up.press("gamepadHoldDetect")
    set_up.pads.press(6)
    set_up.qtbot.waitUntil(lambda: set_up.panel.gamepad.profile.hold == 6)


def test_one_button_is_not_for_both(set_up: Page) -> None:
    set_up.choose("gamepadStopCombo", "button 5")
    assert set_up.panel.gamepad.profile.stop == HOLD
    assert set_up.panel.gamepad.profile.hold is None
    assert "bumped" in set_up.text("gamepadSetUpNote")


def test_what_is_set_up_counts_at_once(set_up: Page) -> None:
    set_up.choose("gamepadStyleCombo", "for each motor")
    set_up.choose("gamepadSecondCombo", "axis 4")
    set_up.press("gamepadSecondInvert")
    for name, value in (("gamepadDeadZoneSpin", 20), ("gamepadExpoSpin", 0)):
        spin = set_up.panel.findChild(QSpinBox, name)
        assert isinstance(spin, QSpinBox)
        spin.setValue(value)
    profile = set_up.panel.gamepad.profile
    assert profile.style is Style.TANK
    assert profile.second == Axis(OTHER_Y, inverted=True)
    assert (profile.dead_zone, profile.expo) == (0.2, 0.0)


def test_the_defaults_come_back(set_up: Page) -> None:
    before = set_up.panel.gamepad.profile
    set_up.choose("gamepadFirstCombo", "axis 3")
    assert set_up.panel.gamepad.profile != before
    set_up.press("gamepadDefaultsButton")
    assert set_up.panel.gamepad.profile == before


def test_a_bar_an_axis_and_a_lamp_a_button_follow_the_gamepad(set_up: Page) -> None:
    bar = set_up.dialog.findChild(PartBar, f"gamepadAxisBar{OTHER_X}")
    lamp = set_up.dialog.findChild(Lamp, "gamepadLamp7")
    assert isinstance(bar, PartBar)
    assert isinstance(lamp, Lamp)
    set_up.pads.move(OTHER_X, -0.5)
    set_up.pads.press(7)
    set_up.qtbot.waitUntil(lambda: lamp.lit)
    assert bar.accessibleDescription() == "−50 %"
    assert lamp.accessibleDescription() == "pressed"


def test_while_it_is_set_up_nothing_drives_but_the_stop_button_stops(set_up: Page) -> None:
    set_up.motors.arm()
    set_up.pads.press(HOLD)
    set_up.pads.move(Y, -1.0)
    set_up.wait_for("being set up")
    set_up.pads.press(STOP)
    set_up.qtbot.waitUntil(lambda: not set_up.motors.armed)
    assert set_up.motors.drive(1) is None


def test_opening_the_set_up_while_driving_stops_the_motors(on: Page) -> None:
    on.drive()
    on.open_set_up()
    assert not on.motors.armed


def test_after_the_set_up_is_closed_the_gamepad_drives_again(set_up: Page) -> None:
    set_up.press("gamepadCloseButton")
    set_up.window.activateWindow()  # window managers do it; without a screen there is none
    set_up.qtbot.waitUntil(set_up.window.isActiveWindow)
    set_up.drive()


def test_a_gamepad_that_goes_while_it_is_set_up_leaves_an_empty_form(set_up: Page) -> None:
    set_up.press("gamepadFirstDetect")
    set_up.pads.unplug(PAD)
    set_up.wait_for("No gamepad", "gamepadName")
    combo = set_up.dialog.findChild(QComboBox, "gamepadFirstCombo")
    assert isinstance(combo, QComboBox)
    assert not combo.isEnabled()
