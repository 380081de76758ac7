"""Where the requests of other threads wait for the session of a line."""

import queue
from typing import Any


class QueueInbox:
    """An inbox that any thread may put requests into, of whatever kind its session takes.

    Not on `queue.SimpleQueue`: in Python 3.11 its `get` waits without end where its time is over
    before its first look at an empty queue has ended. A session often waits for microseconds, and
    one such wait in a thousand ended so.
    """

    def __init__(self) -> None:
        self._queue: queue.Queue[Any] = queue.Queue()

    def put(self, request: object) -> None:
        """Leave a request for the session."""
        self._queue.put(request)

    def get(self, seconds: float) -> Any:
        """Return the next request, waiting up to `seconds` for one; else `None`."""
        try:
            if seconds <= 0:
                return self._queue.get_nowait()
            return self._queue.get(timeout=seconds)
        except queue.Empty:
            return None
