"""Baud rate, error detection and stop bits (parameter 0x7E), and their short text."""

from dataclasses import replace

import pytest

from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings, baud_rates

VALID = [wire for wire in range(0x80) if wire & 0x0F <= 10]


@pytest.mark.parametrize(
    ("wire", "baud", "detection", "stop_bits"),
    [
        (0x0A, 115200, Detection.NONE, 1),
        (0x05, 19200, Detection.NONE, 1),
        (0x00, 1200, Detection.NONE, 1),
        (0x03, 9600, Detection.NONE, 1),
        (0x25, 19200, Detection.CRC7, 1),
        (0x15, 19200, Detection.NONE, 2),
        (0x45, 19200, Detection.EVEN, 1),
        (0x65, 19200, Detection.ODD, 1),
        (0x7A, 115200, Detection.ODD, 2),
    ],
)
def test_wire_bits_match_reference(
    wire: int, baud: int, detection: Detection, stop_bits: int
) -> None:
    settings = LineSettings(baud, detection, stop_bits)
    assert LineSettings.from_wire(wire) == settings
    assert settings.to_wire() == wire


def test_valid_settings_round_trip() -> None:
    assert [LineSettings.from_wire(wire).to_wire() for wire in VALID] == VALID


def test_invalid_wire_values_are_rejected() -> None:
    for wire in {*range(-1, 0x101)} - {*VALID}:
        with pytest.raises(BadRequest):
            LineSettings.from_wire(wire)


def test_unknown_baud_rate_is_rejected_with_valid_rates() -> None:
    with pytest.raises(BadRequest, match=r"1200, 2400, .*, 115200 baud, not 31250"):
        LineSettings(31250).to_wire()


@pytest.mark.parametrize("stop_bits", [0, 3])
def test_invalid_stop_bits_are_rejected_with_limits(stop_bits: int) -> None:
    with pytest.raises(BadRequest, match=f"must be 1 or 2, not {stop_bits}"):
        LineSettings(stop_bits=stop_bits).to_wire()


@pytest.mark.parametrize("firmware", ["1.0", "1.1", "1.2", "1.3", "1.10", "2.0"])
def test_only_old_firmware_halves_two_baud_rates(firmware: str) -> None:
    halved = {38400: 19200, 28800: 14400} if firmware in {"1.0", "1.1"} else {}
    for baud in baud_rates():
        assert LineSettings(baud).real_baud(firmware) == halved.get(baud, baud)


@pytest.mark.parametrize(
    ("detection", "stop_bits", "bits"),
    [
        (Detection.NONE, 1, 10),
        (Detection.NONE, 2, 11),
        (Detection.CRC7, 1, 10),
        (Detection.EVEN, 1, 11),
        (Detection.EVEN, 2, 12),
    ],
)
def test_bits_per_byte_include_parity_and_stop_bits(
    detection: Detection, stop_bits: int, bits: int
) -> None:
    assert LineSettings(19200, detection, stop_bits).bits_per_byte == bits


def test_80_bytes_of_12_bits_take_100_ms_at_9600_baud() -> None:
    assert LineSettings(9600, Detection.EVEN, 2).seconds(80) == pytest.approx(0.1)


def test_set_top_bit_is_not_reported_as_bad_baud_rate() -> None:
    with pytest.raises(BadRequest, match="wire value from 0 to 127, not 133"):
        LineSettings.from_wire(0x85)


@pytest.mark.parametrize(
    ("detection", "text"),
    [
        (Detection.NONE, "57600 baud, 2 stop bits"),
        (Detection.EVEN, "57600 baud, even parity, 2 stop bits"),
        (Detection.ODD, "57600 baud, odd parity, 2 stop bits"),
        (Detection.CRC7, "57600 baud, CRC-7, 2 stop bits"),
    ],
)
def test_short_text_omits_common_settings(detection: Detection, text: str) -> None:
    settings = ConnectionSettings("/dev/ttyUSB0", LineSettings(57600, detection, 2))
    assert settings.short == text
    assert replace(settings, line=LineSettings()).short == "19200 baud"
