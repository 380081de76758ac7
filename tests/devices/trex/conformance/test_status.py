"""Status byte: each sentence of CMD10 0x84."""

import pytest

from tests.devices.trex.conformance.trex import Trex

OVER_LIMIT = [pytest.param(1, 0x20, id="bit 5 motor 1"), pytest.param(2, 0x80, id="bit 7 motor 2")]
FAULT = [pytest.param(1, 0x10, id="bit 4 motor 1"), pytest.param(2, 0x40, id="bit 6 motor 2")]


def drive_with_limits(trex: Trex) -> None:
    """Drive both motors without current, with limits of 3 A."""
    trex.set_parameters(motor1_current_limit=10, motor2_current_limit=10)
    trex.control("current 1 0")
    trex.control("current 2 0")
    trex.send("DA 30 30")


def exceed_the_limit(trex: Trex, motor: int) -> None:
    """Set the current of a motor above its limit for 30 ms."""
    trex.control(f"current {motor} 20")
    trex.wait(0.03)
    trex.control(f"current {motor} 0")
    trex.wait(0.03)


@pytest.mark.parametrize(("motor", "bit"), OVER_LIMIT)
def test_over_current_sets_its_status_bit(trex: Trex, motor: int, bit: int) -> None:
    """CMD10 0x84: bits 7 and 5."""
    drive_with_limits(trex)
    exceed_the_limit(trex, motor)
    assert trex.request_byte("84") == bit


@pytest.mark.parametrize(("motor", "bit"), FAULT)
def test_motor_fault_sets_its_status_bit(trex: Trex, motor: int, bit: int) -> None:
    """CMD10 0x84: bits 6 and 4."""
    trex.control(f"fault {motor} on")
    trex.wait(0.02)
    assert trex.request_byte("84") == bit


def test_status_bits_are_latched_until_read(trex: Trex) -> None:
    """CMD10 0x84: "latched"."""
    trex.control("fault 1 on")
    trex.send(b"\x88")
    trex.wait(0.02)
    trex.control("fault 1 off")
    trex.wait(0.05)
    for query in ("81", "82", "83", "85", "86 1F", "87 1F", "8F", "95", "9F 00"):
        trex.request(query)
    assert trex.request("84") == "11"


def test_reading_status_byte_clears_all_its_bits(trex: Trex) -> None:
    """CMD10 0x84. The test sets every used bit. Bits 3 to 1 are unused."""
    drive_with_limits(trex)
    for motor in (1, 2):
        exceed_the_limit(trex, motor)
        trex.control(f"fault {motor} on")
        trex.control(f"fault {motor} off")
    trex.send(b"\x88")
    assert trex.request("84") == "F1"
    assert trex.request("84") == "00"


def test_lasting_fault_sets_its_bit_again(trex: Trex) -> None:
    """CMD10 0x84: a bit is set while its cause lasts."""
    trex.control("fault 2 on")
    for _ in range(2):
        trex.wait(0.03)
        assert trex.request("84") == "40"
