"""What can go wrong between a person, the program and a board.

Each error is a sentence for a person. They cross threads and processes as values, so every
one pickles.
"""

from enum import IntEnum


class StudioError(Exception):
    """Anything that a person should read rather than a developer."""


class BadRequest(StudioError, ValueError):  # noqa: N818 - reads as what it is
    """Ours: refused before a byte was sent. Says what, the allowed range and what was given."""


class PortUnavailable(StudioError):  # noqa: N818
    """The port is busy, gone or not permitted; says what mends it."""


class NoReply(StudioError):  # noqa: N818
    """Nothing, or not everything, came back in the time that the wire and the board need."""


class BadReply(StudioError):  # noqa: N818
    """Bytes came back that cannot be the reply: wrong CRC, length, echo or content."""


class ResultCode(IntEnum):
    """What the board answers to 0xA0-0xA4 and 0xAF.

    Ref: TReX 1.0 command documentation, "set channel calibration", "set configuration
    parameter".
    """

    OK = 0
    BAD_PARAMETER = 1
    BAD_VALUE = 2
    NOT_SERIAL_MODE = 3


_REASONS = {
    ResultCode.BAD_PARAMETER: "the board does not know this parameter (code 1); "
    "its firmware may be too old for it",
    ResultCode.BAD_VALUE: "the board refuses this value (code 2)",
    ResultCode.NOT_SERIAL_MODE: "the board is not in serial mode (code 3); switch it off, "
    "remove the mode jumper, switch it on again",
}


class Rejected(StudioError):  # noqa: N818
    """The board understood a write and refused it.

    Attributes:
        what: what was written, for people ("Serial Timeout", "calibration of channel 2").
        code: the board's result code.
    """

    def __init__(self, what: str, code: ResultCode) -> None:
        super().__init__(what, code)
        self.what = what
        self.code = code

    def __str__(self) -> str:
        return f"{self.what}: {_REASONS.get(self.code, f'result code {int(self.code)}')}"


def sentence(error: BaseException | None) -> str:
    """Return what an error says as one sentence with one full stop."""
    return f"{str(error).rstrip('. ')}." if error is not None else ""
