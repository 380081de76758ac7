"""Result codes of the board's writes, and the error for a write that it rejects."""

from enum import IntEnum

from trex_gui.core.errors import StudioError


class ResultCode(IntEnum):
    """Reply to 0xA0-0xA4 and 0xAF.

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


class Rejected(StudioError):  # noqa: N818 - reads as a result, like `Outcome`
    """The board understood a write and rejected it.

    Attributes:
        what: what was written, for messages ("Serial Timeout", "calibration of channel 2").
    """

    def __init__(self, what: str, code: ResultCode) -> None:
        super().__init__(what, code)
        self.what = what
        self.code = code

    def __str__(self) -> str:
        return f"{self.what}: {_REASONS.get(self.code, f'result code {int(self.code)}')}"
