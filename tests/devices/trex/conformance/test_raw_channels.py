"""Raw channels: each sentence of CMD10 0x86."""

from itertools import pairwise

import pytest

from tests.devices.trex.conformance.trex import Trex, channels, only, two_byte_values

PULSES = {1: 1100, 2: 1300, 3: 1500, 4: 1700, 5: 1900}
"""Pulse width in µs on each channel."""


def connect_all(trex: Trex) -> None:
    trex.connect(**{f"c{channel}": f"{width}us" for channel, width in PULSES.items()})


def measure_analog_inputs(trex: Trex) -> None:
    trex.set_parameters(channel_input_source=1)


def test_raw_reply_has_two_byte_value_of_each_masked_channel(trex: Trex) -> None:
    """CMD10 0x86: bit n is channel n+1. Lower channels are first, and the low byte is first."""
    connect_all(trex)
    for mask in range(1, 0x20):
        expected = [PULSES[channel] * 10 // 4 for channel in channels(mask)]
        assert two_byte_values(trex.request(f"86 {mask:02X}")) == expected


@pytest.mark.parametrize("query", ["86 00", "87 00"])
def test_empty_mask_gets_no_reply(trex: Trex, query: str) -> None:
    """CMD10 0x86 and 0x87: "will return 0" bytes or more. Inferred: an empty reply has no CRC."""
    assert trex.gets_no_reply(query)
    assert trex.request("85") == "00"


def test_rc_value_is_pulse_width_in_units_of_0_4_us(trex: Trex) -> None:
    """CMD10 0x86: 1500us/.4us = 3750."""
    widths = (500, 1000, 1500, 2000, 2500)
    trex.connect(**{f"c{index + 1}": f"{width}us" for index, width in enumerate(widths)})
    for value, width in zip(two_byte_values(trex.request("86 1F")), widths, strict=True):
        assert abs(value - width / 0.4) <= 1 / 0.4  # accurate to 1 µs (User's Guide 4.c)


def test_rc_value_is_ffff_after_pulse_of_invalid_width(trex: Trex) -> None:
    """CMD10 0x86. The limits of 0.5 and 2.5 ms are from User's Guide 4.c."""
    trex.wait(0.025)
    assert two_byte_values(trex.request("86 1F")) == [3750] * 5
    trex.connect(c1="300us", c2="450us", c3="2550us", c4="3000us")
    assert trex.request("86 0F") == "FF FF FF FF FF FF FF FF"


def test_valid_pulse_replaces_ffff(trex: Trex) -> None:
    """CMD10 0x86: "the width of the last RC pulse received"."""
    trex.connect(c1="3000us")
    trex.connect(c1="1600us")
    assert trex.request("86 01") == "A0 0F"


def test_rc_value_is_ffff_100_ms_after_last_pulse(trex: Trex) -> None:
    """CMD10 0x86. The User's Guide says 150 ms, but the command documentation has priority."""
    connect_all(trex)
    begin = trex.now()
    trex.control("channel 1 silent")
    requested = last_valid = begin
    while two_byte_values(trex.request("86 01")) == [2750]:
        last_valid = requested
        assert requested < begin + 1.0, "the value stays"
        trex.wait(0.005)
        requested = trex.now()
    assert trex.request("86 1F").startswith("FF FF")
    assert trex.now() >= begin - 0.020 + 0.100  # the last pulse was up to 20 ms before
    assert last_valid <= begin + 0.110


@pytest.mark.parametrize(("volts", "value"), [("0V", 0), ("5V", 1023)])
def test_analog_value_ranges_from_0_to_1023(trex: Trex, volts: str, value: int) -> None:
    """CMD10 0x86: a 10-bit conversion. The range of 0 to 5 V is from User's Guide 4.b."""
    measure_analog_inputs(trex)
    trex.connect(**{f"c{channel}": volts for channel in PULSES})
    assert two_byte_values(trex.request("86 1F")) == [value] * 5


def test_analog_value_is_proportional_to_voltage(trex: Trex) -> None:
    """CMD10 0x86. A count is 4.89 mV (User's Guide 4.b)."""
    measure_analog_inputs(trex)
    trex.connect(c1="0.5V", c2="1.5V", c3="2.5V", c4="3.5V", c5="4.5V")
    for channel, value in enumerate(two_byte_values(trex.request("86 1F"))):
        assert abs(value - (0.5 + channel) / 0.00489) <= 1.5


@only(harness="parser")  # the line does not affect the measurement
def test_analog_value_is_average_of_16_samples(trex: Trex) -> None:
    """CMD10 0x86: noise of 400 mV (82 counts) is a quarter of that in the average."""
    measure_analog_inputs(trex)
    trex.connect(c1="2.5V noise 0.4V")
    values = []
    for _ in range(200):
        trex.wait(0.02)
        values += two_byte_values(trex.request("86 01"))
    mean = sum(values) / len(values)
    deviation = (sum((value - mean) ** 2 for value in values) / len(values)) ** 0.5
    assert deviation == pytest.approx(0.4 / 0.00489 / 16**0.5, rel=0.2)


@pytest.mark.parametrize(("source", "signal"), [(0, "1500us noise 60us"), (1, "2.5V noise 1V")])
def test_raw_values_are_updated_50_times_a_second(trex: Trex, source: int, signal: str) -> None:
    """CMD10 0x86: "the standard rate for receivers is 50 Hz", analog "approximately 50 Hz"."""
    trex.set_parameters(channel_input_source=source)
    trex.connect(c1=signal)
    assert 8 <= _changes(trex, "86 01", 0.2) <= 11


def test_documented_rc_example_is_reproduced(trex: Trex) -> None:
    """CMD10 0x86: 0x0A9B is 2715 (1.086 ms). The documentation prints 2716 by mistake."""
    trex.connect(c1="1454.8us", c2="invalid", c5="1086us")
    assert trex.request("86 13") == "35 0E FF FF 9B 0A"


def _changes(trex: Trex, query: str, seconds: float) -> int:
    """Return how often the reply changes within this time."""
    values = [trex.request(query)]
    end = trex.now() + seconds
    while trex.now() < end:
        trex.wait(0.002)
        values.append(trex.request(query))
    return sum(before != after for before, after in pairwise(values))
