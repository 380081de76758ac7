"""Mixing of forward and turn to two speeds."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from trex_gui.devices.trex.model.momentary_drive import (
    TURN_WHILE_DRIVING,
    Heading,
    grown,
    keys_setpoint,
    mix,
)
from trex_gui.devices.trex.simulator.channel_control import motor_values

SHARE = st.floats(-1, 1, allow_nan=False)
SPEEDS = st.tuples(st.integers(-127, 127), st.integers(-127, 127))


@pytest.mark.parametrize(
    ("forward", "turn", "speeds"),
    [
        (0, 0, (0, 0)),
        (1, 0, (127, 127)),
        (0, 1, (127, -127)),
        (0.5, 0.5, (127, 0)),
        (1, 0.5, (127, 42)),
        (-0.5, 0.25, (-32, -95)),
    ],
)
def test_forward_and_turn_are_mixed_into_two_speeds(
    forward: float, turn: float, speeds: tuple[int, int]
) -> None:
    assert mix(forward, turn) == speeds


@given(forward=SHARE, turn=SHARE, ceiling=st.integers(1, 127))
def test_mixed_speeds_stay_within_the_ceiling(forward: float, turn: float, ceiling: int) -> None:
    assert all(abs(speed) <= ceiling for speed in mix(forward, turn, ceiling))


@given(forward=SHARE, turn=SHARE)
def test_mixed_speeds_match_the_board_direction(forward: float, turn: float) -> None:
    by_pad = mix(forward, turn)
    channels = (round(turn * 127), round(forward * 127), 0, 0, 0)
    by_stick = motor_values(channels, mix=True, flip=False, joint=False)
    for pad, stick in zip(by_pad, by_stick, strict=True):
        assert abs(pad) <= abs(stick) + 1
        assert pad * stick >= 0 or abs(pad) <= 1


@given(forward=SHARE, turn=SHARE)
def test_mixing_keeps_the_speed_ratio_when_limited(forward: float, turn: float) -> None:
    left, right = mix(forward, turn)
    # The speeds have the ratio of the sums, except for rounding.
    assert abs(left * (forward - turn) - right * (forward + turn)) <= 2


@given(speeds=SPEEDS, goal=SPEEDS, most=st.integers(1, 127))
def test_speeds_grow_by_steps_and_fall_at_once(
    speeds: tuple[int, int], goal: tuple[int, int], most: int
) -> None:
    for speed, aim, then in zip(speeds, goal, grown(speeds, goal, most), strict=True):
        same_way = speed * aim > 0
        assert abs(then) <= abs(aim) + 1e-9, "no speed beyond the goal"
        assert then * aim >= 0, "nor the other way"
        assert abs(then) <= (abs(speed) if same_way else 0) + most + 1e-9
        if same_way and abs(aim) <= abs(speed):
            assert then == pytest.approx(aim)
    for _ in range(127):
        speeds = grown(speeds, goal, most)  # type: ignore[assignment]
    assert speeds == goal


# --- Held keys --------------------------------------------------------------------------


KEYS = {"W": Heading.FORWARD, "S": Heading.BACK, "A": Heading.LEFT, "D": Heading.RIGHT}


@pytest.mark.parametrize(
    ("names", "setpoint"),
    [
        ("", (0, 0)),
        ("W", (1, 0)),
        ("S", (-1, 0)),
        ("D", (0, 1)),
        ("WW", (1, 0)),
        ("WD", (1, TURN_WHILE_DRIVING)),
        ("SA", (-1, -TURN_WHILE_DRIVING)),
        ("WS", (0, 0)),
        ("WSD", (0, 1)),
        ("WASD", (0, 0)),
    ],
)
def test_held_keys_are_combined(names: str, setpoint: tuple[float, float]) -> None:
    assert keys_setpoint(KEYS[name] for name in names) == setpoint
