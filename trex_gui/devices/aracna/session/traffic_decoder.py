"""What the lines between a host and an Aracna mean, for a transcript."""

from trex_gui.core.transport.transactions import Decoded, Decoder, Transaction
from trex_gui.devices.aracna.protocol.replies import (
    Hello,
    Led,
    Positions,
    Reply,
    Speeds,
    Strange,
    Version,
    read_line,
)

_ASKED = {
    b".q": "ask for version and motors",
    b".l1": "switch the debug LED on",
    b".l0": "switch the debug LED off",
    b"": "end what may stand in the robot's line buffer",
}
_UNREAD = -1
_ANSWERED_LATE = frozenset({b".c", b".v", b".l"})


class AracnaDecoder(Decoder):
    """Words for what `protocol.lines` sends and what `protocol.replies` reads."""

    def shown(self, data: bytes) -> str:
        r"""Text; line ends as `\r` and `\n`, and what is no text as `\x00`."""
        return _shown(data)

    def is_routine(self, sent: bytes) -> bool:
        """The question by which the session sees that the robot is there."""
        return sent == b".q\n"

    def is_whole(self, exchange: Transaction) -> bool:
        """Whether a line of the command's own has come, or the robot has started anew."""
        lines = exchange.received.split(b"\n")[:-1]
        if not exchange.sent:
            return bool(lines)
        last = exchange.sent.rstrip(b"\n").rpartition(b"\n")[2][:2]
        return any(line.startswith((last, b".h")) for line in lines)

    def goes_with(self, exchange: Transaction, sent: bytes) -> bool:
        """Whether it asks if the robot is free again, behind a command that it has not answered.

        A late answer to that command comes before the one to the question.
        """
        is_late = exchange.sent[:2] in _ANSWERED_LATE and not self.is_whole(exchange)
        return sent == b".q\n" and is_late

    def read(self, exchange: Transaction) -> Decoded:
        """Say the command, and each line that came."""
        *lines, rest = exchange.received.split(b"\n")
        replies = [reply for line in lines for reply in _replies(line.removesuffix(b"\r"))]
        is_fault = any(map(_is_fault, replies))
        said = [_said(reply) for reply in replies]
        if not exchange.sent:
            said += [f"a line that broke off: {self.shown(rest)}"] if rest else []
            return Decoded("unasked: " + "; ".join(said), is_fault or bool(rest))
        asked = _asked(exchange.sent)
        if not self.is_whole(exchange) and exchange.sent.strip():
            if not exchange.is_over:
                return Decoded(" → ".join([asked, *said]))
            said.append("the answer broke off" if rest else "no answer")
            is_fault = True
        elif exchange.sent.strip() and not any(_is_of(one, exchange.sent[:2]) for one in replies):
            said.append("no answer to the command itself")
            is_fault = True
        elif rest:
            said.append(f"and behind it {self.shown(rest)}")
            is_fault = True
        is_fault |= exchange.sent[:2] != b".q" and Hello() in replies
        return Decoded(f"{asked} → {'; '.join(said)}" if said else asked, is_fault)


def _replies(line: bytes) -> list[Reply]:
    """Read a line; a restart leaves the line before it without an end."""
    if not line:
        return []
    reply = read_line(line)
    if isinstance(reply, Strange) and line.endswith(b".h"):
        return [Strange(line[:-2]), Hello()]
    return [reply]


def _shown(data: bytes) -> str:
    return data.decode("latin-1").encode("unicode_escape").decode("ascii")


def _is_of(reply: Reply, letter: bytes) -> bool:
    """Whether a reply is one to a command of this letter, or voids it; an empty line has none."""
    kinds: dict[bytes, type[Reply]] = {b".q": Version, b".c": Positions, b".v": Speeds, b".l": Led}
    kind = kinds.get(letter)
    return kind is None or isinstance(reply, kind | Hello)


def _asked(sent: bytes) -> str:
    line, _, behind = sent.partition(b"\n")
    if behind:
        return f"{_asked(line)}, then ask whether it is free"
    if (text := _ASKED.get(line)) is not None:
        return text
    values = line[2:].decode("latin-1").replace(",", ", ")
    match line[:2]:
        case b".c":
            return f"go to {values}"
        case b".v":
            return f"set speeds {values}"
    return "no command of an Aracna"


def _is_fault(reply: Reply) -> bool:
    match reply:
        case Strange():
            return True
        case Positions(values=values) | Speeds(values=values):
            return _UNREAD in values
    return False


def _said(reply: Reply) -> str:
    match reply:
        case Hello():
            return "the robot has started, and is deaf for a second"
        case Version(version=version, motors=None):
            return f"firmware {version}"
        case Version(version=version, motors=motors):
            return f"firmware {version}, {motors} motors"
        case Speeds(values=values):
            return f"speeds {_values(values)}"
        case Positions(values=values):
            return f"at {_values(values)}"
        case Led(on=on):
            return f"the LED is {'on' if on else 'off'}"
        case Strange(line=line):
            return (
                f"no reply of an Aracna: {line.decode('latin-1').encode('unicode_escape').decode()}"
            )


def _values(values: tuple[int, ...]) -> str:
    return ", ".join("no answer" if value == _UNREAD else str(value) for value in values)
