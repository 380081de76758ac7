"""A ring buffer of timed samples that is read as plain arrays without copying."""

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]


class Ring:
    """The last `capacity` rows of a time and some values.

    Twice the room is held, so that the newest rows always lie in one piece.
    """

    def __init__(self, capacity: int, columns: int) -> None:
        self._capacity = capacity
        self._rows: FloatArray = np.zeros((2 * capacity, columns + 1))
        self._end = 0
        self._size = 0

    def __len__(self) -> int:
        return self._size

    def append(self, time: float, *values: float) -> None:
        """Add a row; the oldest one is forgotten when the ring is full."""
        if self._end == len(self._rows):
            kept = self._capacity - 1
            self._rows[:kept] = self._rows[self._end - kept :]
            self._end = kept
        self._rows[self._end, 0] = time
        self._rows[self._end, 1:] = values
        self._end += 1
        self._size = min(self._size + 1, self._capacity)

    def clear(self) -> None:
        """Forget every row."""
        self._end = self._size = 0

    @property
    def times(self) -> FloatArray:
        """The times, oldest first: a view, valid until the next `append`."""
        return self._rows[self._end - self._size : self._end, 0]

    def values(self, column: int) -> FloatArray:
        """One column's values, oldest first: a view, valid until the next `append`."""
        return self._rows[self._end - self._size : self._end, column + 1]
