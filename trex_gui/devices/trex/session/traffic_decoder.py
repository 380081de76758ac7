"""What the bytes between a host and a TReX mean, for a transcript."""

from functools import lru_cache

from trex_gui.core.transport.settings import PortSettings
from trex_gui.core.transport.traffic import Decoded, Decoder, Transaction
from trex_gui.devices.trex.protocol.commands import Command, Signature
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.descriptions import describe, describe_reply, is_refusal
from trex_gui.devices.trex.protocol.framing import (
    EXPANDED_START,
    Framing,
    Malformed,
    NeedData,
    Packet,
    PacketParser,
    Reply,
    ReplyParser,
)

_POLLED = frozenset(range(0x82, 0x90)) | {0xFF}
"""Command bytes that a session repeats by itself: what changes while a board runs, and nothing."""


class TrexDecoder(Decoder):
    """Words for both sub-protocols, with and without CRC and echo.

    Attributes:
        board: which board answers, once that is known: its units and its parameters.
    """

    def __init__(self) -> None:
        self.board: Signature | None = None

    def shown(self, data: bytes) -> str:
        """Hexadecimal, as the documentation writes packets."""
        return data.hex(" ").upper()

    def is_routine(self, sent: bytes) -> bool:
        """What is polled, in either sub-protocol."""
        if sent[0] == EXPANDED_START:
            return len(sent) > 2 and sent[2] | 0x80 in _POLLED
        return sent[0] in _POLLED

    def is_whole(self, transaction: Transaction) -> bool:
        """Whether the reply has its size, behind its echo if there is one."""
        if not transaction.sent:
            return False
        packet = _packets(transaction.sent, _polynomial(transaction.settings))[-1]
        return isinstance(packet, Packet) and not isinstance(_reply(packet, transaction), NeedData)

    def read(self, transaction: Transaction) -> Decoded:
        """Say the packet, and what was answered or what is wrong with that."""
        if not transaction.sent:
            return Decoded("unsolicited bytes", is_fault=True)
        packets = _packets(transaction.sent, _polynomial(transaction.settings))
        said = "; ".join(map(self._said, packets))
        packet = packets[-1]
        if isinstance(packet, Malformed):
            return Decoded(said)
        match _reply(packet, transaction):
            case Reply(value=value):
                answer = describe_reply(packet.command, value, self.board)
                return Decoded(f"{said} → {answer}" if answer else said, is_refusal(value))
            case Malformed() if not packet.command.reply_size():
                text = "unsolicited bytes; perhaps a late reply"
                return Decoded(f"{said} → {text}", is_fault=True)
            case Malformed(reason=reason):
                return Decoded(f"{said} → damaged: {reason}", is_fault=True)
            case _ if not transaction.is_over:
                return Decoded(said)
        if not transaction.received:
            return Decoded(f"{said} → no answer", is_fault=True)
        if transaction.received == transaction.sent:
            return Decoded(f"{said} → only its echo came back", is_fault=True)
        return Decoded(f"{said} → the answer is not complete", is_fault=True)

    def _said(self, packet: Packet | Malformed) -> str:
        if isinstance(packet, Malformed):
            return f"no packet of a TReX: {packet.reason}"
        said = describe(packet.command, self.board)
        if packet.device_number is None:
            return said
        return f"device {packet.device_number}: {said}"


@lru_cache(maxsize=256)  # the same few questions all the time
def _packets(sent: bytes, polynomial: int | None) -> tuple[Packet | Malformed, ...]:
    parser = PacketParser(polynomial)
    return (*parser.feed(sent), *parser.flush())


def _reply(packet: Packet, transaction: Transaction) -> Reply[object] | NeedData | Malformed:
    """Parse the received bytes; if an echo is unknown, their length shows whether there is one."""
    framing = Framing(packet.device_number, _polynomial(transaction.settings))
    if transaction.echo is not None:
        return _parsed(packet.command, framing, transaction.received, echo=transaction.echo)
    plain = _parsed(packet.command, framing, transaction.received, echo=False)
    has_echo = transaction.received[: len(packet.raw)] == packet.raw[: len(transaction.received)]
    if isinstance(plain, Reply) or not has_echo:
        return plain
    return _parsed(packet.command, framing, transaction.received, echo=True)


def _parsed(
    command: Command[object], framing: Framing, received: bytes, *, echo: bool
) -> Reply[object] | NeedData | Malformed:
    return ReplyParser(command, framing, echo).feed(received)


def _polynomial(settings: PortSettings | None) -> int | None:
    return settings.framing.polynomial if isinstance(settings, ConnectionSettings) else None
