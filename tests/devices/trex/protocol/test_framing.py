"""How a command is wrapped: compact or expanded, with or without CRC-7."""

import pytest

from trex_gui.core.errors import BadRequest
from trex_gui.devices.trex.protocol.commands import (
    Command,
    DriveAuxiliary,
    GetRawChannels,
    GetSignature,
    SetParameter,
)
from trex_gui.devices.trex.protocol.framing import Framing


@pytest.mark.parametrize(
    ("command", "device_number", "packet"),
    [
        (GetRawChannels(), None, "86 1f 07"),
        (GetSignature(), None, "81 48"),
        (DriveAuxiliary(127), None, "f0 7f 4d"),
        (SetParameter(0x00, 7), None, "af 00 07 55 2a 47"),
        (GetRawChannels(), 7, "80 07 06 1f 0b"),
    ],
)
def test_crc_follows_packet_and_covers_all_of_it(
    command: Command[object], device_number: int | None, packet: str
) -> None:
    assert Framing(device_number, 0x89).encode(command) == bytes.fromhex(packet)


@pytest.mark.parametrize("device_number", [-1, 128, 255])
def test_invalid_device_number_is_rejected_with_limits(
    device_number: int,
) -> None:
    with pytest.raises(BadRequest, match=f"device number is 0 to 127, not {device_number}"):
        Framing(device_number)


@pytest.mark.parametrize("polynomial", [0x00, 0x09, 0x7F, 0x100])
def test_polynomial_without_top_bit_is_rejected_with_limits(polynomial: int) -> None:
    with pytest.raises(BadRequest, match="0x80 to 0xFF"):
        Framing(None, polynomial)


def test_invalid_parameter_value_is_rejected_on_encode() -> None:
    with pytest.raises(BadRequest, match="parameter value is 0 to 127, not 128"):
        Framing().encode(SetParameter(0, 128))


@pytest.mark.parametrize(
    ("framing", "size"), [(Framing(), 0), (Framing(7), 0), (Framing(7, 0x89), 1)]
)
def test_crc_adds_one_byte_when_enabled(framing: Framing, size: int) -> None:
    assert framing.crc_size == size
