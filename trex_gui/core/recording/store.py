"""Recordings stored as SQLite databases, with one table per sample kind.

Every table has the columns `record` (number in order of arrival, unique in the file), `clock_s`
(session clock), `time_s` (time from the start of the recording) and the columns of its kind.
Physical values are generated columns. Comments in the schema document every column. A header table
describes the recording.
"""

import contextlib
import errno
import os
import shutil
import sqlite3
import struct
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from operator import itemgetter
from pathlib import Path
from tempfile import TemporaryDirectory
from types import NoneType
from typing import Any, Generic, cast

from trex_gui.core.files import atomic_file, check_ordinary, open_ordinary
from trex_gui.core.recording.kinds import (
    LONGEST_TEXT,
    MARKERS,
    SOURCE,
    HeaderT,
    Marker,
    RecordingError,
    RecordingFormat,
    RecordT,
    SampleKind,
    Timestamped,
    Value,
)
from trex_gui.core.translation import tr, tr_noop

SUFFIX = ".trexrec"
APPLICATION_ID = 0x54524543  # `TREC`, at offset 68 of the file
SCHEMA_VERSION = 1
CHUNK = 1000  # records read at a time
_TYPES = {"INTEGER": int, "REAL": float, "TEXT": str}
_MAGIC = b"SQLite format 3\0"
_SQLITE_HEADER = struct.Struct(">16xH10xI")  # page size and page count
_MAX_VALUE = 4 * LONGEST_TEXT  # bytes; SQLite rejects longer values
_MAX_HEADER_ROWS = 100
_MAX_PROBLEMS = 20
_LATEST_CLOCK = 1e10  # seconds: about three hundred years
_EARLIEST_S = -3600.0  # earliest time of a record, in seconds from the start
_LATEST_S = 200 * 86400.0  # latest time of a record, in seconds from the start
_NOT_A_RECORDING = tr_noop("This is not a TReX Studio recording.")
NOT_WRITTEN = tr_noop("The file cannot be written: {0}.")
_NOT_OPENED = tr_noop("The file cannot be opened: {0}.")
_NOT_READ = tr_noop("The file cannot be read: {0}.")
_DAMAGED = tr_noop("The file is damaged: {0}.")
_ENDED = "ended_utc_s"

_Content = tuple[str, bool]  # SQL type of a column, and True if the column may be NULL

ExportRow = tuple[float, int, tuple[Value, ...]]
"""Time from the start (s), index of the sample kind, values of its exported columns."""


def _reason_of(error: Exception) -> str:
    if getattr(error, "sqlite_errorcode", None) == sqlite3.SQLITE_FULL:
        return os.strerror(errno.ENOSPC)
    return str(getattr(error, "strerror", None) or error)


@contextlib.contextmanager
def reported(path: Path, message: str) -> Iterator[None]:
    """Convert disk errors to RecordingError. `message`: text with a placeholder for the reason."""
    try:
        yield
    except (OSError, ValueError, sqlite3.Error) as error:
        raise RecordingError(str(path), tr(message).format(_reason_of(error))) from error


# --- Writing ----------------------------------------------------------------------------


class RecordingWriter(Generic[HeaderT, RecordT]):
    """Writes a recording in one thread. Replaces an existing file.

    Committed records survive a crash of the program. Synced records survive a power failure. All
    methods raise RecordingError if the disk fails.
    """

    def __init__(self, path: Path, fmt: RecordingFormat[HeaderT], header: HeaderT) -> None:
        self._path, self._type_of = path, fmt.type_of
        self._count = 0
        self._kinds: dict[type[object], tuple[SampleKind, str]] = {}
        with reported(path, NOT_WRITTEN):
            with atomic_file(path) as draft:
                draft.close()
                with contextlib.closing(_connect(draft.name)) as database:
                    self._create(database, fmt, header)
                # Otherwise SQLite would apply the log of an older recording to the new one.
                _remove_companions(Path(os.path.realpath(path)))
            self._database = _connect(path)
            execute = self._database.execute
            try:
                # In exclusive mode, the index of the log stays in memory. If it were a mapped file,
                # a lost disk would end the process with SIGBUS, and nothing would stop the motors.
                execute("PRAGMA locking_mode = EXCLUSIVE")
                execute("PRAGMA journal_mode = WAL")
                execute("PRAGMA synchronous = NORMAL")
            except BaseException:
                self._database.close()
                raise

    def _create(
        self, database: sqlite3.Connection, fmt: RecordingFormat[HeaderT], header: HeaderT
    ) -> None:
        execute = database.execute
        execute("PRAGMA journal_mode = OFF")  # an incomplete draft is never used
        execute(f"PRAGMA application_id = {APPLICATION_ID}")
        execute(f"PRAGMA user_version = {SCHEMA_VERSION}")
        execute("BEGIN")
        execute("CREATE TABLE header (key TEXT PRIMARY KEY, value)")
        values = {"device": fmt.device, **header.values()}
        database.executemany("INSERT INTO header VALUES (?, ?)", values.items())
        for kind in fmt.kinds(header):
            execute(_create_table(kind, header.clock))
            names = ", ".join(column.name for column in kind.columns)
            marks = ", ?" * len(kind.columns)
            insert = f"INSERT INTO {kind.name} (record, clock_s{', ' * bool(names)}{names}) "
            self._kinds[kind.type] = (kind, f"{insert} VALUES (?, ?{marks})")
        execute("COMMIT")

    @property
    def size(self) -> int:
        """Size of the file in bytes, including data that is not committed yet."""
        return _size(self._database)

    def write(self, records: Sequence[RecordT | Marker]) -> None:
        """Add records to the file. They are not saved before `commit`."""
        rows: dict[type[object], list[tuple[Value, ...]]] = {}
        number = self._count
        for record in records:
            number += 1
            record_type = self._type_of(record)
            kind = self._kinds[record_type][0]
            rows.setdefault(record_type, []).append((number, record.time, *kind.pack(record)))
        with reported(self._path, NOT_WRITTEN):
            if not self._database.in_transaction:
                self._database.execute("BEGIN")
            for record_type, values in rows.items():
                self._database.executemany(self._kinds[record_type][1], values)
        self._count = number

    def commit(self) -> None:
        """Save the records, so that they survive a crash of the program."""
        with reported(self._path, NOT_WRITTEN):
            if self._database.in_transaction:
                self._database.execute("COMMIT")

    def sync(self) -> None:
        """Save the records, so that they survive a power failure."""
        self.commit()
        with reported(self._path, NOT_WRITTEN):
            self._database.execute("PRAGMA wal_checkpoint(PASSIVE)")

    def finish(self) -> None:
        """Mark the recording as ended and save it."""
        self.write([])
        with reported(self._path, NOT_WRITTEN):
            self._database.execute(
                "INSERT INTO header VALUES (?, CAST(strftime('%s') AS INTEGER))", (_ENDED,)
            )
            self._database.execute("COMMIT")
            with contextlib.suppress(sqlite3.OperationalError):  # open in another program
                self._database.execute("PRAGMA journal_mode = DELETE")

    def close(self) -> None:
        with contextlib.suppress(sqlite3.Error):
            self._database.close()


def _connect(path: str | Path) -> sqlite3.Connection:
    return sqlite3.connect(path, isolation_level=None)


def _companions(path: Path) -> Iterator[Path]:
    for suffix in ("-wal", "-shm", "-journal"):
        yield path.with_name(path.name + suffix)


def _remove_companions(path: Path) -> None:
    for companion in _companions(path):
        companion.unlink(missing_ok=True)


def copy_recording(source: Path, path: Path) -> None:
    """Copy a recording, including its log. Overwrites `path`. Raises RecordingError."""
    with reported(path, NOT_WRITTEN), open_ordinary(source) as original, atomic_file(path) as copy:
        shutil.copyfileobj(original, copy)
        copy.close()
        _add_log(Path(os.path.realpath(source)), Path(copy.name))
        _remove_companions(Path(os.path.realpath(path)))


def _add_log(source: Path, copy: Path) -> None:
    """Add the records in the log of `source` to its copy."""
    try:
        with contextlib.suppress(FileNotFoundError):
            shutil.copyfile(f"{source}-wal", f"{copy}-wal")
            with contextlib.closing(_connect(copy)) as database:
                database.execute("PRAGMA locking_mode = EXCLUSIVE")
                database.execute("PRAGMA journal_mode = DELETE")
    finally:
        _remove_companions(copy)


def remove_recording(path: Path) -> None:
    """Remove a recording and its SQLite companion files. Raises OSError."""
    path.unlink()
    _remove_companions(path)


def _create_table(kind: SampleKind, start: float) -> str:
    lines = [
        ("record INTEGER PRIMARY KEY", "number in order of arrival"),
        ("clock_s REAL NOT NULL", "session's clock"),
        (_generated("time_s", f"clock_s - {start!r}", 6), "time from the start"),
    ]
    for column in kind.columns:
        null = "" if column.optional else " NOT NULL"
        lines.append((f"{column.name} {column.type}{null}", column.description))
        if (physical := column.physical) is not None:
            scale = repr(physical.scale)
            if physical.scales:
                others = (f"WHEN {key} THEN {value!r}" for key, value in physical.scales.items())
                scale = f"CASE {SOURCE} {' '.join(others)} ELSE {scale} END"
            expression = f"{column.name} * {scale}"
            generated = _generated(physical.name, expression, physical.digits)
            lines.append((generated, column.description))
    body = "".join(
        f"    {line}{',' if number < len(lines) else ''} -- {comment}\n"
        for number, (line, comment) in enumerate(lines, 1)
    )
    return f"CREATE TABLE {kind.name} (\n{body})"


def _generated(name: str, expression: str, digits: int) -> str:
    return f"{name} REAL GENERATED ALWAYS AS (round({expression}, {digits})) VIRTUAL"


# --- Reading ----------------------------------------------------------------------------


class Recording(Generic[HeaderT, RecordT]):
    """Recording that is opened read-only. Use it in one thread at a time."""

    def __init__(self, path: Path, fmt: RecordingFormat[HeaderT]) -> None:
        self.path = path
        self.problems: list[str] = []  # sentences about missing or unreadable parts
        self.format = fmt
        if path.suffix.lower() == ".csv":
            raise self._error(
                tr(
                    "A CSV file is an export and cannot be opened as a recording. Open the "
                    "original recording ({0})."
                ).format(SUFFIX)
            )
        with reported(path, _NOT_OPENED), open_ordinary(path) as file:
            sqlite_header = file.read(_SQLITE_HEADER.size)
            size = file.seek(0, os.SEEK_END)
        if len(sqlite_header) < _SQLITE_HEADER.size or not sqlite_header.startswith(_MAGIC):
            raise self._error(tr(_NOT_A_RECORDING))
        page_size, pages = _SQLITE_HEADER.unpack(sqlite_header)
        with reported(path, _NOT_OPENED):
            for companion in _companions(path):
                with contextlib.suppress(FileNotFoundError):
                    check_ordinary(companion)
        # The log contains committed records that are not yet synced.
        log = path.with_name(f"{path.name}-wal")
        if size < page_size * pages and not log.exists():
            self.problems.append(tr("The end of the file is missing."))
        self._resources = contextlib.ExitStack()
        try:
            self._database = self._connect()
            with reported(path, _DAMAGED):
                self.header = self._read_header()
                self.kinds = self._checked_tables(fmt.kinds(self.header))
                self.count = self._last_record()  # number of the last record; the first is 1
                self._valid_types = defaultdict[tuple[str, ...], set[tuple[type, ...]]](set)
        except BaseException:
            self.close()
            raise

    def _uris(self) -> Iterator[str]:
        path = Path(os.path.realpath(self.path))
        yield f"{path.as_uri()}?mode=ro"
        # SQLite cannot read the log of an unfinished recording in a read-only folder.
        log = path.with_name(f"{path.name}-wal")
        if log.exists():
            with contextlib.suppress(OSError):
                copy = Path(self._resources.enter_context(TemporaryDirectory()))
                for part in (path, log):
                    shutil.copyfile(part, copy / part.name)
                yield f"{(copy / path.name).as_uri()}?mode=ro"
            self.problems.append(
                tr("The log of the recording cannot be read, so the last samples are missing.")
            )
        yield f"{path.as_uri()}?immutable=1"

    def _connect(self) -> sqlite3.Connection:
        for uri in self._uris():
            try:
                database = sqlite3.connect(
                    uri, uri=True, timeout=0, isolation_level=None, check_same_thread=False
                )
            except sqlite3.Error as error:
                reason = _reason_of(error)
                continue
            try:
                database.execute("PRAGMA trusted_schema = OFF")
                database.execute("PRAGMA cell_size_check = ON")
                database.execute("PRAGMA writable_schema = ON")  # to read a truncated file
                database.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, _MAX_VALUE)
                database.execute("SELECT count(*) FROM sqlite_master").fetchone()
            except sqlite3.Error as error:
                database.close()
                if error.sqlite_errorcode == sqlite3.SQLITE_BUSY:
                    message = tr(
                        "The recording is still running. End the recording, then open the "
                        "file again."
                    )
                    raise self._error(message) from error
                reason = _reason_of(error)
            else:
                self._resources.callback(database.close)
                return database
        raise self._error(tr(_NOT_READ).format(reason))

    def _error(self, message: str) -> RecordingError:
        return RecordingError(str(self.path), message)

    def _read_header(self) -> HeaderT:
        execute = self._database.execute
        if execute("PRAGMA application_id").fetchone()[0] != APPLICATION_ID:
            raise self._error(tr(_NOT_A_RECORDING))
        version = execute("PRAGMA user_version").fetchone()[0]
        if version != SCHEMA_VERSION:
            raise self._error(
                tr(
                    "The format of the file ({0}) is unknown. A later version of TReX Studio "
                    "may be able to open the file."
                ).format(version)
            )
        values = dict(
            execute(
                "SELECT key, value FROM header"
                " WHERE length(key || coalesce(value, '')) <= ? LIMIT ?",
                (LONGEST_TEXT, _MAX_HEADER_ROWS),
            ).fetchall()
        )
        if values.get("device") != self.format.device:
            name = str(values.get("device_name") or values.get("device"))[:60]
            raise self._error(
                tr(
                    "This is a recording of another device: {0}. Select the port or the demo "
                    "of that device in the list of ports, then open the file again."
                ).format(name)
            )
        if _ENDED not in values:
            self.problems.append(
                tr(
                    "The recording was not closed properly. Samples from the last seconds "
                    "may be missing."
                )
            )
        header = self.format.read_header(values)
        if not abs(header.clock) <= _LATEST_CLOCK:  # also NaN
            raise ValueError(tr("the clock in the header is not in seconds"))
        return header

    def _checked_tables(self, kinds: Iterable[SampleKind]) -> tuple[SampleKind, ...]:
        """Return the kinds that the file contains. Report missing kinds.

        A kind may be missing because it is newer than the file. Raises RecordingError if a
        table has an unexpected structure, or if there is no table of markers, which every version
        writes.
        """
        available = []
        query = "SELECT name FROM sqlite_master WHERE type = 'table' AND sql LIKE 'CREATE TABLE%'"
        tables = {name for (name,) in self._database.execute(query)}
        for kind in kinds:
            problem = (
                "" if kind.name in tables else tr("The table {0} is missing.").format(kind.name)
            )
            info = self._database.execute(f"PRAGMA table_xinfo({kind.name})").fetchall()
            missing = {"record", "clock_s", "time_s", *kind.exported} - {row[1] for row in info}
            if missing and not problem:
                column = f"{kind.name}.{min(missing)}"
                problem = tr("The column {0} is missing.").format(column)
            if problem and kind is MARKERS:
                raise self._error(problem)
            if problem:
                self.problems.append(problem)
                continue
            stored = {"record", "clock_s", *(column.name for column in kind.columns)}
            for _, name, *_, hidden in info:
                if hidden and name in stored:  # an expression could produce any amount of data
                    column = f"{kind.name}.{name}"
                    raise self._error(
                        tr("The column {0} is computed, but it must be stored.").format(column)
                    )
            # Without this key, a search for records would be slow.
            if [row[1:3] for row in info if row[5]] != [("record", "INTEGER")]:
                message = tr("The column {0} is not the key of its table.")
                raise self._error(message.format(f"{kind.name}.record"))
            available.append(kind)
        return tuple(available)

    def _last_record(self) -> int:
        last = 0
        for kind in self.kinds:
            query = f"SELECT max(record) FROM {kind.name}"
            # A damaged table is reported when its records are read.
            with contextlib.suppress(sqlite3.DatabaseError, TypeError):
                last = max(last, self._database.execute(query).fetchone()[0] or 0)
        return min(last, _size(self._database))  # each record takes more than one byte

    def close(self) -> None:
        self._resources.close()

    def read(self, first: int, last: int) -> list[RecordT]:
        """Return the records with the numbers `first` to `last`. Report damaged records."""
        records: list[tuple[int, Timestamped]] = []
        for kind in self.kinds:
            stored = {column.name: (column.type, column.optional) for column in kind.columns}
            for number, *values in self._valid_rows(kind, stored, first, last):
                try:
                    records.append((number, kind.unpack(*values)))
                except (ValueError, KeyError, TypeError) as error:
                    self._report_damaged(number, error)
        records.sort(key=itemgetter(0))
        return cast("list[RecordT]", [record for _, record in records])

    def export_rows(self, first: int, last: int, start: float, end: float) -> list[ExportRow]:
        rows: list[tuple[int, ExportRow]] = []
        for index, kind in enumerate(self.kinds):
            columns = {"time_s": ("REAL", False)}
            for column in kind.columns:
                columns[column.name] = (column.type, column.optional)
                if column.physical is not None:
                    columns[column.physical.name] = ("REAL", column.optional)
            for number, clock, time, *values in self._valid_rows(kind, columns, first, last):
                if start <= clock <= end:
                    rows.append((number, (time, index, tuple(values))))
        rows.sort(key=itemgetter(0))
        return [row for _, row in rows]

    def _valid_rows(
        self, kind: SampleKind, columns: Mapping[str, _Content], first: int, last: int
    ) -> Iterator[tuple[Any, ...]]:
        """Yield the number, clock and `columns` of each record. Report damaged records.

        The types are checked, because SQLite stores values of any type in any column.
        """
        names = ("record", "clock_s", *columns)
        valid = self._valid_types[kind.name, *names]
        for row in self._select(kind, ", ".join(names), first, last):
            if (types := tuple(map(type, row))) not in valid:
                if problem := _wrong_type(columns, types):
                    self._report_damaged(row[0], problem)
                    continue
                valid.add(types)
            if _EARLIEST_S <= row[1] - self.header.clock <= _LATEST_S:
                yield row
            else:
                self._report_damaged(row[0], tr("its time is outside the recording"))

    def _select(self, kind: SampleKind, names: str, first: int, last: int) -> list[tuple[Any, ...]]:
        query = f"SELECT {names} FROM {kind.name} WHERE record BETWEEN ? AND ? ORDER BY record"
        try:
            return self._database.execute(query, (first, last)).fetchall()
        except sqlite3.ProgrammingError as error:  # the database is closed
            raise self._error(tr(_NOT_READ).format(error)) from error
        except (sqlite3.Error, UnicodeError) as error:
            self._report(
                tr("Samples of the kind {0} between records {1} and {2} are lost: {3}.").format(
                    kind.name, first, last, error
                )
            )
            return []

    def _report_damaged(self, number: object, reason: object) -> None:
        self._report(tr("Record {0} cannot be read: {1}.").format(number, reason))

    def _report(self, problem: str) -> None:
        if problem not in self.problems and len(self.problems) < _MAX_PROBLEMS:
            self.problems.append(problem)


def _wrong_type(columns: Mapping[str, _Content], types: Sequence[type]) -> str:
    _number, clock, *values = types
    if clock is not float:
        return tr("its time is not a number")
    for (name, (type_name, is_optional)), actual in zip(columns.items(), values, strict=True):
        if actual is not _TYPES[type_name] and not (is_optional and actual is NoneType):
            return tr("{0} is not of type {1}").format(name, type_name)
    return ""


def _size(database: sqlite3.Connection) -> int:
    pages = database.execute("PRAGMA page_count").fetchone()[0]
    return int(pages * database.execute("PRAGMA page_size").fetchone()[0])
