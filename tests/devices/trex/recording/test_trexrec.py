"""The binary recording: what is written is read, and damage takes only what it hits."""

import contextlib
import zlib
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.devices.trex.recording.samples import HEADER, an_hour, opened, read, records, write
from trex_gui.core.recording.errors import RecordingError
from trex_gui.devices.trex.recording.codec import decode, encode
from trex_gui.devices.trex.recording.layout import PREAMBLE, section
from trex_gui.devices.trex.recording.reader import TrexrecFile
from trex_gui.devices.trex.recording.recording import Marker, Record


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("recordings")


@pytest.fixture(scope="module")
def ten_seconds(folder: Path) -> tuple[bytes, list[Record]]:
    """A recording of forty blocks, and what is in it."""
    what = list(an_hour(10))
    write(folder / "ten.trexrec", what, flush_every=50)
    return (folder / "ten.trexrec").read_bytes(), what


@settings(deadline=None)  # files on a disk that others use, too
@given(what=st.lists(records, max_size=60))
def test_every_record_is_decoded_as_encoded(what: list[Record]) -> None:
    assert decode(encode(what)) == what


@settings(deadline=None)  # files on a disk that others use, too
@given(what=st.lists(records, max_size=60), step=st.integers(1, 20))
def test_file_returns_every_record_in_order(folder: Path, what: list[Record], step: int) -> None:
    path = folder / "any.trexrec"
    write(path, what, flush_every=step)
    assert opened(path) == (HEADER, what, [])


@settings(deadline=None)  # files on a disk that others use, too
@given(data=st.binary(max_size=200))
def test_decoding_arbitrary_bytes_raises_only_value_error(data: bytes) -> None:
    with contextlib.suppress(ValueError):
        decode(data)


@pytest.mark.slow
def test_hour_at_full_rate_is_read_back_unchanged(folder: Path) -> None:
    what = list(an_hour())
    assert len(what) > 680_000
    path = folder / "hour.trexrec"
    size = write(path, what)
    assert size == path.stat().st_size
    assert size < 8_000_000
    header, found, problems = opened(path)
    assert (header, problems) == (HEADER, [])
    assert found == what


def test_blocks_can_be_read_separately_and_backwards(folder: Path) -> None:
    what = list(an_hour(60))
    write(folder / "minute.trexrec", what)
    file = TrexrecFile(folder / "minute.trexrec")
    assert len(file.blocks) > 5
    backwards = [file.read(index) for index in reversed(range(len(file.blocks)))]
    assert [record for block in reversed(backwards) for record in block] == what
    for block, found in zip(file.blocks, reversed(backwards), strict=True):
        assert len(found) == block.count
        assert block.first == min(record.time for record in found)
        assert block.last == max(record.time for record in found)
    file.close()


def _is_whole_blocks(found: list[Record], what: list[Record], step: int = 50) -> bool:
    """Whether these are blocks of what was written, none changed and all in order."""
    blocks = [what[at : at + step] for at in range(0, len(what), step)]
    while found:
        if not blocks:
            return False
        block = blocks.pop(0)
        if found[: len(block)] == block:
            found = found[len(block) :]
    return True


@settings(deadline=None)  # files on a disk that others use, too
@given(share=st.floats(0, 1))
def test_cut_file_is_read_up_to_its_last_whole_block(
    folder: Path, ten_seconds: tuple[bytes, list[Record]], share: float
) -> None:
    data, what = ten_seconds
    path = folder / "cut.trexrec"
    cut = int(share * (len(data) - 1))
    path.write_bytes(data[:cut])
    try:
        header, found, problems = opened(path)
    except RecordingError:
        assert cut < 600  # the header itself is cut
        return
    assert header == HEADER
    assert found == what[: len(found)]
    assert len(found) % 50 == 0 or found == what
    assert any("not ended" in problem for problem in problems)


@settings(deadline=None)  # files on a disk that others use, too
@given(share=st.floats(0, 1), bits=st.integers(1, 255), second=st.floats(0, 1))
def test_flipped_bytes_lose_only_affected_blocks(
    folder: Path,
    ten_seconds: tuple[bytes, list[Record]],
    share: float,
    bits: int,
    second: float,
) -> None:
    data, what = ten_seconds
    path = folder / "flipped.trexrec"
    damaged = bytearray(data)
    for where in (share, second):
        damaged[int(where * (len(data) - 1))] ^= bits
    path.write_bytes(damaged)
    try:
        header, found, problems = opened(path)
    except RecordingError:
        return
    assert header == HEADER
    assert len(found) >= len(what) - 150
    assert _is_whole_blocks(found, what)
    assert problems or bytes(damaged) == data


@settings(deadline=None)  # files on a disk that others use, too
@given(data=st.binary(max_size=400))
def test_other_file_is_rejected_with_name_and_offset(folder: Path, data: bytes) -> None:
    path = folder / "other.trexrec"
    path.write_bytes(data)
    with pytest.raises(RecordingError, match=r"other\.trexrec, byte"):
        TrexrecFile(path)


def test_lost_block_is_reported_with_its_record_count(
    folder: Path, ten_seconds: tuple[bytes, list[Record]]
) -> None:
    data, _ = ten_seconds
    path = folder / "hurt.trexrec"
    damaged = bytearray(data)
    damaged[len(data) // 2] ^= 1
    path.write_bytes(damaged)
    _, _, problems = opened(path)
    assert len(problems) == 2
    assert "are no whole block" in problems[0]
    assert "1 blocks with 50 records are lost" in problems[1]


def test_newer_file_format_is_rejected(folder: Path) -> None:
    path = folder / "later.trexrec"
    path.write_bytes(PREAMBLE.pack(b"\x89TREXREC", 2))
    with pytest.raises(RecordingError, match="format, 2, is not known"):
        TrexrecFile(path)


def test_unknown_section_is_skipped(folder: Path, ten_seconds: tuple[bytes, list[Record]]) -> None:
    data, what = ten_seconds
    path = folder / "more.trexrec"
    end = data.index(b"DATA")
    path.write_bytes(data[:end] + section(b"NEWS", b"something else") + data[end:])
    _, found, _ = opened(path)
    assert found == what


def test_decompression_bomb_is_not_unpacked(folder: Path) -> None:
    path = folder / "bomb.trexrec"
    write(path, [])
    head = path.read_bytes().split(b"INDX")[0]
    bomb = zlib.compress(bytes(200 << 20), 9)
    path.write_bytes(head + section(b"DATA", bytes(16) + b"\1\0\0\0\xff\xff\0\0" + bomb))
    _, found, problems = opened(path)
    assert found == []
    assert problems


def test_unreadable_path_raises_recording_error(folder: Path) -> None:
    with pytest.raises(RecordingError, match="cannot be opened"):
        TrexrecFile(folder / "none.trexrec")
    with pytest.raises(RecordingError):
        TrexrecFile(folder)


def test_long_texts_are_split_into_several_blocks(folder: Path) -> None:
    path = folder / "words.trexrec"
    what: list[Record] = [Marker(float(n), "NOTE", f"{n}" * 20_000) for n in range(300)]
    write(path, what)
    file = TrexrecFile(path)
    assert read(file) == what
    assert len(file.blocks) > 2
    file.close()
