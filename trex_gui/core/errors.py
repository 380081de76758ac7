"""Errors that the program reports to users."""

from collections.abc import Callable
from enum import Enum

from trex_gui.core.translation import tr_noop


class StudioError(Exception):
    """Error that the program reports to users, not to developers."""


class BadRequest(StudioError, ValueError):  # noqa: N818
    """Invalid request, rejected before anything is sent. The text may be a clause."""


class PortUnavailable(StudioError):  # noqa: N818
    """The port is in use, missing or forbidden.

    The text explains the remedy.

    Attributes:
        command: shell command that grants permission, or an empty string.
        is_missing: True if the user must plug in an adapter.
    """

    def __init__(self, text: str, *, command: str = "", is_missing: bool = False) -> None:
        super().__init__(text)
        self.command = command
        self.is_missing = is_missing


class PortFault(Enum):
    """Texts of `PortUnavailable` with placeholders."""

    FORBIDDEN = tr_noop("Permission denied for {0}. {1}")
    UNREACHABLE = tr_noop("The port {0} cannot be reached: {1}.")
    MISSING = tr_noop("There is no port {0}. Ports of this computer: {1}.")
    LOCKED = tr_noop(
        "{0} is in use by another program or locked by its driver. After a crash, the "
        "guardian process also uses it for up to 5 seconds to stop the motors. Close the "
        "other program or wait, then connect again."
    )
    LEFT_RUNNING = tr_noop(
        "Motors may still be turning: no stop has been confirmed for the {0} at {1}, driven "
        "since {2}. Stop the motors, or cut their power."
    )
    LEFT_UNKNOWN = tr_noop(
        "Motors may still be turning: the file {0} shows that a board was left running, but "
        "the file is damaged and does not identify the board. If a motor is turning, cut its "
        "power. Then delete the file."
    )
    GUARDED = tr_noop(
        "The guardian process is still stopping the motors on {0}. Wait up to 5 seconds, "
        "then connect again."
    )
    IN_USE = tr_noop("{0} is in use by {1}. Close the port there, then connect again.")
    NOT_SETTABLE = tr_noop("The port {0} cannot be set to {1} ({2}).")
    NOT_OPEN = tr_noop("The port {0} cannot be opened: {1}.")
    SHARED = tr_noop(
        "Another program is also reading from {0} and has taken some of the bytes. Close "
        "that program, then connect again."
    )
    GONE = tr_noop("The connection to {0} is gone. Plug the adapter in, then connect again.")


class PortShared(PortUnavailable):
    """Another program reads bytes from the port."""


class NoReply(StudioError):  # noqa: N818
    """No complete reply arrived in time."""


class BadReply(StudioError):  # noqa: N818
    """Corrupted reply: wrong CRC, length, echo or content."""


class InternalError(StudioError):
    """Bug in the program. The log contains the traceback."""


class CodedError(StudioError):
    """Error with a code and fields. The code's value is a text with placeholders for the fields.

    A field may itself be a coded error or a tuple of coded errors. `str` returns the English text.
    """

    def __init__(self, code: Enum, *fields: object) -> None:
        super().__init__(code, *fields)
        self.code = code
        self.fields = fields

    def __str__(self) -> str:
        return describe(self.code, self.fields)


def describe(
    code: Enum, fields: tuple[object, ...] = (), translate: Callable[[str], str] = str
) -> str:
    """Return the text of a `CodedError`. `translate` is called with the value of each code."""

    def text(field: object) -> object:
        match field:
            case CodedError():
                return describe(field.code, field.fields, translate)
            case tuple():
                return " ".join(str(text(part)) for part in field)
        return field

    return translate(code.value).format(*map(text, fields))


def sentence(error: BaseException | None) -> str:
    """Return the message of an error with exactly one period at its end."""
    return f"{str(error).rstrip('. ')}." if error is not None else ""
