import pytest

from tests.devices.trex.simulator.ports import SETTLED
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.errors import ResultCode
from trex_gui.devices.trex.protocol.flags import InputSource, Mode, UartError
from trex_gui.devices.trex.simulator.channels import Signal
from trex_gui.devices.trex.simulator.control import report
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.memory import Eeprom
from trex_gui.devices.trex.simulator.motors import MotorDirection

FORWARD = MotorDirection.FORWARD


def write(board: Board, key: str, value: int) -> None:
    """Write a parameter and wait until it is stored."""
    spec = board.memory.parameters[key]
    assert board.set_parameter(spec.number, value) is ResultCode.OK
    board.advance(0.005)


@pytest.fixture
def rc() -> Board:
    """A board in RC mode that has left safe-start."""
    board = Board(mode="rc")
    board.advance(SETTLED)
    assert not board.sticks.safe_start
    return board


class TestPower:
    def test_new_board_is_on_with_motors_off(self) -> None:
        board = Board()
        board.advance(0.1)
        shown = report(board)
        assert shown["power"] is True
        assert [motor["speed"] for motor in shown["motors"]] == [0, 0]
        assert shown["aux"] == {"speed": 0, "target_speed": 0}

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

    def test_power_cycle_clears_latched_errors_and_setpoints(self) -> None:
        board = Board()
        board.serial.drive(1, FORWARD, 127)
        board.report_error(UartError.CRC)
        board.power_cycle()
        assert not board.serial.status
        assert not board.serial.uart_errors
        assert board.motors[0].speed == 0

    def test_write_interrupted_by_power_cycle_is_lost(self) -> None:
        board = Board()
        board.set_parameter(0x07, 5)
        board.advance(0.003)
        board.power_cycle()
        board.advance(1)
        assert board.eeprom["serial_timeout"] == 0

    @pytest.mark.parametrize(
        ("jumper", "mode"), [("serial", Mode.SERIAL_RC), ("rc", Mode.RC), ("analog", Mode.ANALOG)]
    )
    def test_mode_jumper_is_read_at_power_up(self, jumper: str, mode: Mode) -> None:
        board = Board()
        board.mode_jumper = jumper
        assert board.mode is Mode.SERIAL_RC
        board.power_cycle()
        assert board.mode is mode

    def test_input_source_parameter_applies_in_serial_mode_only(self) -> None:
        eeprom = Eeprom()
        eeprom.write("channel_input_source", 1)
        assert Board(eeprom=eeprom).mode is Mode.SERIAL_ANALOG
        assert Board(eeprom=eeprom, mode="rc").mode is Mode.RC

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
        left = {"counters", "leds"}
        shown, wanted = (
            {key: value for key, value in report(each).items() if key not in left}
            for each in (board, new)
        )
        assert shown == wanted
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


class TestParameters:
    def test_parameter_takes_effect_when_its_write_ends(self) -> None:
        board = Board()
        assert board.set_parameter(0x0E, 10) is ResultCode.OK
        assert board.memory.busy_for == pytest.approx(0.004)
        board.advance(0.0039)
        assert board.memory.get(0x0E) == 0
        board.advance(0.0001)
        assert board.memory.get(0x0E) == 10
        assert board.memory.active["motor1_acceleration"] == 10
        assert board.memory.busy_for == 0

    def test_uart_settings_and_motor_mode_need_power_cycle(self) -> None:
        board = Board()
        write(board, "uart_settings", 0x2A)
        write(board, "motor_mode", 1)
        assert board.memory.get(0x7E) == 0x2A
        assert (board.memory.baud, board.memory.crc_polynomial) == (19200, None)
        assert not board.memory.is_joint
        board.power_cycle()
        assert (board.memory.baud, board.memory.crc_polynomial) == (115200, 0x89)
        assert board.memory.is_joint

    def test_factory_reset_takes_effect_at_next_power_up(self) -> None:
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
    def test_invalid_parameter_write_is_rejected_at_once(
        self, number: int, value: int, code: ResultCode
    ) -> None:
        board = Board()
        assert board.set_parameter(number, value) is code
        assert board.memory.busy_for == 0

    def test_writes_are_rejected_in_rc_mode_with_override(self, rc: Board) -> None:
        rc.channels.signals[5] = Signal.pulses(1000)
        rc.advance(0.025)
        assert rc.serial.in_control
        assert rc.set_parameter(0x07, 1) is ResultCode.NOT_SERIAL_MODE
        code = rc.set_calibration(1, Calibration(1, 2, 3, 0))
        assert code is ResultCode.NOT_SERIAL_MODE

    @pytest.mark.parametrize(("firmware", "known"), [("1.0", False), ("1.1", False), ("1.2", True)])
    def test_response_delay_exists_from_firmware_1_2(self, firmware: str, known: bool) -> None:
        board = Board(firmware=firmware)
        code = board.set_parameter(0x17, 1)
        assert code is (ResultCode.OK if known else ResultCode.BAD_PARAMETER)
        assert (board.memory.get(0x17) is not None) == known

    @pytest.mark.parametrize(
        ("firmware", "code", "baud"),
        [("1.0", 7, 19200), ("1.1", 6, 14400), ("1.2", 7, 38400), ("1.0", 8, 57600)],
    )
    def test_firmware_before_1_2_halves_two_baud_rates(
        self, firmware: str, code: int, baud: int
    ) -> None:
        eeprom = Eeprom()
        eeprom.write("uart_settings", code)
        assert Board(firmware=firmware, eeprom=eeprom).memory.baud == baud

    def test_calibration_is_stored_for_active_source_after_32_ms(self) -> None:
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
    def test_calibration_out_of_order_is_rejected(self, values: tuple[int, int, int]) -> None:
        code = Board().set_calibration(1, Calibration(*values, 0))
        assert code is ResultCode.BAD_VALUE
