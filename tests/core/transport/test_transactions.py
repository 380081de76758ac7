"""Transactions: pairs of a request and its reply."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support.matrix import examples
from tests.support.talk import Exchange, pieces_of, reports, rows_of
from trex_gui.core.transport.traffic import (
    Decoded,
    TrafficDirection,
    TrafficEvent,
    Transaction,
    TransactionAssembler,
)
from trex_gui.devices.trex.protocol.commands import (
    Command,
    GetMode,
    GetSignature,
    SetParameter,
    Signature,
)
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.framing import Framing, crc7
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.session.traffic_decoder import TrexDecoder

CRC = ConnectionSettings("virtual", line=LineSettings(19200, Detection.CRC7))

TREX: list[tuple[Exchange, str, bool]] = [
    ((b"\x81", b"TReX1.2"), "get signature → TReX 1.2", False),
    ((b"\x81", b"\x81TReX1.2"), "get signature → TReX 1.2", False),
    ((b"\x82", b"r"), "get mode → serial mode, RC inputs", False),
    ((b"\x82", b""), "get mode → no reply", True),
    ((b"\x82", b"\x82"), "get mode → only the echo came back", True),
    ((b"\x81", b"TReX"), "get signature → incomplete reply", True),
    ((b"\x84", b"\x00"), "get and clear status bits → none", False),
    ((b"\x84", b"\x10"), "get and clear status bits → Motor 1 fault", False),
    ((b"\x85", b"\x80"), "get and clear UART error bits → Serial timeout", False),
    (
        (b"\x86\x1f", bytes(8) + b"\xff\xff"),
        "get raw inputs of all channels → 1: 0, 2: 0, 3: 0, 4: 0, 5: no signal",
        False,
    ),
    ((b"\x87\x01", b"\xff"), "get remapped inputs of channel 1 → 1: -127", False),
    (
        (b"\x8f", b"\x02\x00"),
        "get currents of both motors → motor 1: 2 counts, motor 2: 0 counts",
        False,
    ),
    ((b"\x9f\x07", b"\x0f"), "get Serial Timeout → 1.5 s (15)", False),
    ((b"\xaf\x07\x0f\x55\x2a", b"\x00"), "set Serial Timeout to 1.5 s (15) → stored", False),
    (
        (b"\xaf\x07\x0f\x55\x2a", b"\x02"),
        "set Serial Timeout to 1.5 s (15) → rejected: this value is not allowed (code 2)",
        True,
    ),
    ((b"\xc2\x50", b""), "set motor 1 to forward 80", False),
    ((b"\xc2\x50", b"\xc2\x50"), "set motor 1 to forward 80", False),
    (
        (b"\xc2\x50", b"\x07"),
        "set motor 1 to forward 80 → unsolicited bytes; perhaps a late reply",
        True,
    ),
    ((b"\x80\x09\x02", b"R"), "device 9: get mode → RC mode", False),
    ((b"\xff", b""), "null command (no effect)", False),
    ((b"\x12", b""), "not a TReX packet: a data byte outside a packet", False),
    ((b"\xc2\x00\xca\x00", b""), "set motor 1 to forward 0; set motor 2 to forward 0", False),
    ((b"\xc2\x00\x82", b"r"), "set motor 1 to forward 0; get mode → serial mode, RC inputs", False),
    ((b"", b"\x55\x55"), "unsolicited bytes", True),
]


@pytest.mark.parametrize(("exchange", "text", "is_fault"), TREX, ids=lambda value: str(value)[:40])
def test_trex_exchange_is_decoded(exchange: Exchange, text: str, is_fault: bool) -> None:
    assert reports(TrexDecoder(), pieces_of([exchange])) == [(text, is_fault)]


@examples(40)
@given(st.lists(st.sampled_from(TREX), max_size=8), st.integers(1, 3))
def test_fragmented_bytes_decode_to_same_rows(
    cases: list[tuple[Exchange, str, bool]], size: int
) -> None:
    # Bytes after a complete reply start their own row, at any chunk boundary.
    exchanges = [exchange for exchange, _, is_fault in cases if exchange[0] and not is_fault]
    whole = reports(TrexDecoder(), pieces_of(exchanges))
    assert reports(TrexDecoder(), pieces_of(exchanges, size)) == whole
    assert len(whole) == len(exchanges)


def test_every_byte_appears_in_exactly_one_row() -> None:
    exchanges = [exchange for exchange, _, _ in TREX]
    rows = rows_of(TrexDecoder(), pieces_of(exchanges, 1))
    assert b"".join(row.sent for row in rows) == b"".join(sent for sent, _ in exchanges)
    assert b"".join(row.received for row in rows) == b"".join(reply for _, reply in exchanges)


@pytest.mark.parametrize("command", [GetSignature(), GetMode(), SetParameter(7, 15)], ids=str)
@pytest.mark.parametrize("number", [None, 7])
def test_reply_with_wrong_crc_is_decoded_as_fault(
    command: Command[object], number: int | None
) -> None:
    sent = Framing(number, CRC.polynomial).encode(command)
    reply = {GetSignature: b"TReX1.2", GetMode: b"r", SetParameter: b"\x00"}[type(command)]
    good = reply + bytes([crc7(reply, CRC.polynomial)])
    ((_, is_fault),) = reports(TrexDecoder(), pieces_of([(sent, good)], settings=CRC))
    assert not is_fault
    bad = reply + bytes([good[-1] ^ 1])
    ((text, is_fault),) = reports(TrexDecoder(), pieces_of([(sent, bad)], settings=CRC))
    assert is_fault
    assert "the CRC is" in text


def test_late_bytes_are_assigned_to_their_request() -> None:
    assembler = TransactionAssembler(TrexDecoder())
    assembler.feed(
        [
            TrafficEvent(1.0, TrafficDirection.SENT, b"\x81"),
            TrafficEvent(1.1, TrafficDirection.RECEIVED, b"TRe"),
        ]
    )
    (row,) = assembler.feed([TrafficEvent(1.4, TrafficDirection.RECEIVED, b"X1.2")])
    assert row.received == b"TReX1.2"
    assert row.seconds == pytest.approx(0.4)


def test_decoded_units_are_those_of_board_model() -> None:
    decoder = TrexDecoder()
    junior = device_table().model("trexjr")
    decoder.board = Signature(junior, "1.2")
    ((text, _),) = reports(decoder, pieces_of([(b"\x8f", b"\x0a\x00")]))
    assert f"motor 1: {10 * junior.current_unit:.2f} A" in text


def test_polls_are_distinguished_from_user_requests() -> None:
    polled = [b"\x82", b"\x86\x1f", b"\x8f", b"\xff", b"\x80\x07\x04"]
    polled += [b"\x9f\x07", b"\x80\x07\x1f\x08"]  # serial timeout, shutdown on UART errors
    requested = [b"\x81", b"\x9f\x0e", b"\xc2\x00", b"\xaf\x07\x0f\x55\x2a", b"\x80\x07\x42\x00"]
    assert all(map(TrexDecoder().is_routine, polled))
    assert not any(map(TrexDecoder().is_routine, requested))


@pytest.mark.parametrize("sent", [b"\x84", b"\x85", b"\x8d"])
def test_echo_does_not_count_as_reply(sent: bytes) -> None:
    assembler = TransactionAssembler(TrexDecoder())
    assembler.settings, assembler.echo = ConnectionSettings("virtual"), True
    (row,) = assembler.feed(
        [
            TrafficEvent(1.0, TrafficDirection.SENT, sent),
            TrafficEvent(1.1, TrafficDirection.RECEIVED, sent),
        ]
    )
    row.is_over = True
    words = TrexDecoder().decoded(row)
    assert words.is_fault
    assert words.text.endswith("only the echo came back")
    whole = [
        TrafficEvent(2.0, TrafficDirection.SENT, sent),
        TrafficEvent(2.1, TrafficDirection.RECEIVED, sent),
        TrafficEvent(2.2, TrafficDirection.RECEIVED, b"\0"),
    ]
    assert assembler.feed(whole)[-1].received == sent + b"\0"


def test_row_is_decoded_while_another_thread_clears_the_cache() -> None:
    class ClearedTransaction(Transaction):
        """Row whose cached meaning is cleared after each read."""

        def __getattribute__(self, name: str) -> object:
            value = super().__getattribute__(name)
            if name == "cached_meaning":
                self.cached_meaning = None
            return value

    row = ClearedTransaction(1, 0.0, note="The line was opened.", is_over=True)
    row.cached_meaning = Decoded("cached")
    assert TrexDecoder().decoded(row) == Decoded("cached")
    assert TrexDecoder().decoded(row) == Decoded("The line was opened.")
