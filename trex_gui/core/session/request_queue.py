"""Queue of requests from other threads to a line session."""

import threading
from collections import deque
from types import TracebackType
from typing import Any, Protocol


class Condition(Protocol):
    """The part of `threading.Condition` that queues need."""

    def __enter__(self) -> bool: ...

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
        /,
    ) -> None: ...

    def wait(self, timeout: float | None = None) -> bool:
        """Wait until notified or for `timeout` seconds; return whether it was notified."""
        ...

    def notify(self) -> None:
        """Wake one waiting thread."""
        ...


class RequestQueue:
    """An inbox into which any thread may put requests.

    Does not use `queue.SimpleQueue`: in Python 3.11 its `get` never returns if the timeout expires
    before its first check of an empty queue ends. Sessions often wait for microseconds; one such
    wait in a thousand hung.
    """

    def __init__(self, condition: Condition | None = None) -> None:
        self._changed = condition or threading.Condition()
        self._requests: deque[object] = deque()

    def put(self, request: object) -> None:
        with self._changed:
            self._requests.append(request)
            self._changed.notify()

    def get(self, seconds: float) -> Any:
        """Return the next request, waiting up to `seconds`; `None` if none came."""
        with self._changed:
            if not self._requests and seconds > 0:
                self._changed.wait(seconds)
            return self._requests.popleft() if self._requests else None
