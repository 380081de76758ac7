import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support.matrix import examples
from tests.support.talk import Exchange, pieces_of, reports
from trex_gui.core.transport.traffic import TrafficDirection, TrafficEvent
from trex_gui.devices.aracna.session.traffic_decoder import AracnaDecoder

ARACNA: list[tuple[Exchange, str, bool]] = [
    ((b".q\n", b".q1,8\r\n"), "query version and motors → firmware 1, 8 motors", False),
    ((b".q\n", b".q1\n"), "query version and motors → firmware 1", False),
    ((b".q\n", b""), "query version and motors → no reply", True),
    (
        (b".q\n", b".h\r\n"),
        "query version and motors → the robot has started and is busy for a second",
        False,
    ),
    ((b".l1\n", b".l1\r\n"), "switch the debug LED on → the LED is on", False),
    ((b".v1,2\n", b".v1,2\r\n"), "set speeds 1, 2 → speeds 1, 2", False),
    ((b".v1,2\n", b".v1,-1\r\n"), "set speeds 1, 2 → speeds 1, no reply", True),
    ((b".c5,6\n", b".c5,6\r\n"), "go to 5, 6 → at 5, 6", False),
    ((b".c5,6\n", b".c5,"), "go to 5, 6 → incomplete reply", True),
    (
        (b".c5,6\n", b".c5,.h\r\n"),
        (
            "go to 5, 6 → not a reply from an Aracna: .c5,; "
            "the robot has started and is busy for a second"
        ),
        True,
    ),
    ((b".c5,6\n", b".h\r\n"), "go to 5, 6 → the robot has started and is busy for a second", True),
    (
        (b".c5,6\n", b"%!\r\n.c5,6\r\n"),
        "go to 5, 6 → not a reply from an Aracna: %!; at 5, 6",
        True,
    ),
    ((b"hello\n", b""), "not an Aracna command → no reply", True),
    ((b"\n", b""), "end an unfinished line in the robot's buffer", False),
    ((b"", b".h\r\n"), "unsolicited: the robot has started and is busy for a second", False),
    ((b"", b".h"), "unsolicited: incomplete line: .h", True),
]


@pytest.mark.parametrize(
    ("exchange", "text", "is_fault"), ARACNA, ids=lambda value: str(value)[:40]
)
def test_exchange_is_decoded_as_text(exchange: Exchange, text: str, is_fault: bool) -> None:
    assert reports(AracnaDecoder(), pieces_of([exchange])) == [(text, is_fault)]


@examples(40)
@given(st.lists(st.sampled_from(ARACNA), max_size=8), st.integers(1, 5))
def test_chunk_size_does_not_change_decoded_rows(
    cases: list[tuple[Exchange, str, bool]], size: int
) -> None:
    exchanges = [exchange for exchange, _, _ in cases if exchange[0]]
    whole = reports(AracnaDecoder(), pieces_of(exchanges))
    assert reports(AracnaDecoder(), pieces_of(exchanges, size)) == whole


def test_only_positions_may_move_a_motor() -> None:
    decoder = AracnaDecoder()
    assert decoder.may_move(b".v1,2\n.c1,2\n")
    assert not decoder.may_move(b".q\n.v1,2\n")


def test_only_version_query_is_routine() -> None:
    decoder = AracnaDecoder()
    assert decoder.is_routine(b".q\n")
    assert not any(map(decoder.is_routine, [b".c1,2\n", b".v1,2\n", b"\n", b".l1\n"]))


def test_late_reply_is_shown_with_its_command() -> None:
    decoder = AracnaDecoder()
    pieces = [
        TrafficEvent(1.0, TrafficDirection.SENT, b".c5,6\n"),
        TrafficEvent(2.0, TrafficDirection.RECEIVED, b".c5,"),
        TrafficEvent(4.0, TrafficDirection.SENT, b".q\n"),
        TrafficEvent(9.0, TrafficDirection.SENT, b".q\n"),
        TrafficEvent(9.5, TrafficDirection.RECEIVED, b"6\r\n"),
        TrafficEvent(9.6, TrafficDirection.RECEIVED, b".q1,2\r\n"),
        TrafficEvent(11.0, TrafficDirection.SENT, b".q\n"),
    ]
    first, second = reports(decoder, pieces)
    assert first == (
        "go to 5, 6, then query whether the robot is free → at 5, 6; firmware 1, 2 motors",
        False,
    )
    assert second[0].startswith("query version")


def test_bytes_after_reply_are_a_fault() -> None:
    pieces = pieces_of([(b".q\n", b".q1,8\r\n.c")])
    ((text, is_fault),) = reports(AracnaDecoder(), pieces)
    assert is_fault
    assert text.endswith("firmware 1, 8 motors; followed by .c")


def test_command_without_its_own_reply_is_a_fault() -> None:
    pieces = [
        TrafficEvent(1.0, TrafficDirection.SENT, b".c5,6\n"),
        TrafficEvent(4.0, TrafficDirection.SENT, b".q\n"),
        TrafficEvent(4.1, TrafficDirection.RECEIVED, b".q1,2\r\n"),
        TrafficEvent(5.0, TrafficDirection.LINE, text="Closed."),
    ]
    ((text, is_fault),) = reports(AracnaDecoder(), pieces)
    assert is_fault
    assert text.endswith("firmware 1, 2 motors; no reply to the command itself")


@given(st.binary(max_size=40))
def test_shown_bytes_are_read_back_equal(data: bytes) -> None:
    decoder = AracnaDecoder()
    assert decoder.bytes_of(decoder.display_text(data)) == data
