"""From the ends that a stick reached to the calibration that fits it."""

from hypothesis import given, settings
from hypothesis import strategies as st

from tests.learning.measure import learn, neutral_of, travel_of
from tests.support.people import HOLD, Stick
from trex_gui.learning.problems import Kind
from trex_gui.learning.proposal import check
from trex_gui.learning.travel import Way
from trex_gui.protocol.calibration import Calibration, remap
from trex_gui.protocol.flags import InputSource

unhurried = settings(deadline=None)

sticks = st.builds(
    Stick,
    rest=st.floats(1380, 1620),
    low=st.floats(850, 1200),
    high=st.floats(1800, 2150),
    noise=st.floats(0, 1.0),
    lost=st.floats(0, 0.05),
    spikes=st.floats(0, 0.004),
    forward_is_down=st.booleans(),
)


def bound(stick: Stick) -> float:
    """One percent of the travel, and what the noise makes uncertain, in counts."""
    low, _, high = stick.truth()
    return 0.01 * (high - low) + 5 * max(1.0, stick.noise * stick.source.counts_per_unit)


@unhurried
@given(stick=sticks, seed=st.integers(0, 2**32))
def test_the_ends_are_found_within_one_percent_of_the_travel(stick: Stick, seed: int) -> None:
    found = learn(stick, seed=seed).calibration
    assert found is not None
    assert found.problem() is None
    low, neutral, high = stick.truth()
    assert 0 < found.minimum - low <= bound(stick)
    assert 0 < high - found.maximum <= bound(stick)
    assert abs(found.neutral - neutral) <= max(1.0, 2.5 * stick.noise)


@unhurried
@given(stick=sticks, seed=st.integers(0, 2**32))
def test_full_output_is_surely_reached_and_none_at_rest(stick: Stick, seed: int) -> None:
    proposal = learn(stick, seed=seed)
    assert proposal.calibration is not None
    low, neutral, high = stick.truth()
    noise = 2 * stick.noise * 2.5
    assert remap(round(high - noise), proposal.calibration) == 127
    assert remap(round(low + noise), proposal.calibration) == -127
    assert remap(round(neutral + noise), proposal.calibration) == 0
    assert remap(round(neutral - noise), proposal.calibration) == 0


@unhurried
@given(stick=sticks, now=st.booleans(), seed=st.integers(0, 2**32))
def test_reversed_is_suggested_when_forward_is_down(stick: Stick, now: bool, seed: int) -> None:
    proposal = learn(stick, seed=seed, reversed_now=now)
    assert proposal.reversed_ is stick.forward_is_down
    assert bool(proposal.reversed_reason) is (stick.forward_is_down != now)


@unhurried
@given(low=st.floats(0.2, 1.5), high=st.floats(3.5, 4.8), seed=st.integers(0, 2**32))
def test_a_joystick_is_learned_within_one_percent_of_its_travel(
    low: float, high: float, seed: int
) -> None:
    stick = Stick(rest=2.5, low=low, high=high, noise=0.004, source=InputSource.ANALOG)
    found = learn(stick, seed=seed).calibration
    assert found is not None
    minimum, _, maximum = stick.truth()
    assert 0 < found.minimum - minimum <= bound(stick)
    assert 0 < maximum - found.maximum <= bound(stick)


@unhurried
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
def test_whatever_comes_in_the_board_takes_it_or_it_is_said_why_not(
    stick: Stick, channel: int, seed: int
) -> None:
    proposal = learn(stick, channel, seed=seed)
    if proposal.calibration is None:
        assert any(problem.fatal for problem in proposal.problems)
    else:
        assert proposal.calibration.problem() is None
    assert all(problem.text.endswith((".", "?")) for problem in proposal.problems)


def kinds(
    stick: Stick, channel: int = 1, moves: tuple[tuple[float, float], ...] = HOLD
) -> list[Kind]:
    return [problem.kind for problem in learn(stick, channel, moves).problems]


ONLY_UP = ((0.3, 1.0), (0.3, 1.0), (0.3, 0.0), (0.3, 0.0))


def test_a_stick_that_never_moves_is_told() -> None:
    assert kinds(Stick(noise=1), moves=((2.0, 0.0),)) == [Kind.NEVER_MOVED]


def test_a_stick_that_hardly_moves_is_told_with_what_it_needs() -> None:
    (problem,) = learn(Stick(low=1450, high=1550)).problems
    assert problem.kind is Kind.TOO_LITTLE
    assert "81 µs are needed" in problem.text
    assert "127 speeds" in problem.text


def test_one_direction_only_is_told() -> None:
    assert kinds(Stick(), moves=ONLY_UP) == [Kind.ONE_DIRECTION]


def test_an_end_too_near_is_told() -> None:
    assert kinds(Stick(low=1440)) == [Kind.END_TOO_NEAR]


def test_a_rest_that_is_not_between_the_ends_is_told() -> None:
    neutral = neutral_of(Stick())
    moved = Stick(rest=1700, low=1650, high=2000)
    travel = travel_of(moved, neutral)
    assert [problem.kind for problem in travel.problems] == [Kind.NEUTRAL_OUTSIDE]


def test_an_uneven_travel_is_worth_a_word_and_no_more() -> None:
    proposal = learn(Stick(low=1300))
    assert [problem.kind for problem in proposal.problems] == [Kind.UNEVEN]
    assert proposal.calibration is not None


def test_wild_pulses_make_no_end() -> None:
    stick = Stick(spikes=0.02)
    travel = travel_of(stick, neutral_of(Stick()), seed=5)
    assert abs((travel.high or 0) - 5000) <= 2
    assert abs((travel.low or 0) - 2500) <= 2


def test_a_signal_that_goes_while_it_moves_is_told() -> None:
    travel = travel_of(Stick(lost=0.7), neutral_of(Stick()), moves=HOLD * 3)
    assert Kind.JITTER in [problem.kind for problem in travel.problems]


def test_each_direction_is_ticked_when_it_was_reached() -> None:
    travel = travel_of(Stick(), neutral_of(Stick()), moves=ONLY_UP)
    assert travel.reached(Way.UP)
    assert not travel.reached(Way.DOWN)
    assert travel.first is Way.UP
    assert not travel.is_enough


def test_a_two_way_switch_that_rests_high_needs_no_middle() -> None:
    switch = Stick(rest=1900, low=1100, high=1900, forward_is_down=True)
    proposal = learn(switch, channel=4)
    assert proposal.problems == ()
    found = proposal.calibration
    assert found is not None
    assert found.neutral == 4750
    assert (found.minimum + found.neutral) / 2 == 3760 + (found.minimum - 2770) / 2
    assert not proposal.reversed_


def test_a_switch_that_rests_low_is_reversed_to_be_off_at_rest() -> None:
    proposal = learn(Stick(rest=1100, low=1100, high=1900), channel=5)
    assert proposal.problems == ()
    assert proposal.reversed_
    assert "at rest" in proposal.reversed_reason
    assert proposal.calibration is not None
    assert proposal.calibration.problem() is None


def test_a_switch_with_three_positions_stays_as_it_is() -> None:
    proposal = learn(Stick(rest=1500, low=1100, high=1900), channel=4, reversed_now=True)
    assert proposal.problems == ()
    assert proposal.reversed_
    assert not proposal.reversed_reason


def test_a_throttle_on_channel_3_may_rest_at_its_end() -> None:
    proposal = learn(Stick(rest=1000, low=1000, high=2000), channel=3)
    assert proposal.problems == ()
    assert proposal.calibration is not None
    assert remap(5000 - 12, proposal.calibration) == 127
    assert remap(2500, proposal.calibration) == 0


def test_a_deadband_below_the_noise_is_told() -> None:
    neutral = neutral_of(Stick(noise=10))
    (problem,) = check(Calibration(2500, 3750, 5000, 5), neutral)
    assert problem.kind is Kind.NOISE
    assert not problem.fatal
    assert check(Calibration(2500, 3750, 5000, 75), neutral) == ()


def test_values_that_the_board_refuses_are_told() -> None:
    (problem,) = check(Calibration(3800, 3750, 5000, 5), None)
    assert problem.kind is Kind.REFUSED
    assert "minimum 3800 is above neutral 3750" in problem.text
