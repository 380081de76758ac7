import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support.matrix import examples
from trex_gui.devices.aracna.protocol.replies import (
    MAX_MOTORS,
    Hello,
    Led,
    Positions,
    Reader,
    Reply,
    Speeds,
    Unrecognized,
    Version,
    parse_reply,
)

NUMBERS = st.lists(st.integers(-1, 1023), min_size=1, max_size=9).map(tuple)
REPLIES = st.one_of(
    st.just(Hello()),
    st.builds(Version, st.integers(0, 99), st.one_of(st.none(), st.integers(1, MAX_MOTORS))),
    st.builds(Speeds, NUMBERS),
    st.builds(Positions, NUMBERS),
    st.builds(Led, st.booleans()),
)
ENDS = st.sampled_from([b"\r\n", b"\n"])


def written(reply: Reply) -> bytes:
    match reply:
        case Hello():
            return b".h"
        case Version(version, motors):
            return f".q{version}".encode() + (b"" if motors is None else f",{motors}".encode())
        case Speeds(values):
            return b".v" + ",".join(map(str, values)).encode()
        case Positions(values):
            return b".c" + ",".join(map(str, values)).encode()
        case Led(on):
            return b".l1" if on else b".l0"
        case Unrecognized(line):
            return line


def pieces(data: bytes, cuts: list[int]) -> list[bytes]:
    places = sorted({min(cut, len(data)) for cut in cuts})
    return [data[a:b] for a, b in zip([0, *places], [*places, len(data)], strict=True)]


@examples(40)
@given(replies=st.lists(st.tuples(REPLIES, ENDS)), cuts=st.lists(st.integers(0, 400)))
def test_replies_are_read_from_chunks_of_any_size(
    replies: list[tuple[Reply, bytes]], cuts: list[int]
) -> None:
    stream = b"".join(written(reply) + end for reply, end in replies)
    reader = Reader()
    received = [reply for piece in pieces(stream, cuts) for reply in reader.feed(piece)]
    assert received == [reply for reply, _ in replies]


PIECES_OF_LINES = st.sampled_from(
    [b".h", b".c", b".q1,8", b".v5", b",-1", b"\r", b"\n", b"\r\n", b".", b"h", b"520,", b"x" * 150]
)


@examples(40)
@given(
    data=st.one_of(st.binary(max_size=500), st.lists(PIECES_OF_LINES).map(b"".join)),
    cuts=st.lists(st.integers(0, 500)),
)
def test_chunk_size_does_not_change_reading_of_any_bytes(data: bytes, cuts: list[int]) -> None:
    whole, cut = Reader(), Reader()
    at_once = whole.feed(data)
    assert [reply for piece in pieces(data, cuts) for reply in cut.feed(piece)] == at_once
    assert cut.arrived == whole.arrived


def test_invalid_line_is_unrecognized() -> None:
    for line in (
        *(b".q", b".q,8", b".q1,", b".q1,0", b".q01,8", b".q1,8,", b".q 1,8", b".Q1,8", b"q1,8"),
        *(b".v", b".v1,,2", b".v1,2,", b".v-2", b".v+1", b".v01", b".c1.5", b".c520,abc"),
        *(b".l", b".l2", b".h1", b"..h ", b"TReX", b"\x80.q1,8"),
        *(b".c100000", b".c512,1024", b".c99999", b".v1024,0", b".q1,12", b".q1,999"),
    ):
        assert parse_reply(line) == Unrecognized(line)


@pytest.mark.parametrize("tail", [b"h\r\n", b"\r\n", b"\n", b",8\r\n", b"12,-1,5\r\n", b"\xff\n"])
def test_partial_first_line_is_ignored_unless_hello(tail: bytes) -> None:
    reader = Reader()
    assert reader.feed(tail) == [Hello()] * tail.startswith(b"h")
    assert reader.feed(b".q1,8\r\n") == [Version(1, 8)]


def test_hello_is_read_after_truncated_reply() -> None:
    reader = Reader()
    reader.feed(b"\r\n.c520,5")
    assert reader.feed(b".h\r\n") == [Unrecognized(b".c520,5"), Hello()]


def test_position_counts_after_its_comma() -> None:
    reader = Reader()
    arrived = []
    for byte in b".c520,-1,7\r":
        reader.feed(bytes([byte]))
        arrived.append(reader.arrived)
    assert arrived[:3] == [None, (), ()]
    assert arrived[5] == (520,)
    assert arrived[-1] == (520, -1)
    assert reader.feed(b"\n") == [Positions((520, -1, 7))]
    assert reader.arrived is None


def test_other_partial_line_has_no_positions() -> None:
    for rest in (b".q1", b".cx", b".c520,x", b".c520,,", b"c520,", b""):
        reader = Reader()
        reader.feed(rest)
        assert reader.arrived is None, rest


def test_endless_line_uses_bounded_memory() -> None:
    reader = Reader()
    for _ in range(1000):
        reader.feed(b"x" * 1000)
    assert len(reader._rest) <= 200
    reader.feed(b"\n")
    assert reader.feed(b".q1,8\r\n") == [Version(1, 8)]
