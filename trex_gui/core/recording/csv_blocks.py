"""Reading lines of CSV back from any place, whatever the recording is of."""

import math
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Mapping, Sequence
from copy import copy
from pathlib import Path
from typing import ClassVar, Generic, Self

from trex_gui.core.recording.blocks import Block, HeaderT, RecordT
from trex_gui.core.recording.errors import RecordingError, opened
from trex_gui.devices.trex.recording.columns import cells_of, several_lines
from trex_gui.devices.trex.recording.identify import wrong_device_message

_ROWS = 1000
_LONGEST_LINE = 1 << 18
_MOST_PROBLEMS = 20

Row = Mapping[str, str]


class _Cells(Row):
    """The cells of a row by the names of their columns, of which few are ever asked for."""

    __slots__ = ("_cells", "_places")

    def __init__(self, places: Mapping[str, int], cells: Sequence[str]) -> None:
        if len(cells) != len(places):
            raise ValueError(f"it has {len(cells)} cells, not {len(places)}")
        self._places = places
        self._cells = cells

    def __getitem__(self, name: str) -> str:
        return self._cells[self._places[name]]

    def __iter__(self) -> Iterator[str]:
        return iter(self._places)

    def __len__(self) -> int:
        return len(self._cells)


class CsvBlocks(ABC, Generic[HeaderT, RecordT]):
    """A recording in a CSV file; rows that cannot be understood are left out and named.

    Attributes:
        kind_column: the second column, which says what each row is.
        header: of what it is.
        blocks: its pieces.
        problems: what is missing or cannot be understood, with the line, as sentences.
    """

    kind_column: ClassVar[str]
    header: HeaderT

    def __init__(self, path: Path, *, head_only: bool = False) -> None:
        """Open a recording; with `head_only` it has no blocks before `look_through`.

        Raises:
            RecordingError: there is none, or its first two lines cannot be read.
        """
        self.path = path
        self.blocks: list[Block] = []
        self.problems: list[str] = []
        self._lines: list[int] = []
        self._refused: set[int] = set()
        self._file = opened(path)
        try:
            self._begin()
            if not head_only:
                self.look_through()
        except (OSError, ValueError) as error:
            self._file.close()
            raise self._error(f"It cannot be read: {error}.", 1) from error
        except BaseException:
            self._file.close()
            raise

    # --- What the recordings of a device are -------------------------------------------

    @abstractmethod
    def header_of(self, text: str) -> HeaderT:
        """Return the header of a line of JSON.

        Raises:
            ValueError: it is none.
        """

    @abstractmethod
    def columns(self) -> Sequence[str]:
        """Return the columns that a recording with `header` has at least."""

    @abstractmethod
    def record_of(self, kind: str, time: float, row: Row) -> RecordT:
        """Return the record that a row holds; `time` is on the session's clock.

        Raises:
            ValueError, KeyError: it holds none.
        """

    # --- Reading ------------------------------------------------------------------------

    def close(self) -> None:
        self._file.close()

    def again(self) -> Self:
        """Return the same recording opened once more, for another thread.

        Raises:
            RecordingError: it cannot be opened any more.
        """
        other = copy(self)
        other._file = opened(self.path)  # noqa: SLF001 - one of its own kind
        other.problems = list(self.problems)
        other._refused = set(self._refused)  # noqa: SLF001 - one of its own kind
        return other

    def read(self, index: int) -> list[RecordT]:
        block = self.blocks[index]
        records = []
        try:
            self._file.seek(block.place)
            for number in range(self._lines[index], self._lines[index] + block.count):
                line = self._file.readline(_LONGEST_LINE)
                try:
                    records.append(self._record(line))
                except (ValueError, KeyError) as error:
                    self._refuse(number, error)
        except (OSError, ValueError) as error:
            raise self._error(f"It cannot be read: {error}.", self._lines[index]) from error
        return records

    # --- Looking through ----------------------------------------------------------------

    def _begin(self) -> None:
        try:
            self._names = cells_of(self._file.readline(_LONGEST_LINE))
        except ValueError:  # no text, or none with cells
            self._names = []
        if self._names[:2] != ["time_s", self.kind_column]:
            if stranger := wrong_device_message(self.path):
                raise RecordingError(str(self.path), stranger)
            raise self._error("This is no recording of TReX Studio.", 1)
        self._places = {name: place for place, name in enumerate(self._names)}
        try:
            line = self._file.readline(_LONGEST_LINE)
            row = self._row(line)
            if not line.endswith(b"\n"):
                raise ValueError("it is cut off")  # noqa: TRY301
            if row[self.kind_column] != "header":
                raise ValueError("the header is missing")  # noqa: TRY301
            self.header = self.header_of(several_lines(row["text"]))
        except (ValueError, KeyError) as error:
            raise self._error(f"The header cannot be understood: {error}.", 2) from error
        missing = set(self.columns()) - set(self._names)
        if missing:
            raise self._error(f"The column {min(missing)} is missing.", 1)

    def look_through(self, tell: Callable[[float], None] = lambda _share: None) -> None:
        """Note where every thousandth row begins.

        `tell` is told the share that is done, 0 to 1; what it raises ends the work.

        Raises:
            RecordingError: it cannot be read.
        """
        try:
            self._look_through(tell)
        except (OSError, ValueError) as error:
            raise self._error(f"It cannot be read: {error}.", 1) from error

    def _look_through(self, tell: Callable[[float], None]) -> None:
        place, number = self._file.tell(), 3
        size = max(1, self.path.stat().st_size)
        begin, first_line, times = place, number, list[float]()
        while line := self._file.readline(_LONGEST_LINE):
            if not line.endswith(b"\n"):
                self.problems.append(f"Line {number}, the last one, is cut off.")
                break
            times.append(self._time(line, number))
            place += len(line)
            number += 1
            if len(times) == _ROWS:
                self._note(times, begin, first_line)
                tell(min(1.0, place / size))
                begin, first_line, times = place, number, []
        if times:
            self._note(times, begin, first_line)

    def _note(self, times: list[float], place: int, line: int) -> None:
        known = [time for time in times if not math.isnan(time)] or [self.header.clock]
        self.blocks.append(Block(min(known), max(known), len(times), place))
        self._lines.append(line)

    def _time(self, line: bytes, number: int) -> float:
        try:
            seconds = float(line.partition(b",")[0])
            if not math.isfinite(seconds):
                raise ValueError("its time is no number")  # noqa: TRY301
        except ValueError as error:
            self._refuse(number, error)
            return math.nan
        return self.header.clock + seconds

    def _refuse(self, number: int, error: Exception) -> None:
        if number in self._refused:
            return
        self._refused.add(number)
        if len(self._refused) <= _MOST_PROBLEMS:
            self.problems.append(f"Line {number} cannot be understood: {error}.")
        elif len(self._refused) == _MOST_PROBLEMS + 1:
            self.problems.append("More lines cannot be understood.")

    # --- Rows ---------------------------------------------------------------------------

    def _row(self, line: bytes) -> Row:
        return _Cells(self._places, cells_of(line))

    def _record(self, line: bytes) -> RecordT:
        row = self._row(line)
        kind, seconds = row[self.kind_column], float(row["time_s"])
        if not math.isfinite(seconds):
            raise ValueError("its time is no number")
        return self.record_of(kind, self.header.clock + seconds, row)

    def _error(self, message: str, line: int) -> RecordingError:
        return RecordingError(str(self.path), message, f"line {line}")
