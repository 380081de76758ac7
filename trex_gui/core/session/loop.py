"""The frame of a line session: it serves requests until it is closed or the line is lost."""

import logging
from collections.abc import Callable
from typing import Protocol, TypeVar

from trex_gui.core.errors import StudioError

log = logging.getLogger(__name__)

RequestT_co = TypeVar("RequestT_co", covariant=True)

SHORTEST_WAIT = 1e-5
"""Seconds: a rounding error in a sum of times must not become a busy loop."""


class Inbox(Protocol[RequestT_co]):
    """Where the requests of a session come from."""

    def get(self, seconds: float) -> RequestT_co | None:
        """Return the next request, waiting up to `seconds` for one; else `None`."""
        ...


class Closing(Exception):  # noqa: N818 - no error: the session was closed
    """Raised where a session finds a `Close`."""


def run_until_closed(
    begin: Callable[[], None],
    step: Callable[[], None],
    internal_error: Callable[[str], StudioError],
) -> StudioError | None:
    """Call `begin`, then `step` again and again; return the error that ended it.

    Never raises: whatever happens, the session goes on to leave the device in a safe state.

    Returns:
        `None` where `Closing` was raised; the result of `internal_error` for an exception that is
        no `StudioError`.
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
