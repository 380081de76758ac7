"""What the models know of the reasons why motors do not follow the setpoints."""

from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice
from trex_gui.devices.trex.board.drive_status import drive_statuses
from trex_gui.devices.trex.driving.blockers import DriveBlocker
from trex_gui.devices.trex.driving.board_reasons import BoardInputs
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.drive_status import drive_inputs


def reported(device: Device) -> BoardInputs:
    board = drive_inputs(device).board
    assert board is not None
    return board


def test_situation_follows_the_override_switch(
    rc_device: Device, rc_board: SimulatedDevice, qtbot: QtBot
) -> None:
    assert not reported(rc_device).by_serial
    assert drive_statuses(drive_inputs(rc_device))[0].blocker is DriveBlocker.RC_CHANNELS
    rc_board.do("channel 5 1000us")
    qtbot.waitUntil(lambda: reported(rc_device).by_serial)
    assert drive_statuses(drive_inputs(rc_device))[0].blocker is DriveBlocker.NOT_ARMED


def test_channels_that_keep_safe_start_are_known_after_they_were_read(
    rc_device: Device, rc_board: SimulatedDevice, qtbot: QtBot
) -> None:
    assert rc_device.telemetry.raw is None
    assert reported(rc_device).safe_start == ()
    for channel in (1, 2):  # the board requires the first of them
        rc_board.do(f"channel {channel} silent")
    rc_board.do("channel 3 1680us")

    def said() -> list[str]:
        return [status.text for status in drive_statuses(drive_inputs(rc_device))]

    qtbot.waitUntil(lambda: "Channel 1 is required but has no signal." in said())
    qtbot.waitUntil(lambda: "Channel 3 is 180 µs above neutral." in said())
    assert len(said()) == 3
