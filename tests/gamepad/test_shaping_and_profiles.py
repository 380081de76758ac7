"""Setpoints of stick positions, and profiles of gamepads."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support.pads import PAD
from trex_gui.gamepad.pads import Pad
from trex_gui.gamepad.profile import (
    Axis,
    GamepadProfile,
    Style,
    default_profile,
    read_profile,
    shape,
)

ZONES = st.floats(0, 0.5)
PARTS = st.floats(0, 1)


@given(value=st.floats(-1.1, 1.1), dead_zone=ZONES, expo=PARTS)
def test_setpoint_is_in_range_and_has_the_sign_of_the_stick(
    value: float, dead_zone: float, expo: float
) -> None:
    setpoint = shape(value, dead_zone, expo)
    assert -1 <= setpoint <= 1
    assert setpoint * value >= 0


@given(dead_zone=ZONES, part=PARTS, expo=PARTS)
def test_setpoint_is_zero_inside_dead_zone(dead_zone: float, part: float, expo: float) -> None:
    assert shape(dead_zone * part, dead_zone, expo) == 0


@given(dead_zone=ZONES, expo=PARTS)
def test_full_deflection_always_gives_full_setpoint(dead_zone: float, expo: float) -> None:
    assert shape(1.0, dead_zone, expo) == pytest.approx(1)
    assert shape(-1.0, dead_zone, expo) == pytest.approx(-1)


@given(low=PARTS, high=PARTS, dead_zone=ZONES, expo=PARTS)
def test_more_deflection_never_gives_less_speed(
    low: float, high: float, dead_zone: float, expo: float
) -> None:
    low, high = sorted((low, high))
    assert shape(low, dead_zone, expo) <= shape(high, dead_zone, expo)


def test_setpoint_starts_near_zero_outside_dead_zone() -> None:
    assert shape(0.16, 0.15, 0.0) == pytest.approx(0.0118, abs=0.001)


def test_expo_reduces_setpoint_at_half_deflection() -> None:
    assert shape(0.5, 0.0, 1.0) == pytest.approx(0.125)


BUTTONS = st.none() | st.integers(0, 40)
AXES = st.builds(Axis, st.integers(0, 20), st.booleans())


@given(
    style=st.sampled_from(Style), first=AXES, second=AXES, zone=ZONES, expo=PARTS, button=BUTTONS
)
def test_saved_profile_is_read_back_unchanged(
    style: Style, first: Axis, second: Axis, zone: float, expo: float, button: int | None
) -> None:
    profile = GamepadProfile(
        style=style, first=first, second=second, dead_zone=zone, expo=expo, hold=button, stop=None
    )
    assert read_profile(profile.to_text()) == profile


@pytest.mark.parametrize(
    "corrupted",
    ['"dead_zone": 0.9', '"dead_zone": NaN', '"dead_zone": false', '"expo": -1', '"expo": true',
     '"hold": true', '"hold": -2',
     '"first": [1]', '"first": [true, false]', '"style": "crab"'],
)  # fmt: skip
def test_profile_with_one_invalid_value_is_rejected(corrupted: str) -> None:
    good = GamepadProfile().to_text()
    assert read_profile(f"{good[:-1]}, {corrupted}}}") is None  # the last value of a key counts


def test_default_profile_uses_left_stick_and_left_shoulder() -> None:
    profile = default_profile(PAD)
    assert profile.first == Axis(1, inverted=True)
    assert profile.second == Axis(0)
    assert (profile.hold, profile.stop) == (4, 1)
    assert profile.fits(PAD)


@pytest.mark.parametrize(
    ("buttons", "hold", "stop"),
    [(0, None, None), (1, 0, None), (2, 1, None), (3, 2, 1), (5, 4, 1), (8, 4, 1)],
)
def test_default_profile_fits_unknown_gamepad(
    buttons: int, hold: int | None, stop: int | None
) -> None:
    pad = Pad(ident=1, guid="0", name="Stick", axes=2, buttons=buttons)
    profile = default_profile(pad)
    assert profile.fits(pad)
    assert (profile.hold, profile.stop) == (hold, stop)
