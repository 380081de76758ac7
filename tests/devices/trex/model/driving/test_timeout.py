"""Whether a serial timeout suits a line."""

import pytest

from trex_gui.core.timing import Timeouts
from trex_gui.devices.trex.driving.timeout_stop import TimeoutStop
from trex_gui.devices.trex.model.drive_texts import timeout_warning_on
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import LineSettings


def effect(timeout: float) -> TimeoutStop:
    """Return what is expected of a timeout in seconds with UART-Error Shutdown set."""
    return TimeoutStop.EXPECTED if timeout else TimeoutStop.OFF


@pytest.mark.parametrize(
    ("url", "baud", "timeout", "said", "offered"),
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
def test_warning_about_the_timeout_fits_the_line(
    url: str, baud: int, timeout: float, said: str, offered: float
) -> None:
    settings = ConnectionSettings(url, LineSettings(baud))
    warning = timeout_warning_on(settings, timeout, effect(timeout), is_guarded=True)
    assert (warning is None) == (not said)
    if warning is not None:
        assert said in warning.text
        assert warning.seconds == offered


def test_slow_line_gets_the_longest_offered_timeout() -> None:
    settings = ConnectionSettings("socket://robot:23", timeouts=Timeouts(extra=10.0))
    warning = timeout_warning_on(settings, 1.0, effect(1.0), is_guarded=True)
    assert warning is not None
    assert warning.seconds == 5.0


@pytest.mark.parametrize(
    ("is_guarded", "fails"), [(True, "cable or this computer"), (False, "or this program")]
)
def test_warning_names_the_program_only_if_no_guardian_watches_it(
    is_guarded: bool, fails: str
) -> None:
    warning = timeout_warning_on(
        ConnectionSettings("/dev/ttyUSB0"), 0, effect(0), is_guarded=is_guarded
    )
    assert warning is not None
    assert fails in warning.text
    assert ("guardian" in warning.text) == (not is_guarded)


def test_missing_guardian_is_reported_although_the_serial_timeout_is_set() -> None:
    warning = timeout_warning_on(
        ConnectionSettings("/dev/ttyUSB0"), 12.5, effect(12.5), is_guarded=False
    )
    assert warning is not None
    assert "serial timeout of 12.5 s" in warning.text
    assert warning.seconds is None
