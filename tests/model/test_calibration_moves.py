"""Handles that are moved stay where the board takes them."""

from hypothesis import given
from hypothesis import strategies as st

from trex_gui.model.calibration_moves import Handle, moved, symmetric
from trex_gui.protocol.calibration import HIGHEST_CODED, Calibration
from trex_gui.protocol.flags import InputSource

USUAL = Calibration(2500, 3750, 5000, 75)

counts = st.integers(0, HIGHEST_CODED)


@st.composite
def calibrations(draw: st.DrawFn) -> Calibration:
    low, middle, high = sorted(draw(st.lists(counts, min_size=3, max_size=3)))
    if low == high:
        low, high = max(0, low - 1), min(HIGHEST_CODED, high + 1)
    return Calibration(low, middle, high, draw(counts))


@given(calibration=calibrations(), handle=st.sampled_from(Handle), count=counts)
def test_no_move_makes_a_calibration_that_the_board_would_refuse(
    calibration: Calibration, handle: Handle, count: int
) -> None:
    move = moved(calibration, handle, count)
    assert move.calibration.problem() is None
    reached = handle.count(move.calibration) == count
    assert reached == (move.why == "")


@given(calibration=calibrations(), source=st.sampled_from(InputSource), larger=st.booleans())
def test_symmetric_ends_are_equally_far_from_neutral(
    calibration: Calibration, source: InputSource, larger: bool
) -> None:
    made = symmetric(calibration, source, larger=larger)
    assert made.neutral == calibration.neutral
    assert made.deadband == calibration.deadband
    if made.problem() is None and made.minimum > 0:
        assert made.neutral - made.minimum == made.maximum - made.neutral


def test_each_handle_moves_its_own_part() -> None:
    assert moved(USUAL, Handle.MINIMUM, 2400).calibration == Calibration(2400, 3750, 5000, 75)
    assert moved(USUAL, Handle.NEUTRAL, 3700).calibration == Calibration(2500, 3700, 5000, 75)
    assert moved(USUAL, Handle.MAXIMUM, 5100).calibration == Calibration(2500, 3750, 5100, 75)
    assert moved(USUAL, Handle.DEADBAND_LOW, 3650).calibration.deadband == 100
    assert moved(USUAL, Handle.DEADBAND_HIGH, 3790).calibration.deadband == 40


def test_a_handle_that_meets_another_says_which() -> None:
    assert moved(USUAL, Handle.MINIMUM, 4000).why == "Minimum cannot pass neutral."
    assert moved(USUAL, Handle.NEUTRAL, 2000).why == "Neutral cannot pass minimum."
    assert moved(USUAL, Handle.NEUTRAL, 6000).why == "Neutral cannot pass maximum."
    assert moved(USUAL, Handle.MAXIMUM, 3000).why == "Maximum cannot pass neutral."
    assert moved(USUAL, Handle.DEADBAND_HIGH, 3000).why == "The deadband ends at neutral."
    at_the_end = Calibration(2500, 5000, 5000, 0)
    assert moved(at_the_end, Handle.MINIMUM, 5000).why == "Minimum and maximum must differ."


def test_travel_is_made_equal_to_the_shorter_or_the_longer_side() -> None:
    uneven = Calibration(2700, 3700, 5000, 75)
    assert symmetric(uneven, InputSource.RC, larger=False) == Calibration(2700, 3700, 4700, 75)
    assert symmetric(uneven, InputSource.RC, larger=True) == Calibration(2400, 3700, 5000, 75)


def test_a_voltage_cannot_be_made_to_end_above_5_v() -> None:
    uneven = Calibration(100, 600, 1000, 20)
    made = symmetric(uneven, InputSource.ANALOG, larger=True)
    assert made == Calibration(177, 600, 1023, 20)
