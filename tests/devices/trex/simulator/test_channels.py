"""The five inputs in time: when each is measured, how long it is kept."""

import math
from itertools import pairwise

import pytest

from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource
from trex_gui.devices.trex.simulator.channels import TICK, Channels, Signal, SignalKind

RC, ANALOG = InputSource.RC, InputSource.ANALOG
PERIOD = 8
"""Ticks in which each input is renewed once."""


def ticks(channels: Channels, count: int) -> list[tuple[int | None, ...]]:
    seen = []
    for _ in range(count):
        channels.tick()
        seen.append(channels.raw)
    return seen


@pytest.fixture
def rc() -> Channels:
    return Channels(RC)


@pytest.fixture
def analog() -> Channels:
    return Channels(ANALOG)


def test_rc_channels_have_no_pulse_at_power_up(rc: Channels) -> None:
    assert rc.raw == (None,) * 5
    assert all(rc.silence(channel) == math.inf for channel in CHANNELS)


def test_analog_channels_read_zero_until_first_average(analog: Channels) -> None:
    assert analog.raw == (0,) * 5
    assert ticks(analog, PERIOD - 1) == [(0,) * 5] * (PERIOD - 1)
    assert ticks(analog, 1) == [(512,) * 5]


def test_power_up_forgets_measured_pulses(rc: Channels) -> None:
    rc.signals[1] = Signal.pulses(1200)
    ticks(rc, PERIOD)
    rc.begin(RC)
    assert rc.raw == (None,) * 5
    assert rc.silence(1) == math.inf
    ticks(rc, PERIOD)
    assert rc.raw[0] == 3000


def test_channels_get_first_pulse_at_different_ticks(
    rc: Channels,
) -> None:
    seen = ticks(rc, PERIOD)
    assert seen[-1] == (3750,) * 5
    firsts = [next(tick for tick, raw in enumerate(seen) if raw[index]) for index in range(5)]
    assert len(set(firsts)) == 5


@pytest.mark.parametrize("channel", CHANNELS)
@pytest.mark.parametrize("source", InputSource)
def test_each_channel_updates_every_20_ms(channel: int, source: InputSource) -> None:
    channels = Channels(source)
    changes = []
    for tick in range(400):
        before = channels.raw[channel - 1]
        channels.signals[channel] = Signal.from_counts(500 + 4 * tick, source)
        channels.tick()
        if channels.raw[channel - 1] != before:
            changes.append(tick)
        if source is ANALOG and 500 + 4 * tick > 1000:
            break
    assert {after - before for before, after in pairwise(changes[1:])} == {PERIOD}


def test_new_signal_is_measured_at_next_pulse(rc: Channels) -> None:
    ticks(rc, PERIOD)
    for channel in CHANNELS:
        rc.signals[channel] = Signal.pulses(1200)
    assert rc.raw == (3750,) * 5
    for values in zip(*ticks(rc, PERIOD), strict=True):
        before = values.count(3750)
        assert values == (3750,) * before + (3000,) * (PERIOD - before)
        assert before < PERIOD


def test_bad_pulse_invalidates_channel_at_next_pulse(rc: Channels) -> None:
    ticks(rc, PERIOD)
    rc.signals[4] = Signal(SignalKind.BAD_PULSES)
    assert rc.raw == (3750,) * 5
    seen = ticks(rc, PERIOD)
    assert seen[0][3] == 3750
    assert seen[-1] == (3750, 3750, 3750, None, 3750)
    assert rc.silence(4) > rc.silence(1)


@pytest.mark.parametrize("text", ["silent", "2.5V", "1500us lost 1"])
def test_silent_channel_keeps_its_value_for_100_ms(rc: Channels, text: str) -> None:
    ticks(rc, PERIOD)
    last_pulses = [rc.silence(channel) for channel in CHANNELS]
    for channel in CHANNELS:
        rc.signals[channel] = Signal.parse(text, RC)
    seen = ticks(rc, 60)
    for channel, last_pulse in zip(CHANNELS, last_pulses, strict=True):
        kept = [raw[channel - 1] for raw in seen]
        frozen = kept.count(3750)
        assert kept == [3750] * frozen + [None] * (60 - frozen)
        assert last_pulse + frozen * TICK == pytest.approx(0.1, abs=1.5 * TICK)
        assert rc.silence(channel) == pytest.approx(last_pulse + 0.15)


def test_occasional_lost_pulses_hardly_affect_channel(rc: Channels) -> None:
    rc.signals[1] = Signal.parse("1500us lost 0.2", RC)
    ticks(rc, 10 * PERIOD)
    seen = [raw[0] for raw in ticks(rc, 200 * PERIOD)]
    assert seen.count(3750) > 0.98 * len(seen)


def test_losing_most_pulses_mostly_invalidates_channel(rc: Channels) -> None:
    rc.signals[1] = Signal.parse("1500us lost 0.95", RC)
    seen = [raw[0] for raw in ticks(rc, 500 * PERIOD)]
    assert 0 < seen.count(3750) < 0.5 * len(seen)
    assert set(seen) == {None, 3750}


def test_voltage_is_averaged_over_last_20_ms(analog: Channels) -> None:
    analog.signals[1] = Signal.voltage(0)
    ticks(analog, PERIOD)
    ticks(analog, PERIOD // 4)
    analog.signals[1] = Signal.voltage(5)
    seen = [raw[0] for raw in ticks(analog, PERIOD - PERIOD // 4)]
    assert seen[:-1] == [0] * (len(seen) - 1)
    assert seen[-1] == pytest.approx(0.75 * 1023, abs=1)
    assert ticks(analog, PERIOD)[-1][0] == 1023


def test_disconnect_sets_every_channel_to_rest(rc: Channels) -> None:
    rc.signals[3] = Signal.parse("1200us noise 2us", RC)
    rc.disconnect()
    assert [rc.signals[channel].text for channel in CHANNELS] == ["rest"] * 5
