"""Bytes on a line, and the rows of their transcript."""

from collections.abc import Iterable

from trex_gui.core.transport.traffic import (
    Decoder,
    TrafficDirection,
    TrafficEvent,
    Transaction,
    TransactionAssembler,
)
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings

Said = tuple[bytes, bytes]
"""Sent bytes and their reply."""


def pieces_of(
    talk: Iterable[Said], cut: int = 0, settings: ConnectionSettings | None = None
) -> list[TrafficEvent]:
    """Return the bytes of a line, with replies in pieces of `cut` bytes."""
    now = 0.0
    pieces = [TrafficEvent(now, TrafficDirection.LINE, text="Opened.", settings=settings)]
    for sent, received in talk:
        now += 0.001
        if sent:
            pieces.append(TrafficEvent(now, TrafficDirection.SENT, sent))
        size = cut or max(len(received), 1)
        for at in range(0, len(received), size):
            now += 0.002
            pieces.append(TrafficEvent(now, TrafficDirection.RECEIVED, received[at : at + size]))
    return [*pieces, TrafficEvent(now + 1, TrafficDirection.LINE, text="Closed.")]


def rows_of(decoder: Decoder, pieces: list[TrafficEvent]) -> list[Transaction]:
    """Return the rows with bytes."""
    return [row for row in TransactionAssembler(decoder).feed(pieces) if not row.note]


def reports(decoder: Decoder, pieces: list[TrafficEvent]) -> list[tuple[str, bool]]:
    """Return the meanings of the rows, and their faults."""
    words = [decoder.decoded(row) for row in rows_of(decoder, pieces)]
    return [(one.text, one.is_fault) for one in words]
