"""Bytes on a line and their transcript."""

from collections.abc import Iterable

from trex_gui.core.transport.traffic import (
    Decoder,
    TrafficDirection,
    TrafficEvent,
    Transaction,
    TransactionAssembler,
)
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings

Exchange = tuple[bytes, bytes]
"""Sent bytes and their reply."""


def pieces_of(
    exchanges: Iterable[Exchange], piece: int = 0, settings: ConnectionSettings | None = None
) -> list[TrafficEvent]:
    """Return the traffic of a line. Replies arrive in pieces of `piece` bytes, or whole."""
    now = 0.0
    pieces = [TrafficEvent(now, TrafficDirection.LINE, text="Opened.", settings=settings)]
    for sent, received in exchanges:
        now += 0.001
        if sent:
            pieces.append(TrafficEvent(now, TrafficDirection.SENT, sent))
        size = piece or max(len(received), 1)
        for at in range(0, len(received), size):
            now += 0.002
            pieces.append(TrafficEvent(now, TrafficDirection.RECEIVED, received[at : at + size]))
    return [*pieces, TrafficEvent(now + 1, TrafficDirection.LINE, text="Closed.")]


def rows_of(decoder: Decoder, pieces: list[TrafficEvent]) -> list[Transaction]:
    """Return the transcript's rows with bytes."""
    return [row for row in TransactionAssembler(decoder).feed(pieces) if not row.note]


def reports(decoder: Decoder, pieces: list[TrafficEvent]) -> list[tuple[str, bool]]:
    """Return the meaning of each row, and whether the row is a fault."""
    meanings = [decoder.decoded(row) for row in rows_of(decoder, pieces)]
    return [(meaning.text, meaning.is_fault) for meaning in meanings]
