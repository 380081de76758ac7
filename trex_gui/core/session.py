"""Messages, request queue and loop of line sessions."""

import logging
import threading
from collections import deque
from collections.abc import Callable
from contextlib import AbstractContextManager
from dataclasses import dataclass
from typing import Any, Protocol, TypeVar

from trex_gui.core.errors import StudioError

log = logging.getLogger(__name__)

RequestT_co = TypeVar("RequestT_co", covariant=True)


@dataclass(frozen=True, slots=True)
class Close:
    """Request: stop all motors, close the port and end the session."""


@dataclass(frozen=True, slots=True)
class Progress:
    """Report: `done` of `total` steps are complete. `what`: text about the next step."""

    done: int
    total: int
    what: str


@dataclass(frozen=True, slots=True)
class Outcome:
    """Report: result of a request. Each `id` has exactly one outcome."""

    id: int
    value: object = None
    error: StudioError | None = None


@dataclass(frozen=True, slots=True)
class Closed:
    """Last report: the session has ended and the port is free."""

    error: StudioError | None  # cause of a lost line; `None` after `Close`
    may_move: bool = False  # True if motors were driven and no stop was confirmed


class Condition(AbstractContextManager[bool], Protocol):
    """Subset of `threading.Condition` that queues need."""

    def wait(self, timeout: float | None = None) -> bool: ...
    def notify(self) -> None: ...


class RequestQueue:
    """Queue of requests from any thread.

    Does not use `queue.SimpleQueue`: in Python 3.11 its `get` never returns if the timeout expires
    before its first check of an empty queue ends. Sessions often wait for microseconds; one in a
    thousand such waits hung.
    """

    def __init__(self, condition: Condition | None = None) -> None:
        self._changed = condition or threading.Condition()
        self._requests: deque[object] = deque()

    def __len__(self) -> int:
        return len(self._requests)

    def put(self, request: object) -> None:
        with self._changed:
            self._requests.append(request)
            self._changed.notify()

    def get(self, seconds: float) -> Any:
        with self._changed:
            if not self._requests and seconds > 0:
                self._changed.wait(seconds)
            return self._requests.popleft() if self._requests else None


SHORTEST_WAIT = 1e-5  # seconds; prevents a busy loop caused by rounding errors of times


class Inbox(Protocol[RequestT_co]):
    """Source of requests. `get` returns `None` if no request arrives in time."""

    def get(self, seconds: float) -> RequestT_co | None: ...


class Closing(Exception):  # noqa: N818 - closing is not an error
    """Raised when a session receives `Close`."""


def run_until_closed(
    start: Callable[[], None],
    step: Callable[[], None],
    internal_error: Callable[[str], StudioError],
) -> StudioError | None:
    """Call `start`, then `step` repeatedly. Return the error that ended the loop.

    Never raises, because the session must afterwards bring the device into a safe state. Return
    `None` after `Closing`. For any exception except `StudioError`, return the result of
    `internal_error`.
    """
    try:
        start()
        while True:
            step()
    except Closing:
        return None
    except StudioError as error:
        return error
    except BaseException as error:
        log.exception("the line session failed")
        return internal_error(repr(error))
