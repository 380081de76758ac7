"""Event log of a device, and message log of a workspace."""

import logging
import time
from bisect import bisect_right
from collections import deque
from dataclasses import dataclass
from datetime import datetime
from operator import attrgetter

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.events import Event, EventKind
from trex_gui.ui.runtime import now

log = logging.getLogger(__name__)

MAX_EVENTS = 10_000  # per event log
MAX_ENTRIES = 2000  # per message log
_MAX_LENGTH = 2000  # characters per entry
_REPEAT_TIME = 1.0  # seconds during which a repeated message is dropped
_WARNING_SIGN = "⚠"


class EventLog(QObject):
    happened = Signal(object)  # the new `Event`

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.all: list[Event] = []  # in chronological order

    def add(self, kind: EventKind, text: str, *, is_problem: bool = False) -> None:
        self.put(Event(now(), kind, text, is_problem))

    def put(self, event: Event) -> None:
        self.all.insert(bisect_right(self.all, event.time, key=attrgetter("time")), event)
        del self.all[:-MAX_EVENTS]
        self.happened.emit(event)

    def clear(self) -> None:
        self.all.clear()


@dataclass(frozen=True, slots=True)
class LogEntry:
    time: datetime  # local
    text: str  # one line, for the user
    is_problem: bool
    line: str  # displayed line: time, warning sign (only for a problem), text


class Log(QObject):
    added = Signal(object)  # the new `LogEntry`

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.entries = deque[LogEntry](maxlen=MAX_ENTRIES)  # in order of arrival

    def follow(self, events: EventLog) -> None:
        events.happened.connect(self._on_happened)

    def add(self, text: str, *, is_problem: bool = False, at: float | None = None) -> None:
        """Add a message. `at`: time on the session's clock. The default is now."""
        line = " ".join(text.split())
        line = line if len(line) <= _MAX_LENGTH else f"{line[:_MAX_LENGTH]} …"
        age = 0.0 if at is None else now() - at
        moment = datetime.fromtimestamp(time.time() - age).astimezone()
        last = self.entries[-1] if self.entries else None
        if last is not None and last.text == line:
            is_repeated = (moment - last.time).total_seconds() < _REPEAT_TIME
            if is_repeated and last.is_problem >= is_problem:
                return
        sign = f"{_WARNING_SIGN} " if is_problem else ""
        full_line = f"{moment:%Y-%m-%d %H:%M:%S}  {sign}{line}"
        self.entries.append(LogEntry(moment, line, is_problem, full_line))
        log.info("%s%s", sign, line)
        self.added.emit(self.entries[-1])

    @Slot(object)
    def _on_happened(self, event: Event) -> None:
        self.add(event.text, is_problem=event.is_problem, at=event.time)
