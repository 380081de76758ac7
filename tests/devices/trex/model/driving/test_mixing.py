"""Mixing of forward and turn into two speeds."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from trex_gui.devices.trex.model.momentary_drive import (
    TURN_WHILE_DRIVING,
    Heading,
    keys_setpoint,
    mix,
    next_speeds,
)
from trex_gui.devices.trex.simulator.channel_control import motor_values

FRACTION = st.floats(-1, 1, allow_nan=False)
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


@given(forward=FRACTION, turn=FRACTION, ceiling=st.integers(1, 127))
def test_mixed_speeds_stay_within_the_ceiling(forward: float, turn: float, ceiling: int) -> None:
    assert all(abs(speed) <= ceiling for speed in mix(forward, turn, ceiling))


@given(forward=FRACTION, turn=FRACTION)
def test_mixed_speeds_have_the_directions_of_the_board(forward: float, turn: float) -> None:
    channels = (round(turn * 127), round(forward * 127), 0, 0, 0)
    expected = motor_values(channels, mix=True, flip=False, joint=False)
    for program, board in zip(mix(forward, turn), expected, strict=True):
        assert abs(program) <= abs(board) + 1
        assert program * board >= 0 or abs(program) <= 1


@given(forward=FRACTION, turn=FRACTION)
def test_mixing_retains_the_speed_ratio_when_limited(forward: float, turn: float) -> None:
    left, right = mix(forward, turn)
    # Rounding changes the ratio of the speeds slightly.
    assert abs(left * (forward - turn) - right * (forward + turn)) <= 2


@given(speeds=SPEEDS, target=SPEEDS, step=st.integers(1, 127))
def test_speeds_grow_in_steps_and_fall_at_once(
    speeds: tuple[int, int], target: tuple[int, int], step: int
) -> None:
    for speed, end, new in zip(speeds, target, next_speeds(speeds, target, step), strict=True):
        same_direction = speed * end > 0
        assert abs(new) <= abs(end) + 1e-9
        assert new * end >= 0
        assert abs(new) <= (abs(speed) if same_direction else 0) + step + 1e-9
        if same_direction and abs(end) <= abs(speed):
            assert new == pytest.approx(end)
    for _ in range(127):
        speeds = next_speeds(speeds, target, step)  # type: ignore[assignment]
    assert speeds == target


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
