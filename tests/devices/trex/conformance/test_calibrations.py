"""Calibrations: each sentence of CMD10 0x90 to 0x95 and 0xA0 to 0xA4."""

import pytest

from tests.devices.trex.conformance.trex import Trex, calibration, only, two_byte_values

CHANNELS = range(1, 6)
VALUES = {
    1: (2501, 3701, 5001, 31),
    2: (2502, 3702, 5002, 32),
    3: (2503, 3703, 5003, 33),
    4: (2504, 3704, 5004, 34),
    5: (2505, 3705, 5005, 35),
}
"""Calibration of each channel in RC counts, with different values."""


def stored(trex: Trex, channel: int) -> tuple[int, ...]:
    """Return minimum, neutral, maximum and deadband of a channel."""
    return tuple(two_byte_values(trex.request(f"{0x90 + channel - 1:02X}")))


def test_low_byte_of_each_value_is_sent_first(trex: Trex) -> None:
    """CMD10 0x90."""
    assert trex.request(calibration(1, 0x0102, 0x0304, 0x0506, 0x0108)) == "00"
    assert trex.request("90") == "02 01 04 03 06 05 08 01"


def test_calibration_is_read_for_active_input_source(trex: Trex) -> None:
    """CMD10 0x90: the mode selects the source. In serial mode, the channel input source does."""
    rc, analog = (2501, 3701, 5001, 31), (101, 501, 901, 11)
    assert trex.request(calibration(2, *rc)) == "00"
    trex.set_parameters(channel_input_source=1)
    assert trex.request(calibration(2, *analog)) == "00"
    for jumper, source, values in (
        ("serial", 0, rc),
        ("serial", 1, analog),
        ("rc", 1, rc),
        ("analog", 0, analog),
    ):
        trex.control(f"jumper mode {jumper}")
        trex.set_parameters(channel_input_source=source)
        assert stored(trex, 2) == values, (jumper, source)


def test_calibration_write_applies_to_channel_input_source(trex: Trex) -> None:
    """CMD10 0xA0: the channel input source parameter selects RC or analog.

    The document also describes this command in RC and analog mode, but it needs serial mode.
    """
    before = stored(trex, 1)
    trex.set_parameters(channel_input_source=1)
    assert trex.request(calibration(1, 101, 501, 901, 11)) == "00"
    assert stored(trex, 1) == (101, 501, 901, 11)
    trex.set_parameters(channel_input_source=0)
    assert stored(trex, 1) == before


def test_calibration_command_sets_bit_of_its_channel(trex: Trex) -> None:
    """CMD10 0x95: "via commands 0xA0 - 0xA4". Bit n is channel n+1."""
    learned = 0
    for channel in CHANNELS:
        assert trex.request(calibration(channel, *VALUES[channel])) == "00"
        learned |= 1 << channel - 1
        assert trex.request_byte("95") == learned


def test_channel_with_default_values_has_its_bit_clear(trex: Trex) -> None:
    """CMD10 0x95: "that differ from the defaults"."""
    default = stored(trex, 3)
    assert trex.request(calibration(3, *VALUES[3])) == "00"
    assert trex.request("95") == "04"
    assert trex.request(calibration(3, *default)) == "00"
    assert trex.request("95") == "00"


@only(harness="parser")  # nothing is sent during the 15 seconds of learning
def test_automatic_calibration_sets_bits_of_its_channels(trex: Trex) -> None:
    """CMD10 0x95. The steps are from page 11 of the manual."""
    trex.control("jumper mix on")
    trex.control("jumper so-ground on")
    for channel in CHANNELS:
        trex.control(f"channel {channel} {'1500us' if channel in {1, 3} else 'silent'}")
    trex.restart_in("rc")
    trex.control("jumper mix off")
    trex.wait(5.0)
    for position in ("1050us", "1950us"):
        trex.control(f"channel 1 {position}")
        trex.control(f"channel 3 {position}")
        trex.wait(2.0)
    trex.wait(10.0)
    trex.control("jumper so-ground off")
    trex.restart_in("serial")
    assert trex.request("95") == "05"
    minimum, neutral, maximum, _ = stored(trex, 1)
    assert (minimum, neutral, maximum) == (2625, 3750, 4875)


def test_calibration_command_sets_only_its_channel(trex: Trex) -> None:
    """CMD10 0xA0: 0xA0 is channel 1, and 0xA4 is channel 5."""
    expected = {channel: stored(trex, channel) for channel in CHANNELS}
    for channel in (3, 5, 1, 4, 2):
        assert trex.request(calibration(channel, *VALUES[channel])) == "00"
        expected[channel] = VALUES[channel]
        assert {number: stored(trex, number) for number in CHANNELS} == expected


def test_values_at_edge_of_restrictions_are_accepted(trex: Trex) -> None:
    """CMD10 0xA0: minimum <= neutral AND neutral <= maximum AND minimum < maximum."""
    for values in ((1000, 1000, 1001, 0), (1000, 1001, 1001, 0), (0, 8000, 16383, 127)):
        assert trex.request(calibration(1, *values)) == "00"
        assert stored(trex, 1) == values


@pytest.mark.parametrize(
    "values",
    [(2000, 2000, 2000, 0), (2001, 2000, 3000, 0), (1000, 3001, 3000, 0), (3000, 2500, 1000, 0)],
    ids=["maximum = minimum", "minimum > neutral", "neutral > maximum", "all reversed"],
)
def test_values_beyond_restrictions_are_rejected_and_not_set(
    trex: Trex, values: tuple[int, ...]
) -> None:
    """CMD10 0xA0: "the calibration values were not set". The result code 2 is a bad value."""
    before = stored(trex, 4)
    assert trex.request(calibration(4, *values)) == "02"
    assert stored(trex, 4) == before
    assert trex.request("95") == "00"


def test_set_commands_are_rejected_with_3_in_serial_override(trex: Trex) -> None:
    """CMD10, note before 0xA0: "must be in serial mode for commands 0xA0 - 0xAF to work"."""
    trex.start("rc")
    trex.connect(c5="1000us")
    assert trex.request("83") == "01"
    assert trex.request(calibration(1, *VALUES[1])) == "03"
    assert trex.request("AF 0E 05 55 2A") == "03"


def test_calibration_is_confirmed_after_about_32_ms(trex: Trex) -> None:
    """CMD10 0xA0: "approximately 32ms if the command packet format is correct"."""
    assert trex.request(calibration(1, 2500, 3750, 5000, 75)) == "00"
    assert 0.030 <= trex.reply_delay < 0.036
    assert stored(trex, 1)[2] == 5000


def test_wrong_format_bytes_get_no_reply_within_100_ms(trex: Trex) -> None:
    """CMD10 0xA0: "made it untrustworthy". The UART error byte has "useful information"."""
    before = stored(trex, 1)
    packet = calibration(1, *VALUES[1])
    for ending in ("2A 55", "55 55", "00 00", "55 2B"):
        trex.send(packet.replace("55 2A", ending))
        assert trex.request("85") == "40", ending
    assert trex.gets_no_reply(packet.replace("55 2A", "54 2A"), seconds=0.1)
    assert trex.request("85") == "40"
    assert stored(trex, 1) == before


def test_calibration_survives_power_cycle(trex: Trex) -> None:
    """CMD10 0xA0: "saved, so it will never need to be set again"."""
    assert trex.request(calibration(5, *VALUES[5])) == "00"
    trex.control("power off")
    trex.control("power on")
    assert stored(trex, 5) == VALUES[5]
