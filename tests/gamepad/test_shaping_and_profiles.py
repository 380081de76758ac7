"""What a stick's place means, and what is remembered of a kind of gamepad."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support.pads import PAD
from trex_gui.gamepad.pads import Pad
from trex_gui.gamepad.profile import Axis, Profile, Style, default_profile, read_profile
from trex_gui.gamepad.shaping import shape

ZONES = st.floats(0, 0.5)
PARTS = st.floats(0, 1)


@given(value=st.floats(-1.1, 1.1), dead_zone=ZONES, expo=PARTS)
def test_a_wish_never_leaves_its_range_and_has_the_side_of_the_stick(
    value: float, dead_zone: float, expo: float
) -> None:
    wish = shape(value, dead_zone, expo)
    assert -1 <= wish <= 1
    assert wish * value >= 0


@given(dead_zone=ZONES, part=PARTS, expo=PARTS)
def test_inside_the_dead_zone_nothing_is_wished(dead_zone: float, part: float, expo: float) -> None:
    assert shape(dead_zone * part, dead_zone, expo) == 0


@given(dead_zone=ZONES, expo=PARTS)
def test_a_stick_at_its_end_is_everything_whatever_is_set(dead_zone: float, expo: float) -> None:
    assert shape(1.0, dead_zone, expo) == pytest.approx(1)
    assert shape(-1.0, dead_zone, expo) == pytest.approx(-1)


@given(low=PARTS, high=PARTS, dead_zone=ZONES, expo=PARTS)
def test_more_stick_is_never_less_speed(
    low: float, high: float, dead_zone: float, expo: float
) -> None:
    low, high = sorted((low, high))
    assert shape(low, dead_zone, expo) <= shape(high, dead_zone, expo)


def test_behind_the_dead_zone_speed_begins_at_nothing() -> None:
    assert shape(0.16, 0.15, 0.0) == pytest.approx(0.0118, abs=0.001)


def test_expo_makes_the_middle_finer() -> None:
    assert shape(0.5, 0.0, 1.0) == pytest.approx(0.125)


BUTTONS = st.none() | st.integers(0, 40)
AXES = st.builds(Axis, st.integers(0, 20), st.booleans())


@given(
    style=st.sampled_from(Style), first=AXES, second=AXES, zone=ZONES, expo=PARTS, button=BUTTONS
)
def test_what_is_remembered_is_read_back_equal(
    style: Style, first: Axis, second: Axis, zone: float, expo: float, button: int | None
) -> None:
    profile = Profile(
        style=style, first=first, second=second, dead_zone=zone, expo=expo, hold=button, stop=None
    )
    assert read_profile(profile.to_text()) == profile


@given(text=st.text())
def test_a_note_that_somebody_has_spoilt_is_none(text: str) -> None:
    assert read_profile(text) is None


@pytest.mark.parametrize(
    "spoilt",
    ['"dead_zone": 0.9', '"dead_zone": NaN', '"expo": -1', '"hold": true', '"hold": -2',
     '"first": [1]', '"first": [true, false]', '"style": "crab"'],
)  # fmt: skip
def test_a_note_with_one_impossible_value_is_none(spoilt: str) -> None:
    good = Profile().to_text()
    assert read_profile(good[:-1] + f", {spoilt}" + "}") is None  # the later of two counts


def test_without_a_note_the_left_stick_drives_and_the_left_shoulder_is_held() -> None:
    profile = default_profile(PAD)
    assert profile.first == Axis(1, inverted=True)
    assert profile.second == Axis(0)
    assert (profile.hold, profile.stop) == (4, 1)
    assert profile.fits(PAD)


@pytest.mark.parametrize("buttons", range(8))
def test_what_is_chosen_for_an_unknown_kind_is_there(buttons: int) -> None:
    pad = Pad(ident=1, guid="0", name="Stick", axes=2, buttons=buttons)
    profile = default_profile(pad)
    assert profile.fits(pad)
    assert profile.hold is None or profile.hold != profile.stop
