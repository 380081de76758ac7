"""Reading a recording that was written as CSV."""

import csv
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from copy import copy
from pathlib import Path

from trex_gui.link.telemetry import Control, Currents, ModeSeen, Raw, Remapped, StatusNews
from trex_gui.protocol.commands import Drive
from trex_gui.protocol.driving import Direction
from trex_gui.protocol.flags import CHANNELS, Mode, Status, UartError
from trex_gui.recording.columns import (
    current_column,
    several_lines,
    status_column,
    uart_column,
)
from trex_gui.recording.csv_format import columns
from trex_gui.recording.errors import RecordingError
from trex_gui.recording.on_disk import opened
from trex_gui.recording.recording import (
    AuxiliaryWish,
    Block,
    Header,
    Marker,
    Record,
    SettingsSeen,
    Wish,
)

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


class CsvFile:
    """A recording in a CSV file; rows that cannot be understood are left out and named."""

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

    def close(self) -> None:
        self._file.close()

    def again(self) -> "CsvFile":
        """Return the same recording opened once more, for another thread.

        Raises:
            RecordingError: it cannot be opened any more.
        """
        other = copy(self)
        other._file = opened(self.path)  # noqa: SLF001 - one of its own kind
        other.problems = list(self.problems)
        other._refused = set(self._refused)  # noqa: SLF001 - one of its own kind
        return other

    def read(self, index: int) -> list[Record]:
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
        self._names = self._cells(self._file.readline(_LONGEST_LINE))
        if self._names[:2] != ["time_s", "sample"]:
            raise self._error("This is no recording of TReX Studio.", 1)
        self._places = {name: place for place, name in enumerate(self._names)}
        try:
            row = self._row(self._file.readline(_LONGEST_LINE))
            if row["sample"] != "header":
                raise ValueError("the header is missing")  # noqa: TRY301
            self.header = Header.from_json(several_lines(row["text"]))
        except (ValueError, KeyError) as error:
            raise self._error(f"The header cannot be understood: {error}.", 2) from error
        missing = set(columns(self.header.mode.source)) - set(self._names)
        if missing:
            raise self._error(f"The column {min(missing)} is missing.", 1)
        self._unit = self.header.model.current_unit

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

    def _cells(self, line: bytes) -> list[str]:
        text = line.decode("utf-8", "surrogatepass").removesuffix("\n").removesuffix("\r")
        if '"' not in text and "\r" not in text and "\n" not in text:
            return text.split(",")  # several times as fast, and nearly every row is one of these
        try:
            return next(csv.reader([text], strict=True), [])
        except csv.Error as error:
            raise ValueError(str(error)) from error

    def _row(self, line: bytes) -> Row:
        return _Cells(self._places, self._cells(line))

    def _record(self, line: bytes) -> Record:
        row = self._row(line)
        make = _MAKERS.get(row["sample"])
        if make is None:
            raise ValueError(f"there is no sample {row['sample']!r}")
        seconds = float(row["time_s"])
        if not math.isfinite(seconds):
            raise ValueError("its time is no number")
        return make(self.header.clock + seconds, row, self._unit)

    def _error(self, message: str, line: int) -> RecordingError:
        return RecordingError(str(self.path), message, f"line {line}")


def _currents(time: float, row: Row, unit: float) -> Currents:
    first, second = (round(float(row[current_column(motor)]) / unit) for motor in (1, 2))
    return Currents(time, (first, second))


def _raw(time: float, row: Row, _unit: float) -> Raw:
    cells = [row[f"channel_{channel}_raw"] for channel in CHANNELS]
    return Raw(time, tuple(int(cell) if cell else None for cell in cells))


def _remapped(time: float, row: Row, _unit: float) -> Remapped:
    return Remapped(time, tuple(int(row[f"channel_{channel}_remapped"]) for channel in CHANNELS))


def _status(time: float, row: Row, _unit: float) -> StatusNews:
    status, uart = Status(0), UartError(0)
    for bit in Status:
        status |= bit if row[status_column(bit)] == "1" else Status(0)
    for error in UartError:
        uart |= error if row[uart_column(error)] == "1" else UartError(0)
    return StatusNews(time, status, uart)


def _wish(time: float, row: Row, _unit: float) -> Wish:
    direction = Direction[row["direction"].upper()]
    speed = int(row["brake"]) if row["brake"] else abs(int(row["speed"]))
    return Wish(time, int(row["wished_motor"]), Drive(direction, speed), row["accelerate"] == "1")


_MAKERS: dict[str, Callable[[float, Row, float], Record]] = {
    "currents": _currents,
    "raw": _raw,
    "remapped": _remapped,
    "status": _status,
    "wish": _wish,
    "control": lambda time, row, _: Control(time, bool(int(row["serial_controls"]))),
    "mode": lambda time, row, _: ModeSeen(time, Mode(row["mode"])),
    "auxiliary": lambda time, row, _: AuxiliaryWish(
        time, int(row["auxiliary_speed"]), row["accelerate"] == "1"
    ),
    "event": lambda time, row, _: Marker(
        time, several_lines(row["event"]), several_lines(row["text"])
    ),
    "settings": lambda time, row, _: SettingsSeen(time, several_lines(row["text"])),
}
