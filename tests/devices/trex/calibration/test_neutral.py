"""Measurement of rest positions, and its problems."""

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from tests.devices.trex.calibration.measure import learn, neutral_of, neutral_of_counts
from tests.support.matrix import examples
from tests.support.transmitter import Stick
from trex_gui.devices.trex.calibration.neutral import LIMITS, deadband_floor, measure_neutral
from trex_gui.devices.trex.calibration.problems import ProblemKind
from trex_gui.devices.trex.model.learning.problem_text import problem_text
from trex_gui.devices.trex.protocol.flags import InputSource

ANALOG = InputSource.ANALOG


def kinds(stick: Stick, seed: int = 1) -> set[ProblemKind]:
    return {problem.kind for problem in neutral_of(stick, seed).problems}


@examples(40)
@given(
    rest=st.floats(1100, 1900),
    noise=st.floats(0, 15),
    drift=st.floats(-1.5, 1.5),
    lost=st.floats(0, 0.2),
    spikes=st.floats(0, 0.005),
    seed=st.integers(0, 2**32),
)
def test_stick_rest_is_measured_within_half_its_noise(
    rest: float, noise: float, drift: float, lost: float, spikes: float, seed: int
) -> None:
    stick = Stick(rest=rest, noise=noise, drift=drift, lost=lost, spikes=spikes)
    neutral = neutral_of(stick, seed)
    if neutral.invalid > 0.05:  # rare: many pulses are lost in a row
        assert [problem.kind for problem in neutral.problems] == [ProblemKind.JITTER]
    else:
        # An outlier is repeated while pulses are lost. In rare cases it looks like a movement.
        expected = (
            {ProblemKind.JITTER, ProblemKind.MOVED} if spikes and lost else {ProblemKind.JITTER}
        )
        assert {problem.kind for problem in neutral.problems} <= expected
    assert abs(neutral.value - rest * 2.5) <= max(1, neutral.noise / 2) + abs(drift) * 2.5


@examples(40)
@given(rest=st.floats(1.5, 3.5), noise=st.floats(0, 0.05), seed=st.integers(0, 2**32))
def test_analog_rest_is_measured_within_half_its_noise(
    rest: float, noise: float, seed: int
) -> None:
    neutral = neutral_of(Stick(rest=rest, noise=noise, source=ANALOG), seed)
    assert not neutral.problems
    assert abs(neutral.value - rest * 204.6) <= max(1, neutral.noise / 2)


@examples(40)
@given(noise=st.floats(0.4, 15), seed=st.integers(0, 2**32))
def test_noise_is_measured_within_a_factor_of_two(noise: float, seed: int) -> None:
    neutral = neutral_of(Stick(noise=noise), seed)
    rounding = 0.25  # counts are integers
    assert noise * 2.5 / 2 <= neutral.deviation <= noise * 2.5 * 2 + rounding


@examples(40)
@given(
    twitch=st.one_of(st.floats(60, 400), st.floats(-400, -60)),
    noise=st.floats(0, 2),
    seed=st.integers(0, 2**32),
)
def test_twitch_is_reported_as_movement(twitch: float, noise: float, seed: int) -> None:
    assert kinds(Stick(twitches=twitch, noise=noise), seed) == {ProblemKind.MOVED}


@examples(40)
@example(drift=-14.0, seed=113877)
@given(drift=st.one_of(st.floats(8, 200), st.floats(-200, -8)), seed=st.integers(0, 2**32))
def test_drift_is_reported_as_movement_with_direction(drift: float, seed: int) -> None:
    (problem,) = neutral_of(Stick(drift=drift, noise=0.5), seed).problems
    assert problem.kind is ProblemKind.MOVED
    assert f"The signal drifted {'up' if drift > 0 else 'down'} by" in problem_text(problem)


@pytest.mark.parametrize("source", InputSource)
def test_drift_is_reported_only_beyond_its_limit(source: InputSource) -> None:
    def problems(drift: int) -> list[ProblemKind]:
        middle = source.highest_count // 2
        counts = [middle + step for step in (0, drift // 2, drift) for _ in range(25)]
        return [problem.kind for problem in neutral_of_counts(counts, source).problems]

    assert problems(LIMITS[source].drifted) == []
    assert problems(LIMITS[source].drifted + 1) == [ProblemKind.MOVED]


def problems_of(counts: list[int]) -> list[tuple[ProblemKind, str]]:
    problems = neutral_of_counts(counts).problems
    return [(problem.kind, problem_text(problem)) for problem in problems]


def test_twitch_is_reported_only_beyond_ten_microseconds() -> None:
    rest = [3750] * 40
    assert problems_of([*rest, *[3775] * 5, *rest]) == []
    ((kind, text),) = problems_of([*rest, *[3776] * 5, *rest])
    assert kind is ProblemKind.MOVED
    assert "between 1500 µs and 1510 µs" in text


def test_missing_signal_is_reported_with_remedy() -> None:
    (problem,) = neutral_of(Stick(connected=False)).problems
    assert problem.kind is ProblemKind.NO_SIGNAL
    assert "Is the transmitter on" in problem_text(problem)


def test_lost_pulses_are_reported_beyond_about_one_third() -> None:
    """The message gives these limits."""

    def count_reports(lost: float, noise: float = 1.0) -> int:
        neutrals = [neutral_of(Stick(lost=lost, noise=noise), seed) for seed in range(100)]
        return sum(bool(neutral.problems) for neutral in neutrals)

    assert count_reports(0.0) == count_reports(0.0, 0.8) == count_reports(0.0, 10) == 0
    assert count_reports(0.1) <= 2
    assert count_reports(0.33) >= 60
    assert count_reports(0.45) >= 95


def test_reported_share_of_lost_pulses_is_about_right() -> None:
    (problem,) = neutral_of(Stick(lost=0.45, noise=2)).problems
    share = int(problem_text(problem).removeprefix("About ").split("%")[0].strip())
    assert 30 <= share <= 60
    assert not problem.fatal


def test_outliers_are_reported_only_beyond_three_percent() -> None:
    def with_outliers(*indexes: int) -> list[int]:
        return [5100 if index in indexes else 3750 for index in range(100)]

    assert problems_of(with_outliers(20, 40, 60)) == []
    ((kind, text),) = problems_of(with_outliers(20, 40, 60, 80))
    assert kind is ProblemKind.JITTER
    assert text.startswith("Outlying pulses: 4 of 100.")


def test_single_outlier_does_not_count_as_noise() -> None:
    counts = [5100 if index == 30 else 3750 + index % 2 for index in range(80)]
    neutral = neutral_of_counts(counts)
    assert not neutral.problems
    assert neutral.noise == 1


@pytest.mark.parametrize("outliers", [1, 2])
def test_outliers_at_the_end_of_samples_are_ignored(outliers: int) -> None:
    assert problems_of([3750] * 80 + [5100] * outliers) == []


def test_excessive_noise_is_reported_with_its_size() -> None:
    assert problems_of([3594, *[3906, 3594] * 40]) == []
    ((kind, text),) = problems_of([3593, *[3907, 3593] * 40])
    assert kind is ProblemKind.NOISE
    assert text.startswith("At rest the noise is ±62.8 µs:")


@examples(40)
@example(noise=20.0, seed=312)
@given(noise=st.floats(0, 20), seed=st.integers(0, 2**32))
def test_deadband_covers_the_noise_and_its_lower_limit(noise: float, seed: int) -> None:
    neutral = neutral_of(Stick(noise=noise), seed)
    assert neutral.deadband >= max(neutral.noise, deadband_floor(InputSource.RC))
    if neutral.noise > LIMITS[InputSource.RC].noisy:
        assert any(problem.fatal for problem in neutral.problems)  # no deadband is proposed
    else:
        assert neutral.deadband <= max(deadband_floor(InputSource.RC), LIMITS[InputSource.RC].noisy)


def test_deadband_widened_because_of_noise_is_explained() -> None:
    reason = "At rest the noise is ±"
    assert not any(reason in text for text in learn(Stick(noise=0.5)).reasons)
    assert any(reason in text for text in learn(Stick(noise=12)).reasons)


def test_empty_samples_give_no_neutral() -> None:
    assert measure_neutral([], InputSource.RC) is None


def test_movement_is_reported_before_sampling_is_complete() -> None:
    neutral = neutral_of_counts([3750 + 40 * index for index in range(10)])
    assert [problem.kind for problem in neutral.problems] == [ProblemKind.MOVED]
    assert neutral.seconds_left > 0
