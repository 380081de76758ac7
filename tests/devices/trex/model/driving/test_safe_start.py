"""Whether safe-start may still hold the motors that channels drive."""

import pytest
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.drive_status import SafeStartWatch
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings

COUNT = 0.15
"""Amperes of one count of a motor current of a TReX."""


@pytest.fixture
def watch(device: Device, rc_board: SimulatedDevice, qtbot: QtBot) -> SafeStartWatch:
    """The watch on a board that was connected while channel 1 asks for a speed."""
    rc_board.do("channel 1 1900us")
    rc_board.do("current 1 0")
    watch = SafeStartWatch(device)
    device.connect_to(ConnectionSettings(rc_board.url))
    telemetry = device.telemetry
    qtbot.waitUntil(lambda: None not in {telemetry.remapped, telemetry.motor_currents})
    return watch


def test_stick_off_neutral_since_connecting_may_be_held(watch: SafeStartWatch) -> None:
    assert watch.may_hold


def test_motor_current_shows_that_safe_start_is_over(
    watch: SafeStartWatch, device: Device, rc_board: SimulatedDevice, qtbot: QtBot
) -> None:
    def read(amperes: float) -> None:
        rc_board.do(f"current 1 {amperes}")
        qtbot.waitUntil(lambda: device.telemetry.motor_currents == pytest.approx((amperes, 0)))

    read(COUNT)
    assert watch.may_hold, "one count may be noise"
    read(2 * COUNT)
    assert not watch.may_hold


def test_required_channel_losing_signal_restarts_safe_start(
    watch: SafeStartWatch, device: Device, rc_board: SimulatedDevice, qtbot: QtBot
) -> None:
    rc_board.do("channel 1 1500us")
    qtbot.waitUntil(lambda: not watch.may_hold)
    rc_board.do("channel 1 silent")
    qtbot.waitUntil(lambda: watch.may_hold)
    rc_board.do("channel 1 1900us")
    qtbot.waitUntil(lambda: (device.telemetry.remapped_of(1) or 0) > 0)
    assert watch.may_hold
