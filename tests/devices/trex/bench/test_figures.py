"""Figures of bench tests."""

import pytest

from tests.devices.trex.bench.runs import run_of
from trex_gui.devices.trex.bench.run import MAX_GAP, End, Figures, Profile, Shape, figures

RATE = 80


def readings(*parts: tuple[float, float]) -> list[tuple[float, float]]:
    """Return 80 readings a second from consecutive parts: (duration in s, current in A)."""
    result: list[tuple[float, float]] = []
    for seconds, amperes in parts:
        first = len(result)
        result += [((first + index) / RATE, amperes) for index in range(round(seconds * RATE))]
    return result


def test_inrush_and_settling_time_are_measured() -> None:
    run = run_of(readings((0.05, 0.0), (0.1, 12.0), (0.15, 6.0), (1.8, 4.0)))
    result = figures(run)
    assert result.peak == 12.0
    assert result.delay == pytest.approx(0.05)
    assert result.steady == pytest.approx(4.0)
    assert result.settled == pytest.approx(0.3)


def test_inrush_crossing_the_steady_current_has_not_settled() -> None:
    """The rising and the falling current both pass within a tenth of 4 A."""
    parts = (0.1, 4.0), (0.1, 9.0), (0.1, 4.0), (0.1, 3.0), (1.6, 4.0)
    result = figures(run_of(readings(*parts)))
    assert result.delay == pytest.approx(0)
    assert result.settled == pytest.approx(0.4)


def test_mean_and_charge_cover_only_the_driven_time() -> None:
    run = run_of([(index / 100, 3.6) for index in range(301)], ended=2.0)
    result = figures(run)
    assert result.mean == pytest.approx(3.6)
    assert result.charge == pytest.approx(2.0)  # 3.6 A for 2 s is 2 mAh


def test_gap_in_readings_adds_no_charge() -> None:
    gap = MAX_GAP + 0.1
    result = figures(run_of([(0.0, 3.6), (0.5, 3.6), (0.5 + gap, 3.6), (1.0 + gap, 3.6)]))
    assert result.charge == pytest.approx(1.0)
    assert result.mean == pytest.approx(3.6)


def test_peak_excludes_the_current_before_start_and_after_end() -> None:
    currents = [(-0.1, 60.0), (0.1, 1.0), (0.5, 1.0), (1.2, 50.0)]
    run = run_of(currents, ended=1.0, end=End.RELEASED)
    assert figures(run).peak == 1.0


def test_run_has_no_setpoint_or_current_outside_its_times() -> None:
    run = run_of([(0.1, 1.0), (0.5, 2.0)], ended=0.3)
    assert [run.setpoint_at(time) for time in (-0.1, 0.0, 0.3, 0.4)] == [0, 40, 40, 0]
    assert [run.current_at(time) for time in (0.0, 0.3, 0.5, 0.6)] == [None, 1.0, 2.0, None]


def test_run_without_readings_has_empty_figures() -> None:
    assert figures(run_of([])) == Figures()


def test_delay_ignores_noise_of_one_count() -> None:
    result = figures(run_of(readings((0.5, 0.15), (1.5, 0.3))))
    assert result.delay == pytest.approx(0.5)


def test_motor_drawing_no_current_never_settles() -> None:
    result = figures(run_of(readings((2.0, 0.0))))
    assert result.peak == 0
    assert result.steady == 0
    assert result.settled is None
    assert result.delay is None


def test_sine_has_no_steady_current() -> None:
    profile = Profile(shape=Shape.SINE, duration=2.0)
    result = figures(run_of(readings((2.0, 3.0)), profile))
    assert result.steady is None
    assert result.peak == 3.0


def test_steady_current_of_reversal_precedes_first_turn() -> None:
    profile = Profile(shape=Shape.REVERSE, duration=2.0, period=2.0)
    result = figures(run_of(readings((0.2, 9.0), (0.8, 3.0), (1.0, 20.0)), profile))
    assert result.steady == pytest.approx(3.0)
    assert result.settled == pytest.approx(0.2)
    assert result.peak == 20.0


def test_steady_current_of_ramp_follows_its_rise() -> None:
    profile = Profile(shape=Shape.RAMP, duration=2.0, period=1.0)
    result = figures(run_of(readings((1.0, 1.0), (1.0, 5.0)), profile))
    assert result.steady == pytest.approx(5.0)


@pytest.mark.parametrize(("ended", "steady"), [(0.3, None), (1.0, 5.0)])
def test_only_a_long_enough_run_has_a_steady_current(ended: float, steady: float | None) -> None:
    result = figures(run_of(readings((ended, 5.0)), ended=ended, end=End.RELEASED))
    assert result.steady == steady
    assert result.mean == pytest.approx(5.0)


def test_noise_of_two_counts_counts_as_settled() -> None:
    low_current = [(index / RATE, 0.45 if index % 2 else 0.15) for index in range(2 * RATE)]
    assert figures(run_of(low_current)).settled == 0


def test_oscillating_current_never_settles() -> None:
    oscillation = [(index / RATE, 8.0 if index % 2 else 0.0) for index in range(2 * RATE)]
    assert figures(run_of(oscillation)).settled is None
