"""Bounded queue of records that are waiting for the disk."""

import threading
from collections import deque
from collections.abc import Sequence
from typing import Generic

from trex_gui.core.recording.kinds import Marker, RecordT
from trex_gui.core.session import Condition
from trex_gui.core.translation import tr

CAPACITY = 100_000  # records: nine minutes at full rate, about 15 MB


class Backlog(Generic[RecordT]):
    """Passes records to another thread without blocking the sender.

    A full queue drops new records. A later marker reports the number of dropped records.
    """

    def __init__(self, condition: Condition | None = None, capacity: int = CAPACITY) -> None:
        self._capacity = capacity
        self._ready = condition or threading.Condition()
        self._pending: deque[RecordT | Marker] = deque()
        self._unmarked = 0
        self.lost = 0
        self._closed = False

    def put(self, records: Sequence[RecordT | Marker]) -> None:
        with self._ready:
            if self._closed or not records:
                return
            if len(self._pending) + len(records) > self._capacity:
                self._unmarked += len(records)
                self.lost += len(records)
                return
            self._mark_lost(records[0].time)
            self._pending.extend(records)
            self._ready.notify()

    def close(self, time: float) -> None:
        """Stop accepting records. `time`: session clock (s), for a marker of dropped records."""
        with self._ready:
            self._mark_lost(time)
            self._closed = True
            self._ready.notify()

    def get(self, seconds: float) -> list[RecordT | Marker] | None:
        """Return the pending records after at most `seconds`. `None` after the last record."""
        with self._ready:
            if not self._pending and not self._closed:
                self._ready.wait(seconds)
            if not self._pending and self._closed:
                return None
            records = list(self._pending)
            self._pending.clear()
            return records

    def _mark_lost(self, time: float) -> None:
        if self._unmarked:
            text = tr("Samples lost here because the disk was too slow: {0}.").format(
                self._unmarked
            )
            self._pending.append(Marker(time, "note", text))
            self._unmarked = 0
