"""The loop of a line session, which runs until it is closed or the line is lost."""

import logging
from collections.abc import Callable
from typing import Protocol, TypeVar

from trex_gui.core.errors import StudioError

log = logging.getLogger(__name__)

RequestT_co = TypeVar("RequestT_co", covariant=True)

SHORTEST_WAIT = 1e-5
"""Seconds; keeps rounding errors of times from causing a busy loop."""


class Inbox(Protocol[RequestT_co]):
    """Source of the requests of a session."""

    def get(self, seconds: float) -> RequestT_co | None:
        """Return the next request, waiting up to `seconds`; `None` if none came."""
        ...


class Closing(Exception):  # noqa: N818 - no error: the session was closed
    """Raised when a session receives `Close`."""


def run_until_closed(
    begin: Callable[[], None],
    step: Callable[[], None],
    internal_error: Callable[[str], StudioError],
) -> StudioError | None:
    """Call `begin`, then `step` repeatedly; return the error that ended the loop.

    Never raises, so that the session can then bring the device into a safe state.

    Returns:
        `None` after `Closing`; the result of `internal_error` for any exception other than
        `StudioError`.
    """
    try:
        begin()
        while True:
            step()
    except Closing:
        return None
    except StudioError as error:
        return error
    except BaseException as error:
        log.exception("the line session failed")
        return internal_error(repr(error))
