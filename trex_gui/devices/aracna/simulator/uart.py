"""The receiving half of the chip's UART while nobody reads it: it holds three bytes."""

from collections import deque

HOLDS = 3
"""A buffer of two bytes, and the shift register behind it."""


class Holding:
    """What has come and was not read.

    Attributes:
        keeps_last: which byte survives as the third where more come: the last, as in the chip's
            data sheet (a new byte pushes the one out of the shift register), or the third.
            The document leaves it open; only with the last one does a `.v` that is sent in
            reaction to `.h` restart the firmware for ever, as was observed.
        lost: how many bytes did not survive.
    """

    def __init__(self, *, keeps_last: bool = True) -> None:
        self.keeps_last = keeps_last
        self.lost = 0
        self._bytes: deque[int] = deque()

    def __len__(self) -> int:
        return len(self._bytes)

    def put(self, byte: int) -> None:
        """Take a byte that has come."""
        if len(self._bytes) == HOLDS:
            self.lost += 1
            if not self.keeps_last:
                return
            self._bytes.pop()
        self._bytes.append(byte)

    def take(self) -> int:
        """Read the oldest."""
        return self._bytes.popleft()

    def clear(self) -> None:
        """Forget all: the chip was reset."""
        self._bytes.clear()
