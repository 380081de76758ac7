"""Ranges, ticks and labels of plot axes."""

from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support.matrix import examples
from trex_gui.ui.plotting.axes import ValueAxis, round_up, spread, ticks


@pytest.mark.parametrize(
    ("value", "rounded"),
    [(0.03, 0.05), (0.1, 0.1), (1.01, 2), (2, 2), (2.1, 5), (5.5, 10), (37, 50)],
)
def test_round_up_uses_steps_of_one_two_and_five(value: float, rounded: float) -> None:
    assert round_up(value) == pytest.approx(rounded)


def test_ticks_are_multiples_of_the_step() -> None:
    assert ticks(0, 1, 0.2) == pytest.approx([0, 0.2, 0.4, 0.6, 0.8, 1.0])
    assert ticks(-30, 0, 10) == [-30, -20, -10, 0]
    assert ticks(850, 2150, 500) == [1000, 1500, 2000]


@pytest.mark.parametrize(
    ("centres", "widths", "placed"),
    [
        ([10, 50, 90], [10, 10, 10], [10, 50, 90]),
        ([50, 50, 50], [10, 20, 10], [33, 50, 67]),
        ([0, 100], [20, 20], [10, 90]),
        ([99, 100], [20, 20], [68, 90]),
        ([1, 2, 3], [50, 50, 50], None),
    ],
)
def test_labels_move_only_if_space_is_short(
    centres: list[float], widths: list[float], placed: list[float] | None
) -> None:
    assert spread(centres, widths, 0, 100, 2) == placed


@examples(50)
@given(centres=st.lists(st.floats(-20, 320), max_size=6).map(sorted), width=st.floats(1, 40))
def test_labels_never_overlap(centres: list[float], width: float) -> None:
    placed = spread(centres, [width] * len(centres), 0, 300, 3)
    assert placed is not None
    for left, right in pairwise(placed):
        assert right - left >= width + 3 - 1e-6
    for centre in placed:
        assert width / 2 - 1e-6 <= centre <= 300 - width / 2 + 1e-6


def fit(axis: ValueAxis, low: float, high: float) -> tuple[float, float]:
    axis.fit([(low, high)])
    return axis.ends


def test_range_shrinks_only_when_data_fits_with_margin() -> None:
    axis = ValueAxis("A")
    assert fit(axis, 0, 7.2) == (0, 10)
    assert fit(axis, 0, 4.6) == (0, 10)
    assert fit(axis, 0, 3.9) == (0, 5)


def test_range_does_not_oscillate_at_a_step() -> None:
    axis = ValueAxis("A")
    for high in (5.01, 4.99, 5.01, 4.9, 5.0, 5.02):
        assert fit(axis, 0, high) == (0, 10)


def test_range_includes_negative_values_and_never_collapses() -> None:
    axis = ValueAxis("A")
    assert fit(axis, -3, 3) == (-5, 5)
    assert fit(axis, 0.5, 3) == (0, 5)
    assert fit(ValueAxis("A"), 0, 0) == (0, 1)


def test_axis_of_counts_has_fixed_range_while_values_fit() -> None:
    axis = ValueAxis("")
    assert fit(axis, -20, 100) == (-127, 127)
    assert fit(axis, 0, 150) == (0, 200)
    assert fit(axis, 0, 127) == (-127, 127)


def test_lower_end_of_a_small_range_is_labelled_0() -> None:
    axis = ValueAxis("A")
    axis.fit([(0, 0.5)])
    assert [text for _, text in axis.labels(2)] == ["0", "1 A"]
