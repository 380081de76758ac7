"""Records as bytes and back: a column for each number, so that little is left to pack.

One run of records becomes

    count           4 bytes, unsigned
    kinds           1 byte a record, in the order the records came
    times           8 bytes a record: the bits of the time as an IEEE 754 double, less those of
                    the time before, modulo 2^64
    columns         for each kind that occurs, by its code, and for each of its fields: one
                    number for each record of that kind, then of text fields the UTF-8 bytes

Everything is little-endian. A column of numbers wider than a byte lies byte-wise: first the
lowest byte of each, then the next of each, and so on. A text's number is its length in bytes.

| code | record | fields |
|---|---|---|
| 1 | motor currents | counts of motor 1, 2 (2 bytes each) |
| 2 | raw channels | counts of channel 1-5 (2 bytes each; 65535: no signal) |
| 3 | remapped channels | -127 to 127, channel 1-5 (1 byte each, signed) |
| 4 | status news | status bits, UART error bits (1 byte each) |
| 5 | control | 1: serial commands reach the motors (1 byte) |
| 6 | mode | the letter that 0x82 answers (1 byte) |
| 7 | wish | motor, direction bits, speed or duty, 1: accelerate (1 byte each) |
| 8 | auxiliary wish | speed, 1: accelerate (1 byte each) |
| 9 | marker | kind (text), words (text) |
| 10 | settings | a settings file (text) |
"""

import struct
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import accumulate
from typing import Any

from trex_gui.devices.trex.client.telemetry import (
    Control,
    Currents,
    LatchedStatus,
    ModeSample,
    Raw,
    Remapped,
)
from trex_gui.devices.trex.protocol.commands import Drive
from trex_gui.devices.trex.protocol.driving import Direction
from trex_gui.devices.trex.protocol.flags import Mode, Status, UartError
from trex_gui.devices.trex.recording.recording import (
    AuxiliarySetpointRecord,
    Marker,
    Record,
    SetpointRecord,
    SettingsSeen,
)

_SILENT = 0xFFFF
_MASK = (1 << 64) - 1
_TEXT = "s"
"""Marks a text among the letters that `struct` gives numbers."""

Values = tuple[Any, ...]


@dataclass(frozen=True, slots=True)
class _Kind:
    """How one kind of record lies in columns; `fields` are letters of `struct`, or `s`."""

    code: int
    fields: str
    values: Callable[[Any], Values]
    record: Callable[..., Record]


def _raw(time: float, *counts: int) -> Raw:
    return Raw(time, tuple(None if count == _SILENT else count for count in counts))


_KINDS: dict[type[Any], _Kind] = {
    Currents: _Kind(1, "HH", lambda r: r.counts, lambda t, a, b: Currents(t, (a, b))),
    Raw: _Kind(2, "HHHHH", lambda r: tuple(_SILENT if c is None else c for c in r.counts), _raw),
    Remapped: _Kind(3, "bbbbb", lambda r: r.values, lambda t, *v: Remapped(t, v)),
    LatchedStatus: _Kind(
        4,
        "BB",
        lambda r: (int(r.status), int(r.uart)),
        lambda t, s, u: LatchedStatus(t, Status(s), UartError(u)),
    ),
    Control: _Kind(5, "B", lambda r: (int(r.by_serial),), lambda t, c: Control(t, bool(c))),
    ModeSample: _Kind(
        6, "B", lambda r: (ord(r.mode.value),), lambda t, m: ModeSample(t, Mode(chr(m)))
    ),
    SetpointRecord: _Kind(
        7,
        "BBBB",
        lambda r: (r.motor, int(r.drive.direction), r.drive.speed, int(r.accelerate)),
        lambda t, m, d, s, a: SetpointRecord(t, m, Drive(Direction(d), s), bool(a)),
    ),
    AuxiliarySetpointRecord: _Kind(
        8,
        "BB",
        lambda r: (r.speed, int(r.accelerate)),
        lambda t, s, a: AuxiliarySetpointRecord(t, s, bool(a)),
    ),
    Marker: _Kind(9, "ss", lambda r: (r.kind, r.text), Marker),
    SettingsSeen: _Kind(10, "s", lambda r: (r.text,), SettingsSeen),
}
_BY_CODE = {kind.code: kind for kind in _KINDS.values()}


def encode(records: Sequence[Record]) -> bytes:
    """Return records as bytes.

    Raises:
        ValueError: one of them holds a number that has no room.
    """
    kinds = bytearray()
    rows: dict[int, list[Values]] = {}
    for record in records:
        kind = _KINDS[type(record)]
        kinds.append(kind.code)
        rows.setdefault(kind.code, []).append(kind.values(record))
    parts = [struct.pack("<I", len(records)), bytes(kinds), _times([r.time for r in records])]
    try:
        for code in sorted(rows):
            columns = zip(*rows[code], strict=True)
            for field, column in zip(_BY_CODE[code].fields, columns, strict=True):
                parts += _column(field, column)
    except struct.error as error:
        raise ValueError(f"a record holds a number that has no room: {error}") from error
    return b"".join(parts)


def decode(data: bytes) -> list[Record]:
    """Return the records that bytes stand for.

    Raises:
        ValueError: they stand for none.
    """
    try:
        return _decoded(_Bytes(data))
    except (struct.error, KeyError, IndexError, TypeError, OverflowError) as error:
        raise ValueError(f"the records are damaged: {error}") from error


def _times(times: Sequence[float]) -> bytes:
    bits = struct.unpack(f"<{len(times)}Q", struct.pack(f"<{len(times)}d", *times))
    before = (0, *bits)
    steps = [(new - old) & _MASK for new, old in zip(bits, before, strict=False)]
    return _apart(struct.pack(f"<{len(steps)}Q", *steps), 8)


def _column(field: str, column: Sequence[Any]) -> list[bytes]:
    if field == _TEXT:
        texts = [text.encode("utf-8", "surrogatepass") for text in column]
        lengths = struct.pack(f"<{len(texts)}I", *map(len, texts))
        return [_apart(lengths, 4), *texts]
    numbers = struct.pack(f"<{len(column)}{field}", *column)
    return [_apart(numbers, struct.calcsize(field))]


def _apart(data: bytes, width: int) -> bytes:
    """Put the lowest bytes of numbers first, then the next ones, and so on."""
    return data if width == 1 else b"".join(data[place::width] for place in range(width))


def _together(data: bytes, width: int) -> bytes:
    """Undo `_apart`."""
    count = len(data) // width
    whole = bytearray(len(data))
    for place in range(width):
        whole[place::width] = data[place * count : (place + 1) * count]
    return bytes(whole)


class _Bytes:
    """Bytes that are taken from the front."""

    def __init__(self, data: bytes) -> None:
        self._data = data
        self._at = 0

    @property
    def is_empty(self) -> bool:
        return self._at == len(self._data)

    def take(self, size: int) -> bytes:
        """Take so many bytes; an IndexError where there are fewer."""
        if size > len(self._data) - self._at:
            raise IndexError("there are bytes missing")
        self._at += size
        return self._data[self._at - size : self._at]

    def numbers(self, field: str, count: int) -> tuple[int, ...]:
        width = struct.calcsize(f"<{field}")
        return struct.unpack(f"<{count}{field}", _together(self.take(count * width), width))


def _decoded(data: _Bytes) -> list[Record]:
    count = struct.unpack("<I", data.take(4))[0]
    kinds = data.take(count)
    bits = accumulate(data.numbers("Q", count), lambda old, step: (old + step) & _MASK)
    times = struct.unpack(f"<{count}d", struct.pack(f"<{count}Q", *bits))
    by_code: dict[int, list[float]] = {}
    for code, time in zip(kinds, times, strict=True):
        by_code.setdefault(code, []).append(time)
    made: dict[int, Iterator[Record]] = {}
    for code in sorted(by_code):
        kind = _BY_CODE[code]
        columns = [_read_column(data, field, len(by_code[code])) for field in kind.fields]
        made[code] = map(kind.record, by_code[code], *columns)
    records = [next(made[code]) for code in kinds]
    if not data.is_empty:
        raise ValueError("there are bytes behind the last record")
    return records


def _read_column(data: _Bytes, field: str, count: int) -> Sequence[Any]:
    if field == _TEXT:
        lengths = data.numbers("I", count)
        return [data.take(length).decode("utf-8", "surrogatepass") for length in lengths]
    return data.numbers(field, count)
