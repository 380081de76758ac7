"""Transactions with a board, one at a time.

A TReX cannot receive while it replies, so a request waits for the previous reply. The deadline of a
reply is the delay of the board plus the time of the bytes on the wire. Every use of the line raises
`PortUnavailable` if the line is gone.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Protocol

from trex_gui.core.errors import BadReply, NoReply
from trex_gui.core.guardian.guardian import StopSequence
from trex_gui.core.texts import hex_text
from trex_gui.core.transport.driven import driven_note
from trex_gui.core.transport.serial_port import Transport
from trex_gui.devices.trex.protocol.commands import (
    STOP,
    Command,
    GetParameter,
    GetStatus,
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
from trex_gui.devices.trex.protocol.flags import Status
from trex_gui.devices.trex.protocol.framing import (
    Framing,
    Malformed,
    NeedData,
    Packet,
    Reply,
    ReplyParser,
)
from trex_gui.devices.trex.protocol.parameters import ParameterKey, parameter_number

BOARD_DELAY = 0.005
"""Longest delay of a reply in seconds: half of the board's 10 ms cycle (inferred).

This includes the response delay of 1 ms.
"""

LONGEST_REPLY = 16  # in bytes: ten for five raw channels, a CRC, and the echo of the request
_ECHO_PROBES = 2  # two, so that one corrupted byte does not hide an echo


class Requester(Protocol):
    """Function that runs a transaction. In a session, it first sends due stops and setpoints."""

    def __call__(self, command: Command[ReplyT_co]) -> ReplyT_co: ...


@dataclass(slots=True)
class Counters:
    """Statistics since the line was opened."""

    requests: int = 0
    missing: int = 0  # missing or incomplete replies
    corrupted: int = 0  # corrupted replies
    unsolicited: int = 0  # discarded bytes that belong to no reply
    slowest: float = 0.0  # longest successful round trip in seconds
    replies: int = 0  # complete replies


@dataclass(slots=True)
class _Wire:
    free_at: float  # time when all sent bytes have left the port
    is_unanswered: bool = False  # True if the reply to the last request is missing
    unanswered: int = 0  # missing replies since the last reply that was matched to its request


class TrexClient:
    """Client for one board on an open line."""

    def __init__(
        self,
        transport: Transport,
        settings: ConnectionSettings,
        *,
        echo: bool = False,
        wire: _Wire | None = None,
    ) -> None:
        self.echo = echo  # True if sent bytes are echoed, as on the RS-232 side of the board
        # True to send a null command before waiting for a late reply. Otherwise, the board's serial
        # timeout could stop driven motors.
        self.keepalive_while_waiting = False
        self.counters = Counters()
        self.transport = transport
        self.settings = settings  # updated when the board gets another device number
        self._wire = wire or _Wire(transport.clock())
        self._stop_sequence: tuple[ConnectionSettings, bool, str, StopSequence] | None = None

    def to_board(self, settings: ConnectionSettings) -> "TrexClient":
        return TrexClient(self.transport, settings, echo=self.echo, wire=self._wire)

    def request(self, command: Command[ReplyT_co]) -> ReplyT_co:
        """Send a command and return its parsed reply.

        A motor command has no reply, so the call returns at once. The next request waits until the
        bytes have left the port.

        Raises:
            BadRequest: a value is out of range. Nothing was sent.
            NoReply: the reply is missing or incomplete at its deadline.
            BadReply: the received bytes are not a reply to this command.
        """
        return self._request(command, self.settings.framing).value

    def _request(self, command: Command[ReplyT_co], framing: Framing) -> Reply[ReplyT_co]:
        number = self._new_number(command, framing)
        try:
            reply = self._transact(command, framing)
        except (NoReply, BadReply):
            if number is not None:
                self._try_number(number)
            raise
        if reply.value is ResultCode.OK and number is not None:
            self.settings = replace(self.settings, device_number=number)
        return reply

    def send_packet(self, packet: Packet | Malformed) -> Reply[object]:
        """Send bytes that the user typed. Return the reply.

        If the bytes are not a packet, all received bytes count as the reply.

        Raises:
            BadRequest, NoReply, BadReply: as for `request`.
        """
        if isinstance(packet, Packet):
            framing = replace(self.settings.framing, device_number=packet.device_number)
            if framing.encode(packet.command) == packet.raw:
                return self._request(packet.command, framing)
        self._start_transaction()
        self.transport.write(packet.raw)
        seconds = self.settings.line.seconds(len(packet.raw)) + self._allowance
        received = b""
        while chunk := self.transport.read(1, seconds):
            received += chunk
            seconds = self._allowance
            if len(received) > len(packet.raw) + LONGEST_REPLY:
                break
        self._wire.free_at = self.transport.clock()
        return Reply(received, None)

    def _transact(self, command: Command[ReplyT_co], framing: Framing) -> Reply[ReplyT_co]:
        line = self.settings.line
        packet = framing.encode(command)
        parser = ReplyParser(command, framing, self.echo)
        self._start_transaction()
        started = self.transport.clock()
        self.transport.write(packet)
        # The board replies after all bytes have left the port. `write` may block until then.
        self._wire.free_at = max(started + line.seconds(len(packet)), self.transport.clock())
        deadline = self._wire.free_at + self._allowance + command.max_reply_delay
        received = b""
        state = parser.feed()
        while isinstance(state, NeedData):
            # The rest of the reply needs at least its time on the wire.
            missing = state.size
            remaining = deadline + line.seconds(len(received) + missing) - self.transport.clock()
            chunk = self.transport.read(missing, max(remaining, 0.0))
            received += chunk
            state = parser.feed(chunk)
            if isinstance(state, NeedData) and len(chunk) < missing:
                self.counters.missing += 1
                self._wire.is_unanswered = True
                self._wire.unanswered += 1
                if received:
                    fields = hex_text(packet), hex_text(received)
                    raise TrexNoReplyError(ErrorCode.INCOMPLETE_REPLY, *fields)
                raise TrexNoReplyError(ErrorCode.NO_REPLY, hex_text(packet))
        match state:
            case Malformed(raw, reason):
                self.counters.corrupted += 1
                # Wait for the remaining bytes of the corrupted reply.
                self.transport.wait(line.seconds(LONGEST_REPLY))
                raise TrexBadReplyError(ErrorCode.CORRUPTED_REPLY, hex_text(raw), reason)
            case Reply(raw):
                seconds = self.transport.clock() - started
                if self._wire.unanswered and command.reply_size():
                    self._reject_late_reply(raw)
                self.counters.replies += bool(command.reply_size())
                if command.reply_size() or self.echo:
                    self.counters.slowest = max(self.counters.slowest, seconds)
                    self._wire.free_at = min(self._wire.free_at, self.transport.clock())
                return state

    def _start_transaction(self) -> None:
        self.discard_late_reply()
        self.counters.unsolicited += len(self.transport.discard())
        self.counters.requests += 1

    def send(self, command: Command[None]) -> None:
        packet = self.settings.framing.encode(command)
        self.drain()
        self.counters.requests += 1
        self.transport.write(packet)
        self._wire.free_at = self.transport.clock() + self.settings.line.seconds(len(packet))
        if self.echo:
            self._read_echo(packet)

    def detect_echo(self, before: Callable[[], None] | None = None) -> bool:
        """Send null commands to detect an echo. Set and return `echo`.

        `before` is called before each null command.

        Raises:
            BadReply: bytes keep arriving, so the device is not a TReX.
        """
        self.echo = False
        for _ in range(_ECHO_PROBES):
            if before is not None:
                before()
            self.drain()
            self.transport.discard()
            self.transport.write(self._null)
            if self._read_echo(self._null) == self._null:
                self.echo = True
                break
        return self.echo

    def discard_late_reply(self) -> bool:
        """Wait for a late reply, so that it is not mistaken for the next reply.

        Return False if the last request was answered, so that no wait was necessary.
        """
        self.drain()
        if not self._wire.is_unanswered:
            return False
        self._wire.is_unanswered = False
        if self.keepalive_while_waiting:
            self.transport.write(self._null)
        late = self.transport.read(LONGEST_REPLY, self.transport.latency)
        rest = self.settings.line.seconds(LONGEST_REPLY) if late else 0.0
        late += self.transport.read(LONGEST_REPLY - len(late), rest)
        if self.echo and self.keepalive_while_waiting:
            late = late.removesuffix(self._null)
        if late and self._wire.unanswered == 1:
            self._wire.unanswered = 0
        self.counters.unsolicited += len(late)
        return True

    def _reject_late_reply(self, reply: bytes) -> None:
        """Raise `BadReply` if more bytes follow, since `reply` then belongs to an old request."""
        more = self.transport.read(1, self.transport.latency)
        if more:
            more += self.transport.read(
                self._wire.unanswered * LONGEST_REPLY,
                self._wire.unanswered * self.settings.line.seconds(LONGEST_REPLY),
            )
            more += self.transport.discard()
        self._wire.unanswered = 0
        if more:
            self.counters.unsolicited += len(reply) + len(more)
            raise TrexBadReplyError(ErrorCode.LATE_REPLIES)

    def _read_echo(self, packet: bytes) -> bytes:
        seconds = self.settings.line.seconds(len(packet)) + self._allowance
        return self.transport.read(len(packet), seconds)

    def stop_sequence(self, board: str) -> StopSequence:
        """Return the stop packets for the guardian. `board`: name of the board in messages."""
        cached = self._stop_sequence
        if cached is None or cached[:3] != (self.settings, self.echo, board):
            framing, line = self.settings.framing, self.settings.line
            packets = b"".join(map(framing.encode, STOP))
            query = framing.encode(GetStatus())
            size = GetStatus().reply_size() + framing.crc_size
            bytes_both_ways = len(packets) + len(query) + size
            seconds = line.seconds(bytes_both_ways) + self._allowance
            note = driven_note(board, self.settings)
            stop = StopSequence(
                packets, (query,), size, Status.UART_ERROR, self.echo, seconds, note
            )
            cached = self._stop_sequence = (self.settings, self.echo, board, stop)
        return cached[3]

    def drain(self) -> None:
        self.transport.wait(self._wire.free_at - self.transport.clock())

    def close(self) -> None:
        self.transport.close()

    @property
    def has_crc(self) -> bool:
        """True if replies have a CRC. Parity does not count, because only the board checks it."""
        return self.settings.line.has_crc

    @property
    def _null(self) -> bytes:
        framing = self.settings.framing if self.settings.reserved else Framing()
        return framing.encode(Null())

    @property
    def _allowance(self) -> float:
        return self.transport.latency + self.settings.timeouts.extra + BOARD_DELAY

    def _new_number(self, command: object, framing: Framing) -> int | None:
        """Return the device number that a command assigns to the connected board."""
        if (
            isinstance(command, SetParameter)
            and command.number == parameter_number(ParameterKey.DEVICE_NUMBER)
            and self.settings.device_number is not None
            and framing.device_number in {None, self.settings.device_number}
        ):
            return command.value
        return None

    def _try_number(self, number: int) -> None:
        """Switch to the new device number if the board replies to it."""
        before = self.settings
        self.settings = replace(before, device_number=number)
        try:
            query = GetParameter(parameter_number(ParameterKey.DEVICE_NUMBER))
            self._transact(query, self.settings.framing)
        except (NoReply, BadReply):
            self.settings = before
