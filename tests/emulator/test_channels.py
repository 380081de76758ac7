"""The five inputs in time: when each is measured, how long it is kept."""

import math
from itertools import pairwise

import pytest

from trex_gui.emulator.channels import Channels
from trex_gui.emulator.signals import Signal, SignalKind
from trex_gui.protocol.flags import CHANNELS, InputSource

RC, ANALOG = InputSource.RC, InputSource.ANALOG
TICK = 0.0025
PERIOD = 8
"""Ticks in which each input is renewed once."""


def ticks(channels: Channels, count: int) -> list[tuple[int | None, ...]]:
    seen = []
    for _ in range(count):
        channels.advance(TICK)
        seen.append(channels.raw)
    return seen


@pytest.fixture
def rc() -> Channels:
    return Channels(RC)


@pytest.fixture
def analog() -> Channels:
    return Channels(ANALOG)


def test_at_power_up_no_pulse_has_been_measured(rc: Channels) -> None:
    assert rc.raw == (None,) * 5
    assert all(rc.silent_for(channel) == math.inf for channel in CHANNELS)


def test_at_power_up_no_voltage_has_been_measured(analog: Channels) -> None:
    assert analog.raw == (0,) * 5
    assert ticks(analog, PERIOD - 1) == [(0,) * 5] * (PERIOD - 1)
    assert ticks(analog, 1) == [(512,) * 5]


def test_after_another_power_up_everything_is_forgotten(rc: Channels) -> None:
    rc.connect(1, Signal.pulses(1200))
    ticks(rc, PERIOD)
    rc.begin(RC)
    assert rc.raw == (None,) * 5
    assert rc.silent_for(1) == math.inf
    ticks(rc, PERIOD)
    assert rc.raw[0] == 3000


def test_in_a_fiftieth_of_a_second_each_input_has_its_first_pulse_at_its_own_time(
    rc: Channels,
) -> None:
    seen = ticks(rc, PERIOD)
    assert seen[-1] == (3750,) * 5
    firsts = [next(tick for tick, raw in enumerate(seen) if raw[index]) for index in range(5)]
    assert len(set(firsts)) == 5


@pytest.mark.parametrize("channel", CHANNELS)
@pytest.mark.parametrize("source", InputSource)
def test_each_input_is_renewed_fifty_times_a_second(channel: int, source: InputSource) -> None:
    channels = Channels(source)
    changes = []
    for tick in range(400):
        before = channels.raw[channel - 1]
        channels.connect(channel, Signal.from_counts(500 + 4 * tick, source))
        channels.advance(TICK)
        if channels.raw[channel - 1] != before:
            changes.append(tick)
        if source is ANALOG and 500 + 4 * tick > 1000:
            break
    assert {after - before for before, after in pairwise(changes[1:])} == {PERIOD}


def test_a_pulse_is_measured_when_it_comes_and_not_when_it_is_connected(rc: Channels) -> None:
    ticks(rc, PERIOD)
    for channel in CHANNELS:
        rc.connect(channel, Signal.pulses(1200))
    assert rc.raw == (3750,) * 5
    for values in zip(*ticks(rc, PERIOD), strict=True):
        before = values.count(3750)
        assert values == (3750,) * before + (3000,) * (PERIOD - before)
        assert before < PERIOD


def test_a_bad_pulse_shows_at_the_next_pulse(rc: Channels) -> None:
    ticks(rc, PERIOD)
    rc.connect(4, Signal(SignalKind.BAD_PULSES))
    assert rc.raw == (3750,) * 5
    seen = ticks(rc, PERIOD)
    assert seen[0][3] == 3750
    assert seen[-1] == (3750, 3750, 3750, None, 3750)
    assert rc.silent_for(4) > rc.silent_for(1)


def test_a_good_pulse_after_a_bad_one_counts_again(rc: Channels) -> None:
    rc.connect(1, Signal(SignalKind.BAD_PULSES))
    ticks(rc, 4 * PERIOD)
    rc.connect(1, Signal.pulses(1200))
    assert rc.raw[:1] == (None,)
    ticks(rc, PERIOD)
    assert rc.raw[:1] == (3000,)
    assert rc.silent_for(1) < PERIOD * TICK


@pytest.mark.parametrize("text", ["silent", "2.5V", "1500us lost 1"])
@pytest.mark.parametrize("channel", CHANNELS)
def test_a_silent_channel_keeps_its_value_for_a_tenth_of_a_second(
    rc: Channels, channel: int, text: str
) -> None:
    rc.connect(channel, Signal.pulses(1200))
    ticks(rc, PERIOD)
    last_pulse = rc.silent_for(channel)
    rc.connect(channel, Signal.parse(text, RC))
    kept = [raw[channel - 1] for raw in ticks(rc, 60)]
    frozen = kept.count(3000)
    assert kept == [3000] * frozen + [None] * (60 - frozen)
    assert last_pulse + frozen * TICK == pytest.approx(0.1, abs=1.5 * TICK)
    assert rc.silent_for(channel) == pytest.approx(last_pulse + 0.15)


def test_a_lost_pulse_now_and_then_is_not_seen(rc: Channels) -> None:
    rc.connect(1, Signal.parse("1500us lost 0.2", RC))
    ticks(rc, 10 * PERIOD)
    seen = [raw[0] for raw in ticks(rc, 200 * PERIOD)]
    assert seen.count(3750) > 0.98 * len(seen)


def test_when_nearly_all_pulses_are_lost_the_value_goes(rc: Channels) -> None:
    rc.connect(1, Signal.parse("1500us lost 0.95", RC))
    seen = [raw[0] for raw in ticks(rc, 500 * PERIOD)]
    assert 0 < seen.count(3750) < 0.5 * len(seen)
    assert set(seen) == {None, 3750}


def test_a_voltage_is_the_average_of_the_last_fiftieth_of_a_second(analog: Channels) -> None:
    analog.connect(1, Signal.voltage(0))
    ticks(analog, PERIOD)
    ticks(analog, PERIOD // 4)
    analog.connect(1, Signal.voltage(5))
    seen = [raw[0] for raw in ticks(analog, PERIOD - PERIOD // 4)]
    assert seen[:-1] == [0] * (len(seen) - 1)
    assert seen[-1] == pytest.approx(0.75 * 1023, abs=1)
    assert ticks(analog, PERIOD)[-1][0] == 1023


def test_averaging_takes_most_of_the_noise_away() -> None:
    analog = Channels(ANALOG, seed=2)
    analog.connect(1, Signal.parse("2.5V noise 100mV", ANALOG))  # 20 counts each
    seen = [raw[0] or 0 for raw in ticks(analog, 500 * PERIOD)[PERIOD - 1 :: PERIOD]]
    mean = sum(seen) / len(seen)
    spread = (sum((value - mean) ** 2 for value in seen) / len(seen)) ** 0.5
    assert mean == pytest.approx(511.5, abs=1)
    assert spread == pytest.approx(20.46 / 4, rel=0.15)


def test_disconnecting_puts_every_input_at_rest(rc: Channels) -> None:
    rc.connect(3, Signal.parse("1200us noise 2us", RC))
    rc.disconnect()
    assert [rc.signal(channel).text for channel in CHANNELS] == ["rest"] * 5
