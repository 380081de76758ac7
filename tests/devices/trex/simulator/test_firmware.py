"""Complete board: power, sticks, and automatic stops."""

import pytest

from tests.devices.trex.simulator.ports import SETTLED, create_board, write
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.flags import InputSource, UartError
from trex_gui.devices.trex.simulator.channels import Signal
from trex_gui.devices.trex.simulator.control import report
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.motors import MotorDirection

FORWARD, REVERSE, BRAKE = MotorDirection.FORWARD, MotorDirection.REVERSE, MotorDirection.BRAKE


class TestPower:
    def test_power_off_lets_motor_coast(self) -> None:
        board = Board()
        board.serial.drive(1, FORWARD, 127)
        board.advance(1)
        board.power_off()
        assert report(board)["power"] is False
        before = board.physics[0].speed
        board.advance(0.5)
        assert 0 < board.physics[0].speed < before
        board.power_on()
        board.advance(60)
        assert board.physics[0].speed < 0.01

    def test_restored_board_matches_new_board_and_keeps_time(self) -> None:
        board = Board(mode="rc", mix=True)
        board.eeprom.write("device_number", 9)
        board.eeprom.write_calibration(InputSource.RC, 1, Calibration(1, 2, 3, 0))
        board.eeprom.request_reset()
        board.mode_jumper, board.mix, board.so_ground = "serial", False, True
        board.channels.signals[1] = Signal.pulses(2000)
        board.set_fault(2, fault=True)
        board.force_current(1, 5.0)
        board.physics[0].load = 9.0
        board.machine.battery, board.machine.resistance = 9.0, 0.3
        board.power_cycle()
        board.advance(0.5)
        board.factory_reset()
        assert board.now == 0.5
        new = Board(mode="rc", mix=True)
        for each in (board, new):
            each.advance(0.1)
        restored, expected = (
            {key: value for key, value in report(each).items() if key not in {"counters", "leds"}}
            for each in (board, new)
        )
        assert restored == expected
        assert board.eeprom.learned(InputSource.RC) == 0

    def test_small_time_steps_give_same_state_as_one_step(self) -> None:
        boards = Board(seed=3), Board(seed=3)
        for board in boards:
            write(board, "motor1_acceleration", 37)
            board.serial.drive(1, FORWARD, 120, accelerate=True)
        boards[0].advance(0.3)
        for _ in range(300):
            boards[1].advance(0.001)
        assert report(boards[0]) == report(boards[1])


# --- Sticks ---------------------------------------------------------------------------


def connect(board: Board, channel: int, text: str) -> None:
    """Connect a signal, as in the control line `channel`."""
    board.channels.signals[channel] = Signal.parse(text, board.channels.source)


class TestChannelControl:
    @pytest.mark.parametrize("text", ["invalid", "1300us"])
    def test_safe_start_waits_while_required_channel_is_unsafe(self, text: str) -> None:
        board = Board(mode="rc")
        connect(board, 1, text)
        board.power_cycle()
        for _ in range(400):
            board.advance(0.0025)
            assert board.sticks.safe_start
            assert board.motors[1].direction is BRAKE
            assert board.aux.speed == 0

    @pytest.mark.parametrize("kind", ["silent", "1500us lost 0.6"])
    def test_late_signal_does_not_end_safe_start_with_moved_stick(self, kind: str) -> None:
        for seed in range(20):
            board = Board(mode="rc", seed=seed)
            connect(board, 1, kind)
            connect(board, 2, "1900us")
            board.advance(SETTLED)
            connect(board, 1, "1500us")
            board.advance(1)
            assert board.sticks.safe_start
            assert board.motors[1].direction is BRAKE

    def test_sticks_drive_motors_with_their_ramps(self) -> None:
        board = create_board(mode="rc", motor1_acceleration=50)
        board.advance(SETTLED)
        connect(board, 1, "1000us")
        connect(board, 3, "2000us")
        speeds = []
        for _ in range(10):
            board.advance(0.01)
            speeds.append(board.motors[0].speed)
        driven = [speed for speed in speeds if speed != 127]  # 127: brake until the first pulse
        assert driven == list(range(5, 5 * len(driven) + 5, 5))
        assert len(driven) >= 8
        assert board.motors[0].direction is REVERSE
        assert board.aux.speed == 127

    def test_deadband_applies_configured_brake(self) -> None:
        board = create_board(mode="rc", motor1_deadband_brake_pwm=33)
        board.advance(SETTLED)
        assert (board.motors[0].direction, board.motors[0].speed) == (BRAKE, 33)

    def test_analog_mode_reads_voltages(self) -> None:
        board = Board(mode="analog")
        board.advance(SETTLED)
        assert not board.sticks.safe_start
        connect(board, 1, "5V")
        assert board.motors[0].direction is BRAKE
        board.advance(0.03)
        assert (board.motors[0].direction, board.motors[0].speed) == (FORWARD, 127)

    @pytest.mark.parametrize("mode", ["rc", "analog"])
    def test_motors_wait_after_power_up_until_channels_are_known(self, mode: str) -> None:
        board = Board(mode=mode)
        board.advance(0.09)
        assert board.sticks.safe_start
        assert board.motors[0].direction is BRAKE
        board.advance(SETTLED)
        assert not board.sticks.safe_start

    def test_sticks_drive_one_motor_in_joint_mode(self) -> None:
        board = create_board(mode="rc", motor_mode=1)
        board.mix = True
        board.advance(SETTLED)
        for channel in (1, 2):
            connect(board, channel, "2000us")
        board.advance(0.05)
        assert (board.motors[0].direction, board.motors[0].speed) == (FORWARD, 127)
        assert board.motors[1].direction is BRAKE

    def test_serial_override_stops_motor_without_setpoint(self, rc: Board) -> None:
        connect(rc, 1, "2000us")
        rc.advance(0.05)
        assert (rc.motors[0].direction, rc.motors[0].speed) == (FORWARD, 127)
        connect(rc, 5, "1000us")
        rc.advance(0.03)
        assert (rc.motors[0].direction, rc.motors[0].speed) == (BRAKE, 127)


# --- Stops ----------------------------------------------------------------------------


class TestSafety:
    # It is unknown if the serial timeout of a real board needs UART-Error Shutdown.
    @pytest.mark.parametrize(("needs_shutdown", "direction"), [(False, BRAKE), (True, FORWARD)])
    def test_timeout_stops_motor_unless_it_needs_disabled_shutdown(
        self, direction: MotorDirection, *, needs_shutdown: bool
    ) -> None:
        board = Board()
        board.timeout_needs_shutdown = needs_shutdown
        write(board, "uart_error_shutdown", 0)
        write(board, "serial_timeout", 5)
        board.record_byte()
        board.serial.drive(1, FORWARD, 100)
        board.advance(0.51)
        assert board.motors[0].direction is direction
        assert board.serial.pop_uart_errors() == UartError.TIMEOUT

    def test_timeout_is_latched_once_per_silence(self) -> None:
        board = Board()
        write(board, "serial_timeout", 1)
        board.record_byte()
        board.advance(0.2)
        assert board.serial.pop_uart_errors()
        board.advance(1)
        assert not board.serial.pop_uart_errors()
        board.record_byte()
        board.advance(0.2)
        assert board.serial.pop_uart_errors()

    @pytest.mark.parametrize("needs_shutdown", [False, True])
    def test_old_setpoint_is_not_resumed_after_serial_timeout(
        self, *, needs_shutdown: bool
    ) -> None:
        board = create_board(mode="rc", serial_timeout=5)
        board.timeout_needs_shutdown = needs_shutdown
        board.advance(SETTLED)
        board.record_byte()
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
