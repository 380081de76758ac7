"""Channels of the simulated board: timing, signals and the demonstration."""

import math
from itertools import pairwise
from random import Random

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support.matrix import examples
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource
from trex_gui.devices.trex.simulator.channels import Channels, Signal, SignalKind
from trex_gui.devices.trex.simulator.command import demonstrate
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import SimulatedBoards
from trex_gui.devices.trex.simulator.physics import CONSTANTS

RC, ANALOG = InputSource.RC, InputSource.ANALOG
PERIOD = 8
"""Number of ticks in which each input is measured once."""


def ticks(channels: Channels, count: int) -> list[tuple[int | None, ...]]:
    readings = []
    for _ in range(count):
        channels.tick()
        readings.append(channels.raw)
    return readings


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


def test_channels_get_first_pulse_at_different_ticks(rc: Channels) -> None:
    readings = ticks(rc, PERIOD)
    assert readings[-1] == (3750,) * 5
    firsts = [next(tick for tick, raw in enumerate(readings) if raw[index]) for index in range(5)]
    assert len(set(firsts)) == 5


def test_occasional_lost_pulses_hardly_affect_channel(rc: Channels) -> None:
    rc.signals[1] = Signal.parse("1500us lost 0.2", RC)
    ticks(rc, 10 * PERIOD)
    readings = [raw[0] for raw in ticks(rc, 200 * PERIOD)]
    assert readings.count(3750) > 0.98 * len(readings)


def test_losing_most_pulses_mostly_invalidates_channel(rc: Channels) -> None:
    rc.signals[1] = Signal.parse("1500us lost 0.95", RC)
    readings = [raw[0] for raw in ticks(rc, 500 * PERIOD)]
    assert 0 < readings.count(3750) < 0.5 * len(readings)
    assert set(readings) == {None, 3750}


def test_voltage_is_averaged_over_last_20_ms(analog: Channels) -> None:
    analog.signals[1] = Signal.voltage(0)
    ticks(analog, PERIOD)
    ticks(analog, PERIOD // 4)
    analog.signals[1] = Signal.voltage(5)
    readings = [raw[0] for raw in ticks(analog, PERIOD - PERIOD // 4)]
    assert readings[:-1] == [0] * (len(readings) - 1)
    assert readings[-1] == pytest.approx(0.75 * 1023, abs=1)
    assert ticks(analog, PERIOD)[-1][0] == 1023


def test_reset_sets_every_signal_to_rest(rc: Channels) -> None:
    rc.signals[3] = Signal.parse("1200us noise 2us", RC)
    rc.reset_signals()
    assert [rc.signals[channel].text for channel in CHANNELS] == ["rest"] * 5


# --- Signals --------------------------------------------------------------------------


RANDOM = Random(0)
few_examples = examples(40)


def measured(signal: Signal, source: InputSource) -> int | None:
    return signal.pulse(RANDOM) if source is RC else signal.conversion(RANDOM)


@pytest.mark.parametrize(
    ("text", "source", "raw"),
    [
        ("1500us", RC, 3750),
        ("1500 µs", RC, 3750),
        ("3637", RC, 3637),
        ("500us", RC, 1250),
        ("2500us", RC, 6250),
        ("499us", RC, None),
        ("2501us", RC, None),
        ("invalid", RC, None),
        ("rest", RC, 3750),
        ("2.5V", ANALOG, 512),
        ("2500mv", ANALOG, 512),
        ("0", ANALOG, 0),
        ("1023", ANALOG, 1023),
        ("5V", ANALOG, 1023),
        ("invalid", ANALOG, 0),
        ("silent", ANALOG, 0),
        ("1500us", ANALOG, 77),
        ("rest", ANALOG, 512),
    ],
)
def test_signal_is_measured_as_raw_value(text: str, source: InputSource, raw: int | None) -> None:
    assert measured(Signal.parse(text, source), source) == raw


@pytest.mark.parametrize(
    ("text", "has_pulse"),
    [
        ("1500us", True),
        ("100us", True),
        ("invalid", True),
        ("rest", True),
        ("silent", False),
        ("2.5V", False),
        ("1500us lost 1", False),
        ("1500us lost 0", True),
    ],
)
def test_signal_has_pulse_unless_silent_voltage_or_lost(text: str, has_pulse: bool) -> None:
    assert Signal.parse(text, RC).has_pulse(RANDOM) is has_pulse


@pytest.mark.parametrize(
    "text",
    [
        *("", "stick", "5.01V", "-1us", "20000us", "nan", "inf", "1e3", "1500 ms", "2.5.5V"),
        *("noise 2us", "1500us noise", "1500us noise x", "1500us lost", "1500us lost -0.1"),
        *("1500us lost 1.01", "1500us noise 1V", "2V noise 20us", "invalid lost 0.5"),
        *("rest noise 1us", "1500us lost 0.1 noise 2us", "2.5V noise 6V", "1500us noise -1"),
    ],
)
def test_invalid_signal_text_is_rejected(text: str) -> None:
    with pytest.raises(ValueError, match=r".+"):
        Signal.parse(text, RC)


@pytest.mark.parametrize(
    ("text", "source", "signal"),
    [
        ("1500us noise 2us", RC, Signal(SignalKind.PULSES, 1500, noise=2)),
        ("1500us noise 2", RC, Signal(SignalKind.PULSES, 1500, noise=2)),
        ("1500 us noise 2.5 us lost .25", RC, Signal(SignalKind.PULSES, 1500, 2.5, 0.25)),
        ("3750 noise 5", RC, Signal(SignalKind.PULSES, 1500, noise=2)),
        ("1500us lost 1", RC, Signal(SignalKind.PULSES, 1500, lost=1)),
        ("2.5V noise 20mV", ANALOG, Signal(SignalKind.VOLTAGE, 2.5, noise=0.02)),
        ("1500US NOISE 2US LOST 0.1", RC, Signal(SignalKind.PULSES, 1500, 2, 0.1)),
        ("1500us noise 0 lost 0", RC, Signal(SignalKind.PULSES, 1500)),
    ],
)
def test_noise_and_lost_pulses_are_parsed_after_value(
    text: str, source: InputSource, signal: Signal
) -> None:
    assert Signal.parse(text, source) == signal


numbers = st.integers(0, 4000).map(lambda tenths: tenths / 10)
shares = st.integers(0, 100).map(lambda percent: percent / 100)
signals = st.one_of(
    st.sampled_from(("rest", "silent", "invalid")).map(lambda word: Signal.parse(word, RC)),
    st.builds(Signal, st.just(SignalKind.PULSES), numbers, numbers, shares),
    st.builds(
        Signal,
        st.just(SignalKind.VOLTAGE),
        st.integers(0, 500).map(lambda value: value / 100),
        st.integers(0, 100).map(lambda value: value / 100),
        shares,
    ),
)


@few_examples
@given(signal=signals, source=st.sampled_from(InputSource))
def test_signal_text_can_be_parsed_back(signal: Signal, source: InputSource) -> None:
    assert Signal.parse(signal.text, source) == signal


@few_examples
@given(pulse=st.integers(1250, 6250), voltage=st.integers(0, 1023))
def test_signal_from_counts_measures_same_counts(pulse: int, voltage: int) -> None:
    for counts, source in ((pulse, RC), (voltage, ANALOG)):
        assert measured(Signal.parse(f"{counts}", source), source) == counts


@few_examples
@given(
    signal=st.builds(Signal, st.just(SignalKind.VOLTAGE), st.floats(0, 5), noise=st.floats(0, 5)),
    seed=st.integers(0, 1000),
)
def test_noisy_voltage_stays_within_ten_bits(signal: Signal, seed: int) -> None:
    assert 0 <= signal.conversion(Random(seed)) <= 1023


def test_noise_spreads_pulses_around_their_width() -> None:
    random = Random(1)
    signal = Signal.parse("1500us noise 4us", RC)
    widths = [signal.pulse(random) or 0 for _ in range(2000)]
    mean = sum(widths) / len(widths)
    spread = (sum((width - mean) ** 2 for width in widths) / len(widths)) ** 0.5
    assert mean == pytest.approx(3750, abs=1)
    assert spread == pytest.approx(10, rel=0.1)


# --- The demonstration ----------------------------------------------------------------


def demo_line(mode: str = "serial") -> SimulatedBoards:
    line = SimulatedBoards([Board(mode=mode)])
    demonstrate(line.boards[0], line.timeline)
    return line


def raw_values(line: SimulatedBoards, seconds: float) -> list[tuple[int | None, ...]]:
    """Return the raw values of all channels at intervals of 20 ms."""
    readings = []
    for _ in range(round(seconds / 0.02)):
        line.advance(0.02)
        readings.append(line.boards[0].channels.raw)
    return readings


def test_demo_moves_every_stick_without_override() -> None:
    line = demo_line("rc")
    board = line.boards[0]
    readings = raw_values(line, 20)
    for channel in zip(*readings, strict=True):
        values = [value for value in channel if value is not None]
        assert len(values) == len(readings)
        assert max(values) - min(values) > 300
        steps = [abs(after - before) for before, after in pairwise(values)]
        assert max(steps) < 60
    assert not board.sticks.override
    assert not board.sticks.safe_start


def test_demo_moves_voltages_in_analog_mode() -> None:
    readings = raw_values(demo_line("analog"), 10)
    first = [raw[0] for raw in readings if raw[0] is not None]
    assert 0 <= min(first) < 200
    assert 800 < max(first) <= 1023


def test_demo_puts_light_load_on_motors() -> None:
    light_load = CONSTANTS["trex"].light_load
    assert [physics.load for physics in demo_line().boards[0].physics] == [light_load] * 2
