"""The program drops setpoints when the board stops its motors by itself."""

import pytest
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice
from trex_gui.devices.trex.client.telemetry import LatchedStatus
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.drive_controller import why_the_board_stopped
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.flags import Status, UartError
from trex_gui.ui.devices.connection import ConnectionState


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


def test_line_error_disarms_and_clears_setpoints(
    device: Device, quick_simulator: SimulatedDevice, qtbot: QtBot
) -> None:
    device.connect_to(ConnectionSettings(quick_simulator.url))
    qtbot.waitUntil(
        lambda: device.link is ConnectionState.CONNECTED and device.motors.is_available,
        timeout=20_000,
    )
    device.motors.arm()
    device.motors.accelerate = False
    device.motors.set_speed(1, 90)
    qtbot.waitUntil(lambda: quick_simulator.show()["motors"][0]["speed"] == 90, timeout=20_000)
    quick_simulator.do("line error framing 1")
    qtbot.waitUntil(lambda: not device.motors.armed, timeout=20_000)
    assert "framing error" in device.motors.stop_reason
    assert device.motors.text == ""
    qtbot.waitUntil(lambda: not device.may_move, timeout=20_000)
    assert quick_simulator.show()["motors"][0]["direction"] == "brake"
