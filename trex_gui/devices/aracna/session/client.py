"""Client with one command in flight.

The reply to `.c` arrives motor by motor, so no call waits for the whole reply. The session sends a
command, listens in short slices, and receives events.

Only a single `.q` may follow an unanswered command, because the chip can store only three bytes,
the length of a `.q`, while the firmware is busy. Once this `.q` is answered, the firmware is free.
Any late reply to the command arrives before that.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from trex_gui.core.errors import BadReply
from trex_gui.core.transport.serial_port import Transport
from trex_gui.core.transport.settings import PortSettings, SerialFormat
from trex_gui.devices.aracna.protocol import commands
from trex_gui.devices.aracna.protocol.replies import (
    REPLY_TYPES,
    Hello,
    Led,
    Positions,
    Reader,
    Reply,
    Speeds,
    Unrecognized,
    Version,
)
from trex_gui.devices.aracna.session.errors import (
    ErrorCode,
    RobotBadReplyError,
    RobotBusyError,
    RobotError,
    RobotNoReplyError,
    printable,
)
from trex_gui.devices.aracna.session.messages import LineStats, Progress, Stuck

LINE = SerialFormat(commands.BAUD)

REPLY_TIMEOUT = 1.0  # seconds, except for `.c`; the slowest reply takes 0.06 s on a wire
QUERY_RETRY = 5.0
"""Seconds after which `.q` is repeated if a reply is still incomplete. A repetition is harmless,
because the chip stores only one `.q`."""

SAVED_BYTES = 48  # maximum number of received bytes saved for error messages


@dataclass(frozen=True, slots=True)
class SentCommand:
    """Pending command. `sent`: time on the session clock. `timeout`: seconds after `sent`."""

    letter: str
    values: tuple[int, ...]
    sent: float
    timeout: float


@dataclass(frozen=True, slots=True)
class Answered:
    """Event: the complete reply has arrived."""

    command: SentCommand
    reply: Version | Speeds | Positions | Led
    time: float


@dataclass(frozen=True, slots=True)
class ReplyLost:
    """Event: no reply will arrive. `robot_free`: True if a later `.q` was answered."""

    command: SentCommand
    error: RobotError
    robot_free: bool
    time: float


@dataclass(frozen=True, slots=True)
class Voided:
    """Event: the firmware has started. Any pending command is void."""

    command: SentCommand | None
    time: float


CommandEvent = Answered | Progress | Stuck | ReplyLost | Voided


def read_available(transport: Transport) -> bytes:
    try:
        return transport.discard()
    except BadReply:  # bytes keep arriving; they may identify their sender
        return transport.read(SAVED_BYTES, 0.0)


class AracnaClient:
    def __init__(self, transport: Transport, settings: PortSettings) -> None:
        self.transport = transport
        self.settings = settings.at(LINE)
        self.motors = 0  # 0 before the first reply to `.q`
        self.pending: SentCommand | None = None
        self.received = b""  # first received bytes, for a diagnosis
        self.stats = LineStats()
        self._unrecognized = b""
        self._reader = Reader()
        self._arrived: tuple[int, ...] | None = None  # positions in the last `Progress`
        self._is_late = False  # True from a `Stuck` until another position arrives
        self._query_deadline: float | None = None  # reply to a `.q` sent after the command

    @property
    def extra_time(self) -> float:
        """Maximum delay of a reply on the line, in seconds."""
        return self.transport.latency + self.settings.timeouts.extra

    @property
    def awaited_motor(self) -> int | None:
        """First motor without a position in an incomplete `.c` reply, or `None`."""
        arrived = self._reader.arrived
        return None if arrived is None else len(arrived)

    # --- Commands -----------------------------------------------------------------------
    # All commands raise PortUnavailable if the line is lost, and BadRequest while another command
    # is pending.

    def query(self, timeout: float = REPLY_TIMEOUT) -> None:
        self._send("q", (), commands.QUERY, timeout)

    def set_speeds(self, values: Sequence[int]) -> None:
        """Set the speed of each motor, 0-1023. Raises BadRequest for invalid values."""
        line = commands.speeds(values, self.motors)
        self._send("v", tuple(values), line, REPLY_TIMEOUT)

    def set_led(self, *, on: bool) -> None:
        self._send("l", (int(on),), commands.led(on=on), REPLY_TIMEOUT)

    def move(self, goals: Sequence[int], timeout: float) -> None:
        """Move each motor to its goal, 0-1023. Raises BadRequest for invalid values."""
        line = commands.positions(goals, self.motors)
        self._send("c", tuple(goals), line, timeout)

    def _send(self, letter: str, values: tuple[int, ...], line: bytes, timeout: float) -> None:
        if self.pending is not None:
            raise RobotBusyError(ErrorCode.COMMAND_PENDING)
        self.transport.write(line)
        now = self.transport.clock()
        self.pending = SentCommand(letter, values, now, timeout + self.extra_time)
        self._arrived = None
        self._unrecognized = b""
        self._is_late = False
        self._query_deadline = None
        self._count(requests=1)

    # --- Replies ------------------------------------------------------------------------

    def listen(self, seconds: float = 0.0) -> list[CommandEvent]:
        """Return new events. Wait up to `seconds` for the first byte."""
        data = self.transport.read(1, seconds) if seconds > 0 else b""
        timeouts_at = self.transport.clock()  # bytes received later are late
        data += read_available(self.transport)
        now = self.transport.clock()
        self.received = (self.received + data)[:SAVED_BYTES]
        events: list[CommandEvent] = []
        for reply in self._reader.feed(data):
            events += self._handle(reply, now)
        return events + self._check_partial_reply(now) + self._check_timeouts(timeouts_at)

    def _handle(self, reply: Reply, now: float) -> list[CommandEvent]:
        if isinstance(reply, Hello):
            self._count(restarts=1)
            voided, self.pending = self.pending, None
            return [Voided(voided, now)]
        command = self.pending
        if not isinstance(reply, Unrecognized) and command is not None:
            if self._matches(command, reply):
                self._count_reply(command, now)
                self.pending = None
                if self._query_deadline is not None:  # the reply to the `.q` follows
                    self._query_deadline = None
                    self.pending = SentCommand("q", (), now, REPLY_TIMEOUT + self.extra_time)
                return [Answered(command, reply, now)]
            if isinstance(reply, Version) and self._query_deadline is not None:
                return [self._give_up(now, robot_free=True)]
        if not isinstance(reply, Version):
            self._count(unrecognized=1)
            if isinstance(reply, Unrecognized):
                self._unrecognized = reply.line
            if command is not None and command.letter == "c":
                late_at = max(command.sent + command.timeout, now)
                self._send_query(late_at + REPLY_TIMEOUT + self.extra_time)
        return []

    def _matches(self, command: SentCommand, reply: Reply) -> bool:
        if isinstance(reply, Speeds | Positions) and len(reply.values) != self.motors:
            return False
        return isinstance(reply, REPLY_TYPES[command.letter])

    def _check_partial_reply(self, now: float) -> list[CommandEvent]:
        arrived = self._reader.arrived
        if self.pending is None or self.pending.letter != "c" or arrived in {None, self._arrived}:
            return []
        self._arrived = arrived
        if self._is_late:  # the next motor may also be late
            self._is_late = False
            elapsed = now - self.pending.sent + REPLY_TIMEOUT + self.extra_time
            self.pending = replace(self.pending, timeout=max(self.pending.timeout, elapsed))
        return [Progress(now, arrived or ())]

    def _check_timeouts(self, now: float) -> list[CommandEvent]:
        command = self.pending
        if command is None:
            return []
        if self._query_deadline is not None and now >= self._query_deadline:
            if self.awaited_motor is None:
                return [self._give_up(now, robot_free=False)]
            # The reply to the `.q` may have been lost together with the end of the reply to `.c`.
            self._query_deadline = None
            self._send_query(now + QUERY_RETRY)
        if self._is_late or now < command.sent + command.timeout:
            return []
        if command.letter != "c":
            return [self._give_up(now, robot_free=False)]
        self._is_late = True
        self._send_query(now + REPLY_TIMEOUT + self.extra_time)
        return [Stuck(now, self.awaited_motor)]

    def _send_query(self, deadline: float) -> None:
        if self._query_deadline is None:
            self._query_deadline = deadline
            self.transport.write(commands.QUERY)
            self._count(requests=1)

    def _give_up(self, now: float, *, robot_free: bool) -> ReplyLost:
        assert self.pending is not None  # noqa: S101 - for the type checker
        lost, self.pending = self.pending, None
        if robot_free or self._unrecognized:
            self._count(corrupted=1)
        else:
            self._count(timeouts=1)
        error: RobotError = RobotNoReplyError(ErrorCode.TIMEOUT)
        if self._unrecognized:
            error = RobotBadReplyError(ErrorCode.UNEXPECTED_REPLY, printable(self._unrecognized))
        return ReplyLost(lost, error, robot_free, now)

    # --- Statistics ---------------------------------------------------------------------

    def _count(self, **counts: int) -> None:
        sums = {name: getattr(self.stats, name) + count for name, count in counts.items()}
        self.stats = replace(self.stats, **sums)

    def _count_reply(self, command: SentCommand, now: float) -> None:
        if not self.stats.replies:  # failures before the first reply do not count
            self.stats = LineStats(requests=1, replies=1)
            return
        self._count(replies=1)
        if command.letter != "c":
            slowest = max(self.stats.slowest, now - command.sent)
            self.stats = replace(self.stats, slowest=slowest)
