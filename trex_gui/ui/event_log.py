"""The newest events of a device."""

from bisect import bisect_right
from collections.abc import Callable
from operator import attrgetter

from PySide6.QtCore import QObject, Signal

from trex_gui.core.events import Event, EventKind
from trex_gui.ui.runtime import now

MOST_EVENTS = 10_000  # events kept; the oldest are dropped


class EventLog(QObject):
    happened = Signal(object)  # the new `Event`

    def __init__(self, parent: QObject | None = None, *, clock: Callable[[], float] = now) -> None:
        super().__init__(parent)
        self._clock = clock
        self.all: list[Event] = []  # in the order of time

    def add(
        self, kind: EventKind, text: str, at: float | None = None, *, is_problem: bool = False
    ) -> Event:
        """Note an event, now or at a time of the session's clock, and return it."""
        event = Event(self._clock() if at is None else at, kind, text, is_problem)
        self.put(event)
        return event

    def put(self, event: Event) -> None:
        self.all.insert(bisect_right(self.all, event.time, key=attrgetter("time")), event)
        del self.all[:-MOST_EVENTS]
        self.happened.emit(event)

    def clear(self) -> None:
        self.all.clear()
