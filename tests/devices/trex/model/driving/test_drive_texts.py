"""Texts of the Motors page."""

import pytest
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice
from trex_gui.core.timing import Timeouts
from trex_gui.devices.trex.board.drive_status import drive_statuses
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
    rc_board.do("channel 1 1900us", "channel 3 1100us")
    rc_board.do("channel 5 1000us")  # lets the serial port control the motors
    qtbot.waitUntil(lambda: "channel 1 at +" in report_text(rc_device, 1))
    assert report_text(rc_device, 2) == "channel 2 at 0 (overridden)"
    assert report_text(rc_device, 3) == "channel 3 at +99 (overridden)"


# --- Safe-start -------------------------------------------------------------------------


def test_safe_start_reasons_need_channel_readings(
    rc_device: Device, rc_board: SimulatedDevice, qtbot: QtBot
) -> None:
    assert rc_device.telemetry.raw is None
    board = drive_inputs(rc_device).board
    assert board is not None
    assert board.safe_start == ()
    for channel in (1, 2):  # the board requires channel 1
        rc_board.do(f"channel {channel} silent")
    rc_board.do("channel 3 1680us")

    def texts() -> list[str]:
        return [status.text for status in drive_statuses(drive_inputs(rc_device))]

    qtbot.waitUntil(lambda: "Channel 1 is required but has no signal." in texts())
    qtbot.waitUntil(lambda: "Channel 3 is 180 µs above neutral." in texts())
    assert len(texts()) == 3


# --- Serial timeout ---------------------------------------------------------------------


def warning_on(
    url: str = "/dev/ttyUSB0",
    baud: int = 19200,
    timeout: float = 0.0,
    stop: TimeoutStop | None = None,
    *,
    extra: float = 0.0,
    is_guarded: bool = True,
) -> tuple[str, float | None]:
    """Return the text of the warning and the offered timeout (s)."""
    settings = ConnectionSettings(url, LineSettings(baud), timeouts=Timeouts(extra=extra))
    stop = stop or (TimeoutStop.EXPECTED if timeout else TimeoutStop.OFF)
    warning = timeout_warning_on(settings, timeout, stop, is_guarded=is_guarded)
    return ("", 0.0) if warning is None else (warning.text, warning.seconds)


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
    text, seconds = warning_on(url, baud, timeout)
    assert words in text
    assert bool(text) is bool(words)
    assert seconds == offered


def test_slow_line_and_shutdown_determine_the_offered_timeout() -> None:
    assert warning_on("socket://robot:23", timeout=1.0, extra=10.0)[1] == 5.0, "the longest"
    for stop in (TimeoutStop.DOUBTFUL, TimeoutStop.REFUTED):
        assert warning_on(timeout=2.0, stop=stop)[1] == 2.0, "a longer timeout is not shortened"


@pytest.mark.parametrize(
    ("is_guarded", "timeout", "words", "offered"),
    [
        (True, 0.0, "cable or this computer", 0.5),
        (False, 0.0, "or this program", 0.5),
        (False, 12.5, "serial timeout of 12.5 s", None),
    ],
)
def test_warning_names_the_program_if_there_is_no_guardian(
    is_guarded: bool, timeout: float, words: str, offered: float | None
) -> None:
    text, seconds = warning_on(timeout=timeout, is_guarded=is_guarded)
    assert words in text
    assert ("guardian" in text) is not is_guarded
    assert seconds == offered
