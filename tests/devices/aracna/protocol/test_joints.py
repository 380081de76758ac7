"""Units and joints, compared with figures from Robotis and the robot's authors."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support.matrix import examples
from trex_gui.devices.aracna.protocol import joints
from trex_gui.devices.aracna.protocol.joints import Limits


def test_every_position_survives_conversion_to_degrees_and_back() -> None:
    for position in range(1024):
        assert joints.position(joints.degrees(position)) == position
    assert joints.degrees(1023) == pytest.approx(300)
    assert joints.degrees(512) == pytest.approx(150, abs=0.2)


def test_speed_0_means_maximum_speed() -> None:
    assert joints.degrees_per_second(0) is None
    assert joints.travel_seconds(1023, 0) == joints.travel_seconds(1023, 1023)
    assert joints.degrees_per_second(100) == pytest.approx(66.9)


@pytest.mark.parametrize(
    ("distance", "speed", "max_speed", "seconds"),
    [(1023, 1023, 530, 0.85), (1023, 100, 870, 4.5), (1023, 1, 870, 450)],
)
def test_travel_takes_documented_time(
    distance: int, speed: int, max_speed: int, seconds: float
) -> None:
    assert joints.travel_seconds(distance, speed, max_speed) == pytest.approx(seconds, rel=0.01)


@examples(40)
@given(distance=st.integers(-1023, 1023), seconds=st.floats(0.05, 60))
def test_speed_for_time_is_lowest_sufficient_speed(distance: int, seconds: float) -> None:
    speed = joints.speed_for(distance, seconds)
    assert 1 <= speed <= 1023
    unlimited = 10_000
    if speed < 1023:
        assert joints.travel_seconds(distance, speed, unlimited) <= seconds * (1 + 1e-6)
    if speed > 1:
        assert joints.travel_seconds(distance, speed - 1, unlimited) > seconds


def test_speed_for_time_matches_authors_formula() -> None:
    assert joints.speed_for(512, 1.0) == pytest.approx(438.6 * 512 / 1000, abs=1)
    assert joints.speed_for(512, 1.0) == pytest.approx(435.4 * 512 / 1000, rel=0.01)


@examples(40)
@given(st.integers(-2000, 3000), st.integers(0, 1023), st.integers(0, 1023))
def test_clamp_changes_only_values_outside_limits(value: int, one: int, two: int) -> None:
    limits = Limits(min(one, two), max(one, two))
    clamped = limits.clamp(value)
    assert limits.allows(clamped)
    assert (clamped == value) == limits.allows(value)


@pytest.mark.parametrize(("low", "high"), [(-1, 5), (6, 5), (0, 1024)])
def test_invalid_limits_are_rejected(low: int, high: int) -> None:
    with pytest.raises(ValueError, match="the lower one first"):
        Limits(low, high)
