"""Remapped channels: each sentence of CMD10 0x87.

Values between the documented points are inferred (linear outside the deadband). These tests only
check the documented points, and values that must be equal or opposite.
"""

from itertools import product

import pytest

from tests.devices.trex.conformance.trex import Trex, calibration, channels, only

STICKS = {1: "2100us", 2: "900us", 3: "1500us", 4: "2000us", 5: "1000us"}
REMAPPED = {1: 0x7F, 2: 0xFF, 3: 0x00, 4: 0x7F, 5: 0xFF}


def calibrate(trex: Trex) -> None:
    """Calibrate channel 1 to 1 ms, 1.5 ms and 2 ms with a deadband of 40 µs."""
    assert trex.request(calibration(1, 2500, 3750, 5000, 100)) == "00"


def test_remapped_reply_has_one_byte_of_each_masked_channel(trex: Trex) -> None:
    """CMD10 0x87: bit n is channel n+1. Lower channels are transmitted before higher ones."""
    trex.connect(**{f"c{channel}": stick for channel, stick in STICKS.items()})
    for mask in range(1, 0x20):
        expected = [REMAPPED[channel] for channel in channels(mask)]
        assert list(bytes.fromhex(trex.request(f"87 {mask:02X}"))) == expected


def test_rc_and_analog_ends_give_the_same_remapped_values(trex: Trex) -> None:
    """CMD10 0x87: "unitless, single-byte values"."""
    for source, ends in ((0, ("1000us", "1500us", "2000us")), (1, ("0V", "2.5V", "5V"))):
        trex.set_parameters(channel_input_source=source)
        trex.connect(**{f"c{index + 1}": position for index, position in enumerate(ends)})
        assert trex.request("87 07") == "FF 00 7F"


@pytest.mark.parametrize(
    ("widths", "byte"),
    [
        pytest.param((2000, 2001, 2500), "7F", id="at or above maximum"),
        pytest.param((500, 999, 1000), "FF", id="at or below minimum"),
        pytest.param((1460, 1500, 1540), "00", id="within deadband"),
    ],
)
def test_value_is_documented_at_ends_and_within_deadband(
    trex: Trex, widths: tuple[int, ...], byte: str
) -> None:
    """CMD10 0x87: "greater than or equal to the channel maximum". Bit 7 is the direction."""
    calibrate(trex)
    for width in widths:
        trex.connect(c1=f"{width}us")
        assert trex.request("87 01") == byte, width


def test_mix_jumper_affects_only_channels_1_and_2(trex: Trex) -> None:
    """CMD10 0x87. One channel turns the robot, the other drives it (User's Guide 4.a).

    The jumper can be changed while running (MH 7).
    """
    trex.connect(c2="2000us", c3="2000us")
    assert trex.request("87 07") == "00 7F 7F"
    trex.control("jumper mix on")
    assert trex.request("87 07") == "7F 7F 7F"
    trex.connect(c1="2000us", c2="1500us")
    first, second, third = bytes.fromhex(trex.request("87 07"))
    assert first ^ second == 0x80
    assert third == 0x7F
    trex.control("jumper mix off")
    assert trex.request("87 07") == "7F 00 7F"


def test_flip_channel_affects_only_channels_1_and_2(trex: Trex) -> None:
    """CMD10 0x87: channel 4. It exchanges the motors and their directions (User's Guide 4.a)."""
    trex.connect(c1="2000us", c3="2000us", c4="1500us")
    assert trex.request("87 07") == "7F 00 7F"
    trex.connect(c4="1000us")
    assert trex.request("87 07") == "00 FF 7F"


@pytest.mark.parametrize(("mix", "flip"), [*product(("off", "on"), ("1500us", "1000us"))])
def test_remapped_values_match_motor_targets(trex: Trex, mix: str, flip: str) -> None:
    """CMD10 0x87: channel 1 "will always correspond directly to motor 1", also with mix or flip."""
    trex.control(f"jumper mix {mix}")
    trex.start("rc")
    trex.connect(c1="1700us", c2="1400us", c3="1800us", c4=flip)
    first, second, third = bytes.fromhex(trex.request("87 07"))
    for number, byte in ((1, first), (2, second)):
        assert trex.target(number) == ("reverse" if byte & 0x80 else "forward", byte & 0x7F)
    assert trex.show()["aux"]["target_speed"] == third & 0x7F  # "lower six bits" is a mistake


def test_inverted_robot_applies_raw_channel_1_to_motor_2(trex: Trex) -> None:
    """CMD10 0x87: "in contrast to the raw value for channel 1"."""
    trex.start("rc")
    trex.connect(c1="2000us", c4="1000us")
    assert trex.request("86 01") == "88 13"
    assert trex.target(1)[0] == "brake"
    assert trex.target(2) == ("reverse", 127)


@only(expanded=False)  # the protocol does not affect the motors
def test_serial_program_can_mimic_rc_mode(trex: Trex) -> None:
    """CMD10 0x87: "by requesting the remapped channel values and setting" the motors to them."""
    outputs = []
    for mode in ("rc", "serial"):
        trex.start(mode)
        trex.connect(c1="1700us", c2="1300us", c3="1900us")
        if mode == "serial":
            first, second, third = bytes.fromhex(trex.request("87 07"))
            trex.send(f"{0xC5 if first & 0x80 else 0xC6:02X} {first & 0x7F:02X}")
            trex.send(f"{0xCD if second & 0x80 else 0xCE:02X} {second & 0x7F:02X}")
            trex.send(f"F1 {third & 0x7F:02X}")
        trex.wait(0.02)
        outputs.append(trex.outputs())
        trex.control("factory")
        trex.set_baud(115200)
    assert outputs[0] == outputs[1]
    assert outputs[0][0][0] == "forward"
    assert outputs[0][1][0] == "reverse"
