"""Parameter 0x7E: baud rate, error detection and stop bits."""

import pytest

from trex_gui.protocol.errors import BadRequest
from trex_gui.protocol.line_settings import Detection, LineSettings, baud_rates

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
def test_the_bits_mean_what_the_reference_says(
    wire: int, baud: int, detection: Detection, stop_bits: int
) -> None:
    settings = LineSettings(baud, detection, stop_bits)
    assert LineSettings.from_wire(wire) == settings
    assert settings.to_wire() == wire


def test_a_board_leaves_the_factory_with_19200_baud_and_nothing_else() -> None:
    assert LineSettings() == LineSettings(19200, Detection.NONE, 1)
    assert LineSettings().to_wire() == 0x05


@pytest.mark.parametrize("wire", [0x25, 0x2A, 0x35])
def test_bits_01_enable_the_crc(wire: int) -> None:
    assert wire >> 5 & 0b11 == 0b01
    assert LineSettings.from_wire(wire).detection is Detection.CRC7


def test_every_valid_setting_comes_back() -> None:
    assert [LineSettings.from_wire(wire).to_wire() for wire in VALID] == VALID


def test_every_other_value_is_refused() -> None:
    for wire in {*range(-1, 0x101)} - {*VALID}:
        with pytest.raises(BadRequest):
            LineSettings.from_wire(wire)


def test_there_are_exactly_88_settings() -> None:
    assert len(VALID) == 88
    assert len({LineSettings.from_wire(wire) for wire in VALID}) == 88


def test_there_are_eleven_baud_rates_from_1200_to_115200() -> None:
    rates = baud_rates()
    assert len(rates) == 11
    assert (rates[0], rates[-1]) == (1200, 115200)


def test_a_baud_rate_that_the_board_lacks_is_refused_with_those_it_has() -> None:
    with pytest.raises(BadRequest, match=r"1200, 2400, .*, 115200 baud, not 31250"):
        LineSettings(31250).to_wire()


@pytest.mark.parametrize("stop_bits", [0, 3])
def test_other_stop_bits_are_refused_with_the_limits(stop_bits: int) -> None:
    with pytest.raises(BadRequest, match=f"1 or 2 stop bits, not {stop_bits}"):
        LineSettings(stop_bits=stop_bits).to_wire()


@pytest.mark.parametrize("firmware", ["1.0", "1.1"])
@pytest.mark.parametrize(("chosen", "real"), [(38400, 19200), (28800, 14400)])
def test_old_firmware_runs_at_half_of_two_rates(firmware: str, chosen: int, real: int) -> None:
    assert LineSettings(chosen).real_baud(firmware) == real


@pytest.mark.parametrize("firmware", ["1.0", "1.1"])
def test_old_firmware_runs_at_all_other_rates_rightly(firmware: str) -> None:
    for baud in set(baud_rates()) - {28800, 38400}:
        assert LineSettings(baud).real_baud(firmware) == baud


@pytest.mark.parametrize("firmware", ["1.2", "1.3", "1.10", "2.0"])
def test_newer_firmware_runs_at_the_chosen_rate(firmware: str) -> None:
    for baud in baud_rates():
        assert LineSettings(baud).real_baud(firmware) == baud


@pytest.mark.parametrize(
    ("detection", "stop_bits", "bits"),
    [
        (Detection.NONE, 1, 10),
        (Detection.NONE, 2, 11),
        (Detection.CRC7, 1, 10),
        (Detection.EVEN, 1, 11),
        (Detection.ODD, 1, 11),
        (Detection.EVEN, 2, 12),
    ],
)
def test_a_byte_takes_start_data_parity_and_stop_bits(
    detection: Detection, stop_bits: int, bits: int
) -> None:
    assert LineSettings(19200, detection, stop_bits).bits_per_byte == bits


def test_a_byte_at_19200_baud_takes_about_half_a_millisecond() -> None:
    assert LineSettings().seconds(1) == pytest.approx(10 / 19200)


def test_seconds_grow_with_the_bytes() -> None:
    assert LineSettings(9600, Detection.EVEN, 2).seconds(80) == pytest.approx(0.1)


def test_seconds_can_be_told_the_real_rate_of_old_firmware() -> None:
    settings = LineSettings(38400)
    real = settings.real_baud("1.0")
    assert settings.seconds(1, real) == pytest.approx(10 / 19200)


@pytest.mark.parametrize(
    ("wire", "text"),
    [
        (0x05, "19200 baud, no error detection, 1 stop bit"),
        (0x3A, "115200 baud, CRC-7, 2 stop bits"),
        (0x43, "9600 baud, even parity, 1 stop bit"),
        (0x73, "9600 baud, odd parity, 2 stop bits"),
    ],
)
def test_settings_are_shown_in_words(wire: int, text: str) -> None:
    assert LineSettings.from_wire(wire).text() == text


def test_a_set_top_bit_is_not_blamed_on_the_baud_rate() -> None:
    with pytest.raises(BadRequest) as caught:
        LineSettings.from_wire(0x85)
    assert "no baud rate" not in str(caught.value)
