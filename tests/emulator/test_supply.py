"""Both motors at one battery, and the board that resets when it sags."""

from itertools import pairwise
from typing import Any

import pytest

from tests.emulator.ports import SETTLED, a_board, ask
from trex_gui.emulator.control import control
from trex_gui.emulator.firmware import Board
from trex_gui.emulator.line import Line
from trex_gui.emulator.motors import Direction
from trex_gui.emulator.physics import CONSTANTS, Drive, Machine
from trex_gui.emulator.signals import Signal
from trex_gui.emulator.uart import SerialPort

FORWARD, REVERSE, BRAKE = Direction.FORWARD, Direction.REVERSE, Direction.BRAKE
TREX = CONSTANTS["trex"]
TICK = 0.0025
IDLE = Drive()


def weaken(board: Board) -> None:
    """Give the board a battery that one stalled motor pulls below what it needs."""
    assert control(Line([board]), "battery 8 0.5") == "ok battery 8 V, 0.5 ohm"


def is_on(board: Board) -> bool:
    return board.powered


def waits(board: Board) -> bool:
    return board.safe_start


def currents(board: Board, seconds: float) -> list[float]:
    """Return each reading of motor 1 in A, 80 a second."""
    seen = []
    for _ in range(round(seconds / 0.0125)):
        board.advance(0.0125)
        seen.append(board.physics[0].current)
    return seen


class TestMachine:
    def test_without_current_the_battery_has_its_voltage(self) -> None:
        machine = Machine("trex", 0.15, 0)
        machine.advance(TICK, [IDLE, Drive(brake=1.0)])
        assert machine.volts == TREX.battery

    def test_the_supply_sags_with_every_motor_that_starts(self) -> None:
        volts = []
        for drives in ([IDLE, IDLE], [Drive(1.0), IDLE], [Drive(1.0), Drive(-1.0)]):
            machine = Machine("trex", 0.15, 0)
            machine.advance(TICK, drives)
            volts.append(machine.volts)
        # A divider of the battery's resistance and those of the motors that stand still.
        resistances = [0.4, 0.2]
        expected = [12 * each / (each + TREX.battery_resistance) for each in resistances]
        assert volts == pytest.approx([12.0, *expected])

    def test_a_motor_that_starts_slows_the_other_one(self) -> None:
        machine = Machine("trex", 0.15, 0)
        for _ in range(800):
            machine.advance(TICK, [Drive(1.0), IDLE])
        before = machine.motors[0].speed
        for _ in range(20):
            machine.advance(TICK, [Drive(1.0), Drive(1.0)])
        assert 0 < machine.motors[0].speed < before

    def test_a_running_motor_gives_nothing_back(self) -> None:
        machine = Machine("trex", 0.15, 0)
        for _ in range(800):
            machine.advance(TICK, [Drive(1.0), Drive(1.0)])
        machine.advance(TICK, [Drive(0.2), Drive(0.2)])
        assert machine.volts == TREX.battery

    def test_half_the_duty_takes_a_quarter_of_the_current_from_the_battery(self) -> None:
        machine = Machine("trex", 0.15, 0)
        machine.advance(TICK, [Drive(0.5), IDLE])
        drawn = (TREX.battery - machine.volts) / TREX.battery_resistance
        assert drawn == pytest.approx(0.25 * machine.volts / TREX.resistance)

    def test_a_driver_with_a_fault_takes_nothing(self) -> None:
        machine = Machine("trex", 0.15, 0)
        machine.motors[0].fault = True
        machine.advance(TICK, [Drive(1.0), IDLE])
        assert machine.volts == TREX.battery

    @pytest.mark.parametrize("model", CONSTANTS)
    def test_a_good_battery_bears_both_motors_starting_and_reversing(self, model: str) -> None:
        board = Board(model)
        for direction in (FORWARD, REVERSE):
            for number in (1, 2):
                board.serial.drive(number, direction, 127)
            board.advance(1)
        assert board.powered
        assert board.counters["brown_outs"] == 0


class TestBoard:
    def test_a_start_at_full_speed_peaks_near_stall_and_falls(self) -> None:
        board = Board()
        board.serial.drive(1, FORWARD, 127)
        seen = currents(board, 0.5)
        stall = TREX.battery / (TREX.resistance + TREX.battery_resistance)
        assert max(seen) == seen[0]
        assert 0.75 * stall < seen[0] <= stall
        assert all(after <= before + 0.31 for before, after in pairwise(seen))
        assert seen[-1] == pytest.approx(TREX.free, abs=0.35)

    def test_a_reversal_peaks_higher_than_a_start(self) -> None:
        board = Board()
        board.serial.drive(1, FORWARD, 127)
        start = max(currents(board, 1))
        board.serial.drive(1, REVERSE, 127)
        assert max(currents(board, 1)) > 1.4 * start

    def test_a_ramp_spares_the_battery(self) -> None:
        board = a_board(motor1_acceleration=20)
        board.serial.drive(1, FORWARD, 127, accelerate=True)
        assert max(currents(board, 1)) < 0.5 * TREX.stall

    def test_a_stalled_motor_holds_its_current_and_its_voltage(self) -> None:
        board = Board()
        board.physics[0].load = 100.0
        board.serial.drive(1, FORWARD, 127)
        seen = currents(board, 5)
        stall = TREX.battery / (TREX.resistance + TREX.battery_resistance)
        assert seen[1:] == [pytest.approx(stall, abs=0.35)] * (len(seen) - 1)
        assert board.show()["supply"] == pytest.approx(stall * TREX.resistance, abs=0.01)
        assert board.show()["motors"][0]["rpm"] == 0

    def test_the_same_current_is_asked_for_in_counts(self) -> None:
        board = a_board(model="trexjr")
        board.physics[0].load = 3.0
        board.serial.drive(1, FORWARD, 127)
        board.advance(3)
        assert int(ask(SerialPort(board), "8D"), 16) == pytest.approx(3.0 / 0.04, abs=2)


class TestBrownOut:
    def test_a_weak_battery_resets_the_board_that_starts_a_motor(self) -> None:
        board = Board()
        weaken(board)
        board.advance(0.1)
        assert is_on(board)
        board.serial.drive(1, FORWARD, 127)
        board.advance(TICK)
        assert not is_on(board)
        board.advance(TICK)
        assert is_on(board)
        assert board.motors[0].speed == 0
        counters: dict[str, Any] = board.show()["counters"]
        assert (counters["brown_outs"], counters["power_ups"]) == (1, 2)
        board.advance(1)
        assert board.counters["brown_outs"] == 1

    def test_it_starts_as_from_a_power_cycle(self) -> None:
        board = Board()
        weaken(board)
        board.advance(2)
        board.mode_jumper = "rc"
        board.set_parameter(0x07, 9)
        board.serial.drive(1, FORWARD, 127)
        board.advance(0.005)
        assert board.show()["mode"] == "R"
        assert board.show()["leds"] == {"red": "on", "green": "off"}  # the first of five flashes
        assert board.eeprom["serial_timeout"] == 0
        assert board.memory.busy_for == 0

    def test_sticks_that_pull_the_battery_down_end_in_safe_start(self) -> None:
        board = Board(mode="rc")
        weaken(board)
        board.advance(SETTLED)
        assert not waits(board)
        board.connect(1, Signal.pulses(2000))
        board.advance(0.1)
        assert board.counters["brown_outs"] == 1
        assert waits(board)
        board.advance(2)
        assert board.counters["brown_outs"] == 1
        assert waits(board)
        assert board.motors[0].direction is BRAKE
        board.connect(1, Signal.pulses(1500))
        board.advance(SETTLED)
        assert not waits(board)

    def test_an_answer_that_was_under_way_is_cut(self) -> None:
        board = Board()
        line = Line([board])
        weaken(board)
        line.send(bytes.fromhex("81"))
        assert line.read(2, 1) == b"TR"
        board.serial.drive(1, FORWARD, 127)
        line.advance(1)
        assert len(line.receive()) < 5
        line.send(b"\x82")
        assert line.read(9, 1) == b"r"

    def test_an_empty_battery_keeps_it_off_until_it_is_charged(self) -> None:
        board = Board()
        board.machine.battery = 3.0
        board.advance(1)
        assert not is_on(board)
        assert board.counters["brown_outs"] == 1
        board.power_on()
        assert not is_on(board)
        board.machine.battery = 12.0
        board.advance(0.01)
        assert is_on(board)
        assert board.show()["supply"] == 12.0

    def test_one_that_was_switched_off_stays_off_when_the_battery_recovers(self) -> None:
        board = Board()
        board.machine.battery = 3.0
        board.advance(0.1)
        board.power_off()
        board.machine.battery = 12.0
        board.advance(1)
        assert not is_on(board)
        board.power_on()
        assert is_on(board)
