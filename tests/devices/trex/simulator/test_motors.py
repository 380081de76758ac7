"""Speed of a motor: acceleration, brake duration and current limit."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support.matrix import examples
from trex_gui.devices.trex.simulator.motors import Motor, MotorDirection, MotorSettings

BRAKE, REVERSE, FORWARD = MotorDirection.BRAKE, MotorDirection.REVERSE, MotorDirection.FORWARD


def update(motor: Motor, settings: MotorSettings, count: int, current: int = 0) -> list[int]:
    """Update a motor several times. Return the speed after each update."""
    speeds = []
    for _ in range(count):
        motor.update(settings, current)
        speeds.append(motor.speed)
    return speeds


def test_braked_motor_reverses_at_once_after_brake_duration() -> None:
    motor = Motor()
    settings = MotorSettings(brake_duration=5)
    motor.set(FORWARD, 100)
    motor.accelerate(BRAKE, 127)
    update(motor, settings, 5)
    motor.accelerate(REVERSE, 40)
    assert update(motor, settings, 1) == [40]


def test_cancelled_reversal_resumes_old_direction() -> None:
    motor = Motor()
    settings = MotorSettings(acceleration=100, brake_duration=50)
    motor.set(FORWARD, 100)
    motor.accelerate(REVERSE, 60)
    update(motor, settings, 2)
    motor.accelerate(FORWARD, 60)
    assert update(motor, settings, 2) == [10, 20]
    assert motor.direction is FORWARD


def test_speed_falls_in_proportion_to_excess_current() -> None:
    motor = Motor()
    motor.accelerate(FORWARD, 100)
    settings = MotorSettings(current_limit=10, current_limit_p=8)  # 20 counts
    assert not motor.update(settings, 20)
    assert motor.speed == 100
    assert motor.update(settings, 30)  # ceil(8 * 10 / 16) = 5
    assert motor.speed == 95
    assert update(motor, settings, 100, current=30)[-1] == 0


def test_zero_gain_turns_motor_off_over_current_limit() -> None:
    motor = Motor()
    settings = MotorSettings(current_limit=1)
    motor.set(FORWARD, 100)
    assert motor.update(settings, 3)
    assert motor.speed == 0
    assert not motor.update(settings, 2)
    assert motor.speed == 100


@pytest.mark.parametrize(
    ("direction", "speed", "limit", "gain", "current", "output"),
    [(FORWARD, 100, 0, 127, 255, 100), (BRAKE, 127, 1, 5, 255, 127), (FORWARD, 10, 1, 1, 3, 9)],
    ids=["no limit", "brake command", "lower setpoint"],
)
def test_limiter_spares_brakes_and_starts_at_the_setpoint(
    direction: MotorDirection, speed: int, limit: int, gain: int, current: int, output: int
) -> None:
    motor = Motor()
    motor.set(FORWARD, 100)
    motor.accelerate(direction, speed)
    is_over = motor.update(MotorSettings(current_limit=limit, current_limit_p=gain), current)
    assert (motor.direction, motor.speed, is_over) == (direction, output, limit > 0)


@examples(30)
@given(
    steps=st.lists(
        st.tuples(
            st.booleans(),
            st.sampled_from(MotorDirection),
            st.integers(0, 127),
            st.integers(0, 127),
            st.integers(0, 255),
        ),
        max_size=20,
    )
)
def test_speed_stays_in_its_range(
    steps: list[tuple[bool, MotorDirection, int, int, int]],
) -> None:
    motor = Motor()
    for sets, direction, speed, parameter, current in steps:
        (motor.set if sets else motor.accelerate)(direction, speed)
        motor.update(MotorSettings(parameter, parameter, parameter, parameter), current)
        assert 0 <= motor.speed <= 127
