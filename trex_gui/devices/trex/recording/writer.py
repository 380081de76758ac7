"""Writing a `.trexrec` file, a block at a time."""

import zlib
from collections.abc import Sequence
from typing import BinaryIO

from trex_gui.core.recording.blocks import Block
from trex_gui.devices.trex.recording.codec import encode
from trex_gui.devices.trex.recording.layout import (
    DATA_HEAD,
    DONE,
    INDEX_ENTRY,
    LARGEST_BODY,
    MAGIC,
    PREAMBLE,
    RECORDS,
    VERSION,
    section,
)
from trex_gui.devices.trex.recording.recording import Header, Marker, Record, SettingsSeen

_LONGEST_WORDS = 1 << 20
"""Characters of text after which a block is written, so that it stays small enough."""


class TrexrecWriter:
    """Packs records into blocks; each block can be read without the others."""

    def __init__(self, file: BinaryIO, header: Header) -> None:
        self.size = 0
        self._file = file
        self._waiting: list[Record] = []
        self._words = 0
        self._blocks: list[Block] = []
        self._put(PREAMBLE.pack(MAGIC, VERSION))
        self._put(section(b"HEAD", header.to_json().encode("utf-8")))

    def write(self, records: Sequence[Record]) -> None:
        for record in records:
            self._waiting.append(record)
            if isinstance(record, Marker | SettingsSeen):
                self._words += len(record.text)
            if len(self._waiting) >= RECORDS or self._words >= _LONGEST_WORDS:
                self.flush()

    def flush(self) -> None:
        """Write what waits as a block of its own."""
        if not self._waiting:
            return
        records, self._waiting, self._words = self._waiting, [], 0
        times = [record.time for record in records]
        run = encode(records)
        block = Block(min(times), max(times), len(records), self.size)
        head = DATA_HEAD.pack(block.first, block.last, block.count, len(run))
        self._put(section(b"DATA", head + zlib.compress(run, 6)))
        self._blocks.append(block)

    def finish(self) -> None:
        self.flush()
        entries = [INDEX_ENTRY.pack(b.place, b.first, b.last, b.count) for b in self._blocks]
        place = self.size
        # 28 bytes a block: what has no room belongs to a recording of more than a week.
        self._put(section(b"INDX", b"".join(entries[: LARGEST_BODY // INDEX_ENTRY.size])))
        self._put(section(b"DONE", DONE.pack(place)))
        self._file.flush()

    def _put(self, data: bytes) -> None:
        self._file.write(data)
        self.size += len(data)
