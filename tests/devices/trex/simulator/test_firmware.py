import pytest

from tests.devices.trex.simulator.ports import write
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.errors import ResultCode
from trex_gui.devices.trex.protocol.flags import InputSource, UartError
from trex_gui.devices.trex.simulator.channels import Signal
from trex_gui.devices.trex.simulator.control import report
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.memory import Eeprom
from trex_gui.devices.trex.simulator.motors import MotorDirection

FORWARD = MotorDirection.FORWARD


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

    def test_power_cycle_clears_latched_errors_and_setpoints(self) -> None:
        board = Board()
        board.serial.drive(1, FORWARD, 127)
        board.report_error(UartError.CRC)
        board.power_cycle()
        assert not board.serial.status
        assert not board.serial.uart_errors
        assert board.motors[0].speed == 0

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

    def test_invalid_calibration_write_is_rejected_at_once(self) -> None:
        board = Board()
        assert board.set_calibration(1, Calibration(5, 4, 9, 0)) is ResultCode.BAD_VALUE
        assert board.memory.busy_for == 0
