"""Ends count only after a hold, at any sample rate."""

from random import Random

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from tests.devices.trex.calibration.measure import neutral_of
from tests.support.matrix import examples
from tests.support.transmitter import RATE, Stick
from trex_gui.devices.trex.calibration.neutral import ChannelSample, measure_neutral
from trex_gui.devices.trex.calibration.problems import ProblemKind
from trex_gui.devices.trex.calibration.proposal import Proposal, propose
from trex_gui.devices.trex.calibration.travel import TASKS, WINDOW, Task, Travel, Way
from trex_gui.devices.trex.model.learning.problem_text import problem_text
from trex_gui.devices.trex.protocol.flags import InputSource

modest = examples(40)

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


def push(way: float, there: float, hold: float, back: float) -> Moves:
    return (there, way), (hold, way), (back, 0.0)


def travel_of(
    stick: Stick, moves: Moves, rate: float, seed: int = 1, task: Task = Task.STICK
) -> Travel:
    travel = Travel(neutral_of(stick), task)
    moves = ((1.5 + WINDOW / rate, 0.0), *moves)  # so long that the rate is known
    for sample in stick.samples(moves, Random(seed), 10.0, rate):
        travel.feed(sample)
    return travel


def proposal_of(stick: Stick, travel: Travel) -> Proposal:
    return propose(neutral_of(stick), travel, reversed_now=False)


def furthest_inside(length: float, stick: Stick) -> float:
    """Return the largest distance of a learned end inside the true end, in counts.

    Samples count as held while they agree within 2 % of the travel and 6 deviations. A stick that
    turns slowly there looks the same. Readings may be off by 4 deviations, and the proposal lies
    another 1 % and 3 deviations inside. Both round up.
    """
    deviation = max(1.0, 2.5 * stick.noise)
    return (0.02 + 0.01) * length + (6 + 4 + 3) * deviation + 2


@modest
@example(  # turns at the end in 23 ms, so slowly that the samples agree within their tolerance
    stick=Stick(rest=1400, low=900, high=1850, noise=2, forward_is_down=True),
    rate=25.0,
    there=0.90625,
    hold=0.0234375,
    back=0.875,
    seed=901507,
)
@given(
    stick=sticks,
    rate=rates,
    there=st.floats(0.05, 1.0),
    hold=st.floats(0.02, 2.5),
    back=st.floats(0.05, 1.0),
    seed=st.integers(0, 2**32),
)
def test_learned_ends_match_true_ends_at_every_rate(
    stick: Stick, rate: float, there: float, hold: float, back: float, seed: int
) -> None:
    moves = push(1.0, there, hold, back) + push(-1.0, there, hold, back)
    travel = travel_of(stick, moves, rate, seed)
    proposal = proposal_of(stick, travel)
    low, neutral, high = stick.truth()
    found = proposal.calibration
    if found is None:
        assert proposal.problems
        return
    assert abs(found.minimum - low) <= furthest_inside(neutral - low, stick)
    assert abs(high - found.maximum) <= furthest_inside(high - neutral, stick)


@modest
@given(stick=sticks, rate=rates, seed=st.integers(0, 2**32))
def test_holding_for_requested_time_is_enough(stick: Stick, rate: float, seed: int) -> None:
    agreeing = 3 if rate < 20 else 6  # samples in a row
    hold = max(0.3, (agreeing + 1) / rate)
    moves = push(1.0, 0.2, hold, 0.2) + push(-1.0, 0.2, hold, 0.2)
    travel = travel_of(stick, moves, rate, seed)
    assert travel.is_enough
    assert travel.hold_seconds == pytest.approx(hold, abs=1.5 * (agreeing + 1) / RATE)
    assert proposal_of(stick, travel).calibration is not None


@pytest.mark.parametrize("rate", [50.0, 5.0])
def test_ends_only_passed_are_reported_and_block_proposal(rate: float) -> None:
    stick = Stick()
    slowly = 2.5 / rate * 2
    moves = ((slowly, 1.0), (slowly, 0.0), (slowly, -1.0), (slowly, 0.0))
    travel = travel_of(stick, moves, rate)
    assert travel.reached(Way.UP)
    assert not travel.held(Way.UP)
    assert not travel.is_enough
    proposal = proposal_of(stick, travel)
    assert [problem.kind for problem in proposal.problems] == [ProblemKind.NOT_HELD]
    assert "Both ends were only passed, not held. Go back, push the stick" in problem_text(
        proposal.problems[0]
    )
    assert proposal.calibration is None


def test_single_end_only_passed_is_named() -> None:
    moves = (*push(1.0, 0.2, 1.2, 0.4), (0.5, -0.8), (0.5, 0.0))
    (problem,) = travel_of(Stick(), moves, 8.0).problems
    assert problem.kind is ProblemKind.NOT_HELD
    assert problem_text(problem).startswith("The low end was only passed, not held. Go back")


def test_pause_short_of_end_is_discarded_after_further_travel() -> None:
    pause = ((0.2, 0.7), (1.2, 0.7))
    flick = ((0.1, 1.0), (0.2, 1.0), (0.1, 0.0), (0.5, 0.0))
    travel = travel_of(Stick(), pause, 5.0)
    assert travel.held(Way.UP)
    travel = travel_of(Stick(), pause + flick, 5.0)
    assert travel.reached(Way.UP)
    assert not travel.held(Way.UP)
    again = ((0.2, 1.0), (1.2, 1.0), (0.2, 0.0))
    travel = travel_of(Stick(), pause + flick + again, 5.0)
    assert travel.held(Way.UP)


def test_hold_prompt_names_pushed_end_until_held() -> None:
    up = ((0.4, 1.0),)
    assert travel_of(Stick(), up, 5.0).to_hold is Way.UP
    assert travel_of(Stick(), (*up, (1.0, 1.0)), 5.0).to_hold is None
    assert travel_of(Stick(), ((0.4, -1.0),), 5.0).to_hold is Way.DOWN
    assert travel_of(Stick(), ((0.4, 0.0),), 5.0).to_hold is None


def test_low_sample_rate_is_detected_as_slow() -> None:
    still = ((1.0, 0.0),)
    assert not travel_of(Stick(), still, 50.0).is_slow
    slow = travel_of(Stick(), still, 4.0)
    assert slow.is_slow
    assert slow.interval == pytest.approx(0.25, abs=0.02)


def test_switch_at_low_rate_must_be_held_in_position() -> None:
    switch = Stick(rest=1900, low=1100, high=1900, forward_is_down=True)
    assert TASKS[4] is Task.SWITCH
    flick = travel_of(switch, ((0.1, 1.0), (0.1, 0.0), (0.5, 0.0)), 5.0, task=Task.SWITCH)
    assert not flick.is_enough
    held = travel_of(switch, ((0.1, 1.0), (1.0, 1.0), (0.1, 0.0)), 5.0, task=Task.SWITCH)
    assert held.is_enough


def test_time_left_counts_samples_at_low_rate() -> None:
    samples = [ChannelSample(index / 4, 3750) for index in range(9)]  # two seconds
    found = measure_neutral(samples, InputSource.RC)
    assert found is not None
    assert found.seconds_left == pytest.approx(1.5)
    samples = [ChannelSample(index / 4, 3750) for index in range(15)]
    found = measure_neutral(samples, InputSource.RC)
    assert found is not None
    assert found.seconds_left == 0


@pytest.mark.parametrize(
    ("volts", "words"),
    [(0.0, "it stays at 0.00 V, an end of the measuring range."), (1.3, "it stays at 1.30 V.")],
)
def test_still_analog_input_is_reported_as_maybe_unconnected(volts: float, words: str) -> None:
    stick = Stick(rest=volts, source=InputSource.ANALOG)
    (problem,) = travel_of(stick, ((2.0, 0.0),), 50.0).problems
    assert problem.kind is ProblemKind.NEVER_MOVED
    assert words in problem_text(problem)
    assert "Either nothing is connected to this input" in problem_text(problem)
    assert "was not moved" in problem_text(problem)


def test_noisy_analog_input_is_reported_as_maybe_unconnected() -> None:
    found = neutral_of(Stick(rest=2.0, noise=0.4, source=InputSource.ANALOG))
    (problem,) = found.problems
    assert problem.kind is ProblemKind.NOISE
    assert "An unconnected input behaves in the same way." in problem_text(problem)
    (problem,) = neutral_of(Stick(noise=60)).problems
    assert "unconnected" not in problem_text(problem)
