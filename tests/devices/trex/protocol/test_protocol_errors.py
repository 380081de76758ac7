"""Errors are sentences that survive the way to another thread or process."""

import copy
import pickle

import pytest

from trex_gui.core import errors
from trex_gui.core.errors import (
    BadReply,
    BadRequest,
    CodedError,
    InternalError,
    NoReply,
    PortShared,
    PortUnavailable,
    StudioError,
    describe,
)
from trex_gui.devices.trex.protocol import errors as trex_errors
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import (
    BoardElsewhere,
    ErrorCode,
    OtherBoard,
    Rejected,
    ResultCode,
    Skipped,
    TrexBadReplyError,
    TrexError,
    TrexInternalError,
    TrexNoReplyError,
    TrexRequestError,
)

EVERY_ERROR: list[StudioError] = [
    StudioError("the worst has happened"),
    BadRequest("a speed is 0 to 127, not 128"),
    PortUnavailable("/dev/ttyUSB0 is busy"),
    PortShared("another program reads /dev/ttyUSB0"),
    NoReply("2 of 7 bytes came"),
    BadReply("the CRC is 08, not 07"),
    InternalError("the connection was closed"),
    *(Rejected("Serial Timeout", code) for code in ResultCode if code),
    CodedError(ErrorCode.INTERNAL, "a bug"),
    TrexError(ErrorCode.CLOSED),
    TrexRequestError(ErrorCode.LOCKED_OUT),
    TrexNoReplyError(ErrorCode.NO_REPLY, "81"),
    TrexBadReplyError(ErrorCode.OTHER_DEVICE, "COM3", "It is garbled."),
    TrexInternalError(ErrorCode.INTERNAL, "KeyError(7)"),
    OtherBoard(ErrorCode.OTHER_VALUES),
    BoardElsewhere(
        ErrorCode.OTHER_BAUD, "COM3", "TReX 1.2", "9600", "19200", ConnectionSettings("COM3")
    ),
    Skipped(ErrorCode.WRITE_CANCELLED),
]


def test_examples_cover_every_error() -> None:
    defined = {
        found
        for module in (errors, trex_errors)
        for found in vars(module).values()
        if isinstance(found, type) and issubclass(found, StudioError)
    }
    assert {type(error) for error in EVERY_ERROR} == defined


@pytest.mark.parametrize("error", EVERY_ERROR, ids=repr)
def test_pickled_error_keeps_its_message(error: StudioError) -> None:
    arrived = pickle.loads(pickle.dumps(error))
    assert type(arrived) is type(error)
    assert str(arrived) == str(error)
    assert arrived.args == error.args


@pytest.mark.parametrize("error", EVERY_ERROR, ids=repr)
def test_copied_error_keeps_its_message(error: StudioError) -> None:
    assert str(copy.deepcopy(error)) == str(error)


def test_pickled_rejection_keeps_subject_and_code() -> None:
    error = Rejected("calibration of channel 2", ResultCode.BAD_VALUE)
    arrived = pickle.loads(pickle.dumps(error))
    assert isinstance(arrived, Rejected)
    assert arrived.what == "calibration of channel 2"
    assert arrived.result is ResultCode.BAD_VALUE


@pytest.mark.parametrize("code", list(ErrorCode))
def test_every_code_has_a_sentence(code: ErrorCode) -> None:
    assert "{" not in describe(code, ("A", "B", "C", "D"))


def test_error_inside_an_error_is_translated_too() -> None:
    cause = TrexBadReplyError(ErrorCode.LATE_REPLIES)
    text = describe(ErrorCode.OTHER_DEVICE, ("COM3", cause), str.upper)
    assert "LATE REPLIES" in text


@pytest.mark.parametrize(
    ("code", "words"),
    [
        (ResultCode.BAD_PARAMETER, "does not know this parameter (code 1)"),
        (ResultCode.BAD_VALUE, "rejects this value (code 2)"),
        (ResultCode.NOT_SERIAL_MODE, "not in serial mode (code 3)"),
    ],
)
def test_rejection_names_subject_and_reason(code: ResultCode, words: str) -> None:
    sentence = str(Rejected("Serial Timeout", code))
    assert sentence.startswith("Serial Timeout: ")
    assert words in sentence


def test_result_codes_match_documentation() -> None:
    assert {code.name: int(code) for code in ResultCode} == {
        "OK": 0,
        "BAD_PARAMETER": 1,
        "BAD_VALUE": 2,
        "NOT_SERIAL_MODE": 3,
    }


@pytest.mark.parametrize("error", EVERY_ERROR, ids=repr)
def test_every_error_is_a_trex_error(error: StudioError) -> None:
    assert isinstance(error, StudioError)
    assert isinstance(error, ValueError) is isinstance(error, BadRequest)
