"""What was known at one time of a recording of anything, without reading it from the start."""

from collections.abc import Sequence
from copy import copy
from typing import Any, Generic, Protocol, TypeVar

from trex_gui.core.recording.blocks import BlockFile, HasStartTime, RecordT


class Accumulator(Protocol):
    """Everything that is known; `copy.copy` of it is no longer changed by `take`."""

    def take(self, record: Any, /) -> None:
        """Take a record as the newest."""


LatestT = TypeVar("LatestT", bound=Accumulator)


class BlockReplay(Generic[RecordT, LatestT]):
    """Goes to any time of a recording; remembers what was known where each block begins.

    It belongs to one thread at a time, and the file with it.
    """

    def __init__(self, file: BlockFile[HasStartTime, RecordT], first: LatestT) -> None:
        """Go through this file; `first` is what is known before its first record."""
        self._file = file
        self._known = [first]
        self._read: tuple[int, Sequence[RecordT]] = (-1, [])

    @property
    def blocks_seen(self) -> int:
        """How many blocks, from the first on, were gone through."""
        return len(self._known) - 1

    def go_through_next(self) -> tuple[LatestT, Sequence[RecordT]]:
        """Go through one block more; return what was known before it, and its records.

        Raises:
            RecordingError: the file has changed since it was opened.
            IndexError: there is none.
        """
        records = self._file.read(self.blocks_seen)
        latest = copy(self._known[-1])
        for record in records:
            latest.take(record)
        self._known.append(latest)
        return copy(self._known[-2]), records

    def at(self, time: float) -> LatestT:
        """Return what was known at a time, as far as the blocks were gone through.

        Raises:
            RecordingError: the file has changed since it was opened.
        """
        index = self._block_of(time)
        latest = copy(self._known[index])
        if index < self.blocks_seen:
            if self._read[0] != index:
                self._read = (index, self._file.read(index))
            for record in self._read[1]:
                if record.time <= time:
                    latest.take(record)
        return latest

    def _block_of(self, time: float) -> int:
        """Return the last block seen that begins no later than that."""
        low, high = 0, self.blocks_seen
        while low + 1 < high:
            middle = (low + high) // 2
            if self._file.blocks[middle].first <= time:
                low = middle
            else:
                high = middle
        return low
