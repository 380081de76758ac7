"""Parameters: each sentence of CMD10 0x9F and 0xAF, and the polynomial of User's Guide 5.e."""

import pytest

from tests.devices.trex.conformance.trex import RATES, WITH_CRC, Trex, only

IMMEDIATE = {
    0x00: 9, 0x01: 3, 0x02: 4, 0x03: 1, 0x04: 2, 0x05: 60, 0x06: 61, 0x07: 50, 0x08: 0,
    0x09: 0, 0x0A: 0, 0x0B: 62, 0x0C: 64, 0x0D: 65, 0x0E: 1, 0x0F: 2, 0x10: 3, 0x11: 4, 0x12: 5,
    0x13: 6, 0x14: 7, 0x15: 8, 0x16: 9,
}  # fmt: skip
"""Parameters that take effect at once, each with a value other than its default."""


def write(number: int, value: int) -> str:
    return f"AF {number:02X} {value:02X} 55 2A"


def test_written_parameters_are_read_back(trex: Trex) -> None:
    """CMD10 0x9F. Every parameter that takes effect at once gets a different value."""
    for number, value in IMMEDIATE.items():
        trex.send(b"\xff")
        assert trex.request(write(number, value)) == "00", f"{number:02X}"
        if number == 0x00:
            trex.device = value
    assert {number: trex.request_byte(f"9F {number:02X}") for number in IMMEDIATE} == IMMEDIATE


@pytest.mark.parametrize("number", [0x18, 0x40, 0x7A])
def test_unknown_parameter_write_returns_1(trex: Trex, number: int) -> None:
    """CMD10 0xAF. There is no parameter between 0x17 and 0x7B (parameter lists of two clients)."""
    assert trex.request(write(number, 0)) == "01"
    assert trex.request("84") == "00"


@pytest.mark.parametrize(
    ("number", "value"), [(0x09, 4), (0x7B, 2), (0x7E, 0x0B), (0x7E, 0x0F), (0x7F, 0x00)]
)
def test_invalid_value_write_returns_2(trex: Trex, number: int, value: int) -> None:
    """CMD10 0xAF. Inferred: the limits of these parameters."""
    assert trex.request(write(number, value)) == "02"
    assert trex.request("84") == "00"


def test_rejected_write_changes_no_parameter(trex: Trex) -> None:
    """CMD10 0xAF: "the TReX has rejected the command packet"."""
    before = trex.show()["parameters"]
    for number, value in ((0x09, 4), (0x18, 1), (0x7B, 2), (0x7E, 0x0B)):
        assert trex.request(write(number, value)) != "00"
    trex.restart_in("rc")
    assert trex.request(write(0x0E, 5)) == "03"
    trex.restart_in("serial")
    assert trex.show()["parameters"] == before


def test_parameter_write_is_confirmed_after_about_4_ms(trex: Trex) -> None:
    """CMD10 0xAF: "approximately 4ms if the command packet format is correct"."""
    assert trex.request(write(0x0E, 1)) == "00"
    assert 0.0035 <= trex.reply_delay < 0.006
    assert trex.request_byte("9F 0E") == 1


def test_wrong_format_bytes_get_no_reply_within_50_ms(trex: Trex) -> None:
    """CMD10 0xAF: "made it untrustworthy". The UART error byte has "useful information"."""
    for ending in ("2A 55", "55 55", "2A 2A", "00 00"):
        trex.send(f"AF 0E 05 {ending}")
        assert trex.request("85") == "40", ending
    assert trex.gets_no_reply("AF 0E 05 55 2B", seconds=0.05)
    assert trex.request("85") == "40"
    assert trex.request("9F 0E") == "00"


def test_parameter_survives_power_cycles(trex: Trex) -> None:
    """CMD10 0xAF: "it will never need to be set again"."""
    assert trex.request(write(0x07, 99)) == "00"
    assert trex.request(write(0x11, 3)) == "00"
    for _ in range(2):
        trex.control("power off")
        trex.control("power on")
        assert (trex.request_byte("9F 07"), trex.request_byte("9F 11")) == (99, 3)


def test_parameters_with_documented_effects_act_at_once(trex: Trex) -> None:
    """CMD10 0xAF: parameters 0x00 to 0x16."""
    trex.connect(c1="1800us", c2="1800us")
    before = trex.request("87 03")
    assert trex.request(write(0x03, 0b11)) == "00"
    assert trex.request("87 03") != before
    assert trex.request(write(0x0E, 10)) == "00"
    trex.send("C6 7F")
    trex.wait(0.03)
    assert 0 < trex.motor(1)[1] <= trex.most_updates
    assert trex.request(write(0x07, 1)) == "00"
    trex.wait(0.12)
    assert trex.request("85") == "80"
    assert trex.request(write(0x00, 12)) == "00"
    assert trex.request(trex.add_crc(b"\x80\x0c\x02"), 1) == "72"


def test_motor_mode_7b_takes_effect_after_restart(trex: Trex) -> None:
    """CMD10 0xAF. The value 1 is joint mode, in which no current is measured (0x8D)."""
    assert trex.request(write(0x7B, 1)) == "00"
    trex.control("current 1 15")
    trex.wait(0.02)
    assert trex.request("8D") == "64"
    trex.restart()
    trex.wait(0.02)
    assert trex.request("8D") == "00"


def test_channel_input_source_7c_takes_effect_after_restart(trex: Trex) -> None:
    """CMD10 0xAF."""
    assert trex.request(write(0x7C, 1)) == "00"
    assert trex.request("82") == "72"
    trex.restart()
    assert trex.request("82") == "61"


@only(crc=True)
def test_crc_polynomial_7d_takes_effect_after_restart(trex: Trex) -> None:
    """CMD10 0xAF. The polynomial has eight bits, and the first bit is 1 (User's Guide 5.e)."""
    assert trex.request(write(0x7D, 0x65)) == "00"
    assert trex.request("82") == "72"
    trex.restart()
    assert trex.gets_no_reply(trex.packet("82"))
    assert trex.gets_no_reply(trex.packet("82"))
    trex.polynomial = 0xE5
    assert trex.request("85") == "20"
    assert trex.request("86 1F")


@only(crc=True)
@pytest.mark.parametrize("value", [0x00, 0x09, 0x37, 0x7F])
def test_polynomial_parameter_has_implied_top_bit(trex: Trex, value: int) -> None:
    """User's Guide 5.e."""
    trex.set_parameters(crc7_polynomial=value)
    trex.polynomial = 0x80 | value
    assert trex.request_byte("9F 7D") == value
    assert bytes.fromhex(trex.request("81")) == b"TReX1.2"


@only(harness="wire")  # bytes have no rate in the parser
def test_uart_settings_7e_take_effect_after_restart(trex: Trex) -> None:
    """CMD10 0xAF. 57600 baud is one of the rates in User's Guide 5.a."""
    crc = WITH_CRC if trex.variant.crc else 0
    assert trex.request(write(0x7E, RATES.index(57600) | crc)) == "00"
    assert trex.request("82") == "72"
    trex.restart()
    trex.set_host_baud(57600)
    assert trex.request("82") == "72"


def test_factory_reset_7f_takes_effect_after_restart(trex: Trex) -> None:
    """CMD10 0xAF. The value 0x7F is from forum thread 4631."""
    assert trex.request(write(0x0E, 5)) == "00"
    assert trex.request(write(0x7F, 0x7F)) == "00"
    assert trex.request("9F 0E") == "05"
    trex.restart()
    assert trex.show()["parameters"]["motor1_acceleration"] == 0
