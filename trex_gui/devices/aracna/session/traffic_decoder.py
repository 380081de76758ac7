"""Decoder of Aracna lines for the traffic log."""

from trex_gui.core.translation import tr, tr_noop
from trex_gui.core.transport.traffic import Decoded, Decoder, Transaction
from trex_gui.devices.aracna.protocol.replies import (
    REPLY_TYPES,
    UNREADABLE,
    Hello,
    Led,
    Positions,
    Reply,
    Speeds,
    Unrecognized,
    Version,
    parse_replies,
)

_COMMANDS = {
    b".q": tr_noop("query version and motors"),
    b".l1": tr_noop("switch the debug LED on"),
    b".l0": tr_noop("switch the debug LED off"),
    b"": tr_noop("end an unfinished line in the robot's buffer"),
}


class AracnaDecoder(Decoder):
    def display_text(self, data: bytes) -> str:
        r"""Return text with escapes such as `\n` and `\x00`."""
        return data.decode("latin-1").encode("unicode_escape").decode("ascii")

    def bytes_of(self, text: str) -> bytes:
        return text.encode("ascii").decode("unicode_escape").encode("latin-1")

    def is_routine(self, sent: bytes) -> bool:
        return sent == b".q\n"

    def may_move(self, sent: bytes) -> bool:
        """Return True if a line sets positions. The robot ignores a line's first character."""
        return any(line[1:2] == b"c" for line in sent.split(b"\n"))

    def is_whole(self, transaction: Transaction) -> bool:
        """Return True after a restart, or after a reply to the last command."""
        lines = transaction.received.split(b"\n")[:-1]
        if not transaction.sent:
            return bool(lines)
        last = transaction.sent.rstrip(b"\n").rpartition(b"\n")[2][:2]
        return any(line.startswith((last, b".h")) for line in lines)

    def goes_with(self, transaction: Transaction, sent: bytes) -> bool:
        """Return True for a query that follows an unanswered command."""
        is_late = transaction.sent[:2] in {b".c", b".v", b".l"} and not self.is_whole(transaction)
        return sent == b".q\n" and is_late

    def read(self, transaction: Transaction) -> Decoded:
        *lines, rest = transaction.received.split(b"\n")
        replies = [reply for line in lines for reply in parse_replies(line.removesuffix(b"\r"))]
        is_fault = any(map(_is_fault, replies))
        texts = [self._reply(reply) for reply in replies]
        if not transaction.sent:
            texts += [tr("incomplete line: {0}").format(self.display_text(rest))] if rest else []
            return Decoded(tr("unsolicited: {0}").format("; ".join(texts)), is_fault or bool(rest))
        command = _command(transaction.sent)
        if not self.is_whole(transaction) and transaction.sent.strip():
            if not transaction.is_over:
                return Decoded(" → ".join([command, *texts]))
            texts.append(tr("incomplete reply") if rest else tr("no reply"))
            is_fault = True
        elif transaction.sent.strip() and not any(
            _answers(reply, transaction.sent) for reply in replies
        ):
            texts.append(tr("no reply to the command itself"))
            is_fault = True
        elif rest:
            texts.append(tr("followed by {0}").format(self.display_text(rest)))
            is_fault = True
        is_fault |= transaction.sent[:2] != b".q" and Hello() in replies
        return Decoded(f"{command} → {'; '.join(texts)}" if texts else command, is_fault)

    def _reply(self, reply: Reply) -> str:
        match reply:
            case Hello():
                return tr("the robot has started and is busy for a second")
            case Version(version=version, motors=int(motors)):
                count = tr("1 motor") if motors == 1 else tr("{0} motors").format(motors)
                return tr("firmware {0}, {1}").format(version, count)
            case Version(version=version):
                return tr("firmware {0}").format(version)
            case Speeds(values=values):
                return tr("speeds {0}").format(_values(values))
            case Positions(values=values):
                return tr("at {0}").format(_values(values))
            case Led(on=on):
                return tr("the LED is on") if on else tr("the LED is off")
            case Unrecognized(line=line):
                return tr("not a reply from an Aracna: {0}").format(self.display_text(line))


def _answers(reply: Reply, sent: bytes) -> bool:
    """Return True if a reply answers a command or reports a restart."""
    kind = REPLY_TYPES.get(sent[1:2].decode("latin-1"))
    return kind is None or isinstance(reply, kind | Hello)


def _command(sent: bytes) -> str:
    line, _, rest = sent.partition(b"\n")
    if rest:
        return tr("{0}, then query whether the robot is free").format(_command(line))
    if (text := _COMMANDS.get(line)) is not None:
        return tr(text)
    values = line[2:].decode("latin-1").replace(",", ", ")
    match line[:2]:
        case b".c":
            return tr("go to {0}").format(values)
        case b".v":
            return tr("set speeds {0}").format(values)
    return tr("not an Aracna command")


def _is_fault(reply: Reply) -> bool:
    match reply:
        case Unrecognized():
            return True
        case Positions(values=values) | Speeds(values=values):
            return UNREADABLE in values
    return False


def _values(values: tuple[int, ...]) -> str:
    return ", ".join(tr("no reply") if value == UNREADABLE else str(value) for value in values)
