"""Virtual time: what is to happen when, in order."""

import heapq
import math
from collections.abc import Callable
from itertools import count

EPSILON = 1e-9  # seconds; swallows the rounding of summed times


class Timeline:
    """Runs what is due, moment by moment.

    Attributes:
        now: seconds since it was made.
    """

    def __init__(self, passes: Callable[[float], None]) -> None:
        """Begin at 0; `passes` is told of each stretch of time, in seconds."""
        self.now = 0.0
        self._passes = passes
        self._events: list[tuple[float, int, Callable[[], None]]] = []
        self._order = count()

    def at(self, moment: float, action: Callable[[], None]) -> None:
        """Do something when a moment has come; never, if that is infinite."""
        if moment < math.inf:
            heapq.heappush(self._events, (moment, next(self._order), action))

    @property
    def next_event(self) -> float | None:
        """When something happens next; `None` while nothing is to."""
        return self._events[0][0] if self._events else None

    def step(self, end: float) -> bool:
        """Do the next thing that is due by `end`; return whether there was one."""
        if not self._events or self._events[0][0] > end + EPSILON:
            return False
        moment, _, action = heapq.heappop(self._events)
        self.move_to(moment)
        action()
        return True

    def move_to(self, moment: float) -> None:
        """Let time pass in which nothing is due; a moment that is over changes nothing."""
        if moment > self.now:
            seconds, self.now = moment - self.now, moment
            self._passes(seconds)
