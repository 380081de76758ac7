"""Ends of travel that must be held, at any sample rate."""

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from tests.devices.trex.calibration import measure
from tests.devices.trex.calibration.measure import neutral_of, neutral_of_counts
from tests.support.matrix import examples
from tests.support.transmitter import RATE, Stick
from trex_gui.devices.trex.calibration.problems import ProblemKind
from trex_gui.devices.trex.calibration.proposal import Proposal, propose
from trex_gui.devices.trex.calibration.travel import WINDOW, Travel, Way
from trex_gui.devices.trex.model.learning.problem_text import problem_text
from trex_gui.devices.trex.protocol.flags import InputSource

Moves = tuple[tuple[float, float], ...]

rates = st.sampled_from([50.0, 25.0, 12.0, 5.0, 3.0, 2.0])
sticks = st.builds(
    Stick,
    rest=st.floats(1400, 1600),
    low=st.floats(900, 1150),
    high=st.floats(1850, 2100),
    noise=st.floats(0, 2),
    forward_is_down=st.booleans(),
)


def push(end: float, rise: float, hold: float, fall: float) -> Moves:
    """Return moves to an end (±1) and back. `rise`, `hold` and `fall` are seconds."""
    return (rise, end), (hold, end), (fall, 0.0)


def travel_of(stick: Stick, moves: Moves, rate: float, seed: int = 1, channel: int = 1) -> Travel:
    rest = (1.5 + WINDOW / rate, 0.0)  # long enough to measure the rate
    return measure.travel_of(stick, neutral_of(stick), channel, (rest, *moves), seed, rate)


def proposal_of(stick: Stick, travel: Travel) -> Proposal:
    return propose(neutral_of(stick), travel, reversed_now=False)


def end_tolerance(length: float, stick: Stick) -> float:
    """Return the largest distance between a learned end and the true end, in counts.

    Samples count as held while they agree within 2 % of the travel and 6 deviations. A stick that
    turns slowly at its end looks the same. Readings may differ by 4 deviations. The proposed end
    is another 1 % and 3 deviations further inside. Both distances are rounded up.
    """
    deviation = max(1.0, 2.5 * stick.noise)
    return (0.02 + 0.01) * length + (6 + 4 + 3) * deviation + 2


@examples(40)
@example(  # turns within 23 ms, so the samples at the end still agree
    stick=Stick(rest=1400, low=900, high=1850, noise=2, forward_is_down=True),
    rate=25.0,
    rise=0.90625,
    hold=0.0234375,
    fall=0.875,
    seed=901507,
)
@given(
    stick=sticks,
    rate=rates,
    rise=st.floats(0.05, 1.0),
    hold=st.floats(0.02, 2.5),
    fall=st.floats(0.05, 1.0),
    seed=st.integers(0, 2**32),
)
def test_learned_ends_match_the_true_ends_at_every_rate(
    stick: Stick, rate: float, rise: float, hold: float, fall: float, seed: int
) -> None:
    moves = push(1.0, rise, hold, fall) + push(-1.0, rise, hold, fall)
    travel = travel_of(stick, moves, rate, seed)
    proposal = proposal_of(stick, travel)
    low, neutral, high = stick.truth()
    calibration = proposal.calibration
    if calibration is None:
        assert proposal.problems
        return
    assert abs(calibration.minimum - low) <= end_tolerance(neutral - low, stick)
    assert abs(high - calibration.maximum) <= end_tolerance(high - neutral, stick)


@examples(40)
@given(stick=sticks, rate=rates, seed=st.integers(0, 2**32))
def test_holding_for_the_requested_time_is_enough(stick: Stick, rate: float, seed: int) -> None:
    samples = 3 if rate < 20 else 6  # consecutive samples that must agree
    hold = max(0.3, (samples + 1) / rate)
    moves = push(1.0, 0.2, hold, 0.2) + push(-1.0, 0.2, hold, 0.2)
    travel = travel_of(stick, moves, rate, seed)
    assert travel.is_enough
    assert travel.hold_seconds == pytest.approx(hold, abs=1.5 * (samples + 1) / RATE)
    assert proposal_of(stick, travel).calibration is not None


@pytest.mark.parametrize("rate", [50.0, 5.0])
def test_ends_passed_without_a_hold_block_the_proposal(rate: float) -> None:
    stick = Stick()
    seconds = 5 / rate
    moves = ((seconds, 1.0), (seconds, 0.0), (seconds, -1.0), (seconds, 0.0))
    travel = travel_of(stick, moves, rate)
    assert travel.has_reached(Way.UP)
    assert not travel.is_held(Way.UP)
    assert not travel.is_enough
    proposal = proposal_of(stick, travel)
    (problem,) = proposal.problems
    assert problem.kind is ProblemKind.NOT_HELD
    assert "Both ends were only passed, not held. Go back, push the stick" in problem_text(problem)
    assert proposal.calibration is None


def test_single_end_passed_without_a_hold_is_named() -> None:
    moves = (*push(1.0, 0.2, 1.2, 0.4), (0.5, -0.8), (0.5, 0.0))
    (problem,) = travel_of(Stick(), moves, 8.0).problems
    assert problem.kind is ProblemKind.NOT_HELD
    assert problem_text(problem).startswith("The low end was only passed, not held. Go back")


def test_pause_before_the_end_does_not_count_as_hold() -> None:
    pause = ((0.2, 0.7), (1.2, 0.7))
    short_push = ((0.1, 1.0), (0.2, 1.0), (0.1, 0.0), (0.5, 0.0))
    travel = travel_of(Stick(), pause, 5.0)
    assert travel.is_held(Way.UP)
    travel = travel_of(Stick(), pause + short_push, 5.0)
    assert travel.has_reached(Way.UP)
    assert not travel.is_held(Way.UP)
    travel = travel_of(Stick(), pause + short_push + push(1.0, 0.2, 1.2, 0.2), 5.0)
    assert travel.is_held(Way.UP)


def test_hold_prompt_names_the_pushed_end_until_it_is_held() -> None:
    up = ((0.4, 1.0),)
    assert travel_of(Stick(), up, 5.0).hold_direction is Way.UP
    assert travel_of(Stick(), (*up, (1.0, 1.0)), 5.0).hold_direction is None
    assert travel_of(Stick(), ((0.4, -1.0),), 5.0).hold_direction is Way.DOWN
    assert travel_of(Stick(), ((0.4, 0.0),), 5.0).hold_direction is None


def test_low_sample_rate_is_detected() -> None:
    rest = ((1.0, 0.0),)
    assert not travel_of(Stick(), rest, 50.0).is_slow
    slow = travel_of(Stick(), rest, 4.0)
    assert slow.is_slow
    assert slow.interval == pytest.approx(0.25, abs=0.02)


def test_switch_at_low_rate_must_be_held_in_position() -> None:
    switch = Stick(rest=1900, low=1100, high=1900, forward_is_down=True)
    passed = travel_of(switch, ((0.1, 1.0), (0.1, 0.0), (0.5, 0.0)), 5.0, channel=4)
    assert not passed.is_enough
    held = travel_of(switch, push(1.0, 0.1, 1.0, 0.1), 5.0, channel=4)
    assert held.is_enough


def test_time_left_counts_samples_at_low_rate() -> None:
    two_seconds = neutral_of_counts([3750] * 9, rate=4)
    assert two_seconds.seconds_left == pytest.approx(1.5)
    assert neutral_of_counts([3750] * 15, rate=4).seconds_left == 0


@pytest.mark.parametrize(
    ("volts", "words"),
    [(0.0, "it stays at 0.00 V, an end of the measuring range."), (1.3, "it stays at 1.30 V.")],
)
def test_constant_analog_input_may_be_unconnected(volts: float, words: str) -> None:
    stick = Stick(rest=volts, source=InputSource.ANALOG)
    (problem,) = travel_of(stick, ((2.0, 0.0),), 50.0).problems
    assert problem.kind is ProblemKind.NEVER_MOVED
    assert words in problem_text(problem)
    assert "Either nothing is connected to this input" in problem_text(problem)
    assert "was not moved" in problem_text(problem)


def test_noisy_analog_input_may_be_unconnected() -> None:
    (problem,) = neutral_of(Stick(rest=2.0, noise=0.4, source=InputSource.ANALOG)).problems
    assert problem.kind is ProblemKind.NOISE
    assert "An unconnected input behaves in the same way." in problem_text(problem)
    (problem,) = neutral_of(Stick(noise=60)).problems
    assert "unconnected" not in problem_text(problem)
