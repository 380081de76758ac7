"""Sample kinds, which define the tables and columns of a recording.

Each device declares its sample kinds once. The store, the exports and `trexcmd stream` use the
names, units and values of these kinds.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import datetime
from typing import Any, Generic, Literal, Protocol, TypeVar

from trex_gui.core.errors import StudioError

Value = int | float | str | None

SOURCE = "board"  # column that identifies the board, if there are several boards

LONGEST_TEXT = 60_000  # characters per text; the settings of a board need 4,000 characters


class Timestamped(Protocol):
    """Object with a time on the session clock (s)."""

    @property
    def time(self) -> float: ...


class RecordingHeader(Protocol):
    """Header of a recording. `clock`: session clock (s) at the start of the recording.

    `values` returns the rows of the header table: `device_name`, `started_utc`, `clock_s` and the
    device's own values.
    """

    @property
    def started(self) -> datetime: ...
    @property
    def clock(self) -> float: ...
    def values(self) -> dict[str, Value]: ...


HeaderT = TypeVar("HeaderT", bound=RecordingHeader)
RecordT = TypeVar("RecordT", bound=Timestamped)


@dataclass(frozen=True, slots=True)
class Marker:
    """Event in a recording.

    `kind`: a word such as `stop`. `text`: a sentence for the user.
    """

    time: float
    kind: str
    text: str


def marker(time: float, kind: str, text: str) -> Marker:
    """Create a marker. Its text is truncated to `LONGEST_TEXT`."""
    return Marker(time, kind, text[:LONGEST_TEXT])


@dataclass(frozen=True, slots=True)
class Physical:
    """Computed column: stored value times `scale`, rounded to `digits` decimal places.

    `scales`: value in the column `SOURCE` → scale of that board, if it differs from `scale`.
    """

    name: str
    scale: float
    digits: int
    scales: Mapping[int, float] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Column:
    """Stored column. Its name or its description includes the unit."""

    name: str
    type: Literal["INTEGER", "REAL", "TEXT"]
    description: str
    physical: Physical | None = None
    optional: bool = False


@dataclass(frozen=True, slots=True)
class SampleKind:
    """Kind of sample. A recording has one table for each kind.

    Attributes:
        unpack: creates a record from its time and values. Raises ValueError, KeyError or TypeError
            if the values are damaged.
    """

    name: str
    type: type[Any]  # class of the records
    columns: tuple[Column, ...]
    pack: Callable[[Any], Sequence[Value]]  # values of a record in the order of `columns`
    unpack: Callable[..., Any]
    held: bool = False  # True if a CSV row repeats the last values until they change
    partial: bool = False  # True if NULL leaves a held value unchanged
    clears: frozenset[str] = frozenset()  # kinds whose held values this kind invalidates

    @property
    def exported(self) -> tuple[str, ...]:
        pairs = ((column, column.physical) for column in self.columns)
        return tuple(part.name for pair in pairs for part in pair if part is not None)

    def cells(self, record: Timestamped) -> dict[str, Value]:
        cells: dict[str, Value] = {}
        for column, value in zip(self.columns, self.pack(record), strict=True):
            cells[column.name] = value
            if (physical := column.physical) is not None:
                count = value if isinstance(value, int | float) else None
                cells[physical.name] = (
                    None if count is None else round(count * physical.scale, physical.digits)
                )
        return cells


MARKERS = SampleKind(
    "marker",
    Marker,
    (
        Column("marker_kind", "TEXT", "stop, fault, apply, link, note and so on"),
        Column("text", "TEXT", "what happened"),
    ),
    # The name of a port may contain invalid Unicode.
    lambda marker: (marker.kind, marker.text.encode("utf-8", "backslashreplace").decode()),
    Marker,
)


@dataclass(frozen=True, slots=True)
class RecordingFormat(Generic[HeaderT]):
    """Format of the recordings of a kind of device.

    Attributes:
        device: name of the kind of device in the header table.
        read_header: creates the header from the rows of the header table. Raises ValueError if the
            rows are damaged.
        kinds: returns the sample kinds of a recording with this header.
        type_of: returns the `SampleKind.type` of a record.
    """

    device: str
    read_header: Callable[[Mapping[str, Any]], HeaderT]
    kinds: Callable[[HeaderT], Sequence[SampleKind]]
    type_of: Callable[[Any], type[object]] = type


class RecordingError(StudioError):
    """Failure to read or write a recording. `args`: file name and reason."""

    def __str__(self) -> str:
        return ": ".join(self.args)
