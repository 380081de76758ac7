"""What stops motors by itself: silence, line errors, faults, too much current; joint mode."""

import pytest

from tests.devices.trex.simulator.ports import SETTLED, write
from trex_gui.devices.trex.protocol.flags import UartError
from trex_gui.devices.trex.simulator.channels import Signal
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.memory import Eeprom
from trex_gui.devices.trex.simulator.motors import MotorDirection

FORWARD, REVERSE, BRAKE = MotorDirection.FORWARD, MotorDirection.REVERSE, MotorDirection.BRAKE


either_firmware = pytest.mark.parametrize("needs_shutdown", [False, True])
"""Whether the serial timeout needs UART-Error Shutdown, which is on in these tests, is unknown."""


class TestSafety:
    @pytest.mark.parametrize(("needs_shutdown", "direction"), [(False, BRAKE), (True, FORWARD)])
    def test_timeout_without_shutdown_is_latched_and_stops_under_one_hypothesis(
        self, direction: MotorDirection, *, needs_shutdown: bool
    ) -> None:
        board = Board()
        board.timeout_needs_shutdown = needs_shutdown
        write(board, "uart_error_shutdown", 0)
        write(board, "serial_timeout", 5)
        board.note_byte()
        board.serial.drive(1, FORWARD, 100)
        board.advance(0.51)
        assert board.motors[0].direction is direction
        assert board.serial.take_uart_errors() == UartError.TIMEOUT

    def test_timeout_is_latched_once_per_silence(self) -> None:
        board = Board()
        write(board, "serial_timeout", 1)
        board.note_byte()
        board.advance(0.2)
        assert board.serial.take_uart_errors()
        board.advance(1)
        assert not board.serial.take_uart_errors()
        board.note_byte()
        board.advance(0.2)
        assert board.serial.take_uart_errors()

    @either_firmware
    def test_old_setpoint_is_not_resumed_after_serial_timeout(
        self, *, needs_shutdown: bool
    ) -> None:
        eeprom = Eeprom()
        eeprom.write("serial_timeout", 5)
        board = Board(mode="rc", eeprom=eeprom)
        board.timeout_needs_shutdown = needs_shutdown
        board.advance(SETTLED)
        board.note_byte()
        board.serial.drive(1, FORWARD, 77)
        board.advance(2)
        assert not board.serial.uart_errors  # the channels are in control
        board.channels.signals[5] = Signal.pulses(1000)
        board.advance(0.03)
        assert board.motors[0].direction is BRAKE
        assert board.serial.uart_errors == UartError.TIMEOUT

    def test_line_error_does_not_stop_motor_driven_by_stick(self, rc: Board) -> None:
        rc.channels.signals[1] = Signal.pulses(2000)
        rc.advance(0.05)
        assert rc.motors[0].direction is FORWARD
        rc.report_error(UartError.FORMAT)
        assert rc.motors[0].direction is FORWARD


class TestCurrents:
    def test_sticks_drive_one_motor_in_joint_mode(self) -> None:
        eeprom = Eeprom()
        eeprom.write("motor_mode", 1)
        board = Board(eeprom=eeprom, mode="rc", mix=True)
        board.advance(SETTLED)
        for channel in (1, 2):
            board.channels.signals[channel] = Signal.pulses(2000)
        board.advance(0.05)
        assert (board.motors[0].direction, board.motors[0].speed) == (FORWARD, 127)
        assert board.motors[1].direction is BRAKE
