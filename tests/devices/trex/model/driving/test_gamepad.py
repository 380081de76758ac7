"""Setpoints and stops of a gamepad."""

from collections.abc import Callable, Iterator
from dataclasses import replace

import pytest
from PySide6.QtCore import QCoreApplication, QEvent
from pytestqt.qtbot import QtBot

from tests.support.pads import PAD, HeldPads
from tests.support.virtual_time import VirtualRuntime
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.gamepad import HOLDER, Gamepad, axis_text, button_text
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.gamepad.profile import Axis, DriveCondition

HOLD, STOP = 4, 1
X, Y = 0, 1
OTHER = replace(PAD, ident=2, guid="b" * 32, name="Other pad")


class GamepadSetup:
    """Gamepad that drives the motors of a device, and the reasons for its stops."""

    def __init__(self, qtbot: QtBot) -> None:
        self.qtbot = qtbot
        self.device = Device()
        self.motors = self.device.motors
        self.motors.lockout = 0
        self.motors.set_ceiling(FULL_SCALE)
        self.motors.set_available(True)
        self.pads = HeldPads(PAD)
        self.gamepad = Gamepad(self.device, self.pads)
        self.stops: list[str] = []
        self.motors.stop_requested.connect(self._on_stop)

    def _on_stop(self) -> None:
        self.stops.append(self.motors.stop_reason)

    def arm(self) -> None:
        self.motors.arm()
        self.wait_for("Hold")

    def wait_for(self, words: str) -> None:
        self.qtbot.waitUntil(lambda: words in self.gamepad.text)

    def speeds(self) -> tuple[int | None, int | None]:
        first, second = self.motors.drive(1), self.motors.drive(2)
        return (first.signed if first else None, second.signed if second else None)

    def drive_forward(self) -> None:
        """Push the stick all the way forward."""
        self.pads.press(HOLD)
        self.wait_for("Driving")
        self.pads.move(Y, -1.0)
        self.qtbot.waitUntil(lambda: self.speeds() == (FULL_SCALE, FULL_SCALE))


@pytest.fixture
def setup(qtbot: QtBot) -> Iterator[GamepadSetup]:
    setup = GamepadSetup(qtbot)
    setup.gamepad.switch_on()
    setup.arm()
    yield setup
    setup.gamepad.switch_off()


def test_held_button_and_moved_stick_drive_the_motors(setup: GamepadSetup) -> None:
    setup.drive_forward()
    assert setup.motors.holder == HOLDER
    assert setup.gamepad.is_driving


def test_releasing_the_button_brakes_without_disarming(setup: GamepadSetup) -> None:
    setup.drive_forward()
    setup.pads.release(HOLD)
    braking = [Drive.brake(), Drive.brake()]
    setup.qtbot.waitUntil(lambda: [setup.motors.drive(1), setup.motors.drive(2)] == braking)
    assert setup.motors.armed
    assert not setup.motors.holder


def test_button_held_before_arming_does_not_drive(setup: GamepadSetup) -> None:
    setup.motors.stop()
    setup.pads.press(HOLD)
    setup.pads.move(Y, -1.0)
    setup.wait_for("Arm the motors")
    setup.motors.arm()
    setup.wait_for("Release")
    assert setup.speeds() == (None, None)
    assert not setup.motors.holder


def test_unreadable_gamepad_stops_the_motors_once(
    setup: GamepadSetup, virtual_time: VirtualRuntime, monkeypatch: pytest.MonkeyPatch
) -> None:
    setup.drive_forward()
    monkeypatch.setattr(setup.pads, "read", lambda _pad: None)
    setup.wait_for("was disconnected")
    assert setup.stops == ["The gamepad “Test pad” was disconnected."]
    assert not setup.motors.armed
    assert setup.gamepad.pads == (PAD,)
    changes: list[str] = []
    setup.gamepad.changed.connect(lambda: changes.append(setup.gamepad.text))
    virtual_time.advance(0.1)
    assert changes == [], "the gamepad is not read again"


def test_second_gamepad_does_not_take_over_driving(setup: GamepadSetup) -> None:
    setup.drive_forward()
    setup.pads.plug_in(OTHER)
    setup.pads.move(Y, -1.0, OTHER)
    setup.pads.press(HOLD, OTHER)
    setup.pads.unplug(PAD)
    setup.qtbot.waitUntil(lambda: setup.gamepad.pad == OTHER)
    assert not setup.motors.armed
    assert setup.stops == ["The gamepad “Test pad” was disconnected."]


def test_replugged_gamepad_needs_arming_and_a_new_press(setup: GamepadSetup) -> None:
    setup.drive_forward()
    setup.pads.unplug(PAD)
    setup.wait_for("was disconnected")
    replugged = replace(PAD, ident=7)
    setup.pads.plug_in(replugged)
    setup.pads.press(HOLD, replugged)
    setup.wait_for("Arm the motors")
    setup.motors.arm()
    setup.wait_for("Release")
    assert not setup.motors.holder


@pytest.mark.parametrize("blocker", ["", "Another page is open."])
def test_stop_button_stops_motors_that_another_control_drives(
    setup: GamepadSetup, blocker: str
) -> None:
    setup.gamepad.set_unattended(blocker)
    setup.motors.acquire("pad")
    setup.motors.set_speed(1, 50, "pad")
    setup.pads.press(STOP)
    setup.qtbot.waitUntil(lambda: not setup.motors.armed)
    assert setup.stops == [""]


@pytest.mark.parametrize(
    ("act", "reason"),
    [
        (lambda pad: pad.set_unattended("Another page is open."), "Another page is open."),
        (lambda pad: pad.switch_off(), "Driving with a gamepad was switched off."),
        (
            lambda pad: pad.set_profile(replace(pad.profile, expo=1.0)),
            "The gamepad settings were changed.",
        ),
    ],
)
def test_change_while_driving_stops_with_the_reason(
    setup: GamepadSetup, act: Callable[[Gamepad], None], reason: str
) -> None:
    setup.drive_forward()
    act(setup.gamepad)
    assert setup.stops == [reason]


def test_blocked_gamepad_does_not_drive(setup: GamepadSetup) -> None:
    setup.gamepad.set_unattended("Another page is open.")
    assert setup.gamepad.text == "Another page is open."
    setup.pads.press(HOLD)
    setup.qtbot.waitUntil(lambda: setup.gamepad.request.waits_for is DriveCondition.RELEASE)
    setup.pads.release(HOLD)
    setup.qtbot.waitUntil(lambda: setup.gamepad.request.waits_for is DriveCondition.HOLD)
    setup.pads.press(HOLD)
    setup.pads.move(Y, -1.0)
    setup.qtbot.waitUntil(lambda: setup.gamepad.request.drives)
    assert setup.speeds() == (None, None)
    setup.gamepad.set_unattended("")
    setup.wait_for("Release the sticks")
    assert setup.speeds() == (None, None)


def test_another_held_control_blocks_the_gamepad(setup: GamepadSetup) -> None:
    setup.motors.acquire("pad")
    setup.motors.set_speed(1, 30, "pad")
    setup.pads.press(HOLD)
    setup.pads.move(Y, -1.0)
    setup.wait_for("Another control is driving")
    assert setup.motors.holder == "pad"
    setup.motors.release("pad")
    setup.pads.move(Y, 0.0)
    setup.wait_for("Release button")
    assert not setup.motors.holder


def test_switched_off_gamepad_is_closed(setup: GamepadSetup) -> None:
    setup.gamepad.switch_off()
    assert not setup.pads.is_open
    assert setup.gamepad.text == ""


def test_profile_is_saved_for_each_gamepad_model(setup: GamepadSetup) -> None:
    profile = replace(setup.gamepad.profile, second=Axis(3), hold=5, dead_zone=0.2)
    setup.gamepad.set_profile(profile)
    setup.gamepad.switch_off()
    gamepad = Gamepad(setup.device, HeldPads(PAD, OTHER))
    gamepad.switch_on()
    assert gamepad.profile == profile
    gamepad.set_profile(replace(profile, first=Axis(9)))  # this gamepad has no axis 9
    gamepad.switch_off()
    gamepad.switch_on()
    assert gamepad.profile.first == Axis(Y, inverted=True)
    gamepad.select(OTHER)
    assert gamepad.profile != profile
    gamepad.switch_off()


def test_last_selected_gamepad_model_is_selected_again(setup: GamepadSetup) -> None:
    setup.pads.plug_in(OTHER)
    setup.qtbot.waitUntil(lambda: OTHER in setup.gamepad.pads)
    setup.gamepad.select(OTHER)
    setup.gamepad.switch_off()
    setup.gamepad.switch_on()
    assert setup.gamepad.pad == OTHER


def test_missing_gamepad_support_is_shown_with_a_remedy(qtbot: QtBot) -> None:
    gamepad = Gamepad(Device(), HeldPads(failure="Install it with …"))
    gamepad.switch_on()
    assert not gamepad.is_on
    assert gamepad.text == gamepad.failure == "Install it with …"


def test_first_plugged_in_gamepad_is_selected(qtbot: QtBot) -> None:
    pads = HeldPads()
    gamepad = Gamepad(Device(), pads)
    gamepad.switch_on()
    assert "No gamepad is connected" in gamepad.text
    pads.plug_in(PAD)
    qtbot.waitUntil(lambda: gamepad.pad == PAD)
    gamepad.switch_off()


def test_deleted_gamepad_is_closed(qtbot: QtBot) -> None:
    pads = HeldPads(PAD)
    gamepad = Gamepad(Device(), pads)
    gamepad.switch_on()
    assert pads.is_open
    gamepad.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    assert not pads.is_open


# --- Names of axes and buttons ----------------------------------------------------------


def test_axes_and_buttons_have_numbers_from_1_and_known_names() -> None:
    unnamed = replace(PAD, parts={})
    assert axis_text(unnamed, 0) == "axis 1"
    assert button_text(unnamed, 4) == "button 5"
    assert axis_text(PAD, 0) == "axis 1 (left stick, sideways)"
    assert button_text(PAD, 4) == "button 5 (left shoulder)"
    assert button_text(PAD, None) == "none"
