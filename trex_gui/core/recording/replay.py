"""Reconstruction of a device's state at any time in a recording."""

import math
from bisect import bisect_right
from collections.abc import Callable, Sequence
from copy import copy
from typing import Any, Generic, Protocol, TypeVar

from trex_gui.core.recording.kinds import HeaderT, RecordT
from trex_gui.core.recording.store import CHUNK, Recording


class ReplayState(Protocol):
    """State of a device. Later records do not change earlier copies of the state."""

    def update(self, record: Any, /) -> None: ...


StateT = TypeVar("StateT", bound=ReplayState)
ResultT = TypeVar("ResultT")


class Replay(Generic[HeaderT, RecordT, StateT]):
    """Reconstructs states. Stores the state at the start of each chunk. Not thread-safe."""

    def __init__(self, recording: Recording[HeaderT, RecordT], initial: StateT) -> None:
        self.recording = recording
        self._states = [initial]
        self._starts: list[float] = []  # latest time of the records before each chunk, ascending
        self.latest = -math.inf  # latest time of the records read so far
        self._cached: tuple[int, Sequence[RecordT]] = (-1, ())

    @property
    def progress(self) -> float:
        chunks = math.ceil(self.recording.count / CHUNK)
        return len(self._starts) / chunks if chunks else 1.0

    def read_next(
        self, process: Callable[[StateT, Sequence[RecordT]], ResultT]
    ) -> tuple[Sequence[RecordT], ResultT]:
        """Read the next chunk. Return its records and the result of `process`.

        `process` must update the state with the records.
        """
        index = len(self._starts)
        records = self._read(index)
        state = copy(self._states[-1])
        result = process(state, records)
        self._starts.append(self.latest)
        self._states.append(state)
        self.latest = max(self.latest, *(record.time for record in records), -math.inf)
        return records, result

    def at(self, time: float) -> StateT:
        """Return the state at a time, according to the records read so far."""
        index = max(0, bisect_right(self._starts, time) - 1)
        state = copy(self._states[index])
        if self._starts:
            if self._cached[0] != index:
                self._cached = (index, self._read(index))
            for record in self._cached[1]:
                if record.time <= time:
                    state.update(record)
        return state

    def _read(self, index: int) -> Sequence[RecordT]:
        return self.recording.read(index * CHUNK + 1, (index + 1) * CHUNK)
