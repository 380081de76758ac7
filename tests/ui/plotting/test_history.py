"""Points and statistics of sample histories of any length."""

import itertools
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support.matrix import examples
from trex_gui.ui.plotting.history import Floats, SampleHistory


def new_history(
    count: int, capacity: int = 1_000_000, seed: int = 1, rate: float = 80
) -> SampleHistory:
    history = SampleHistory(2, capacity)
    noise = np.random.default_rng(seed)
    history.extend(np.arange(count) / rate, list(noise.normal(size=(2, count))))
    return history


def test_empty_history_has_no_points() -> None:
    history = SampleHistory(2)
    assert history.span is None
    assert len(history) == 0
    times, values = history.points(0, 0, 30, 500)
    assert len(times) == len(values) == 0
    assert history.statistics(0, 0, 30).seconds == 0
    assert math.isnan(history.statistics(0, 0, 30).mean)
    assert math.isnan(history.value_at(0, 1))


def test_times_stay_sorted_when_the_clock_steps_back() -> None:
    history = SampleHistory(1)
    history.append(2.0, 1.0)
    history.append(1.0, 2.0)
    assert history.times.tolist() == [2.0, 2.0]


def test_sparse_samples_are_drawn_beyond_both_edges() -> None:
    history = SampleHistory(1)
    history.extend(np.arange(10.0) / 4, [np.arange(10.0)])
    times, values = history.points(0, 1.0, 2.0, 500)
    assert times.tolist() == [0.75, 1.0, 1.25, 1.5, 1.75, 2.0, 2.25]
    assert values.tolist() == [3, 4, 5, 6, 7, 8, 9]


@examples(50)
@given(
    count=st.integers(1, 6000),
    capacity=st.sampled_from([100, 1000, 8000, 1_000_000]),
    seed=st.integers(0, 99),
    bins=st.integers(1, 60),
    ends=st.tuples(st.floats(0, 1), st.floats(0, 1)),
)
def test_points_are_limited_and_contain_every_peak(
    count: int, capacity: int, seed: int, bins: int, ends: tuple[float, float]
) -> None:
    history = new_history(count, capacity, seed)
    low, high = history.span or (0.0, 0.0)
    start, end = sorted(low + part * (high - low) for part in ends)
    end += 0.01
    times, values = history.points(1, start, end, bins)
    rows = history.rows(start, end)
    inside = history.values(1)[rows]
    assert len(times) == len(values) <= 2 * bins + 8
    assert np.all(np.diff(times) >= 0)
    if len(inside):
        assert values.max() >= inside.max()
        assert values.min() <= inside.min()
        assert np.isin(values, history.values(1)).all()


@examples(50)
@given(
    count=st.integers(1, 6000),
    capacity=st.sampled_from([100, 1000, 8000, 1_000_000]),
    seed=st.integers(0, 99),
    ends=st.tuples(st.floats(0, 1), st.floats(0, 1)),
    gaps=st.lists(st.integers(0, 5999), max_size=5),
    step=st.integers(20, 700),
)
def test_statistics_equal_those_of_a_loop_over_samples(
    count: int, capacity: int, seed: int, ends: tuple[float, float], gaps: list[int], step: int
) -> None:
    noise = np.random.default_rng(seed)
    times, values = np.arange(count) / 80, noise.normal(3, 2, size=(1, count))
    for gap in gaps:
        times[gap:] += 2.0
        values[0, gap // 2 : gap // 2 + 3] = math.nan
    history = SampleHistory(1, capacity)
    for first in range(0, count, step):
        history.extend(times[first : first + step], list(values[:, first : first + step]))
    times, value = times[-capacity:], values[0, -capacity:]
    assert np.array_equal(history.times, times)
    start, end = sorted(times[0] + part * (times[-1] - times[0]) for part in ends)
    result = history.statistics(0, start, end)
    inside = (times >= start) & (times <= end)
    expected = reference_statistics(times[inside], value[inside])
    figures = [result.seconds, result.integral, result.mean, result.rms, result.low, result.high]
    assert figures == pytest.approx(expected, rel=1e-9, abs=1e-9, nan_ok=True)


def reference_statistics(times: Floats, values: Floats) -> list[float]:
    """Return seconds, integral, mean, RMS, low and high, computed sample by sample."""
    seconds = integral = squares = 0.0
    rows = list(zip(times.tolist(), values.tolist(), strict=True))
    for (begin, before), (end, after) in itertools.pairwise(rows):
        if end - begin <= 0.5 and not math.isnan(before + after):
            seconds += end - begin
            integral += (before + after) / 2 * (end - begin)
            squares += (before**2 + after**2) / 2 * (end - begin)
    known = [value for value in values.tolist() if not math.isnan(value)]
    limits = [min(known), max(known)] if known else [math.nan, math.nan]
    if not seconds:
        return [0.0, 0.0, math.nan, math.nan, *limits]
    return [seconds, integral, integral / seconds, math.sqrt(squares / seconds), *limits]


def test_append_gives_the_same_history_as_extend() -> None:
    extended, appended = new_history(5000, 1000), SampleHistory(2, 1000)
    noise = np.random.default_rng(1).normal(size=(2, 5000))
    for row in range(5000):
        appended.append(row / 80, *noise[:, row])
    assert np.array_equal(extended.times, appended.times)
    for column in (0, 1):
        assert np.array_equal(
            extended.points(column, 51, 60, 20), appended.points(column, 51, 60, 20)
        )
        assert extended.statistics(column, 51, 60) == appended.statistics(column, 51, 60)


def test_oldest_rows_are_dropped_at_capacity() -> None:
    history = new_history(20_000, 3000)
    assert len(history) == 3000
    assert history.span == (17_000 / 80, 19_999 / 80)
    assert history._times.nbytes < 2 * 8 * 3000


def test_gap_in_samples_interrupts_the_curve() -> None:
    history = SampleHistory(1)
    for time in (0.0, 0.25, 0.5, 10.5, 10.75):
        history.append(time, 2.0)
    times, values = history.points(0, 0, 20, 500)
    assert times.tolist() == [0.0, 0.25, 0.5, 0.5, 10.5, 10.75]
    assert np.isnan(values).tolist() == [False, False, False, True, False, False]


def test_gap_is_drawn_in_a_long_history() -> None:
    history = SampleHistory(1)
    times = np.arange(200_000) / 80
    times[77_777:] += 600
    history.extend(times, [np.ones(200_000)])
    drawn, values = history.points(0, 0, 3200, 500)
    (gap,) = np.flatnonzero(np.isnan(values))
    assert drawn[gap + 1] - drawn[gap - 1] == pytest.approx(600, abs=0.1)


def test_points_are_limited_even_with_many_gaps() -> None:
    history = SampleHistory(1)
    history.extend(np.arange(20_000.0), [np.ones(20_000)])  # every interval is a gap
    times, _ = history.points(0, 0, 100, 500)
    assert len(times) <= 1000


def test_value_at_gives_the_last_sample_before_a_time() -> None:
    history = SampleHistory(1)
    history.append(1.0, 5.0)
    history.append(1.2, 6.0)
    assert math.isnan(history.value_at(0, 0.9))
    assert history.value_at(0, 1.0) == 5
    assert history.value_at(0, 1.19) == 5
    assert history.value_at(0, 1.3) == 6
    assert math.isnan(history.value_at(0, 2.0))


def test_scrolling_does_not_change_the_drawn_bins() -> None:
    history = new_history(50_000)
    _, before = history.points(0, 0, 200, 100)
    _, after = history.points(0, 20, 220, 100)
    # Each bin reappears at its new position, except the newest bin, which is incomplete.
    assert np.array_equal(before[20:-5], after[2 : len(before) - 23])


def test_cleared_history_starts_again_from_any_time() -> None:
    history = new_history(5000)
    history.clear()
    assert history.span is None
    history.append(0.0, 1.0, 2.0)
    history.append(0.5, 1.0, 2.0)
    assert history.statistics(1, 0, 1).integral == 1
