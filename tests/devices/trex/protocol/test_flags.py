"""Status and error bits, channel masks, modes, and units of raw counts."""

from enum import IntFlag

import pytest

from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.protocol.flags import (
    STATUS_MEANING,
    UART_MEANING,
    InputSource,
    Mode,
    Status,
    UartError,
    channel_mask,
    channels_in,
)


@pytest.mark.parametrize(
    ("bit", "flag", "name"),
    [
        (7, Status.MOTOR2_OVER_LIMIT, "Motor 2 over current limit"),
        (6, Status.MOTOR2_FAULT, "Motor 2 fault"),
        (5, Status.MOTOR1_OVER_LIMIT, "Motor 1 over current limit"),
        (4, Status.MOTOR1_FAULT, "Motor 1 fault"),
        (0, Status.UART_ERROR, "UART error"),
        (7, UartError.TIMEOUT, "Serial timeout"),
        (6, UartError.FORMAT, "Format error"),
        (5, UartError.CRC, "CRC error"),
        (4, UartError.FRAMING, "Framing error"),
        (3, UartError.DATA_OVERRUN, "Data overrun"),
        (2, UartError.PARITY, "Parity error"),
        (1, UartError.READ_OVERRUN, "Read buffer overrun"),
        (0, UartError.SEND_OVERRUN, "Send buffer overrun"),
    ],
)
def test_bits_match_documentation(bit: int, flag: Status | UartError, name: str) -> None:
    assert flag == 1 << bit
    assert (STATUS_MEANING[flag] if isinstance(flag, Status) else UART_MEANING[flag])[0] == name


def test_status_bits_1_to_3_are_unused() -> None:
    assert sum(Status) == 0b1111_0001


@pytest.mark.parametrize(
    ("flags", "meanings"), [(Status, STATUS_MEANING), (UartError, UART_MEANING)]
)
def test_every_bit_is_explained_highest_first(
    flags: type[IntFlag], meanings: dict[IntFlag, tuple[str, str]]
) -> None:
    assert list(meanings) == sorted(flags, reverse=True)
    for name, explanation in meanings.values():
        assert name
        assert explanation.endswith(".")


def test_mask_bit_n_is_channel_n_plus_1() -> None:
    assert [channels_in(mask) for mask in (0, 0x01, 0x13)] == [(), (1,), (1, 2, 5)]
    assert all(channel_mask(channels_in(mask)) == mask for mask in range(32))


@pytest.mark.parametrize("channel", [-1, 0, 6])
def test_invalid_channel_number_is_rejected(channel: int) -> None:
    with pytest.raises(BadRequest, match=f"the channel number must be 1 to 5, not {channel}"):
        channel_mask([1, channel])


@pytest.mark.parametrize(
    ("source", "count", "physical", "text"),
    [
        (InputSource.RC, 3750, 1500, "1500 µs"),
        (InputSource.RC, 3637, 1454.8, "1455 µs"),
        (InputSource.RC, 6250, 2500, "2500 µs"),
        (InputSource.ANALOG, 1023, 5, "5.00 V"),
        (InputSource.ANALOG, 512, 2.502, "2.50 V"),
        (InputSource.ANALOG, 0, 0, "0.00 V"),
    ],
)
def test_count_converts_to_pulse_width_or_voltage(
    source: InputSource, count: int, physical: float, text: str
) -> None:
    assert source.physical(count) == pytest.approx(physical, rel=0.001)
    assert source.text(count) == text


@pytest.mark.parametrize("source", InputSource)
def test_counts_round_trip(source: InputSource) -> None:
    for count in range(source.highest_count + 1):
        assert source.counts(source.physical(count)) == count


@pytest.mark.parametrize(
    ("source", "lowest", "highest"),
    [(InputSource.RC, 500.0, 2500.0), (InputSource.ANALOG, 0.0, 5.0)],
)
def test_counts_span_physical_range_of_source(
    source: InputSource, lowest: float, highest: float
) -> None:
    assert source.physical(source.lowest_count) == lowest
    assert source.physical(source.highest_count) == highest


@pytest.mark.parametrize(
    ("letter", "is_serial", "source"),
    [
        ("R", False, InputSource.RC),
        ("A", False, InputSource.ANALOG),
        ("r", True, InputSource.RC),
        ("a", True, InputSource.ANALOG),
    ],
)
def test_lower_case_mode_letter_means_serial_mode(
    letter: str, is_serial: bool, source: InputSource
) -> None:
    assert Mode(letter).is_serial is is_serial
    assert Mode(letter).source is source
