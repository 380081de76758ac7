"""What waits to be written: bounded, so that a slow disk costs samples and not memory."""

import threading
from collections import deque
from collections.abc import Sequence
from typing import Generic

from trex_gui.core.recording.blocks import RecordT
from trex_gui.core.session.request_queue import Condition
from trex_gui.devices.trex.recording.recording import Marker

MOST = 100_000
"""Records that may wait: nine minutes at full rate, some 15 MB."""

LOST_KIND = "note"


class Backlog(Generic[RecordT]):
    """Takes records from one thread for another, and never makes the first one wait.

    When it is full, what comes is dropped; a marker says so in its place as soon as there is
    room again.
    """

    def __init__(self, condition: Condition | None = None, most: int = MOST) -> None:
        self._most = most
        self._ready = condition or threading.Condition()
        self._waiting: deque[RecordT | Marker] = deque()
        self._lost = 0
        self._lost_in_all = 0
        self._closed = False

    @property
    def lost(self) -> int:
        """How many records were dropped so far."""
        return self._lost_in_all

    def put(self, records: Sequence[RecordT]) -> None:
        """Leave records; does not wait."""
        with self._ready:
            if self._closed or not records:
                return
            if len(self._waiting) + len(records) > self._most:
                self._lost += len(records)
                self._lost_in_all += len(records)
                return
            self._tell_of_lost(records[0].time)
            self._waiting.extend(records)
            self._ready.notify()

    def close(self, time: float) -> None:
        """Take nothing any more; `time` is the session's, for what has to be told."""
        with self._ready:
            self._tell_of_lost(time)
            self._closed = True
            self._ready.notify()

    def get(self, seconds: float) -> list[RecordT | Marker] | None:
        """Return what waits, after at most so many seconds; `None` when nothing more comes."""
        with self._ready:
            if not self._waiting and not self._closed:
                self._ready.wait(seconds)
            if not self._waiting and self._closed:
                return None
            records = list(self._waiting)
            self._waiting.clear()
            return records

    def _tell_of_lost(self, time: float) -> None:
        if self._lost:
            text = f"{self._lost} samples are missing here: the disk was too slow."
            self._waiting.append(Marker(time, LOST_KIND, text))
            self._lost = 0
