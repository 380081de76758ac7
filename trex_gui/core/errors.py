"""Errors that users see; each is a sentence.

They cross threads and processes as values, so every one pickles.
"""


class StudioError(Exception):
    """An error for users rather than for developers."""


class BadRequest(StudioError, ValueError):  # noqa: N818 - reads as what it is
    """Invalid input, rejected before a byte was sent; names the allowed range and the value."""


class PortUnavailable(StudioError):  # noqa: N818
    """The port is in use, gone or not permitted; says how to fix it."""


class NoReply(StudioError):  # noqa: N818
    """No complete reply arrived within the time that wire and board need."""


class BadReply(StudioError):  # noqa: N818
    """The received bytes cannot be the reply: wrong CRC, length, echo or content."""


def sentence(error: BaseException | None) -> str:
    """Return the message of an error as one sentence with one full stop."""
    return f"{str(error).rstrip('. ')}." if error is not None else ""
