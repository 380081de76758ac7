"""What measured channels mean: remapping, switches, mixing."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from trex_gui.devices.trex.protocol.calibration import DEFAULT_CALIBRATION
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource
from trex_gui.devices.trex.simulator.channel_control import ChannelSetup, motor_values

SETUP = ChannelSetup((DEFAULT_CALIBRATION[InputSource.RC],) * 5)
values = st.integers(-127, 127)


@pytest.mark.parametrize(
    ("raw", "active"), [(None, False), (3750, False), (3126, False), (3124, True), (2500, True)]
)
def test_switch_is_active_below_half_of_its_lower_range(raw: int | None, active: bool) -> None:
    assert SETUP.is_switched(5, raw) is active


def test_switch_respects_ignored_and_reversed_settings() -> None:
    assert not ChannelSetup(SETUP.calibrations, ignored=0x10).is_switched(5, 2500)
    turned = ChannelSetup(SETUP.calibrations, reversed_=0x08)
    assert turned.is_switched(4, 5000)
    assert not turned.is_switched(4, 2500)


def test_mix_adds_turn_to_one_motor_and_subtracts_from_other() -> None:
    assert motor_values((30, 100), mix=True, flip=False, joint=False) == (127, 70)
    assert motor_values((127, -127), mix=True, flip=False, joint=False) == (0, -127)


def test_flip_swaps_and_reverses_motors() -> None:
    assert motor_values((10, -20), mix=False, flip=True, joint=False) == (20, -10)
    assert motor_values((30, 50), mix=True, flip=True, joint=False) == (-20, -80)


@given(first=values, second=values, mix=st.booleans(), flip=st.booleans(), joint=st.booleans())
def test_motor_setpoints_stay_within_full_speed(
    first: int, second: int, mix: bool, flip: bool, joint: bool
) -> None:
    requested = motor_values((first, second), mix=mix, flip=flip, joint=joint)
    assert all(abs(value) <= 127 for value in requested)


@given(raw=st.lists(st.none() | st.integers(0, 0xFFFE), min_size=5, max_size=5))
def test_any_raw_value_is_remapped_within_full_speed(raw: list[int | None]) -> None:
    remapped = SETUP.remapped(raw)
    assert len(remapped) == len(CHANNELS)
    assert all(-127 <= value <= 127 for value in remapped)
