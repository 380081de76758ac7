from tests.devices.trex.simulator.ports import write
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.simulator.channels import Signal
from trex_gui.devices.trex.simulator.control import report
from trex_gui.devices.trex.simulator.firmware import Board
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
