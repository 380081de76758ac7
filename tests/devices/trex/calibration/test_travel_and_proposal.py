"""Travel of sticks and proposed calibrations."""

from dataclasses import replace

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from tests.devices.trex.calibration.measure import (
    HIGH_THROTTLE,
    THROTTLE,
    check,
    learn,
    neutral_of,
    travel_of,
)
from tests.support.matrix import examples
from tests.support.transmitter import HOLD, Stick
from trex_gui.devices.trex.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.calibration.neutral import ChannelSample
from trex_gui.devices.trex.calibration.problems import ProblemKind
from trex_gui.devices.trex.calibration.proposal import Proposal, propose
from trex_gui.devices.trex.calibration.travel import WINDOW, Task, Travel, Way, least_travel
from trex_gui.devices.trex.model.learning.channels import Check
from trex_gui.devices.trex.model.learning.problem_text import problem_text
from trex_gui.devices.trex.protocol.calibration import Calibration, remap
from trex_gui.devices.trex.protocol.flags import InputSource

# The board repeats the last value while pulses are lost. An outlier before lost pulses would look
# like an end that is held, so a stick has either outliers or lost pulses.
sticks = st.builds(
    lambda stick, lost, spikes: replace(stick, **({"lost": lost} if lost else {"spikes": spikes})),
    st.builds(
        Stick,
        rest=st.floats(1380, 1620),
        low=st.floats(850, 1200),
        high=st.floats(1800, 2150),
        noise=st.floats(0, 1.0),
        forward_is_down=st.booleans(),
    ),
    lost=st.sampled_from([0.0, 0.01, 0.05]),
    spikes=st.floats(0, 0.004),
)


def learn_good_stick(stick: Stick, seed: int, *, reversed_now: bool = False) -> Proposal:
    """Learn channel 1 from a stick whose rest position has no fatal problem."""
    assume(not any(problem.fatal for problem in neutral_of(stick, seed).problems))
    return learn(stick, seed=seed, reversed_now=reversed_now)


def tolerance(stick: Stick) -> float:
    """Return the tolerance in counts: one percent of the travel, plus the noise."""
    low, _, high = stick.truth()
    return 0.01 * (high - low) + 5 * max(1.0, stick.noise * stick.source.counts_per_unit)


@examples(40)
@given(stick=sticks, seed=st.integers(0, 2**32))
def test_ends_are_measured_within_one_percent_of_travel(stick: Stick, seed: int) -> None:
    calibration = learn_good_stick(stick, seed).calibration
    assert calibration is not None
    assert calibration.problem() is None
    low, neutral, high = stick.truth()
    assert 0 < calibration.minimum - low <= tolerance(stick)
    assert 0 < high - calibration.maximum <= tolerance(stick)
    assert abs(calibration.neutral - neutral) <= max(1.0, 2.5 * stick.noise)


@examples(40)
@given(stick=sticks, seed=st.integers(0, 2**32))
def test_calibration_gives_full_output_at_ends_and_0_at_rest(stick: Stick, seed: int) -> None:
    proposal = learn_good_stick(stick, seed)
    assert proposal.calibration is not None
    low, neutral, high = stick.truth()
    noise = 2 * stick.noise * 2.5
    assert remap(round(high - noise), proposal.calibration) == 127
    assert remap(round(low + noise), proposal.calibration) == -127
    assert remap(round(neutral + noise), proposal.calibration) == 0
    assert remap(round(neutral - noise), proposal.calibration) == 0


@examples(40)
@given(stick=sticks, reversed_now=st.booleans(), seed=st.integers(0, 2**32))
def test_reversed_is_suggested_when_forward_is_down(
    stick: Stick, reversed_now: bool, seed: int
) -> None:
    proposal = learn_good_stick(stick, seed, reversed_now=reversed_now)
    assert proposal.reversed_ is stick.forward_is_down
    suggested = "should be reversed." if stick.forward_is_down else "should not be reversed."
    changes = stick.forward_is_down != reversed_now
    assert proposal.reversed_reason.endswith(suggested if changes else "")
    assert bool(proposal.reversed_reason) is changes


@examples(40)
@given(low=st.floats(0.2, 1.5), high=st.floats(3.5, 4.8), seed=st.integers(0, 2**32))
def test_analog_ends_are_measured_within_one_percent_of_travel(
    low: float, high: float, seed: int
) -> None:
    stick = Stick(rest=2.5, low=low, high=high, noise=0.004, source=InputSource.ANALOG)
    calibration = learn(stick, seed=seed).calibration
    assert calibration is not None
    minimum, _, maximum = stick.truth()
    assert 0 < calibration.minimum - minimum <= tolerance(stick)
    assert 0 < maximum - calibration.maximum <= tolerance(stick)


@examples(40)
@given(
    stick=st.builds(
        Stick,
        rest=st.floats(700, 2300),
        low=st.floats(600, 2400),
        high=st.floats(600, 2400),
        noise=st.floats(0, 80),
        drift=st.floats(-30, 30),
        lost=st.floats(0, 1),
        spikes=st.floats(0, 0.3),
        twitches=st.floats(-100, 100),
        connected=st.booleans(),
    ),
    channel=st.integers(1, 5),
    seed=st.integers(0, 2**32),
)
def test_any_signal_gives_valid_calibration_or_fatal_problem(
    stick: Stick, channel: int, seed: int
) -> None:
    proposal = learn(stick, channel, seed=seed)
    if proposal.calibration is None:
        assert any(problem.fatal for problem in proposal.problems)
    else:
        assert proposal.calibration.problem() is None
    assert all(problem_text(problem).endswith((".", "?")) for problem in proposal.problems)


ONLY_UP = ((0.3, 1.0), (0.3, 1.0), (0.3, 0.0), (0.3, 0.0))


@pytest.mark.parametrize(
    ("stick", "moves", "kind"),
    [
        (Stick(noise=1), ((2.0, 0.0),), ProblemKind.NEVER_MOVED),
        (Stick(), ONLY_UP, ProblemKind.ONE_DIRECTION),
        (Stick(low=1440), HOLD, ProblemKind.END_TOO_NEAR),
        (Stick(low=1300), HOLD, ProblemKind.UNEVEN),
    ],
)
def test_unsuitable_travel_is_reported(
    stick: Stick, moves: tuple[tuple[float, float], ...], kind: ProblemKind
) -> None:
    proposal = learn(stick, moves=moves)
    assert [problem.kind for problem in proposal.problems] == [kind]
    if kind is ProblemKind.UNEVEN:
        assert proposal.calibration is not None


def test_too_little_travel_is_reported_with_required_travel() -> None:
    (problem,) = learn(Stick(low=1450, high=1550)).problems
    assert problem.kind is ProblemKind.TOO_LITTLE
    assert "81 µs is needed" in problem_text(problem)
    assert "127 speeds" in problem_text(problem)


def test_neutral_outside_travel_is_reported() -> None:
    neutral = neutral_of(Stick())
    travel = travel_of(Stick(rest=1700, low=1650, high=2000), neutral)
    assert [problem.kind for problem in travel.problems] == [ProblemKind.NEUTRAL_OUTSIDE]


def test_outliers_do_not_extend_the_travel() -> None:
    travel = travel_of(Stick(spikes=0.02), neutral_of(Stick()), seed=5)
    assert abs(travel.end(Way.UP) - 5000) <= 2
    assert abs(travel.end(Way.DOWN) - 2500) <= 2


def travel_of_counts(counts: list[int | None]) -> Travel:
    """Return the travel of a stick that rests at 3750 and gives 50 counts a second."""
    travel = Travel(neutral_of(Stick()), Task.STICK)
    for index, count in enumerate(counts):
        travel.feed(ChannelSample(index / 50, count))
    return travel


def test_outlier_before_lost_pulses_is_not_an_end() -> None:
    """The board repeats the outlier for each lost pulse, for up to 100 ms."""
    outlier: list[int | None] = [*[5600] * 5, *[3750] * 20]
    at_rest = travel_of_counts([*[3750] * 20, *outlier])
    assert at_rest.end(Way.UP) == 3750
    pushed = travel_of_counts([*[5000] * 15, *[2500] * 15, *outlier])
    assert pushed.end(Way.UP) == 5000
    assert pushed.is_enough


def problems_with_lost_samples(lost: int) -> list[tuple[ProblemKind, str]]:
    """Push a stick to both ends. `lost` is the number without signal among 50 samples."""
    travel = travel_of_counts([*[None] * lost, *[5000] * 15, *[2500] * (35 - lost)])
    return [(problem.kind, problem_text(problem)) for problem in travel.problems]


def test_lost_samples_are_reported_only_beyond_ten_percent() -> None:
    assert problems_with_lost_samples(5) == []
    ((kind, text),) = problems_with_lost_samples(6)
    assert kind is ProblemKind.JITTER
    assert "12\u00a0% of the samples had no valid pulse" in text


def test_no_signal_is_reported_if_most_samples_are_lost() -> None:
    assert [kind for kind, _ in problems_with_lost_samples(25)] == [ProblemKind.JITTER]
    assert [kind for kind, _ in problems_with_lost_samples(26)] == [ProblemKind.NO_SIGNAL]


def test_first_end_is_known_once_travel_is_enough() -> None:
    required = least_travel(neutral_of(Stick()).deadband)
    assert travel_of_counts([3750 - required + 1] * WINDOW).first is None
    assert travel_of_counts([3750 - required] * WINDOW).first is Way.DOWN


def test_only_the_travelled_direction_counts_as_reached() -> None:
    travel = travel_of(Stick(), neutral_of(Stick()), moves=ONLY_UP)
    assert travel.has_reached(Way.UP)
    assert not travel.has_reached(Way.DOWN)
    assert travel.first is Way.UP
    assert not travel.is_enough


def test_two_position_switch_resting_high_needs_no_middle() -> None:
    switch = Stick(rest=1900, low=1100, high=1900, forward_is_down=True)
    proposal = learn(switch, channel=4)
    assert proposal.problems == ()
    calibration = proposal.calibration
    assert calibration is not None
    assert calibration.neutral == 4750
    assert 0 < calibration.minimum - 2750 <= tolerance(switch)
    assert not proposal.reversed_


def test_switch_resting_low_is_reversed_to_be_off_at_rest() -> None:
    proposal = learn(THROTTLE, channel=5)
    assert proposal.problems == ()
    assert proposal.reversed_
    assert "than at rest" in proposal.reversed_reason
    assert proposal.calibration is not None
    assert proposal.calibration.problem() is None


def test_three_position_switch_retains_its_direction() -> None:
    proposal = learn(Stick(rest=1500, low=1100, high=1900), channel=4, reversed_now=True)
    assert proposal.problems == ()
    assert proposal.reversed_
    assert not proposal.reversed_reason


def test_throttle_on_channel_3_may_rest_at_its_end() -> None:
    proposal = learn(Stick(rest=1000, low=1000, high=2000), channel=3)
    assert proposal.problems == ()
    assert proposal.calibration is not None
    assert remap(5000 - 12, proposal.calibration) == 127
    assert remap(2500, proposal.calibration) == 0


@pytest.mark.parametrize("stick", [THROTTLE, HIGH_THROTTLE])
def test_trim_beyond_throttle_rest_gives_low_auxiliary_speed(stick: Stick) -> None:
    calibration = learn(stick, channel=3).calibration
    assert calibration is not None
    trim = -250 if stick.rest < 1500 else 250
    assert abs(remap(round(stick.rest * 2.5) + trim, calibration)) <= 25
    assert abs(remap(round(stick.rest * 2.5) + trim * 6 // 10, calibration)) <= 10


def test_throttle_end_at_rest_is_set_to_the_input_limit() -> None:
    low = learn(THROTTLE, channel=3).calibration
    high = learn(HIGH_THROTTLE, channel=3).calibration
    assert low is not None
    assert high is not None
    assert (low.minimum, high.maximum) == (1250, 6250)  # 0.5 ms and 2.5 ms


def test_analog_throttle_calibration_extends_beyond_its_rest() -> None:
    stick = Stick(rest=1.0, low=1.0, high=4.5, source=InputSource.ANALOG)
    calibration = learn(stick, channel=3).calibration
    assert calibration is not None
    assert calibration.minimum == 0
    stick = Stick(rest=4.0, low=0.5, high=4.0, source=InputSource.ANALOG, forward_is_down=True)
    calibration = learn(stick, channel=3).calibration
    assert calibration is not None
    assert remap(1023, calibration) < 127


@examples(40)
@given(rest=st.floats(600, 2400), seed=st.integers(0, 2**32))
def test_throttle_output_stays_low_just_beyond_the_rest(rest: float, seed: int) -> None:
    end = 2400.0 if rest < 1500 else 600.0
    stick = Stick(rest=rest, low=min(rest, end), high=max(rest, end), forward_is_down=rest > end)
    calibration = learn(stick, channel=3, seed=seed).calibration
    assert calibration is not None
    assert abs(remap(round(rest * 2.5) + (-150 if rest < end else 150), calibration)) <= 20


def test_full_speed_beyond_throttle_rest_is_reported() -> None:
    (problem,) = check(THROTTLE, 3, Calibration(2600, 2750, 4700, 75)).problems
    assert problem.kind is ProblemKind.SPEEDS_UP
    assert "to 127 of 127" in problem_text(problem)
    stick = Stick(rest=0.3, low=0.3, high=4.5, source=InputSource.ANALOG)
    (problem,) = check(stick, 3).problems
    assert "at 0.00 V, to 127 of 127" in problem_text(problem)
    assert "broken wire" in problem_text(problem)


def test_deadband_below_noise_is_reported() -> None:
    (problem,) = check(Stick(noise=10), 1, Calibration(2550, 3750, 4950, 5)).problems
    assert problem.kind is ProblemKind.NOISE
    assert not problem.fatal
    assert check(Stick(noise=10), 1, Calibration(2550, 3750, 4950, 75)).problems == ()


@pytest.mark.parametrize(
    ("channel", "points", "words"),
    [
        (1, (2550, 3750, 4950, 3000), "reaches minimum and maximum: no output between"),
        (1, (3700, 3750, 4950, 75), "reaches minimum: no output between 0 and"),
        (1, (1000, 3750, 4950, 75), "Minimum (400 µs) is outside the input"),
        (1, (2550, 3750, 5050, 75), "Maximum is beyond 2000 µs, the farthest value reached"),
        (1, (2450, 3750, 4950, 75), "Minimum is beyond 1000 µs, the farthest value reached"),
        (1, (2550, 3500, 4950, 75), "The stick rests at 1500 µs: with this neutral, the output"),
        (3, (1250, 2750, 4700, 3000), "reaches maximum: no output between 0 and full"),
    ],
)
def test_unsuitable_calibration_is_reported(
    channel: int, points: tuple[int, int, int, int], words: str
) -> None:
    stick = THROTTLE if channel == 3 else Stick()
    problems = check(stick, channel, Calibration(*points)).problems
    assert words in " ".join(problem_text(problem) for problem in problems)


@pytest.mark.parametrize("channel", [1, 3, 4])
def test_proposed_calibration_has_no_problems(channel: int) -> None:
    stick = Stick() if channel == 1 else THROTTLE
    assert check(stick, channel).problems == ()


# --- Switches ---------------------------------------------------------------------------


def test_switching_point_is_described_as_inferred() -> None:
    text = check(THROTTLE, 5).remark
    assert "Active above 1495 µs, halfway between neutral and maximum (inferred)" in text
    assert text.endswith("At rest the switch is off.")


def test_unreversed_switch_resting_low_is_reported() -> None:
    (problem,) = check(THROTTLE, 5, reversed_=False).problems
    assert problem.kind is ProblemKind.NEVER_SWITCHES
    assert "The switch is inactive in all its positions" in problem_text(problem)
    assert "Should the channel be reversed" in problem_text(problem)


def test_switch_resting_at_its_switching_point_is_reported() -> None:
    problems = check(THROTTLE, 5, Calibration(2700, 2750, 4700, 75), reversed_=False).problems
    assert ProblemKind.SWITCHES_AT_REST in [problem.kind for problem in problems]


# --- Sticks that are held off their rest position ---------------------------------------


@examples(40)
@given(off=st.floats(0.1, 0.3), up=st.booleans(), seed=st.integers(0, 2**32))
def test_stick_held_off_rest_while_sampled_is_reported(off: float, up: bool, seed: int) -> None:
    stick = Stick(noise=0.5)
    neutral = neutral_of(replace(stick, rest=stick.value(off if up else -off)), seed)
    travel = travel_of(stick, neutral, moves=(*HOLD, (0.5, 0.0)), seed=seed)
    assert abs(travel.rest - 3750) <= 3
    proposed = propose(neutral, travel, reversed_now=False).calibration
    assert proposed is not None
    (problem,) = Check(1, ChannelCurve(proposed), neutral, travel).problems
    assert problem.kind is ProblemKind.NEUTRAL_MOVED
    assert problem_text(problem).startswith("After release the stick rests at 1500 µs, not at ")
    assert "sample the channel again, or use the new rest" in problem_text(problem)
    corrected = replace(proposed, neutral=travel.rest)
    assert Check(1, ChannelCurve(corrected), neutral, travel).problems == ()


@pytest.mark.parametrize("held", [1.0, -1.0, 0.7])
def test_stick_held_off_rest_after_travel_retains_neutral(held: float) -> None:
    neutral = neutral_of(Stick())
    travel = travel_of(Stick(), neutral, moves=(*HOLD, (0.5, held), (0.5, held)))
    assert travel.settled is not None
    assert travel.rest == neutral.value
    travel = travel_of(Stick(), neutral, moves=(*HOLD, (1.0, 0.4 * held)))
    assert travel.settled is None, "the stick moves"


def test_noisy_stick_settles_after_its_release() -> None:
    stick = Stick(noise=12)
    travel = travel_of(stick, neutral_of(stick), moves=(*HOLD, (0.5, 0.0)))
    assert travel.settled == pytest.approx(3750, abs=15)


# --- Sticks with two axes ---------------------------------------------------------------


@pytest.mark.parametrize("amplitude", [0.2, 0.35, 0.5])
@pytest.mark.parametrize("forward_is_down", [False, True])
def test_crosstalk_of_the_other_axis_does_not_affect_reversal(
    amplitude: float, forward_is_down: bool
) -> None:
    stick = Stick(forward_is_down=forward_is_down)
    crosstalk = (
        (0.2, -amplitude),
        (0.3, -amplitude),
        (0.3, amplitude),
        (0.3, amplitude),
        (0.2, 0.0),
    )
    assert learn(stick, moves=(*crosstalk, *HOLD)).reversed_ is forward_is_down
