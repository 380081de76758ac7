"""A gamepad's button counts only when it is pressed after the motors were armed."""

from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from tests.support.pads import PAD, HeldPads
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.gamepad import Gamepad
from trex_gui.gamepad.profile import Waits

HOLD = 4
STICK = 1


@pytest.fixture
def pads() -> HeldPads:
    return HeldPads(PAD)


@pytest.fixture
def gamepad(device: Device, pads: HeldPads) -> Iterator[Gamepad]:
    """A gamepad that is read while the motors are not armed."""
    device.motors.set_available(True)
    gamepad = Gamepad(device, pads)
    gamepad.switch_on()
    yield gamepad
    gamepad.switch_off()


def test_button_pressed_before_arming_does_not_drive(
    gamepad: Gamepad, device: Device, pads: HeldPads, qtbot: QtBot
) -> None:
    qtbot.waitUntil(lambda: gamepad.request.waits is Waits.HOLD)
    pads.press(HOLD)
    qtbot.waitUntil(lambda: gamepad.request.drives)
    device.motors.arm()
    pads.move(STICK, -1.0)
    qtbot.waitUntil(lambda: "Release" in gamepad.text)
    assert device.motors.text == ""
    assert not gamepad.drives


def test_button_pressed_after_arming_drives(
    gamepad: Gamepad, device: Device, pads: HeldPads, qtbot: QtBot
) -> None:
    device.motors.arm()
    qtbot.waitUntil(lambda: gamepad.request.waits is Waits.HOLD)
    pads.press(HOLD)
    pads.move(STICK, -1.0)
    qtbot.waitUntil(lambda: device.motors.text == "motor 1 +38, motor 2 +38")
    assert gamepad.drives
