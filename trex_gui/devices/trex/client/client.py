"""Transactions: one command out, its whole reply in, before anything else is sent.

A TReX is deaf while it answers, so there is never a second request in flight. Deadlines come
from the bytes on the wire and from what the board needs, not from a flat second.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Protocol

from trex_gui.core.errors import BadReply, NoReply, StudioError
from trex_gui.core.transport.serial_port import Transport
from trex_gui.devices.trex.protocol.commands import (
    Command,
    GetParameter,
    Null,
    ReplyT_co,
    SetParameter,
)
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import (
    ErrorCode,
    ResultCode,
    TrexBadReplyError,
    TrexNoReplyError,
)
from trex_gui.devices.trex.protocol.framing import Framing, Malformed, NeedData, Reply, ReplyParser
from trex_gui.devices.trex.protocol.parameters import ParameterKey, parameter_number

_BOARD_DELAY = 0.005
"""Seconds a board may think about a query: its 1 ms response delay and its 10 ms cycle halved.

Inferred: no source gives more than the response delay.
"""

_LONGEST_REPLY = 16
"""Bytes: the ten of five raw channels, a CRC and the echo of the question."""

_NULL = Framing().encode(Null())

_ECHO_PROBES = 2
"""How often an echo is looked for: one damaged byte must not hide it."""


class Requester(Protocol):
    """Runs transactions: a client, or a session that serves a stop in between."""

    def __call__(self, command: Command[ReplyT_co]) -> ReplyT_co:
        """Run one transaction and return its reply."""
        ...


@dataclass(slots=True)
class Counters:
    """Statistics since the line was opened.

    Attributes:
        requests: transactions begun.
        silences: missing or incomplete replies.
        damaged: corrupted replies.
        stale: unsolicited bytes, discarded.
        slowest: the longest round trip that succeeded, in seconds.
        answers: replies that came whole.
    """

    requests: int = 0
    silences: int = 0
    damaged: int = 0
    stale: int = 0
    slowest: float = 0.0
    answers: int = 0


class TrexClient:
    """Runs transactions on one line.

    Attributes:
        echo: whether everything sent comes back, as it does on the board's RS-232 side.
        keepalive_while_waiting: whether to send a null command while a late reply is awaited, to
            keep the board's serial timeout from stopping motors that are driven.
    """

    def __init__(
        self, transport: Transport, settings: ConnectionSettings, *, echo: bool = False
    ) -> None:
        self.echo = echo
        self.keepalive_while_waiting = False
        self.counters = Counters()
        self._transport = transport
        self._settings = settings
        self._framing = settings.framing
        self._free_at = transport.clock()
        self._is_unanswered = False
        self._unanswered = 0  # missing replies since one was surely matched to its request

    @property
    def settings(self) -> ConnectionSettings:
        """How the line was opened."""
        return self._settings

    @property
    def transport(self) -> Transport:
        """The line."""
        return self._transport

    def request(self, command: Command[ReplyT_co]) -> ReplyT_co:
        """Send a command and return its parsed reply.

        A motor command has no reply: it returns at once, and the next request waits until
        its bytes have left.

        Raises:
            BadRequest: a value does not fit; nothing was sent.
            NoReply: not everything came in time.
            BadReply: the bytes are no reply to this command.
            PortUnavailable: the line is gone.
        """
        try:
            reply = self._transact(command)
        except (NoReply, BadReply):
            if (number := self._new_number(command)) is not None:
                self._look_for(number)
            raise
        if reply is ResultCode.OK and (number := self._new_number(command)) is not None:
            self._address(number)
        return reply

    def _transact(self, command: Command[ReplyT_co]) -> ReplyT_co:
        packet = self._framing.encode(command)
        line = self._settings.line
        parser = ReplyParser(command, self._framing, self.echo)
        self.drain()
        stale = self._drain_late_reply() + self._transport.discard()
        self.counters.requests += 1
        self.counters.stale += len(stale)
        begun = self._transport.clock()
        self._transport.write(packet)
        self._free_at = begun + line.seconds(len(packet))
        # What is queued in the port must leave before the board can answer.
        deadline = self._free_at + self._allowance + command.seconds_to_answer
        received = b""
        state = parser.feed()
        while isinstance(state, NeedData):
            # The rest of the reply is on its way: it needs at least its time on the wire.
            wanted = state.size
            left = deadline + line.seconds(len(received) + wanted) - self._transport.clock()
            chunk = self._transport.read(wanted, max(left, 0.0))
            received += chunk
            state = parser.feed(chunk)
            if isinstance(state, NeedData) and len(chunk) < wanted:
                self.counters.silences += 1
                self._is_unanswered = True
                self._unanswered += 1
                raise _missing_reply(packet, received)
        match state:
            case Malformed(raw, reason):
                self.counters.damaged += 1
                # Whatever else is on its way belongs to the same damage.
                self._transport.wait(line.seconds(16))
                raise TrexBadReplyError(ErrorCode.CORRUPTED_REPLY, _hex(raw), reason)
            case Reply(raw, value):
                took = self._transport.clock() - begun
                if self._unanswered and command.reply_size():
                    self._reject_late_reply(raw)
                self.counters.answers += bool(command.reply_size())
                if command.reply_size() or self.echo:
                    self.counters.slowest = max(self.counters.slowest, took)
                    self._free_at = min(self._free_at, self._transport.clock())
                return value

    def send(self, command: Command[None]) -> None:
        """Send a command without a reply that something else will confirm.

        An echo is awaited and not checked.

        Raises:
            PortUnavailable: the line is gone.
        """
        packet = self._framing.encode(command)
        self.drain()
        self.counters.requests += 1
        self._transport.write(packet)
        self._free_at = self._transport.clock() + self._settings.line.seconds(len(packet))
        if self.echo:
            self._read_echo(packet)

    def detect_echo(self, before: Callable[[], None] | None = None) -> bool:
        """Find out with null commands whether everything sent comes back.

        `before` is called before each of them: a stop may have to be sent first.

        Raises:
            BadReply: bytes come without end; no TReX sends any unsolicited.
            PortUnavailable: the line is gone.
        """
        self.echo = False
        for _ in range(_ECHO_PROBES):
            if before is not None:
                before()
            self.drain()
            self._transport.discard()
            self._transport.write(_NULL)
            if self._read_echo(_NULL) == _NULL:
                self.echo = True
                break
        return self.echo

    def _drain_late_reply(self) -> bytes:
        """Discard a reply that did not come in time: it would be taken for the next one.

        A stop does not wait for that.
        """
        if not self._is_unanswered:
            return b""
        self._is_unanswered = False
        if self.keepalive_while_waiting:
            self._transport.write(_NULL)
        late = self._transport.read(_LONGEST_REPLY, self._transport.latency)
        # The rest of it is on its way; what follows that is no reply.
        rest = self._settings.line.seconds(_LONGEST_REPLY) if late else 0.0
        late += self._transport.read(_LONGEST_REPLY - len(late), rest)
        if late and self._unanswered == 1:
            self._unanswered = 0
        return late.removesuffix(_NULL) if self.echo and self.keepalive_while_waiting else late

    def _reject_late_reply(self, answer: bytes) -> None:
        """Accept a reply as that of the last request only if no other one follows it.

        Missing replies may have been delayed by an adapter or the system, and all arrive now: then
        this one belongs to an earlier request.

        Raises:
            BadReply: more came.
            PortUnavailable: the line is gone.
        """
        more = self._transport.read(1, self._transport.latency)
        if more:
            # Until it is quiet; what goes on for longer is no reply.
            more += self._transport.read(
                self._unanswered * _LONGEST_REPLY,
                self._unanswered * self._settings.line.seconds(_LONGEST_REPLY),
            )
            more += self._transport.discard()
        self._unanswered = 0
        if more:
            self.counters.stale += len(answer) + len(more)
            raise TrexBadReplyError(ErrorCode.LATE_REPLIES)

    def _read_echo(self, packet: bytes) -> bytes:
        seconds = self._settings.line.seconds(len(packet)) + self._allowance
        return self._transport.read(len(packet), seconds)

    def drain(self) -> None:
        """Wait until everything that was sent has left the port."""
        self._transport.wait(self._free_at - self._transport.clock())

    def close(self) -> None:
        """Close the port."""
        self._transport.close()

    @property
    def _allowance(self) -> float:
        return self._transport.latency + self._settings.timeouts.extra + _BOARD_DELAY

    def _new_number(self, command: object) -> int | None:
        """Return the new number from a command that changes that of a board addressed by number."""
        if (
            isinstance(command, SetParameter)
            and command.number == parameter_number(ParameterKey.DEVICE_NUMBER)
            and self._settings.device_number is not None
        ):
            return command.value
        return None

    def _address(self, number: int) -> None:
        """Address the board by this number from now on."""
        self._settings = replace(self._settings, device_number=number)
        self._framing = self._settings.framing

    def _look_for(self, number: int) -> None:
        """Find out whether a board has taken its new number although the reply was lost."""
        before = self._settings.device_number
        self._address(number)
        try:
            self._transact(GetParameter(parameter_number(ParameterKey.DEVICE_NUMBER)))
        except (NoReply, BadReply):
            if before is not None:
                self._address(before)


def _hex(data: bytes) -> str:
    return data.hex(" ").upper()


def _missing_reply(packet: bytes, received: bytes) -> TrexNoReplyError:
    if received:
        return TrexNoReplyError(ErrorCode.INCOMPLETE_REPLY, _hex(packet), _hex(received))
    return TrexNoReplyError(ErrorCode.NO_REPLY, _hex(packet))


def diagnose(settings: ConnectionSettings, *, echo: bool, error: StudioError) -> StudioError:
    """Return why no TReX was found, judged by the error of the first query and by its echo."""
    where = settings.text()
    if isinstance(error, BadReply):
        return TrexBadReplyError(ErrorCode.OTHER_DEVICE, where, error)
    if not isinstance(error, NoReply):
        return error
    if echo:
        return TrexNoReplyError(ErrorCode.ECHO_ONLY, where)
    if settings.device_number is not None:
        return TrexNoReplyError(ErrorCode.NO_BOARD_AT_NUMBER, where, settings.device_number)
    return TrexNoReplyError(ErrorCode.NO_BOARD, where)
