"""Handles that are moved stay where the board takes them."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from trex_gui.devices.trex.model.calibration_moves import (
    Handle,
    moved,
    symmetric,
    why_not_symmetric,
    within_input,
)
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE, HIGHEST_CODED, Calibration, remap
from trex_gui.devices.trex.protocol.flags import InputSource

USUAL = Calibration(2500, 3750, 5000, 75)

counts = st.integers(0, HIGHEST_CODED)


@st.composite
def calibrations(draw: st.DrawFn) -> Calibration:
    low, middle, high = sorted(draw(st.lists(counts, min_size=3, max_size=3)))
    if low == high:
        low, high = max(0, low - 1), min(HIGHEST_CODED, high + 1)
    return Calibration(low, middle, high, draw(counts))


@given(calibration=calibrations(), handle=st.sampled_from(Handle), count=counts)
def test_moved_handle_gives_a_calibration_the_board_accepts(
    calibration: Calibration, handle: Handle, count: int
) -> None:
    made, why = moved(calibration, handle, count)
    assert made.problem() is None
    assert (handle.count(made) == count) == (why == "")


@given(calibration=calibrations(), source=st.sampled_from(InputSource), larger=st.booleans())
def test_symmetric_travel_is_equal_and_reaches_every_output(
    calibration: Calibration, source: InputSource, larger: bool
) -> None:
    made = symmetric(calibration, source, larger=larger)
    if why_not_symmetric(made, source):
        return
    assert made.problem() is None
    assert (made.neutral, made.deadband) == (calibration.neutral, calibration.deadband)
    assert made.neutral - made.minimum == made.maximum - made.neutral
    first, last = made.neutral + made.deadband, made.maximum
    outputs = {remap(raw, made) for raw in range(first, last + 1)}
    assert outputs == set(range(FULL_SCALE + 1))


def test_side_without_travel_cannot_be_mirrored() -> None:
    one_sided = Calibration(3750, 3750, 5000, 75)
    why = why_not_symmetric(symmetric(one_sided, InputSource.RC, larger=False), InputSource.RC)
    assert why.startswith("That would leave 0 µs on each side of neutral")
    made = symmetric(one_sided, InputSource.RC, larger=True)
    assert not why_not_symmetric(made, InputSource.RC)
    assert made == USUAL


@pytest.mark.parametrize(("travel", "good"), [(75 + 127, False), (75 + 128, True)])
def test_equal_travel_needs_a_count_for_each_output(travel: int, good: bool) -> None:
    short = Calibration(3750 - travel, 3750, 3750 + travel, 75)
    assert (why_not_symmetric(short, InputSource.RC) == "") is good


@pytest.mark.parametrize(
    ("source", "uneven", "larger", "expected"),
    [
        (InputSource.RC, (2700, 3700, 5000), False, (2700, 3700, 4700)),
        (InputSource.RC, (2700, 3700, 5000), True, (2400, 3700, 5000)),
        (InputSource.RC, (2000, 2500, 5000), True, (1250, 2500, 3750)),  # 500 µs at least
        (InputSource.ANALOG, (100, 600, 1000), True, (177, 600, 1023)),  # 5 V at most
    ],
)
def test_symmetric_travel_is_that_of_one_side_within_the_input_range(
    source: InputSource,
    uneven: tuple[int, int, int],
    larger: bool,
    expected: tuple[int, int, int],
) -> None:
    made = symmetric(Calibration(*uneven, 75), source, larger=larger)
    assert made == Calibration(*expected, 75)


@pytest.mark.parametrize(
    ("source", "handle", "count", "kept", "words"),
    [
        (InputSource.RC, Handle.MAXIMUM, 6250, 6250, ""),
        (InputSource.RC, Handle.MAXIMUM, 7000, 6250, "A pulse is 500 µs to 2500 µs."),
        (InputSource.RC, Handle.MINIMUM, 900, 1250, "A pulse is 500 µs to 2500 µs."),
        (InputSource.ANALOG, Handle.MAXIMUM, 1100, 1023, "A voltage is 0.00 V to 5.00 V."),
        (InputSource.ANALOG, Handle.MINIMUM, -9, 0, "A voltage is 0.00 V to 5.00 V."),
    ],
)
def test_handle_is_limited_to_the_input_range(
    source: InputSource, handle: Handle, count: int, kept: int, words: str
) -> None:
    calibration = USUAL if source is InputSource.RC else Calibration(100, 512, 900, 20)
    assert within_input(calibration, handle, count, source) == (kept, words)


def test_handle_beyond_the_input_range_may_stay() -> None:
    wide = Calibration(100, 3750, 15000, 75)
    assert within_input(wide, Handle.MAXIMUM, 14000, InputSource.RC) == (14000, "")
    assert within_input(wide, Handle.MINIMUM, 50, InputSource.RC)[0] == 100


def test_each_handle_changes_its_own_value() -> None:
    assert moved(USUAL, Handle.MINIMUM, 2400)[0] == Calibration(2400, 3750, 5000, 75)
    assert moved(USUAL, Handle.NEUTRAL, 3700)[0] == Calibration(2500, 3700, 5000, 75)
    assert moved(USUAL, Handle.MAXIMUM, 5100)[0] == Calibration(2500, 3750, 5100, 75)
    assert moved(USUAL, Handle.DEADBAND_LOW, 3650)[0].deadband == 100
    assert moved(USUAL, Handle.DEADBAND_HIGH, 3790)[0].deadband == 40


def test_blocked_handle_names_what_blocks_it() -> None:
    assert moved(USUAL, Handle.MINIMUM, 4000)[1] == "Minimum cannot pass neutral."
    assert moved(USUAL, Handle.NEUTRAL, 2000)[1] == "Neutral cannot pass minimum."
    assert moved(USUAL, Handle.NEUTRAL, 6000)[1] == "Neutral cannot pass maximum."
    assert moved(USUAL, Handle.MAXIMUM, 3000)[1] == "Maximum cannot pass neutral."
    assert moved(USUAL, Handle.DEADBAND_HIGH, 3000)[1] == "The deadband ends at neutral."
    at_the_end = Calibration(2500, 5000, 5000, 0)
    assert moved(at_the_end, Handle.MINIMUM, 5000)[1] == "Minimum and maximum must differ."
