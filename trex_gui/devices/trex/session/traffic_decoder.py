"""Decoder of TReX packets and replies for the traffic log."""

from functools import lru_cache

from trex_gui.core.texts import hex_text
from trex_gui.core.translation import tr
from trex_gui.core.transport.settings import PortSettings
from trex_gui.core.transport.traffic import Decoded, Decoder, Transaction
from trex_gui.devices.trex.protocol.commands import GetParameter, Signature
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.descriptions import describe_reply, is_refusal
from trex_gui.devices.trex.protocol.framing import (
    EXPANDED_START,
    Framing,
    Malformed,
    NeedData,
    Packet,
    Reply,
    ReplyParser,
)
from trex_gui.devices.trex.protocol.parameters import parameter_number
from trex_gui.devices.trex.protocol.raw_packets import may_move, packets_of
from trex_gui.devices.trex.session.polling import SAFETY_PARAMETERS

_POLLED = frozenset(range(0x82, 0x90)) | {0xFF}  # queries of polled values, and the null command


class TrexDecoder(Decoder):
    def __init__(self) -> None:
        self.board: Signature | None = None  # determines units and parameters; `None` if unknown

    def display_text(self, data: bytes) -> str:
        return hex_text(data)

    def bytes_of(self, text: str) -> bytes:
        return bytes.fromhex(text)

    def learn(self, transaction: Transaction) -> None:
        match last_exchange(transaction):
            case _, Reply(value=Signature() as board):
                self.board = board

    def is_routine(self, sent: bytes) -> bool:
        command, data = sent[0], sent[1:]
        if command == EXPANDED_START:
            if len(sent) < 3:
                return False
            command, data = sent[2] | 0x80, sent[3:]
        if command in GetParameter.opcodes and data:
            return data[0] in map(parameter_number, SAFETY_PARAMETERS)
        return command in _POLLED

    def may_move(self, sent: bytes) -> bool:
        return may_move(sent)

    def is_whole(self, transaction: Transaction) -> bool:
        if not transaction.sent:
            return False
        _, reply = last_exchange(transaction)
        return reply is not None and not isinstance(reply, NeedData)

    def is_fault(self, transaction: Transaction) -> bool:
        if not transaction.sent:
            return not transaction.note
        match last_exchange(transaction)[1]:
            case Reply(value=value):
                return is_refusal(value)
            case Malformed():
                return True
            case NeedData():
                return transaction.is_over
            case None:
                return False

    def read(self, transaction: Transaction) -> Decoded:
        return Decoded(self._text(transaction), self.is_fault(transaction))

    def _text(self, transaction: Transaction) -> str:
        if not transaction.sent:
            return tr("unsolicited bytes")
        packets = _packets(transaction.sent, _polynomial(transaction.settings))
        request = "; ".join(packet.description(self.board) for packet in packets)
        packet = packets[-1].packet
        if isinstance(packet, Malformed):
            return request
        match _reply(packet, transaction):
            case Reply(value=value):
                reply = describe_reply(packet.command, value, self.board)
                return f"{request} → {reply}" if reply else request
            case Malformed() if not packet.command.reply_size():
                fault = tr("unsolicited bytes; perhaps a late reply")
            case Malformed(reason=reason):
                fault = tr("corrupted: {0}").format(reason)
            case _ if not transaction.is_over:
                return request
            case _ if not transaction.received:
                fault = tr("no reply")
            case _ if transaction.received == transaction.sent:
                fault = tr("only the echo came back")
            case _:
                fault = tr("incomplete reply")
        return f"{request} → {fault}"


_packets = lru_cache(maxsize=256)(packets_of)  # polling repeats the same few packets


def last_exchange(
    transaction: Transaction,
) -> tuple[Packet | Malformed | None, Reply[object] | NeedData | Malformed | None]:
    """Return the last sent packet and its reply. Either is `None` if missing."""
    if not transaction.sent:
        return None, None
    packet = _packets(transaction.sent, _polynomial(transaction.settings))[-1].packet
    return packet, None if isinstance(packet, Malformed) else _reply(packet, transaction)


def _reply(packet: Packet, transaction: Transaction) -> Reply[object] | NeedData | Malformed:
    framing = Framing(packet.device_number, _polynomial(transaction.settings))
    received, echo = transaction.received, transaction.echo
    if echo is not None:
        return ReplyParser(packet.command, framing, echo).feed(received)
    plain = ReplyParser(packet.command, framing, False).feed(received)
    has_echo = received[: len(packet.raw)] == packet.raw[: len(received)]
    if isinstance(plain, Reply) or not has_echo:
        return plain
    return ReplyParser(packet.command, framing, True).feed(received)


def _polynomial(settings: PortSettings | None) -> int | None:
    return settings.framing.polynomial if isinstance(settings, ConnectionSettings) else None
