"""The program drops setpoints when the board stops its motors by itself."""

import pytest

from trex_gui.devices.trex.client.telemetry import LatchedStatus
from trex_gui.devices.trex.model.drive_controller import why_the_board_stopped
from trex_gui.devices.trex.protocol.flags import Status, UartError


@pytest.mark.parametrize("errors_stop", [False, True])
def test_serial_timeout_always_explains_the_stop(*, errors_stop: bool) -> None:
    news = LatchedStatus(0.0, Status.UART_ERROR, UartError.TIMEOUT)
    assert "Serial Timeout" in why_the_board_stopped(news, errors_stop=errors_stop)


@pytest.mark.parametrize("bit", [bit for bit in UartError if bit is not UartError.TIMEOUT])
def test_line_error_explains_the_stop_only_if_errors_stop(bit: UartError) -> None:
    news = LatchedStatus(0.0, Status.UART_ERROR, bit)
    assert "error on the line" in why_the_board_stopped(news, errors_stop=True)
    assert why_the_board_stopped(news, errors_stop=False) == ""


def test_motor_status_bits_do_not_explain_a_stop() -> None:
    news = LatchedStatus(0.0, Status.MOTOR1_FAULT | Status.MOTOR2_OVER_LIMIT, UartError(0))
    assert why_the_board_stopped(news, errors_stop=True) == ""
