"""Reading a `.trexrec` file, whole or damaged, from any place of it."""

import struct
from collections.abc import Callable
from copy import copy
from pathlib import Path

from trex_gui.core.recording.blocks import Block
from trex_gui.core.recording.errors import RecordingError, opened
from trex_gui.devices.trex.recording.codec import decode
from trex_gui.devices.trex.recording.layout import (
    DATA_HEAD,
    INDEX_ENTRY,
    LARGEST_BODY,
    MAGIC,
    PREAMBLE,
    SECTION,
    VERSION,
    Section,
    crc_of,
    unpack_run,
)
from trex_gui.devices.trex.recording.recording import Header, Record

_PIECE = 1 << 20
_LONGEST_SEARCH = 64 << 20
"""Bytes behind a damaged place that are searched for the next whole block."""


class TrexrecFile:
    """A recording on disk; every section is checked against its CRC when it is looked through.

    Attributes:
        header: of what it is.
        blocks: the whole blocks.
        problems: what is missing, as sentences.
    """

    def __init__(self, path: Path, *, head_only: bool = False) -> None:
        """Open a recording; with `head_only` it has no blocks before `look_through`.

        Raises:
            RecordingError: there is none, or its head cannot be read.
        """
        self.path = path
        self.blocks: list[Block] = []
        self.problems: list[str] = []
        self._file = opened(path)
        try:
            self.header = self._read_head()
            if not head_only:
                self.look_through()
        except BaseException:
            self._file.close()
            raise

    def close(self) -> None:
        self._file.close()

    def again(self) -> "TrexrecFile":
        """Return the same recording opened once more, for another thread.

        Raises:
            RecordingError: it cannot be opened any more.
        """
        other = copy(self)
        other._file = opened(self.path)  # noqa: SLF001 - one of its own kind
        return other

    def read(self, index: int) -> list[Record]:
        block = self.blocks[index]
        section = self._section_at(block.place)
        if section is None or section.tag != b"DATA":
            raise self._error("The block was changed while the file was open.", block.place)
        try:
            return decode(unpack_run(section.body))
        except ValueError as error:
            raise self._error(f"The block cannot be read: {error}.", block.place) from error

    # --- Looking through ----------------------------------------------------------------

    def _read_head(self) -> Header:
        preamble = self._bytes_at(0, PREAMBLE.size)
        if len(preamble) < PREAMBLE.size or not preamble.startswith(MAGIC):
            raise self._error("This is no recording of TReX Studio.", 0)
        version = PREAMBLE.unpack(preamble)[1]
        if version != VERSION:
            raise self._error(f"Its format, {version}, is not known here, only {VERSION}.", 8)
        section = self._section_at(PREAMBLE.size)
        if section is None or section.tag != b"HEAD":
            raise self._error("The header is damaged or cut off.", PREAMBLE.size)
        self._start = section.end
        try:
            return Header.from_json(section.body.decode("utf-8"))
        except ValueError as error:
            raise self._error(f"The header cannot be understood: {error}.", 10) from error

    def look_through(self, tell: Callable[[float], None] = lambda _share: None) -> None:
        """Find every whole block, and say what lies between and behind them.

        `tell` is told the share that is done, 0 to 1; what it raises ends the work.

        Raises:
            RecordingError: it cannot be read.
        """
        place, entries, done = self._start, None, False
        end = self._end()
        while place < end:
            tell(place / end)
            section = self._section_at(place)
            if section is None:
                following = self._next_whole(place, end)
                self._miss(place, end if following is None else following)
                if following is None:
                    break
                place = following
                continue
            if section.tag == b"DATA":
                self._note_block(section)
            elif section.tag == b"INDX":
                entries = _entries(section.body)
            done = done or section.tag == b"DONE"
            place = section.end
        if not done:
            self.problems.append(
                "It was not ended; what came after its last whole block is missing."
            )
        if entries is not None:
            held = {block.place for block in self.blocks}
            lost = [block for block in entries if block.place not in held]
            if lost:
                records = sum(block.count for block in lost)
                begin = lost[0].first - self.header.clock
                self.problems.append(
                    f"{len(lost)} blocks with {records} records are lost, the first from "
                    f"{begin:.1f} s on."
                )

    def _note_block(self, section: Section) -> None:
        try:
            first, last, count, _ = DATA_HEAD.unpack_from(section.body)
            unpack_run(section.body)
        except (struct.error, ValueError):
            self._miss(section.place, section.end)
            return
        self.blocks.append(Block(first, last, count, section.place))

    def _miss(self, place: int, end: int) -> None:
        behind = self.blocks[-1].last - self.header.clock if self.blocks else 0.0
        self.problems.append(
            f"Behind {behind:.1f} s, {end - place} bytes from byte {place} on are no whole block."
        )

    def _next_whole(self, place: int, end: int) -> int | None:
        """Return where the next whole section begins behind a damaged place."""
        limit = min(end, place + _LONGEST_SEARCH)
        at = place + 1
        while at < limit:
            piece = self._bytes_at(at, _PIECE + 3)
            found = min(
                (i for tag in (b"DATA", b"INDX", b"DONE") if (i := piece.find(tag)) >= 0),
                default=-1,
            )
            if found < 0:
                at += _PIECE
                continue
            if self._section_at(at + found) is not None:
                return at + found
            at += found + 1
        return None

    # --- Bytes --------------------------------------------------------------------------

    def _section_at(self, place: int) -> Section | None:
        """Return the section that begins here; `None` where there is no whole one."""
        head = self._bytes_at(place, SECTION.size)
        if len(head) < SECTION.size:
            return None
        tag, length, crc = SECTION.unpack(head)
        if length > LARGEST_BODY:
            return None
        body = self._bytes_at(place + SECTION.size, length)
        if len(body) < length or crc_of(tag, body) != crc:
            return None
        return Section(tag, body, place)

    def _bytes_at(self, place: int, size: int) -> bytes:
        try:
            self._file.seek(place)
            return self._file.read(size)
        except (OSError, ValueError) as error:
            raise self._error(f"It cannot be read: {error}.", place) from error

    def _end(self) -> int:
        try:
            return self._file.seek(0, 2)
        except (OSError, ValueError) as error:
            raise self._error(f"It cannot be read: {error}.", 0) from error

    def _error(self, message: str, place: int) -> RecordingError:
        return RecordingError(str(self.path), message, f"byte {place}")


def _entries(body: bytes) -> list[Block]:
    whole = body[: len(body) // INDEX_ENTRY.size * INDEX_ENTRY.size]
    return [
        Block(first, last, count, place)
        for place, first, last, count in INDEX_ENTRY.iter_unpack(whole)
    ]
