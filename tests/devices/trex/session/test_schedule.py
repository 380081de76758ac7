"""Schedule of polls at given times."""

import math
from collections import Counter
from collections.abc import Mapping

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support.matrix import examples
from trex_gui.devices.trex.client.telemetry import (
    POLLED,
    Currents,
    LatchedStatus,
    ModeSample,
    Raw,
    Remapped,
)
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.session.polling import Schedule, Topic, rates

modest = examples(40)
any_rates = st.dictionaries(
    st.sampled_from(list(POLLED)), st.floats(1.0, 100.0), min_size=1, max_size=6
)


def simulate(
    poll_rates: Mapping[Topic, float], cost: Mapping[Topic, float], seconds: float
) -> Counter[Topic]:
    """Run the schedule. Return the number of polls by topic. `cost`: seconds of a poll by topic."""
    schedule = Schedule()
    schedule.start(poll_rates, 0.0)
    now, polled = 0.0, Counter[Topic]()
    while now < seconds:
        topic = schedule.next(now)
        if topic is None:
            now += max(schedule.seconds_to_next(now), 1e-6)
            continue
        schedule.record_poll(topic, now)
        polled[topic] += 1
        now += cost[topic]
    return polled


def costs(baud: int) -> dict[Topic, float]:
    """Return the seconds of a poll by topic, without device number and CRC."""
    queries = {topic: value.query for topic, value in POLLED.items()}
    return {
        topic: (1 + query.data_size + query.reply_size()) * 10 / baud
        for topic, query in queries.items()
    }


def test_unstarted_schedule_has_no_next_topic() -> None:
    schedule = Schedule()
    assert schedule.next(5.0) is None
    assert schedule.seconds_to_next(5.0) == math.inf


def test_every_topic_is_due_at_start() -> None:
    schedule = Schedule()
    schedule.start(rates(InputSource.RC), 10.0)
    polled = set()
    while topic := schedule.next(10.0):
        polled.add(topic)
        schedule.record_poll(topic, 10.0)
    assert polled == POLLED.keys()


def test_topic_is_not_due_before_its_period() -> None:
    schedule = Schedule()
    schedule.start({ModeSample: 2.0}, 0.0)
    schedule.record_poll(ModeSample, 0.0)
    assert schedule.next(0.49) is None
    assert schedule.seconds_to_next(0.1) == pytest.approx(0.4)
    assert schedule.next(0.5) is ModeSample
    assert schedule.seconds_to_next(0.7) == 0.0


def test_restart_discards_earlier_topics() -> None:
    schedule = Schedule()
    schedule.start({ModeSample: 1.0, Raw: 50.0}, 0.0)
    schedule.start({LatchedStatus: 10.0}, 1.0)
    assert schedule.next(1.0) is LatchedStatus
    schedule.record_poll(LatchedStatus, 1.0)
    assert schedule.next(1.05) is None


def test_poll_of_unscheduled_topic_is_ignored() -> None:
    schedule = Schedule()
    schedule.start({ModeSample: 1.0}, 0.0)
    schedule.record_poll(Raw, 0.0)
    assert schedule.next(0.0) is ModeSample


def test_poll_rates_match_update_rates_of_source() -> None:
    assert rates(InputSource.RC)[Currents] == 80
    assert rates(InputSource.ANALOG)[Currents] == 50
    for source in InputSource:
        assert rates(source)[Raw] == rates(source)[Remapped] == 50


def test_polls_missed_in_a_pause_are_skipped() -> None:
    schedule = Schedule()
    schedule.start({Currents: 80.0}, 0.0)
    schedule.record_poll(Currents, 0.0)
    polled, now = 0, 100.0
    while now < 101.0:
        if schedule.next(now):
            schedule.record_poll(Currents, now)
            polled += 1
        now += 0.001
    assert polled < 95


@modest
@given(poll_rates=any_rates, cost=st.floats(0.0005, 0.1))
def test_no_topic_starves(*, poll_rates: dict[Topic, float], cost: float) -> None:
    load = max(1.0, cost * sum(poll_rates.values()))
    polled = simulate(
        poll_rates, dict.fromkeys(POLLED, cost), 3 * load / min(poll_rates.values()) + 1.0
    )
    assert all(polled[topic] >= 2 for topic in poll_rates)


@modest
@given(poll_rates=any_rates, load=st.floats(0.01, 0.7))
def test_poll_rates_are_met_and_not_exceeded(
    *, poll_rates: dict[Topic, float], load: float
) -> None:
    cost = load / sum(poll_rates.values())
    seconds = 10 / min(poll_rates.values())
    polled = simulate(poll_rates, dict.fromkeys(POLLED, cost), seconds)
    for topic, rate in poll_rates.items():
        assert polled[topic] == pytest.approx(rate * seconds, rel=0.02, abs=2)


@modest
@given(times=st.lists(st.floats(0, 10), min_size=1, max_size=30).map(sorted))
def test_wait_ends_when_topic_is_due(*, times: list[float]) -> None:
    schedule = Schedule()
    schedule.start(rates(InputSource.RC), 0.0)
    for now in times:
        wait = schedule.seconds_to_next(now)
        assert wait >= 0
        topic = schedule.next(now)
        assert (topic is None) <= (wait > 0)
        if topic is None:
            assert schedule.next(now + wait + 1e-9) is not None
        else:
            schedule.record_poll(topic, now)


@pytest.mark.parametrize("baud", [1200, 4800, 9600])
def test_slow_line_lowers_all_rates_by_the_same_factor(baud: int) -> None:
    poll_rates = rates(InputSource.RC)
    polled = simulate(poll_rates, costs(baud), 100.0)
    fractions = [polled[topic] / rate for topic, rate in poll_rates.items()]
    assert min(fractions) > 0.9 * max(fractions)
