import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from trex_gui.views.widgets.reduction import Floats, reduce_min_max


def samples(count: int, seed: int = 1) -> tuple[Floats, Floats]:
    noise = np.random.default_rng(seed)
    return np.sort(noise.uniform(0, 30, count)), noise.normal(size=count)


def test_few_samples_pass_unchanged() -> None:
    times, values = samples(100)
    kept_times, kept_values = reduce_min_max(times, values, 0, 30, 500)
    assert np.array_equal(kept_times, times)
    assert np.array_equal(kept_values, values)


def test_no_samples_are_no_samples() -> None:
    none = np.empty(0)
    assert all(len(part) == 0 for part in reduce_min_max(none, none, 0, 30, 500))


def test_only_the_window_is_kept() -> None:
    times, values = samples(1000)
    kept, _ = reduce_min_max(times, values, 10, 20, 500)
    assert kept[0] >= 10
    assert kept[-1] <= 20
    assert len(kept) == np.count_nonzero((times >= 10) & (times <= 20))


@given(count=st.integers(101, 3000), seed=st.integers(0, 99), bins=st.integers(1, 50))
def test_many_samples_become_few_and_lose_no_peak(count: int, seed: int, bins: int) -> None:
    times, values = samples(count, seed)
    kept_times, kept_values = reduce_min_max(times, values, 0, 30, bins)
    assert len(kept_times) == len(kept_values) <= 2 * (bins + 1) + 1
    assert kept_values.max() == values.max()
    assert kept_values.min() == values.min()
    assert np.all(np.diff(kept_times) >= 0)


def test_one_spike_among_a_hundred_thousand_survives() -> None:
    times = np.linspace(0, 30, 100_000)
    values = np.zeros_like(times)
    values[54_321] = 40
    _, kept = reduce_min_max(times, values, 0, 30, 500)
    assert np.count_nonzero(kept == 40) == 1


def test_the_line_ends_at_the_newest_sample() -> None:
    times, values = samples(5000)
    kept_times, kept_values = reduce_min_max(times, values, 0, 30, 100)
    assert kept_times[-1] == times[-1]
    assert kept_values[-1] == values[-1]


def test_the_picture_does_not_flicker_while_it_scrolls() -> None:
    times, values = samples(5000)
    _, before = reduce_min_max(times, values, 0, 20, 100)
    _, after = reduce_min_max(times, values, 2, 22, 100)
    # All but the newest value and the bin that was not full is found again, shifted.
    assert np.array_equal(before[20:-3], after[: len(before) - 23])


def test_a_gap_stays_a_gap() -> None:
    times = np.linspace(0, 30, 10_000)
    values = np.ones_like(times)
    values[3000:4000] = np.nan
    _, kept = reduce_min_max(times, values, 0, 30, 100)
    assert np.isnan(kept).any()
    assert np.nanmax(kept) == 1
