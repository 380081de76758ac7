"""What is connected to an input: the text that names it, and one measurement of it."""

from random import Random

import pytest
from hypothesis import given
from hypothesis import strategies as st

from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.simulator.channels import Signal, SignalKind

RC, ANALOG = InputSource.RC, InputSource.ANALOG
LUCK = Random(0)


def measured(signal: Signal, source: InputSource) -> int | None:
    return signal.pulse(LUCK) if source is RC else signal.conversion(LUCK)


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
    ("text", "comes"),
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
def test_signal_has_pulse_unless_silent_voltage_or_lost(text: str, comes: bool) -> None:
    assert Signal.parse(text, RC).has_pulse(LUCK) is comes


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


@given(signal=signals, source=st.sampled_from(InputSource))
def test_signal_text_can_be_parsed_back(signal: Signal, source: InputSource) -> None:
    assert Signal.parse(signal.text, source) == signal


@given(counts=st.integers(1250, 6250))
def test_signal_from_pulse_counts_measures_same_counts(counts: int) -> None:
    assert measured(Signal.from_counts(counts, RC), RC) == counts


@given(counts=st.integers(0, 1023))
def test_signal_from_voltage_counts_measures_same_counts(counts: int) -> None:
    assert measured(Signal.from_counts(counts, ANALOG), ANALOG) == counts


@given(
    signal=st.builds(Signal, st.just(SignalKind.VOLTAGE), st.floats(0, 5), noise=st.floats(0, 5)),
    seed=st.integers(0, 1000),
)
def test_noisy_voltage_stays_within_ten_bits(signal: Signal, seed: int) -> None:
    assert 0 <= signal.conversion(Random(seed)) <= 1023


def test_noise_spreads_pulses_around_their_width() -> None:
    luck = Random(1)
    signal = Signal.parse("1500us noise 4us", RC)
    widths = [signal.pulse(luck) or 0 for _ in range(2000)]
    mean = sum(widths) / len(widths)
    spread = (sum((width - mean) ** 2 for width in widths) / len(widths)) ** 0.5
    assert mean == pytest.approx(3750, abs=1)
    assert spread == pytest.approx(10, rel=0.1)
