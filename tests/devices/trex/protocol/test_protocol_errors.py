"""Sentences of protocol errors."""

import pytest

from trex_gui.core.errors import describe
from trex_gui.devices.trex.protocol.errors import ErrorCode, Rejected, ResultCode, TrexBadReplyError


def test_four_fields_suffice_for_every_sentence() -> None:
    for code in ErrorCode:
        assert describe(code, ("A", "B", "C", "D"))


def test_error_inside_an_error_is_translated() -> None:
    cause = TrexBadReplyError(ErrorCode.LATE_REPLIES)
    text = describe(ErrorCode.OTHER_DEVICE, ("COM3", cause), str.upper)
    assert "LATE REPLIES" in text


@pytest.mark.parametrize(
    ("code", "words"),
    [
        (
            ResultCode.BAD_PARAMETER,
            "(code 1); its firmware may be too old",
        ),
        (ResultCode.BAD_VALUE, "rejects this value (code 2)"),
        (
            ResultCode.NOT_SERIAL_MODE,
            "serial mode (code 3); switch it off, remove the mode jumper",
        ),
    ],
)
def test_rejection_names_subject_and_reason(code: ResultCode, words: str) -> None:
    sentence = str(Rejected("Serial Timeout", code))
    assert sentence.startswith("Serial Timeout: ")
    assert words in sentence
