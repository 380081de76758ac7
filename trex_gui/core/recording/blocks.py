"""A recording of anything as a file that is read in blocks."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Protocol, TypeVar


class Timestamped(Protocol):
    """What can be recorded: it has a time on the session's clock."""

    @property
    def time(self) -> float:
        """When it was."""
        ...


class HasStartTime(Protocol):
    """What every header says: when it began, on the session's clock (s)."""

    @property
    def clock(self) -> float:
        """What the session's clock said when the recording began."""
        ...


HeaderT = TypeVar("HeaderT", bound=HasStartTime)
HeaderT_co = TypeVar("HeaderT_co", bound=HasStartTime, covariant=True)
RecordT = TypeVar("RecordT", bound=Timestamped)
RecordT_co = TypeVar("RecordT_co", bound=Timestamped, covariant=True)


@dataclass(frozen=True, slots=True)
class Block:
    """A piece of a recording that is read as a whole.

    Attributes:
        first, last: the earliest and the latest time in it.
        count: how many records.
        place: where it begins in the file, in bytes.
    """

    first: float
    last: float
    count: int
    place: int


class BlockFile(Protocol[HeaderT_co, RecordT_co]):
    """A recording that can be read at any place, whatever its format and whatever it is of."""

    @property
    def header(self) -> HeaderT_co:
        """Of what it is."""

    @property
    def blocks(self) -> Sequence[Block]:
        """Its pieces, in the order they were written."""

    @property
    def problems(self) -> Sequence[str]:
        """What is missing or cannot be read, as sentences; empty for a whole one."""

    def look_through(self, tell: Callable[[float], None] = ...) -> None:
        """Find the blocks, where only the head was read; `tell` is told the share, 0 to 1.

        Raises:
            RecordingError: it cannot be read.
        """

    def read(self, index: int) -> Sequence[RecordT_co]:
        """Return the records of one block.

        Raises:
            RecordingError: the file has changed or gone since it was opened.
        """

    def close(self) -> None:
        """Give the file back."""
