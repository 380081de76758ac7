"""Texts of the Motors page."""

import pytest
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice
from trex_gui.core.timing import Timeouts
from trex_gui.devices.trex.board.drive_status import drive_statuses
from trex_gui.devices.trex.driving.blockers import DriveBlocker
from trex_gui.devices.trex.driving.board_reasons import BoardInputs
from trex_gui.devices.trex.driving.timeout_stop import TimeoutStop
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.drive_status import drive_inputs
from trex_gui.devices.trex.model.drive_texts import report_text, setpoint_text, timeout_warning_on
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.line_settings import LineSettings


@pytest.mark.parametrize(
    ("drive", "text"),
    [
        (None, "–"),
        (Drive.brake(0), "coast"),
        (Drive.brake(127), "brake, 100 %"),
        (Drive.at(-64), "50 %"),
    ],
)
def test_setpoint_text_names_the_commanded_drive(drive: Drive | None, text: str) -> None:
    assert setpoint_text(drive) == text


def test_fault_is_shown_only_for_its_motor(
    rc_device: Device, rc_board: SimulatedDevice, qtbot: QtBot
) -> None:
    rc_board.do("fault 2 on")
    qtbot.waitUntil(lambda: "fault" in report_text(rc_device, 2))
    assert not any(report_text(rc_device, motor) for motor in (1, 3))


def test_report_shows_speeds_that_channel_5_overrides(
    rc_device: Device, rc_board: SimulatedDevice, qtbot: QtBot
) -> None:
    rc_board.do("channel 1 1900us")
    rc_board.do("channel 3 1100us")
    rc_board.do("channel 5 1000us")  # lets the serial port control the motors
    qtbot.waitUntil(lambda: "channel 1 at +" in report_text(rc_device, 1))
    assert report_text(rc_device, 2) == "channel 2 at 0 (overridden)"
    assert report_text(rc_device, 3) == "channel 3 at +99 (overridden)"


# --- Blockers ---------------------------------------------------------------------------


def board_inputs(device: Device) -> BoardInputs:
    board = drive_inputs(device).board
    assert board is not None
    return board


def test_blocker_follows_the_override_switch(
    rc_device: Device, rc_board: SimulatedDevice, qtbot: QtBot
) -> None:
    assert not board_inputs(rc_device).by_serial
    assert drive_statuses(drive_inputs(rc_device))[0].blocker is DriveBlocker.RC_CHANNELS
    rc_board.do("channel 5 1000us")
    qtbot.waitUntil(lambda: board_inputs(rc_device).by_serial)
    assert drive_statuses(drive_inputs(rc_device))[0].blocker is DriveBlocker.NOT_ARMED


def test_safe_start_reasons_need_channel_readings(
    rc_device: Device, rc_board: SimulatedDevice, qtbot: QtBot
) -> None:
    assert rc_device.telemetry.raw is None
    assert board_inputs(rc_device).safe_start == ()
    for channel in (1, 2):  # the board requires channel 1
        rc_board.do(f"channel {channel} silent")
    rc_board.do("channel 3 1680us")

    def texts() -> list[str]:
        return [status.text for status in drive_statuses(drive_inputs(rc_device))]

    qtbot.waitUntil(lambda: "Channel 1 is required but has no signal." in texts())
    qtbot.waitUntil(lambda: "Channel 3 is 180 µs above neutral." in texts())
    assert len(texts()) == 3


# --- Serial timeout ---------------------------------------------------------------------


def effect(timeout: float) -> TimeoutStop:
    """Return the expected effect of a timeout with UART-Error Shutdown set."""
    return TimeoutStop.EXPECTED if timeout else TimeoutStop.OFF


@pytest.mark.parametrize(
    ("url", "baud", "timeout", "words", "offered"),
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
def test_timeout_warning_depends_on_port_and_baud_rate(
    url: str, baud: int, timeout: float, words: str, offered: float
) -> None:
    settings = ConnectionSettings(url, LineSettings(baud))
    warning = timeout_warning_on(settings, timeout, effect(timeout), is_guarded=True)
    assert (warning is None) == (not words)
    if warning is not None:
        assert words in warning.text
        assert warning.seconds == offered


@pytest.mark.parametrize("stop", [TimeoutStop.DOUBTFUL, TimeoutStop.REFUTED])
def test_longer_timeout_is_not_shortened_with_the_shutdown(stop: TimeoutStop) -> None:
    warning = timeout_warning_on(ConnectionSettings("/dev/ttyUSB0"), 2.0, stop, is_guarded=True)
    assert warning is not None
    assert warning.seconds == 2.0


def test_slow_line_gets_a_warning_with_the_longest_timeout() -> None:
    settings = ConnectionSettings("socket://robot:23", timeouts=Timeouts(extra=10.0))
    warning = timeout_warning_on(settings, 1.0, effect(1.0), is_guarded=True)
    assert warning is not None
    assert warning.seconds == 5.0


@pytest.mark.parametrize(
    ("is_guarded", "cause"), [(True, "cable or this computer"), (False, "or this program")]
)
def test_warning_names_the_program_if_there_is_no_guardian(is_guarded: bool, cause: str) -> None:
    warning = timeout_warning_on(
        ConnectionSettings("/dev/ttyUSB0"), 0, effect(0), is_guarded=is_guarded
    )
    assert warning is not None
    assert cause in warning.text
    assert ("guardian" in warning.text) == (not is_guarded)


def test_missing_guardian_is_reported_with_the_timeout() -> None:
    warning = timeout_warning_on(
        ConnectionSettings("/dev/ttyUSB0"), 12.5, effect(12.5), is_guarded=False
    )
    assert warning is not None
    assert "serial timeout of 12.5 s" in warning.text
    assert warning.seconds is None
