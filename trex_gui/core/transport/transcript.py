"""Traffic as a text file that users can read and that the program can replay.

The file has comments, a line of column names, and one tab-separated line per transaction.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import TextIO

from trex_gui.core.errors import StudioError
from trex_gui.core.files import SettingsError
from trex_gui.core.translation import tr
from trex_gui.core.transport.traffic import (
    SEARCH,
    Decoder,
    TrafficEvent,
    Transaction,
    TransactionAssembler,
)
from trex_gui.version import __version__

COLUMNS = ("time", "fault", "sent", "received", "took_ms", "meaning")
LARGEST = 16 * 1024 * 1024  # bytes; about a hundred thousand transactions


def header() -> str:
    written = datetime.now(UTC).astimezone().isoformat(sep=" ", timespec="seconds")
    columns = "\t".join(COLUMNS)
    return f"# TReX Studio {__version__}: traffic on the line\n# written {written}\n{columns}\n"


def line_of(row: Transaction, decoder: Decoder, epoch: float) -> str:
    """Return a row as a line of the file. `epoch`: Unix time in s at which the clock was 0."""
    meaning, shown = decoder.decoded(row), decoder.display_text
    moment = datetime.fromtimestamp(epoch + row.time).astimezone()
    values = (
        moment.isoformat(sep=" ", timespec="milliseconds"),
        "!" if meaning.is_fault else "",
        shown(row.sent),
        shown(row.received),
        "" if row.seconds is None else f"{row.seconds * 1e3:.1f}",
        meaning.text,
    )
    return "\t".join(values)


class TranscriptWriter:
    """Writes the traffic of a line to a file.

    The file is opened before the line. Its old content is kept until the first byte is written.
    A later disk error does not affect the line. `error`: reason why the file is incomplete.
    """

    def __init__(
        self, path: Path | None, decoder: Decoder, epoch: float, *, is_search: bool = False
    ) -> None:
        self.error: OSError | None = None
        self._path = path
        self._decoder = decoder
        self._epoch = epoch
        self._assembler = TransactionAssembler(decoder, is_search=is_search)
        self._pending: Transaction | None = None
        self._file: TextIO | None = None
        self.text = header()  # text that is not yet in the file
        self._has_content = False

    def open(self) -> None:
        """Open the file if necessary. Raises StudioError."""
        if self._file is not None or self._path is None:
            return
        try:
            self._file = self._path.open(
                "a", encoding="utf-8", errors="backslashreplace", newline=""
            )
        except OSError as error:
            reason = error.strerror or error
            raise StudioError(
                tr("{0} cannot be written: {1}.").format(self._path, reason)
            ) from error

    def record(self, event: TrafficEvent) -> None:
        for row in self._assembler.feed([event]):
            self._pending = None if row.is_over else row
            if row.is_over:
                self._write_row(row)

    def close(self) -> None:
        if self._pending is not None:
            self._pending.is_over = True
            self._write_row(self._pending)
        if self._file is not None:
            try:
                self._file.close()
            except OSError as error:
                self.error = self.error or error

    def _write_row(self, row: Transaction) -> None:
        self._decoder.learn(row)
        if self.error is not None:
            return
        self.text += line_of(row, self._decoder, self._epoch) + "\n"
        if self._file is None or not (self._has_content or row.sent or row.received):
            return
        try:
            if not self._has_content and self._file.seekable():
                self._file.truncate(0)
            self._file.write(self.text)
        except OSError as error:
            self.error = error
        self.text, self._has_content = "", True


@dataclass(frozen=True, slots=True)
class TranscriptRow:
    """Transaction in a file. `line`: line number from 1. `time`: Unix time in s."""

    line: int
    time: float
    sent: bytes
    received: bytes
    meaning: str

    @property
    def is_search(self) -> bool:
        """True for bytes of a device search, which may have used other line settings."""
        return self.meaning.startswith(SEARCH)


def read_transcript(text: str, name: str, decoder: Decoder) -> Iterator[TranscriptRow]:
    """Yield the rows that have bytes. Raises SettingsError for an invalid file."""
    lines = text.removesuffix("\n").replace("\r\n", "\n").split("\n")
    first = next((index for index, line in enumerate(lines) if not line.startswith("#")), 0)
    if tuple(lines[first].split("\t"))[: len(COLUMNS)] != COLUMNS:
        message = tr("this is not a traffic log from the Traffic page or from trexcmd --traffic")
        raise SettingsError.of(name, message)
    for number, line in enumerate(lines[first + 1 :], first + 2):
        cells = line.split("\t")
        try:
            moment, sent, received = cells[0], cells[2], cells[3]
            row = TranscriptRow(
                number,
                datetime.fromisoformat(moment).timestamp(),
                decoder.bytes_of(sent),
                decoder.bytes_of(received),
                cells[5],
            )
        except (IndexError, ValueError, OverflowError, OSError):
            raise SettingsError.of(name, tr("this is not a row of a traffic log"), number) from None
        if row.sent or row.received:
            yield row
