"""Signature, mode and serial control: each sentence of CMD10 0x81 to 0x83."""

import pytest

from tests.devices.trex.conformance.trex import Trex


def test_signature_is_name_and_firmware_version(trex: Trex) -> None:
    """CMD10 0x81: the version is a major byte, '.' and a minor byte, such as "TReX1.0"."""
    assert bytes.fromhex(trex.request("81")) == b"TReX" + trex.variant.firmware.encode()


@pytest.mark.parametrize(
    ("jumper", "source", "letter"),
    [("rc", 0, "52"), ("analog", 0, "41"), ("serial", 0, "72"), ("serial", 1, "61")],
)
def test_mode_letter_follows_jumper_and_input_source(
    trex: Trex, jumper: str, source: int, letter: str
) -> None:
    """CMD10 0x82: 'R', 'A', 'r', 'a'."""
    trex.set_parameters(channel_input_source=source)
    trex.restart_in(jumper)
    assert trex.request("82") == letter


def test_serial_is_always_in_control_in_serial_mode(trex: Trex) -> None:
    """CMD10 0x82 and 0x83."""
    for position in ("1000us", "1500us", "2000us", "silent"):
        trex.connect(c5=position)
        assert trex.request("83") == "01"


def test_channels_can_be_read_in_serial_mode(trex: Trex) -> None:
    """CMD10 0x82: "it can choose to read and use the channel inputs as it sees fit"."""
    trex.connect(c1="2000us", c2="1000us")
    assert trex.request("86 03") == "88 13 C4 09"
    assert trex.request("87 03") == "7F FF"
    assert trex.motor(1)[1] == trex.motor(2)[1] == 0


def test_channel_input_source_selects_inputs_in_serial_mode(trex: Trex) -> None:
    """CMD10 0x82: parameter 0x7C."""
    trex.control("channel 1 5V")
    for source, raw in ((0, "FF FF"), (1, "FF 03"), (0, "FF FF")):
        trex.set_parameters(channel_input_source=source)
        trex.wait(0.03)
        assert trex.request("86 01") == raw


@pytest.mark.parametrize(
    ("jumper", "letter", "signal", "raw"),
    [("rc", "52", "1600us", "A0 0F"), ("analog", "41", "5V", "FF 03")],
)
def test_channel_input_source_is_ignored_in_rc_and_analog_mode(
    trex: Trex, jumper: str, letter: str, signal: str, raw: str
) -> None:
    """CMD10 0x82: "no effect when the mode shorting block selects for RC or analog mode"."""
    trex.control(f"channel 1 {signal}")
    for source in (0, 1):
        trex.set_parameters(channel_input_source=source)
        trex.restart_in(jumper)
        trex.wait(0.025)
        assert trex.request("82") == letter
        assert trex.request("86 01") == raw


@pytest.mark.parametrize(
    ("jumper", "low", "middle"), [("rc", "1000us", "1500us"), ("analog", "0V", "2.5V")]
)
def test_low_channel_5_puts_serial_in_control(
    trex: Trex, jumper: str, low: str, middle: str
) -> None:
    """CMD10 0x83: 1 only "when serial override (as controlled by channel 5) is active"."""
    trex.start(jumper)
    for position, reply in ((low, "01"), (middle, "00")):
        trex.connect(c5=position)
        assert trex.request("83") == reply
