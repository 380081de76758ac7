"""Descriptions of commands and replies."""

import pytest

from trex_gui.devices.trex.protocol.commands import (
    GetCalibratedChannels,
    GetCurrents,
    GetParameter,
    GetRawChannels,
    SetParameter,
    Signature,
)
from trex_gui.devices.trex.protocol.descriptions import describe, describe_reply, is_refusal
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.errors import ResultCode

TREX_JR = Signature(device_table().model("trexjr"), "1.2")


@pytest.mark.parametrize(
    ("mask", "words"),
    [
        (0b00000, "no channel"),
        (0b00010, "channel 2"),
        (0b10010, "channels 2, 5"),
        (0b11111, "all channels"),
    ],
)
def test_channel_mask_is_named(mask: int, words: str) -> None:
    assert describe_reply(GetCalibratedChannels(), mask) == words
    assert describe(GetRawChannels(mask)) == f"get raw inputs of {words}"


@pytest.mark.parametrize(("board", "lacking"), [(None, "no TReX"), (TREX_JR, "no TReX Jr 1.2")])
def test_unknown_parameter_names_board_that_lacks_it(board: Signature | None, lacking: str) -> None:
    assert describe(GetParameter(0x6F), board) == f"get parameter 0x6f, which {lacking} has"
    assert describe(SetParameter(0x6F, 5), board) == (
        f"set parameter 0x6f, which {lacking} has to 0x05"
    )


def test_reply_uses_the_units_of_the_board() -> None:
    assert describe_reply(GetCurrents(), (1, 20)) == "motor 1: 1 counts, motor 2: 20 counts"
    assert describe_reply(GetCurrents(), (1, 20), TREX_JR) == "motor 1: 0.04 A, motor 2: 0.80 A"


def test_channel_without_signal_is_named() -> None:
    words = describe_reply(GetRawChannels(0b11), {1: 3750, 2: None})
    assert words == "1: 3750, 2: no signal"


@pytest.mark.parametrize("value", [ResultCode.OK, 0, 2, None, {1: 3750}])
def test_value_or_ok_is_no_refusal(value: object) -> None:
    assert not is_refusal(value)


@pytest.mark.parametrize("code", [code for code in ResultCode if code is not ResultCode.OK])
def test_result_code_other_than_ok_is_a_refusal(code: ResultCode) -> None:
    assert is_refusal(code)
    assert describe_reply(SetParameter(7, 5), code).startswith("rejected: ")
