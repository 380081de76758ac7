"""Setpoints and stops of a gamepad."""

from collections.abc import Iterator
from dataclasses import replace

import pytest
from PySide6.QtCore import QCoreApplication, QEvent
from pytestqt.qtbot import QtBot

from tests.support.pads import PAD, HeldPads
from tests.support.virtual_time import VirtualRuntime
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.gamepad import HOLDER, Gamepad, axis_text, button_text
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.gamepad.profile import Axis, DriveCondition

HOLD, STOP = 4, 1
X, Y = 0, 1
OTHER = replace(PAD, ident=2, guid="b" * 32, name="Other pad")


class GamepadSetup:
    """Gamepad that drives the motors of a device, and its stops."""

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

    def wait_for_speeds(self, left: int | None, right: int | None) -> None:
        self.qtbot.waitUntil(lambda: self.speeds() == (left, right))

    def drive_forward(self) -> None:
        """Push the stick all the way forward."""
        self.pads.press(HOLD)
        self.wait_for("Driving")
        self.pads.move(Y, -1.0)
        self.wait_for_speeds(FULL_SCALE, FULL_SCALE)


@pytest.fixture
def setup(qtbot: QtBot) -> Iterator[GamepadSetup]:
    setup = GamepadSetup(qtbot)
    setup.gamepad.switch_on()
    setup.arm()
    yield setup
    setup.gamepad.switch_off()


def brakes(setup: GamepadSetup) -> bool:
    return all(
        (drive := setup.motors.drive(motor)) is not None and drive.is_brake for motor in (1, 2)
    )


def test_held_button_and_moved_stick_drive_the_motors(setup: GamepadSetup) -> None:
    setup.drive_forward()
    assert setup.motors.holder == HOLDER
    assert setup.gamepad.drives


def test_releasing_the_button_brakes_and_keeps_motors_armed(setup: GamepadSetup) -> None:
    setup.drive_forward()
    setup.pads.release(HOLD)
    setup.qtbot.waitUntil(lambda: brakes(setup))
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


def test_stick_off_center_before_arming_does_not_drive(setup: GamepadSetup) -> None:
    setup.motors.stop()
    setup.pads.move(Y, 0.6)
    setup.motors.arm()
    setup.pads.press(HOLD)
    setup.wait_for("Release the sticks")
    assert setup.speeds() == (None, None)


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
    assert changes == [], "it is not tried again and again"


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
    assert setup.stops == ["The gamepad “Test pad” was disconnected."]
    assert not setup.motors.armed
    again = replace(PAD, ident=7)
    setup.pads.plug_in(again)
    setup.pads.press(HOLD, again)
    setup.wait_for("Arm the motors")
    setup.motors.arm()
    setup.wait_for("Release")
    assert not setup.motors.holder


@pytest.mark.parametrize("blocker", ["", "Another page is open."])
def test_stop_button_stops_another_control(setup: GamepadSetup, blocker: str) -> None:
    setup.gamepad.set_unattended(blocker)
    setup.motors.acquire("pad")
    setup.motors.set_speed(1, 50, "pad")
    setup.pads.press(STOP)
    setup.qtbot.waitUntil(lambda: not setup.motors.armed)
    assert setup.stops == [""]


def test_blocking_while_driving_stops_with_the_reason(setup: GamepadSetup) -> None:
    setup.drive_forward()
    setup.gamepad.set_unattended("The window is not in front.")
    assert setup.stops == ["The window is not in front."]
    assert setup.gamepad.text == "The window is not in front."


def test_blocked_gamepad_does_not_drive(setup: GamepadSetup) -> None:
    setup.gamepad.set_unattended("Another page is open.")
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


def test_control_held_elsewhere_blocks_the_gamepad(setup: GamepadSetup) -> None:
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


def test_switching_off_while_driving_stops_the_motors(setup: GamepadSetup) -> None:
    setup.drive_forward()
    setup.gamepad.switch_off()
    assert setup.stops == ["Driving with a gamepad was switched off."]
    assert not setup.pads.is_open
    assert setup.gamepad.text == ""


def test_profile_is_saved_per_gamepad_model(setup: GamepadSetup) -> None:
    profile = replace(setup.gamepad.profile, second=Axis(3), hold=5, dead_zone=0.2)
    setup.gamepad.set_profile(profile)
    setup.gamepad.switch_off()
    later = Gamepad(setup.device, HeldPads(PAD, OTHER))
    later.switch_on()
    assert later.profile == profile
    later.set_profile(replace(profile, first=Axis(9)))  # this gamepad has no axis 9
    later.switch_off()
    later.switch_on()
    assert later.profile.first == Axis(Y, inverted=True)
    later.select(OTHER)
    assert later.profile != profile
    later.switch_off()


def test_last_chosen_gamepad_model_is_reselected(setup: GamepadSetup) -> None:
    setup.pads.plug_in(OTHER)
    setup.qtbot.waitUntil(lambda: OTHER in setup.gamepad.pads)
    setup.gamepad.select(OTHER)
    setup.gamepad.switch_off()
    setup.gamepad.switch_on()
    assert setup.gamepad.pad == OTHER


def test_profile_change_while_driving_stops_the_motors(setup: GamepadSetup) -> None:
    setup.drive_forward()
    setup.gamepad.set_profile(replace(setup.gamepad.profile, expo=1.0))
    assert setup.stops == ["The gamepad settings were changed."]


def test_missing_gamepad_support_shows_a_remedy(qtbot: QtBot) -> None:
    gamepad = Gamepad(Device(), HeldPads(failure="Install it with …"))
    gamepad.switch_on()
    assert not gamepad.on
    assert gamepad.text == gamepad.failure == "Install it with …"


def test_first_plugged_in_gamepad_is_selected(qtbot: QtBot) -> None:
    pads = HeldPads()
    gamepad = Gamepad(Device(), pads)
    gamepad.switch_on()
    assert "No gamepad is connected" in gamepad.text
    pads.plug_in(PAD)
    qtbot.waitUntil(lambda: gamepad.pad == PAD)
    gamepad.switch_off()


def test_deleted_gamepad_model_closes_the_pads(qtbot: QtBot) -> None:
    pads = HeldPads(PAD)
    gamepad = Gamepad(Device(), pads)
    gamepad.switch_on()
    assert pads.is_open
    gamepad.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    assert not pads.is_open


# --- Names of the parts -----------------------------------------------------------------


UNKNOWN = replace(PAD, parts={})


def test_parts_are_numbered_from_one() -> None:
    assert axis_text(UNKNOWN, 0) == "axis 1"
    assert button_text(UNKNOWN, 4) == "button 5"


def test_parts_known_to_sdl_show_their_names() -> None:
    assert axis_text(PAD, 0) == "axis 1 (left stick, sideways)"
    assert button_text(PAD, 4) == "button 5 (left shoulder)"
    assert button_text(PAD, None) == "none"
