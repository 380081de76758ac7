"""Packet encoder, and CRC-7 compared with the long division in the guide."""

from collections.abc import Callable

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.devices.trex.oracle.framing import remainder
from tests.support.matrix import examples
from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.protocol.framing import Framing, PacketParser, crc7


@pytest.mark.parametrize(
    ("packet", "crc"),
    [
        ("86 1f", 0x07),
        ("81", 0x48),
        ("f0 7f", 0x4D),
        ("af 00 07 55 2a", 0x47),
        ("80 07 06 1f", 0x0B),
    ],
)
def test_crc_of_packets_matches_reference(packet: str, crc: int) -> None:
    assert crc7(bytes.fromhex(packet)) == crc


@examples(40)
@given(data=st.binary(max_size=24), polynomial=st.integers(0x80, 0xFF))
def test_crc_is_remainder_of_long_division(data: bytes, polynomial: int) -> None:
    assert crc7(data, polynomial) == remainder(data, polynomial)


@pytest.mark.parametrize("polynomial", [0x00, 0x09, 0x7F, 0x100, -0x77])
@pytest.mark.parametrize(
    "use",
    [
        lambda polynomial: crc7(b"\x81", polynomial),
        lambda polynomial: Framing(None, polynomial),
        PacketParser,
    ],
)
def test_polynomial_without_top_bit_is_rejected_with_limits(
    use: Callable[[int], object], polynomial: int
) -> None:
    with pytest.raises(BadRequest, match="0x80 to 0xFF"):
        use(polynomial)


@pytest.mark.parametrize("device_number", [-1, 128, 255])
def test_invalid_device_number_is_rejected_with_limits(device_number: int) -> None:
    with pytest.raises(BadRequest, match=f"device number must be 0 to 127, not {device_number}"):
        Framing(device_number)
