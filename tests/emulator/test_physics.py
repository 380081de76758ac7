import pytest

from trex_gui.emulator.physics import MOTORS, MotorPhysics

TREX = MOTORS["trex"]


def run(physics: MotorPhysics, seconds: float, voltage: float, brake: float = 0.0) -> None:
    for _ in range(round(seconds / 0.0025)):
        physics.advance(0.0025, voltage, brake)


@pytest.fixture
def physics() -> MotorPhysics:
    return MotorPhysics(TREX, 0.15, seed=0)


def test_a_motor_at_rest_draws_nothing(physics: MotorPhysics) -> None:
    run(physics, 0.1, 0.0)
    physics.measure()
    assert physics.reading == 0


def test_starting_takes_more_current_than_running(physics: MotorPhysics) -> None:
    run(physics, 0.0125, 1.0)
    physics.measure()
    inrush = physics.current
    run(physics, 2.0, 1.0)
    physics.measure()
    run(physics, 0.0125, 1.0)
    physics.measure()
    assert inrush > 0.8 * TREX.stall
    assert physics.current == pytest.approx(TREX.free, abs=0.3)


@pytest.mark.parametrize("load", [1.0, 5.0, 12.0])
@pytest.mark.parametrize("voltage", [0.5, 1.0, -1.0])
def test_the_current_follows_load_and_speed(
    physics: MotorPhysics, load: float, voltage: float
) -> None:
    physics.load = load
    run(physics, 3.0, voltage)
    physics.measure()
    run(physics, 0.0125, voltage)
    physics.measure()
    assert physics.current == pytest.approx(load * abs(voltage), abs=0.3)
    assert (physics.speed > 0) == (voltage > 0)


@pytest.mark.parametrize("load", [30.0, 1000.0])
def test_a_load_above_the_stall_current_stalls(physics: MotorPhysics, load: float) -> None:
    physics.load = load
    run(physics, 3.0, 1.0)
    physics.measure()
    assert physics.current == pytest.approx(TREX.stall, rel=0.05)
    assert abs(physics.speed) < 0.05


def test_braking_stops_sooner_than_coasting() -> None:
    def left(brake: float) -> float:
        physics = MotorPhysics(TREX, 0.15, seed=0)
        run(physics, 2.0, 1.0)
        run(physics, 0.2, 0.0, brake)
        return physics.speed

    assert 0 <= left(1.0) < left(0.5) < left(0.0) < 1


def test_braking_passes_the_sensor_by(physics: MotorPhysics) -> None:
    run(physics, 2.0, 1.0)
    physics.measure()
    run(physics, 0.0125, 0.0, 1.0)
    physics.measure()
    assert physics.reading == 0


def test_a_driver_with_a_fault_drives_nothing(physics: MotorPhysics) -> None:
    physics.fault = True
    run(physics, 0.5, 1.0)
    physics.measure()
    assert (physics.reading, physics.speed) == (0, 0.0)


def test_a_reading_is_one_byte(physics: MotorPhysics) -> None:
    physics.forced = 1000.0
    physics.measure()
    assert physics.reading == 255
    physics.forced = 8.25
    physics.measure()
    assert physics.reading == 55
    physics.forced = None
    physics.measure()
    assert physics.reading == 0


def test_the_same_seed_gives_the_same_noise() -> None:
    def readings(seed: int) -> list[int]:
        physics = MotorPhysics(TREX, 0.15, seed)
        result = []
        for _ in range(50):
            run(physics, 0.0125, 0.7)
            physics.measure()
            result.append(physics.reading)
        return result

    assert readings(1) == readings(1) != readings(2)
