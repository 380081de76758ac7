"""One motor with what it turns: inrush, load, stall, coasting, braking, its sensor."""

from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from trex_gui.devices.trex.simulator.physics import CONSTANTS, Constants, MotorPhysics

TREX = CONSTANTS["trex"]
TICK = 0.0025
FULL = TREX.battery
models = pytest.mark.parametrize("constants", CONSTANTS.values(), ids=CONSTANTS)


def run(physics: MotorPhysics, seconds: float, volts: float, brake: float = 0.0) -> None:
    for _ in range(round(seconds / TICK)):
        physics.advance(TICK, volts, brake)


def reading(physics: MotorPhysics, volts: float, brake: float = 0.0) -> float:
    """Return the current in A that the sensor shows over the next 80th of a second."""
    physics.measure()
    run(physics, 0.0125, volts, brake)
    physics.measure()
    return physics.current


@pytest.fixture
def physics() -> MotorPhysics:
    return MotorPhysics(TREX, 0.15, seed=0)


def test_motor_at_rest_draws_no_current(physics: MotorPhysics) -> None:
    run(physics, 0.1, 0.0)
    physics.measure()
    assert (physics.reading, physics.speed) == (0, 0.0)


@models
def test_start_current_falls_from_stall_to_free_current(
    constants: Constants,
) -> None:
    physics = MotorPhysics(constants, 0.01, seed=0)
    currents = []
    for _ in range(round(1 / TICK)):
        currents.append(physics.current_at(constants.battery))
        physics.advance(TICK, constants.battery, 0.0)
    assert currents[0] == pytest.approx(constants.stall)
    assert all(after <= before for before, after in pairwise(currents))
    assert currents[-1] == pytest.approx(constants.free, rel=0.02)


def test_sensor_shows_inrush_current(physics: MotorPhysics) -> None:
    inrush = reading(physics, FULL)
    run(physics, 2.0, FULL)
    assert inrush > 0.8 * TREX.stall
    assert reading(physics, FULL) == pytest.approx(TREX.free, abs=0.3)


def test_reversal_draws_more_current_than_start(physics: MotorPhysics) -> None:
    start = physics.current_at(FULL)
    run(physics, 2.0, FULL)
    reversal = physics.current_at(-FULL)
    assert reversal < 0
    assert -reversal == pytest.approx(2 * start - TREX.free, rel=0.02)
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


@pytest.mark.parametrize("load", [TREX.stall, 31.0, 1000.0])
@pytest.mark.parametrize("share", [0.25, 0.5, 1.0, -1.0])
def test_load_of_stall_current_or_more_stalls_motor(
    physics: MotorPhysics, load: float, share: float
) -> None:
    physics.load = load
    run(physics, 3.0, share * FULL)
    assert physics.speed == 0
    assert reading(physics, share * FULL) == pytest.approx(abs(share) * TREX.stall, abs=0.4)


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
    def left(brake: float) -> float:
        physics = MotorPhysics(TREX, 0.15, seed=0)
        run(physics, 2.0, FULL)
        run(physics, 0.1, 0.0, brake)
        return physics.speed

    top = FULL / TREX.back_emf
    assert 0 <= left(1.0) < left(0.5) < left(0.0) < top


def test_coasting_motor_is_stopped_by_friction(physics: MotorPhysics) -> None:
    run(physics, 2.0, FULL)
    top = physics.speed
    run(physics, 0.2, 0.0)
    assert 0.5 * top < physics.speed < top
    run(physics, 20.0, 0.0)
    assert physics.speed == 0


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


def test_rpm_is_converted_from_speed(physics: MotorPhysics) -> None:
    run(physics, 2.0, FULL)
    assert physics.rpm == pytest.approx(15_000, rel=0.06)
    assert physics.rpm == pytest.approx(physics.speed * 9.5493, rel=1e-4)


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
