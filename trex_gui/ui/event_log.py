"""What happened while a board was connected, for marks in a plot, a recording and a list."""

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import StrEnum

from PySide6.QtCore import QObject, Signal

from trex_gui.ui.runtime import now

MOST_EVENTS = 10_000
"""Events that are kept; the oldest go."""


class EventKind(StrEnum):
    """What an event is about; the value is how files spell it."""

    APPLY = "apply"
    STOP = "stop"
    FAULT = "fault"
    OVER_LIMIT = "over-limit"
    TIMEOUT = "timeout"
    LINK = "link"
    NOTE = "note"


@dataclass(frozen=True, slots=True)
class Event:
    """Something that happened; `time` is on the session's clock (s), as telemetry's."""

    time: float
    kind: EventKind
    text: str  # one line, for people


class EventLog(QObject):
    """The newest events, oldest first.

    Signals:
        happened: the new `Event`.
        cleared: all were forgotten.
    """

    happened = Signal(object)
    cleared = Signal()

    def __init__(self, parent: QObject | None = None, *, clock: Callable[[], float] = now) -> None:
        super().__init__(parent)
        self._clock = clock
        self._events: list[Event] = []

    @property
    def all(self) -> Sequence[Event]:
        """Every event that is kept, oldest first; it goes on growing."""
        return self._events

    def between(self, start: float, end: float) -> Sequence[Event]:
        first = bisect_left(self._events, start, key=_time)
        return self._events[first : bisect_right(self._events, end, key=_time)]

    def add(self, kind: EventKind, text: str, at: float | None = None) -> Event:
        """Note an event, now or at a time of the session's clock; return it."""
        event = Event(self._clock() if at is None else at, kind, text)
        self._events.insert(bisect_right(self._events, event.time, key=_time), event)
        del self._events[:-MOST_EVENTS]
        self.happened.emit(event)
        return event

    def clear(self) -> None:
        self._events.clear()
        self.cleared.emit()


def _time(event: Event) -> float:
    return event.time
