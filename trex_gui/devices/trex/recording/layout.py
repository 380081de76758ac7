r"""The bytes of a `.trexrec` file.

A file is a preamble and then sections, all numbers little-endian:

    preamble    89 54 52 45 58 52 45 43 (`\x89TREXREC`), version (2 bytes; now 1)
    section     tag (4 letters), length of the body (4 bytes), CRC-32 (4 bytes, as zlib's, over
                tag, length and body), body

| tag | body |
|---|---|
| HEAD | the header as JSON in UTF-8; the first section, once |
| DATA | earliest and latest time (a double each, seconds), records (4 bytes), size of what is |
|      | packed (4 bytes), then the packed run of records (zlib); `codec` says what is in it |
| INDX | for each DATA: place in the file (8 bytes), earliest and latest time, records (4 bytes) |
| DONE | place of INDX (8 bytes); the last section of a recording that was ended |

Sections with other tags are skipped. A body is at most 4 MiB, and so is what is packed in it
four times over. A recording that was cut off lacks INDX and DONE and perhaps a part of its last
DATA; every DATA before that can be read by itself.
"""

import struct
import zlib
from dataclasses import dataclass

MAGIC = b"\x89TREXREC"
VERSION = 1
PREAMBLE = struct.Struct("<8sH")
SECTION = struct.Struct("<4sII")
DATA_HEAD = struct.Struct("<ddII")
INDEX_ENTRY = struct.Struct("<QddI")
DONE = struct.Struct("<Q")

LARGEST_BODY = 4 << 20
LARGEST_RUN = 16 << 20
RECORDS = 1000
"""Records in one block: five seconds at full rate."""

SUFFIX = ".trexrec"


@dataclass(frozen=True, slots=True)
class Section:
    """One section, and where it begins in the file."""

    tag: bytes
    body: bytes
    place: int

    @property
    def end(self) -> int:
        """Where the next one begins."""
        return self.place + SECTION.size + len(self.body)


def section(tag: bytes, body: bytes) -> bytes:
    """Return a section as bytes.

    Raises:
        ValueError: the body is too large.
    """
    if len(body) > LARGEST_BODY:
        raise ValueError(f"a section of {len(body)} bytes is too large")
    head = tag + struct.pack("<I", len(body))
    return head + struct.pack("<I", zlib.crc32(body, zlib.crc32(head))) + body


def crc_of(tag: bytes, body: bytes) -> int:
    """Return what the CRC of a section must be."""
    return zlib.crc32(body, zlib.crc32(tag + struct.pack("<I", len(body))))


def unpack_run(body: bytes) -> bytes:
    """Return what is packed in the body of a DATA section.

    Raises:
        ValueError: it is damaged, or larger than any that is written.
    """
    if len(body) < DATA_HEAD.size:
        raise ValueError("a block is too short")
    size = DATA_HEAD.unpack_from(body)[3]
    if size > LARGEST_RUN:
        raise ValueError(f"a block of {size} bytes is too large")
    try:
        unpacker = zlib.decompressobj()
        run = unpacker.decompress(body[DATA_HEAD.size :], size + 1)
    except zlib.error as error:
        raise ValueError(f"a block cannot be unpacked: {error}") from error
    if len(run) != size:
        raise ValueError("a block does not unpack to its size")
    return run
