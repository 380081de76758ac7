"""Expected effect of the serial timeout, under both hypotheses about UART-Error Shutdown."""

import pytest

from trex_gui.devices.trex.driving.timeout_stop import (
    TimeoutStop,
    TimeoutTrial,
    remedy_for_silence,
    timeout_stop,
    turning_text,
    with_shutdown,
)
from trex_gui.devices.trex.model.drive_texts import timeout_warning_on
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.memory import Eeprom
from trex_gui.devices.trex.simulator.motors import MotorDirection

CUT = "Cut the power."
SHOULD_STOP = (
    "The board should stop its motors 0.5 s after the last byte. If it does not, cut the power."
)


def keeps_turning(timeout: int, shutdown: int, *, needs_shutdown: bool) -> bool:
    """Return whether motor 1 still turns after two silent seconds."""
    eeprom = Eeprom()
    eeprom.write("serial_timeout", timeout)
    eeprom.write("uart_error_shutdown", shutdown)
    board = Board(eeprom=eeprom)
    board.timeout_needs_shutdown = needs_shutdown
    board.record_byte()
    board.serial.drive(1, MotorDirection.FORWARD, 60)
    board.advance(2)
    return board.motors[0].direction is MotorDirection.FORWARD


@pytest.mark.parametrize("needs_shutdown", [False, True])
@pytest.mark.parametrize(
    ("timeout", "shutdown", "warning", "remedy"),
    [
        (0, 0, "Serial timeout is off", CUT),
        (0, 1, "Serial timeout is off", CUT),
        (5, 0, "UART-Error Shutdown is off", CUT),
        (5, 1, None, SHOULD_STOP),
    ],
)
def test_warning_is_shown_if_motors_keep_turning(
    timeout: int, shutdown: int, warning: str | None, remedy: str, *, needs_shutdown: bool
) -> None:
    stop = timeout_stop({"serial_timeout": timeout, "uart_error_shutdown": shutdown})
    line = ConnectionSettings("/dev/ttyUSB0")
    message = timeout_warning_on(line, timeout / 10, stop, is_guarded=True)
    assert (message is None) == (warning is None)
    assert message is None or message.text.startswith(warning or "")
    assert remedy_for_silence(stop, "0.5 s") == remedy
    if keeps_turning(timeout, shutdown, needs_shutdown=needs_shutdown):
        assert message is not None
        assert remedy == CUT


def test_proposed_settings_stop_the_motors_under_both_hypotheses() -> None:
    proposed = with_shutdown(5)
    for needs_shutdown in (False, True):
        assert not keeps_turning(*proposed.values(), needs_shutdown=needs_shutdown)


@pytest.mark.parametrize(
    ("stopped", "tried_with_shutdown", "expected"),
    [
        # Expected with 0x08 = 0 and with 0x08 = 1.
        (True, False, (TimeoutStop.TRIED, TimeoutStop.TRIED)),
        (True, True, (TimeoutStop.DOUBTFUL, TimeoutStop.TRIED)),
        (False, False, (TimeoutStop.REFUTED, TimeoutStop.EXPECTED)),
        (False, True, (TimeoutStop.FAILED, TimeoutStop.FAILED)),
    ],
)
def test_trial_decides_expected_stop(
    expected: tuple[TimeoutStop, TimeoutStop], *, stopped: bool, tried_with_shutdown: bool
) -> None:
    trial = TimeoutTrial(stopped, tried_with_shutdown)
    line = ConnectionSettings("/dev/ttyUSB0")
    for shutdown, stop in enumerate(expected):
        stored = {"serial_timeout": 5, "uart_error_shutdown": shutdown}
        assert timeout_stop(stored, trial) is stop
        warning = timeout_warning_on(line, 0.5, stop, is_guarded=True)
        assert (warning is None) is stop.is_reliable
        assert bool(warning and warning.seconds) is stop.is_fixable


@pytest.mark.parametrize(
    ("motors", "text"),
    [
        ({1}, "Motor 1 may still be turning."),
        ({3}, "The auxiliary motor may still be turning."),
        ({1, 2}, "Motors may still be turning."),
        (set(), "Motors may still be turning."),
    ],
)
def test_warning_names_the_motor_that_was_driven(motors: set[int], text: str) -> None:
    assert turning_text(motors) == text
