import pytest

from trex_gui.emulator.channels import Signal
from trex_gui.emulator.eeprom import Eeprom
from trex_gui.emulator.firmware import Board
from trex_gui.emulator.motors import Direction
from trex_gui.protocol.calibration import Calibration
from trex_gui.protocol.errors import ResultCode
from trex_gui.protocol.flags import InputSource, Mode, Status, UartError

FORWARD, REVERSE, BRAKE = Direction.FORWARD, Direction.REVERSE, Direction.BRAKE


def write(board: Board, key: str, value: int) -> None:
    """Write a parameter and wait until it is stored."""
    spec = board.memory.parameters[key]
    assert board.set_parameter(spec.number, value) is ResultCode.OK
    board.advance(0.005)


def put(board: Board, channel: int, text: str) -> None:
    board.connect(channel, Signal.parse(text, board.channels.source))


def waits(board: Board) -> bool:
    return board.safe_start


@pytest.fixture
def rc() -> Board:
    """A board in RC mode that has left safe-start."""
    board = Board(mode="rc")
    board.advance(0.02)
    return board


class TestPower:
    def test_a_new_board_is_on_and_its_motors_are_off(self) -> None:
        board = Board()
        board.advance(0.1)
        shown = board.show()
        assert shown["power"] is True
        assert [motor["speed"] for motor in shown["motors"]] == [0, 0]
        assert shown["aux"] == {"speed": 0, "target_speed": 0}

    def test_switching_off_lets_the_motors_run_out(self) -> None:
        board = Board()
        board.serial.drive(1, FORWARD, 127)
        board.advance(1)
        board.power_off()
        assert board.show()["power"] is False
        before = board.physics[0].speed
        board.advance(0.5)
        assert 0 < board.physics[0].speed < before
        board.power_on()
        board.advance(60)
        assert board.physics[0].speed < 0.01

    def test_a_power_cycle_clears_latches_and_orders(self) -> None:
        board = Board()
        board.serial.drive(1, FORWARD, 127)
        board.report_error(UartError.CRC)
        board.power_cycle()
        assert not board.serial.status
        assert not board.serial.uart_errors
        assert board.motors[0].speed == 0

    def test_a_write_that_the_power_interrupts_is_lost(self) -> None:
        board = Board()
        board.set_parameter(0x07, 5)
        board.advance(0.003)
        board.power_cycle()
        board.advance(1)
        assert board.eeprom["serial_timeout"] == 0

    @pytest.mark.parametrize(
        ("jumper", "mode"), [("serial", Mode.SERIAL_RC), ("rc", Mode.RC), ("analog", Mode.ANALOG)]
    )
    def test_the_mode_jumper_is_read_at_power_up(self, jumper: str, mode: Mode) -> None:
        board = Board()
        board.mode_jumper = jumper
        assert board.mode is Mode.SERIAL_RC
        board.power_cycle()
        assert board.mode is mode

    def test_the_input_source_counts_in_serial_mode_only(self) -> None:
        eeprom = Eeprom()
        eeprom.write("channel_input_source", 1)
        assert Board(eeprom=eeprom).mode is Mode.SERIAL_ANALOG
        assert Board(eeprom=eeprom, mode="rc").mode is Mode.RC

    def test_time_in_small_steps_is_time_in_one(self) -> None:
        boards = Board(seed=3), Board(seed=3)
        for board in boards:
            write(board, "motor1_acceleration", 37)
            board.serial.drive(1, FORWARD, 120, accelerate=True)
        boards[0].advance(0.3)
        for _ in range(300):
            boards[1].advance(0.001)
        assert boards[0].show() == boards[1].show()


class TestParameters:
    def test_a_parameter_acts_when_its_write_is_finished(self) -> None:
        board = Board()
        assert board.set_parameter(0x0E, 10) is ResultCode.OK
        assert board.memory.busy_for == pytest.approx(0.004)
        board.advance(0.0039)
        assert board.memory.get(0x0E) == 0
        board.advance(0.0001)
        assert board.memory.get(0x0E) == 10
        assert board.memory.active["motor1_acceleration"] == 10
        assert board.memory.busy_for == 0

    def test_the_high_parameters_act_after_a_power_cycle(self) -> None:
        board = Board()
        write(board, "uart_settings", 0x2A)
        write(board, "motor_mode", 1)
        assert board.memory.get(0x7E) == 0x2A
        assert (board.memory.baud, board.memory.crc_polynomial) == (19200, None)
        assert not board.memory.is_joint
        board.power_cycle()
        assert (board.memory.baud, board.memory.crc_polynomial) == (115200, 0x89)
        assert board.memory.is_joint

    def test_a_factory_reset_acts_at_the_next_power_up(self) -> None:
        board = Board()
        write(board, "serial_timeout", 9)
        write(board, "factory_reset", 0x7F)
        assert board.memory.get(0x07) == 9
        board.power_cycle()
        assert board.memory.get(0x07) == 0

    @pytest.mark.parametrize(
        ("number", "value", "code"),
        [
            (0x18, 0, ResultCode.BAD_PARAMETER),
            (0x7A, 0, ResultCode.BAD_PARAMETER),
            (0x08, 2, ResultCode.BAD_VALUE),
            (0x01, 0x20, ResultCode.BAD_VALUE),
            (0x7E, 0x0B, ResultCode.BAD_VALUE),
            (0x7F, 0, ResultCode.BAD_VALUE),
        ],
    )
    def test_what_is_wrong_is_refused_at_once(
        self, number: int, value: int, code: ResultCode
    ) -> None:
        board = Board()
        assert board.set_parameter(number, value) is code
        assert board.memory.busy_for == 0

    def test_only_serial_mode_takes_them(self, rc: Board) -> None:
        put(rc, 5, "1000us")
        assert rc.serial.in_control
        assert rc.set_parameter(0x07, 1) is ResultCode.NOT_SERIAL_MODE
        code = rc.set_calibration(1, Calibration(1, 2, 3, 0))
        assert code is ResultCode.NOT_SERIAL_MODE

    @pytest.mark.parametrize(("firmware", "known"), [("1.0", False), ("1.1", False), ("1.2", True)])
    def test_the_response_delay_came_with_firmware_1_2(self, firmware: str, known: bool) -> None:
        board = Board(firmware=firmware)
        code = board.set_parameter(0x17, 1)
        assert code is (ResultCode.OK if known else ResultCode.BAD_PARAMETER)
        assert (board.memory.get(0x17) is not None) == known

    @pytest.mark.parametrize(
        ("firmware", "code", "baud"),
        [("1.0", 7, 19200), ("1.1", 6, 14400), ("1.2", 7, 38400), ("1.0", 8, 57600)],
    )
    def test_old_firmware_halves_two_rates(self, firmware: str, code: int, baud: int) -> None:
        eeprom = Eeprom()
        eeprom.write("uart_settings", code)
        assert Board(firmware=firmware, eeprom=eeprom).memory.baud == baud

    def test_a_calibration_takes_longer_and_goes_to_the_set_in_use(self) -> None:
        board = Board()
        stick = Calibration(2600, 3660, 4700, 50)
        assert board.set_calibration(2, stick) is ResultCode.OK
        board.advance(0.031)
        assert board.calibration(2) != stick
        board.advance(0.001)
        assert board.calibration(2) == stick
        assert board.eeprom.learned(InputSource.RC) == 0b00010
        assert board.eeprom.learned(InputSource.ANALOG) == 0

    @pytest.mark.parametrize("values", [(5, 4, 9), (1, 9, 8), (3, 3, 3)])
    def test_a_calibration_out_of_order_is_refused(self, values: tuple[int, int, int]) -> None:
        code = Board().set_calibration(1, Calibration(*values, 0))
        assert code is ResultCode.BAD_VALUE


class TestChannelControl:
    def test_safe_start_ends_when_all_is_well(self) -> None:
        board = Board(mode="rc")
        put(board, 2, "1900us")
        board.power_cycle()
        board.advance(0.1)
        assert waits(board)
        assert board.motors[1].direction is BRAKE
        put(board, 2, "1500us")
        assert not waits(board)
        put(board, 2, "1900us")
        board.advance(0.02)
        assert not waits(board)
        assert board.motors[1].direction is FORWARD

    @pytest.mark.parametrize(
        ("channel", "text"), [(1, "invalid"), (1, "1300us"), (3, "1900us"), (5, "1000us")]
    )
    def test_safe_start_waits_for(self, channel: int, text: str) -> None:
        board = Board(mode="rc")
        put(board, channel, text)
        board.power_cycle()
        board.advance(1)
        assert waits(board)

    def test_a_channel_that_is_not_required_may_be_silent(self) -> None:
        board = Board(mode="rc")
        put(board, 2, "invalid")
        board.power_cycle()
        board.advance(1)
        assert not waits(board)

    def test_a_required_channel_that_falls_silent_stops_the_motors(self, rc: Board) -> None:
        put(rc, 2, "2000us")
        rc.advance(0.1)
        assert rc.motors[1].speed == 127
        put(rc, 1, "silent")
        rc.advance(0.49)
        assert not waits(rc)
        rc.advance(0.03)
        assert waits(rc)
        assert (rc.motors[1].direction, rc.motors[1].speed) == (BRAKE, 127)
        put(rc, 1, "1500us")
        assert waits(rc)  # channel 2 is not at rest
        put(rc, 2, "1500us")
        assert not waits(rc)

    def test_sticks_drive_the_motors_with_their_ramps(self) -> None:
        eeprom = Eeprom()
        eeprom.write("motor1_acceleration", 50)
        board = Board(mode="rc", eeprom=eeprom)
        board.advance(0.02)
        put(board, 1, "1000us")
        put(board, 3, "2000us")
        board.advance(0.1)
        assert (board.motors[0].direction, board.motors[0].speed) == (REVERSE, 50)
        assert board.aux.speed == 127

    def test_in_the_deadband_the_motor_is_braked_as_told(self) -> None:
        eeprom = Eeprom()
        eeprom.write("motor1_deadband_brake_pwm", 33)
        board = Board(mode="rc", eeprom=eeprom)
        board.advance(0.02)
        assert (board.motors[0].direction, board.motors[0].speed) == (BRAKE, 33)

    def test_the_mix_jumper_acts_at_once(self, rc: Board) -> None:
        put(rc, 2, "1750us")
        rc.mix = True
        first, second, *_ = rc.remapped
        assert first == second > 0
        rc.advance(0.02)
        assert rc.motors[0].speed == rc.motors[1].speed == first

    def test_analog_mode_reads_voltages(self) -> None:
        board = Board(mode="analog")
        board.advance(0.02)
        assert not waits(board)
        put(board, 1, "5V")
        board.advance(0.02)
        assert (board.motors[0].direction, board.motors[0].speed) == (FORWARD, 127)


class TestSerialOverride:
    def test_channel_five_hands_control_to_the_latest_serial_orders(self, rc: Board) -> None:
        rc.serial.drive(1, FORWARD, 10)
        rc.serial.drive(1, FORWARD, 77)
        rc.serial.drive(2, REVERSE, 55, accelerate=True)
        rc.serial.drive_aux(44)
        rc.advance(0.1)
        assert rc.motors[0].direction is BRAKE
        put(rc, 5, "1000us")
        assert rc.override
        assert rc.serial.in_control
        assert (rc.motors[0].direction, rc.motors[0].speed) == (FORWARD, 77)
        assert rc.aux.speed == 44
        assert rc.motors[1].speed != 55
        rc.advance(0.01)
        assert (rc.motors[1].direction, rc.motors[1].speed) == (REVERSE, 55)

    def test_a_motor_without_an_order_stops(self, rc: Board) -> None:
        put(rc, 1, "2000us")
        rc.advance(0.05)
        put(rc, 5, "1000us")
        assert (rc.motors[0].direction, rc.motors[0].speed) == (BRAKE, 127)

    def test_the_sticks_take_over_again(self, rc: Board) -> None:
        rc.serial.drive(1, FORWARD, 77)
        put(rc, 5, "1000us")
        put(rc, 1, "1000us")
        put(rc, 5, "2000us")
        rc.advance(0.02)
        assert not rc.serial.in_control
        assert (rc.motors[0].direction, rc.motors[0].speed) == (REVERSE, 127)

    def test_serial_mode_knows_no_override(self) -> None:
        board = Board()
        put(board, 5, "1000us")
        board.advance(0.1)
        assert not board.override
        assert board.serial.in_control


class TestSafety:
    def test_motors_stop_when_the_host_falls_silent(self) -> None:
        board = Board()
        write(board, "serial_timeout", 5)
        board.hear()
        board.serial.drive(1, FORWARD, 100)
        board.serial.drive_aux(100)
        board.advance(0.49)
        assert board.motors[0].speed == 100
        board.advance(0.02)
        assert (board.motors[0].direction, board.aux.speed) == (BRAKE, 0)
        assert board.serial.take_uart_errors() == UartError.TIMEOUT
        assert board.serial.take_status() == Status.UART_ERROR

    def test_the_timeout_is_latched_once_for_each_silence(self) -> None:
        board = Board()
        write(board, "serial_timeout", 1)
        board.hear()
        board.advance(0.2)
        assert board.serial.take_uart_errors()
        board.advance(1)
        assert not board.serial.take_uart_errors()
        board.hear()
        board.advance(0.2)
        assert board.serial.take_uart_errors()

    def test_every_byte_puts_the_timeout_off_and_the_next_order_starts_again(self) -> None:
        board = Board()
        write(board, "serial_timeout", 1)
        board.serial.drive(1, FORWARD, 100)
        for _ in range(50):
            board.hear()
            board.advance(0.09)
        assert board.motors[0].speed == 100
        board.advance(0.1)
        assert board.motors[0].direction is BRAKE
        board.hear()
        board.serial.drive(1, REVERSE, 5)
        assert (board.motors[0].direction, board.motors[0].speed) == (REVERSE, 5)

    def test_an_old_order_of_a_silent_host_does_not_come_back(self) -> None:
        eeprom = Eeprom()
        eeprom.write("serial_timeout", 5)
        board = Board(mode="rc", eeprom=eeprom)
        board.advance(0.02)
        board.hear()
        board.serial.drive(1, FORWARD, 77)
        board.advance(2)
        assert not board.serial.uart_errors  # the channels are in control
        put(board, 5, "1000us")
        board.advance(0.02)
        assert board.motors[0].direction is BRAKE
        assert board.serial.uart_errors == UartError.TIMEOUT

    @pytest.mark.parametrize(("setting", "speed"), [(0, 100), (1, 127)])
    def test_a_line_error_stops_the_motors_if_told_so(self, setting: int, speed: int) -> None:
        board = Board()
        write(board, "uart_error_shutdown", setting)
        board.serial.drive(1, FORWARD, 100)
        board.report_error(UartError.FRAMING)
        stopped = board.motors[0].direction is BRAKE
        assert (stopped, board.motors[0].speed) == (bool(setting), speed)
        assert board.serial.status == Status.UART_ERROR

    def test_a_line_error_does_not_stop_what_the_sticks_drive(self, rc: Board) -> None:
        put(rc, 1, "2000us")
        rc.advance(0.05)
        rc.report_error(UartError.FORMAT)
        assert rc.motors[0].direction is FORWARD

    def test_reading_clears_each_byte_by_itself(self) -> None:
        board = Board()
        board.report_error(UartError.CRC)
        assert board.serial.take_status() == Status.UART_ERROR
        assert board.serial.take_status() == 0
        assert board.serial.take_uart_errors() == UartError.CRC
        assert board.serial.take_uart_errors() == 0

    def test_a_fault_is_latched_again_while_it_lasts(self) -> None:
        board = Board()
        board.set_fault(2, fault=True)
        assert board.serial.take_status() == Status.MOTOR2_FAULT
        board.advance(0.01)
        assert board.serial.take_status() == Status.MOTOR2_FAULT
        board.set_fault(2, fault=False)
        board.advance(0.01)
        assert board.serial.take_status() == 0


class TestCurrents:
    def test_the_limiter_slows_a_motor_that_draws_too_much(self) -> None:
        board = Board()
        write(board, "motor1_current_limit", 20)  # 40 counts, 6 A
        write(board, "motor1_current_limit_p", 1)
        write(board, "motor1_acceleration", 20)
        board.physics[0].load = 12.0
        board.serial.drive(1, FORWARD, 127, accelerate=True)
        board.advance(5)
        assert board.serial.take_status() == Status.MOTOR1_OVER_LIMIT
        assert 30 < board.motors[0].speed < 110
        assert board.physics[0].current < 8

    @pytest.mark.parametrize(("mode", "rate"), [("rc", 80), ("analog", 50)])
    def test_currents_are_renewed_as_often_as_documented(self, mode: str, rate: int) -> None:
        board = Board(mode=mode)
        board.physics[0].forced = 1.0
        board.advance(1 / rate + 0.001)
        assert board.physics[0].reading == 7
        board.physics[0].forced = 2.0
        board.advance(1 / rate - 0.003)
        assert board.physics[0].reading == 7
        board.advance(0.003)
        assert board.physics[0].reading == 13

    def test_joint_mode_has_one_motor_and_no_currents(self) -> None:
        eeprom = Eeprom()
        eeprom.write("motor_mode", 1)
        board = Board(eeprom=eeprom)
        board.serial.drive(1, FORWARD, 100)
        board.serial.drive(2, FORWARD, 100)
        board.force_current(1, 5.0)
        board.advance(0.5)
        assert (board.motors[0].speed, board.motors[1].speed) == (100, 0)
        assert [physics.reading for physics in board.physics] == [0, 0]

    def test_joint_mode_lets_the_sticks_drive_one_motor(self) -> None:
        eeprom = Eeprom()
        eeprom.write("motor_mode", 1)
        board = Board(eeprom=eeprom, mode="rc", mix=True)
        board.advance(0.02)
        put(board, 1, "2000us")
        put(board, 2, "2000us")
        board.advance(0.05)
        assert (board.motors[0].direction, board.motors[0].speed) == (FORWARD, 127)
        assert board.motors[1].direction is BRAKE
