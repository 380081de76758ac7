"""CRC-7 against a long division by hand, as the guide describes it."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.devices.trex.oracle.framing import remainder
from tests.support.matrix import examples
from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.protocol.framing import DEFAULT_POLYNOMIAL, check_polynomial, crc7

modest = examples(40)
polynomials = st.integers(0x80, 0xFF)


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
def test_guide_packets_have_their_printed_crc(packet: str, crc: int) -> None:
    assert crc7(bytes.fromhex(packet)) == crc


def test_default_polynomial_is_0x89() -> None:
    assert DEFAULT_POLYNOMIAL == 0x89


@modest
@given(data=st.binary(max_size=24), polynomial=polynomials)
def test_crc_is_remainder_of_remainder(data: bytes, polynomial: int) -> None:
    assert crc7(data, polynomial) == remainder(data, polynomial)


def test_every_polynomial_gives_right_crc_of_single_bytes() -> None:
    for polynomial in range(0x80, 0x100):
        for byte in (0x00, 0x01, 0x55, 0x80, 0x86, 0xFF):
            data = bytes([byte])
            assert crc7(data, polynomial) == remainder(data, polynomial)


@pytest.mark.parametrize("polynomial", [0x00, 0x09, 0x7F, 0x100, -0x77])
def test_polynomial_without_top_bit_is_rejected_with_limits(polynomial: int) -> None:
    with pytest.raises(BadRequest, match="0x80 to 0xFF"):
        crc7(b"\x81", polynomial)


@pytest.mark.parametrize("polynomial", [0x80, 0x89, 0xFF])
def test_polynomial_with_top_bit_is_accepted(polynomial: int) -> None:
    assert check_polynomial(polynomial) == polynomial
