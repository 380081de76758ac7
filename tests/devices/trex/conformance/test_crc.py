"""Cyclic redundancy check: CMD10 General Overview and User's Guide 5.e.

Every test of this folder runs with and without CRC. `Trex.request` checks the CRC of each reply.
"""

import pytest

from tests.devices.trex.conformance.trex import Trex, only

EXAMPLES = [
    ("86 1F", 0x07),
    ("81", 0x48),
    ("F0 7F", 0x4D),
    ("AF 00 07 55 2A", 0x47),
    ("80 07 06 1F", 0x0B),
]
"""Packets and their CRC. The guide calculates the first, and the others are calculated by hand."""


@only(crc=True)
@pytest.mark.parametrize(("packet", "crc"), EXAMPLES)
def test_packets_with_example_crc_are_accepted(trex: Trex, packet: str, crc: int) -> None:
    """User's Guide 5.e."""
    trex.exchange(bytes.fromhex(packet) + bytes([crc]))
    assert trex.request("85") == "00"


@only(crc=True)
def test_packet_with_flipped_data_bit_is_discarded(trex: Trex) -> None:
    """CMD10 0x85: a CRC that does not match is an error. The CRC detects each flipped bit."""
    packet = trex.packet("F0 7F")
    for index in range(1, len(packet)):
        for bit in range(7):
            corrupted = bytearray(packet)
            corrupted[index] ^= 1 << bit
            trex.send(bytes(corrupted))
    assert trex.show()["aux"]["speed"] == 0


@only(crc=True)
@pytest.mark.parametrize("value", [0x00, 0x09, 0x37, 0x7F])
def test_polynomial_parameter_has_implied_top_bit(trex: Trex, value: int) -> None:
    """User's Guide 5.e."""
    trex.set_parameters(crc7_polynomial=value)
    trex.polynomial = 0x80 | value
    assert trex.request_byte("9F 7D") == value
    assert bytes.fromhex(trex.request("81")) == b"TReX1.2"
