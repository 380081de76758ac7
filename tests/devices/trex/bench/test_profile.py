"""Profiles of bench tests."""

import math
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from trex_gui.devices.trex.bench.run import MAX_SECONDS, MIN_SECONDS, Profile, Shape

SECONDS = st.floats(MIN_SECONDS, MAX_SECONDS)
PROFILES = st.builds(
    Profile,
    shape=st.sampled_from(Shape),
    speed=st.integers(-127, 127).filter(bool),
    duration=SECONDS,
    period=SECONDS,
)


@given(profile=PROFILES, fraction=st.floats(-1, 2))
def test_profile_never_exceeds_its_speed(profile: Profile, fraction: float) -> None:
    assert abs(profile.speed_at(profile.duration * fraction)) <= abs(profile.speed)


@given(profile=PROFILES)
def test_profile_is_zero_before_start_and_after_end(profile: Profile) -> None:
    assert profile.speed_at(-0.001) == 0
    assert profile.speed_at(profile.duration) == 0
    assert profile.speed_at(profile.duration + 1) == 0


@given(profile=PROFILES, fraction=st.floats(0, 0.999))
def test_negative_speed_mirrors_the_profile(profile: Profile, fraction: float) -> None:
    time = profile.duration * fraction
    assert replace(profile, speed=-profile.speed).speed_at(time) == -profile.speed_at(time)


def test_step_runs_at_full_speed_and_ignores_its_period() -> None:
    profile = Profile(shape=Shape.STEP, speed=90, duration=2, period=0)
    assert [profile.speed_at(time) for time in (0, 0.01, 1, 1.99)] == [90] * 4


def test_ramp_rises_for_its_period_and_then_holds() -> None:
    profile = Profile(shape=Shape.RAMP, speed=-100, duration=4, period=2)
    assert [profile.speed_at(time) for time in (0, 0.5, 1, 2, 3.9)] == [0, -25, -50, -100, -100]


def test_reversal_changes_direction_every_half_period() -> None:
    profile = Profile(shape=Shape.REVERSE, speed=50, duration=3, period=2)
    assert [profile.speed_at(time) for time in (0, 0.99, 1, 1.99, 2.5)] == [50, 50, -50, -50, 50]


def test_sine_starts_forward_and_passes_through_zero() -> None:
    profile = Profile(shape=Shape.SINE, speed=100, duration=4, period=4)
    assert [profile.speed_at(time) for time in (0, 1, 2, 3)] == [0, 100, 0, -100]
    assert profile.speed_at(0.5) == round(100 * math.sin(math.pi / 4))


@given(profile=PROFILES, ceiling=st.integers(1, 127))
def test_ceiling_limits_only_the_speed(profile: Profile, ceiling: int) -> None:
    limited = profile.limited(ceiling)
    assert abs(limited.speed) == min(abs(profile.speed), ceiling)
    assert (limited.speed > 0) is (profile.speed > 0)
    assert (limited.shape, limited.duration) == (profile.shape, profile.duration)


@given(profile=PROFILES)
def test_drawn_course_matches_the_profile(profile: Profile) -> None:
    course = profile.course(100)
    times = [time for time, _ in course]
    assert times == sorted(times)
    assert course[0] == (0.0, 0)
    assert course[-1] == (profile.duration, 0)
    assert all(speed == profile.speed_at(time) for time, speed in course[1:-2])


@pytest.mark.parametrize(
    ("values", "words"),
    [
        ({"speed": 0}, "not 0"),
        ({"speed": 128}, "127"),
        ({"speed": -128}, "127"),
        ({"duration": 0.1}, "must last 0.2 to 120 s, not 0.1 s"),
        ({"duration": 121}, "not 121 s"),
        ({"duration": math.nan}, "not nan s"),
        ({"shape": Shape.SINE, "period": 0.1}, "period of a bench test must be 0.2 to 120 s"),
    ],
)
def test_invalid_profile_is_rejected_with_its_limits(values: dict[str, float], words: str) -> None:
    with pytest.raises(ValueError, match=words):
        Profile(**values)  # type: ignore[arg-type]  # the values have several types
