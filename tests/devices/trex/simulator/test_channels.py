"""The five inputs in time: when each is measured, how long it is kept."""

import math

import pytest

from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource
from trex_gui.devices.trex.simulator.channels import Channels, Signal

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


def test_channels_get_first_pulse_at_different_ticks(
    rc: Channels,
) -> None:
    seen = ticks(rc, PERIOD)
    assert seen[-1] == (3750,) * 5
    firsts = [next(tick for tick, raw in enumerate(seen) if raw[index]) for index in range(5)]
    assert len(set(firsts)) == 5


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
