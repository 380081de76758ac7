"""Virtual time, with a queue of actions."""

import heapq
import math
from collections.abc import Callable
from itertools import count

EPSILON = 1e-9  # seconds; absorbs the rounding of summed times


class Timeline:
    """Runs actions in order of time. `now`: seconds since creation."""

    def __init__(self, advance: Callable[[float], None]) -> None:
        """`advance` is called with the elapsed seconds whenever the time advances."""
        self.now = 0.0
        self._advance = advance
        self._events: list[tuple[float, int, Callable[[], object], Callable[[], bool] | None]] = []
        self._order = count()

    def at(
        self, moment: float, action: Callable[[], object], only_if: Callable[[], bool] | None = None
    ) -> None:
        """Run an action at a moment. `only_if`: condition that is checked at that moment."""
        if moment < math.inf:
            heapq.heappush(self._events, (moment, next(self._order), action, only_if))

    @property
    def next_event(self) -> float | None:
        return self._events[0][0] if self._events else None

    def step(self, end: float) -> bool:
        """Run the next action that is due by `end`. Return whether there was one."""
        if not self._events or self._events[0][0] > end + EPSILON:
            return False
        moment, _, action, only_if = heapq.heappop(self._events)
        self.move_to(moment)
        if only_if is None or only_if():
            action()
        return True

    def move_to(self, moment: float) -> None:
        """Advance the time without running actions. A past moment has no effect."""
        if moment > self.now:
            seconds, self.now = moment - self.now, moment
            self._advance(seconds)
