"""Where the requests of other threads wait for the session of a line."""

import threading
from collections import deque
from types import TracebackType
from typing import Any, Protocol


class Condition(Protocol):
    """The part of `threading.Condition` that queues between threads need."""

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
    """An inbox that any thread may put requests into, of whatever kind its session takes.

    Not on `queue.SimpleQueue`: in Python 3.11 its `get` waits without end where its time is over
    before its first look at an empty queue has ended. A session often waits for microseconds, and
    one such wait in a thousand ended so.
    """

    def __init__(self, condition: Condition | None = None) -> None:
        self._changed = condition or threading.Condition()
        self._requests: deque[object] = deque()

    def put(self, request: object) -> None:
        """Leave a request for the session."""
        with self._changed:
            self._requests.append(request)
            self._changed.notify()

    def get(self, seconds: float) -> Any:
        """Return the next request, waiting up to `seconds` for one; else `None`."""
        with self._changed:
            if not self._requests and seconds > 0:
                self._changed.wait(seconds)
            return self._requests.popleft() if self._requests else None
