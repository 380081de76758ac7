"""Writing a recording as lines of CSV, whatever it is of."""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import BinaryIO, Generic, TypeVar

WrittenT = TypeVar("WrittenT")


class CsvLines(ABC, Generic[WrittenT]):
    """Hands each record on at once, as one line.

    Attributes:
        size: bytes handed to the file so far.
    """

    def __init__(self, file: BinaryIO) -> None:
        self.size = 0
        self._file = file

    @abstractmethod
    def line_of(self, record: WrittenT) -> str:
        """Return the line of a record, without its end."""

    def write(self, records: Sequence[WrittenT]) -> None:
        lines = [self.line_of(record) for record in records]
        if lines:
            self.put("\n".join(lines))

    def flush(self) -> None:
        """Every row is handed on at once."""

    def finish(self) -> None:
        self._file.flush()

    def put(self, text: str) -> None:
        """Hand on one line or several; the last has no end yet."""
        data = (text + "\n").encode("utf-8", "surrogatepass")
        self._file.write(data)
        self.size += len(data)
