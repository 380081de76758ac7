"""Physics of motors and battery: start, stall, coasting, braking, current and brown-out."""

from itertools import pairwise
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.devices.trex.simulator.ports import SETTLED
from tests.support.matrix import examples
from trex_gui.devices.trex.simulator.channels import Signal
from trex_gui.devices.trex.simulator.control import control, report
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import SimulatedBoards
from trex_gui.devices.trex.simulator.motors import MotorDirection
from trex_gui.devices.trex.simulator.physics import (
    CONSTANTS,
    Constants,
    DriverOutput,
    Machine,
    MotorPhysics,
)

TREX = CONSTANTS["trex"]
TICK = 0.0025
FULL = TREX.battery
models = pytest.mark.parametrize("constants", CONSTANTS.values(), ids=CONSTANTS)


def run(physics: MotorPhysics, seconds: float, volts: float, brake: float = 0.0) -> None:
    for _ in range(round(seconds / TICK)):
        physics.advance(TICK, volts, brake)


def reading(physics: MotorPhysics, volts: float, brake: float = 0.0) -> float:
    """Return the measured current in A over the next 80th of a second."""
    physics.measure()
    run(physics, 0.0125, volts, brake)
    physics.measure()
    return physics.current


@pytest.fixture
def physics() -> MotorPhysics:
    return MotorPhysics(TREX, 0.15, seed=0)


@models
def test_start_current_falls_from_stall_to_free_current(constants: Constants) -> None:
    physics = MotorPhysics(constants, 0.01, seed=0)
    currents = []
    for _ in range(round(1 / TICK)):
        currents.append(physics.current_at(constants.battery))
        physics.advance(TICK, constants.battery, 0.0)
    assert currents[0] == pytest.approx(constants.stall_current)
    assert all(after <= before for before, after in pairwise(currents))
    assert currents[-1] == pytest.approx(constants.free_current, rel=0.02)


def test_sensor_shows_inrush_current(physics: MotorPhysics) -> None:
    inrush = reading(physics, FULL)
    run(physics, 2.0, FULL)
    assert inrush > 0.8 * TREX.stall_current
    assert reading(physics, FULL) == pytest.approx(TREX.free_current, abs=0.3)


def test_reversal_draws_more_current_than_start(physics: MotorPhysics) -> None:
    start = physics.current_at(FULL)
    run(physics, 2.0, FULL)
    reversal = physics.current_at(-FULL)
    assert reversal < 0
    assert -reversal == pytest.approx(2 * start - TREX.free_current, rel=0.02)
    run(physics, 2.0, -FULL)
    assert physics.speed < 0


@pytest.mark.parametrize("load", [1.5, 5.0, 12.0])
@pytest.mark.parametrize("volts", [FULL / 2, FULL, -FULL])
def test_current_follows_load_at_any_speed(
    physics: MotorPhysics, load: float, volts: float
) -> None:
    physics.load = load
    run(physics, 3.0, volts)
    assert reading(physics, volts) == pytest.approx(load, abs=0.3)
    assert (physics.speed > 0) == (volts > 0)
    assert abs(physics.speed * TREX.back_emf) == pytest.approx(abs(volts) - 0.4 * load, rel=0.02)


@pytest.mark.parametrize("load", [TREX.stall_current, 31.0, 1000.0])
@pytest.mark.parametrize("share", [0.25, 0.5, 1.0, -1.0])
def test_load_of_stall_current_or_more_stalls_motor(
    physics: MotorPhysics, load: float, share: float
) -> None:
    physics.load = load
    run(physics, 3.0, share * FULL)
    assert physics.speed == 0
    assert reading(physics, share * FULL) == pytest.approx(abs(share) * TREX.stall_current, abs=0.4)


def test_friction_stops_motor_without_reversing_it(physics: MotorPhysics) -> None:
    run(physics, 1.0, FULL)
    physics.load = 25.0
    speeds = []
    for _ in range(400):
        physics.advance(TICK, 0.0, 0.0)
        speeds.append(physics.speed)
    assert speeds == sorted(speeds, reverse=True)
    assert speeds[-1] == 0


def test_braking_slows_motor_faster_than_coasting() -> None:
    def speed_after_100_ms(brake: float) -> float:
        physics = MotorPhysics(TREX, 0.15, seed=0)
        run(physics, 2.0, FULL)
        run(physics, 0.1, 0.0, brake)
        return physics.speed

    top = FULL / TREX.back_emf
    braked, half_braked, coasting = map(speed_after_100_ms, (1.0, 0.5, 0.0))
    assert 0 <= braked < half_braked < coasting < top


@pytest.mark.parametrize("brake", [0.0, 0.3, 1.0])
def test_sensor_reads_zero_while_braking_or_coasting(physics: MotorPhysics, brake: float) -> None:
    run(physics, 2.0, FULL)
    assert reading(physics, 0.0, brake) == 0
    assert physics.speed > 0 or brake == 1


def test_voltage_below_back_emf_draws_no_current(physics: MotorPhysics) -> None:
    run(physics, 2.0, FULL)
    before = physics.speed
    assert physics.current_at(FULL / 4) == 0
    assert reading(physics, FULL / 4) == 0
    assert 0 < physics.speed < before


def test_faulty_driver_neither_drives_nor_brakes(physics: MotorPhysics) -> None:
    physics.fault = True
    run(physics, 0.5, FULL)
    physics.measure()
    assert (physics.reading, physics.speed) == (0, 0.0)
    speeds = []
    for brake in (0.0, 1.0):
        physics.fault = False
        run(physics, 2.0, FULL)
        physics.fault = True
        run(physics, 0.1, 0.0, brake)
        speeds.append(physics.speed)
    assert speeds[0] == pytest.approx(speeds[1])


@examples(40)
@given(
    steps=st.lists(
        st.tuples(st.floats(-24, 24), st.floats(0, 1), st.floats(0, 1000), st.booleans()),
        max_size=60,
    ),
    model=st.sampled_from(sorted(CONSTANTS)),
)
def test_speed_and_current_stay_within_physical_limits(
    steps: list[tuple[float, float, float, bool]], model: str
) -> None:
    constants = CONSTANTS[model]
    physics = MotorPhysics(constants, 0.15, seed=0)
    for volts, brake, load, fault in steps:
        physics.load, physics.fault = load, fault
        physics.advance(TICK, volts, brake)
        physics.measure()
        assert abs(physics.speed) * constants.back_emf <= 24.001
        assert abs(physics.current_at(24)) <= 48.001 / constants.resistance
        assert 0 <= physics.reading <= 255


# --- Two motors on one battery --------------------------------------------------------


FORWARD, REVERSE, BRAKE = MotorDirection.FORWARD, MotorDirection.REVERSE, MotorDirection.BRAKE
IDLE = DriverOutput()


def weaken(board: Board) -> None:
    """Set a battery that cannot supply a stalled motor."""
    assert control(SimulatedBoards([board]), "battery 8 0.5") == "ok battery 8 V, 0.5 ohm"


# Functions, because mypy assumes that an asserted attribute does not change.
def is_powered(board: Board) -> bool:
    return board.powered


def has_safe_start(board: Board) -> bool:
    return board.sticks.safe_start


class TestMachine:
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
        # Divider of the resistances of battery and stationary motors.
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
        assert is_powered(board)
        assert board.counters["brown_outs"] == 0

    def test_stalled_motor_keeps_current_and_supply_constant(self) -> None:
        board = Board()
        board.physics[0].load = 100.0
        board.serial.drive(1, FORWARD, 127)
        board.advance(0.0125)
        stall = TREX.battery / (TREX.resistance + TREX.battery_resistance)
        for _ in range(400):
            board.advance(0.0125)  # the time between two measurements of the current
            assert board.physics[0].current == pytest.approx(stall, abs=0.35)
        assert report(board)["supply"] == pytest.approx(stall * TREX.resistance, abs=0.01)
        assert report(board)["motors"][0]["rpm"] == 0


class TestBrownOut:
    def test_weak_battery_resets_board_at_motor_start(self) -> None:
        board = Board()
        weaken(board)
        board.advance(0.1)
        assert is_powered(board)
        board.serial.drive(1, FORWARD, 127)
        board.advance(TICK)
        assert not is_powered(board)
        board.advance(TICK)
        assert is_powered(board)
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
        assert not has_safe_start(board)
        board.channels.signals[1] = Signal.pulses(2000)
        board.advance(0.1)
        assert board.counters["brown_outs"] == 1
        assert has_safe_start(board)
        board.advance(2)
        assert board.counters["brown_outs"] == 1
        assert has_safe_start(board)
        assert board.motors[0].direction is BRAKE
        board.channels.signals[1] = Signal.pulses(1500)
        board.advance(SETTLED)
        assert not has_safe_start(board)

    def test_brown_out_cuts_off_reply(self) -> None:
        board = Board()
        line = SimulatedBoards([board])
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
        assert not is_powered(board)
        assert board.counters["brown_outs"] == 1
        board.power_on()
        assert not is_powered(board)
        board.machine.battery = 12.0
        board.advance(0.01)
        assert is_powered(board)
        assert report(board)["supply"] == 12.0

    def test_switched_off_board_stays_off_when_battery_recovers(self) -> None:
        board = Board()
        board.machine.battery = 3.0
        board.advance(0.1)
        board.power_off()
        board.machine.battery = 12.0
        board.advance(1)
        assert not is_powered(board)
        board.power_on()
        assert is_powered(board)
