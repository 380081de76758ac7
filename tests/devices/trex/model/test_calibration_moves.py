"""Moves of calibration handles within their limits."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from trex_gui.devices.trex.model.calibration_moves import Handle, limit_to_input, move_handle
from trex_gui.devices.trex.protocol.calibration import HIGHEST_CODED, Calibration
from trex_gui.devices.trex.protocol.flags import InputSource

CALIBRATION = Calibration(2500, 3750, 5000, 75)

counts = st.integers(0, HIGHEST_CODED)


@st.composite
def calibrations(draw: st.DrawFn) -> Calibration:
    low, middle, high = sorted(draw(st.lists(counts, min_size=3, max_size=3)))
    if low == high:
        low, high = max(0, low - 1), min(HIGHEST_CODED, high + 1)
    return Calibration(low, middle, high, draw(counts))


@given(calibration=calibrations(), handle=st.sampled_from(Handle), count=counts)
def test_moved_handle_gives_a_valid_calibration(
    calibration: Calibration, handle: Handle, count: int
) -> None:
    result, reason = move_handle(calibration, handle, count)
    assert result.problem() is None
    assert (handle.count(result) == count) == (reason == "")


@pytest.mark.parametrize(
    ("source", "handle", "count", "limited", "reason"),
    [
        (InputSource.RC, Handle.MAXIMUM, 6250, 6250, ""),
        (InputSource.RC, Handle.MAXIMUM, 7000, 6250, "Pulses range from 500 µs to 2500 µs."),
        (InputSource.RC, Handle.MINIMUM, 900, 1250, "Pulses range from 500 µs to 2500 µs."),
        (InputSource.ANALOG, Handle.MAXIMUM, 1100, 1023, "Voltages range from 0.00 V to 5.00 V."),
        (InputSource.ANALOG, Handle.MINIMUM, -9, 0, "Voltages range from 0.00 V to 5.00 V."),
    ],
)
def test_handle_is_limited_to_the_input_range(
    source: InputSource, handle: Handle, count: int, limited: int, reason: str
) -> None:
    calibration = CALIBRATION if source is InputSource.RC else Calibration(100, 512, 900, 20)
    assert limit_to_input(calibration, handle, count, source) == (limited, reason)


def test_handle_beyond_the_input_range_may_remain_there() -> None:
    wide = Calibration(100, 3750, 15000, 75)
    assert limit_to_input(wide, Handle.MAXIMUM, 14000, InputSource.RC) == (14000, "")
    assert limit_to_input(wide, Handle.MINIMUM, 50, InputSource.RC)[0] == 100


def test_each_handle_changes_its_own_value() -> None:
    assert move_handle(CALIBRATION, Handle.MINIMUM, 2400)[0] == Calibration(2400, 3750, 5000, 75)
    assert move_handle(CALIBRATION, Handle.NEUTRAL, 3700)[0] == Calibration(2500, 3700, 5000, 75)
    assert move_handle(CALIBRATION, Handle.MAXIMUM, 5100)[0] == Calibration(2500, 3750, 5100, 75)
    assert move_handle(CALIBRATION, Handle.DEADBAND_LOW, 3650)[0].deadband == 100
    assert move_handle(CALIBRATION, Handle.DEADBAND_HIGH, 3790)[0].deadband == 40


def test_blocked_handle_names_the_blocking_value() -> None:
    assert move_handle(CALIBRATION, Handle.MINIMUM, 4000)[1] == "Minimum cannot pass neutral."
    assert move_handle(CALIBRATION, Handle.NEUTRAL, 2000)[1] == "Neutral cannot pass minimum."
    assert move_handle(CALIBRATION, Handle.NEUTRAL, 6000)[1] == "Neutral cannot pass maximum."
    assert move_handle(CALIBRATION, Handle.MAXIMUM, 3000)[1] == "Maximum cannot pass neutral."
    assert (
        move_handle(CALIBRATION, Handle.DEADBAND_HIGH, 3000)[1]
        == "The ends of the deadband cannot pass neutral."
    )
    neutral_at_maximum = Calibration(2500, 5000, 5000, 0)
    assert (
        move_handle(neutral_at_maximum, Handle.MINIMUM, 5000)[1]
        == "Minimum and maximum must differ."
    )
