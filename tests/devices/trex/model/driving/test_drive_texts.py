"""Texts of the Motors page for a motor and the channel that drives it."""

import pytest
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.drive_texts import (
    channel_text,
    report_text,
    setpoint_text,
    speed_text,
)
from trex_gui.devices.trex.protocol.driving import Drive


@pytest.mark.parametrize(
    ("speed", "text"), [(0, "0"), (64, "forward 64 (50 %)"), (-127, "reverse 127 (100 %)")]
)
def test_speed_names_direction_and_share_of_full(speed: int, text: str) -> None:
    assert speed_text(speed) == text


@pytest.mark.parametrize(
    ("drive", "text"),
    [
        (None, "none"),
        (Drive.brake(0), "coast"),
        (Drive.brake(127), "brake, 100 %"),
        (Drive.at(-64), "reverse 64 (50 %)"),
    ],
)
def test_setpoint_text_names_the_commanded_drive(drive: Drive | None, text: str) -> None:
    assert setpoint_text(drive).endswith(text)


def test_channel_text_shows_a_missing_signal(
    rc_device: Device, rc_board: SimulatedDevice, qtbot: QtBot
) -> None:
    assert channel_text(rc_device, 2) == "Channel 2: N/A"
    rc_board.do("channel 2 silent")
    qtbot.waitUntil(lambda: channel_text(rc_device, 2) == "Channel 2: no signal")
    assert channel_text(rc_device, 1) == "Channel 1: 0"


def test_report_gives_each_motor_its_own_errors(
    rc_device: Device, rc_board: SimulatedDevice, qtbot: QtBot
) -> None:
    assert report_text(rc_device, 1) == "Board: N/A"
    rc_board.do("fault 2 on")
    qtbot.waitUntil(lambda: "fault" in report_text(rc_device, 2))
    assert report_text(rc_device, 1) == "Board: serial not in control"
    assert report_text(rc_device, 3) == "Board: serial not in control"


def test_report_shows_the_speed_waiting_behind_channel_5(
    rc_device: Device, rc_board: SimulatedDevice, qtbot: QtBot
) -> None:
    rc_board.do("channel 1 1900us")
    rc_board.do("channel 3 1100us")
    rc_board.do("channel 5 1000us")  # hands the motors to the serial port
    qtbot.waitUntil(lambda: "channel 1 at +" in report_text(rc_device, 1))
    assert report_text(rc_device, 1).startswith("Board: serial in control, ")
    assert report_text(rc_device, 2).endswith(", channel 2 at 0 (overridden)")
    assert report_text(rc_device, 3).endswith(", channel 3 at +99 (overridden)")
