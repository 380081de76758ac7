"""Errors of a connection to a board: a code with fields, and the sentence for each code."""

from collections.abc import Callable
from enum import Enum, IntEnum, auto

from trex_gui.core.errors import BadReply, BadRequest, NoReply, StudioError


class ResultCode(IntEnum):
    """Reply to 0xA0-0xA4 and 0xAF.

    Ref: TReX 1.0 command documentation, "set channel calibration", "set configuration
    parameter".
    """

    OK = 0
    BAD_PARAMETER = 1
    BAD_VALUE = 2
    NOT_SERIAL_MODE = 3


class ErrorCode(Enum):
    """What went wrong; `_TEXTS` shows the fields of each code."""

    # Connecting
    NO_BOARD = auto()
    NO_BOARD_AT_NUMBER = auto()
    ECHO_ONLY = auto()
    OTHER_DEVICE = auto()
    # Transactions
    NO_REPLY = auto()
    INCOMPLETE_REPLY = auto()
    CORRUPTED_REPLY = auto()
    LATE_REPLIES = auto()
    # Motors
    STOP_UNCONFIRMED = auto()
    STOP_ON_NOISY_LINE = auto()
    NO_HEARTBEAT = auto()
    LOCKED_OUT = auto()
    OVERTAKEN_BY_STOP = auto()
    # Writes
    BAD_PARAMETER = auto()
    BAD_VALUE = auto()
    NOT_SERIAL_MODE = auto()
    PARAMETER_MISMATCH = auto()
    CALIBRATION_MISMATCH = auto()
    OTHER_SOURCE = auto()
    WRITE_CANCELLED = auto()
    LINE_SETTINGS_UNCERTAIN = auto()
    # The session
    SCANNING = auto()
    NOT_READ = auto()
    CLOSED = auto()
    INTERNAL = auto()


def QT_TRANSLATE_NOOP(context: str, text: str) -> str:  # noqa: N802 - the name that lupdate finds
    """Mark a text for translation without Qt."""
    del context
    return text


_TEXTS = {
    ErrorCode.NO_BOARD: QT_TRANSLATE_NOOP(
        "TrexErrors",
        "No TReX answers on {0}. Check that the board has power (an LED is lit), that the "
        "adapter's TX goes to SI and its RX to SO (or both RS-232 pins, never mixed), that "
        "ground is connected, and that the board's serial settings are these.",
    ),
    ErrorCode.NO_BOARD_AT_NUMBER: QT_TRANSLATE_NOOP(
        "TrexErrors",
        "No TReX answers on {0}. Check that the board has power (an LED is lit), that the "
        "adapter's TX goes to SI and its RX to SO (or both RS-232 pins, never mixed), that "
        "ground is connected, and that the board's serial settings are these, its device number "
        "is {1}.",
    ),
    ErrorCode.ECHO_ONLY: QT_TRANSLATE_NOOP(
        "TrexErrors",
        "Everything sent on {0} comes back, and nothing else. Either this is the RS-232 side of a "
        "board that is off or set to another baud rate, or the adapter's TX and RX are joined.",
    ),
    ErrorCode.OTHER_DEVICE: QT_TRANSLATE_NOOP(
        "TrexErrors",
        "Something answers on {0}, but not as a TReX does. {1} Most often the baud rate, parity "
        "or CRC is not the one set in the board; or another device is connected.",
    ),
    ErrorCode.NO_REPLY: QT_TRANSLATE_NOOP("TrexErrors", "No answer to {0}."),
    ErrorCode.INCOMPLETE_REPLY: QT_TRANSLATE_NOOP("TrexErrors", "Only {1} came in answer to {0}."),
    ErrorCode.CORRUPTED_REPLY: QT_TRANSLATE_NOOP("TrexErrors", "The reply {0} is damaged: {1}."),
    ErrorCode.LATE_REPLIES: QT_TRANSLATE_NOOP(
        "TrexErrors", "Late replies arrived and cannot be matched to requests."
    ),
    ErrorCode.STOP_UNCONFIRMED: QT_TRANSLATE_NOOP(
        "TrexErrors",
        "The stop was sent, but the board does not confirm it. If a motor still turns, cut its "
        "power.",
    ),
    ErrorCode.STOP_ON_NOISY_LINE: QT_TRANSLATE_NOOP(
        "TrexErrors",
        "The stop was sent and the board answers, but the line damages bytes. It is sent again "
        "until the line is quiet. If a motor still turns, cut its power.",
    ),
    ErrorCode.NO_HEARTBEAT: QT_TRANSLATE_NOOP(
        "TrexErrors", "The window did not respond for a second."
    ),
    ErrorCode.LOCKED_OUT: QT_TRANSLATE_NOOP(
        "TrexErrors", "The motors are locked for a while after a stop; nothing was sent."
    ),
    ErrorCode.OVERTAKEN_BY_STOP: QT_TRANSLATE_NOOP(
        "TrexErrors", "A stop came before it; nothing was sent."
    ),
    ErrorCode.BAD_PARAMETER: QT_TRANSLATE_NOOP(
        "TrexErrors",
        "{0}: the board does not know this parameter (code 1); its firmware may be too old for it",
    ),
    ErrorCode.BAD_VALUE: QT_TRANSLATE_NOOP(
        "TrexErrors", "{0}: the board rejects this value (code 2)"
    ),
    ErrorCode.NOT_SERIAL_MODE: QT_TRANSLATE_NOOP(
        "TrexErrors",
        "{0}: the board is not in serial mode (code 3); switch it off, remove the mode jumper, "
        "switch it on again",
    ),
    ErrorCode.PARAMETER_MISMATCH: QT_TRANSLATE_NOOP(
        "TrexErrors",
        "{0} could not be verified: wrote {1}, but the board reads back {2}",
    ),
    ErrorCode.CALIBRATION_MISMATCH: QT_TRANSLATE_NOOP(
        "TrexErrors", "{0} could not be verified: the board reads back {1}"
    ),
    ErrorCode.OTHER_SOURCE: QT_TRANSLATE_NOOP(
        "TrexErrors", "{0} is for {1} inputs, but the board reads {2} now"
    ),
    ErrorCode.WRITE_CANCELLED: QT_TRANSLATE_NOOP(
        "TrexErrors", "The writing was cancelled before this was tried."
    ),
    ErrorCode.LINE_SETTINGS_UNCERTAIN: QT_TRANSLATE_NOOP(
        "TrexErrors",
        "{0} {1} may be the factory default meanwhile: the board, switched off and on, then runs "
        "at {2}",
    ),
    ErrorCode.SCANNING: QT_TRANSLATE_NOOP(
        "TrexErrors", "The board is not responding; scanning for it."
    ),
    ErrorCode.NOT_READ: QT_TRANSLATE_NOOP("TrexErrors", "No board has been read yet."),
    ErrorCode.CLOSED: QT_TRANSLATE_NOOP(
        "TrexErrors", "The connection was closed before this was done."
    ),
    ErrorCode.INTERNAL: QT_TRANSLATE_NOOP("TrexErrors", "Internal error in the connection: {0}"),
}


def describe(
    code: ErrorCode, fields: tuple[object, ...] = (), translate: Callable[[str], str] = str
) -> str:
    """Return the sentence for an error; `translate` is applied to the texts of this module."""
    texts = [
        describe(field.code, field.fields, translate) if isinstance(field, TrexError) else field
        for field in fields
    ]
    return translate(_TEXTS[code]).format(*texts)


class TrexError(StudioError):
    """An error with a code; `str` gives its sentence in English."""

    def __init__(self, code: ErrorCode, *fields: object) -> None:
        super().__init__(code, *fields)
        self.code = code
        self.fields = fields

    def __str__(self) -> str:
        return describe(self.code, self.fields)


class TrexRequestError(TrexError, BadRequest):
    """Rejected in the present state; nothing was sent."""


class TrexNoReplyError(TrexError, NoReply):
    """The board does not answer, or does not confirm."""


class TrexBadReplyError(TrexError, BadReply):
    """The bytes that arrived are no reply, or the board reads back another value."""


class Skipped(TrexError):  # noqa: N818 - nothing went wrong
    """The write was cancelled before this had its turn; it is unchanged."""


class Rejected(TrexError):  # noqa: N818 - reads as a result, like `Outcome`
    """The board understood a write and rejected it.

    Attributes:
        what: what was written, for messages ("Serial Timeout", "calibration of channel 2").
        result: the board's reply.
    """

    def __init__(self, what: str, result: ResultCode) -> None:
        super().__init__(_REJECTIONS[result], what)
        self.what = what
        self.result = result
        self.args = (what, result)  # so that it can be pickled


_REJECTIONS = {
    ResultCode.BAD_PARAMETER: ErrorCode.BAD_PARAMETER,
    ResultCode.BAD_VALUE: ErrorCode.BAD_VALUE,
    ResultCode.NOT_SERIAL_MODE: ErrorCode.NOT_SERIAL_MODE,
}


def suggests_scan(error: BaseException) -> bool:
    """Whether the board may have other serial settings: a scan may find it."""
    return isinstance(error, TrexError) and error.code in {
        ErrorCode.NO_BOARD,
        ErrorCode.NO_BOARD_AT_NUMBER,
        ErrorCode.ECHO_ONLY,
        ErrorCode.OTHER_DEVICE,
    }
