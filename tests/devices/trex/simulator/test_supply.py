"""Both motors at one battery, and the board that resets when it sags."""

from typing import Any

import pytest

from tests.devices.trex.simulator.ports import SETTLED
from trex_gui.devices.trex.simulator.channels import Signal
from trex_gui.devices.trex.simulator.control import control, report
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import TrexLine
from trex_gui.devices.trex.simulator.motors import MotorDirection
from trex_gui.devices.trex.simulator.physics import CONSTANTS, DriverOutput, Machine

FORWARD, REVERSE, BRAKE = MotorDirection.FORWARD, MotorDirection.REVERSE, MotorDirection.BRAKE
TREX = CONSTANTS["trex"]
TICK = 0.0025
IDLE = DriverOutput()


def weaken(board: Board) -> None:
    """Give the board a battery that one stalled motor pulls below what it needs."""
    assert control(TrexLine([board]), "battery 8 0.5") == "ok battery 8 V, 0.5 ohm"


def is_on(board: Board) -> bool:
    return board.powered


def waits(board: Board) -> bool:
    return board.sticks.safe_start


def currents(board: Board, seconds: float) -> list[float]:
    """Return each reading of motor 1 in A, 80 a second."""
    seen = []
    for _ in range(round(seconds / 0.0125)):
        board.advance(0.0125)
        seen.append(board.physics[0].current)
    return seen


class TestMachine:
    def test_battery_without_load_has_full_voltage(self) -> None:
        machine = Machine("trex", 0.15, 0)
        machine.advance(TICK, [IDLE, DriverOutput(brake=1.0)])
        assert machine.volts == TREX.battery

    def test_supply_sags_with_each_starting_motor(self) -> None:
        volts = []
        for drives in (
            [IDLE, IDLE],
            [DriverOutput(1.0), IDLE],
            [DriverOutput(1.0), DriverOutput(-1.0)],
        ):
            machine = Machine("trex", 0.15, 0)
            machine.advance(TICK, drives)
            volts.append(machine.volts)
        # A divider of the battery's resistance and those of the motors that stand still.
        resistances = [0.4, 0.2]
        expected = [12 * each / (each + TREX.battery_resistance) for each in resistances]
        assert volts == pytest.approx([12.0, *expected])

    def test_starting_motor_slows_other_motor(self) -> None:
        machine = Machine("trex", 0.15, 0)
        for _ in range(800):
            machine.advance(TICK, [DriverOutput(1.0), IDLE])
        before = machine.motors[0].speed
        for _ in range(20):
            machine.advance(TICK, [DriverOutput(1.0), DriverOutput(1.0)])
        assert 0 < machine.motors[0].speed < before

    def test_running_motor_does_not_feed_battery(self) -> None:
        machine = Machine("trex", 0.15, 0)
        for _ in range(800):
            machine.advance(TICK, [DriverOutput(1.0), DriverOutput(1.0)])
        machine.advance(TICK, [DriverOutput(0.2), DriverOutput(0.2)])
        assert machine.volts == TREX.battery

    def test_half_duty_draws_quarter_of_battery_current(self) -> None:
        machine = Machine("trex", 0.15, 0)
        machine.advance(TICK, [DriverOutput(0.5), IDLE])
        drawn = (TREX.battery - machine.volts) / TREX.battery_resistance
        assert drawn == pytest.approx(0.25 * machine.volts / TREX.resistance)

    @pytest.mark.parametrize("model", CONSTANTS)
    def test_good_battery_survives_start_and_reversal_of_motors(self, model: str) -> None:
        board = Board(model)
        for direction in (FORWARD, REVERSE):
            for number in (1, 2):
                board.serial.drive(number, direction, 127)
            board.advance(1)
        assert board.powered
        assert board.counters["brown_outs"] == 0


class TestBoard:
    def test_stalled_motor_keeps_current_and_supply_constant(self) -> None:
        board = Board()
        board.physics[0].load = 100.0
        board.serial.drive(1, FORWARD, 127)
        seen = currents(board, 5)
        stall = TREX.battery / (TREX.resistance + TREX.battery_resistance)
        assert seen[1:] == [pytest.approx(stall, abs=0.35)] * (len(seen) - 1)
        assert report(board)["supply"] == pytest.approx(stall * TREX.resistance, abs=0.01)
        assert report(board)["motors"][0]["rpm"] == 0


class TestBrownOut:
    def test_weak_battery_resets_board_at_motor_start(self) -> None:
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
        counters: dict[str, Any] = report(board)["counters"]
        assert (counters["brown_outs"], counters["power_ups"]) == (1, 2)
        board.advance(1)
        assert board.counters["brown_outs"] == 1

    def test_board_restarts_after_brown_out_like_power_cycle(self) -> None:
        board = Board()
        weaken(board)
        board.advance(2)
        board.mode_jumper = "rc"
        board.set_parameter(0x07, 9)
        board.serial.drive(1, FORWARD, 127)
        board.advance(0.005)
        assert report(board)["mode"] == "R"
        assert report(board)["leds"] == {"red": "on", "green": "off"}  # the first of five flashes
        assert board.eeprom["serial_timeout"] == 0
        assert board.memory.busy_for == 0

    def test_brown_out_caused_by_stick_ends_in_safe_start(self) -> None:
        board = Board(mode="rc")
        weaken(board)
        board.advance(SETTLED)
        assert not waits(board)
        board.channels.signals[1] = Signal.pulses(2000)
        board.advance(0.1)
        assert board.counters["brown_outs"] == 1
        assert waits(board)
        board.advance(2)
        assert board.counters["brown_outs"] == 1
        assert waits(board)
        assert board.motors[0].direction is BRAKE
        board.channels.signals[1] = Signal.pulses(1500)
        board.advance(SETTLED)
        assert not waits(board)

    def test_brown_out_cuts_off_reply(self) -> None:
        board = Board()
        line = TrexLine([board])
        weaken(board)
        line.send(bytes.fromhex("81"))
        assert line.read(2, 1) == b"TR"
        board.serial.drive(1, FORWARD, 127)
        line.advance(1)
        assert len(line.receive()) < 5
        line.send(b"\x82")
        assert line.read(9, 1) == b"r"

    def test_empty_battery_keeps_board_off_until_charged(self) -> None:
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
        assert report(board)["supply"] == 12.0

    def test_switched_off_board_stays_off_when_battery_recovers(self) -> None:
        board = Board()
        board.machine.battery = 3.0
        board.advance(0.1)
        board.power_off()
        board.machine.battery = 12.0
        board.advance(1)
        assert not is_on(board)
        board.power_on()
        assert is_on(board)
